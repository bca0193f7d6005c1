//! Corrosion: exposed material disintegrates, exposes and weakens what is near, and a flat surface
//! gets pits and cracks (Pytel 2015, figure 3.1, bottom row).
//!
//! `cargo run --release --example corrosion` writes corrosion.png into the folder it is run in.

use landform::core::Result;
use landform::core::agents::{Connectivity, Falloff, Group, Order, RasterSites, Search, avalanche};
use landform::core::grid::{Edge, Edges, Grid, Neighbours, Shape};
use landform::core::random::Seed;
use landform::core::terrain::HeightField;
use landform::io::format::encode_png;
use landform::io::render::{MapStyle, shaded_map};

/// Radius in which an event weakens, sites. It is what tells this from self-organised criticality
/// proper: a scale.
const RADIUS: f64 = 4.0;
/// What an event takes from the strength of the site beside it.
const WEAKENING: f64 = 0.035;
/// Force of the weather, against strengths from 0 to 1.
const FORCE: f64 = 0.16;

/// A flat surface of n by n sites after so many rounds of corrosion.
pub(crate) fn corrosion(n: usize, rounds: usize, seed: u64) -> Result<HeightField> {
    let mut grid = Grid::new(Shape::new(n, n), [1.0, 1.0])?;
    grid.edges = Edges::all(Edge::Periodic);
    let sites = RasterSites::new(&grid, Connectivity::Eight)?;
    let (mut search, mut draws) = (Search::new(n * n), Seed(seed).draws());
    let mut depth = vec![0.0f64; n * n];
    // An agent a site: what is left of the strength of the material that is exposed there.
    let mut material: Group<f64> = Group::new(n * n);
    (0..n * n).for_each(|site| {
        material.join(site, draws.uniform());
    });
    for round in 0..rounds {
        let mut weakened: Vec<(usize, f64)> = Vec::new();
        material.visit(Order::Shuffled(Seed(seed).with(round as u64)), |material, site| {
            // Sites that stand above their neighbours are exposed on more sides.
            let open = sites.neighbours(site).filter(|near| depth[near.to] > depth[site]).count();
            let strength = material.at(site).copied().unwrap_or(0.0);
            if strength * (1.0 - open as f64 / 10.0) < FORCE {
                depth[site] += 1.0;
                // Fresh material, and an avalanche: what is near grows weaker.
                *material.at_mut(site).expect("the agent that acts") = draws.uniform();
                avalanche(
                    &sites,
                    &mut search,
                    site,
                    RADIUS,
                    Falloff::Linear,
                    |_, _| true,
                    |near, weight| {
                        if near != site {
                            weakened.push((near, WEAKENING * weight));
                        }
                    },
                );
            }
        });
        for (site, less) in weakened {
            *material.at_mut(site).expect("a site") -= less;
        }
    }
    HeightField::new(grid, depth.iter().map(|d| -0.2 * d).collect())
}

fn main() -> Result<()> {
    let field = corrosion(256, 14, 1)?;
    let map = shaded_map(&field, &MapStyle { water: false, ..MapStyle::default() })?;
    let path = std::path::Path::new("corrosion.png");
    std::fs::write(path, encode_png(&map.pixels, map.shape)?).map_err(|e| landform::core::Error::io("write", path, e))
}
