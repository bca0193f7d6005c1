//! `cargo xtask instructions`: counts the instructions of hot paths, against what was counted
//! before.
//!
//! # Method
//! Valgrind's callgrind runs each test of `hot_paths` on one thread and counts within its `hot_…`
//! function alone. Counts repeat to a few in a thousand for one toolchain on one kind of processor;
//! what the C library chooses by processor is pinned to the baseline. Counts, unlike seconds, do
//! not depend on how busy a machine is.
//!
//! Counts are kept in `benches/instructions.json`, by toolchain. One that rises by more than 3 %
//! fails, until its line is changed: `--accept` writes what is counted now, and whoever does so
//! says why in the changelog.

use std::collections::BTreeMap;
use std::process::{Command, Stdio};

use serde_json::Value;

/// Share by which a count may rise.
const MOST_RISE: f64 = 0.03;
const KEPT: &str = "benches/instructions.json";
/// Tests of `hot_paths`, and the function that is counted.
const PATHS: &[(&str, &str)] = &[
    ("route", "hot_route"),
    ("stream_power_on_a_raster", "hot_steps"),
    ("stream_power_on_a_mesh", "hot_steps"),
    ("stream_power_with_deposition", "hot_steps"),
    ("stream_power_through_beds", "hot_steps"),
    ("linear_diffusion", "hot_steps"),
    ("thermal_erosion", "hot_steps"),
    ("dunes", "hot_steps"),
    ("snow", "hot_steps"),
    ("channel_columns", "hot_steps"),
    ("channel_pipes", "hot_steps"),
    ("noise", "hot_generate"),
    ("spectral_fbm", "hot_generate"),
    ("perspective_picture", "hot_draw"),
    ("geotiff", "hot_write"),
];

type Counts = BTreeMap<String, BTreeMap<String, u64>>;

pub(crate) fn run(accept: bool) -> bool {
    let Some(binary) = test_binary() else {
        println!("the tests of hot_paths did not build");
        return false;
    };
    let toolchain = toolchain();
    let mut kept: Counts =
        std::fs::read(KEPT).ok().and_then(|text| serde_json::from_slice(&text).ok()).unwrap_or_default();
    let known = kept.remove(&toolchain).unwrap_or_default();
    if known.is_empty() && !accept {
        println!(
            "nothing was counted yet with {toolchain}; `cargo xtask instructions --accept` writes what is counted now"
        );
    }
    let (mut counted, mut good) = (BTreeMap::new(), true);
    for (test, function) in PATHS {
        let Some(count) = count(&binary, test, function) else {
            println!("{test}: not counted; is valgrind installed?");
            return false;
        };
        let before = known.get(*test).copied();
        let rise = before.map_or(0.0, |b| count as f64 / b as f64 - 1.0);
        let word = if rise > MOST_RISE { "  ROSE" } else { "" };
        let against = before.map(|b| format!("{b:>14}  {:+6.1} %", 100.0 * rise)).unwrap_or_default();
        println!("{test:<32} {count:>14} {against}{word}");
        good &= rise <= MOST_RISE;
        counted.insert(test.to_string(), count);
    }
    if accept {
        kept.insert(toolchain, counted);
        let text = serde_json::to_string_pretty(&kept).unwrap_or_default();
        return std::fs::write(KEPT, text + "\n").is_ok();
    }
    if !good {
        println!("a count rose by more than {:.0} %: win it back, or accept it and say why", 100.0 * MOST_RISE);
    }
    good
}

/// "rustc 1.95.0 x86_64".
fn toolchain() -> String {
    let version = Command::new("rustc").arg("--version").output().map(|o| o.stdout).unwrap_or_default();
    let version = String::from_utf8_lossy(&version);
    let short = version.split_whitespace().take(2).collect::<Vec<_>>().join(" ");
    format!("{short} {}", std::env::consts::ARCH)
}

fn test_binary() -> Option<String> {
    let build = Command::new("cargo")
        .args(["test", "--workspace", "--test", "hot_paths", "--no-run", "--message-format=json"])
        .stderr(Stdio::inherit())
        .output()
        .ok()?;
    let lines = String::from_utf8(build.stdout).ok()?;
    let messages = lines.lines().filter_map(|l| serde_json::from_str::<Value>(l).ok());
    messages.rev().find_map(|m| m["executable"].as_str().map(String::from))
}

fn count(binary: &str, test: &str, function: &str) -> Option<u64> {
    let run = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null", "--collect-atstart=no"])
        .arg(format!("--toggle-collect=*{function}*"))
        .args([binary, "--exact", test, "--test-threads=1"])
        .env("RAYON_NUM_THREADS", "1")
        // The C library's copies as on the oldest processors.
        .env("GLIBC_TUNABLES", "glibc.cpu.hwcaps=-AVX2,-AVX512F,-ERMS,-FSRM,-AVX_Fast_Unaligned_Load")
        .output()
        .ok()?;
    let text = String::from_utf8_lossy(&run.stderr);
    let line = text.lines().find(|l| l.contains("Collected :"))?;
    line.rsplit(':').next()?.trim().parse().ok().filter(|&n| n > 0)
}
