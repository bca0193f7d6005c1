//! The program where something goes wrong around it: kills, full disks, closed outputs, damaged
//! files.

#![cfg(unix)]
#![allow(clippy::unwrap_used, reason = "a test that cannot go on panics")]

use std::fs::{self, File};
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

fn landform(folder: &Path, args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_landform"));
    command.current_dir(folder).args(args);
    command
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// A small recipe of so many steps.
fn recipe(steps: u32) -> String {
    format!(
        "seed = 3\n[[stage]]\nuse = \"noise\"\ngrid = {{ size = [\"4 km\", \"4 km\"], cell_size = \"200 m\" }}\n\
         [[stage]]\nuse = \"evolve\"\nclock = {{ dt = \"1 kyr\", iterations = {steps} }}\n\
         watch = {{ table = \"t.csv\", frames = \"f.png\", steps = {}, size = 16 }}\n\
         process = [ {{ use = \"uplift\" }}, {{ use = \"stream_power\" }} ]\n\
         [[stage]]\nuse = \"write_raster\"\npath = \"sub/a.tif\"\n",
        steps / 4
    )
}

fn folder_with(steps: u32) -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join("r.toml"), recipe(steps)).unwrap();
    dir
}

/// All files below a folder, hidden ones too.
fn files(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        match path.is_dir() {
            true => found.extend(files(&path)),
            false => found.push(path),
        }
    }
    found.sort();
    found
}

#[test]
fn a_killed_run_goes_on_to_the_same_bytes() {
    let dir = folder_with(4_000);
    let run = |out: &str, more: &[&str]| {
        let args = ["run", "r.toml", "-o", out, "--progress", "json", "--checkpoint-every", "0 s"];
        let mut command = landform(dir.path(), &args);
        command.args(more);
        command
    };
    let mut child = run("o1", &[]).stdout(Stdio::piped()).spawn().unwrap();
    let mut lines = BufReader::new(child.stdout.take().unwrap()).lines().map_while(Result::ok);
    lines.find(|l| l.contains("\"event\":\"step\"")).expect("a step");
    let checkpoint = dir.path().join("o1/.landform/checkpoint.lfc");
    while !checkpoint.exists() && child.try_wait().unwrap().is_none() {
        std::thread::yield_now();
    }
    child.kill().unwrap();
    assert!(!child.wait().unwrap().success(), "killed before the end");
    assert!(checkpoint.exists());
    let again = run("o1", &["--resume"]).output().unwrap();
    assert!(again.status.success(), "{}", said(&again));
    let steps = String::from_utf8(again.stdout).unwrap();
    assert!(!steps.contains("\"steps\":1,"), "it begins where it was: {}", steps.lines().nth(2).unwrap_or_default());
    assert!(landform(dir.path(), &["run", "r.toml", "-o", "o2", "-q"]).status().unwrap().success());
    for file in ["t.csv", "f_0001.png", "f_0004.png", "sub/a.tif"] {
        let bytes = |out: &str| fs::read(dir.path().join(out).join(file)).unwrap();
        assert!(bytes("o1") == bytes("o2"), "{file}");
    }
    let odd: Vec<_> =
        files(&dir.path().join("o1")).into_iter().filter(|f| f.to_string_lossy().contains(".part")).collect();
    assert!(odd.is_empty(), "{odd:?}");
}

#[test]
fn what_a_run_killed_in_its_first_checkpoint_left_goes() {
    let dir = folder_with(4);
    let state = dir.path().join("o/.landform");
    fs::create_dir_all(state.join("checkpoint.watch")).unwrap();
    // No process has this number.
    for left in
        [".checkpoint.lfc.4000000000.landform.part", "checkpoint.watch/.000000000004.lfc.4000000000.landform.part"]
    {
        fs::write(state.join(left), b"half").unwrap();
    }
    assert!(landform(dir.path(), &["run", "r.toml", "-o", "o", "-q", "--resume"]).status().unwrap().success());
    let left: Vec<_> =
        files(&dir.path().join("o")).into_iter().filter(|f| f.to_string_lossy().contains(".part")).collect();
    assert!(left.is_empty(), "{left:?}");
}

/// Kills runs at random moments, resumes each, and compares the files with those of a run that was
/// left alone. Some in the tests; `cargo xtask validate` sets `LANDFORM_KILLS`.
#[test]
fn runs_killed_at_any_moment_go_on_to_the_same_bytes() {
    let count = std::env::var("LANDFORM_KILLS").ok().and_then(|n| n.parse().ok()).unwrap_or(4);
    let dir = folder_with(2_000);
    let begun = std::time::Instant::now();
    assert!(landform(dir.path(), &["run", "r.toml", "-o", "whole", "-q", "--no-cache"]).status().unwrap().success());
    let whole = begun.elapsed();
    let kept = ["t.csv", "f_0001.png", "f_0004.png", "sub/a.tif"];
    let bytes = |out: &str| kept.map(|file| fs::read(dir.path().join(out).join(file)).unwrap());
    let wanted = bytes("whole");
    let mut finished = 0;
    for k in 0..count {
        let out = format!("o{k}");
        let args = ["run", "r.toml", "-o", &out, "-q", "--checkpoint-every", "0 s"];
        let mut child = landform(dir.path(), &args).spawn().unwrap();
        // Moments spread over twice the time, since checkpoints take some of it too.
        let part = (k as f64 * 0.618_033_988_75).fract();
        std::thread::sleep(whole.mul_f64(2.0 * part));
        child.kill().unwrap();
        finished += usize::from(child.wait().unwrap().success());
        let again = landform(dir.path(), &["run", "r.toml", "-o", &out, "-q", "--resume"]).output().unwrap();
        assert!(again.status.success(), "kill {k}: {}", said(&again));
        assert!(bytes(&out) == wanted, "kill {k} at {part:.3} of two runs");
        let left: Vec<_> =
            files(&dir.path().join(&out)).into_iter().filter(|f| f.to_string_lossy().contains(".part")).collect();
        assert!(left.is_empty(), "kill {k}: {left:?}");
        fs::remove_dir_all(dir.path().join(&out)).unwrap();
    }
    println!("{count} kills, {finished} of them after the end");
}

#[test]
fn the_time_between_checkpoints_has_a_unit() {
    let dir = folder_with(4);
    for wrong in ["30", "-1 s", "3 km", "often"] {
        let run = landform(dir.path(), &["run", "r.toml", &format!("--checkpoint-every={wrong}")]).output().unwrap();
        assert!(run.status.code() == Some(2) && said(&run).contains("write 30 s or 10 min"), "{}", said(&run));
    }
    assert!(landform(dir.path(), &["run", "r.toml", "--checkpoint-every", "30s"]).output().unwrap().status.success());
}

#[test]
fn what_killed_runs_left_unfinished_is_swept_and_nothing_else() {
    let dir = folder_with(4);
    let mut gone = Command::new("true").spawn().unwrap();
    gone.wait().unwrap();
    let (dead, lives) = (gone.id(), std::process::id());
    let out = dir.path().join("out");
    fs::create_dir_all(out.join(".landform/cache")).unwrap();
    fs::create_dir_all(out.join("sub")).unwrap();
    let names = |process: u32| {
        [
            format!(".t.csv.{process}.landform.part"),
            format!("sub/.a.tif.{process}.landform.part"),
            format!(".landform/cache/.k.lfc.{process}.landform.part"),
            format!(".landform-probe.{process}"),
        ]
    };
    let others = [format!(".t.csv.{dead}.part"), "t.csv.landform.part".into(), ".x.y.landform.part".into()];
    for name in names(dead).iter().chain(&names(lives)).chain(&others) {
        fs::write(out.join(name), "half").unwrap();
    }
    assert!(landform(dir.path(), &["run", "r.toml"]).output().unwrap().status.success());
    for name in names(dead) {
        assert!(!out.join(&name).exists(), "{name}");
    }
    for name in names(lives).iter().chain(&others) {
        assert!(out.join(name).exists(), "{name}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_behind_the_output_is_an_error() {
    let dir = folder_with(4);
    let full = || File::options().write(true).open("/dev/full").unwrap();
    let all = [
        &["stages"][..],
        &["schema"],
        &["check", "r.toml"],
        &["completions", "bash"],
        &["cite", "r.toml"],
        &["cache", "out"],
        &["--help"],
        &["--version"],
        &["run", "r.toml"],
        &["run", "r.toml", "--progress", "json"],
    ];
    for args in all {
        let done = landform(dir.path(), args).stdout(full()).output().unwrap();
        assert_eq!(done.status.code(), Some(1), "{args:?}: {}", said(&done));
        assert!(said(&done).contains("cannot write to standard output"), "{args:?}: {}", said(&done));
    }
    assert!(dir.path().join("out/sub/a.tif").exists(), "a run goes on to its end");
}

#[cfg(target_os = "linux")]
#[test]
fn a_run_does_not_need_its_error_output() {
    let dir = folder_with(4);
    for style in ["plain", "bar", "json"] {
        let program = env!("CARGO_BIN_EXE_landform");
        for to in ["2>/dev/full", "2>&-", ">&- 2>&-"] {
            let line = format!("exec {program} run r.toml -o out --no-cache --progress {style} {to}");
            let done = Command::new("sh").current_dir(dir.path()).args(["-c", &line]).output().unwrap();
            assert!(done.status.success(), "{style} {to}: {:?} {}", done.status, said(&done));
            assert!(dir.path().join("out/sub/a.tif").exists(), "{style} {to}");
            fs::remove_dir_all(dir.path().join("out")).unwrap();
        }
    }
    let wrong = format!("exec {} run none.toml 2>/dev/full", env!("CARGO_BIN_EXE_landform"));
    let done = Command::new("sh").current_dir(dir.path()).args(["-c", &wrong]).status().unwrap();
    assert_eq!(done.code(), Some(1), "what is wrong stays wrong");
}

#[test]
fn check_knows_what_is_whole_in_the_cache() {
    let dir = folder_with(4);
    assert!(landform(dir.path(), &["run", "r.toml"]).output().unwrap().status.success());
    let lines = || {
        let check = landform(dir.path(), &["check", "r.toml", "-o", "out"]).output().unwrap();
        let text = String::from_utf8(check.stdout).unwrap();
        text.lines().filter(|l| l.contains("noise") || l.contains("evolve")).map(String::from).collect::<Vec<_>>()
    };
    let whole = lines();
    assert!(whole[0].ends_with("  cached") && whole[1].contains("runs again for `watch`"), "{whole:?}");
    for file in files(&dir.path().join("out/.landform/cache")).iter().filter(|f| !f.to_string_lossy().contains("event"))
    {
        let mut bytes = fs::read(file).unwrap();
        let middle = bytes.len() / 2;
        bytes[middle] ^= 1;
        fs::write(file, bytes).unwrap();
    }
    let damaged = lines();
    assert!(damaged.iter().all(|line| line.contains("damaged in the cache")), "{damaged:?}");
}

#[test]
fn rounds_are_not_told_as_years() {
    let dir = tempfile::tempdir().unwrap();
    let text = "[[stage]]\nuse = \"flat\"\ngrid = { size = [\"200 m\", \"200 m\"], cell_size = \"10 m\" }\n\
                [[stage]]\nuse = \"thermal_erosion\"\niterations = 3\n";
    fs::write(dir.path().join("r.toml"), text).unwrap();
    let run =
        |style: &str| landform(dir.path(), &["run", "r.toml", "--no-cache", "--progress", style]).output().unwrap();
    let plain = said(&run("plain"));
    assert!(plain.contains("after 3 steps; mass"), "{plain}");
    let json = String::from_utf8(run("json").stdout).unwrap();
    let outcome = json.lines().find(|l| l.contains("\"outcome\"")).unwrap();
    assert!(outcome.contains("\"years\":null"), "{outcome}");
}
