//! Height maps as engines read them: an asymmetric pattern must come back upright, in place and in
//! metres.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on panics")]

use std::collections::BTreeMap;

use landform_core::grid::{Grid, Shape};
use landform_core::terrain::{HeightField, NodeSurface};
use landform_core::verb::{Export, Landscape, MemoryOutput, Params};
use landform_io::export::{Preset, WriteHeightmap};
use landform_io::format::{Sidecar, raster_format};

/// A letter F of different heights on a ramp: no flip, turn or transpose leaves it as it is.
fn letter(n: usize) -> HeightField {
    let grid = Grid::new(Shape::new(n, n), [20.0, 20.0]).unwrap();
    let z = (0..n * n).map(|i| {
        let (row, col) = (8 * (i / n) / n, 8 * (i % n) / n);
        let stem = col == 1 && (1..7).contains(&row);
        let bars = (row == 1 && (1..6).contains(&col)) || (row == 3 && (1..4).contains(&col));
        -120.0
            + 0.5 * (i % n) as f64
            + if stem {
                300.0
            } else if bars {
                200.0
            } else {
                0.0
            }
    });
    HeightField::new(grid, z.collect()).unwrap()
}

fn export(preset: Preset, path: &str, field: &HeightField, size: Option<usize>) -> BTreeMap<String, Vec<u8>> {
    let stage = WriteHeightmap { path: path.into(), preset, size, ..WriteHeightmap::default() };
    stage.validate().unwrap();
    let mut out = MemoryOutput::default();
    let mut landscape = Landscape::plain(field);
    (landscape.seed, landscape.title) = (5, "F");
    stage.export(&landscape, &mut out).unwrap();
    out.0
}

fn card(files: &BTreeMap<String, Vec<u8>>, path: &str) -> String {
    String::from_utf8(files[&format!("{path}.md")].clone()).unwrap()
}

/// The numbers of a row of a card's table.
fn row(card: &str, name: &str) -> Vec<f64> {
    let line =
        card.lines().find(|l| l.starts_with(&format!("| {name} |"))).unwrap_or_else(|| panic!("{name} in\n{card}"));
    line.split(['|', ',']).skip(2).filter_map(|c| c.trim().parse().ok()).collect()
}

fn close(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance, "{found} {expected}");
}

#[test]
fn unreal_reads_the_letter_upright_and_in_metres() {
    let field = letter(127);
    let files = export(Preset::Unreal, "f.png", &field, None);
    let card = card(&files, "f.png");
    let (location, scale) = (row(&card, "Location"), row(&card, "Scale"));
    let raw = raster_format("f.png".as_ref()).unwrap().read(&files["f.png"], None).unwrap();
    assert_eq!(raw.grid().shape, Shape::new(127, 127));
    for i in 0..127 * 127 {
        // Unreal: Z = location + (v - 32768)/128 * scale, in cm; the first row has the least Y,
        // which is north here.
        let z = location[2] + (raw.elevation()[i] - 32_768.0) / 128.0 * scale[2];
        close(z / 100.0, field.elevation()[i], 0.01);
    }
    close(scale[0], 2000.0, 1e-6);
    close(scale[1], 2000.0, 1e-6);
    // Read back with its own sidecar it is the same land.
    let sidecar = Sidecar::parse(&files["f.png.landform.json"]).unwrap();
    let back = raster_format("f.png".as_ref()).unwrap().read(&files["f.png"], Some(&sidecar)).unwrap();
    assert!(back.elevation().iter().zip(field.elevation()).all(|(a, b)| (a - b).abs() < 0.005));
}

#[test]
fn unity_reads_the_letter_from_the_south() {
    let field = letter(129);
    let files = export(Preset::Unity, "f.raw", &field, None);
    let card = card(&files, "f.raw");
    let size = row(&card, "Terrain Size X, Y, Z");
    assert_eq!(row(&card, "Resolution"), [129.0]);
    close(size[0], 128.0 * 20.0, 1e-9);
    let base: f64 = card.split("Position Y: ").nth(1).unwrap().split(". ").next().unwrap().parse().unwrap();
    let samples: Vec<u16> = files["f.raw"].chunks(2).map(|b| u16::from_le_bytes([b[0], b[1]])).collect();
    for z in 0..129 {
        for x in 0..129 {
            // Unity: row z counts from the south, 65535 is the terrain's height.
            let height = base + f64::from(samples[z * 129 + x]) / 65_535.0 * size[1];
            close(height, field.elevation()[(128 - z) * 129 + x], 0.01);
        }
    }
}

#[test]
fn godot_blender_and_gis_get_metres() {
    let field = letter(65);
    let files = export(Preset::Godot, "f.exr", &field, None);
    assert!(card(&files, "f.exr").contains("| Vertex Spacing | 20 |"));
    let header = String::from_utf8_lossy(&files["f.exr"][..400]).into_owned();
    assert!(["R\0", "G\0", "B\0"].iter().all(|c| header.contains(c)), "three channels");
    let read = |path: &str, bytes: &[u8]| raster_format(path.as_ref()).unwrap().read(bytes, None).unwrap();
    for (files, path) in [
        (&files, "f.exr"),
        (&export(Preset::Blender, "b.exr", &field, None), "b.exr"),
        (&export(Preset::Gis, "g.tif", &field, None), "g.tif"),
    ] {
        let back = read(path, &files[path]);
        assert!(back.elevation().iter().zip(field.elevation()).all(|(a, b)| (a - b).abs() < 1e-4), "{path}");
    }
    let r16 = export(Preset::Godot, "f.r16", &field, None);
    let range = row(&card(&r16, "f.r16"), "R16 Range");
    let first = f64::from(u16::from_le_bytes([r16["f.r16"][0], r16["f.r16"][1]]));
    close(range[0] + first / 65_535.0 * (range[1] - range[0]), field.elevation()[0], 0.01);
    assert!(card(&export(Preset::Blender, "b.glb", &field, None), "b.glb").contains("glTF"));
}

#[test]
fn other_sizes_are_resampled_and_said_so() {
    let field = letter(100);
    let files = export(Preset::Unreal, "f.r16", &field, None);
    assert_eq!(files["f.r16"].len(), 2 * 127 * 127);
    let card = card(&files, "f.r16");
    assert!(card.contains("The landscape has 100 x 100 nodes; it was resampled"));
    close(row(&card, "Scale")[0], 100.0 * 99.0 * 20.0 / 126.0, 1e-3);
    let mut holes = field.elevation().to_vec();
    holes[0] = f64::NAN;
    let holes = HeightField::new(field.grid().clone(), holes).unwrap();
    let files = export(Preset::Unity, "h.raw", &holes, Some(129));
    assert!(String::from_utf8_lossy(&files["h.raw.md"]).contains("without data"));
}

#[test]
fn what_an_engine_cannot_read_is_refused() {
    for (preset, path, size, message) in [
        (Preset::Unreal, "f.exr", None, ".png or .r16"),
        (Preset::Unreal, "f_1009x1009.png", None, "one tile of many"),
        (Preset::Unreal, "f_x0_y0.png", None, "one tile of many"),
        (Preset::Unreal, "f.png", Some(1024), "one of 127, 253"),
        (Preset::Unity, "f.raw", Some(512), "33, 65"),
        (Preset::Godot, "f.png", None, ".exr or .r16"),
    ] {
        let error = WriteHeightmap { path: path.into(), preset, size, ..WriteHeightmap::default() }
            .validate()
            .unwrap_err()
            .to_string();
        assert!(error.contains(message), "{path}: {error}");
    }
}

#[test]
fn cells_stay_square_and_level_ground_has_a_range() {
    let grid = Grid::new(Shape::new(61, 101), [100.0, 100.0]).unwrap();
    let field = HeightField::new(grid, vec![5.0; 61 * 101]).unwrap();
    let files = export(Preset::Godot, "f.r16", &field, Some(65));
    let text = card(&files, "f.r16");
    assert_eq!(row(&text, "Vertex Spacing"), [156.25]);
    assert!(text.contains("| spacing | 156.25 m x 156.25 m |"), "{text}");
    assert_eq!(row(&text, "R16 Range"), [5.0, 6.0]);
    assert!(files["f.r16"].iter().all(|b| *b == 0));
    let unity = export(Preset::Unity, "f.raw", &field, None);
    assert_eq!(row(&card(&unity, "f.raw"), "Terrain Size X, Y, Z")[1], 1.0);
}

fn tiled(preset: Preset, path: &str, field: &HeightField, tiles: [usize; 2]) -> BTreeMap<String, Vec<u8>> {
    let stage = WriteHeightmap { path: path.into(), preset, tiles, ..WriteHeightmap::default() };
    stage.validate().unwrap();
    let mut out = MemoryOutput::default();
    stage.export(&Landscape::plain(field), &mut out).unwrap();
    let mut planned = stage.outputs();
    planned.retain(|name| out.0.contains_key(name));
    assert_eq!(planned.len(), out.0.len(), "what is written is planned");
    out.0
}

#[test]
fn tiles_of_unreal_share_their_borders_byte_for_byte_and_hold_the_letter() {
    let field = letter(253);
    let files = tiled(Preset::Unreal, "f.r16", &field, [2, 2]);
    let samples =
        |name: &str| -> Vec<u16> { files[name].chunks(2).map(|b| u16::from_le_bytes([b[0], b[1]])).collect() };
    let (nw, ne, sw) = (samples("f_x0_y0.r16"), samples("f_x1_y0.r16"), samples("f_x0_y1.r16"));
    assert_eq!(nw.len(), 127 * 127);
    assert!((0..127).all(|k| nw[k * 127 + 126] == ne[k * 127]), "the border of west and east");
    assert!((0..127).all(|k| nw[126 * 127 + k] == sw[k]), "the border of north and south");
    let text = card(&files, "f.r16");
    let (location, scale) = (row(&text, "Location"), row(&text, "Scale"));
    for y in 0..2 {
        for x in 0..2 {
            for (i, raw) in samples(&format!("f_x{x}_y{y}.r16")).into_iter().enumerate() {
                let z = location[2] + (f64::from(raw) - 32_768.0) / 128.0 * scale[2];
                let (r, c) = (126 * y + i / 127, 126 * x + i % 127);
                close(z / 100.0, field.elevation()[r * 253 + c], 0.01);
            }
        }
    }
    assert!(text.contains("| `f_x1_y0.r16` | 2520 | 0 |"), "{text}");
}

#[test]
fn tiles_of_unity_count_from_the_south_and_godot_regions_share_nothing() {
    let field = letter(129);
    let files = tiled(Preset::Unity, "f.raw", &field, [2, 2]);
    let text = card(&files, "f.raw");
    let size = row(&text, "Terrain Size X, Y, Z");
    assert_eq!((row(&text, "Resolution"), size[0]), (vec![65.0], 64.0 * 20.0));
    let base: f64 = text.split("Position Y: ").nth(1).unwrap().split(". ").next().unwrap().parse().unwrap();
    for z in 0..2 {
        for x in 0..2 {
            let bytes = &files[&format!("f_{x}_{z}.raw")];
            for (i, b) in bytes.chunks(2).enumerate() {
                let height = base + f64::from(u16::from_le_bytes([b[0], b[1]])) / 65_535.0 * size[1];
                let (north, east) = (64 * z + i / 65, 64 * x + i % 65);
                close(height, field.elevation()[(128 - north) * 129 + east], 0.01);
            }
        }
    }
    let files = tiled(Preset::Godot, "f.exr", &letter(128), [2, 2]);
    let read = |name: &str| raster_format("f.exr".as_ref()).unwrap().read(&files[name], None).unwrap();
    let (west, east) = (read("f_00_00.exr"), read("f_01_00.exr"));
    assert_eq!(west.grid().shape, Shape::new(64, 64));
    let whole = letter(128);
    assert!(
        (0..64).all(|r| (f64::from(whole.elevation()[r * 128 + 64] as f32) - east.elevation()[r * 64]).abs() < 1e-3)
    );
    assert!((0..64).all(|r| (whole.elevation()[r * 128 + 63] - west.elevation()[r * 64 + 63]).abs() < 1e-3));
    let one_file = WriteHeightmap { tiles: [2, 2], ..WriteHeightmap::default() };
    assert!(one_file.validate().unwrap_err().to_string().contains("takes one file"));
}

#[test]
fn a_size_that_is_not_the_landscapes_own_is_told() {
    #[derive(Default)]
    struct Notes(Vec<String>);
    impl landform_core::verb::Output for Notes {
        fn put(&mut self, _: &str, _: &[u8]) -> landform_core::Result<()> {
            Ok(())
        }
        fn note(&mut self, text: String) {
            self.0.push(text);
        }
    }
    let mut notes = Notes::default();
    let stage = WriteHeightmap { path: "f.r16".into(), preset: Preset::Unreal, ..WriteHeightmap::default() };
    stage.export(&Landscape::plain(&letter(260)), &mut notes).unwrap();
    assert_eq!(notes.0, ["f.r16: 260 x 260 nodes were resampled to 253 x 253"]);
}
