//! Every format there and back; hostile bytes get an answer.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on panics")]

use std::path::Path;

use landform_core::Error;
use landform_core::grid::{Grid, Shape};
use landform_core::random::Seed;
use landform_core::terrain::{HeightField, NodeSurface};
use landform_io::format::{
    MESH_FORMATS, RASTER_FORMATS, RasterFile, Sidecar, load_raster, mesh_file_from_height_field, raster_format,
    read_grey,
};

fn field(rows: usize, cols: usize) -> HeightField {
    let mut grid = Grid::new(Shape::new(rows, cols), [12.5, 12.5]).unwrap();
    grid.origin = [4_000.0, 9_000.0];
    // Asymmetric: a flip or a transpose cannot go unseen.
    let z = (0..grid.len()).map(|i| f64::from((i as f32).sqrt() * 31.0 - 200.0));
    HeightField::new(grid.clone(), z.collect()).unwrap()
}

fn file<'a>(field: &'a HeightField, values: &'a [f64]) -> RasterFile<'a> {
    RasterFile::real(field.grid(), values, "elevation", "m", 1)
}

#[test]
fn every_raster_format_goes_there_and_back_with_its_place() {
    for (rows, cols) in [(5, 7), (1, 1), (40, 33)] {
        let source = field(rows, cols);
        for format in RASTER_FORMATS {
            let raster = file(&source, source.elevation());
            let bytes = (format.write)(&raster).unwrap();
            let sixteen_bit = ["PNG", "PNM", "RAW16"].contains(&format.name);
            let sidecar = Sidecar::describe(&raster, sixteen_bit.then_some(65_535.0));
            let sidecar = Sidecar::parse(&sidecar.text().unwrap()).unwrap();
            let back = format.read(&bytes, format.needs_sidecar.then_some(&sidecar)).unwrap();
            assert_eq!(back.grid().shape, source.grid().shape, "{}", format.name);
            assert_eq!(back.grid().spacing, source.grid().spacing, "{}", format.name);
            for k in 0..2 {
                assert!((back.grid().origin[k] - source.grid().origin[k]).abs() < 1e-6, "{}", format.name);
            }
            let (lo, hi) = raster.range();
            let tolerance = if sixteen_bit { 0.5001 * (hi - lo) / 65_535.0 + 1e-9 } else { 0.0 };
            // Text holds as many digits as a 32-bit float has.
            let tolerance = if format.name.contains("ASCII") { 1e-4 } else { tolerance };
            for (a, b) in source.elevation().iter().zip(back.elevation()) {
                assert!((a - b).abs() <= tolerance, "{}: {a} {b}", format.name);
            }
        }
    }
}

#[test]
fn nodata_survives_where_the_format_has_it() {
    let source = field(6, 6);
    let mut values = source.elevation().to_vec();
    values[8] = f64::NAN;
    for name in ["a.tif", "a.asc", "a.exr", "a.npy", "a.nc"] {
        let format = raster_format(Path::new(name)).unwrap();
        let back = format.read(&(format.write)(&file(&source, &values)).unwrap(), None).unwrap();
        assert!(back.elevation()[8].is_nan() && !back.elevation()[9].is_nan(), "{name}");
        assert_eq!(back.nodata_count(), 1);
    }
}

/// A valid file of each format, as a start for damage.
fn samples() -> Vec<(&'static str, Vec<u8>)> {
    let source = field(24, 17);
    RASTER_FORMATS.iter().map(|f| (f.extensions[0], (f.write)(&file(&source, source.elevation())).unwrap())).collect()
}

#[test]
fn no_damage_makes_a_reader_panic() {
    for (extension, bytes) in samples() {
        let format = raster_format(Path::new(&format!("x.{extension}"))).unwrap();
        let seed = Seed(1).named(extension);
        for n in 0..bytes.len().min(400) {
            let _ = format.read(&bytes[..n * bytes.len() / bytes.len().min(400)], None);
        }
        for trial in 0..400 {
            let mut damaged = bytes.clone();
            let draws = seed.with(trial);
            for k in 0..1 + draws.bits(0) % 6 {
                let at = draws.bits(2 * k + 1) as usize % damaged.len().min(600);
                damaged[at] = draws.bits(2 * k + 2) as u8;
            }
            let _ = format.read(&damaged, None);
            let _ = read_grey(&damaged);
        }
    }
}

fn tiff_with(change: impl Fn(&mut Vec<u8>)) -> Vec<u8> {
    let mut bytes = samples().into_iter().find(|s| s.0 == "tif").unwrap().1;
    change(&mut bytes);
    bytes
}

fn npy(header: &str, data: usize) -> Vec<u8> {
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((header.len() as u16).to_le_bytes());
    bytes.extend(header.bytes());
    bytes.resize(bytes.len() + data, 0);
    bytes
}

/// Name, bytes, and a part of the message.
fn broken() -> Vec<(&'static str, Vec<u8>, &'static str)> {
    let cut = |extension: &str, part: f64| {
        let bytes = samples().into_iter().find(|s| s.0 == extension).unwrap().1;
        bytes[..(bytes.len() as f64 * part) as usize].to_vec()
    };
    vec![
        ("empty.tif", vec![], "not a readable GeoTIFF"),
        ("text.tif", b"hello, I am no TIFF at all".to_vec(), "not a readable GeoTIFF"),
        ("half.tif", cut("tif", 0.5), "not a readable GeoTIFF"),
        ("header.tif", cut("tif", 0.02), "not a readable GeoTIFF"),
        ("magic.tif", tiff_with(|b| b[2] = 99), "not a readable GeoTIFF"),
        ("directory.tif", tiff_with(|b| b[4..8].fill(0xff)), "not a readable GeoTIFF"),
        ("empty.asc", vec![], "`ncols` is missing"),
        ("word.asc", b"ncols two\nnrows 2\n".to_vec(), "`ncols` has no number"),
        ("unknown.asc", b"columns 2\nnrows 2\n".to_vec(), "header word `columns` is not known"),
        ("zero.asc", b"ncols 0\nnrows 2\ncellsize 1\n".to_vec(), "it claims 0 x 2 values"),
        ("huge.asc", b"ncols 900000\nnrows 900000\ncellsize 1\n1 2 3".to_vec(), "more than"),
        ("negative.asc", b"ncols 2\nnrows 1\ncellsize -1\n1 2\n".to_vec(), "`cellsize` is -1"),
        ("short.asc", b"ncols 2\nnrows 2\ncellsize 1\n1 2 3\n".to_vec(), "it has 3 values where the header says 4"),
        ("long.asc", b"ncols 2\nnrows 1\ncellsize 1\n1 2 3 4\n".to_vec(), "it has more values where the header says 2"),
        ("letters.asc", b"ncols 2\nnrows 1\ncellsize 1\n1 x2\n".to_vec(), "`x2` is not a number"),
        ("nodata.asc", b"ncols 2\nnrows 1\ncellsize 1\n-9999 -9999\n".to_vec(), "every cell is nodata"),
        ("binary.asc", vec![0xff, 0xfe, 0x00], "not a readable ESRI ASCII grid"),
        ("empty.exr", vec![], "not a readable OpenEXR"),
        ("half.exr", cut("exr", 0.5), "not a readable OpenEXR"),
        ("text.exr", b"no picture here".to_vec(), "not a readable OpenEXR"),
        ("empty.npy", vec![], "not a readable NumPy"),
        ("half.npy", cut("npy", 0.6), "not a readable NumPy"),
        ("flat.npy", npy("{'descr': '<f4', 'fortran_order': False, 'shape': (4,), }\n", 16), "1 dimensions"),
        ("complex.npy", npy("{'descr': '<c8', 'fortran_order': False, 'shape': (1, 2), }\n", 16), "is not read"),
        ("bomb.npy", npy("{'descr': '<f4', 'fortran_order': False, 'shape': (99999999, 99999999), }\n", 4), "claims"),
        ("empty.png", vec![], "not a readable PNG"),
        ("half.png", cut("png", 0.6), "not a readable PNG"),
        ("text.png", b"<svg></svg>".to_vec(), "not a readable PNG"),
        ("half.pgm", cut("pgm", 0.5), "not a readable PNM"),
        ("bomb.pgm", b"P5\n60000 60000\n65535\n12".to_vec(), "claims 60000 x 60000 samples"),
        ("text.pgm", b"P9 no such thing".to_vec(), "not a readable PNM"),
        ("odd.r16", vec![0; 7], "not a square of 16-bit numbers"),
        ("empty.r16", vec![], "not 0 x 0"),
        ("strange.xyz", vec![1, 2, 3], "expected a name that ends with"),
        ("noextension", vec![1, 2, 3], ".tif, .tiff"),
    ]
}

#[test]
fn broken_files_say_what_is_wrong_and_name_themselves() {
    let folder = std::env::temp_dir().join(format!("landform-broken-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let table = broken();
    assert!(table.len() >= 30);
    for (name, bytes, message) in table {
        let path = folder.join(name);
        std::fs::write(&path, bytes).unwrap();
        let text = load_raster(&path).unwrap_err().to_string();
        assert!(text.contains(message) && text.contains(name), "{name}: {text}");
    }
    std::fs::write(folder.join("side.r16"), vec![0; 8]).unwrap();
    for (sidecar, message) in [
        ("{", "sidecar"),
        (r#"{"dx_m": -4}"#, "`dx_m`, `dy_m` and `cell_deg` must be > 0"),
        (r#"{"width": 3, "height": 3}"#, "are not 3 x 3"),
    ] {
        std::fs::write(folder.join("side.landform.json"), sidecar).unwrap();
        let text = load_raster(&folder.join("side.r16")).unwrap_err().to_string();
        assert!(text.contains(message), "{sidecar}: {text}");
    }
    assert!(matches!(load_raster(&folder.join("absent.tif")), Err(Error::Io { .. })));
    std::fs::remove_dir_all(&folder).unwrap();
}

#[test]
fn mesh_files_hold_every_triangle() {
    let source = field(4, 5);
    let mesh = mesh_file_from_height_field(&source);
    assert_eq!((mesh.points.len(), mesh.triangles.len()), (20, 24));
    for format in MESH_FORMATS {
        let bytes = (format.write)(&mesh).unwrap();
        match format.extension {
            "glb" => check_glb(&bytes, &mesh.points),
            "stl" => assert_eq!(bytes.len(), 84 + 50 * 24),
            "ply" => assert!(bytes.starts_with(b"ply\n") && bytes.ends_with(&mesh.triangles[23][2].to_le_bytes())),
            "vtk" => {
                let count = |what: &[u8]| bytes.windows(what.len()).any(|w| w == what);
                assert!(count(b"POINTS 20 double\n") && count(b"\nPOLYGONS 24 96\n"));
                assert_eq!(bytes.len(), 91 + 20 * 24 + 16 + 24 * 16 + 1);
            }
            "csv" => {
                let text = String::from_utf8(bytes).unwrap();
                let rows: Vec<&str> = text.lines().collect();
                assert_eq!((rows.len(), rows[0]), (21, "x_m,y_m,elevation_m"));
                let last: Vec<f64> = rows[20].split(',').map(|v| v.parse().unwrap()).collect();
                assert_eq!(last, mesh.points[19]);
            }
            _ => {
                let text = String::from_utf8(bytes).unwrap();
                assert_eq!(text.lines().filter(|l| l.starts_with("v ")).count(), 20);
                assert_eq!(text.lines().filter(|l| l.starts_with("f ")).count(), 24);
            }
        }
    }
}

fn check_glb(bytes: &[u8], points: &[[f64; 3]]) {
    let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
    assert_eq!((&bytes[..4], word(4), word(8)), (&b"glTF"[..], 2, bytes.len()));
    let json: serde_json::Value = serde_json::from_slice(&bytes[20..20 + word(12)]).unwrap();
    assert_eq!(json["accessors"][0]["count"], points.len());
    // y is up: the greatest y is the greatest elevation.
    let top = points.iter().map(|p| p[2]).fold(f64::NEG_INFINITY, f64::max);
    assert!((json["accessors"][0]["max"][1].as_f64().unwrap() - top).abs() < 1e-3);
    let buffer = 20 + word(12) + 8;
    assert_eq!(bytes.len() - buffer, json["buffers"][0]["byteLength"].as_u64().unwrap() as usize);
}

#[test]
fn files_appear_whole_or_not_at_all() {
    let folder = std::env::temp_dir().join(format!("landform-whole-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join("a.txt");
    landform_io::files::write_whole(&path, b"one").unwrap();
    landform_io::files::write_whole(&path, b"two").unwrap();
    assert_eq!(std::fs::read(&path).unwrap(), b"two");
    assert!(landform_io::files::write_whole(&folder.join("none/b.txt"), b"x").is_err());
    assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 1, "nothing is left aside");
    std::fs::remove_dir_all(&folder).unwrap();
}
