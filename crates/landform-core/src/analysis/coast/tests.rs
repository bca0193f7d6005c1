use super::*;
use crate::algo::noise::spectral_surface;
use crate::grid::Shape;
use crate::random::Seed;

/// Koch's curve of unit length after so many replacements.
fn koch(times: u32) -> Vec<[f64; 2]> {
    let mut points = vec![[0.0, 0.0], [1.0, 0.0]];
    let (c, s) = (0.5, 0.75_f64.sqrt());
    for _ in 0..times {
        let mut next = vec![points[0]];
        for p in points.windows(2) {
            let third = [(p[1][0] - p[0][0]) / 3.0, (p[1][1] - p[0][1]) / 3.0];
            let a = [p[0][0] + third[0], p[0][1] + third[1]];
            let b = [p[1][0] - third[0], p[1][1] - third[1]];
            let top = [a[0] + c * third[0] - s * third[1], a[1] + s * third[0] + c * third[1]];
            next.extend([a, top, b, p[1]]);
        }
        points = next;
    }
    points
}

#[test]
fn kochs_curve_and_a_straight_line_have_their_dimensions() {
    let curve = koch(7);
    let smallest = 1.0 / crate::math::powi(3.0_f64, 7);
    let expected = math::log(4.0) / math::log(3.0);
    let divider = dimension_by_divider(&curve, 4.0 * smallest, f64::INFINITY).unwrap();
    assert!((divider.dimension - expected).abs() < 0.02, "{}", divider.dimension);
    let boxes = dimension_by_boxes(&[&curve], 4.0 * smallest, f64::INFINITY).unwrap();
    assert!((boxes.dimension - expected).abs() < 0.02, "{}", boxes.dimension);
    let line: Vec<[f64; 2]> = (0..=1000).map(|k| [f64::from(k) * 0.9, f64::from(k) * 0.37]).collect();
    for d in [dimension_by_divider(&line, 4.0, f64::INFINITY), dimension_by_boxes(&[&line], 2.0, f64::INFINITY)] {
        let d = d.unwrap().dimension;
        assert!((d - 1.0).abs() < 0.02, "{d}");
    }
    assert!((dimension_by_divider(&line, 4.0, f64::INFINITY).unwrap().dimension - 1.0).abs() < 0.005);
}

#[test]
fn level_sets_read_what_the_calibration_reads() {
    // FB5: 2 − H = 1.70, 1.50, 1.30, 1.10 is read as 1.56, 1.40, 1.24, 1.12 by a plain count of
    // boxes at 1024².
    let shape = Shape::new(1024, 1024);
    let grid = Grid::new(shape, [1.0, 1.0]).unwrap();
    for (hurst, reads) in [(0.3, 1.56), (0.5, 1.40), (0.7, 1.24), (0.9, 1.12)] {
        let mean = (1..=3)
            .map(|seed| {
                let z = spectral_surface(shape, [1.0, 1.0], hurst, Seed(seed));
                let (coast, lines) = coast(&grid, &z, 0.0);
                assert!(coast.islands > 0 && (0.2..0.8).contains(&coast.land_share));
                let all: Vec<&[[f64; 2]]> = lines.iter().map(|l| l.points.as_slice()).collect();
                dimension_by_boxes(&all, 2.0, f64::INFINITY).unwrap().dimension
            })
            .sum::<f64>()
            / 3.0;
        assert!((mean - reads).abs() < 0.05, "H = {hurst}: {mean}");
    }
}

#[test]
fn a_round_island_has_its_area_and_coast() {
    let grid = Grid::new(Shape::new(201, 201), [10.0, 10.0]).unwrap();
    let z: Vec<f64> =
        (0..grid.len()).map(|i| grid.position(i)).map(|[x, y]| 500.0 - math::hypot(x - 1000.0, y - 1000.0)).collect();
    let (c, _) = coast(&grid, &z, 0.0);
    assert_eq!((c.islands, c.lines), (1, 1));
    assert!((c.largest[0] / (std::f64::consts::PI * 250_000.0) - 1.0).abs() < 0.01);
    assert!((c.length / (std::f64::consts::PI * 1000.0) - 1.0).abs() < 0.01);
    // A quarter of its extent is six times the least step.
    assert!(c.divider.dimension.is_none() && c.divider.why.as_ref().is_some_and(|why| why.contains("0.75 decades")));
    let (nothing, _) = coast(&grid, &z, 1e4);
    assert!(nothing.islands == 0 && nothing.divider.dimension.is_none() && nothing.length == 0.0);
}

#[test]
fn a_divider_refuses_less_than_a_decade_of_steps() {
    let expected = math::log(4.0) / math::log(3.0);
    let side = |times: u32| 1.0 / math::powi(3.0, times);
    let fine = Divider::along(&koch(7), 4.0 * side(7), f64::INFINITY);
    assert!((fine.dimension.unwrap() - expected).abs() < 0.02 && fine.r2.unwrap() > 0.99, "{fine:?}");
    let span = fine.greatest_step.unwrap() / fine.least_step.unwrap();
    assert!(span >= 10.0 && fine.why.is_none());
    // Half a decade.
    let coarse = Divider::along(&koch(4), 4.0 * side(4), f64::INFINITY);
    assert!(coarse.dimension.is_none() && coarse.why.as_ref().is_some_and(|why| why.contains("decades")), "{coarse:?}");
    assert!(coarse.least_step.is_some() && coarse.greatest_step.is_some());
    let json = serde_json::to_value(&coarse).unwrap();
    assert!(json["dimension"].is_null() && json["why"].is_string());
    let none = Divider::along(&[], 1.0, f64::INFINITY);
    assert!(none.dimension.is_none() && none.r2.is_none() && none.why.is_some());
}

#[test]
fn a_wide_round_island_has_a_smooth_coast() {
    let grid = Grid::new(Shape::new(401, 401), [5.0, 5.0]).unwrap();
    let z: Vec<f64> =
        (0..grid.len()).map(|i| grid.position(i)).map(|[x, y]| 900.0 - math::hypot(x - 1000.0, y - 1000.0)).collect();
    let divider = coast(&grid, &z, 0.0).0.divider;
    // A ring is no line, but nearly.
    assert!((divider.dimension.unwrap() - 1.0).abs() < 0.03 && divider.r2.unwrap() > 0.999, "{divider:?}");
    assert_eq!(divider.least_step, Some(20.0));
}

#[test]
fn the_projection_keeps_distances_near_its_centre() {
    let p = project(&[[10.0, 50.0], [10.0, 51.0], [11.0, 50.0]], [10.0, 50.0]);
    assert_eq!(p[0], [0.0, 0.0]);
    assert!((p[1][1] / 111_195.0 - 1.0).abs() < 1e-3 && p[1][0].abs() < 1e-6);
    assert!((p[2][0] / (111_195.0 * math::cos(50.0_f64.to_radians())) - 1.0).abs() < 1e-3);
}

#[test]
fn steps_of_nothing_and_points_without_extent_end_at_once() {
    let line = [[0.0, 0.0], [5.0, 1.0], [9.0, 0.0]];
    for least in [0.0, -1.0, f64::NAN, 1e-12] {
        assert!(dimension_by_divider(&line, least, f64::INFINITY).is_none());
        assert!(dimension_by_boxes(&[&line], least, f64::INFINITY).is_none());
    }
    let point = [[3.0, 3.0]; 4];
    assert!(dimension_by_divider(&point, 0.0, 1.0).is_none() && dimension_by_boxes(&[&point], 0.1, 1.0).is_none());
}
