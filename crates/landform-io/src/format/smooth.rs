//! Smoothing of voxels' surfaces that keeps the volume of each body.
//!
//! # Method
//! Each point moves towards the mean of its neighbours and then a little further away from it
//! (Taubin 1995), which takes steps away and leaves the large form. What volume a body has lost
//! after a round is given back by a shift of its points across the surface, so that a passage of
//! one voxel stays as wide as it is, however many rounds there are.

use landform_core::algo::DisjointSets;
use landform_core::algo::polygonise::Quads;

use crate::vector::{cross, dot, sub};

/// Parts of the way to the mean of the neighbours, there and back (Taubin 1995, section 4).
const WAYS: [f64; 2] = [0.6307, -0.6732];
/// How far a point may move along an axis, voxels.
const FARTHEST: f64 = 0.5;
/// Rounds of giving volume back at the end.
const LAST: usize = 8;

/// Places of all vertices of voxels' faces after some rounds, in voxels, from the corners of voxels
/// or from surface nets. Those on the sides of the box stay in them.
pub(super) fn smooth(quads: &Quads, size: [usize; 3], rounds: u32, nets: bool) -> Vec<[f64; 3]> {
    let home: Vec<[f64; 3]> = quads.vertices.iter().map(|v| v.map(f64::from)).collect();
    if rounds == 0 && !nets {
        return quads.points(home);
    }
    let bodies = Bodies::of(quads, &home);
    let hold = |i: usize, place: [f64; 3]| {
        [0, 1, 2].map(|k| {
            let is_side = home[i][k] == 0.0 || home[i][k] == size[k] as f64;
            let near = place[k].clamp(home[i][k] - FARTHEST, home[i][k] + FARTHEST);
            if is_side { home[i][k] } else { near.clamp(0.0, size[k] as f64) }
        })
    };
    let mut points = home.clone();
    if nets {
        points = quads.nets().into_iter().enumerate().map(|(i, place)| hold(i, place)).collect();
    }
    for _ in 0..rounds {
        for way in WAYS {
            let means = means(quads, &points);
            let moved = |i: usize| hold(i, [0, 1, 2].map(|k| points[i][k] + way * (means[i][k] - points[i][k])));
            points = (0..points.len()).map(moved).collect();
        }
        bodies.fill(quads, &mut points, hold);
    }
    (0..LAST).for_each(|_| bodies.fill(quads, &mut points, hold));
    quads.points_apart(points)
}

/// The mean of the neighbours of each vertex.
fn means(quads: &Quads, points: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let mut sums = vec![([0.0; 3], 0.0); points.len()];
    for face in &quads.faces {
        for k in 0..4 {
            let (sum, count) = &mut sums[face[k] as usize];
            let next = points[face[(k + 1) % 4] as usize];
            (0..3).for_each(|axis| sum[axis] += next[axis]);
            *count += 1.0;
        }
    }
    sums.into_iter().map(|(sum, count)| sum.map(|v| v / count)).collect()
}

/// Bodies that a surface encloses, and their volumes.
struct Bodies {
    /// The body of each vertex.
    of: Vec<u32>,
    volumes: Vec<f64>,
}

impl Bodies {
    fn of(quads: &Quads, home: &[[f64; 3]]) -> Self {
        let mut sets = DisjointSets::new(home.len());
        for face in &quads.faces {
            face[1..].iter().for_each(|&v| {
                sets.join(face[0], v);
            });
        }
        let of: Vec<u32> = (0..home.len() as u32).map(|v| sets.root(v)).collect();
        let mut bodies = Self { of, volumes: Vec::new() };
        bodies.volumes = bodies.measure(quads, home, &areas(quads, home)).into_iter().map(|b| b[0]).collect();
        bodies
    }

    /// The volume of each body and what a unit shift across its surface adds, by its first vertex.
    fn measure(&self, quads: &Quads, points: &[[f64; 3]], areas: &[[f64; 3]]) -> Vec<[f64; 2]> {
        let mut found = vec![[0.0; 2]; points.len()];
        for face in &quads.faces {
            let [a, b, c, d] = face.map(|v| points[v as usize]);
            found[self.of[face[0] as usize] as usize][0] += (dot(a, cross(b, c)) + dot(a, cross(c, d))) / 6.0;
        }
        for (v, across) in areas.iter().enumerate() {
            found[self.of[v] as usize][1] += dot(*across, *across).sqrt();
        }
        found
    }

    /// Shifts points across the surface until bodies have their volume again.
    fn fill(&self, quads: &Quads, points: &mut [[f64; 3]], hold: impl Fn(usize, [f64; 3]) -> [f64; 3]) {
        let areas = areas(quads, points);
        let found = self.measure(quads, points, &areas);
        for (v, across) in areas.into_iter().enumerate() {
            let body = self.of[v] as usize;
            let ([volume, area], length) = (found[body], dot(across, across).sqrt());
            if length > 0.0 {
                let shift = ((self.volumes[body] - volume) / area).clamp(-FARTHEST, FARTHEST) / length;
                points[v] = hold(v, [0, 1, 2].map(|k| points[v][k] + shift * across[k]));
            }
        }
    }
}

/// A quarter of the areas of the faces around each vertex, as vectors across them.
fn areas(quads: &Quads, points: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let mut sums = vec![[0.0; 3]; points.len()];
    for face in &quads.faces {
        let [a, b, c, d] = face.map(|v| points[v as usize]);
        let across = cross(sub(c, a), sub(d, b));
        face.iter().for_each(|&v| (0..3).for_each(|k| sums[v as usize][k] += 0.125 * across[k]));
    }
    sums
}

#[cfg(test)]
mod tests {
    use landform_core::algo::polygonise::polygonise;

    use super::*;

    /// Volume of each body after some rounds over that before.
    fn kept(rounds: u32, nets: bool, is_solid: impl Fn([usize; 3]) -> bool) -> (f64, f64) {
        let size = [24, 9, 9];
        let quads = polygonise(size, is_solid);
        let points = smooth(&quads, size, rounds, nets);
        let home: Vec<[f64; 3]> = quads.vertices.iter().map(|v| v.map(f64::from)).collect();
        let bodies = Bodies::of(&quads, &home);
        let ratios = bodies.measure(&quads, &points, &areas(&quads, &points)).into_iter().zip(&bodies.volumes);
        let ratios = ratios.filter(|(_, before)| **before != 0.0).map(|(now, before)| now[0] / before);
        ratios.fold((f64::INFINITY, 0.0), |(low, high), r| (low.min(r), high.max(r)))
    }

    #[test]
    fn bodies_keep_their_volume_through_any_number_of_rounds() {
        // A passage of one voxel with a bend, a single voxel beside it, and a chamber.
        let passage =
            |[x, y, z]: [usize; 3]| z == 4 && ((y == 2 && (2..20).contains(&x)) || (x == 20 && (2..6).contains(&y)));
        let voxel = |at: [usize; 3]| at == [4, 6, 6];
        let chamber =
            |[x, y, z]: [usize; 3]| (8..14).contains(&x) && (4..8).contains(&y) && (1..8).contains(&z) && x + y > 13;
        for (rounds, nets) in [(1, false), (3, false), (10, true), (100, false), (0, true), (100, true)] {
            let (low, high) = kept(rounds, nets, |at| passage(at) || voxel(at) || chamber(at));
            assert!(low > 0.97 && high < 1.03, "{rounds} rounds: {low} to {high}");
        }
    }

    #[test]
    fn steps_of_a_slope_grow_even() {
        let size = [24, 9, 9];
        let quads = polygonise(size, |[x, _, z]| 3 * z < x);
        let rough = |points: &[[f64; 3]]| {
            let off = |p: &[f64; 3]| (3.0 * p[2] - p[0] - 1.0).abs();
            let inner =
                |v: &[u32; 3]| (3..21).contains(&v[0]) && (2..7).contains(&v[1]) && v[2] > 0 && 3 * v[2] < v[0] + 4;
            quads.vertices.iter().zip(points).filter(|(v, _)| inner(v)).map(|(_, p)| off(p)).fold(0.0, f64::max)
        };
        let [before, after] = [0, 10].map(|rounds| rough(&smooth(&quads, size, rounds, false)));
        assert!(after < 0.5 * before, "{before} {after}");
    }
}
