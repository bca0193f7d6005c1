//! What a plan says of memory, against what runs take.

#![cfg(target_os = "linux")]
#![allow(clippy::unwrap_used, reason = "a test that cannot go on panics")]

use std::fs;
use std::process::Command;

/// Stages after noise on a raster of 513 by 513 nodes.
const STAGES: &[(&str, &str)] = &[
    ("drainage", ""),
    ("fill_depressions", ""),
    ("uplift", "clock = { dt = \"10 kyr\", iterations = 2 }"),
    ("stream_power", "clock = { dt = \"10 kyr\", iterations = 2 }"),
    ("linear_diffusion", "clock = { dt = \"10 kyr\", iterations = 2 }"),
    ("nonlinear_diffusion", "clock = { dt = \"1 kyr\", iterations = 2 }"),
    ("thermal_erosion", "iterations = 2"),
    ("channel_erosion", "iterations = 2"),
    ("channel_erosion", "iterations = 2\ntransport = \"pipes\""),
    ("coast_erosion", "iterations = 3\nsea_level = \"-2 km\""),
    ("stream_automaton", ""),
    ("snow", "iterations = 2"),
    ("write_raster", "path = \"a.tif\""),
    ("write_mesh", "path = \"a.glb\""),
    ("write_features", "path = \"a.geojson\""),
    ("write_picture", "path = \"a.png\"\nview = \"map\""),
];

#[test]
fn plans_say_the_memory_that_runs_take() {
    let dir = tempfile::tempdir().unwrap();
    let run = |args: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_landform"));
        let output = command.current_dir(dir.path()).args(args).output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).unwrap()
    };
    let mut wrong = Vec::new();
    for (stage, more) in STAGES {
        let text = format!(
            "seed = 1\n[[stage]]\nuse = \"noise\"\n\
             grid = {{ size = [\"10.24 km\", \"10.24 km\"], cell_size = \"20 m\" }}\n[[stage]]\nuse = \"{stage}\"\n{more}\n"
        );
        fs::write(dir.path().join("r.toml"), &text).unwrap();
        let plan = landform::recipe::Recipe::parse(&text, "r.toml", dir.path(), &[]).unwrap().plan(None, "").unwrap();
        let said = run(&["run", "r.toml", "-o", "o", "--no-cache", "--threads", "2", "--progress", "json"]);
        let done = said.lines().rfind(|l| l.contains("peak_bytes")).unwrap();
        let digits = done.split("\"peak_bytes\":").nth(1).unwrap();
        let peak: f64 = digits.chars().take_while(char::is_ascii_digit).collect::<String>().parse().unwrap();
        let share = plan.bytes as f64 / peak;
        println!("{stage} {more:?}: planned {:.2} of {:.0} MiB", share, peak / f64::from(1 << 20));
        if !(0.9..=1.3).contains(&share) {
            wrong.push(format!("{stage} {more:?}: {share:.2}"));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
