//! The program on elevation files that stumble others.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on panics")]

use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn landform(folder: &Path, args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_landform")).current_dir(folder).args(args).output().unwrap()
}

fn said(output: &Output) -> String {
    format!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr))
}

const UTM_11: &str = r#"PROJCS["u",GEOGCS["w"],UNIT["metre",1],AUTHORITY["EPSG","32611"]]"#;
const UTM_12: &str = r#"PROJCS["u",GEOGCS["w"],UNIT["metre",1],AUTHORITY["EPSG","32612"]]"#;
const WEB: &str = r#"PROJCS["w",GEOGCS["w"],UNIT["metre",1],AUTHORITY["EPSG","3857"]]"#;
const DEGREES: &str = r#"GEOGCS["w",DATUM["d"],UNIT["degree",0.0174532925199433],AUTHORITY["EPSG","4326"]]"#;

/// A valley of 12 x 16 samples with its corner at (x, y), as an ASCII grid, and its system beside
/// it.
fn valley(folder: &Path, name: &str, (x, y, cell): (f64, f64, f64), system: &str) {
    let mut text = format!("ncols 16\nnrows 12\nxllcorner {x}\nyllcorner {y}\ncellsize {cell}\n");
    for i in 0..12 {
        for j in 0..16 {
            let z =
                100.0 + 3.0 * f64::from(11 - i) + 5.0 * f64::from(j - 8).abs() + 0.1 * f64::from((i * 7 + j * 3) % 5);
            write!(text, "{z} ").unwrap();
        }
        text.push('\n');
    }
    fs::write(folder.join(format!("{name}.asc")), text).unwrap();
    fs::write(folder.join(format!("{name}.prj")), system).unwrap();
}

#[test]
fn numbers_below_zero_are_values_and_not_options() {
    let dir = tempfile::tempdir().unwrap();
    valley(dir.path(), "a", (5e5, 4.2e6, 30.0), UTM_11);
    let apart = landform(dir.path(), &["analyze", "a.asc", "--sea-level", "-10 m"]);
    let joined = landform(dir.path(), &["analyze", "a.asc", "--sea-level=-10 m"]);
    assert!(apart.status.success() && apart.stdout == joined.stdout, "{}", said(&apart));
    let drawn = landform(dir.path(), &["render", "a.asc", "a.png", "--view", "perspective", "--from", "-20 deg"]);
    assert!(drawn.status.success(), "{}", said(&drawn));
}

#[test]
fn what_lies_apart_is_not_compared() {
    let dir = tempfile::tempdir().unwrap();
    valley(dir.path(), "a", (5e5, 4.2e6, 30.0), UTM_11);
    valley(dir.path(), "far", (9e5, 4.2e6, 30.0), UTM_11);
    valley(dir.path(), "other", (5e5, 4.2e6, 30.0), UTM_12);
    let same = landform(dir.path(), &["compare", "a.asc", "a.asc"]);
    assert!(same.status.success(), "{}", said(&same));
    for (b, words) in [("far.asc", "(900015, 4200345)"), ("other.asc", "EPSG:32612")] {
        let refused = landform(dir.path(), &["compare", "a.asc", b]);
        let text = said(&refused);
        assert_eq!(refused.status.code(), Some(1));
        assert!(text.contains(words) && text.contains("EPSG:32611") && text.contains("warp"), "{text}");
    }
}

#[test]
fn maps_of_the_web_are_told_to_be_stretched() {
    let dir = tempfile::tempdir().unwrap();
    valley(dir.path(), "web", (1e6, 8_399_600.0, 30.0), WEB);
    let measured = landform(dir.path(), &["analyze", "web.asc"]);
    let text = said(&measured);
    assert!(measured.status.success() && text.contains("2.00 times too gentle") && text.contains("UTM"), "{text}");
    let recipe = "[[stage]]\nuse = \"elevation_file\"\npath = \"web.asc\"\n";
    fs::write(dir.path().join("r.toml"), recipe).unwrap();
    let refused = landform(dir.path(), &["run", "r.toml", "-o", "out", "--no-cache"]);
    assert!(!refused.status.success() && said(&refused).contains("warp it to UTM first"), "{}", said(&refused));
}

#[test]
fn a_single_row_has_no_mesh() {
    let dir = tempfile::tempdir().unwrap();
    let row = "ncols 3\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 10\n1 2 3\n";
    fs::write(dir.path().join("row.asc"), row).unwrap();
    let recipe = "[[stage]]\nuse = \"elevation_file\"\npath = \"row.asc\"\noutlets = \"border\"\n\
                  [[stage]]\nuse = \"write_mesh\"\npath = \"m.glb\"\n";
    fs::write(dir.path().join("r.toml"), recipe).unwrap();
    for args in [&["convert", "row.asc", "m.glb"][..], &["run", "r.toml", "-o", ".", "--no-cache"]] {
        let refused = landform(dir.path(), args);
        let text = said(&refused);
        assert!(text.contains("the surface is nowhere two nodes wide: a mesh of it has no face"), "{text}");
        assert!(text.contains("two rows and two columns") && !text.contains("nodata"), "{text}");
        assert!(refused.status.code() == Some(1) && !dir.path().join("m.glb").exists());
    }
}

#[test]
fn fine_steps_at_great_heights_are_kept_or_told() {
    let dir = tempfile::tempdir().unwrap();
    let mut text = "ncols 4\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 10\n".to_string();
    (0..12).for_each(|i| write!(text, "{} ", 1e6 + f64::from(i) * 1e-3).unwrap());
    fs::write(dir.path().join("a.asc"), text).unwrap();
    for name in ["a.exr", "a.glb", "a.stl"] {
        let out = landform(dir.path(), &["convert", "a.asc", name]);
        assert!(out.status.success() && said(&out).contains("come out in steps of 0.0625 m"), "{}", said(&out));
    }
    let recipe = "[[stage]]\nuse = \"elevation_file\"\npath = \"a.asc\"\noutlets = \"border\"\n\
                  [[stage]]\nuse = \"write_mesh\"\npath = \"b.glb\"\n[[stage]]\nuse = \"write_raster\"\npath = \"b.tif\"\n";
    fs::write(dir.path().join("r.toml"), recipe).unwrap();
    let out = landform(dir.path(), &["run", "r.toml", "-o", ".", "--no-cache"]);
    assert!(out.status.success() && said(&out).contains("b.glb holds 32-bit floats"), "{}", said(&out));
    assert!(!said(&out).contains("b.tif holds"));
    let back = landform(dir.path(), &["convert", "b.tif", "c.asc"]);
    let heights = fs::read_to_string(dir.path().join("c.asc")).unwrap();
    assert!(back.status.success() && heights.contains("1000000.011"), "{heights}");
}

#[test]
fn what_came_in_degrees_goes_out_in_degrees() {
    let dir = tempfile::tempdir().unwrap();
    valley(dir.path(), "a", (10.0, 45.0, 0.000_5), DEGREES);
    let recipe = "[[stage]]\nuse = \"elevation_file\"\npath = \"a.asc\"\ndegrees_to_metres = true\noutlets = \"border\"\n\
                  [[stage]]\nuse = \"drainage\"\n[[stage]]\nuse = \"write_raster\"\npath = \"z.asc\"\n\
                  [[stage]]\nuse = \"write_contours\"\ninterval = \"10 m\"\npath = \"c.geojson\"\n";
    fs::write(dir.path().join("r.toml"), recipe).unwrap();
    let out = landform(dir.path(), &["run", "r.toml", "-o", ".", "--no-cache"]);
    assert!(out.status.success(), "{}", said(&out));
    let lines: serde_json::Value = serde_json::from_slice(&fs::read(dir.path().join("c.geojson")).unwrap()).unwrap();
    let points: Vec<[f64; 2]> = lines["features"]
        .as_array()
        .unwrap()
        .iter()
        .flat_map(|f| f["geometry"]["coordinates"].as_array().unwrap())
        .map(|p| [0, 1].map(|k| p[k].as_f64().unwrap()))
        .collect();
    let inside = |[x, y]: &[f64; 2]| (10.0..10.008).contains(x) && (45.0..45.006).contains(y);
    assert!(points.len() > 10 && points.iter().all(inside), "{points:?}");
    let again = fs::read_to_string(dir.path().join("z.asc")).unwrap();
    assert!(again.contains("xllcorner 10") && again.contains("yllcorner 45"), "{}", &again[..120]);
}
