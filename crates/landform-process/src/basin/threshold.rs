//! Erosion at a threshold of shear stress (Rodríguez-Iturbe & Rinaldo).
//!
//! # Model
//! τ = √A S at every node, A drainage area, S slope to the node that receives its water. Where τ
//! exceeds τ_c, the ground is eroded until τ no longer does. Then some nodes are raised a little,
//! and the ground is eroded again, in small and large avalanches.
//!
//! # Method
//! A sweep routes the flow (D8) and lowers all nodes at once to z_r + τ_c d / √A, with z_r of
//! before the sweep. Sweeps go on until none changes anything. Erosion then moves upstream as a
//! scarp, which decides what drains over it. Lowering all nodes from the outlets upwards in one
//! pass becomes stable as well, but leaves parallel channels (β 0.26 on a slope).
//!
//! # Limits
//! On rasters. With `depressions = "end"` rivers end in depressions, as in the thesis.
//!
//! # Sources
//! Rinaldo, Rodríguez-Iturbe, Rigon, Bras, Ijjász-Vásquez & Marani (1993); Pytel (2015), 2.3.2 and
//! figure 4.25.

use landform_core::algo::flow::{Flow, node_areas};
use landform_core::field::names;
use landform_core::grid::{Domain, NO_SLOT, RasterDomain, Status};
use landform_core::terrain::{HeightField, Layer, NodeSurface};
use landform_core::units::{Length, Ratio, YEAR};
use landform_core::verb::{Change, Context, Outlets, OwnClock, Params, Process, Source, Step};
use landform_core::{Error, Result, parallel};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::mechanism::water::highest_first;

/// What water does in depressions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Depressions {
    /// It fills them and flows on.
    #[default]
    Overflow,
    /// It ends there.
    End,
}

/// Most sweeps until the ground is stable.
const MOST_SWEEPS: usize = 20_000;
/// Ground within this part above the threshold is stable.
const STABLE: f64 = 1e-10;

/// Threshold erosion: ground is eroded wherever the shear stress of its water, the root of the
/// drainage area times slope, exceeds a threshold. Then it is perturbed and eroded again. Runs
/// without a clock; one round is a perturbation.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct ThresholdErosion {
    /// The threshold: root of drainage area times slope. 10 m is a slope of 0.01 where 1 km2
    /// drains.
    #[schemars(extend("x-above" = 0.0))]
    pub threshold: Length,
    /// Number of perturbations after the first erosion.
    #[schemars(extend("x-min" = 0, "x-max" = 100_000))]
    pub iterations: u64,
    /// Fraction of the nodes that a perturbation raises.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1.0))]
    pub perturbed: Ratio,
    /// Greatest height by which it raises them. Choose about the threshold, which is the drop of a
    /// node that drains only itself.
    #[schemars(extend("x-min" = 0.0))]
    pub perturbation: Length,
    /// What water does in depressions: "overflow" or "end".
    pub depressions: Depressions,
    /// Where water leaves, as in `stream_power`. If not given, the outlets of the landscape are
    /// used.
    pub outlets: Option<Outlets>,
}

impl Default for ThresholdErosion {
    fn default() -> Self {
        Self {
            threshold: Length::of(10.0),
            iterations: 25,
            perturbed: Ratio::of(0.1),
            perturbation: Length::of(10.0),
            depressions: Depressions::Overflow,
            outlets: None,
        }
    }
}

impl Params for ThresholdErosion {
    const NAME: &'static str = "threshold_erosion";
    const RENAMED: &'static [(&'static str, &'static str)] =
        &[("perturbations", "iterations"), ("shaken", "perturbed"), ("hollows", "depressions")];
    const SOURCES: &'static [Source] = &[Source {
        authors: "Rinaldo et al. (1993)",
        title: "Self-organized fractal river networks, Physical Review Letters 70(6)",
        doi: "10.1103/PhysRevLett.70.822",
    }];

    fn check(&self) -> Result<()> {
        self.outlets.as_ref().map_or(Ok(()), Outlets::check)
    }
}

/// Nothing but scratch: what a round does follows from the ground and the round's number.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct State {
    #[serde(skip)]
    flow: Flow,
}

impl Process<HeightField> for ThresholdErosion {
    const WRITES: &'static [&'static str] = &["elevation", "drainage_area"];
    type State = State;

    fn own_clock(&self) -> Option<OwnClock> {
        Some(OwnClock { dt: YEAR, rounds: self.iterations + 1, is_timed: false })
    }

    fn start(&self, terrain: &mut HeightField, context: &Context) -> Result<State> {
        if let Some(outlets) = &self.outlets {
            outlets.apply(terrain, 0.0, context)?;
        }
        Ok(State::default())
    }

    fn step(&self, terrain: &mut HeightField, state: &mut State, at: &Step) -> Result<Change> {
        let domain = terrain.domain();
        let area = terrain.grid().cell_area();
        let raised = if at.index > 0 { self.shake(terrain, &domain, at) } else { 0.0 };
        let (mut eroded, mut amount) = (0.0, Vec::new());
        for sweep in 0.. {
            amount = self.route(&domain, terrain.elevation(), &mut state.flow);
            let lowered = terrain.change(Layer::Surface("sediment"), |z| self.wear(&domain, &state.flow, &amount, z));
            eroded += lowered;
            if lowered == 0.0 {
                break;
            }
            if sweep > MOST_SWEEPS {
                return Err(Error::NotConverged {
                    what: "threshold erosion".into(),
                    iterations: sweep,
                    residual: lowered,
                });
            }
        }
        let status = domain.status();
        parallel::update(&mut amount, |i, a| *a = if status[i] == Status::Masked { f64::NAN } else { *a });
        terrain.fields_mut().insert(&names::DRAINAGE_AREA, amount)?;
        let greatest = if raised > 0.0 { self.perturbation.si() } else { 0.0 };
        let eroded = eroded * area;
        Ok(Change { supplied: raised * area, eroded, exported: eroded, raised: greatest, ..Change::default() })
    }
}

impl ThresholdErosion {
    /// Raises some nodes; the sum of heights.
    fn shake(&self, terrain: &mut HeightField, domain: &RasterDomain, at: &Step) -> f64 {
        let status = domain.status();
        let by = |i: usize| {
            let seed = at.seed.with(i as u64);
            let hit = status[i] == Status::Interior && seed.uniform(0) < self.perturbed.si();
            if hit { self.perturbation.si() * seed.uniform(1) } else { 0.0 }
        };
        terrain.change(Layer::Bedrock, |z| parallel::update(z, |i, z| *z += by(i)));
        parallel::sum(status.len(), by)
    }

    /// Drainage area, m².
    fn route(&self, domain: &RasterDomain, z: &[f64], flow: &mut Flow) -> Vec<f64> {
        let mut amount = node_areas(domain);
        flow.route(domain, z, &mut amount);
        if self.depressions == Depressions::End {
            // Water stays in depressions: receivers as they are before flow is routed through
            // lakes.
            amount = node_areas(domain);
            let (mut receiver, mut slot) = (vec![0; z.len()], vec![NO_SLOT; z.len()]);
            domain.steepest_descent(z, &mut receiver, &mut slot);
            for i in highest_first(z) {
                let r = receiver[i] as usize;
                if r != i {
                    amount[r] += amount[i];
                }
            }
        }
        amount
    }

    /// Lowers what is above the threshold, all nodes from the heights before; the sum of depths.
    fn wear(&self, domain: &RasterDomain, flow: &Flow, amount: &[f64], z: &mut [f64]) -> f64 {
        let (receivers, slots) = (flow.receivers(), flow.slots());
        let mut sum = 0.0;
        // Donors come first, so that receivers still have their old heights.
        for &i in flow.order() {
            let i = i as usize;
            if slots[i] == NO_SLOT {
                continue;
            }
            let below = z[receivers[i] as usize];
            let limit = below + self.threshold.si() * domain.distance(i, slots[i]) / amount[i].sqrt();
            if z[i] - below > (limit - below) * (1.0 + STABLE) {
                sum += z[i] - limit;
                z[i] = limit;
            }
        }
        sum
    }
}
