use landform_core::grid::{Edge, Edges, Grid, Shape};
use landform_core::math;
use landform_core::parallel::with_threads;
use landform_core::random::Seed;
use landform_core::sim::{Simulation, Stop};
use landform_core::terrain::HeightField;
use landform_core::units::{Length, YEAR};

use super::*;

fn field(rows: usize, cols: usize, cell: f64, edges: Edges, f: impl Fn(f64, f64) -> f64) -> HeightField {
    let mut grid = Grid::new(Shape::new(rows, cols), [cell; 2]).unwrap();
    grid.edges = edges;
    let z = (0..grid.len()).map(|i| f((i % cols) as f64, (i / cols) as f64)).collect();
    HeightField::new(grid, z).unwrap()
}

fn run(terrain: HeightField, params: ChannelErosion, rounds: u64) -> HeightField {
    let mut sim = Simulation::new(terrain).process(params).unwrap().dt(YEAR).seed(Seed(2)).until(Stop::steps(rounds));
    let outcome = sim.run().unwrap();
    assert!(outcome.budget.imbalance() < 1e-10 && outcome.budget.sediment_imbalance() < 1e-10, "{outcome:?}");
    sim.into_terrain()
}

/// A slope to the south, noise on it, open there only.
fn ramp(n: usize) -> HeightField {
    let edges = Edges { south: Edge::Open, ..Edges::all(Edge::Closed) };
    field(n, n / 2, 10.0, edges, |x, y| 2.0 * (n as f64 - y) + 3.0 * Seed(8).uniform((y * 999.0 + x) as u64))
}

#[test]
fn water_only_lowers_the_ground_and_never_below_its_lowest_neighbour() {
    for transport in
        [Transport::Columns, Transport::Average, Transport::WeightedAverage, Transport::Pipes, Transport::AreaMap]
    {
        let before = ramp(64);
        let params = ChannelErosion { transport, base_weight: 0.0, ..ChannelErosion::default() };
        let after = run(before.clone(), params, 10);
        let (a, b) = (before.elevation(), after.elevation());
        assert!((0..a.len()).all(|i| b[i] <= a[i]), "{transport:?}");
        let lowest = a.iter().copied().fold(f64::INFINITY, f64::min);
        assert!(b.iter().all(|&z| z >= lowest - 1e-9), "{transport:?}");
        assert!(a != b, "{transport:?}");
    }
}

#[test]
fn a_lake_fills_spills_and_breaks_through() {
    // A bowl on a table that falls away in the south.
    let bowl = |x: f64, y: f64| {
        let r = math::hypot(x - 20.0, y - 20.0);
        (40.0f64.min(0.1 * r * r)) - 2.0 * (y - 36.0).max(0.0)
    };
    let edges = Edges { south: Edge::Open, ..Edges::all(Edge::Closed) };
    let lake = |t: &HeightField| {
        let depth = t.fields().get(&names::WATER_DEPTH, "").unwrap();
        (t.elevation()[20 * 41 + 20] + depth[20 * 41 + 20], depth[20 * 41 + 20])
    };
    let at = |rounds| lake(&run(field(61, 41, 10.0, edges, bowl), ChannelErosion::default(), rounds));
    let levels: Vec<(f64, f64)> = [2, 8, 40, 400].map(at).to_vec();
    assert!(levels[0].0 < levels[1].0, "it fills: {levels:?}");
    assert!(levels[3].0 < levels[1].0 - 5.0 && levels[3].1 < levels[1].1 - 5.0, "it is drained: {levels:?}");
}

#[test]
fn fewer_and_wider_channels_reach_the_foot() {
    // Capture: threads that carry flow across the lower part of the slope become fewer.
    let threads = |t: &HeightField| {
        let q = t.fields().get(&names::DISCHARGE, "").unwrap();
        let (rows, cols) = (t.grid().shape.rows, t.grid().shape.cols);
        let row: Vec<f64> = (0..cols).map(|c| q[(rows - 20) * cols + c]).collect();
        let total: f64 = row.iter().sum();
        // Effective number: 1 / sum of squared shares.
        total * total / row.iter().map(|v| v * v).sum::<f64>()
    };
    let params =
        ChannelErosion { rainfall: landform_core::units::Rate::of(1000.0).into(), ..ChannelErosion::default() };
    let count = |rounds| threads(&run(ramp(128), params.clone(), rounds));
    let (early, late) = (count(2), count(300));
    assert!(late < 0.6 * early, "{early} {late}");
}

#[test]
fn river_objects_carry_what_their_basins_supply() {
    use landform_core::analysis::{Drainage, Width, rivers};
    let per_year = 1.0 / YEAR;
    for transport in [Transport::Columns, Transport::WeightedAverage, Transport::Pipes] {
        let rain = landform_core::units::Rate::of(1000.0).into();
        let params = ChannelErosion { transport, rainfall: rain, ..ChannelErosion::default() };
        let t = run(ramp(96), params, 20);
        let reaches = rivers(&t, &Drainage::of(&t, None, 0.0), 3_000.0, Width::default());
        assert!(reaches.len() > 20, "{transport:?}: {}", reaches.len());
        let fair =
            |r: &&landform_core::analysis::RiverReach| (0.8..1.25).contains(&(r.discharge / (r.area * per_year)));
        let share = reaches.iter().filter(fair).count() as f64 / reaches.len() as f64;
        assert!(share >= 0.95, "{transport:?}: {share}");
        // A line stays in the thread of the water; pipes and averages spread it over the width of
        // the channel.
        let q = t.fields().get(&names::DISCHARGE, "").unwrap();
        let main = reaches.iter().max_by(|a, b| a.area.total_cmp(&b.area)).unwrap();
        let greatest = |&i: &u32| q[i as usize];
        let carried = main.nodes.iter().map(greatest).fold(0.0, f64::max);
        assert!(carried > 0.1 * main.discharge, "{transport:?}: {carried} of {}", main.discharge);
    }
}

#[test]
fn rivers_widen_with_the_root_of_their_water() {
    // WC8: wet width against discharge along rivers of a valley that gathers tributaries.
    let edges = Edges { south: Edge::Open, ..Edges::all(Edge::Closed) };
    let n = 161;
    let start = field(n, n, 10.0, edges, |x, y| {
        1.0 * (n as f64 - y) + 0.4 * (x - 80.0).abs() + 4.0 * Seed(9).uniform((y * 999.0 + x) as u64)
    });
    let t = run(start, ChannelErosion { channel_radius: Some(Length::of(80.0)), ..ChannelErosion::default() }, 150);
    let (q, depth) = (t.fields().get(&names::DISCHARGE, "").unwrap(), t.fields().get(&names::WATER_DEPTH, "").unwrap());
    // Across the main river, row by row: what is wet beside its deepest place, at least a third as
    // deep.
    let points: Vec<(f64, f64)> = (30..n - 10)
        .map(|row| {
            let of = |c: usize| depth[row * n + c];
            let thread = (0..n).max_by(|&a, &b| of(a).total_cmp(&of(b))).unwrap();
            let is_wet = |c: &usize| of(*c) > 0.33 * of(thread);
            let reach: Vec<usize> =
                (0..thread).rev().take_while(is_wet).chain((thread..n).take_while(is_wet)).collect();
            let flow: f64 = reach.iter().map(|c| q[row * n + c]).sum();
            (math::log(flow), math::log(reach.len() as f64))
        })
        .collect();
    let (slope, ..) = math::line_fit(points.iter().copied());
    assert!((0.3..0.6).contains(&slope), "{slope}");
}

#[test]
fn any_number_of_threads_gives_the_same_bytes() {
    for transport in [Transport::Columns, Transport::Pipes] {
        let params = ChannelErosion { transport, ..ChannelErosion::default() };
        let one = with_threads(1, || run(ramp(300), params.clone(), 6)).unwrap();
        let two = with_threads(2, || run(ramp(300), params.clone(), 6)).unwrap();
        assert!(one.elevation().iter().zip(two.elevation()).all(|(a, b)| a.to_bits() == b.to_bits()));
    }
}

/// Mountains in the north over a plain with a hollow.
fn front(n: usize) -> HeightField {
    let edges = Edges { south: Edge::Open, ..Edges::all(Edge::Closed) };
    let (rows, middle) = (n as f64, n as f64 / 4.0);
    field(n, n / 2, 10.0, edges, |x, y| {
        let up = rows - y;
        let valleys = 0.4 + 0.6 * math::sin(std::f64::consts::PI * x / middle).abs();
        let mountains = 4.0 * (up - 0.6 * rows).clamp(0.0, 0.2 * rows) * valleys + 0.1 * up;
        let r = math::hypot(x - middle, up - 0.4 * rows);
        mountains - 0.4 * (8.0 - r).max(0.0) + 0.1 * Seed(8).uniform((y * 999.0 + x) as u64)
    })
}

#[test]
fn what_mountains_shed_is_laid_down_at_their_foot_and_lakes_fill() {
    for transport in [Transport::Columns, Transport::WeightedAverage, Transport::Pipes] {
        let (n, before) = (96, front(96));
        let bare = ChannelErosion { transport, outlets: None, ..ChannelErosion::default() };
        let laden = ChannelErosion { graded_slope: Some(landform_core::units::Ratio::of(0.1)), ..bare.clone() };
        let (cut, laid) = (run(before.clone(), bare, 40), run(before.clone(), laden, 40));
        let mean_change = |t: &HeightField, rows: std::ops::Range<usize>| {
            let nodes = rows.start * n / 2..rows.end * n / 2;
            let count = nodes.len() as f64;
            nodes.map(|i| t.elevation()[i] - before.elevation()[i]).sum::<f64>() / count
        };
        // The foot of the mountains is at row 0.4 n.
        let foot = (n * 4 / 10)..(n * 5 / 10);
        assert!(mean_change(&cut, foot.clone()) < 0.0, "{transport:?}");
        assert!(mean_change(&laid, foot) > 0.5, "{transport:?}");
        let pit = (n - n * 4 / 10) * n / 2 + n / 4;
        assert!(laid.elevation()[pit] > before.elevation()[pit] + 1.0, "{transport:?}: the hollow fills");
        // Nothing is raised above what was there, but by what a river may raise its bed.
        let highest = before.elevation().iter().copied().fold(0.0, f64::max);
        assert!(laid.elevation().iter().all(|&z| z <= highest + 1.0), "{transport:?}");
    }
}

#[test]
fn a_fan_falls_gently_away_from_its_mouth() {
    let params =
        ChannelErosion { graded_slope: Some(landform_core::units::Ratio::of(0.08)), ..ChannelErosion::default() };
    let after = run(front(96), params, 80);
    let row = |r: usize| after.elevation()[r * 48..(r + 1) * 48].iter().sum::<f64>() / 48.0;
    // Slopes of the plain between the foot and the hollow's end: steep under the mountains, less
    // with distance, near the graded slope.
    let slope = |a: usize, b: usize| (row(a) - row(b)) / ((b - a) as f64 * 10.0);
    let (near, far) = (slope(42, 52), slope(70, 90));
    assert!(near > 1.5 * far && (0.02..0.3).contains(&near), "{near} {far}");
}

#[test]
fn the_deeper_of_two_channels_takes_the_others_water() {
    // WC7: two grooves side by side on a slope, one deeper; the other keeps less than a tenth of
    // its flow.
    let (rows, cols) = (96, 40);
    let edges = Edges { south: Edge::Open, ..Edges::all(Edge::Closed) };
    let grooves = |x: f64, y: f64| {
        let groove = |at: f64, deep: f64| deep * (1.0 - (x - at).abs() / 4.0).max(0.0);
        let deeper = 0.02 * y;
        2.0 * (rows as f64 - y) - groove(16.0, 1.0) - groove(22.0, 1.0 + 8.0 * deeper)
            + 0.2 * Seed(8).uniform((y * 999.0 + x) as u64)
    };
    let share = |rounds: u64| {
        let params = ChannelErosion {
            channel_radius: Some(Length::of(80.0)),
            avalanche_weight: 4.0,
            ..ChannelErosion::default()
        };
        let after = run(field(rows, cols, 10.0, edges, grooves), params, rounds);
        let q = after.fields().get(&names::DISCHARGE, "").unwrap();
        let near = |at: usize| (at - 2..=at + 2).map(|c| q[(rows - 20) * cols + c]).sum::<f64>();
        near(16) / (near(16) + near(22))
    };
    let (early, late) = (share(1), share(300));
    assert!(early > 0.2 && late < 0.1 * early, "{early} {late}");
}

#[test]
fn a_spring_runs_in_its_rounds_only() {
    let edges = Edges { south: Edge::Open, ..Edges::all(Edge::Closed) };
    let slope = || field(40, 20, 10.0, edges, |_, y| 80.0 - 2.0 * y);
    let params = ChannelErosion {
        rainfall: landform_core::units::Rate::of(0.0).into(),
        springs: vec![Spring {
            at: [Length::of(95.0), Length::of(300.0)],
            discharge: landform_core::units::Discharge::of(1.0),
            rounds: Some([4, 6]),
        }],
        ..ChannelErosion::default()
    };
    let change = |from: u64, to: u64| {
        let (a, b) = (run(slope(), params.clone(), from), run(slope(), params.clone(), to));
        a.elevation().iter().zip(b.elevation()).map(|(a, b)| a - b).sum::<f64>()
    };
    // Before it begins and after it has ended nothing is worn.
    assert!(change(1, 3) == 0.0 && change(3, 5) > 0.0 && change(6, 20) == 0.0, "{} {}", change(3, 5), change(6, 20));
}

#[test]
fn ground_too_high_for_depths_of_water_is_refused() {
    let far = field(9, 9, 10.0, Edges::default(), |x, _| 1e18 + 1e6 * x);
    let run = Simulation::new(far)
        .process(ChannelErosion::default())
        .and_then(|sim| sim.dt(YEAR).until(Stop::steps(2)).run());
    assert!(run.unwrap_err().to_string().contains("1e9 m"));
}

#[test]
fn level_ground_stays_level_to_the_bit() {
    let slope = Some(landform_core::units::Ratio::of(0.05));
    for graded_slope in [None, slope] {
        let level = field(16, 16, 10.0, Edges::default(), |_, _| 100.0);
        let after = run(level, ChannelErosion { graded_slope, ..ChannelErosion::default() }, 5);
        assert!(after.elevation().iter().all(|&z| z == 100.0));
    }
}
