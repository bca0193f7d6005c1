//! Mud cracks: a drying layer tears, every crack relieves what is beside it, and plates are left.
//! The model of the tutorial in docs/tutorial/README.md.
//!
//! `cargo run --release --example mud_cracks` writes mud_cracks.png into the folder it is run in.

use landform::core::Result;
use landform::core::agents::{Connectivity, Falloff, Group, Order, RasterSites, Search, Sites, avalanche};
use landform::core::algo::fast_marching::{self, distance};
use landform::core::grid::{Grid, Lattice, Shape};
use landform::core::math;
use landform::core::random::Seed;
use landform::core::terrain::HeightField;
use landform::io::format::encode_png;
use landform::io::render::{MapStyle, Ramp, shaded_map};

/// How far a crack relieves the mud beside it, sites.
const RELIEF: f64 = 18.0;
/// Steps that a tip takes in a round.
const STRIDE: usize = 12;

/// A drying layer of n by n sites after so many rounds. Cracks are 1 deep; plates curl up a little
/// at their edges.
pub(crate) fn mud_cracks(n: usize, rounds: u64, seed: u64) -> Result<HeightField> {
    let grid = Grid::new(Shape::new(n, n), [1.0, 1.0])?;
    let sites = RasterSites::new(&grid, Connectivity::Eight)?;
    let (mut search, mut draws) = (Search::new(n * n), Seed(seed).draws());
    let strength: Vec<f64> = (0..n * n).map(|_| 0.8 + 0.4 * draws.uniform()).collect();
    let mut tension = vec![0.0; n * n];
    let mut cracked = vec![false; n * n];
    // Tips of cracks are the agents; their state is where they are heading, radians, and where
    // within their site they are.
    let mut tips: Group<(f64, [f64; 2])> = Group::new(n * n);
    for round in 0..rounds {
        // Drying pulls everywhere alike.
        tension.iter_mut().for_each(|t| *t += 1.3 / rounds as f64);
        // Where the mud is weakest against its tension, it tears both ways.
        let pull = |i: usize| if cracked[i] { 0.0 } else { tension[i] / strength[i] };
        let weakest = (0..n * n).max_by(|&a, &b| pull(a).total_cmp(&pull(b))).filter(|&i| pull(i) > 1.0);
        if let Some(site) = weakest {
            let heading = draws.uniform() * std::f64::consts::TAU;
            cracked[site] = true;
            for heading in [heading, heading + std::f64::consts::PI] {
                let way = [1.5 * math::cos(heading), 1.5 * math::sin(heading), 0.0];
                sites.step(site, way).map(|next| tips.join(next, (heading, [0.0; 2])));
            }
        }
        for _ in 0..STRIDE {
            tips.visit(Order::Shuffled(Seed(seed).with(round)), |tips, site| {
                let Some((heading, at)) = tips.leave(site) else { return };
                // A tip that meets a crack has cut off a plate.
                if std::mem::replace(&mut cracked[site], true) {
                    return;
                }
                // An avalanche: the mud beside the crack is relieved, and tears later or never.
                let relieve = |near: usize, weight: f64| tension[near] *= 1.0 - 0.3 * weight;
                avalanche(&sites, &mut search, site, RELIEF, Falloff::Linear, |_, _| true, relieve);
                let heading = heading + 0.35 * (draws.uniform() - 0.5);
                let to = [at[0] + 1.1 * math::cos(heading), at[1] + 1.1 * math::sin(heading)];
                if let Some(next) = sites.step(site, [to[0], to[1], 0.0]).filter(|&next| next != site) {
                    let moved = sites.offset(site, next);
                    tips.join(next, (heading, [to[0] - moved[0], to[1] - moved[1]]));
                }
            });
        }
    }
    let cracks: Vec<usize> = (0..n * n).filter(|&i| cracked[i]).collect();
    let away = distance(&Lattice::of(&grid), &cracks, fast_marching::Order::First);
    let height = |i: usize| if cracked[i] { -1.0 } else { 0.5 * math::exp(-away[i].min(1e3) / 3.0) };
    HeightField::new(grid, (0..n * n).map(height).collect())
}

fn main() -> Result<()> {
    let map =
        shaded_map(&mud_cracks(320, 400, 1)?, &MapStyle { water: false, ramp: Ramp::Grey, ..MapStyle::default() })?;
    let path = std::path::Path::new("mud_cracks.png");
    std::fs::write(path, encode_png(&map.pixels, map.shape)?).map_err(|e| landform::core::Error::io("write", path, e))
}
