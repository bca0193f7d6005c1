//! Sediment that rivers carry and deposit: fans, deltas, floodplains.
//!
//! # Model
//! Let E be the volume that a round would erode if all of it could be carried. A river with the
//! part f of the map's water can carry
//!
//! C = E f S / S_g
//!
//! at the slope S: at the graded slope S_g a river carries what the land above it sheds, for any
//! rate of erosion. Where less sediment arrives, the river erodes; where more arrives, the excess
//! settles over the length ℓ: 1 − exp(−dx/ℓ) of it at every node, never so much that the path
//! uphill is blocked. Standing water carries nothing: coarse sediment settles at the mouth, up to
//! the surface; sediment that reaches the deepest node is spread over the lake by its depth. A full
//! lake keeps the rest and releases it with the next round's water.
//!
//! Water in pipes is under way during the whole round; sediment goes where most of it went, and
//! every depression counts as full.
//!
//! # Limits
//! One grain size. Fine sediment does not leave lakes over their outlets.
//!
//! # Sources
//! Mei, Decaudin & Hu (2007), Eqs. 9 to 12: capacity in proportion to slope and flow, pick-up and
//! settling. That a graded river has just the slope that its load needs: Mackin (1948), Bull. Geol.
//! Soc. America 59. Here that slope is the parameter, so that a weight of erosion changes how fast,
//! not what, forms.

use landform_core::grid::{Domain, Grid, Neighbours, Status};
use landform_core::units::Length;
use landform_core::{math, parallel};
use serde::{Deserialize, Serialize};

use super::params::ChannelErosion;
use super::ways::SedimentRouting;
use super::wear::Ground;
use crate::mechanism::water::{FlowPartition, Rule};

/// Settling lengths along the map's longer side.
const LENGTHS_ACROSS: f64 = 50.0;

/// Rivers steeper than this raise their beds by no more in a round.
const STEEP: f64 = 0.1;
/// Height, as cells at the graded slope, by which a river may raise its bed over the ground uphill
/// of it in a round; then it leaves the bed.
const RISE: f64 = 0.5;

/// Capacity of rivers, and the sediment under way in full lakes.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Sediment {
    /// Slope at which a river carries all that the land sheds.
    graded: f64,
    /// Fraction of the excess that settles across a cell.
    settling: f64,
    /// As a depth over each node, m.
    under_way: Vec<f64>,
}

impl Sediment {
    /// As the parameters have it; none if all that is cut leaves.
    pub(super) fn of(params: &ChannelErosion, grid: &Grid) -> Option<Self> {
        let ([w, h], [dx, dy]) = (grid.extent(), grid.spacing);
        let length = params.settling_length.map_or(w.max(h) / LENGTHS_ACROSS, Length::si);
        params.graded_slope.map(|slope| Self {
            graded: slope.si(),
            settling: 1.0 - math::exp(-dx.min(dy) / length),
            under_way: vec![0.0; grid.len()],
        })
    }

    /// Sediment under way, as depths summed over nodes, m.
    pub(super) fn under_way(&self) -> f64 {
        parallel::sum(self.under_way.len(), |i| self.under_way[i])
    }

    /// Carries and deposits the sediment that a round erodes: `new` becomes the ground after the
    /// round. Returns the sediment that leaves the map, as depths summed over nodes, m.
    pub(super) fn carry(&mut self, g: &Ground, ways: &dyn SedimentRouting, sinks: &[bool], new: &mut [f64]) -> f64 {
        let whole = shed(g, new);
        let (status, cell) = (g.domain.status(), g.grid.spacing[0].min(g.grid.spacing[1]));
        // Surface of the lowest ground that sends anything here: deposits stay below it.
        let mut max_bed = vec![f64::INFINITY; new.len()];
        let mut left = 0.0;
        let mut in_lakes: Vec<(usize, usize, f64)> = Vec::new();
        for i in ways.order() {
            let came = std::mem::take(&mut self.under_way[i]);
            if status[i] == Status::BaseLevel || sinks.get(i).copied().unwrap_or(false) {
                left += came + g.z[i] - new[i];
                continue;
            }
            let mut downstream = ways.downstream(i, g.flow[i]);
            let above = if max_bed[i] < f64::INFINITY { (max_bed[i] - g.z[i]).max(0.0) } else { 0.0 };
            let lake = ways.lake(i);
            let (capacity, room) = match lake {
                Some(_) => (0.0, ways.surface(i) - g.z[i]),
                None => {
                    let flow = g.banks[i].lateral_flow + g.flow[i];
                    (
                        whole * flow * slope_downstream(ways, &downstream, i) / self.graded,
                        above + RISE * self.graded.min(STEEP) * cell,
                    )
                }
            };
            let wanted = g.z[i] - new[i];
            let too_much = came - capacity;
            let change = if lake.is_none() && too_much < 0.0 {
                // Erosion is limited by capacity, and deposition by the sediment that arrived.
                -wanted.min(-too_much).max(-came)
            } else {
                (self.settling * too_much.max(0.0)).min(room).max(0.0)
            };
            new[i] = g.z[i] + change;
            let on = came - change;
            if lake.is_none() && too_much > 0.0 {
                // Overloaded rivers braid.
                downstream.set_weights(Rule::Weighted, g.flow[i]);
            }
            if downstream.is_empty() {
                match lake {
                    Some(lake) => in_lakes.push((lake, i, on)),
                    None => self.under_way[i] = on,
                }
                continue;
            }
            for (j, share) in downstream.weights() {
                self.under_way[j] += on * share;
                max_bed[j] = max_bed[j].min(new[i]);
            }
        }
        spread_in_lakes(ways, in_lakes, new, &mut self.under_way);
        left
    }
}

/// All that a round would erode, as depths summed over nodes, m.
fn shed(g: &Ground, new: &[f64]) -> f64 {
    parallel::sum(new.len(), |i| if g.domain.status()[i] == Status::Masked { 0.0 } else { (g.z[i] - new[i]).max(0.0) })
}

/// Slope along the paths downstream.
fn slope_downstream(ways: &dyn SedimentRouting, downstream: &FlowPartition, i: usize) -> f64 {
    let fall = |(j, share): (usize, f64)| {
        let distance = ways.domain().neighbours(i).find(|l| l.to == j).map_or(f64::INFINITY, |l| l.distance);
        share * (ways.height(i) - ways.surface(j)).max(0.0) / distance
    };
    downstream.weights().map(fall).sum()
}

/// Spreads the sediment that has reached the deepest nodes of lakes, by the depth that is left; the
/// rest stays there.
fn spread_in_lakes(ways: &dyn SedimentRouting, rests: Vec<(usize, usize, f64)>, new: &mut [f64], load: &mut [f64]) {
    let Some(last) = rests.iter().map(|r| r.0).max() else { return };
    let mut amount = vec![0.0; last + 1];
    let mut room = vec![0.0; last + 1];
    rests.iter().for_each(|&(lake, _, rest)| amount[lake] += rest);
    let of = |i: usize, new: &[f64]| {
        let lake = ways.lake(i).filter(|&lake| lake <= last)?;
        Some((lake, (ways.surface(i) - new[i]).max(0.0)))
    };
    for i in 0..new.len() {
        if let Some((lake, depth)) = of(i, new) {
            room[lake] += depth;
        }
    }
    for i in 0..new.len() {
        if let Some((lake, depth)) = of(i, new)
            && room[lake] > 0.0
        {
            new[i] += depth * (amount[lake] / room[lake]).min(1.0);
        }
    }
    for (lake, pit, rest) in rests {
        if amount[lake] > room[lake] {
            load[pit] += rest * (1.0 - room[lake] / amount[lake]);
        }
    }
}
