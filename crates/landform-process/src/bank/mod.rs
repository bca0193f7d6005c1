//! Rivers that wear their banks and widen their valleys.
//!
//! # Model
//! A river lowers its bed by K Aᵐ S over its width w. Beside, it wears λ K Aᵐ S w of bank a metre
//! of its length and a unit of time (m²/s). A bank that has lost the volume of its node above the
//! river falls to the river, which carries all of it away. So low banks give way in a step or two
//! and high walls stand for long: valleys get floors where incision is slow, and none where it is
//! fast.
//!
//! A bend wears its outer bank: of the wear a share (1 + sin θ)/2 goes to the outer side and the
//! rest to the inner, θ being the angle by which the river turns over two nodes above and two
//! below. Where the river stands off the wall, on its floor, nothing is worn there.
//!
//! | symbol | here | unit | meaning |
//! |---|---|---|---|
//! | K, m | `erodibility`, `area_exponent` | m^(1−2m)/s, – | those of stream power |
//! | A, S | drainage area, slope to the receiver | m², – | at the start of the step |
//! | w | width | m | 7.2 Q^0.5 (m³/s), Q the runoff of 1 m/yr from A |
//! | λ | `ratio` | – | how much faster banks are worn than beds |
//!
//! # Method
//! Flow is routed over the surface at the start of a step. The bank of a side is the node beside
//! the river whose direction is nearest to square. A bank falls to the middle between the heights
//! of the river's node and of the node below it, so that water may go through it next. Explicit.
//! O(n). Nodes of a raster stand where the other processes of the run want them.
//!
//! # Limits
//! The river takes all that falls out of the map; with deposition nothing of it settles. Walls wear
//! node by node, so that a step must be short against the time in which a wall falls.
//!
//! # Sources
//! Langston & Tucker (2018), for bank wear by the power that is spent on the bed, banks that must
//! lose their volume, and rivers that then move. They draw the side of a straight reach and make
//! wear grow with curvature over a radius; we share it by the angle of the turn, so that no draw is
//! needed. Moody & Troutman (2002) for the width.
//!
//! # Checked by
//! `tests`: the volume that a straight river wears, walls of two heights, the outer bank, mass,
//! runs that are cut.

mod course;
#[cfg(test)]
mod tests;

use landform_core::algo::flow::{Flow, node_areas};
use landform_core::grid::{Domain, Status};
use landform_core::terrain::{HeightField, Layer, Mesh, NodeSurface};
use landform_core::units::{Area, Erodibility, ErodibilityDimension, YEAR};
use landform_core::verb::{Change, Context, Params, Process, Resolved, Source, Step, Varying};
use landform_core::{Result, math};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use course::{Course, Side};

landform_core::stages! {
    process LateralErosion where HeightField, Mesh;
}

/// Lateral erosion: rivers wear their banks and widen their valleys, so that slow rivers get floors
/// on which they swing.
///
/// ```
/// use landform_core::grid::{Edge, Edges, Grid, Shape};
/// use landform_core::sim::Model;
/// use landform_core::terrain::HeightField;
/// use landform_core::units::{Area, MYR};
/// use landform_process::bank::LateralErosion;
///
/// # fn main() -> landform_core::Result<()> {
/// // A river down the middle row to the east, between banks of a metre.
/// let mut grid = Grid::new(Shape::new(3, 30), [10.0; 2])?;
/// grid.edges = Edges { east: Edge::Open, ..Edges::all(Edge::Closed) };
/// let height = |i: usize| 0.1 * (29 - i % 30) as f64 + if i / 30 == 1 { 0.0 } else { 1.0 };
/// let mut model = Model::new(HeightField::new(grid, (0..90).map(height).collect())?).dt(10.0 * MYR);
/// model.add(LateralErosion { least_area: Area::of(2000.0), ..LateralErosion::default() })?;
/// model.advance_steps(50)?;
/// assert!(model.budget().change.eroded > 0.0 && model.budget().imbalance() < 1e-12);
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct LateralErosion {
    /// Erodibility k of the bed, as in `stream_power`; may vary in space or change in time.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1e3))]
    pub erodibility: Varying<ErodibilityDimension>,
    /// Area exponent m, as in `stream_power`.
    #[schemars(extend("x-min" = 0.0, "x-max" = 2.0))]
    pub area_exponent: f64,
    /// Volume of bank that is worn off for each part of bed. Langston & Tucker: 1 to 1.5; tens
    /// where banks are loose.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1e4))]
    pub ratio: f64,
    /// Drainage area from which a river wears its banks.
    #[schemars(extend("x-above" = 0.0))]
    pub least_area: Area,
}

impl Default for LateralErosion {
    fn default() -> Self {
        Self { erodibility: Erodibility::of(2e-6).into(), area_exponent: 0.5, ratio: 1.5, least_area: Area::of(1e6) }
    }
}

impl Params for LateralErosion {
    const NAME: &'static str = "lateral_erosion";
    const IN_TIME: &'static [&'static str] = &["erodibility"];
    const SOURCES: &'static [Source] = &[
        Source {
            authors: "Langston & Tucker (2018)",
            title: "Developing and exploring a theory for the lateral erosion of bedrock channels for use in landscape evolution models, Earth Surface Dynamics 6",
            doi: "10.5194/esurf-6-1-2018",
        },
        Source {
            authors: "Moody & Troutman (2002)",
            title: "Characterization of the spatial variability of channel morphology, Earth Surface Processes and Landforms 27",
            doi: "10.1002/esp.403",
        },
    ];

    fn bytes_a_node(&self) -> Option<u64> {
        Some(110)
    }
}

/// What banks have lost, and the flow of a step as scratch.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct State {
    erodibility: Resolved,
    /// Volume that the river wore off each node since it last fell, m³.
    worn: Vec<f64>,
    #[serde(skip)]
    routed: Routed,
}

#[derive(Clone, Debug, Default)]
struct Routed {
    flow: Flow,
    /// Drainage area, m².
    area: Vec<f64>,
}

impl<T: NodeSurface> Process<T> for LateralErosion {
    const WRITES: &'static [&'static str] = &["elevation"];
    type State = State;

    fn start(&self, terrain: &mut T, context: &Context) -> Result<State> {
        let erodibility = self.erodibility.resolve("erodibility", terrain, context)?.at_least_zero("erodibility")?;
        Ok(State { erodibility, worn: vec![0.0; terrain.elevation().len()], routed: Routed::default() })
    }

    fn begin(&self, terrain: &T, state: &mut State, _: &Step) -> Result<()> {
        let domain = terrain.domain();
        let Routed { flow, area } = &mut state.routed;
        *area = node_areas(&*domain);
        flow.route(&*domain, terrain.elevation(), area);
        Ok(())
    }

    fn step(&self, terrain: &mut T, state: &mut State, at: &Step) -> Result<Change> {
        if let Some(now) = self.erodibility.in_time(at.time, at.time + at.dt) {
            state.erodibility = Resolved::Uniform(now);
        }
        let domain = terrain.domain();
        let State { erodibility, worn, routed: Routed { flow, area } } = state;
        let least = self.least_area.si();
        let course = Course::new(terrain, &*domain, flow.receivers(), area, least);
        let z = terrain.elevation();
        let mut fallen: Vec<(usize, f64)> = Vec::new();
        for &node in course.rivers() {
            let (below, length) = course.below(node);
            let drop = z[node] - z[below];
            if !(drop > 0.0) {
                continue;
            }
            let wear = self.wear(erodibility.at(node), area[node], drop / length) * length * at.dt;
            for side in [Side::Left, Side::Right] {
                let Some(bank) = course.bank(node, side) else { continue };
                let foot = 0.5 * (z[node] + z[below]);
                if !(z[bank] > z[node]) || domain.status()[bank] != Status::Interior {
                    continue;
                }
                worn[bank] += wear * course.share(node, side);
                if worn[bank] >= (z[bank] - foot) * domain.area(bank) {
                    fallen.push((bank, foot));
                }
            }
        }
        let mut lost = 0.0;
        terrain.change(Layer::Surface("sediment"), |z| {
            // A bank between two rivers falls to the lower one.
            for &(bank, foot) in &fallen {
                if z[bank] > foot {
                    lost += (z[bank] - foot) * domain.area(bank);
                    (z[bank], worn[bank]) = (foot, 0.0);
                }
            }
        });
        Ok(Change { eroded: lost, exported: lost, ..Change::default() })
    }
}

impl LateralErosion {
    /// Volume that a river wears off its banks, a metre of its length, m²/s.
    fn wear(&self, erodibility: f64, area: f64, slope: f64) -> f64 {
        let discharge = area / YEAR;
        let width = 7.2 * discharge.sqrt();
        self.ratio * erodibility * math::pow(area, self.area_exponent) * slope * width
    }
}
