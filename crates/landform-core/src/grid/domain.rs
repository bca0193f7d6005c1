//! The graph that flow runs over: what rasters and meshes have in common.

use serde::{Deserialize, Serialize};

use super::{Centres, Link, Neighbours, Shape};
use crate::parallel;

/// Status of a node for flow.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[repr(u8)]
pub enum Status {
    /// Part of the landscape.
    #[default]
    Interior,
    /// Water leaves here; the elevation is given.
    BaseLevel,
    /// Outside of the landscape (nodata).
    Masked,
}

/// The slot of a node that has no receiver.
pub const NO_SLOT: u8 = u8::MAX;

/// The little that graph algorithms need; implemented by rasters and by the mesh's graph.
///
/// Links of a node sit in numbered *slots*. Slots, like node indices, follow from the geometry
/// alone, so that no result depends on the order in which a mesh's sites were given. Masked nodes
/// are no node's neighbour.
///
/// Three methods must be written, and three of [`Neighbours`]; the kernels follow from them, for
/// graphs that have no faster ones.
pub trait Domain: Neighbours + Clone + Send + 'static {
    /// Area of a node's cell, m².
    fn area(&self, node: usize) -> f64;

    /// Status of every node.
    fn status(&self) -> &[Status];

    /// Sets what every node is; masked nodes stay masked.
    fn set_status(&mut self, status: Vec<Status>);

    /// Width of the face shared with the neighbour in a slot over the distance to it: the
    /// conductance of a diffusive flux.
    fn conductance(&self, node: usize, slot: u8) -> f64;

    /// Rows and columns, if the conductances that are not 0 are those to the east, north, west and
    /// south of a raster whose sides do not wrap.
    fn five_point(&self) -> Option<Shape> {
        None
    }

    /// Weights for the heights at the places that conductances hold for, if nodes stand off them.
    fn centres(&self) -> Option<Centres> {
        None
    }

    /// The link in a slot.
    fn link(&self, node: usize, slot: u8) -> Link {
        let none = Link { to: node, distance: f64::INFINITY, slot: NO_SLOT };
        self.neighbours(node).find(|l| l.slot == slot).unwrap_or(none)
    }

    /// The neighbour in a slot.
    #[inline]
    fn neighbour(&self, node: usize, slot: u8) -> usize {
        self.link(node, slot).to
    }

    /// Distance to the neighbour in a slot, m.
    #[inline]
    fn distance(&self, node: usize, slot: u8) -> f64 {
        self.link(node, slot).distance
    }

    /// One over the distance to the neighbour in a slot, 1/m.
    #[inline]
    fn inverse_distance(&self, node: usize, slot: u8) -> f64 {
        1.0 / self.distance(node, slot)
    }

    /// What a drop to the neighbour in a slot is multiplied by where slopes are compared, 1/m: one
    /// over the distance, but where links of one kind would be chosen too often.
    #[inline]
    fn steepness(&self, node: usize, slot: u8) -> f64 {
        self.inverse_distance(node, slot)
    }

    /// The slot in which the neighbour holds the link back.
    fn slot_back(&self, node: usize, slot: u8) -> u8 {
        let back = |to: usize| self.neighbours(to).find(|l| l.to == node).map(|l| l.slot);
        back(self.neighbour(node, slot)).unwrap_or(NO_SLOT)
    }

    /// Calls `visit` with every neighbour whose receiver a node is, in order of slots.
    #[inline]
    fn each_donor(&self, node: usize, receiver: &[u32], mut visit: impl FnMut(usize)) {
        for link in self.neighbours(node) {
            if receiver[link.to] as usize == node {
                visit(link.to);
            }
        }
    }

    /// The neighbour down the steepest slope from a node, and its slot; none without a lower one.
    /// Ties go to the lower slot.
    fn steepest(&self, elevation: &[f64], node: usize) -> Option<(usize, u8)> {
        steepest_link(self, elevation, node).map(|l| (l.to, l.slot))
    }

    /// Writes each interior node's steepest-descent receiver and its slot; a node without a lower
    /// neighbour, a base level or a masked node becomes its own receiver, with [`NO_SLOT`]. Ties go
    /// to the lower slot.
    fn steepest_descent(&self, elevation: &[f64], receiver: &mut [u32], slot: &mut [u8]) {
        write_receivers(self, receiver, slot, |node| self.steepest(elevation, node));
    }

    /// The lowest neighbour of a node, and its slot; of equals the one of lower index.
    fn lowest(&self, elevation: &[f64], node: usize) -> Option<(usize, u8)> {
        let lower = |a: Link, b: Link| if is_below(elevation, b.to, a.to) { b } else { a };
        self.neighbours(node).reduce(lower).map(|l| (l.to, l.slot))
    }

    /// Whether a neighbour has another label. A masked node beside it may count as one.
    #[inline]
    fn touches_other(&self, label: &[u32], node: usize) -> bool {
        self.neighbours(node).any(|l| label[l.to] != label[node])
    }

    /// Writes 1 at base levels and at nodes whose lower neighbours (see [`Domain::lower_arcs`])
    /// form more than one arc, else 0.
    fn saddles(&self, elevation: &[f64], saddle: &mut [u8]) {
        parallel::update(saddle, |node, saddle| {
            let mut arcs = 0;
            self.lower_arcs(elevation, node, NO_SLOT, |_| arcs += 1);
            *saddle = u8::from(arcs > 1 || self.status()[node] == Status::BaseLevel);
        });
    }

    /// Calls `visit` with one slot of each arc of lower neighbours that does not hold `own`. An arc
    /// is a set of neighbours that are joined by links among themselves; lower means lower by
    /// (elevation, index).
    fn lower_arcs(&self, elevation: &[f64], node: usize, own: u8, mut visit: impl FnMut(u8)) {
        let mut left: Vec<Link> = self.neighbours(node).filter(|l| is_below(elevation, l.to, node)).collect();
        while !left.is_empty() {
            let first = left.remove(0);
            let (mut arc, mut next) = (vec![first], 0);
            while let Some(&at) = arc.get(next) {
                let joined = |l: &Link| self.neighbours(at.to).any(|n| n.to == l.to);
                let (found, rest): (Vec<Link>, Vec<Link>) = left.into_iter().partition(joined);
                arc.extend(found);
                left = rest;
                next += 1;
            }
            if arc.iter().all(|l| l.slot != own) {
                visit(first.slot);
            }
        }
    }
}

/// Writes the receiver of each interior node and its slot, as `find` says; other nodes, and those
/// for which it finds none, become their own, with [`NO_SLOT`].
pub(crate) fn write_receivers<D: Domain>(
    domain: &D,
    receiver: &mut [u32],
    slot: &mut [u8],
    find: impl Fn(usize) -> Option<(usize, u8)> + Sync,
) {
    let status = domain.status();
    parallel::for_pieces_mut2(receiver, slot, parallel::PIECE, |first, receivers, slots| {
        for (k, (r, s)) in receivers.iter_mut().zip(slots).enumerate() {
            let node = first + k;
            let found = if status[node] == Status::Interior { find(node) } else { None };
            (*r, *s) = found.map_or((node as u32, NO_SLOT), |(to, slot)| (to as u32, slot));
        }
    });
}

/// Steepest descent at one node by its list of links: the definition that faster kernels must agree
/// with.
#[inline]
pub(super) fn steepest_link(domain: &impl Domain, elevation: &[f64], node: usize) -> Option<Link> {
    let z = elevation[node];
    let mut best = (0.0, None);
    for link in domain.neighbours(node) {
        // As the kernels do: ties are decided by the last digit.
        let slope = (z - elevation[link.to]) * domain.steepness(node, link.slot);
        if slope > best.0 {
            best = (slope, Some(link));
        }
    }
    best.1
}

/// Whether `a` is lower than `b`; of equals the one with the lower index is.
#[inline]
pub(crate) fn is_below(elevation: &[f64], a: usize, b: usize) -> bool {
    elevation[a] < elevation[b] || (elevation[a] == elevation[b] && a < b)
}
