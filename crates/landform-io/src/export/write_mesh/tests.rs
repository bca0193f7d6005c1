use landform_core::grid::{Grid, Shape};
use landform_core::verb::MemoryOutput;
use serde_json::Value;

use super::*;

fn hills() -> HeightField {
    let grid = Grid::new(Shape::new(24, 40), [10.0; 2]).unwrap();
    let mut z: Vec<f64> = (0..grid.len()).map(|i| f64::from((i * 7919 % 101) as u32)).collect();
    z[3] = f64::NAN;
    HeightField::new(grid, z).unwrap()
}

fn chunks(bytes: &[u8]) -> (Value, Vec<u8>) {
    let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
    assert_eq!((&bytes[..4], word(4), word(8)), (&b"glTF"[..], 2, bytes.len()));
    let text = word(12);
    let json = serde_json::from_slice(&bytes[20..20 + text]).unwrap();
    let data = word(20 + text);
    assert_eq!((text % 4, data % 4, 28 + text + data), (0, 0, bytes.len()));
    (json, bytes[28 + text..].to_vec())
}

#[test]
fn a_texture_lies_on_the_nodes_and_every_view_fits_its_buffer() {
    let field = hills();
    for solid_base in [None, Some(Length::of(5.0))] {
        let mesh = WriteMesh { texture: true, solid_base, ..WriteMesh::default() };
        mesh.validate().unwrap();
        let mut out = MemoryOutput::default();
        mesh.export(&Landscape::plain(&field), &mut out).unwrap();
        let (json, data) = chunks(&out.0["terrain.glb"]);
        let view = |k: u64| {
            let view = &json["bufferViews"][k as usize];
            let at = view["byteOffset"].as_u64().unwrap() as usize;
            &data[at..at + view["byteLength"].as_u64().unwrap() as usize]
        };
        let primitive = &json["meshes"][0]["primitives"][0];
        let accessor = |name: &str| &json["accessors"][primitive["attributes"][name].as_u64().unwrap() as usize];
        let (points, places) = (accessor("POSITION"), accessor("TEXCOORD_0"));
        let faces = if solid_base.is_some() { 2 } else { 1 };
        assert_eq!((points["count"].as_u64(), places["count"].as_u64()), (Some(959 * faces), Some(959 * faces)));
        assert_eq!((places["type"].as_str(), places["componentType"].as_u64()), (Some("VEC2"), Some(5126)));
        let floats: Vec<f32> = view(places["bufferView"].as_u64().unwrap())
            .chunks(4)
            .map(|b| f32::from_le_bytes(b.try_into().unwrap()))
            .collect();
        // The first node is at the north-west: to the left and at the top.
        assert_eq!(floats[..2], [0.5 / 40.0, 0.5 / 24.0]);
        assert!(floats.iter().all(|v| (0.0..=1.0).contains(v)));
        let image = &json["images"][json["textures"][0]["source"].as_u64().unwrap() as usize];
        let png = view(image["bufferView"].as_u64().unwrap());
        let info = png::Decoder::new(std::io::Cursor::new(png)).read_info().unwrap();
        assert_eq!((info.info().width, info.info().height), (32, 32));
        assert_eq!(json["buffers"][0]["byteLength"].as_u64(), Some(data.len() as u64));
        let again = WriteMesh { path: "again.glb".into(), ..mesh };
        again.export(&Landscape::plain(&field), &mut out).unwrap();
        assert!(out.0["again.glb"] == out.0["terrain.glb"]);
    }
}

#[test]
fn colours_where_there_can_be_none_are_refused() {
    let refused = |mesh: WriteMesh| mesh.validate().unwrap_err().parameter_name().map(String::from);
    let texture = || WriteMesh { texture: true, ..WriteMesh::default() };
    assert_eq!(refused(WriteMesh { path: "a.obj".into(), ..texture() }).as_deref(), Some("texture"));
    assert_eq!(refused(WriteMesh { surface: MeshSurface::Water, ..texture() }).as_deref(), Some("texture"));
    assert_eq!(refused(WriteMesh { texture_size: Some(64), ..WriteMesh::default() }).as_deref(), Some("texture_size"));
    assert!(WriteMesh { texture_size: Some(usize::MAX), ..texture() }.validate().is_err());
}

/// Positions of a binary PLY in metres, and its triangles.
fn ply(bytes: &[u8]) -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
    let end = bytes.windows(11).position(|w| w == b"end_header\n").unwrap() + 11;
    let head = std::str::from_utf8(&bytes[..end]).unwrap();
    let count = |what: &str| {
        let line = head.lines().find(|l| l.starts_with(&format!("element {what}"))).unwrap();
        line.rsplit(' ').next().unwrap().parse::<usize>().unwrap()
    };
    let (points, faces) = bytes[end..].split_at(24 * count("vertex"));
    assert_eq!(faces.len(), 13 * count("face"));
    let number = |b: &[u8]| f64::from_le_bytes(b.try_into().unwrap());
    let corner = |b: &[u8]| u32::from_le_bytes(b.try_into().unwrap());
    let points = points.chunks(24).map(|p| [0, 8, 16].map(|k| number(&p[k..k + 8]))).collect();
    (points, faces.chunks(13).map(|f| [1, 5, 9].map(|k| corner(&f[k..k + 4]))).collect())
}

#[test]
fn levels_of_detail_keep_their_error_and_watertight_walls() {
    let grid = Grid::new(Shape::new(33, 49), [5.0; 2]).unwrap();
    let wave = |i: usize| {
        let [x, y] = grid.position(i);
        15.0 * landform_core::math::sin(x / 30.0) + 0.1 * y
    };
    let mut z: Vec<f64> = (0..grid.len()).map(wave).collect();
    z[600] = f64::NAN;
    let field = HeightField::new(grid.clone(), z.clone()).unwrap();
    let mesh = WriteMesh {
        path: "a.ply".into(),
        max_error: Some(Length::of(0.25)),
        levels: 3,
        solid_base: Some(Length::of(4.0)),
        ..WriteMesh::default()
    };
    mesh.validate().unwrap();
    assert_eq!(mesh.outputs(), ["a.ply", "a_LOD1.ply", "a_LOD2.ply"]);
    let mut out = MemoryOutput::default();
    mesh.export(&Landscape::plain(&field), &mut out).unwrap();
    let mut last = 33 * 49;
    for (path, tolerance) in mesh.outputs().iter().zip([0.25, 0.5, 1.0]) {
        let (points, triangles) = ply(&out.0[path]);
        let edges: std::collections::BTreeSet<_> =
            triangles.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]).collect();
        assert_eq!(edges.len(), 3 * triangles.len());
        assert!(edges.iter().all(|&(a, b)| edges.contains(&(b, a))), "{path} is open");
        // The upper half of the points is the ground's.
        let ground = points.len() / 2;
        assert!(ground < last, "{path}: {ground} {last}");
        last = ground;
        let top = triangles.iter().filter(|t| t.iter().all(|&i| (i as usize) < ground));
        let top: Vec<_> = top.map(|t| t.map(|i| points[i as usize])).collect();
        for i in (0..z.len()).filter(|&i| !z[i].is_nan()) {
            let p = grid.position(i);
            let cross = |u: [f64; 3], v: [f64; 3]| (u[0] - p[0]) * (v[1] - p[1]) - (u[1] - p[1]) * (v[0] - p[0]);
            let off = top.iter().filter_map(|&[a, b, c]| {
                let w = [cross(b, c), cross(c, a), cross(a, b)];
                let sum: f64 = w.iter().sum();
                let at = (w[0] * a[2] + w[1] * b[2] + w[2] * c[2]) / sum;
                w.iter().all(|v| v / sum >= -1e-9).then(|| (at - z[i]).abs())
            });
            assert!(off.fold(f64::INFINITY, f64::min) <= tolerance + 1e-9, "{path}, node {i}");
        }
    }
    let textured = WriteMesh { max_error: Some(Length::of(0.5)), texture: true, ..WriteMesh::default() };
    textured.export(&Landscape::plain(&field), &mut out).unwrap();
    let (json, _) = chunks(&out.0["terrain.glb"]);
    let count = |k: usize| json["accessors"][k]["count"].as_u64().unwrap();
    assert_eq!(count(0), count(3));
    assert!(count(0) < 800);
}

#[test]
fn errors_that_mean_nothing_are_refused() {
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(WriteMesh { max_error: Some(Length::of(bad)), ..WriteMesh::default() }.validate().is_err(), "{bad}");
    }
    for levels in [0, 2, 9, usize::MAX] {
        assert!(WriteMesh { levels, ..WriteMesh::default() }.validate().is_err(), "{levels}");
    }
    let bare = WriteMesh { max_error: Some(Length::of(1e6)), ..WriteMesh::default() };
    let lone = HeightField::new(Grid::new(Shape::new(1, 5), [1.0; 2]).unwrap(), vec![0.0; 5]).unwrap();
    assert!(bare.export(&Landscape::plain(&lone), &mut MemoryOutput::default()).is_err());
    bare.export(&Landscape::plain(&hills()), &mut MemoryOutput::default()).unwrap();
}

#[test]
fn fields_of_the_nodes_go_with_them() {
    let mut field = hills();
    let area: Vec<f64> = (0..24 * 40).map(|i| f64::from(i) * 0.5).collect();
    field.fields_mut().insert(&names::DRAINAGE_AREA, area).unwrap();
    let mut out = MemoryOutput::default();
    for path in ["a.csv", "a.ply", "a.vtk"] {
        let mesh = WriteMesh { path: path.into(), fields: vec!["drainage_area".into()], ..WriteMesh::default() };
        mesh.validate().unwrap();
        mesh.export(&Landscape::plain(&field), &mut out).unwrap();
    }
    let text = String::from_utf8(out.0["a.csv"].clone()).unwrap();
    let rows: Vec<&str> = text.lines().collect();
    // Node 3 has no data.
    assert_eq!((rows.len(), rows[0]), (960, "x_m,y_m,elevation_m,drainage_area_m2"));
    assert!(rows[3].ends_with(",1") && rows[4].ends_with(",2"), "{} {}", rows[3], rows[4]);
    let text = |path: &str| String::from_utf8_lossy(&out.0[path][..400]).to_string();
    assert!(
        text("a.ply").contains("comment drainage_area in m2\n") && text("a.ply").contains("double drainage_area\n")
    );
    // The last numbers of a file of VTK are the last field's, most significant byte first.
    let vtk = &out.0["a.vtk"];
    let end = vtk.len() - 1;
    assert_eq!(f64::from_be_bytes(vtk[end - 8..end].try_into().unwrap()), 479.5);
    let thin = WriteMesh {
        path: "thin.csv".into(),
        fields: vec!["drainage_area".into()],
        max_error: Some(Length::of(40.0)),
        ..WriteMesh::default()
    };
    thin.export(&Landscape::plain(&field), &mut out).unwrap();
    let all: std::collections::BTreeSet<&str> = rows.iter().copied().collect();
    let some = String::from_utf8(out.0["thin.csv"].clone()).unwrap();
    assert!(some.lines().count() < 900 && some.lines().all(|row| all.contains(row)));
    let refused = WriteMesh { fields: vec!["drainage_area".into()], ..WriteMesh::default() };
    assert_eq!(refused.validate().unwrap_err().parameter_name(), Some("fields"));
    let absent = WriteMesh { path: "a.csv".into(), fields: vec!["dew".into()], ..WriteMesh::default() };
    assert!(absent.export(&Landscape::plain(&field), &mut out).is_err());
}
