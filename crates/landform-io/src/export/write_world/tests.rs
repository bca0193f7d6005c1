use std::collections::BTreeMap;

use landform_core::grid::{Grid, Shape};
use landform_core::verb::MemoryOutput;

use super::*;

/// A slope to the east with a ridge in the south-west: no flip, turn or transpose leaves it as it
/// is.
fn land(rows: usize, cols: usize) -> HeightField {
    let grid = Grid::new(Shape::new(rows, cols), [4.0, 4.0]).unwrap();
    let height = |i: usize| {
        let cell = grid.shape.cell(i);
        let ridge = if cell.row == rows - 3 && cell.col < cols / 2 { 25.0 } else { 0.0 };
        -7.0 + 0.5 * cell.col as f64 + ridge
    };
    let z = (0..grid.len()).map(height).collect();
    HeightField::new(grid, z).unwrap()
}

fn files(stage: &WriteWorld, field: &HeightField) -> BTreeMap<String, Vec<u8>> {
    stage.validate().unwrap();
    let mut out = MemoryOutput::default();
    stage.export(&Landscape::plain(field), &mut out).unwrap();
    let mut promised = stage.outputs();
    promised.sort();
    assert_eq!(out.0.keys().cloned().collect::<Vec<_>>(), promised);
    out.0
}

fn string(files: &BTreeMap<String, Vec<u8>>, path: &str) -> String {
    String::from_utf8(files[path].clone()).unwrap()
}

/// Numbers between two marks of a text, after a word.
fn numbers(text: &str, after: &str, open: &str, close: &str) -> Vec<f64> {
    let rest = &text[text.find(after).unwrap_or_else(|| panic!("{after} in\n{text}"))..];
    let rest = &rest[rest.find(open).unwrap() + open.len()..];
    let inside = &rest[..rest.find(close).unwrap()];
    inside.split(|c: char| c.is_whitespace() || "(),".contains(c)).filter_map(|w| w.parse().ok()).collect()
}

#[test]
fn gazebo_has_the_land_at_its_metres() {
    let field = land(65, 65);
    let files = files(&WriteWorld { path: "w/land.sdf".into(), texture: true, ..WriteWorld::default() }, &field);
    let sdf = string(&files, "w/land.sdf");
    assert_eq!(numbers(&sdf, "<size>", ">", "<"), [256.0, 256.0, 40.5]);
    // The collision and the visual stand equally high.
    assert_eq!(numbers(&sdf, "<collision name", "<pose>", "</pose>"), [0.0, 0.0, -7.0, 0.0, 0.0, 0.0]);
    assert_eq!(numbers(&sdf, "<visual", "<pos>", "</pos>"), [0.0, 0.0, -7.0]);
    assert_eq!(numbers(&sdf, "<collision name", "<pos>", "</pos>"), [0.0; 3]);
    assert!(sdf.contains("<uri>land_heights.png</uri>") && sdf.contains("<diffuse>land_colours.png</diffuse>"));
    let mut reader = png::Decoder::new(std::io::Cursor::new(&files["w/land_heights.png"])).read_info().unwrap();
    assert_eq!((reader.info().width, reader.info().height, reader.info().bit_depth), (65, 65, png::BitDepth::Sixteen));
    let mut pixels = vec![0; 65 * 65 * 2];
    reader.next_frame(&mut pixels).unwrap();
    let pixel = |i: usize| f64::from(u16::from_be_bytes([pixels[2 * i], pixels[2 * i + 1]]));
    for (i, z) in field.elevation().iter().enumerate() {
        let back = -7.0 + 40.5 * pixel(i) / 65_535.0;
        assert!((back - z).abs() < 40.5 / 65_535.0, "{i}: {back} {z}");
    }
    assert!(string(&files, "w/land.sdf.md").contains("| heights | -7 m to 33.5 m |"));
}

#[test]
fn gazebo_gets_a_size_it_takes_or_a_mesh() {
    let field = land(50, 70);
    let map = files(&WriteWorld::default(), &field);
    let info = png::Decoder::new(std::io::Cursor::new(&map["world_heights.png"])).read_info().unwrap();
    assert_eq!((info.info().width, info.info().height), (65, 65));
    let mesh = files(&WriteWorld { max_error: Some(Length::of(0.5)), ..WriteWorld::default() }, &field);
    let stl = &mesh["world_ground.stl"];
    let triangles: Vec<&[u8]> = stl[84..].chunks(50).collect();
    assert!(triangles.len() < 2 * 49 * 69 / 2);
    let number = |b: &[u8]| f32::from_le_bytes(b.try_into().unwrap());
    let axis = |k: usize| {
        let all = triangles.iter().flat_map(move |t| [12, 24, 36].map(|at| number(&t[at + 4 * k..at + 4 * k + 4])));
        all.fold((f32::INFINITY, f32::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)))
    };
    assert_eq!((axis(0), axis(1)), ((-138.0, 138.0), (-98.0, 98.0)));
    assert_eq!(string(&mesh, "world.sdf").matches("<mesh><uri>world_ground.stl</uri></mesh>").count(), 2);
}

#[test]
fn mujoco_reads_rows_from_the_south() {
    let field = land(20, 30);
    let files =
        files(&WriteWorld { preset: Simulator::Mujoco, path: "world.xml".into(), ..WriteWorld::default() }, &field);
    let (xml, bytes) = (string(&files, "world.xml"), &files["world.hfield"]);
    let (lo, hi) = range(&field);
    let size = numbers(&xml, "size=", "\"", "\"");
    assert_eq!(size[..3], [58.0, 38.0, hi - lo]);
    assert_eq!(numbers(&xml, "pos=\"0 0 -", "\"", "\""), [0.0, 0.0, lo]);
    let count = |at: usize| i32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
    assert_eq!((count(0), count(4), bytes.len()), (20, 30, 8 + 4 * 600));
    for (i, z) in field.elevation().iter().enumerate() {
        let cell = field.grid().shape.cell(i);
        let at = 8 + 4 * ((19 - cell.row) * 30 + cell.col);
        let back = lo + size[2] * f64::from(f32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()));
        assert!((back - z).abs() < 1e-5);
    }
}

#[test]
fn usd_has_the_mesh_its_numbers_say() {
    let mut field = land(20, 30);
    for max_error in [None, Some(Length::of(0.5))] {
        let stage = WriteWorld {
            preset: Simulator::Usd,
            path: "world.usda".into(),
            texture: max_error.is_some(),
            max_error,
            ..WriteWorld::default()
        };
        let files = files(&stage, &field);
        let text = string(&files, "world.usda");
        assert!(text.starts_with("#usda 1.0\n") && text.contains("metersPerUnit = 1\n"));
        let points = numbers(&text, "point3f[] points", " = [", "]").len() / 3;
        let corners = numbers(&text, "faceVertexIndices", " = [", "]");
        assert_eq!(corners.len(), 3 * numbers(&text, "faceVertexCounts", " = [", "]").len());
        assert!(corners.iter().all(|&i| (i as usize) < points));
        assert_eq!(numbers(&text, "float3[] extent", " = [", "]"), [-58.0, -38.0, -7.0, 58.0, 38.0, 25.0]);
        if max_error.is_some() {
            assert!(points < 300);
            assert_eq!(numbers(&text, "primvars:st", " = [", "]").len(), 2 * points);
            assert!(text.contains("@./world_colours.png@"));
        } else {
            assert_eq!((points, corners.len()), (600, 3 * 2 * 19 * 29));
        }
    }
    // A hole stays open.
    field = land(20, 30);
    let mut z = field.elevation().to_vec();
    z[310] = f64::NAN;
    field = HeightField::new(field.grid().clone(), z).unwrap();
    let stage = WriteWorld { preset: Simulator::Usd, path: "a.usda".into(), ..WriteWorld::default() };
    let text = string(&files(&stage, &field), "a.usda");
    assert_eq!(numbers(&text, "faceVertexCounts", " = [", "]").len(), 2 * 19 * 29 - 6);
}

#[test]
fn what_no_simulator_reads_is_refused() {
    let refused = |stage: WriteWorld| stage.validate().unwrap_err().parameter_name().map(String::from);
    let gazebo = WriteWorld::default;
    let mujoco = || WriteWorld { preset: Simulator::Mujoco, path: "a.xml".into(), ..gazebo() };
    let error = Some(Length::of(1.0));
    assert_eq!(refused(WriteWorld { path: "a.xml".into(), ..gazebo() }).as_deref(), Some("path"));
    assert_eq!(refused(WriteWorld { path: "a b@.sdf".into(), ..gazebo() }).as_deref(), Some("path"));
    assert_eq!(refused(WriteWorld { size: Some(64), ..gazebo() }).as_deref(), Some("size"));
    assert_eq!(refused(WriteWorld { size: Some(65), max_error: error, ..gazebo() }).as_deref(), Some("size"));
    assert_eq!(refused(WriteWorld { texture: true, max_error: error, ..gazebo() }).as_deref(), Some("texture"));
    assert_eq!(refused(WriteWorld { max_error: error, ..mujoco() }).as_deref(), Some("max_error"));
    assert_eq!(refused(WriteWorld { size: Some(65), ..mujoco() }).as_deref(), Some("size"));
    assert!(WriteWorld { size: Some(usize::MAX), ..gazebo() }.validate().is_err());
    let grid = |rows, cols| Grid::new(Shape::new(rows, cols), [1.0; 2]).unwrap();
    for field in [HeightField::new(grid(1, 4), vec![0.0; 4]).unwrap(), HeightField::new(grid(1, 1), vec![0.0]).unwrap()]
    {
        assert!(gazebo().export(&Landscape::plain(&field), &mut MemoryOutput::default()).is_err());
    }
    // Level ground is a world.
    let level = HeightField::new(grid(40, 40), vec![12.5; 1600]).unwrap();
    let sdf = string(&files(&gazebo(), &level), "world.sdf");
    assert_eq!(numbers(&sdf, "<pose>0 0 12", "<pose>", "</pose>")[2], 12.5);
    files(&mujoco(), &level);
}
