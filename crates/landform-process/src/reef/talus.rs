//! Slopes of reef rock and rubble that are too steep slip.
//!
//! Where a reef under water stands steeper than the talus angle over a neighbour, or over the plane
//! through two that lie side by side, as much of it slips on to the neighbour as brings both to the
//! angle; without planes a cone would have as many sides as a node has neighbours. Nodes are
//! visited from the highest down, so that what slips runs down a whole slope at once, and again
//! until little moves. Only coral slips.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use landform_core::grid::{Domain, Status};
use landform_core::math::ordered_bits;
use landform_core::parallel;

/// Rounds of a step at most.
const MOST_ROUNDS: u8 = 6;
/// Excess height that stays, m.
const STAYS: f64 = 0.1;

/// Volumes that slipped, m³.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Slipped {
    /// From nodes that are not held.
    pub eroded: f64,
    /// On to nodes that are not held.
    pub deposited: f64,
    /// On to nodes at base level, where it leaves.
    pub exported: f64,
}

/// Lets coral of a depth (m) slip on a surface (m), both of which follow, wherever the surface is
/// under `level` (m) and steeper than `slope` (rise over run).
pub(super) fn slip(
    domain: &impl Domain,
    position: &[[f64; 2]],
    surface: &mut [f64],
    coral: &mut [f64],
    level: f64,
    slope: f64,
) -> Slipped {
    let status = domain.status();
    let mut slipped = Slipped::default();
    // What slips from a node: on to which, and the height of its excess.
    let excess = |surface: &[f64], coral: &[f64], i: usize| {
        let may = coral[i] > 0.0 && surface[i] <= level && status[i] == Status::Interior;
        if may { steepest(domain, position, surface, i, slope) } else { None }
    };
    let is_steep = parallel::map(surface.len(), |i| excess(surface, coral, i).is_some());
    let mut next: Vec<u32> = (0..surface.len()).filter(|&i| is_steep[i]).map(|i| i as u32).collect();
    // The round in which a node was visited, and for which it is listed.
    let (mut visited, mut listed) = (vec![0u8; surface.len()], vec![0u8; surface.len()]);
    for round in 1..=MOST_ROUNDS {
        let is_steep = |i: &u32| excess(surface, coral, *i as usize).is_some();
        let mut heap: BinaryHeap<_> =
            next.drain(..).filter(is_steep).map(|i| (ordered_bits(surface[i as usize]), Reverse(i))).collect();
        while let Some((_, Reverse(at))) = heap.pop() {
            let i = at as usize;
            if visited[i] == round {
                continue;
            }
            let Some((to, excess)) = excess(surface, coral, i) else { continue };
            visited[i] = round;
            let own = domain.area(i);
            let other: f64 = to.iter().map(|(j, share)| share * domain.area(*j)).sum();
            let height = (excess * other / (own + other)).min(coral[i]);
            surface[i] -= height;
            coral[i] -= height;
            slipped.eroded += height * own;
            for (j, share) in to.into_iter().filter(|t| t.1 > 0.0) {
                let volume = share * height * own;
                if status[j] == Status::BaseLevel {
                    slipped.exported += volume;
                } else {
                    surface[j] += volume / domain.area(j);
                    coral[j] += volume / domain.area(j);
                    slipped.deposited += volume;
                    heap.push((ordered_bits(surface[j]), Reverse(j as u32)));
                }
            }
            // The node itself, and what stands above and has lost its foot.
            let above = domain.neighbours(i).map(|l| l.to).filter(|&j| surface[j] > surface[i] && coral[j] > 0.0);
            for j in above.chain([i]) {
                if listed[j] != round {
                    listed[j] = round;
                    next.push(j as u32);
                }
            }
        }
        if next.is_empty() {
            break;
        }
    }
    slipped
}

/// One or two neighbours, with shares.
type Foot = [(usize, f64); 2];

/// The neighbours on to which a node slips that is steeper than a slope, and the height of the
/// excess (m).
fn steepest(domain: &impl Domain, position: &[[f64; 2]], surface: &[f64], i: usize, slope: f64) -> Option<(Foot, f64)> {
    let mut most = (STAYS, None);
    let mut take = |excess: f64, to: Foot| {
        if excess > most.0 {
            most = (excess, Some(to));
        }
    };
    let (mut first, mut before): (Option<usize>, Option<usize>) = (None, None);
    for link in domain.neighbours(i) {
        take(surface[i] - surface[link.to] - slope * link.distance, [(link.to, 1.0), (link.to, 0.0)]);
        if let Some(before) = before {
            plane(position, surface, [i, before, link.to], slope, &mut take);
        }
        (first, before) = (first.or(Some(link.to)), Some(link.to));
    }
    if let (Some(first), Some(last)) = (first, before) {
        plane(position, surface, [i, last, first], slope, &mut take);
    }
    most.1.map(|to| (to, most.0))
}

/// What stands out of the steepest plane through a node and two neighbours side by side, if it
/// falls between them.
fn plane(position: &[[f64; 2]], z: &[f64], [i, a, b]: [usize; 3], slope: f64, take: &mut impl FnMut(f64, Foot)) {
    // Ground that falls to neither is no slope.
    if !(z[i] > z[a] && z[i] > z[b]) {
        return;
    }
    let to = |j: usize| [0, 1].map(|k| position[j][k] - position[i][k]);
    let dot = |p: [f64; 2], q: [f64; 2]| p[0] * q[0] + p[1] * q[1];
    let (u, v) = (to(a), to(b));
    let turn = u[0] * v[1] - u[1] * v[0];
    if turn.abs() < 1e-6 * dot(u, u) || dot(u, v) < 0.0 {
        return;
    }
    // The gradient of the plane through heights over these two places.
    let gradient = |p: f64, q: f64| [(p * v[1] - q * u[1]) / turn, (q * u[0] - p * v[0]) / turn];
    let now = gradient(z[a] - z[i], z[b] - z[i]);
    let parts = [(now[1] * v[0] - now[0] * v[1]) / turn, (now[0] * u[1] - now[1] * u[0]) / turn];
    if !(dot(now, now) > slope * slope && parts[0] > 0.0 && parts[1] > 0.0) {
        return;
    }
    // Lowered by h the node changes it by h times this: the least h at which it has the slope.
    let change = gradient(1.0, 1.0);
    let (square, both) = (dot(change, change), dot(change, now));
    let left = both * both - square * (dot(now, now) - slope * slope);
    if left > 0.0 {
        let height = (-both - left.sqrt()) / square;
        let (one, two) = (parts[0] * dot(u, u).sqrt(), parts[1] * dot(v, v).sqrt());
        take(height, [(a, one / (one + two)), (b, two / (one + two))]);
    }
}

#[cfg(test)]
mod tests {
    use landform_core::grid::{Edge, Edges, Grid, Neighbours, RasterDomain, Shape};

    use super::*;

    #[test]
    fn a_cliff_of_coral_comes_to_rest_at_its_angle_and_rock_stands() {
        let mut grid = Grid::new(Shape::new(3, 60), [10.0; 2]).unwrap();
        grid.edges = Edges::all(Edge::Closed);
        let domain = RasterDomain::new(&grid, &[]);
        let col = |i: usize| i % 60;
        // A wall of 100 m: coral from column 10 to 29, rock before it.
        let mut z: Vec<f64> = (0..180).map(|i| if col(i) < 30 { -1.0 } else { -101.0 }).collect();
        let mut coral: Vec<f64> = (0..180).map(|i| if (10..30).contains(&col(i)) { 100.0 } else { 0.0 }).collect();
        let before: f64 = z.iter().sum();
        let position: Vec<[f64; 2]> = (0..180).map(|i| grid.position(i)).collect();
        let mut slipped = Slipped::default();
        for _ in 0..400 {
            let more = slip(&domain, &position, &mut z, &mut coral, 0.0, 0.8);
            slipped.eroded += more.eroded;
            slipped.deposited += more.deposited;
        }
        assert!((z.iter().sum::<f64>() - before).abs() < 1e-9 * before.abs());
        assert!((slipped.eroded - slipped.deposited).abs() < 1e-9 * slipped.eroded && slipped.eroded > 1e4);
        let fall = |i: usize| (z[i] - z[i + 1]) / 10.0;
        let steepest = (60..119).map(fall).fold(0.0, f64::max);
        assert!((steepest - 0.8).abs() < 0.01, "{steepest}");
        assert!((60..70).all(|i| z[i] == -1.0));
        // Above the water nothing slips.
        let mut steep = [10.0, 0.0, 0.0].repeat(60);
        assert_eq!(slip(&domain, &position, &mut steep, &mut [5.0; 180], -20.0, 0.8), Slipped::default());
    }

    #[test]
    fn a_heap_of_coral_becomes_a_round_cone() {
        let mut grid = Grid::new(Shape::new(81, 81), [10.0; 2]).unwrap();
        grid.edges = Edges::all(Edge::Closed);
        let domain = RasterDomain::new(&grid, &[]);
        let position: Vec<[f64; 2]> = (0..grid.len()).map(|i| grid.position(i)).collect();
        let radius = |i: usize| {
            ((position[i][0] - 400.0) * (position[i][0] - 400.0) + (position[i][1] - 400.0) * (position[i][1] - 400.0))
                .sqrt()
        };
        let mut coral: Vec<f64> = (0..grid.len()).map(|i| if radius(i) < 150.0 { 150.0 } else { 0.0 }).collect();
        let mut z: Vec<f64> = coral.iter().map(|c| c - 200.0).collect();
        for _ in 0..300 {
            slip(&domain, &position, &mut z, &mut coral, 0.0, 0.8);
        }
        // The foot is as far from the middle in all directions: within two cells.
        let is_foot = |i: usize| coral[i] > 2.0 && domain.neighbours(i).any(|l| coral[l.to] <= 2.0);
        let feet: Vec<f64> = (0..grid.len()).filter(|&i| is_foot(i)).map(radius).collect();
        let (near, far) = feet.iter().fold((f64::MAX, 0.0), |(a, b): (f64, f64), &r| (a.min(r), b.max(r)));
        assert!(feet.len() > 40 && far - near < 20.0, "{near} {far}");
    }
}
