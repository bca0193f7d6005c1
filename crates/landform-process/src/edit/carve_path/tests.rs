use landform_core::grid::{Grid, Shape};

use super::*;

fn ground(rows: usize, cols: usize, cell: f64, z: impl Fn(f64, f64) -> f64) -> HeightField {
    let grid = Grid::new(Shape::new(rows, cols), [cell; 2]).unwrap();
    let z = (0..grid.len()).map(|i| z(grid.position(i)[0], grid.position(i)[1])).collect();
    HeightField::new(grid, z).unwrap()
}

fn carved(mut field: HeightField, points: &[[f64; 2]], params: &CarvePath) -> HeightField {
    let points = points.iter().map(|p| p.map(Length::of)).collect();
    let params = CarvePath { points, ..params.clone() };
    params.validate().unwrap();
    params.edit(&mut field, &Context::default()).unwrap();
    field
}

fn road(field: &HeightField) -> (Vec<[f64; 3]>, impl Fn(&str) -> f64) {
    let feature = field.features().of(FeatureKind::Path).next().unwrap().clone();
    let Geometry::Line(line) = feature.geometry.clone() else { panic!("no line") };
    (line, move |name: &str| match feature.property(name) {
        Some(Property::Number(v)) => *v,
        Some(Property::Whole(v)) => f64::from(*v),
        other => panic!("{name}: {other:?}"),
    })
}

fn steepest_of(line: &[[f64; 3]]) -> f64 {
    line.windows(2)
        .map(|w| (w[1][2] - w[0][2]).abs() / math::hypot(w[1][0] - w[0][0], w[1][1] - w[0][1]))
        .fold(0.0, f64::max)
}

/// Hills of 60 m, 300 m from crest to crest.
fn hills(x: f64, y: f64) -> f64 {
    100.0 + 30.0 * math::sin(x / 48.0) * math::sin(y / 57.0) + 0.02 * x
}

#[test]
fn on_level_ground_nothing_moves_but_the_camber() {
    let flat = CarvePath { camber: 0.0, ..CarvePath::default() };
    let field = carved(ground(41, 61, 5.0, |_, _| 7.0), &[[20.0, 30.0], [280.0, 170.0]], &flat);
    assert!(field.elevation().iter().all(|z| (z - 7.0).abs() < 1e-9));
    let (line, number) = road(&field);
    // The way of least cost over level ground is straight to a part in a hundred.
    let straight = math::hypot(260.0, 140.0);
    assert!((number("length_m") / straight - 1.0).abs() < 0.01, "{}", number("length_m"));
    assert!(number("cut_m3") < 1e-6 && number("fill_m3") < 1e-6);
    assert!((line[0][0] - 20.0).abs() < 1e-9 && (line[line.len() - 1][1] - 170.0).abs() < 1e-9);
}

#[test]
fn the_grade_is_kept_on_the_line_and_on_the_ground_and_cut_balances_fill() {
    for route in [PathRoute::Found, PathRoute::Straight] {
        let params = CarvePath {
            route,
            width: Length::of(10.0),
            steepest: Angle::of(6.0),
            bridge_above: Length::of(1e9),
            ..CarvePath::default()
        };
        let before = ground(201, 301, 2.0, hills);
        let field = carved(before.clone(), &[[20.0, 200.0], [580.0, 220.0]], &params);
        let (line, number) = road(&field);
        let most = math::tan(6.0_f64.to_radians());
        assert!(steepest_of(&line) <= most * (1.0 + 1e-9), "{route:?}: {}", steepest_of(&line));
        assert!(number("steepest_deg") <= 6.0 + 1e-6);
        // The ground under the middle is the road, to the camber between nodes.
        for p in &line {
            let off = field.elevation_at([p[0], p[1]]) - p[2];
            assert!(off.abs() < 0.02 * 2.0 * 1.5 + 1e-6, "{route:?}: {off} m at {p:?}");
        }
        let [cut, fill] = [number("cut_m3"), number("fill_m3")];
        assert!(cut > 100.0 && (fill / cut - 1.0).abs() < 1e-6, "{route:?}: cut {cut} fill {fill}");
        // The volumes are those of the ground.
        let moved = |sign: f64| {
            let rise = field.elevation().iter().zip(before.elevation()).map(|(a, b)| (sign * (a - b)).max(0.0));
            rise.sum::<f64>() * 4.0
        };
        assert!((moved(-1.0) / cut - 1.0).abs() < 1e-9 && (moved(1.0) / fill - 1.0).abs() < 1e-9);
    }
}

#[test]
fn the_cross_section_is_flat_with_camber_and_slopes_beside() {
    // A road along a hillside of 20 degrees, straight to the east.
    let side = math::tan(20.0_f64.to_radians());
    let params =
        CarvePath { route: PathRoute::Straight, width: Length::of(12.0), camber: 0.03, ..CarvePath::default() };
    let field = carved(ground(121, 81, 1.0, |_, y| side * y), &[[0.0, 60.0], [80.0, 60.0]], &params);
    let z = |y: usize| field.elevation()[field.grid().shape.index(120 - y, 40)];
    let middle = z(60);
    for k in 1..=6 {
        let fall = middle - 0.03 * k as f64;
        assert!((z(60 + k) - fall).abs() < 1e-9 && (z(60 - k) - fall).abs() < 1e-9, "{k}");
    }
    let (cut, fill) = (math::tan(45.0_f64.to_radians()), math::tan(34.0_f64.to_radians()));
    let edge = middle - 0.03 * 6.0;
    let above = side * 67.0;
    assert!((z(67) - above.min(edge + cut)).abs() < 1e-9 && (z(53) - (edge - fill)).abs() < 1e-9);
    // Farther away the hillside is as it was.
    assert_eq!((z(100), z(10)), (side * 100.0, side * 10.0));
}

#[test]
fn a_steep_slope_is_climbed_in_bends() {
    // 30 degrees straight up; at 8 degrees the way must be four times as long.
    let slope = math::tan(30.0_f64.to_radians());
    let steep = |_: f64, y: f64| slope * y;
    let field = carved(ground(101, 201, 5.0, steep), &[[500.0, 50.0], [500.0, 350.0]], &CarvePath::default());
    let (_, number) = road(&field);
    let least = 300.0 * slope / math::tan(8.0_f64.to_radians());
    assert!(number("length_m") > 0.75 * least, "{} of {least} m", number("length_m"));
    assert!(number("length_m") < 2.0 * least);
}

#[test]
fn a_gorge_is_bridged_and_what_is_far_stays() {
    let gorge = |x: f64, _: f64| if (x - 300.0).abs() < 20.0 { 0.0 } else { 50.0 };
    let before = ground(61, 121, 5.0, gorge);
    let params = CarvePath { route: PathRoute::Straight, ..CarvePath::default() };
    let field = carved(before.clone(), &[[20.0, 150.0], [580.0, 150.0]], &params);
    let (_, number) = road(&field);
    assert_eq!(number("bridges"), 1.0);
    let at = |x: usize, y: usize| field.grid().shape.index(60 - y, x);
    assert_eq!(field.elevation()[at(60, 30)], 0.0, "no fill under the bridge");
    assert!((0..121).all(|x| field.elevation()[at(x, 58)] == before.elevation()[at(x, 58)]));
}

#[test]
fn roads_are_kept_and_a_second_one_has_another_name() {
    let once = carved(ground(41, 61, 5.0, |_, _| 7.0), &[[20.0, 30.0], [280.0, 170.0]], &CarvePath::default());
    let twice = carved(once, &[[20.0, 170.0], [280.0, 30.0]], &CarvePath::default());
    let ids: Vec<&str> = twice.features().of(FeatureKind::Path).map(|f| f.id.as_str()).collect();
    assert_eq!(ids, ["path 1", "path 2"]);
}

#[test]
fn strange_ground_and_places_are_refused_or_carved() {
    let edit = |mut field: HeightField, points: &[[f64; 2]]| {
        let points: Vec<_> = points.iter().map(|p| p.map(Length::of)).collect();
        CarvePath { points, ..CarvePath::default() }.edit(&mut field, &Context::default()).map(|()| field)
    };
    let hole = |x: f64, _: f64| if (x - 100.0).abs() < 12.0 { f64::NAN } else { 5.0 };
    let name = |error: landform_core::Error| error.parameter_name().map(String::from);
    let walled = || ground(21, 41, 5.0, hole);
    assert_eq!(name(edit(walled(), &[[20.0, 50.0], [180.0, 50.0]]).unwrap_err()).as_deref(), Some("points"));
    assert!(edit(walled(), &[[20.0, 50.0], [100.0, 50.0]]).is_err(), "a place without ground");
    assert!(edit(walled(), &[[20.0, 50.0], [1e9, 50.0]]).is_err(), "off the map");
    assert!(edit(walled(), &[[20.0, 50.0], [20.0, 50.0]]).is_err(), "no length");
    assert!(edit(ground(1, 1, 5.0, |_, _| 1.0), &[]).is_err());
    assert!(edit(ground(1, 30, 5.0, |x, _| x), &[]).is_ok());
    assert!(edit(ground(30, 2, 5.0, |_, y| y), &[]).is_ok());
    assert!(CarvePath { points: vec![[Length::of(1.0); 2]], ..CarvePath::default() }.validate().is_err());
    assert!(CarvePath { width: Length::of(1e12), ..CarvePath::default() }.validate().is_err());
}
