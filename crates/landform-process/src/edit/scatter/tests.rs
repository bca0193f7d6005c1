use landform_core::grid::{Grid, Shape};
use landform_core::parallel::with_threads;
use landform_core::units::{Angle, Ratio};

use super::*;

/// A slope that rises to the north, steeper in the east: 0.1 in the west, 1 in the east.
fn ground() -> HeightField {
    let grid = Grid::new(Shape::new(81, 81), [5.0; 2]).unwrap();
    let z = (0..grid.len()).map(|i| grid.position(i)).map(|[x, y]| y * if x < 200.0 { 0.1 } else { 1.0 });
    HeightField::new(grid.clone(), z.collect()).unwrap()
}

fn points(params: &Scatter, mut field: HeightField) -> Vec<[f64; 3]> {
    params.validate().unwrap();
    params.edit(&mut field, &Context { seed: Seed(3), ..Context::default() }).unwrap();
    let feature = field.features().of(FeatureKind::Object).last().unwrap();
    let Geometry::Points(points) = &feature.geometry else { panic!("no points") };
    for name in ["yaw_deg", "scale"] {
        assert_eq!(feature.numbers(name).unwrap().len(), points.len());
    }
    assert!(feature.numbers("scale").unwrap().iter().all(|s| (params.scale[0]..=params.scale[1]).contains(s)));
    points.clone()
}

fn dense() -> Scatter {
    Scatter { spacing: Length::of(5.0), ..Scatter::default() }
}

#[test]
fn no_two_are_nearer_than_the_spacing_and_none_is_missing() {
    let points = points(&dense(), ground());
    for (i, p) in points.iter().enumerate() {
        assert!(points[..i].iter().all(|q| math::hypot(p[0] - q[0], p[1] - q[1]) >= 5.0));
    }
    // As many as disks of Bridson's algorithm, 0.69 a square of the spacing (0.615 with a border).
    let a_square = points.len() as f64 * 25.0 / (400.0 * 400.0);
    assert!((0.60..0.75).contains(&a_square), "{a_square}");
    assert!(points.iter().all(|p| (p[2] - ground().elevation_at([p[0], p[1]])).abs() < 1e-9));
}

#[test]
fn density_is_the_share_that_stays() {
    let all = points(&dense(), ground()).len() as f64;
    let half = Scatter { density: Varying::Uniform(Ratio::of(0.5)), ..dense() };
    let share = points(&half, ground()).len() as f64 / all;
    // Three standard deviations of 4,400 draws.
    assert!((share - 0.5).abs() < 3.0 * (0.25 / all).sqrt(), "{share}");
    // In the north (v = 1) all of it, in the south none.
    let more: Scatter = serde_json::from_str(r#"{"spacing":"5 m","density":{"formula":"v"}}"#).unwrap();
    let north = points(&more, ground());
    for k in 0..4 {
        let low = 100.0 * f64::from(k);
        let count = north.iter().filter(|p| (low..low + 100.0).contains(&p[1])).count() as f64;
        let expected = 0.25 * all * (low + 50.0) / 400.0;
        assert!((count - expected).abs() < 5.0 * expected.sqrt() + 10.0, "{count} of {expected}");
    }
}

#[test]
fn rules_of_slope_and_height_hold() {
    let slope = SlopeSpan { above: None, below: Some(Angle::of(20.0)) };
    let height = LengthSpan { above: Some(Length::of(10.0)), below: Some(Length::of(30.0)) };
    let points = points(&Scatter { slope, height, ..dense() }, ground());
    assert!(points.len() > 500);
    assert!(points.iter().all(|p| p[0] < 202.5 && (10.0..=30.0).contains(&p[2])), "in the west, at these heights");
}

#[test]
fn objects_keep_their_distance_from_features_and_stay_off_roads_and_out_of_water() {
    let mut field = ground();
    let line = vec![[0.0, 200.0, 0.0], [400.0, 200.0, 0.0]];
    let feature =
        |kind, properties| Feature { id: "1".into(), kind, geometry: Geometry::Line(line.clone()), properties };
    field.features_mut().add(feature(FeatureKind::River, Vec::new()));
    let rule: Scatter =
        serde_json::from_str(r#"{"spacing":"5 m","distance":[{"feature":"rivers","above":"20 m","below":"50 m"}]}"#)
            .unwrap();
    let beside = points(&rule, field.clone());
    assert!(beside.len() > 300 && beside.iter().all(|p| (20.0..=50.0).contains(&(p[1] - 200.0).abs())));
    let width = vec![("width_m".to_string(), Property::Number(30.0))];
    field.features_mut().add(feature(FeatureKind::Path, width));
    let off = points(&dense(), field.clone());
    assert!(off.iter().all(|p| (p[1] - 200.0).abs() > 15.0));
    let depth = (0..81 * 81).map(|i| if i % 81 < 40 { 2.0 } else { 0.0 }).collect();
    field.fields_mut().insert(&names::LAKE_DEPTH, depth).unwrap();
    assert!(points(&dense(), field).iter().all(|p| p[0] > 195.0));
}

#[test]
fn threads_change_nothing_and_a_second_kind_is_added() {
    let run =
        |threads| with_threads(threads, || points(&Scatter { spacing: Length::of(2.0), ..dense() }, ground())).unwrap();
    assert!(run(1) == run(4));
    let mut field = ground();
    for kind in ["tree", "rock", "tree"] {
        Scatter { kind: kind.into(), ..dense() }.edit(&mut field, &Context::default()).unwrap();
    }
    let ids: Vec<&str> = field.features().of(FeatureKind::Object).map(|f| f.id.as_str()).collect();
    assert_eq!(ids, ["tree", "rock", "tree-2"]);
}

#[test]
fn what_cannot_be_scattered_is_refused() {
    let refused = |params: &Scatter| {
        let edited = || params.edit(&mut ground(), &Context::default());
        params.validate().and_then(|()| edited()).unwrap_err().to_string()
    };
    assert!(refused(&Scatter { spacing: Length::of(1e-9), ..dense() }).contains("20 million"));
    assert!(refused(&Scatter { spacing: Length::of(1e9), ..dense() }).contains("half of the map"));
    assert!(refused(&Scatter { kind: "a,b".into(), ..dense() }).contains("a word of letters"));
    assert!(refused(&Scatter { scale: [2.0, 1.0], ..dense() }).contains("the least, then"));
    assert!(Scatter { density: Varying::Uniform(Ratio::of(2.0)), ..dense() }.validate().is_err());
    let rule = DistanceRule { feature: FeatureWord::Rivers, above: None, below: Some(Length::of(9.0)) };
    assert!(refused(&Scatter { distance: vec![rule], ..dense() }).contains("no rivers"));
    let one = HeightField::new(Grid::new(Shape::new(1, 1), [5.0; 2]).unwrap(), vec![1.0]).unwrap();
    assert!(dense().edit(&mut one.clone(), &Context::default()).is_err());
}
