use landform_core::algo::depression::flood_levels;
use landform_core::grid::{Domain, Edge, Edges, Grid, Jitter, Neighbours, RasterDomain, Shape, Status};
use landform_core::math;
use landform_core::random::Seed;

use super::*;

const RULES: [Rule; 3] = [Rule::Columns { depth: 1.0 }, Rule::Average, Rule::Weighted];

fn ground(edge: Edge, rows: usize, cols: usize, f: impl Fn(f64, f64) -> f64) -> (RasterDomain, Vec<f64>) {
    let mut grid = Grid::new(Shape::new(rows, cols), [10.0; 2]).unwrap();
    grid.edges = Edges::all(edge);
    let z = (0..grid.len()).map(|i| f((i % cols) as f64, (i / cols) as f64)).collect();
    (RasterDomain::new(&grid, &[]), z)
}

fn rain(depth: &[f64]) -> Supply<'_> {
    Supply { depth, total: depth.iter().sum(), evaporation: 0.0, sinks: &[] }
}

fn rough(x: f64, y: f64) -> f64 {
    10.0 * Seed(3).uniform((y * 1000.0 + x) as u64) + 5.0 * math::sin(x / 5.0) * math::cos(y / 6.0)
}

#[test]
fn a_tilted_plane_sheds_all_its_rain() {
    for rule in RULES {
        let (domain, z) = ground(Edge::Open, 30, 40, |x, y| 2.0 * x + 0.3 * y);
        let mut water = vec![0.0; z.len()];
        let ledger = Sweep::new(rule).round(&domain, &z, &rain(&vec![0.5; z.len()]), &mut water);
        assert!(ledger.stored == 0.0 && ledger.imbalance() < 1e-12, "{ledger:?}");
    }
}

#[test]
fn water_is_conserved_round_by_round() {
    // WC1, with evaporation and on rough ground.
    for rule in RULES {
        let (domain, z) = ground(Edge::Open, 60, 70, rough);
        let (mut water, mut sweep) = (vec![0.0; z.len()], Sweep::new(rule));
        let depth = vec![0.3; z.len()];
        for _ in 0..12 {
            let ledger = sweep.round(&domain, &z, &Supply { evaporation: 0.1, ..rain(&depth) }, &mut water);
            assert!(ledger.imbalance() < 1e-12, "{ledger:?}");
        }
        assert!(water.iter().sum::<f64>() > 0.0);
    }
}

#[test]
fn level_ground_keeps_its_water() {
    // Terraces: every node has equals beside it.
    for rule in RULES {
        let (domain, z) = ground(Edge::Open, 60, 70, |x, y| (0.4 * rough(x, y)).floor() + 5.0 * (x / 9.0).floor());
        let level = flood_levels(&domain, &z);
        let (mut water, mut sweep) = (vec![0.0; z.len()], Sweep::new(rule));
        for _ in 0..30 {
            let ledger = sweep.round(&domain, &z, &rain(&vec![1.0; z.len()]), &mut water);
            assert!(ledger.imbalance() < 1e-12, "{ledger:?}");
        }
        let wrong = (0..z.len()).filter(|&i| (z[i] + water[i] - level[i]).abs() > 3e-7).count();
        assert_eq!(wrong, 0, "{rule:?}");
        let even = flood_levels(&domain, sweep.ran_over());
        let wrong = (0..z.len()).filter(|&i| (sweep.ran_over()[i] + water[i] - even[i]).abs() > 1e-9).count();
        assert_eq!(wrong, 0, "{rule:?}");
    }
}

#[test]
fn hollows_fill_to_the_level_of_priority_flood() {
    // WC5: with enough rain every hollow stands at its lowest pass, whatever the rule and in
    // however many rounds.
    let (domain, z) = ground(Edge::Open, 60, 70, rough);
    let level = flood_levels(&domain, &z);
    for (rule, rounds) in RULES.into_iter().flat_map(|r| [(r, 1), (r, 7)]) {
        let (mut water, mut sweep) = (vec![0.0; z.len()], Sweep::new(rule));
        let depth = vec![40.0 / f64::from(rounds); z.len()];
        for _ in 0..rounds {
            sweep.round(&domain, &z, &rain(&depth), &mut water);
        }
        let worst = (0..z.len()).map(|i| (z[i] + water[i] - level[i]).abs()).fold(0.0, f64::max);
        let wrong = (0..z.len()).filter(|&i| (z[i] + water[i] - level[i]).abs() > 3e-7).count();
        assert_eq!(wrong, 0, "{rule:?} in {rounds}: {worst}");
        let even = flood_levels(&domain, sweep.ran_over());
        let wrong = (0..z.len()).filter(|&i| (sweep.ran_over()[i] + water[i] - even[i]).abs() > 1e-9).count();
        assert_eq!(wrong, 0, "{rule:?} in {rounds}");
    }
}

#[test]
fn a_paraboloid_holds_the_water_that_its_volume_says() {
    // WC2: V = pi l^2 R^2 / 2 for level l in z = l r^2 / R^2.
    let (domain, z) =
        ground(Edge::Closed, 201, 201, |x, y| 0.01 * (math::pow(x - 100.0, 2.0) + math::pow(y - 100.0, 2.0)));
    for rule in RULES {
        let mut water = vec![0.0; z.len()];
        let volume = 20_000.0;
        let depth = vec![volume / z.len() as f64; z.len()];
        Sweep::new(rule).round(&domain, &z, &rain(&depth), &mut water);
        // In cells: z = 0.01 r^2, so l = sqrt(2 V 0.01 / pi).
        let expected = (2.0 * volume * 0.01 / std::f64::consts::PI).sqrt();
        let wet: Vec<f64> = (0..z.len()).filter(|&i| water[i] > 0.0).map(|i| z[i] + water[i]).collect();
        let (lo, hi) = wet.iter().fold((f64::MAX, f64::MIN), |(a, b), &h| (a.min(h), b.max(h)));
        assert!(hi - lo < 1e-6 && (hi / expected - 1.0).abs() < 2e-3, "{lo} {hi} {expected}");
    }
}

#[test]
fn two_bowls_in_a_row_fill_one_after_the_other() {
    // A valley along x with a sill at 20 and an exit on the east at 40.
    let bed = |x: f64, y: f64| {
        let floor: f64 = if x < 20.0 { 10.0 + (x - 10.0).abs() * 0.3 } else { 5.0 + (x - 30.0).abs() * 0.4 };
        floor + 4.0 * (y - 5.0).abs()
    };
    let (domain, z) = ground(Edge::Open, 11, 41, bed);
    let spring = 5 * 41 + 8;
    let mut depth = vec![0.0; z.len()];
    depth[spring] = 2.0;
    let (mut water, mut sweep) = (vec![0.0; z.len()], Sweep::new(RULES[0]));
    let (mut first, mut second, mut out) = (None, None, None);
    for round in 0..60 {
        let ledger = sweep.round(&domain, &z, &rain(&depth), &mut water);
        assert!(ledger.imbalance() < 1e-12);
        let is_wet = |x: usize| water[5 * 41 + x] > 0.0;
        first = first.or((is_wet(10)).then_some(round));
        second = second.or((is_wet(30)).then_some(round));
        out = out.or((ledger.left > 0.0).then_some(round));
    }
    assert!(first < second && second < out && out.is_some(), "{first:?} {second:?} {out:?}");
    // Full, they pass all.
    let ledger = sweep.round(&domain, &z, &rain(&depth), &mut water);
    assert!((ledger.left / 2.0 - 1.0).abs() < 1e-9);
}

#[test]
fn what_passes_adds_up_to_drainage_area_where_water_takes_one_way() {
    let (domain, z) = ground(Edge::Open, 40, 40, |x, y| rough(x, y) + 3.0 * x);
    let mut flow = landform_core::algo::flow::Flow::new();
    let mut area = landform_core::algo::flow::node_areas(&domain);
    flow.route(&domain, &z, &mut area);
    let depth = vec![1.0; z.len()];
    let mut sweep = Sweep::new(Rule::Columns { depth: 1e-9 });
    let mut water = vec![0.0; z.len()];
    for _ in 0..60 {
        sweep.round(&domain, &z, &rain(&depth), &mut water);
    }
    // All that rains inside leaves over the border, in either.
    let out = |amount: &dyn Fn(usize) -> f64| {
        (0..z.len()).filter(|&i| domain.status()[i] != Status::Interior).map(amount).sum::<f64>()
    };
    let (a, b) = (out(&|i| sweep.passed()[i]), out(&|i| area[i] / 100.0));
    assert!((a / b - 1.0).abs() < 1e-6, "{a} {b}");
}

#[test]
fn a_broken_dam_runs_at_twice_the_speed_of_its_wave() {
    // WC11 (Ritter): the front on a dry bed without friction runs at 2 sqrt(g h0); where it is h
    // deep, 3 sqrt(g h) slower.
    let (domain, z) = ground(Edge::Closed, 3, 2000, |_, _| 0.0);
    let (h0, dx) = (1.0, 10.0);
    let mut water: Vec<f64> = (0..z.len()).map(|i| if i % 2000 < 1000 { h0 } else { 0.0 }).collect();
    let none = vec![0.0; z.len()];
    let mut pipes = Pipes::new(z.len(), [dx; 2], 0.0);
    let front = |water: &[f64]| (0..2000).rfind(|&c| water[2000 + c] > 1e-3 * h0).unwrap_or(0) as f64 * dx;
    let (mut time, mut mark) = (0.0, None);
    while time < 1200.0 {
        let dt = pipes.max_step(&water).min(0.5);
        let before: f64 = water.iter().sum();
        pipes.step(&domain, &z, (&rain(&none), &[]), dt, &mut water);
        assert!((water.iter().sum::<f64>() / before - 1.0).abs() < 1e-12, "WC1");
        time += dt;
        if mark.is_none() && time > 300.0 {
            mark = Some((time, front(&water)));
        }
    }
    let (t0, x0) = mark.unwrap();
    let speed = (front(&water) - x0) / (time - t0);
    let expected = 2.0 * (9.81f64 * h0).sqrt() - 3.0 * (9.81f64 * 1e-3 * h0).sqrt();
    assert!((speed / expected - 1.0).abs() < 0.1, "{speed} {expected}");
}

#[test]
fn water_in_pipes_comes_to_rest_level() {
    // WC2 with friction: a closed bowl; all transports agree on the level.
    let (domain, z) = ground(Edge::Closed, 21, 21, |x, y| 0.04 * (math::pow(x - 10.0, 2.0) + math::pow(y - 10.0, 2.0)));
    let depth = vec![0.5; z.len()];
    let mut expected = vec![0.0; z.len()];
    Sweep::new(RULES[0]).round(&domain, &z, &rain(&depth), &mut expected);
    let (mut pipes, mut water, none) = (Pipes::new(z.len(), [10.0; 2], 0.05), depth, vec![0.0; z.len()]);
    for _ in 0..20_000 {
        let dt = pipes.max_step(&water);
        pipes.step(&domain, &z, (&rain(&none), &[]), dt, &mut water);
    }
    let wet: Vec<f64> = (0..z.len()).filter(|&i| water[i] > 5e-3).map(|i| z[i] + water[i]).collect();
    let (lo, hi) = wet.iter().fold((f64::MAX, f64::MIN), |(a, b), &h| (a.min(h), b.max(h)));
    let level = (0..z.len()).filter(|&i| expected[i] > 0.0).map(|i| z[i] + expected[i]).fold(0.0, f64::max);
    // Not the 1e-6 of a level pool: it goes on sloshing, less and less, as friction falls with the
    // square of the speed.
    assert!(hi - lo < 5e-4 && (hi - level).abs() < 5e-4, "{lo} {hi} {level}");
}

#[test]
fn rivers_keep_their_water_across_level_ground() {
    // A slope, a level terrace with a hollow in it, a slope: what came from above crosses every
    // row, whichever way.
    let n = 40;
    let (domain, z) = ground(Edge::Open, n, n, |x, y| {
        let noise = 0.3 * Seed(3).uniform((y * 99.0 + x) as u64);
        match y {
            y if y < 12.0 => 40.0 - y + noise,
            y if y < 28.0 => 20.0 - if math::hypot(x - 20.0, y - 20.0) < 4.0 { 2.0 } else { 0.0 },
            y => 40.0 - y + noise,
        }
    });
    let depth: Vec<f64> =
        (0..n * n).map(|i| if i / n < 10 && i % n > 0 && i % n < n - 1 { 1.0 } else { 0.0 }).collect();
    let mut standing = vec![0.0; n * n];
    let mut sweep = Sweep::new(RULES[0]);
    for _ in 0..5 {
        sweep.round(&domain, &z, &rain(&depth), &mut standing);
    }
    let crosses = |row: usize| (0..n).map(|c| sweep.passed()[row * n + c]).sum::<f64>();
    let through: f64 = (0..n).map(|c| sweep.passed()[c + n * 11]).sum();
    // Some leaves by the open sides on the way.
    for row in 12..27 {
        let sides: f64 = (12..=row).map(|r| sweep.passed()[r * n] + sweep.passed()[r * n + n - 1]).sum();
        assert!(crosses(row) + sides > 0.98 * through, "row {row}: {} and {sides} of {through}", crosses(row));
    }
}

#[test]
fn a_full_lake_passes_on_what_comes_in_and_no_more() {
    // Fifty rounds of little water over a deep bowl above an open side: what stands in it is no
    // flow.
    let (domain, z) = ground(Edge::Open, 31, 31, |x, y| {
        let r = math::hypot(x - 15.0, y - 12.0);
        60.0 - y - 30.0 * (1.0 - r / 8.0).max(0.0)
    });
    let depth = vec![1.0; z.len()];
    let mut standing = vec![0.0; z.len()];
    let mut sweep = Sweep::new(RULES[0]);
    let mut ledger = Ledger::default();
    for _ in 0..50 {
        ledger = sweep.round(&domain, &z, &rain(&depth), &mut standing);
    }
    assert!((ledger.stored - ledger.before).abs() < 1e-9 * ledger.stored && ledger.stored > 500.0);
    let greatest = sweep.passed().iter().copied().fold(0.0, f64::max);
    assert!(greatest < 0.7 * 961.0, "{greatest} of 961 passes the busiest node; {} stands", ledger.stored);
}

#[test]
fn strips_of_pipes_join_without_a_seam() {
    // Ground and its transpose, higher than one strip: the same water, whichever side strips are
    // cut along; a wall in between.
    let (rows, cols) = (75, 53);
    let f = |x: f64, y: f64| if (x, y) == (20.0, 33.0) { f64::NAN } else { rough(x, y) };
    let run = |rows: usize, cols: usize, f: &dyn Fn(f64, f64) -> f64| {
        let (domain, z) = ground(Edge::Closed, rows, cols, f);
        let mut water: Vec<f64> = z.iter().map(|h| if h.is_nan() { 0.0 } else { 1.0 }).collect();
        let (mut pipes, none) = (Pipes::new(z.len(), [10.0; 2], 0.03), vec![0.0; z.len()]);
        let before: f64 = water.iter().sum();
        for _ in 0..200 {
            let dt = pipes.max_step(&water);
            pipes.step(&domain, &z, (&rain(&none), &[]), dt, &mut water);
        }
        assert!((water.iter().sum::<f64>() / before - 1.0).abs() < 1e-12);
        water
    };
    let (a, b) = (run(rows, cols, &f), run(cols, rows, &|x, y| f(y, x)));
    let apart = (0..a.len()).map(|i| (a[i] - b[i % cols * rows + i / cols]).abs()).fold(0.0, f64::max);
    assert!(apart < 1e-9, "{apart}");
    assert!(a.iter().copied().fold(0.0, f64::max) > 3.0);
}

#[test]
fn water_crosses_a_plain_as_fast_towards_any_side() {
    // A level plain with a hill in a corner and its opposite side open: nodes are taken in the
    // order of their tilt, so that all that falls leaves, whichever way the plain is turned.
    let n = 60;
    for turned in [false, true] {
        let (_, z) = ground(Edge::Closed, n, n, |x, y| {
            let y = if turned { n as f64 - 1.0 - y } else { y };
            (1000.0 - 100.0 * math::hypot(x, y)).max(0.0)
        });
        let mut grid = Grid::new(Shape::new(n, n), [10.0; 2]).unwrap();
        let open = if turned {
            Edges { north: Edge::Open, ..Edges::all(Edge::Closed) }
        } else {
            Edges { south: Edge::Open, ..Edges::all(Edge::Closed) }
        };
        grid.edges = open;
        let domain = RasterDomain::new(&grid, &[]);
        for rule in RULES {
            let (depth, mut standing) = (vec![1.0; n * n], vec![0.0; n * n]);
            let ledger = Sweep::new(rule).round(&domain, &z, &rain(&depth), &mut standing);
            assert!(ledger.stored < 1e-9 && (ledger.left / (n * n) as f64 - 1.0).abs() < 1e-12, "{rule:?} {ledger:?}");
        }
    }
}

#[test]
fn pipes_in_a_single_column_or_row_run_too() {
    for (rows, cols) in [(1, 1), (1, 40), (40, 1), (2, 40), (40, 2)] {
        let (domain, z) = ground(Edge::Closed, rows, cols, |x, y| 0.1 * (x + y));
        let (mut water, none) = (vec![1.0; z.len()], vec![0.0; z.len()]);
        let mut pipes = Pipes::new(z.len(), [10.0; 2], 0.03);
        for _ in 0..50 {
            let dt = pipes.max_step(&water);
            pipes.step(&domain, &z, (&rain(&none), &[]), dt, &mut water);
        }
        assert!((water.iter().sum::<f64>() / z.len() as f64 - 1.0).abs() < 1e-12);
        assert!(z.len() == 1 || water[0] > 1.0, "it runs down");
    }
}

#[test]
fn every_node_is_taken_once_and_after_its_higher_neighbours() {
    // Strips, seams and holes.
    for (rows, cols) in [(1, 1), (1, 9), (9, 1), (2, 9), (9, 2), (3, 3), (13, 17)] {
        for (edge, hole) in [Edge::Open, Edge::Closed, Edge::Periodic].into_iter().flat_map(|e| [(e, false), (e, true)])
        {
            let mut grid = Grid::new(Shape::new(rows, cols), [10.0; 2]).unwrap();
            grid.edges = Edges::all(edge);
            let valid: Vec<bool> = (0..grid.len()).map(|i| !hole || i % 7 != 3).collect();
            let domain = RasterDomain::new(&grid, &valid);
            let z: Vec<f64> = (0..grid.len()).map(|i| rough((i % cols) as f64, (i / cols) as f64).floor()).collect();
            let depth: Vec<f64> = valid.iter().map(|&v| f64::from(u8::from(v))).collect();
            let (mut water, mut sweep) = (vec![0.0; z.len()], Sweep::new(RULES[0]));
            for _ in 0..3 {
                let ledger = sweep.round(&domain, &z, &rain(&depth), &mut water);
                assert!(ledger.imbalance() < 1e-12, "{rows} {cols} {edge:?} {hole} {ledger:?}");
            }
            let mut place = vec![usize::MAX; z.len()];
            for (k, i) in sweep.order().enumerate() {
                assert_eq!(std::mem::replace(&mut place[i], k), usize::MAX, "once");
            }
            let height = sweep.ran_over();
            for i in (0..z.len()).filter(|&i| valid[i]) {
                let late = domain.neighbours(i).any(|l| height[l.to] > height[i] && place[l.to] > place[i]);
                assert!(place[i] != usize::MAX && !late, "{rows} {cols} {edge:?} {hole}");
            }
        }
    }
}

/// A plane that falls by a tenth towards `angle` degrees east of south, sampled where nodes stand.
fn plane(angle: f64, jitter: bool) -> (Grid, RasterDomain, Vec<f64>) {
    let mut grid = Grid::new(Shape::new(121, 121), [10.0; 2]).unwrap();
    grid.jitter = jitter.then_some(Jitter { seed: Seed(5) });
    let (s, c) = (math::sin(angle.to_radians()), math::cos(angle.to_radians()));
    let z = (0..grid.len()).map(|i| grid.position(i)).map(|[x, y]| 500.0 - 0.1 * (s * x - c * y)).collect();
    let domain = RasterDomain::new(&grid, &[]);
    (grid, domain, z)
}

/// Degrees from `angle` to the mean direction in which water crosses the middle of the plane.
fn astray(grid: &Grid, angle: f64, moves: impl Fn(usize) -> Vec<(usize, f64)>) -> f64 {
    let mut sum = [0.0; 2];
    for i in (0..grid.len()).filter(|i| (20..100).contains(&(i % 121)) && (20..100).contains(&(i / 121))) {
        let from = grid.position(i);
        for (j, amount) in moves(i) {
            let to = grid.position(j);
            (0..2).for_each(|k| sum[k] += amount * (to[k] - from[k]));
        }
    }
    math::atan2(sum[0], -sum[1]).to_degrees() - angle
}

#[test]
fn water_runs_down_the_fall_line_whichever_way_the_lattice_lies() {
    for angle in [0.0, 5.0, 10.0, 22.5, 30.0, 45.0] {
        let (grid, domain, z) = plane(angle, true);
        let depth = vec![0.1; z.len()];
        for rule in RULES {
            let (mut sweep, mut standing) = (Sweep::new(rule), vec![0.0; z.len()]);
            sweep.round(&domain, &z, &rain(&depth), &mut standing);
            let total: f64 = depth.iter().sum();
            let way = |i: usize| {
                let passed = sweep.passed()[i];
                sweep.downstream(&domain, i, passed / total).weights().map(|(j, w)| (j, w * passed)).collect()
            };
            let off = astray(&grid, angle, way);
            assert!(off.abs() < 3.0, "{rule:?} {angle}: {off}");
        }
        let mut flow = landform_core::algo::flow::Flow::new();
        let mut area = landform_core::algo::flow::node_areas(&domain);
        flow.route(&domain, &z, &mut area);
        let off = astray(&grid, angle, |i| vec![(flow.receivers()[i] as usize, area[i])]);
        assert!(off.abs() < 3.0, "area {angle}: {off}");
        // Shared among all lower neighbours, what leaves a node goes on by slope.
        let mut shared = landform_core::algo::flow::node_areas(&domain);
        flow.accumulate_multiple(&domain, &z, 1.1, &mut shared);
        let by_slope = |i: usize| {
            let lower = domain.neighbours(i).filter(|l| z[l.to] < z[i]);
            let all: Vec<_> = lower.map(|l| (l.to, math::pow((z[i] - z[l.to]) / l.distance, 1.1))).collect();
            let sum: f64 = all.iter().map(|s| s.1).sum();
            all.into_iter().map(|(j, s)| (j, shared[i] * s / sum)).collect()
        };
        let off = astray(&grid, angle, by_slope);
        assert!(off.abs() < 3.0, "multiple {angle}: {off}");
        // Pipes have no corners, and run over the centres.
        let (grid, domain, z) = plane(angle, false);
        let ends: Vec<u32> =
            (0..z.len()).filter(|&i| domain.status()[i] != Status::Interior).map(|i| i as u32).collect();
        let (mut pipes, mut water) = (Pipes::new(z.len(), [10.0; 2], 0.04), vec![0.0; z.len()]);
        let supply = vec![1e-5; z.len()];
        for step in 0..2500 {
            if step == 2000 {
                pipes.begin_sums();
            }
            let dt = pipes.max_step(&water);
            pipes.step(&domain, &z, (&rain(&supply), &ends), dt, &mut water);
        }
        let off = astray(&grid, angle, |i| pipes.volume_out(&domain, i).collect());
        assert!(off.abs() < 0.5, "pipes {angle}: {off}");
    }
}

#[test]
fn a_sheet_in_pipes_runs_at_mannings_speed() {
    // Steady rain on a plane: q grows downhill; u = h^(2/3) S^(1/2) / n, whatever the step.
    let (_, domain, z) = plane(0.0, false);
    let ends: Vec<u32> = (0..z.len()).filter(|&i| domain.status()[i] != Status::Interior).map(|i| i as u32).collect();
    let (roughness, supply) = (0.04, vec![1e-5; z.len()]);
    let (mut pipes, mut water) = (Pipes::new(z.len(), [10.0; 2], roughness), vec![0.0; z.len()]);
    for step in 0..1500 {
        if step == 1499 {
            pipes.begin_sums();
        }
        let dt = pipes.max_step(&water);
        pipes.step(&domain, &z, (&rain(&supply), &ends), dt, &mut water);
    }
    let through = pipes.net_discharge(&domain);
    for row in [30, 60, 90] {
        let i = row * 121 + 60;
        let speed = through[i] / (water[i] * 10.0);
        let expected = math::pow(water[i], 2.0 / 3.0) * 0.1f64.sqrt() / roughness;
        assert!((speed / expected - 1.0).abs() < 0.05, "{row}: {speed} {expected}");
    }
}
