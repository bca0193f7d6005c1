//! From keys to a network of conduits.

use landform_core::Result;
use landform_core::feature::{ConduitNetwork, Feature, FeatureKind, Features, Geometry, Passage, Property};
use landform_core::random::Seed;
use landform_core::terrain::{HeightField, NodeSurface};
use landform_core::units::Length;
use landform_core::verb::{Context, Edit};

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
        let fixed: Vec<u32> = springs.iter().chain(&sinkholes).copied().collect();
        let bent = wander::wander(&skeleton, &fixed, self.tortuosity, &rock);
        Ok(self.conduits(&bent, sinkholes, springs, &rock))
    }

    /// Conduits, from where the water comes to where it goes, with their radii.
    fn conduits(&self, bent: &Skeleton, sinkholes: Vec<u32>, springs: Vec<u32>, rock: &Rock<'_>) -> Grown {
        let mut edges: Vec<[u32; 2]> = bent.edges.clone();
        edges.retain(|[a, b]| bent.nodes[*a as usize] != bent.nodes[*b as usize]);
        let mut network = ConduitNetwork::from_edges(bent.nodes.clone(), &edges, |_| Passage::default());
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
        Grown { network, sinkholes, springs, shares, water }
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
