//! Creep over a step, implicitly: links whose flux is in proportion to their drop.
//!
//! # Method
//! Finite volumes over the graph: on a raster the five-point stencil, on a mesh Voronoi faces.
//! Backward Euler. On rasters without periodic sides by over-relaxation in two colours ([`rows`]),
//! else by conjugate gradients ([`links`]).

mod links;
mod rows;

use std::borrow::Cow;

use landform_core::grid::{Centres, Domain, Link, Status};
use landform_core::terrain::{Layer, NodeSurface};
use landform_core::units::DiffusivityDimension;
use landform_core::verb::{Change, Context, Resolved, Varying};
use landform_core::{Error, Result, parallel};
use links::Links;
pub(super) use rows::Rows;

/// Error of the change over the greatest change.
const TOLERANCE: f64 = 1e-12;

/// The links of a graph with their conductances.
#[derive(Clone, Debug)]
pub(super) struct System {
    solver: Solver,
    /// Inner nodes, base levels beside them, and the conductance between them, m²/s.
    base_level_links: Vec<(u32, u32, f64)>,
    pub(super) cells: Cells,
}

/// Where creep acts: nodes, or the centres of the cells that they stand off.
#[derive(Clone, Debug)]
pub(super) struct Cells {
    centres: Option<Centres>,
    area: Vec<f64>,
}

#[derive(Clone, Debug)]
enum Solver {
    Rows(Box<Rows>),
    Links(Links),
}

impl System {
    pub(super) fn new<D: Domain>(domain: &D, diffusivity: &Resolved) -> Self {
        let rows = domain.five_point().map(|shape| {
            Solver::Rows(Box::new(Rows::new(domain, shape, |i, link| between(domain, diffusivity, i, link))))
        });
        let status = domain.status();
        let mut base_level_links = Vec::new();
        for i in (0..domain.len()).filter(|&i| status[i] == Status::Interior) {
            for link in domain.neighbours(i).filter(|l| status[l.to] == Status::BaseLevel) {
                let g = between(domain, diffusivity, i, link);
                if g > 0.0 {
                    base_level_links.push((i as u32, link.to as u32, g));
                }
            }
        }
        Self {
            solver: rows.unwrap_or_else(|| Solver::Links(Links::new(domain, diffusivity))),
            base_level_links,
            cells: Cells::new(domain),
        }
    }

    /// The change of every node in one backward-Euler step, and the one that fluxes at its end
    /// belong to.
    pub(super) fn change(&mut self, z: &[f64], dt: f64) -> Result<[Vec<f64>; 2]> {
        let by_links = |links: &Links| links.change(z, dt).map(|change| [change.clone(), change]);
        match &mut self.solver {
            Solver::Rows(rows) => match rows.change(z, dt) {
                Err(Error::NotConverged { .. }) => by_links(&rows.links()),
                found => found,
            },
            Solver::Links(links) => by_links(links),
        }
    }

    /// Volume flux from inner nodes to base levels after a change, m³/s.
    pub(super) fn outflow(&self, z: &[f64], change: &[f64]) -> f64 {
        let after = |i: u32| z[i as usize] + change[i as usize];
        parallel::sum(self.base_level_links.len(), |k| {
            let (i, base, g) = self.base_level_links[k];
            g * (after(i) - after(base))
        })
    }
}

impl Cells {
    pub(super) fn new<D: Domain>(domain: &D) -> Self {
        Self { centres: domain.centres(), area: (0..domain.len()).map(|i| domain.area(i)).collect() }
    }

    /// The heights that creep acts on: those at the centres of cells, where nodes stand off them.
    pub(super) fn heights<'z>(&self, z: &'z [f64]) -> Cow<'z, [f64]> {
        self.centres.as_ref().map_or(Cow::Borrowed(z), |centres| Cow::Owned(centres.values(z)))
    }

    /// Moves the ground by a change over heights, while so much flows to base levels; returns the
    /// volumes moved.
    pub(super) fn apply<T: NodeSurface>(&self, terrain: &mut T, change: &[f64], outflow: f64) -> Change {
        let (mut change, mut exported) = (Cow::Borrowed(change), outflow);
        if let Some(centres) = &self.centres {
            let domain = terrain.domain();
            let status = domain.status();
            let mut spread = centres.spread(&change);
            let held = |i: usize| status[i] != Status::Interior;
            // What comes to rest on a base level leaves.
            exported += parallel::sum(spread.len(), |i| if held(i) { spread[i] * self.area[i] } else { 0.0 });
            parallel::update(&mut spread, |i, change| *change = if held(i) { 0.0 } else { *change });
            change = Cow::Owned(spread);
        }
        terrain.change(Layer::Surface("soil"), |z| parallel::update(z, |i, v| *v += change[i]));
        let volume = |up: f64| parallel::sum(change.len(), |i| (up * change[i]).max(0.0) * self.area[i]);
        Change { eroded: volume(-1.0), deposited: volume(1.0), exported, ..Change::default() }
    }
}

/// A diffusivity on the nodes of a terrain, m²/s.
///
/// # Errors
/// Where [`Varying::resolve`] and [`Resolved::at_least_zero`] fail.
pub(super) fn resolve_diffusivity<T: NodeSurface>(
    given: &Varying<DiffusivityDimension>,
    terrain: &T,
    context: &Context,
) -> Result<Resolved> {
    given.resolve("diffusivity", terrain, context)?.at_least_zero("diffusivity")
}

/// Conductance of a link times the mean diffusivity of its ends, m²/s.
fn between<D: Domain>(domain: &D, diffusivity: &Resolved, node: usize, link: Link) -> f64 {
    domain.conductance(node, link.slot).max(0.0) * 0.5 * (diffusivity.at(node) + diffusivity.at(link.to))
}

#[cfg(test)]
mod tests {
    use landform_core::grid::{Edge, Edges, Grid, Shape};
    use landform_core::terrain::HeightField;
    use landform_core::units::{KYR, YEAR};

    use super::*;

    #[test]
    fn rows_and_links_give_the_same() {
        let mut grid = Grid::new(Shape::new(23, 38), [10.0, 14.0]).unwrap();
        grid.edges = Edges { north: Edge::Closed, ..Edges::default() };
        let mut z: Vec<f64> =
            (0..grid.len()).map(|i| 50.0 * landform_core::random::Seed(1).uniform(i as u64)).collect();
        z[400] = f64::NAN;
        let field = HeightField::new(grid.clone(), z.clone()).unwrap();
        let domain = field.domain();
        let varied = Resolved::PerNode((0..grid.len()).map(|i| 0.01 / YEAR * (1.0 + (i % 7) as f64)).collect());
        for dt in [KYR, 300.0 * KYR, 1e5 * KYR] {
            let shape = domain.five_point().unwrap();
            let [rows, end] =
                Rows::new(&*domain, shape, |i, link| between(&*domain, &varied, i, link)).change(&z, dt).unwrap();
            let links = Links::new(&*domain, &varied).change(&z, dt).unwrap();
            let other = Rows::new(&*domain, shape, |i, link| between(&*domain, &varied, i, link)).links();
            assert_eq!(other.change(&z, dt).unwrap(), links);
            // Fluxes hold the error of the heights times D dt over the area of a cell.
            let times = (dt / KYR).sqrt();
            for i in (0..z.len()).filter(|&i| i != 400) {
                let (change, end) = ((rows[i] - links[i]).abs(), (end[i] - links[i]).abs());
                assert!(change < 1e-7 * times && end < 1e-9 * times, "{dt} {i}: {change:e} {end:e}");
            }
        }
    }
}
