//! Islands from a sketch: CR3, CR6, CR7, CR8.

use landform_core::field::names::COAST_LABELS;
use landform_core::random::Seed;
use landform_core::verb::Params;

use super::*;
use crate::mechanism::GridParams;

/// An island without noise.
fn smooth(size: f64, cell: f64) -> CoralIsland {
    let outline = OutlineParams { roughness: Ratio::of(0.0), ..OutlineParams::default() };
    CoralIsland { grid: GridParams::of([size; 2], cell), outline, valleys: Ratio::of(0.0), ..CoralIsland::default() }
}

/// A cone with a fall of 1 in 2 from 495 m down to a floor at 500 m under the sea.
fn cone(subsidence: f64) -> CoralIsland {
    let points = [[0.0, 495.0], [10.0, 495.0], [500.0, 250.0], [1000.0, 0.0], [1500.0, -250.0], [2000.0, -500.0]];
    let reef = BandParams { low: Length::of(-20.0), ..BandParams::default() };
    let profile = points.map(|p| p.map(Length::of)).to_vec();
    CoralIsland { profile, subsidence: Length::of(subsidence), reef: Some(reef), ..smooth(4_000.0, 20.0) }
}

fn made(params: &CoralIsland, seed: u64) -> HeightField {
    params.validate().unwrap();
    params.generate(&Context { seed: Seed(seed), ..Context::default() }).unwrap()
}

/// Labels along a line from the middle to the east.
fn labels_on_ray(field: &HeightField) -> Vec<&'static str> {
    let (grid, labels) = (field.grid(), field.fields().get(&names::LABELS, "a test").unwrap());
    let middle = grid.shape.rows / 2;
    (grid.shape.cols / 2..grid.shape.cols)
        .map(|c| COAST_LABELS[usize::from(labels[grid.shape.index(middle, c)])])
        .collect()
}

#[test]
fn cr3_a_cone_that_sinks_has_a_fringing_reef_then_a_barrier_then_an_atoll() {
    let (cell, fall) = (20.0, 0.5);
    let mut stages = Vec::new();
    for subsidence in [0.0, 2.0, 25.0, 60.0, 120.0, 200.0, 240.0, 400.0, 494.0, 500.0, 600.0] {
        let ray = labels_on_ray(&made(&cone(subsidence), 1));
        let count = |name: &str| ray.iter().filter(|l| **l == name).count() as f64;
        let width = cell * count("lagoon");
        let has_land = ["mountain", "island", "beach"].iter().any(|name| ray.contains(name));
        if (25.0..=240.0).contains(&subsidence) {
            assert!((width - subsidence / fall).abs() <= cell, "sunk {subsidence} m: lagoon of {width} m");
        }
        stages.push(if !has_land { 2 } else { usize::from(width > cell) });
        assert!(ray.contains(&"reef crest"), "sunk {subsidence} m");
    }
    assert_eq!(stages, [0, 0, 1, 1, 1, 1, 1, 1, 1, 2, 2]);
}

#[test]
fn cr6_without_noise_an_island_depends_on_the_distance_from_its_middle_alone() {
    for params in [smooth(6_000.0, 50.0), cone(100.0)] {
        let field = made(&params, 7);
        let (grid, z) = (field.grid(), field.elevation());
        let half = grid.shape.rows / 2;
        for (row, col) in (0..=half).flat_map(|r| (0..=half).map(move |c| (r, c))) {
            let last = grid.shape.rows - 1;
            let alike = [(col, row), (last - row, col), (row, last - col), (last - col, last - row)];
            let at = |(r, c): (usize, usize)| z[grid.shape.index(r, c)];
            assert!(alike.iter().all(|&place| (at(place) - at((row, col))).abs() < 1e-9), "{row} {col}");
        }
        // (30, 40) and (50, 0) are as far, too.
        let at = |r: usize, c: usize| z[grid.shape.index(half + r, half + c)];
        assert!((at(30, 40) - at(50, 0)).abs() < 1e-9 && (at(15, 20) - at(0, 25)).abs() < 1e-9);
    }
    assert!(
        made(&CoralIsland { grid: GridParams::of([6_000.0; 2], 50.0), ..CoralIsland::default() }, 1)
            != made(&smooth(6_000.0, 50.0), 1)
    );
}

#[test]
fn cr7_labels_part_the_map_and_come_in_order_from_the_middle_outwards() {
    let order = |label: u8| usize::from(label);
    for subsidence in [0.0, 60.0, 200.0, 600.0] {
        let field = made(&cone(subsidence), 3);
        let labels = field.fields().get(&names::LABELS, "a test").unwrap();
        assert!(labels.iter().all(|&l| (1..=8).contains(&l)));
        let (grid, middle) = (field.grid(), [2_000.0, 2_000.0]);
        for turn in 0..360 {
            let angle = f64::from(turn).to_radians();
            let mut last = 0;
            for step in 0..190 {
                let far = 10.0 * f64::from(step);
                let place = [middle[0] + far * math::sin(angle), middle[1] + far * math::cos(angle)];
                let next = order(labels[grid.node_at(place).unwrap()]);
                assert!(next >= last, "sunk {subsidence} m, {turn} deg, {far} m: {last} then {next}");
                last = next;
            }
            assert!(last >= 7);
        }
    }
}

#[test]
fn cr8_the_strongest_wind_folds_no_ground() {
    let wind = Some(WarpParams { from: Angle::of(130.0), strength: Ratio::of(1.0) });
    let params = CoralIsland { wind, ..smooth(8_000.0, 50.0) };
    let curve = params.curve().unwrap();
    let island = Island::new(&params, &curve, [4_000.0; 2], Seed(1));
    let step = 0.01;
    let mut least = f64::INFINITY;
    for (a, b) in (-80..=80).flat_map(|a| (-80..=80).map(move |b| (a, b))) {
        let (x, y) = (50.0 * f64::from(a), 50.0 * f64::from(b));
        let at = |dx: f64, dy: f64| island.before_wind([x + dx, y + dy]);
        let rise = |p: [f64; 2], q: [f64; 2]| [0, 1].map(|k| (p[k] - q[k]) / (2.0 * step));
        let (east, north) = (rise(at(step, 0.0), at(-step, 0.0)), rise(at(0.0, step), at(0.0, -step)));
        least = least.min(east[0] * north[1] - east[1] * north[0]);
    }
    // 1 - e^(-1/2) where the wind brings ground closest together.
    assert!(least > 0.0 && (least - (1.0 - math::exp(-0.5))).abs() < 0.02, "{least}");
    // The summit lies to leeward of the middle, north-west.
    let field = made(&params, 1);
    let top = (0..field.grid().len()).max_by(|&a, &b| field.elevation()[a].total_cmp(&field.elevation()[b])).unwrap();
    let [x, y] = field.grid().position(top);
    assert!(x < 3_600.0 && y > 4_300.0, "{x} {y}");
}

#[test]
fn islands_follow_their_radii_and_places_and_wrong_ones_are_refused() {
    let outline = OutlineParams { radius: Some(Length::of(1_000.0)), roughness: Ratio::of(0.0), radii: Vec::new() };
    let two = CoralIsland {
        outline: OutlineParams { radii: [1_200.0, 600.0].map(Length::of).to_vec(), ..outline.clone() },
        at: vec![[Length::of(2_000.0); 2], [Length::of(6_000.0), Length::of(2_000.0)]],
        grid: GridParams { size: [Length::of(8_000.0), Length::of(4_000.0)], cell_size: Length::of(20.0) },
        ..smooth(8_000.0, 20.0)
    };
    let field = made(&two, 1);
    for middle in [2_000.0, 6_000.0] {
        assert!(field.elevation_at([middle, 2_000.0]) > 500.0);
        assert!(field.elevation_at([middle, 3_180.0]) > 0.0 && field.elevation_at([middle, 3_230.0]) < 0.0);
        assert!(field.elevation_at([middle, 1_420.0]) > 0.0 && field.elevation_at([middle, 1_380.0]) < 0.0);
    }
    let wrong: [fn(&mut CoralIsland); 7] = [
        |p| p.at = vec![[Length::of(500.0), Length::of(1e300)]],
        |p| p.profile = vec![[Length::of(0.0); 2]],
        |p| p.profile[1][0] = Length::of(f64::NAN),
        |p| p.profile[1][1] = Length::of(1e308),
        |p| p.subsidence = Length::of(-1.0),
        |p| p.outline.radii = vec![Length::of(0.0)],
        |p| p.reef = Some(BandParams { low: Length::of(5.0), ..BandParams::default() }),
    ];
    for spoil in wrong {
        let mut params = smooth(1_000.0, 100.0);
        spoil(&mut params);
        assert!(params.validate().is_err(), "{params:?}");
    }
    // A map of a few nodes, and an island far larger than it.
    for (size, cell) in [(100.0, 100.0), (10.0, 3.0)] {
        assert!(made(&CoralIsland { grid: GridParams::of([size; 2], cell), ..cone(30.0) }, 1).nodata_count() == 0);
    }
}
