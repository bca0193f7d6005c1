//! Parameters of channel erosion.

use landform_core::grid::Side;
use landform_core::units::{Discharge, Length, Rate, RateDimension, Ratio, RatioDimension};
use landform_core::verb::{Outlets, Params, Source, Varying};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::mechanism::Lattice;

/// How water finds its way.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Transport {
    /// To the neighbour down the steepest slope first, until it is level with the next:
    /// concentrates water in channels.
    #[default]
    Columns,
    /// To all lower neighbours, the nearer ones more, whatever the slope: spreads water.
    Average,
    /// To all lower neighbours, in proportion to the slopes to them.
    WeightedAverage,
    /// In time steps, driven by differences of level: a flood with momentum.
    Pipes,
    /// No water: drainage area passes to the steepest neighbour, and every depression is full.
    AreaMap,
}

/// Where the ground is smoothed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Smoothing {
    /// In channels only, in proportion to the flow. Plants hold the ground beside them.
    #[default]
    Channels,
    /// Everywhere by the same amount.
    Everywhere,
}

/// Water that rises at a place.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Spring {
    /// Position east and north, in the landscape's coordinates.
    pub at: [Length; 2],
    /// Its discharge.
    pub discharge: Discharge,
    /// The first and the last round in which it runs, counted from 1. If not given, it runs in all.
    #[serde(default)]
    pub rounds: Option<[u64; 2]>,
}

/// A river that enters over a side.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Inflow {
    /// The side. The water enters one node inside. The side must be closed, or the water leaves
    /// again where it entered.
    pub side: Side,
    /// Discharge, spread evenly along the side.
    pub discharge: Discharge,
}

/// Channel erosion by running water: rivers cut channels and widen with their discharge; lakes
/// fill, spill and drain as their outlets are cut. Water stays on the ground as a field. Runs
/// without a clock; one round is a year of rain.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct ChannelErosion {
    /// How water is routed: "columns", "average", "weighted_average", "pipes", or "area_map" (no
    /// water, depressions full).
    pub transport: Transport,
    /// Where water runs: over places off the centres of the cells, or over the centres, where it
    /// keeps to eight directions. In pipes it always runs over the centres.
    pub lattice: Lattice,
    /// Rain that runs off; may vary in space.
    #[schemars(extend("x-min" = 0.0))]
    pub rainfall: Varying<RateDimension>,
    /// Springs, each { at = ["1 km", "2 km"], discharge = "2 m3/s" }; with rounds = [50, 80] one
    /// runs from the 50th to the 80th round only.
    pub springs: Vec<Spring>,
    /// Rivers that enter over sides, each { side = "north", discharge = "5 m3/s" }.
    pub inflow: Vec<Inflow>,
    /// Evaporation from standing water.
    #[schemars(extend("x-min" = 0.0))]
    pub evaporation: Rate,
    /// Sinkholes, where a map is at least one half: they take all water that reaches them.
    pub sinks: Option<Varying<RatioDimension>>,
    /// Where water leaves, as in `stream_power`. If not given, the outlets of the landscape are
    /// used.
    pub outlets: Option<Outlets>,
    /// Number of rounds of water and erosion.
    #[schemars(extend("x-min" = 1, "x-max" = 1_000_000))]
    pub iterations: u64,
    /// Weight w_a of the flow nearby in erosion. It makes rivers erode their banks and widen.
    #[schemars(extend("x-min" = 0.0))]
    pub avalanche_weight: f64,
    /// Weight w_c of the flow at a node in erosion.
    #[schemars(extend("x-min" = 0.0))]
    pub flow_weight: f64,
    /// Exponent m of the flow. Below 1 small channels cut more.
    #[schemars(extend("x-above" = 0.0, "x-max" = 3.0))]
    pub flow_exponent: f64,
    /// Weight of smoothing.
    #[schemars(extend("x-min" = 0.0))]
    pub diffusion_weight: f64,
    /// Weight w_d of the erosion in proportion to slope.
    #[schemars(extend("x-min" = 0.0))]
    pub advection_weight: f64,
    /// Weight w_0 of the erosion that does not depend on slope.
    #[schemars(extend("x-min" = 0.0))]
    pub base_weight: f64,
    /// Weight of a uniform uplift.
    #[schemars(extend("x-min" = 0.0))]
    pub uplift_weight: f64,
    /// Where the ground is smoothed: "channels" (with the flow, Eq. 4.4), or "everywhere" (Eq.
    /// 4.6).
    pub smoothing: Smoothing,
    /// Factor on how easily the ground erodes; may vary in space.
    #[schemars(extend("x-min" = 0.0))]
    pub softness: Varying<RatioDimension>,
    /// Half the width of a river with all the water of the map. If not given, it is a 40th of the
    /// longer side.
    #[schemars(extend("x-min" = 0.0))]
    pub channel_radius: Option<Length>,
    /// Power of the flow with which width grows. The thesis has 1, rivers have 0.4 to 0.5.
    #[schemars(extend("x-above" = 0.0, "x-max" = 2.0))]
    pub width_exponent: f64,
    /// Depth of a river with all the water of the map. Depth grows with the square root of the
    /// flow. With "columns" a deeper river spreads more over its bed.
    #[schemars(extend("x-above" = 0.0))]
    pub river_depth: Length,
    /// Slope at which rivers carry all the sediment that the land above them sheds. Where rivers
    /// are less steep they deposit it as fans, deltas and floodplains. If not given, all sediment
    /// leaves the map. No field holds the sediment that full lakes keep at the end.
    #[schemars(extend("x-above" = 0.0, "x-max" = 10.0))]
    pub graded_slope: Option<Ratio>,
    /// Distance over which excess sediment settles. If not given, it is a 50th of the longer side.
    #[schemars(extend("x-above" = 0.0))]
    pub settling_length: Option<Length>,
    /// Pipes only: rain of the flood that erodes, as if it fell everywhere. `rainfall`, springs and
    /// inflow then give only the share of each place. If not given, it is 30 mm/h.
    #[schemars(extend("x-above" = 0.0))]
    pub storm: Option<Rate>,
    /// Pipes only: steps of water between rounds of erosion. If not given, they are 20.
    #[schemars(extend("x-min" = 1, "x-max" = 100_000))]
    pub pipe_steps: Option<u32>,
    /// Pipes only: Manning's roughness. If not given, it is 0.04.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1.0))]
    pub roughness: Option<Ratio>,
}

impl Default for ChannelErosion {
    fn default() -> Self {
        Self {
            transport: Transport::Columns,
            lattice: Lattice::Jittered,
            rainfall: Rate::of(1000.0).into(),
            springs: Vec::new(),
            inflow: Vec::new(),
            evaporation: Rate::of(0.0),
            sinks: None,
            outlets: None,
            iterations: 150,
            avalanche_weight: 2.0,
            flow_weight: 1.0,
            flow_exponent: 0.5,
            diffusion_weight: 5.0,
            advection_weight: 3.0,
            base_weight: 0.5,
            uplift_weight: 0.0,
            smoothing: Smoothing::Channels,
            softness: Ratio::of(1.0).into(),
            channel_radius: None,
            width_exponent: 0.5,
            river_depth: Length::of(2.0),
            graded_slope: None,
            settling_length: None,
            storm: None,
            pipe_steps: None,
            roughness: None,
        }
    }
}

impl ChannelErosion {
    /// Refuses options of pipes without pipes.
    fn check_pipes(&self) -> Result<()> {
        let given = [
            ("storm", self.storm.is_some()),
            ("pipe_steps", self.pipe_steps.is_some()),
            ("roughness", self.roughness.is_some()),
        ];
        match given.into_iter().find(|(_, is_given)| *is_given && self.transport != Transport::Pipes) {
            Some((name, _)) => Err(Error::Incomplete { name: name.into(), needs: "transport = \"pipes\"" }),
            None => Ok(()),
        }
    }

    /// Whether water runs over places off the centres of the cells.
    pub(super) fn runs_off_centres(&self) -> bool {
        self.lattice == Lattice::Jittered && self.transport != Transport::Pipes
    }

    /// Rain of the flood that erodes, m/s.
    pub(super) fn storm(&self) -> f64 {
        self.storm.map_or(0.03 / 3600.0, Rate::si)
    }

    /// Steps of water between rounds.
    pub(super) fn pipe_steps(&self) -> u32 {
        self.pipe_steps.unwrap_or(20)
    }

    /// Manning's roughness.
    pub(super) fn roughness(&self) -> f64 {
        self.roughness.map_or(0.04, Ratio::si)
    }
}

impl Params for ChannelErosion {
    const NAME: &'static str = "channel_erosion";
    const RENAMED: &'static [(&'static str, &'static str)] = &[("swallow", "sinks")];
    const SOURCES: &'static [Source] = &[
        Source {
            authors: "Pytel & Mann (2013)",
            title: "Self-organized approach to modeling hydraulic erosion features, Computers & Graphics 37(4)",
            doi: "10.1016/j.cag.2013.01.003",
        },
        Source {
            authors: "Mei, Decaudin & Hu (2007)",
            title: "Fast hydraulic erosion simulation and visualization on GPU, Pacific Graphics",
            doi: "10.1109/PG.2007.15",
        },
        Source {
            authors: "Barnes, Callaghan & Wickert (2021)",
            title: "Computing water flow through complex landscapes - Part 3: Fill-Spill-Merge, Earth Surface Dynamics 9",
            doi: "10.5194/esurf-9-105-2021",
        },
    ];

    fn bytes_a_node(&self) -> Option<u64> {
        Some(if self.transport == Transport::Pipes { 205 } else { 255 })
    }

    fn places(&self) -> Vec<(&'static str, [f64; 2])> {
        self.springs.iter().map(|s| ("springs", s.at.map(Length::si))).collect()
    }

    fn check(&self) -> Result<()> {
        if self.transport == Transport::AreaMap && (self.sinks.is_some() || self.evaporation.si() > 0.0) {
            let value = if self.sinks.is_some() { "sinks" } else { "evaporation" };
            return Err(Error::parameter(
                "transport",
                format!("\"area_map\" with `{value}`"),
                "another: an area map has no water to lose",
            ));
        }
        if self.transport == Transport::AreaMap && self.graded_slope.is_some() {
            let allowed = "another: an area map has no water to carry sediment";
            return Err(Error::parameter("transport", "\"area_map\" with `graded_slope`", allowed));
        }
        if self.smoothing == Smoothing::Everywhere && self.graded_slope.is_some() {
            let allowed = "\"channels\": rivers carry what they cut, not what creeps";
            return Err(Error::parameter("smoothing", "\"everywhere\" with `graded_slope`", allowed));
        }
        if self.settling_length.is_some() && self.graded_slope.is_none() {
            return Err(Error::Incomplete { name: "settling_length".into(), needs: "graded_slope" });
        }
        self.check_pipes()?;
        if self.springs.iter().any(|s| !(s.discharge.si() > 0.0)) {
            return Err(Error::parameter("springs", "without water", "a discharge > 0 m3/s"));
        }
        if let Some([first, last]) = self.springs.iter().filter_map(|s| s.rounds).find(|r| r[0] < 1 || r[1] < r[0]) {
            let allowed = "a first round from 1 on, and a last that is not before it";
            return Err(Error::parameter("springs", format!("rounds = [{first}, {last}]"), allowed));
        }
        if self.inflow.iter().any(|s| !(s.discharge.si() > 0.0)) {
            return Err(Error::parameter("inflow", "without water", "a discharge > 0 m3/s"));
        }
        self.outlets.as_ref().map_or(Ok(()), Outlets::check)
    }
}
