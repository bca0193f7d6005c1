//! The paths of sediment in a round, which are those of its water.

use std::collections::BTreeSet;

use landform_core::algo::flow::Flow;
use landform_core::algo::outline::label_regions;
use landform_core::grid::RasterDomain;
use landform_core::parallel;

use crate::mechanism::water::{FlowPartition, Pipes, Rule, Sweep, highest_first};

/// Where sediment goes.
pub(super) trait SedimentRouting {
    /// The graph that water runs over.
    fn domain(&self) -> &RasterDomain;
    /// Nodes, higher ones before their lower neighbours.
    fn order(&self) -> Box<dyn Iterator<Item = usize> + '_>;
    /// The nodes to which a node passes water and sediment on, with shares; always lower ground.
    /// `part` is the flow as a part of all water.
    fn downstream(&self, node: usize, part: f64) -> FlowPartition;
    /// Elevation of a node's ground by which its paths are routed.
    fn height(&self, node: usize) -> f64;
    /// The lake over a node.
    fn lake(&self, node: usize) -> Option<usize>;
    /// Surface of the lake over a node, or its ground.
    fn surface(&self, node: usize) -> f64;
}

/// The paths of a sweep over its ground.
pub(super) struct SweepPaths<'a> {
    pub(super) sweep: &'a Sweep,
    pub(super) domain: &'a RasterDomain,
}

impl SedimentRouting for SweepPaths<'_> {
    fn domain(&self) -> &RasterDomain {
        self.domain
    }

    fn order(&self) -> Box<dyn Iterator<Item = usize> + '_> {
        Box::new(self.sweep.order())
    }

    fn downstream(&self, node: usize, part: f64) -> FlowPartition {
        self.sweep.downstream(self.domain, node, part)
    }

    fn height(&self, node: usize) -> f64 {
        self.sweep.ran_over()[node]
    }

    fn lake(&self, node: usize) -> Option<usize> {
        self.sweep.lake(node)
    }

    fn surface(&self, node: usize) -> f64 {
        self.sweep.surface(node)
    }
}

/// The paths of water in pipes, with the volumes that crossed in the round. Every depression is a
/// full lake: many floods would have filled it.
pub(super) struct PipePaths<'a> {
    pipes: &'a Pipes,
    domain: &'a RasterDomain,
    ground: &'a [f64],
    level: Vec<f64>,
    lake: Vec<u32>,
}

impl<'a> PipePaths<'a> {
    pub(super) fn new(pipes: &'a Pipes, (domain, ground): (&'a RasterDomain, &'a [f64]), sinks: &[bool]) -> Self {
        let mut flow = Flow::new();
        flow.route(domain, ground, &mut vec![0.0; ground.len()]);
        let level = flow.water_level(ground);
        let mut lake = label_regions(domain.shape(), |i| level[i] > ground[i], |a, b| level[a] == level[b]);
        // A depression with a sinkhole in its floor holds no water.
        let open: BTreeSet<u32> = (0..sinks.len()).filter(|&i| sinks[i]).map(|i| lake[i]).collect();
        if !open.is_empty() {
            parallel::update(&mut lake, |_, l| *l = if open.contains(l) { 0 } else { *l });
        }
        Self { pipes, domain, ground, level, lake }
    }
}

impl SedimentRouting for PipePaths<'_> {
    fn domain(&self) -> &RasterDomain {
        self.domain
    }

    fn order(&self) -> Box<dyn Iterator<Item = usize> + '_> {
        Box::new(highest_first(self.ground).into_iter())
    }

    fn downstream(&self, node: usize, part: f64) -> FlowPartition {
        let z = self.ground[node];
        let mut lower = FlowPartition::default();
        for (to, volume) in self.pipes.volume_out(self.domain, node) {
            if volume > 0.0 && self.ground[to] < z {
                lower.push(to, [volume, 1.0]);
            }
        }
        if lower.is_empty() {
            lower = FlowPartition::from_neighbours(self.domain, self.ground, node, |to| self.ground[to]);
        }
        lower.set_weights(Rule::Weighted, part);
        lower
    }

    fn height(&self, node: usize) -> f64 {
        self.ground[node]
    }

    fn lake(&self, node: usize) -> Option<usize> {
        (self.lake[node] > 0).then_some(self.lake[node] as usize)
    }

    fn surface(&self, node: usize) -> f64 {
        if self.lake[node] > 0 { self.level[node] } else { self.ground[node] }
    }
}
