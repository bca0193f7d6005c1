//! From keys to a network of conduits.

use std::collections::{BTreeMap, BTreeSet};

use landform_core::feature::{ConduitNetwork, Feature, FeatureKind, Features, Geometry, Passage, Property, adjacency};
use landform_core::random::Seed;
use landform_core::terrain::{HeightField, NodeSurface};
use landform_core::units::Length;
use landform_core::verb::{Context, Edit};
use landform_core::{Error, Result};

use super::keys::Keys;
use super::rock::Rock;
use super::space::{Skeleton, Vector};
use super::{KarstNetwork, Method, colonise, leads, loops, maze, radii, shortest, wander};

/// A network, and its nodes at which water enters and leaves.
pub(super) struct Grown {
    pub(super) network: ConduitNetwork,
    pub(super) sinkholes: Vec<u32>,
    pub(super) springs: Vec<u32>,
    /// Share of all water in each conduit, 0 to 1.
    pub(super) shares: Vec<f64>,
    /// Level of the water table over each node, m.
    pub(super) water: Vec<f64>,
}

impl KarstNetwork {
    /// Grows the network under a surface.
    pub(super) fn grow(&self, ground: &HeightField, seed: Seed) -> Result<Grown> {
        let rock = Rock::new(self, ground, seed)?;
        let keys = Keys::new(self, &rock)?;
        let mut skeleton = Skeleton::default();
        let springs: Vec<u32> = rock.springs.iter().map(|s| skeleton.node(s.0)).collect();
        let sinks = keys.shafts.len() as f64;
        let leads = self.dead_ends.map_or((sinks * self.preset.dead_ends()).round() as usize, |n| n as usize);
        let ends = sinks + leads as f64;
        let wanted = self.cycles.map_or((ends * self.preset.loops()).round() as usize, |n| n as usize);
        let reached = match (self.preset.is_maze(), self.method) {
            (true, _) => maze::fill(&mut skeleton, &keys, &rock, self.preset)?,
            (false, Method::SpaceColonisation) => colonise::colonise(&mut skeleton, &keys, &rock),
            (false, Method::ShortestPaths) => shortest::shortest(&mut skeleton, &keys, &rock, self.gamma, wanted)?,
        };
        leads::add(&mut skeleton, leads, &rock, seed.named("leads"));
        let sinkholes: Vec<u32> =
            keys.shafts.iter().zip(&reached).map(|(s, foot)| hang(&mut skeleton, s, *foot)).collect();
        let missing = wanted.saturating_sub(cycles(&skeleton));
        loops::close(&mut skeleton, missing, &rock, seed.named("loops"));
        let feet = keys.shafts.len();
        let fixed: Vec<u32> = springs.iter().chain(&sinkholes).chain(&reached[feet..]).copied().collect();
        let bent = wander::wander(&skeleton, &fixed, [self.tortuosity, self.method.straighter()], &rock)?;
        let ends = Ends { sinkholes, springs, waypoints: reached[feet..].to_vec() };
        self.conduits(bent, ends, &rock)
    }

    /// Conduits, from where the water comes to where it goes, with their radii.
    fn conduits(&self, bent: Skeleton, ends: Ends, rock: &Rock<'_>) -> Result<Grown> {
        let Ends { sinkholes, springs, waypoints } = ends;
        let (bent, number) = whole(bent, &springs, rock);
        let [sinkholes, springs, waypoints] =
            [sinkholes, springs, waypoints].map(|n| n.into_iter().map(|n| number[n as usize]).collect::<Vec<_>>());
        for (name, nodes) in [("sinkholes", &sinkholes), ("waypoints", &waypoints)] {
            let left = nodes.iter().filter(|n| **n == u32::MAX).count();
            if left > 0 {
                return Err(cut_off(name, left, nodes.len(), self.method));
            }
        }
        let ends: Vec<u32> = sinkholes.iter().chain(&springs).copied().collect();
        let mut network = ConduitNetwork::from_edges_with_ends(bent.nodes, &bent.edges, &ends, |_| Passage::default());
        let mut shares = radii::shares(&network, &sinkholes, &springs);
        let radii = radii::radii(&shares, self.radius.map(Length::si));
        for (k, conduit) in network.conduits.iter_mut().enumerate() {
            let radius = (radii[k] * 1e4).round() / 1e4;
            conduit.passages.fill(Passage::round(radius));
            if shares[k] < 0.0 {
                conduit.nodes.reverse();
                shares[k] = -shares[k];
            }
        }
        let water = network.nodes.iter().map(|at| rock.water_table(*at)).collect();
        Ok(Grown { network, sinkholes, springs, shares, water })
    }
}

impl Method {
    /// By how much bends are less along fractures. Shortest paths are straight as they are.
    fn straighter(self) -> f64 {
        match self {
            Self::SpaceColonisation => 0.25,
            Self::ShortestPaths => 0.0,
        }
    }
}

/// Nodes of a skeleton at which water enters and leaves, and others that it must pass.
struct Ends {
    sinkholes: Vec<u32>,
    springs: Vec<u32>,
    waypoints: Vec<u32>,
}

/// The parts of a network that lie in the rock and hang together with a spring. Nodes at one place
/// become one. Returns the new number of each node too, `u32::MAX` for those left out.
fn whole(bent: Skeleton, springs: &[u32], rock: &Rock<'_>) -> (Skeleton, Vec<u32>) {
    let mut known: BTreeMap<[u64; 3], u32> = BTreeMap::new();
    let place = |at: &Vector| at.map(|v| (v + 0.0).to_bits());
    let one: Vec<u32> = (0..).zip(&bent.nodes).map(|(k, at)| *known.entry(place(at)).or_insert(k)).collect();
    let mut seen = BTreeSet::new();
    let mut edges: Vec<[u32; 2]> = bent.edges.iter().map(|e| e.map(|n| one[n as usize])).collect();
    edges.retain(|[a, b]| a != b && seen.insert([*a.min(b), *a.max(b)]));
    let is_fit: Vec<bool> = bent.nodes.iter().map(|at| rock.is_in_rock(*at)).collect();
    let is_clear = |[a, b]: [u32; 2]| {
        let ends = [a, b].map(|n| n as usize);
        ends.iter().all(|&n| is_fit[n]) && rock.is_clear(bent.nodes[ends[0]], bent.nodes[ends[1]], f64::INFINITY)
    };
    edges.retain(|e| is_clear(*e));
    let joined = adjacency(bent.nodes.len(), &edges);
    let mut number = vec![u32::MAX; bent.nodes.len()];
    let mut stack: Vec<u32> = springs.iter().map(|s| one[*s as usize]).collect();
    while let Some(node) = stack.pop() {
        if number[node as usize] == u32::MAX {
            number[node as usize] = node;
            stack.extend(joined[node as usize].iter().filter(|n| number[**n as usize] == u32::MAX));
        }
    }
    edges.retain(|[a, _]| number[*a as usize] != u32::MAX);
    let number = one.iter().map(|n| number[*n as usize]).collect();
    (Skeleton { nodes: bent.nodes, edges }, number)
}

/// That no way was found to some keys.
fn cut_off(name: &str, left: usize, of: usize, method: Method) -> Error {
    let other = match method {
        Method::SpaceColonisation => "; `method` \"shortest_paths\" finds ways around more of them",
        Method::ShortestPaths => ", or a shorter `step`",
    };
    Error::Recipe {
        at: None,
        what: format!("no way through the rock leads from the springs to {left} of {of} {name}"),
        hint: Some(format!("`forbidden` spheres or nodata cut it off: give smaller ones or other places{other}")),
    }
}

/// Hangs a shaft on its foot; returns the node of its sinkhole.
fn hang(skeleton: &mut Skeleton, shaft: &[Vector], foot: u32) -> u32 {
    let above = shaft[..shaft.len() - 1].iter().rev();
    above.fold(foot, |below, at| skeleton.grow(below, *at))
}

/// Independent cycles of a network that hangs together.
fn cycles(skeleton: &Skeleton) -> usize {
    (skeleton.edges.len() + 1).saturating_sub(skeleton.nodes.len())
}

impl Grown {
    /// Conduits, sinkholes and springs.
    pub(super) fn features(&self) -> Features {
        let digits = |v: f64, scale: f64| (v * scale).round() / scale;
        let conduits = self.network.features().into_iter().zip(&self.network.conduits).zip(&self.shares);
        let conduits = conduits.map(|((mut feature, conduit), share)| {
            let under = |n: &u32| digits(self.water[*n as usize] - self.network.nodes[*n as usize][2], 100.0);
            let own = [
                ("water_share", Property::Number(digits(*share, 1e4))),
                ("depth_under_water_table_m", Property::Numbers(conduit.nodes.iter().map(under).collect())),
            ];
            feature.properties.extend(own.map(|(name, property)| (name.to_string(), property)));
            feature
        });
        let points = |kind: FeatureKind, nodes: &[u32]| {
            let point = |(k, n): (usize, &u32)| Feature {
                id: (k + 1).to_string(),
                kind,
                geometry: Geometry::Point(self.network.nodes[*n as usize]),
                properties: Vec::new(),
            };
            nodes.iter().enumerate().map(point).collect::<Vec<_>>()
        };
        let sinkholes = points(FeatureKind::Sinkhole, &self.sinkholes);
        conduits.chain(sinkholes).chain(points(FeatureKind::Spring, &self.springs)).collect()
    }
}

impl Edit<HeightField> for KarstNetwork {
    fn edit(&self, terrain: &mut HeightField, context: &Context) -> Result<()> {
        let found = self.grow(terrain, context.seed)?.features();
        terrain.features_mut().update(found);
        Ok(())
    }
}
