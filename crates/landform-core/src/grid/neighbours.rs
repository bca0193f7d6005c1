//! Nodes and their neighbours: the common part of the graphs of flow, agents and voxels.

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

/// Nodes with neighbours.
pub trait Neighbours: Sync {
    /// Number of nodes.
    fn len(&self) -> usize;

    /// Whether there are no nodes.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Links of a node, in order of slots.
    fn neighbours(&self, node: usize) -> impl Iterator<Item = Link>;
}
