//! The paths of water after a round, which sediment follows.

use landform_core::grid::RasterDomain;

use super::pools::DRY;
use super::spread::{FlowPartition, Rule};
use super::sweep::Sweep;

impl Sweep {
    /// Nodes in the order of the last round: higher ones before their lower neighbours.
    pub fn order(&self) -> impl Iterator<Item = usize> + '_ {
        self.order.iter().map(|i| *i as usize)
    }

    /// The body of standing water over a node.
    #[inline]
    pub fn lake(&self, node: usize) -> Option<usize> {
        match self.pools.at(node) {
            DRY => None,
            pool => Some(pool as usize),
        }
    }

    /// Surface (m) of standing water over a node, or its ground.
    #[inline]
    pub fn surface(&self, node: usize) -> f64 {
        self.pools.surface(self.ran_over(), node)
    }

    /// The nodes to which a node of the last round passes sediment on, with shares: with the water
    /// on dry ground, down the bed under standing water. `part` is the flow as a part of all water.
    pub fn downstream(&self, domain: &RasterDomain, node: usize, part: f64) -> FlowPartition {
        let ground = self.ran_over();
        if self.lake(node).is_some() {
            let mut lower = FlowPartition::from_neighbours(domain, ground, node, |to| ground[to]);
            lower.set_weights(Rule::Weighted, part);
            return lower;
        }
        let mut lower = FlowPartition::from_neighbours(domain, ground, node, |to| self.surface(to));
        lower.set_weights(self.rule, part);
        lower
    }
}
