//! The graph that flow runs over: what rasters and meshes have in common.

/// Flat index of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Node(pub u32);

/// What a node is to flow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// Part of the landscape.
    Interior,
    /// Water leaves here; the elevation is given.
    BaseLevel,
    /// Outside of the landscape (nodata).
    Masked,
}

/// [`Status::Interior`] as stored.
pub const INTERIOR: u8 = 0;
/// [`Status::BaseLevel`] as stored.
pub const BASE_LEVEL: u8 = 1;
/// [`Status::Masked`] as stored.
pub const MASKED: u8 = 2;

/// The slot of a node that has no receiver.
pub const NO_SLOT: u8 = u8::MAX;

/// A neighbour: the node, how far, and in which of the centre's slots.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Link {
    /// The neighbour.
    pub to: usize,
    /// Distance between the nodes, m.
    pub distance: f64,
    /// Index of this link among the centre's links.
    pub slot: u8,
}

/// The little that graph algorithms need; implemented by rasters and by the mesh's graph.
///
/// Links of a node sit in numbered *slots*. Slots, like node indices, follow from the geometry alone, so that no result
/// depends on the order in which a mesh's sites were given. Masked nodes are nobody's neighbour.
pub trait Domain: Clone + Send + Sync + 'static {
    /// Number of nodes.
    fn len(&self) -> usize;

    /// Whether there are no nodes.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Area that a node stands for, m².
    fn area(&self, node: usize) -> f64;

    /// Status of every node: [`INTERIOR`], [`BASE_LEVEL`] or [`MASKED`].
    fn status(&self) -> &[u8];

    /// Links of a node, in order of slots.
    fn neighbours(&self, node: usize) -> impl Iterator<Item = Link>;

    /// The neighbour in a slot.
    fn neighbour(&self, node: usize, slot: u8) -> usize;

    /// Distance to the neighbour in a slot, m.
    fn distance(&self, node: usize, slot: u8) -> f64;

    /// Width of the face shared with the neighbour in a slot over the distance to it: the conductance of a diffusive flux.
    fn conductance(&self, node: usize, slot: u8) -> f64;

    /// The slot in which the neighbour holds the link back.
    fn slot_back(&self, node: usize, slot: u8) -> u8;

    /// Calls `visit` with every neighbour whose receiver a node is, in order of slots.
    #[inline]
    fn each_donor(&self, node: usize, receiver: &[u32], mut visit: impl FnMut(usize)) {
        for link in self.neighbours(node) {
            if receiver[link.to] as usize == node {
                visit(link.to);
            }
        }
    }

    /// Writes each interior node's steepest-descent receiver and its slot; a node without a lower neighbour, a base level
    /// or a masked node becomes its own receiver, with [`NO_SLOT`]. Ties go to the lower slot.
    fn steepest_descent(&self, elevation: &[f64], receiver: &mut [u32], slot: &mut [u8]);

    /// Writes 1 at base levels and at nodes whose lower neighbours (see [`Domain::lower_arcs`]) form more than one arc, else 0.
    fn saddles(&self, elevation: &[f64], saddle: &mut [u8]);

    /// Calls `visit` with one slot of each arc of lower neighbours that does not hold `own`. An arc is a set of neighbours
    /// that are joined by links among themselves; lower means lower by (elevation, index).
    fn lower_arcs(&self, elevation: &[f64], node: usize, own: u8, visit: impl FnMut(u8));

    /// Sets what every node is; masked nodes stay masked.
    fn set_status(&mut self, status: Vec<u8>);
}

/// Steepest descent at one node by its list of links: the definition that faster kernels must agree with.
#[inline]
pub(super) fn steepest_link(domain: &impl Domain, elevation: &[f64], node: usize) -> Option<Link> {
    let z = elevation[node];
    let mut best = (0.0, None);
    for link in domain.neighbours(node) {
        let slope = (z - elevation[link.to]) / link.distance;
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
