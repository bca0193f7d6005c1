use super::*;
use crate::algo::depression::flood_levels;
use crate::algo::sampling::poisson_disk;
use crate::grid::{Edge, Edges, Grid, Neighbours, RasterDomain, Shape, Status};
use crate::random::Seed;
use crate::terrain::{Mesh, NodeSurface};

fn rough(n: usize, seed: u64) -> Vec<f64> {
    (0..n).map(|i| 100.0 * Seed(seed).uniform(i as u64)).collect()
}

/// Small whole numbers: full of flats and ties.
fn terraced(n: usize, seed: u64) -> Vec<f64> {
    rough(n, seed).iter().map(|z| (z / 12.0).floor()).collect()
}

fn raster(rows: usize, cols: usize, edges: Edges) -> RasterDomain {
    let mut grid = Grid::new(Shape::new(rows, cols), [10.0, 10.0]).unwrap();
    grid.edges = edges;
    RasterDomain::new(&grid, &[])
}

fn check<D: Domain>(domain: &D, z: &[f64]) {
    check_by(Descent::Steepest, domain, z);
    check_by(Descent::Lowest, domain, z);
}

fn check_by<D: Domain>(descent: Descent, domain: &D, z: &[f64]) {
    let mut flow = Flow::by(descent);
    let mut area = node_areas(domain);
    let total: f64 = area.iter().sum();
    flow.route(domain, z, &mut area);
    let mut place = vec![usize::MAX; z.len()];
    for (k, &i) in flow.order().iter().enumerate() {
        place[i as usize] = k;
    }
    let mut at_outlets = 0.0;
    for i in 0..z.len() {
        let r = flow.receivers()[i] as usize;
        if r == i {
            assert_ne!(domain.status()[i], crate::grid::Status::Interior, "node {i} ends inside");
            at_outlets += area[i];
        } else {
            assert_eq!(domain.neighbour(i, flow.slots()[i]), r);
            assert!(place[i] < place[r], "donors come first, so there is no cycle");
        }
    }
    assert!((at_outlets / total - 1.0).abs() < 1e-12);
    let mut shared = node_areas(domain);
    flow.accumulate_multiple(domain, z, 1.1, &mut shared);
    let out: f64 = (0..z.len()).filter(|&i| flow.receivers()[i] as usize == i).map(|i| shared[i]).sum();
    assert!((out / total - 1.0).abs() < 1e-9, "water shared among all ways down arrives: {out} of {total}");
    let (level, flood) = (flow.water_level(z), flood_levels(domain, z));
    for i in 0..z.len() {
        assert!(
            level[i] == flood[i] || (level[i].is_nan() && flood[i].is_nan()),
            "level at {i}: {} {}",
            level[i],
            flood[i]
        );
    }
}

#[test]
fn every_node_of_a_raster_drains_and_levels_equal_priority_flood() {
    for seed in 0..6 {
        for edges in [
            Edges::default(),
            Edges { north: Edge::Closed, east: Edge::Periodic, west: Edge::Periodic, south: Edge::Open },
        ] {
            let domain = raster(37, 53, edges);
            check(&domain, &rough(37 * 53, seed));
            check(&domain, &terraced(37 * 53, seed));
        }
    }
}

#[test]
fn every_node_of_a_mesh_drains_and_levels_equal_priority_flood() {
    for seed in 0..4 {
        let sites = poisson_disk([1000.0, 1000.0], 25.0, Seed(seed)).unwrap();
        let mesh = Mesh::delaunay(&sites, Edges { north: Edge::Closed, ..Edges::default() }).unwrap();
        check(mesh.graph(), &rough(sites.len(), seed));
        check(mesh.graph(), &terraced(sites.len(), seed));
    }
}

#[test]
fn holes_and_ragged_rims_drain_too() {
    let grid = Grid::new(Shape::new(40, 40), [10.0, 10.0]).unwrap();
    let mut z = rough(1600, 2);
    let valid: Vec<bool> = (0..1600).map(|i| Seed(8).uniform(i / 7) > 0.12).collect();
    for i in 0..1600 {
        if !valid[i] {
            z[i] = f64::NAN;
        }
    }
    let domain = RasterDomain::new(&grid, &valid);
    let mut flow = Flow::new();
    let mut area = node_areas(&domain);
    flow.route(&domain, &z, &mut area);
    for i in 0..1600 {
        let mut node = i;
        while flow.receivers()[node] as usize != node {
            node = flow.receivers()[node] as usize;
            assert!(valid[node]);
        }
    }
}

#[test]
fn a_hand_made_lake_spills_over_its_lowest_pass() {
    // One pit (1 m) in the middle; the rim is 5 m but for a notch of 3 m in the east.
    let domain = raster(5, 5, Edges::default());
    let mut z = vec![5.0; 25];
    for i in 0..25 {
        let cell = Shape::new(5, 5).cell(i);
        if cell.row == 0 || cell.col == 0 || cell.row == 4 || cell.col == 4 {
            z[i] = 0.0;
        }
    }
    (z[12], z[13]) = (1.0, 3.0);
    let mut flow = Flow::new();
    let mut area = vec![1.0; 25];
    flow.route(&domain, &z, &mut area);
    assert_eq!(flow.lakes(), 1);
    assert_eq!(flow.receivers()[12], 13);
    assert_eq!(flow.water_level(&z)[12], 3.0);
    assert_eq!(
        area.iter().zip(domain.status()).filter(|(_, s)| **s == Status::BaseLevel).map(|(a, _)| a).sum::<f64>(),
        25.0
    );
}

#[test]
fn a_closed_box_ends_in_its_own_pits() {
    let domain = raster(20, 20, Edges::all(Edge::Closed));
    let mut flow = Flow::new();
    let mut area = node_areas(&domain);
    flow.route(&domain, &rough(400, 1), &mut area);
    let ends: Vec<usize> = (0..400).filter(|&i| flow.receivers()[i] as usize == i).collect();
    assert_eq!(ends.len(), 1);
    assert_eq!(area[ends[0]], 400.0 * 100.0);
}

#[test]
fn degenerate_domains_are_routed() {
    for (rows, cols) in [(1, 1), (1, 7), (7, 1), (2, 2), (3, 3)] {
        check(&raster(rows, cols, Edges::default()), &rough(rows * cols, 3));
    }
    let mut flow = Flow::new();
    let mut area = vec![1.0];
    flow.route(&raster(1, 1, Edges::all(Edge::Closed)), &[0.0], &mut area);
    assert_eq!(flow.receivers(), [0]);
}

#[test]
fn threads_do_not_change_a_bit() {
    let domain = raster(300, 301, Edges::default());
    let z = rough(300 * 301, 4);
    let run = |threads| {
        crate::parallel::with_threads(threads, || {
            let mut flow = Flow::new();
            let mut area = node_areas(&domain);
            flow.route(&domain, &z, &mut area);
            (flow.receivers().to_vec(), flow.order().to_vec(), area)
        })
        .unwrap()
    };
    assert_eq!(run(1), run(3));
}

#[test]
fn the_numbering_of_sites_does_not_change_a_bit() {
    let sites = poisson_disk([800.0, 800.0], 20.0, Seed(5)).unwrap();
    let run = |sites: &[[f64; 2]]| {
        let mesh = Mesh::delaunay(sites, Edges::default()).unwrap();
        let z: Vec<f64> =
            mesh.positions().iter().map(|p| Seed((p[0] * 1e6) as u64).uniform((p[1] * 1e6) as u64)).collect();
        let mut flow = Flow::new();
        let mut area = node_areas(&*mesh.domain());
        flow.route(mesh.graph(), &z, &mut area);
        area
    };
    let mut reversed = sites.clone();
    reversed.reverse();
    assert_eq!(run(&sites), run(&reversed));
}

#[test]
fn basins_are_numbered_from_one() {
    let domain = raster(12, 12, Edges::default());
    let z = rough(144, 7);
    let mut flow = Flow::new();
    flow.route(&domain, &z, &mut [1.0; 144]);
    let basins = flow.basins(domain.status());
    assert_eq!(basins.iter().max(), Some(&44), "one basin per border node");
    assert!(basins.iter().all(|&b| b > 0));
}

#[test]
fn water_on_a_cone_spreads_evenly_and_not_along_eight_rays() {
    // On a cone the drainage area per width is r/2 in every direction.
    let n = 101;
    let domain = raster(n, n, Edges::default());
    let at = |i: usize| ((i % n) as f64 - 50.0, (i / n) as f64 - 50.0);
    let z: Vec<f64> =
        (0..n * n).map(|i| -10.0 * (crate::math::powi(at(i).0, 2) + crate::math::powi(at(i).1, 2)).sqrt()).collect();
    let (mut flow, mut single) = (Flow::new(), node_areas(&domain));
    flow.route(&domain, &z, &mut single);
    let mut shared = node_areas(&domain);
    flow.accumulate_multiple(&domain, &z, 1.1, &mut shared);
    let spread = |area: &[f64]| {
        let ring: Vec<f64> = (0..n * n)
            .filter(|&i| ((crate::math::powi(at(i).0, 2) + crate::math::powi(at(i).1, 2)).sqrt() - 40.0).abs() < 1.0)
            .map(|i| area[i])
            .collect();
        let mean = ring.iter().sum::<f64>() / ring.len() as f64;
        (ring.iter().map(|a| crate::math::powi(a - mean, 2)).sum::<f64>() / ring.len() as f64).sqrt() / mean
    };
    let (one, all) = (spread(&single), spread(&shared));
    assert!(all < 0.4 && one > 2.0 * all, "single {one}, multiple {all}");
}

/// Specific drainage area by D-infinity of a surface on cells of 1 m with open border.
fn infinity_area(n: usize, sink: bool, surface: impl Fn(f64, f64) -> f64) -> Vec<f64> {
    let grid = Grid::new(Shape::new(n, n), [1.0, 1.0]).unwrap();
    let mut domain = RasterDomain::new(&grid, &[]);
    if sink {
        let mut status = domain.status().to_vec();
        status[n * n / 2] = Status::BaseLevel;
        domain.set_status(status);
    }
    let middle = (n / 2) as f64;
    let z: Vec<f64> = (0..n * n).map(|i| grid.position(i)).map(|[x, y]| surface(x - middle, y - middle)).collect();
    let (mut flow, mut area) = (Flow::new(), node_areas(&domain));
    flow.route(&domain, &z, &mut area);
    let mut area = node_areas(&domain);
    flow.accumulate_infinity(&domain, &grid, &z, &mut area);
    area
}

#[test]
fn infinity_spreads_a_cone_as_it_should() {
    // Validation notes 2.14: outward a = r/2, inward a = (R² − r²)/(2 r).
    let n = 201;
    let r = |i: usize| crate::math::hypot((i % n) as f64 - 100.0, (i / n) as f64 - 100.0);
    let outward = infinity_area(n, false, |x, y| -crate::math::hypot(x, y));
    let inward = infinity_area(n, true, |x, y| {
        let r = crate::math::hypot(x, y);
        if r <= 95.0 { r } else { 190.0 - r }
    });
    // A cell shows the flow the width of its larger step: water at an angle crosses one column (or
    // row) at a time.
    let width = |i: usize| {
        let (x, y) = ((i % n) as f64 - 100.0, (i / n) as f64 - 100.0);
        x.abs().max(y.abs()) / crate::math::hypot(x, y)
    };
    let error = |area: &[f64], ring: std::ops::Range<f64>, expected: &dyn Fn(f64) -> f64| {
        let all: Vec<f64> =
            (0..n * n).filter(|&i| ring.contains(&r(i))).map(|i| area[i] / width(i) / expected(r(i)) - 1.0).collect();
        let mean = all.iter().sum::<f64>() / all.len() as f64;
        let mut amounts: Vec<f64> = all.iter().map(|e| e.abs()).collect();
        amounts.sort_by(f64::total_cmp);
        (mean, amounts[amounts.len() / 2])
    };
    let (mean, spread) = error(&outward, 40.0..90.0, &|r| r / 2.0);
    // Single nodes keep what the discrete tip gave them.
    assert!(mean.abs() < 0.01 && spread < 0.1, "outward {mean} {spread}");
    let (mean, spread) = error(&inward, 30.0..80.0, &|r| (95.0 * 95.0 - r * r) / (2.0 * r));
    assert!(mean.abs() < 0.03 && spread < 0.1, "inward {mean} {spread}");
}

#[test]
fn infinity_on_a_plane_counts_the_way_to_the_ridge() {
    // A roof whose ridge runs through the middle at any azimuth: a = distance to the ridge.
    for azimuth in [0.0_f64, 0.3, 0.6, 0.785, 1.2] {
        let (c, s) = (crate::math::cos(azimuth), crate::math::sin(azimuth));
        let n = 301;
        let area = infinity_area(n, false, |x, y| -(c * x + s * y).abs());
        let mut errors = Vec::new();
        for i in 0..n * n {
            let (x, y) = ((i % n) as f64 - 150.0, 150.0 - (i / n) as f64);
            let (across, along) = (c * x + s * y, -s * x + c * y);
            if across > 40.0 && across < 90.0 && along.abs() < 50.0 {
                errors.push(area[i] / (across * c.abs().max(s.abs())) - 1.0);
            }
        }
        let mean = errors.iter().sum::<f64>() / errors.len() as f64;
        let worst = errors.iter().fold(0.0_f64, |m, e| m.max((e - mean).abs()));
        assert!(mean.abs() < 0.03 && worst < 0.06, "{azimuth}: {mean} {worst}");
    }
}

#[test]
fn level_ground_gathers_its_water_in_the_middle() {
    // A level valley floor between two slopes, open at one end: away from the slopes, then out.
    let (rows, cols) = (41, 21);
    let z: Vec<f64> = (0..rows * cols).map(|i| ((i % cols) as f64 - 10.0).abs().max(5.0)).collect();
    let mut domain = raster(rows, cols, Edges::all(Edge::Closed));
    let mut status = vec![Status::Interior; z.len()];
    status[40 * cols + 5..40 * cols + 16].fill(Status::BaseLevel);
    domain.set_status(status);
    let mut flow = Flow::new();
    let mut area = vec![1.0; z.len()];
    flow.route(&domain, &z, &mut area);
    // Most of what falls above has come together on the axis.
    let greatest = (0..cols).max_by(|&a, &b| area[30 * cols + a].total_cmp(&area[30 * cols + b])).unwrap();
    assert!((9..=11).contains(&greatest), "{greatest}");
    assert!(area[30 * cols + greatest] > 0.7 * (31 * cols) as f64, "{}", area[30 * cols + greatest]);
    assert_eq!(flow.lakes(), 0);
}

#[test]
fn a_level_floor_of_a_pit_has_its_pit_in_the_middle() {
    let n = 15;
    let z: Vec<f64> =
        (0..n * n).map(|i| ((i % n) as f64 - 7.0).abs().max(((i / n) as f64 - 7.0).abs()).max(3.0)).collect();
    let domain = raster(n, n, Edges::all(Edge::Closed));
    let mut flow = Flow::new();
    let mut area = vec![1.0; z.len()];
    flow.route(&domain, &z, &mut area);
    assert_eq!(area[7 * n + 7], (n * n) as f64);
}

/// Routes in strips; receivers, levels, basins and sums.
fn in_strips<D: Domain>(domain: &D, z: &[f64], strips: usize) -> (Vec<u32>, Vec<f64>, Vec<u32>, [Vec<f64>; 2]) {
    let mut flow = Flow::new().in_strips(strips);
    // Areas whose sums differ by the order in which they are taken.
    let mut amount: Vec<f64> = (0..z.len()).map(|i| 1.0 + Seed(9).uniform(i as u64)).collect();
    let own = amount.clone();
    flow.route(domain, z, &mut amount);
    let mut again = own;
    flow.down(domain, &mut again, |a, b| a + b, |_, v| v);
    let alike = |a: f64, b: f64| (a - b).abs() <= 1e-12 * b;
    assert!((0..z.len()).all(|i| alike(again[i], amount[i])), "{strips} strips");
    let mut place = vec![0; z.len()];
    flow.order().iter().enumerate().for_each(|(k, &i)| place[i as usize] = k);
    let late = |i: usize| flow.receivers()[i] as usize == i || place[i] < place[flow.receivers()[i] as usize];
    assert!((0..z.len()).all(late), "{strips} strips: a receiver before its donor");
    (flow.receivers().to_vec(), flow.water_level(z), flow.basins(domain.status()), [amount, again])
}

#[test]
fn how_nodes_are_cut_into_strips_changes_no_bit() {
    let (rows, cols) = (67, 41);
    let n = rows * cols;
    let at = |i: usize| ((i / cols) as f64, (i % cols) as f64);
    let rough: Vec<f64> = (0..n).map(|i| 100.0 * Seed(3).uniform(i as u64)).collect();
    let plateaus: Vec<f64> = rough.iter().map(|z| (z / 20.0).floor()).collect();
    // A lake over three seams of five strips, and a river that weaves along the seam of two.
    let lake: Vec<f64> = (0..n)
        .map(|i| crate::math::powi(((at(i).0 - 33.0) / 30.0).abs().max((at(i).1 - 20.0).abs() / 18.0), 2))
        .collect();
    let weaving: Vec<f64> = (0..n)
        .map(|i| {
            let (r, c) = at(i);
            (r - 33.5 - 2.5 * crate::math::sin(c)).abs() + 0.01 * (40.0 - c) + 0.3 * Seed(4).uniform(i as u64)
        })
        .collect();
    let mut holes = rough.clone();
    (0..cols).for_each(|c| holes[33 * cols + c] = if c % 7 < 3 { f64::NAN } else { -5.0 });
    for (name, z) in [
        ("rough", rough),
        ("plateaus", plateaus),
        ("flat", vec![2.0; n]),
        ("lake", lake),
        ("weaving", weaving),
        ("holes", holes),
    ] {
        let half_open = Edges { north: Edge::Closed, east: Edge::Closed, ..Edges::default() };
        // The holes cut a closed ground in two; each part ends in a pit of its own.
        for edges in [half_open, Edges::all(Edge::Closed)] {
            let mut grid = Grid::new(Shape::new(rows, cols), [30.0, 30.0]).unwrap();
            grid.edges = edges;
            let valid: Vec<bool> = z.iter().map(|v| !v.is_nan()).collect();
            let domain = RasterDomain::new(&grid, &valid);
            let whole = in_strips(&domain, &z, 1);
            for strips in [2, 3, 5, 8] {
                let cut = in_strips(&domain, &z, strips);
                assert!(cut.0 == whole.0, "{name}, {strips} strips: receivers");
                assert!(cut.2 == whole.2 && cut.3 == whole.3, "{name}, {strips} strips: basins or sums");
                assert!(cut.1.iter().zip(&whole.1).all(|(a, b)| a.to_bits() == b.to_bits()), "{name}: levels");
            }
        }
    }
    let sites = crate::algo::sampling::poisson_disk([1000.0, 700.0], 12.0, Seed(5)).unwrap();
    let mesh = crate::terrain::Mesh::delaunay(&sites, Edges::default()).unwrap();
    let z: Vec<f64> = (0..mesh.graph().len()).map(|i| Seed(6).uniform(i as u64)).collect();
    let whole = in_strips(mesh.graph(), &z, 1);
    for strips in [2, 3, 5, 8] {
        assert!(in_strips(mesh.graph(), &z, strips) == whole, "mesh, {strips} strips");
    }
}
