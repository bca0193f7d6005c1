//! Flow routing: receivers, lakes through their passes, order, accumulation. Linear cost.
//!
//! # Method
//! 1. *Receivers*: steepest descent (drop over distance); level ground is tilted first ([`flats`]).
//! 2. *Open pits*: for about half of the pits on rough ground the way out follows from their
//!    neighbours alone ([`pits`]).
//! 3. *Basins*: follow receivers to an outlet or a pit ([`labels`]).
//! 4. *Passes*: links between basins, thinned to those that can be the lowest between their two
//!    basins ([`passes`]).
//! 5. *Exits*: minimum spanning tree of the basins by height of pass, all outlets as one root;
//!    Borůvka ([`exits`]).
//! 6. *Carving*: in every lake the path from the exit down to the pit is turned round, so that it
//!    leads out ([`carve`]).
//! 7. *Order and accumulation*: donors before receivers, by counting donors ([`order`]).
//!
//! After routing, every node reaches an outlet, and the greatest elevation along its path is the
//! level to which water must rise there: the flooding level of Priority-Flood (within the tilt of
//! level ground, where passes differ by less).
//!
//! O(n) time and, beyond the elevations, about 19 bytes a node and 24 a pass. Remaining ties are
//! broken by slots and node numbers, which follow from geometry. Donors are added in an order that
//! follows from the tree alone ([`order`]), and paths over the seams of strips ([`strips`]) are
//! joined at the end. So the bits are the same for any division of the work and on any number of
//! threads.
//!
//! # Sources
//! Braun & Willett (2013) for receivers and order; Cordonnier, Bovy & Braun (2019), algorithms 1-5,
//! for basins, passes and carving; Garbrecht & Martz (1997) and Barnes et al. (2014) for level
//! ground. We differ in two points: pits and passes that are decided before basins are compared
//! ([`pits`], [`passes`]), and ordering by donor counts. Bell's thesis finds lake exits by list
//! scans in O(n²) and lets a lake flow two ways; neither is repeated here.
//!
//! # Checked by
//! `tests`: every node drains, area is conserved, levels equal Priority-Flood exactly, numbering
//! and threads do not matter.
//!
//! # Example
//! On a ramp that falls to the east each row drains along itself:
//!
//! ```
//! use landform_core::algo::flow::{Flow, node_areas};
//! use landform_core::grid::{Edge, Edges, Grid, RasterDomain, Shape};
//!
//! let mut grid = Grid::new(Shape::new(3, 4), [10.0, 10.0])?;
//! grid.edges = Edges { east: Edge::Open, ..Edges::all(Edge::Closed) };
//! let domain = RasterDomain::new(&grid, &[]);
//! let (mut flow, mut area) = (Flow::new(), node_areas(&domain));
//! flow.route(&domain, &[3.0, 2.0, 1.0, 0.0].repeat(3), &mut area);
//! assert_eq!(flow.receivers()[4..8], [5, 6, 7, 7]);
//! assert_eq!(area[4..8], [100.0, 200.0, 300.0, 400.0]);
//! # Ok::<(), landform_core::Error>(())
//! ```

mod carve;
mod exits;
mod flats;
mod infinity;
mod labels;
mod multiple;
mod order;
mod passes;
mod pits;
mod strips;

pub use flats::{fall, spread_steps, tilt_flats};
pub use infinity::{Direction, direction};

use flats::Flats;
use strips::Strips;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::grid::{Domain, NO_SLOT, Status, write_receivers};
use crate::parallel;

/// Which of the lower neighbours receives a node's water.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Descent {
    /// The one down the steepest slope.
    #[default]
    Steepest,
    /// The lowest one, at any distance (Bell's thesis); favours long links.
    Lowest,
}

/// Receivers and order of all nodes; buffers are kept from call to call.
#[derive(Clone, Debug, Default)]
pub struct Flow {
    receiver: Vec<u32>,
    slot: Vec<u8>,
    /// Labels of basins while routing, order of nodes afterwards.
    order: Vec<u32>,
    /// Saddles while routing, donors while ordering.
    marks: Vec<u8>,
    strips: Strips,
    /// Number of strips, if it does not follow from the number of nodes.
    wanted: Option<usize>,
    lakes: usize,
    descent: Descent,
    flats: Flats,
}

impl Flow {
    /// Empty buffers.
    pub fn new() -> Self {
        Self::default()
    }

    /// Empty buffers, for another rule of descent.
    pub fn by(descent: Descent) -> Self {
        Self { descent, ..Self::default() }
    }

    /// Cuts the nodes into this many strips; no bit depends on it.
    pub fn in_strips(self, strips: usize) -> Self {
        Self { wanted: Some(strips), ..self }
    }

    /// Routes flow over `elevation` (NaN on masked nodes) and accumulates: on return `amount`
    /// holds, for each node, the sum of what it held at all nodes that drain through it, itself
    /// included (drainage area, if it held the nodes' areas).
    ///
    /// Nodes of a part of the domain without any base level keep their own lowest pit as an end.
    ///
    /// **Shape** both slices have one value per node. **Cost** O(n).
    pub fn route<D: Domain>(&mut self, domain: &D, elevation: &[f64], amount: &mut [f64]) {
        self.descend(domain, elevation);
        let cuts = strips::cut(domain.len(), self.wanted);
        self.strips = order::order_and_accumulate(&self.receiver, cuts, &mut self.marks, &mut self.order, amount);
    }

    /// As [`Flow::route`], but each node drains to the neighbour and by the slot that `find` gives,
    /// which must be lower; none for a pit.
    pub fn route_by<D: Domain>(
        &mut self,
        domain: &D,
        elevation: &[f64],
        amount: &mut [f64],
        find: impl Fn(usize) -> Option<(usize, u8)> + Sync,
    ) {
        self.resize(domain.len());
        write_receivers(domain, &mut self.receiver, &mut self.slot, find);
        self.drain_flats_and_pits(domain, elevation);
        let cuts = strips::cut(domain.len(), self.wanted);
        self.strips = order::order_and_accumulate(&self.receiver, cuts, &mut self.marks, &mut self.order, amount);
    }

    fn resize(&mut self, n: usize) {
        if self.receiver.len() != n {
            // Zeroed pages cost nothing until they are written.
            (self.receiver, self.slot, self.order, self.marks) = (vec![0; n], vec![0; n], vec![0; n], vec![0; n]);
        }
    }

    /// Receivers with lakes carved through; no order.
    fn descend<D: Domain>(&mut self, domain: &D, elevation: &[f64]) {
        self.resize(domain.len());
        self.steepest(domain, elevation);
        self.drain_flats_and_pits(domain, elevation);
    }

    /// Leads water over level ground and out of pits; all other nodes have their receivers.
    fn drain_flats_and_pits<D: Domain>(&mut self, domain: &D, elevation: &[f64]) {
        let mut pits = pits::without_receiver(domain, &self.slot);
        let mut flats = std::mem::take(&mut self.flats);
        if flats.tilt(domain, elevation, &pits, &self.slot) {
            self.steepest_around(domain, &flats);
            pits = pits::without_receiver(domain, &self.slot);
            self.drain_pits(domain, &flats.tilted, pits);
        } else {
            self.drain_pits(domain, elevation, pits);
        }
        self.flats = flats;
    }

    /// Finds a way out of every pit: over its lowest neighbour, or over passes from basin to basin.
    fn drain_pits<D: Domain>(&mut self, domain: &D, elevation: &[f64], mut pits: Vec<usize>) {
        let cuts = strips::cut(domain.len(), self.wanted);
        self.lakes = pits::open_pits(domain, elevation, &cuts, &mut pits, &mut self.receiver, &mut self.slot);
        if pits.is_empty() {
            return;
        }
        labels::label_basins(&self.receiver, &pits, &cuts, &mut self.order);
        domain.saddles(elevation, &mut self.marks);
        let exits = exits::find_exits(domain, elevation, &self.marks, &self.slot, &self.order, &pits, &cuts);
        carve::carve(domain, &exits, &pits, &cuts, &mut self.receiver, &mut self.slot);
    }

    fn steepest<D: Domain>(&mut self, domain: &D, elevation: &[f64]) {
        match self.descent {
            Descent::Steepest => domain.steepest_descent(elevation, &mut self.receiver, &mut self.slot),
            Descent::Lowest => {
                write_receivers(domain, &mut self.receiver, &mut self.slot, |node| lowest(domain, elevation, node));
            }
        }
    }

    /// Descent on flats that were tilted, and beside them.
    fn steepest_around<D: Domain>(&mut self, domain: &D, flats: &Flats) {
        let elevation = &flats.tilted;
        if flats.level.len() > domain.len() / 16 {
            self.steepest(domain, elevation);
            return;
        }
        let status = domain.status();
        let mut descend = |node: usize| {
            if status[node] == Status::Interior {
                let link = match self.descent {
                    Descent::Steepest => domain.steepest(elevation, node),
                    Descent::Lowest => lowest(domain, elevation, node),
                };
                (self.receiver[node], self.slot[node]) =
                    link.map_or((node as u32, NO_SLOT), |(to, slot)| (to as u32, slot));
            }
        };
        for &node in &flats.level {
            descend(node);
            domain.neighbours(node).for_each(|l| descend(l.to));
        }
    }

    /// The node that receives each node's water; itself at outlets and masked nodes.
    pub fn receivers(&self) -> &[u32] {
        &self.receiver
    }

    /// The slot of each node's receiver, or [`NO_SLOT`].
    pub fn slots(&self) -> &[u8] {
        &self.slot
    }

    /// All nodes, donors before receivers.
    pub fn order(&self) -> &[u32] {
        &self.order
    }

    /// How many local minima overflowed in the last routing.
    pub fn lakes(&self) -> usize {
        self.lakes
    }

    /// The level to which water rises at each node before it can leave: the greatest elevation on
    /// its way out. Equal to the elevation on land. NaN on masked nodes.
    pub fn water_level(&self, elevation: &[f64]) -> Vec<f64> {
        let mut level = elevation.to_vec();
        self.up(&mut level, |_, own, below| own.max(below));
        level
    }

    /// The number of each node's basin, from 1 in order of outlets' indices; 0 on masked nodes.
    pub fn basins(&self, status: &[Status]) -> Vec<u32> {
        let mut basin = vec![0; self.receiver.len()];
        let mut count = 0;
        for i in 0..basin.len() {
            if self.receiver[i] as usize == i && status[i] != Status::Masked {
                count += 1;
                basin[i] = count;
            }
        }
        self.up(&mut basin, |_, _, below| below);
        basin
    }
}

/// The lowest of the lower neighbours of a node, and its slot.
fn lowest<D: Domain>(domain: &D, elevation: &[f64], node: usize) -> Option<(usize, u8)> {
    let (mut least, mut found) = (elevation[node], None);
    for link in domain.neighbours(node) {
        if elevation[link.to] < least {
            (least, found) = (elevation[link.to], Some((link.to, link.slot)));
        }
    }
    found
}

/// Area of every node, m², 0 where masked: what [`Flow::route`] turns into drainage area.
pub fn node_areas<D: Domain>(domain: &D) -> Vec<f64> {
    let status = domain.status();
    parallel::map(domain.len(), |i| if status[i] == Status::Masked { 0.0 } else { domain.area(i) })
}

#[cfg(test)]
mod tests;
