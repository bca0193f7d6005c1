use super::*;
use crate::format::raster_format;
use landform_core::grid::{Grid, Shape};
use landform_core::math;
use landform_core::terrain::HeightField;
use landform_core::verb::MemoryOutput;

/// Hills between -40 m and 80 m on a raster of 20 m x 30 m cells.
fn hills() -> HeightField {
    let grid = Grid::new(Shape::new(31, 41), [20.0, 30.0]).unwrap();
    let z = (0..grid.len()).map(|i| grid.position(i));
    let z = z.map(|[x, y]| 20.0 + 60.0 * math::sin(0.011 * x) * math::cos(0.013 * y)).collect();
    HeightField::new(grid, z).unwrap()
}

fn flat(shape: Shape, z: f64) -> HeightField {
    let grid = Grid::new(shape, [10.0, 10.0]).unwrap();
    HeightField::new(grid.clone(), vec![z; grid.len()]).unwrap()
}

fn export(write: &WritePovray, field: &HeightField) -> Result<MemoryOutput> {
    let mut out = MemoryOutput::default();
    write.check()?;
    write.export(&Landscape::plain(field), &mut out)?;
    Ok(out)
}

fn text(out: &MemoryOutput) -> String {
    String::from_utf8(out.0["scene.pov"].clone()).unwrap()
}

/// The number that a scene declares by a name.
fn declared(scene: &str, name: &str) -> f64 {
    let start = format!("#declare {name} = ");
    let line = scene.lines().find_map(|line| line.strip_prefix(&start)).unwrap();
    line.split(';').next().unwrap().parse().unwrap()
}

/// The three numbers after a word at the start of a line.
fn numbers(scene: &str, word: &str) -> Vec<f64> {
    let line = scene.lines().find_map(|line| line.trim().strip_prefix(word)).unwrap();
    let inner = line.trim().trim_start_matches('<').split('>').next().unwrap();
    inner.split(',').map(|n| n.trim().parse().unwrap()).collect()
}

/// Elevations that the heights of a file mean in a scene, m.
fn metres(out: &MemoryOutput, file: &str) -> Vec<f64> {
    let scene = text(out);
    let steps = raster_format(file.as_ref()).unwrap().read(&out.0[file], None).unwrap();
    let metre = |v: &f64| declared(&scene, "Foot") + v * declared(&scene, "Step");
    steps.elevation().iter().map(metre).collect()
}

#[test]
fn heights_come_back_in_metres_within_half_a_step() {
    let field = hills();
    for exaggeration in [1.0, 2.5] {
        let out = export(&WritePovray { exaggeration, ..WritePovray::default() }, &field).unwrap();
        let scene = text(&out);
        assert_eq!([declared(&scene, "Width"), declared(&scene, "Length")], [800.0, 900.0]);
        assert_eq!(declared(&scene, "Exaggeration"), exaggeration);
        let half = 0.5 * declared(&scene, "Step") + 1e-9;
        let back = metres(&out, "scene_ground.png");
        assert!(back.iter().zip(field.elevation()).all(|(a, b)| (a - b).abs() <= half));
    }
}

#[test]
fn camera_and_sun_are_those_of_the_picture() {
    let field = hills();
    let quarter = Angle::from_si(std::f64::consts::FRAC_PI_2);
    let sun_altitude = Angle::from_si(0.5);
    let write = WritePovray { view_from: quarter, sun: quarter, sun_altitude, ..WritePovray::default() };
    let scene = text(&export(&write, &field).unwrap());
    let block = BlockView::new(&field, &write.view());
    let [east, north, up] = block.camera;
    let at = numbers(&scene, "location");
    assert!(at.iter().zip([east, up, north]).all(|(a, b)| (a - b).abs() < 1e-5), "{at:?}");
    // From the east, above the ground, towards the west.
    assert!(at[0] > 800.0 && at[1] > 80.0 && numbers(&scene, "look_at")[0] < at[0]);
    let sun = numbers(&scene, "#declare Sun =");
    let expected = [math::cos(0.5), math::sin(0.5), 0.0];
    assert!(sun.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-5), "{sun:?}");
    // Nearer with zoom.
    let near = text(&export(&WritePovray { zoom: 2.0, ..write }, &field).unwrap());
    assert!(numbers(&near, "location")[1] < at[1]);
}

#[test]
fn the_sea_lies_at_its_level_where_land_rises_above_it() {
    let field = hills();
    let at = |level: f64| WritePovray { sea_level: Some(Length::of(level)), ..WritePovray::default() };
    let scene = text(&export(&at(12.5), &field).unwrap());
    assert_eq!(declared(&scene, "SeaLevel"), 12.5);
    for write in [at(-500.0), at(500.0), WritePovray { water: false, ..at(12.5) }] {
        let out = export(&write, &field).unwrap();
        assert!(!text(&out).contains("SeaLevel"));
    }
}

#[test]
fn a_lake_lies_over_its_bed_and_under_its_shore() {
    let grid = Grid::new(Shape::new(21, 21), [10.0, 10.0]).unwrap();
    let bowl = |i: usize| grid.position(i).map(|v| (v - 100.0).abs()).into_iter().fold(0.0, f64::max);
    // A pit of 50 m in a plain at 100 m that falls to its sides.
    let z: Vec<f64> = (0..grid.len()).map(bowl).map(|d| if d < 50.0 { 50.0 + d } else { 110.0 - 0.2 * d }).collect();
    let field = HeightField::new(grid.clone(), z.clone()).unwrap();
    let out = export(&WritePovray::default(), &field).unwrap();
    let (ground, lakes) = (metres(&out, "scene_ground.png"), metres(&out, "scene_lakes.png"));
    let middle = grid.shape.index(10, 10);
    assert!(lakes[middle] > 99.0 && ground[middle] < 51.0, "{} over {}", lakes[middle], ground[middle]);
    for i in (0..grid.len()).filter(|&i| bowl(i) >= 60.0) {
        assert!(lakes[i] < ground[i], "{i}");
    }
    let dry = export(&WritePovray { water: false, ..WritePovray::default() }, &field).unwrap();
    assert!(!dry.0.contains_key("scene_lakes.png") && !text(&dry).contains("scene_lakes.png"));
}

#[test]
fn nodata_lies_at_the_least_elevation_and_is_told() {
    let mut z = hills().elevation().to_vec();
    z[5] = f64::NAN;
    let field = HeightField::new(hills().grid().clone(), z).unwrap();
    let out = export(&WritePovray::default(), &field).unwrap();
    let scene = text(&out);
    let low = field.elevation().iter().copied().fold(f64::INFINITY, f64::min);
    assert!((metres(&out, "scene_ground.png")[5] - low).abs() <= declared(&scene, "Step"));
    assert!(scene.contains("// 1 nodes without data lie at the least elevation"));
}

#[test]
fn level_ground_is_a_scene_and_a_single_node_is_not() {
    let out = export(&WritePovray::default(), &flat(Shape::new(4, 5), 7.0)).unwrap();
    let scene = text(&out);
    assert!(declared(&scene, "Step") > 0.0 && !scene.contains("NaN") && !scene.contains("inf"));
    assert!(metres(&out, "scene_ground.png").iter().all(|z| (z - 7.0).abs() <= declared(&scene, "Step")));
    for shape in [Shape::new(1, 1), Shape::new(1, 6), Shape::new(6, 1)] {
        let error = export(&WritePovray::default(), &flat(shape, 7.0)).unwrap_err();
        assert!(matches!(error, Error::NoFace { .. }) && error.hint().is_some(), "{error}");
    }
    let named = WritePovray { path: "scene.png".into(), ..WritePovray::default() };
    assert!(matches!(named.check(), Err(Error::Extension { .. })));
    for path in ["é.pov", "a\\b.pov", "a\nb.pov"] {
        let odd = WritePovray { path: path.into(), ..WritePovray::default() };
        assert!(odd.check().is_err(), "{path}");
    }
    assert!(WritePovray { path: "my scene.pov".into(), ..WritePovray::default() }.check().is_ok());
}

#[test]
fn a_title_stays_in_its_comment() {
    let field = hills();
    let title = "two\nlines";
    let mut out = MemoryOutput::default();
    let mut landscape = Landscape::plain(&field);
    landscape.title = title;
    WritePovray::default().export(&landscape, &mut out).unwrap();
    assert!(text(&out).starts_with("// two lines, seed"));
}
