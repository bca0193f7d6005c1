//! Optimal channel networks: drainage trees of least energy.
//!
//! # Model
//! Energy E = Σ A^γ d over all nodes, A drainage area (in cells), d length of the way to the
//! receiver (in cells), γ = 1/2. Landscapes at a steady state of stream power with m/n = 1 − γ are
//! local minima of it.
//!
//! # Method
//! A random node gets another of its neighbours as receiver, unless that would close a circle.
//! Areas change only along those parts of the old and the new path that the two do not share. The
//! change is kept if E falls, or with probability exp(−ΔE/T). T falls to 0 over the sweeps. Heights
//! follow from S ∝ A^(γ − 1), from the outlets upwards.
//!
//! # Sources
//! Rodríguez-Iturbe, Rinaldo, Rigon, Bras, Marani & Ijjász-Vásquez (1992); Rinaldo, Rigon, Banavar,
//! Maritan & Rodríguez-Iturbe (2014).

use landform_core::algo::flow::{Flow, node_areas};
use landform_core::field::names;
use landform_core::grid::{Domain, Link, Neighbours, RasterDomain, Status};
use landform_core::random::{Seed, Stream};
use landform_core::terrain::{HeightField, Layer, NodeSurface};
use landform_core::units::Length;
use landform_core::verb::{Context, Edit, Outlets, Params, Source};
use landform_core::{Error, Result, math, parallel};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Optimal channel network: rearranges drainage until its energy is least, and gives the ground the
/// heights of such rivers. The elevation before only sets where the search begins.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct OptimalNetwork {
    /// Exponent of drainage area in the energy.
    #[schemars(extend("x-above" = 0.0, "x-max" = 1.0))]
    pub energy_exponent: f64,
    /// Number of trial changes for each node.
    #[schemars(extend("x-min" = 0, "x-max" = 10_000))]
    pub iterations: u64,
    /// Temperature at the start, in mean energies of a node. With 0 no change that raises the
    /// energy is accepted.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1e6))]
    pub temperature: f64,
    /// Greatest height above the outlets.
    #[schemars(extend("x-above" = 0.0))]
    pub relief: Length,
    /// Where water leaves, as in `stream_power`. If not given, the outlets of the landscape are
    /// used.
    pub outlets: Option<Outlets>,
}

impl Default for OptimalNetwork {
    fn default() -> Self {
        Self { energy_exponent: 0.5, iterations: 60, temperature: 0.0, relief: Length::of(500.0), outlets: None }
    }
}

impl Params for OptimalNetwork {
    const NAME: &'static str = "optimal_network";
    const RENAMED: &'static [(&'static str, &'static str)] = &[("sweeps", "iterations")];
    const SOURCES: &'static [Source] = &[
        Source {
            authors: "Rodriguez-Iturbe et al. (1992)",
            title: "Energy dissipation, runoff production, and the three-dimensional structure of river basins, Water Resources Research 28(4)",
            doi: "10.1029/91WR03034",
        },
        Source {
            authors: "Rinaldo et al. (2014)",
            title: "Evolution and selection of river networks: statics, dynamics, and complexity, PNAS 111(7)",
            doi: "10.1073/pnas.1322700111",
        },
    ];

    fn leaves(&self) -> Vec<String> {
        [names::DRAINAGE_AREA.name, names::RECEIVER.name].map(String::from).to_vec()
    }

    fn check(&self) -> Result<()> {
        self.outlets.as_ref().map_or(Ok(()), Outlets::check)
    }
}

impl Edit<HeightField> for OptimalNetwork {
    fn edit(&self, terrain: &mut HeightField, context: &Context) -> Result<()> {
        if let Some(outlets) = &self.outlets {
            outlets.apply(terrain, 0.0, context)?;
        }
        let domain = terrain.domain();
        let mut tree = Tree::of(&domain, terrain.elevation(), self.energy_exponent);
        tree.search(&domain, self.iterations, self.temperature, context.seed);
        let (heights, order) = tree.heights(self.energy_exponent);
        let greatest = heights.iter().copied().fold(0.0, f64::max);
        if greatest == 0.0 {
            return Err(Error::parameter("outlets", "everywhere", "some ground that is no outlet"));
        }
        // Outlets keep their elevation.
        let scale = self.relief.si() / greatest;
        terrain.change(Layer::Bedrock, |z| {
            for &i in order.iter().rev() {
                let (i, r) = (i as usize, tree.receiver[i as usize] as usize);
                if r != i {
                    z[i] = z[r] + (heights[i] - heights[r]) * scale;
                }
            }
        });
        let status = domain.status();
        let cell = terrain.grid().cell_area();
        let area =
            parallel::map(
                tree.area.len(),
                |i| if status[i] == Status::Masked { f64::NAN } else { tree.area[i] * cell },
            );
        terrain.fields_mut().insert(&names::DRAINAGE_AREA, area)?;
        terrain.fields_mut().insert(&names::RECEIVER, tree.receiver)
    }
}

/// A drainage tree with its areas.
pub(super) struct Tree {
    pub(super) receiver: Vec<u32>,
    /// Length of the way to the receiver, cells.
    length: Vec<f64>,
    /// Drainage area, cells.
    pub(super) area: Vec<f64>,
    exponent: f64,
    /// Last try in which a node was on the new way down.
    stamp: Vec<u64>,
    tries: u64,
}

impl Tree {
    /// The tree that water takes over a surface.
    pub(super) fn of(domain: &RasterDomain, z: &[f64], exponent: f64) -> Self {
        let cell = domain.area(0);
        let unit = cell.sqrt();
        let mut flow = Flow::new();
        let mut area = node_areas(domain);
        flow.route(domain, z, &mut area);
        let length = (0..z.len()).map(|i| match flow.receivers()[i] as usize == i {
            true => 0.0,
            false => domain.distance(i, flow.slots()[i]) / unit,
        });
        Self {
            length: length.collect(),
            receiver: flow.receivers().to_vec(),
            area: area.iter().map(|a| a / cell).collect(),
            exponent,
            stamp: vec![0; z.len()],
            tries: 0,
        }
    }

    fn cost(&self, area: f64) -> f64 {
        math::pow(area, self.exponent)
    }

    /// Σ A^γ d.
    pub(super) fn energy(&self) -> f64 {
        (0..self.area.len())
            .map(|i| if self.length[i] > 0.0 { self.cost(self.area[i]) * self.length[i] } else { 0.0 })
            .sum()
    }

    /// The change of energy if `node` drained over a link, and where its two ways down meet; none
    /// if that closes a circle.
    pub(super) fn change(&mut self, node: usize, link: Link, unit: f64) -> Option<(f64, usize)> {
        self.tries += 1;
        let mut at = link.to;
        loop {
            if at == node {
                return None;
            }
            self.stamp[at] = self.tries;
            let next = self.receiver[at] as usize;
            if next == at {
                break;
            }
            at = next;
        }
        let moved = self.area[node];
        let mut change = self.cost(moved) * (link.distance / unit - self.length[node]);
        // Down the old way until it meets the new, or to its own outlet.
        let mut at = self.receiver[node] as usize;
        let meets = loop {
            if self.stamp[at] == self.tries {
                break at;
            }
            change += (self.cost(self.area[at] - moved) - self.cost(self.area[at])) * self.length[at];
            let next = self.receiver[at] as usize;
            if next == at {
                break usize::MAX;
            }
            at = next;
        };
        let mut at = link.to;
        while at != meets {
            change += (self.cost(self.area[at] + moved) - self.cost(self.area[at])) * self.length[at];
            let next = self.receiver[at] as usize;
            if next == at {
                break;
            }
            at = next;
        }
        Some((change, meets))
    }

    fn take(&mut self, node: usize, link: Link, unit: f64, meets: usize) {
        let moved = self.area[node];
        for (start, sign) in [(self.receiver[node] as usize, -1.0), (link.to, 1.0)] {
            let mut at = start;
            while at != meets {
                self.area[at] += sign * moved;
                let next = self.receiver[at] as usize;
                if next == at {
                    break;
                }
                at = next;
            }
        }
        self.receiver[node] = link.to as u32;
        self.length[node] = link.distance / unit;
    }

    /// Tries this many changes for each node while the temperature falls.
    pub(super) fn search(&mut self, domain: &RasterDomain, iterations: u64, temperature: f64, seed: Seed) {
        let has_choice = |i: &usize| domain.status()[*i] == Status::Interior && domain.neighbours(*i).next().is_some();
        let inner: Vec<usize> = (0..self.area.len()).filter(has_choice).collect();
        if inner.is_empty() {
            return;
        }
        let unit = domain.area(0).sqrt();
        let mean = self.energy() / inner.len() as f64;
        let mut draws = seed.stream();
        let all = iterations * inner.len() as u64;
        for k in 0..all {
            let bits = draws.bits();
            let node = inner[Stream::index(bits as u32, inner.len())];
            let links: Vec<Link> = domain.neighbours(node).collect();
            let link = links[Stream::index((bits >> 32) as u32, links.len())];
            if link.to == self.receiver[node] as usize {
                continue;
            }
            let Some((change, meets)) = self.change(node, link, unit) else { continue };
            let left = 1.0 - k as f64 / all as f64;
            let warmth = temperature * mean * left * left;
            let chance = (draws.bits() >> 11) as f64 / (1u64 << 53) as f64;
            if change <= 0.0 || warmth > 0.0 && chance < math::exp(-change / warmth) {
                self.take(node, link, unit, meets);
            }
        }
    }

    /// Longest ways upstream, cells.
    #[cfg(test)]
    pub(super) fn lengths(&self) -> Vec<f64> {
        let mut longest = vec![0.0f64; self.area.len()];
        for &i in &self.heights(self.exponent).1 {
            let (i, r) = (i as usize, self.receiver[i as usize] as usize);
            if r != i {
                longest[r] = longest[r].max(longest[i] + self.length[i]);
            }
        }
        longest
    }

    /// Part of all single changes that would lower the energy; `among` says which changes count:
    /// (length now, length then).
    #[cfg(test)]
    pub(super) fn gains(&mut self, domain: &RasterDomain, among: impl Fn(f64, f64) -> bool) -> f64 {
        let unit = domain.area(0).sqrt();
        let (mut all, mut lower) = (0u64, 0u64);
        for node in (0..self.area.len()).filter(|&i| domain.status()[i] == Status::Interior) {
            for link in domain.neighbours(node).collect::<Vec<_>>() {
                if link.to != self.receiver[node] as usize
                    && among(self.length[node], link.distance / unit)
                    && let Some((change, _)) = self.change(node, link, unit)
                {
                    all += 1;
                    lower += u64::from(change < -1e-9);
                }
            }
        }
        lower as f64 / all.max(1) as f64
    }

    /// Heights in arbitrary units, and nodes with donors before receivers.
    fn heights(&self, exponent: f64) -> (Vec<f64>, Vec<u32>) {
        // Area grows along the flow, strictly.
        let mut order: Vec<u32> = (0..self.area.len() as u32).collect();
        parallel::sort_by(&mut order, |&a, &b| self.area[a as usize].total_cmp(&self.area[b as usize]).then(a.cmp(&b)));
        let mut heights = vec![0.0; self.area.len()];
        for &i in order.iter().rev() {
            let (i, r) = (i as usize, self.receiver[i as usize] as usize);
            if r != i {
                heights[i] = heights[r] + self.length[i] * math::pow(self.area[i], exponent - 1.0);
            }
        }
        (heights, order)
    }
}
