//! The program as a person uses it.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on panics")]

use std::path::Path;
use std::process::{Command, Output};

fn landform(folder: &Path, args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_landform")).current_dir(folder).args(args).output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

const SMALL: &str = "seed = 3\n[[stage]]\nuse = \"stream_graph\"\nnodes = 600\nsize = [\"10 km\", \"10 km\"]\n\
[[stage]]\nuse = \"evolve\"\nclock = { dt = \"50 kyr\", duration = \"2 Myr\" }\nprocess = [ { use = \"uplift\" }, { use = \"stream_power\" } ]\n\
[[stage]]\nuse = \"write_mesh\"\npath = \"a.ply\"\n\
[[stage]]\nuse = \"to_height_field\"\ncell_size = \"200 m\"\n\
[[stage]]\nuse = \"write_raster\"\npath = \"sub/a.tif\"\n\
[[stage]]\nuse = \"write_picture\"\npath = \"a.png\"\nsize = 120\n\
[[stage]]\nuse = \"write_report\"\n";

#[test]
fn a_recipe_runs_and_runs_again_from_the_cache_to_the_same_bytes() {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("r.toml"), SMALL).unwrap();
    let first = landform(dir.path(), &["run", "r.toml", "-o", "o1", "--threads", "1"]);
    assert!(first.status.success(), "{}", text(&first.stderr));
    let again = landform(dir.path(), &["run", "r.toml", "-o", "o1"]);
    assert!(text(&again.stderr).contains("(cached)"), "{}", text(&again.stderr));
    assert!(landform(dir.path(), &["run", "r.toml", "-o", "o2", "--threads", "2", "--no-cache"]).status.success());
    for file in ["a.ply", "sub/a.tif", "a.png", "report.html"] {
        let bytes = |o: &str| std::fs::read(dir.path().join(o).join(file)).unwrap();
        assert!(bytes("o1") == bytes("o2"), "{file}");
    }
    assert!(text(&std::fs::read(dir.path().join("o1/report.html")).unwrap()).contains("Braun &amp; Willett (2013)"));
    let json = landform(dir.path(), &["run", "r.toml", "-o", "o3", "--progress", "json", "--seed", "4"]);
    assert!(text(&json.stdout).lines().all(|l| serde_json::from_str::<serde_json::Value>(l).is_ok()));
    let quiet = landform(dir.path(), &["run", "r.toml", "-o", "o4", "-q", "--set", "uplift.rate=1 mm/yr"]);
    assert!(quiet.stdout.is_empty() && quiet.stderr.is_empty() && quiet.status.success());
    let mesh = |o: &str| std::fs::read(dir.path().join(o).join("a.ply")).unwrap();
    assert!(mesh("o1") != mesh("o3") && mesh("o1") != mesh("o4"));
}

#[test]
fn errors_name_line_and_column_and_nothing_is_written() {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("r.toml"), SMALL.replace("nodes = 600", "nods = 600")).unwrap();
    let run = landform(dir.path(), &["run", "r.toml", "-o", "out"]);
    let said = text(&run.stderr);
    assert_eq!(run.status.code(), Some(1));
    assert!(said.contains("error: `stream_graph` has no parameter `nods`") && said.contains("r.toml:4:1"), "{said}");
    assert!(said.contains("hint: did you mean `nodes`?"), "{said}");
    assert!(!dir.path().join("out").exists());
    std::fs::write(dir.path().join("file"), "").unwrap();
    std::fs::write(dir.path().join("r.toml"), SMALL).unwrap();
    let blocked = landform(dir.path(), &["run", "r.toml", "-o", "file/out"]);
    assert!(text(&blocked.stderr).contains("error: cannot create folder"), "{}", text(&blocked.stderr));
    let absent = landform(dir.path(), &["run", "none.toml"]);
    assert!(text(&absent.stderr).contains("error: cannot read none.toml"));
    let huge = "[[stage]]\nuse = \"flat\"\nsize = [\"60 km\", \"60 km\"]\ncell_size = \"1 m\"\n";
    std::fs::write(dir.path().join("huge.toml"), huge.replace("60 km", "600 km").replace("1 m\"", "10 m\"")).unwrap();
    let refused = landform(dir.path(), &["run", "huge.toml"]);
    if !refused.status.success() {
        assert!(text(&refused.stderr).contains("--force"), "{}", text(&refused.stderr));
    }
}

#[cfg(unix)]
#[test]
fn an_interrupt_saves_and_resume_gives_the_same_bytes() {
    use std::io::{BufRead, BufReader};
    let dir = tempfile::tempdir().unwrap();
    let long = SMALL.replace("2 Myr", "40 Myr").replace("nodes = 600", "nodes = 3000");
    std::fs::write(dir.path().join("r.toml"), long).unwrap();
    let run = |out: &str, more: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_landform"));
        command.current_dir(dir.path()).args(["run", "r.toml", "-o", out, "--progress", "json"]).args(more);
        command
    };
    let mut child = run("o1", &[]).stdout(std::process::Stdio::piped()).spawn().unwrap();
    let mut lines = BufReader::new(child.stdout.take().unwrap()).lines().map_while(Result::ok);
    lines.find(|l| l.contains("\"event\":\"step\"")).expect("a step");
    Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    for _ in lines {}
    let status = child.wait().unwrap();
    assert_eq!(status.code(), Some(130), "interrupted before the end");
    assert!(dir.path().join("o1/.landform/checkpoint.lfc").exists());
    assert!(!dir.path().join("o1/a.ply").exists());
    assert!(run("o1", &["--resume"]).output().unwrap().status.success());
    assert!(run("o2", &[]).output().unwrap().status.success());
    let bytes = |o: &str| std::fs::read(dir.path().join(o).join("a.ply")).unwrap();
    assert!(bytes("o1") == bytes("o2"));
}

#[test]
fn the_catalogue_the_schema_and_the_sources_are_printed() {
    let dir = tempfile::tempdir().unwrap();
    let all = text(&landform(dir.path(), &["stages"]).stdout);
    assert!(all.contains("stream_power") && all.contains("evolve"));
    let one = text(&landform(dir.path(), &["stages", "stream_power"]).stdout);
    assert!(one.contains("talus_angle [deg]") && one.contains("Braun & Willett"), "{one}");
    let wrong = landform(dir.path(), &["stages", "steam_power"]);
    assert!(text(&wrong.stderr).contains("did you mean `stream_power`?"));
    let schema: serde_json::Value = serde_json::from_slice(&landform(dir.path(), &["schema"]).stdout).unwrap();
    assert_eq!(schema["title"], "landform recipe");
    assert!(landform(dir.path(), &["new", "first_mountains"]).status.success());
    assert!(!landform(dir.path(), &["new", "first_mountains"]).status.success(), "a file is not written over");
    let check = text(&landform(dir.path(), &["check", "first_mountains.toml"]).stdout);
    assert!(check.contains("evolve: uplift + stream_power") && check.contains("memory: about"), "{check}");
    assert!(text(&landform(dir.path(), &["cite", "first_mountains.toml"]).stdout).contains("Cordonnier"));
}

#[test]
fn a_recipe_runs_at_a_coarser_level_and_in_a_window() {
    let dir = tempfile::tempdir().unwrap();
    let recipe = "[[stage]]\nuse = \"noise\"\ngrid = { size = [\"4 km\", \"4 km\"], cell_size = \"100 m\" }\n\
                  [[stage]]\nuse = \"write_raster\"\npath = \"a.asc\"\n";
    std::fs::write(dir.path().join("r.toml"), recipe).unwrap();
    let sizes = |out: &str, args: &[&str]| {
        let done = landform(dir.path(), &[&["run", "r.toml", "-o", out], args].concat());
        assert!(done.status.success(), "{}", text(&done.stderr));
        let written = std::fs::read_to_string(dir.path().join(out).join("a.asc")).unwrap().to_lowercase();
        let value =
            |key: &str| written.lines().find_map(|l| l.strip_prefix(key)).unwrap().trim().parse::<usize>().unwrap();
        [value("ncols"), value("nrows")]
    };
    assert_eq!(sizes("whole", &[]), [41, 41]);
    assert_eq!(sizes("coarse", &["--level", "1/4"]), [11, 11]);
    let [cols, rows] = sizes("window", &["--region", "1km,1km,2km,3km"]);
    assert!(cols < rows && rows < 41, "{cols} x {rows}");
    let wrong = landform(dir.path(), &["run", "r.toml", "-o", "w", "--level", "1/3"]);
    assert!(!wrong.status.success() && text(&wrong.stderr).contains("1/"));
}

#[test]
fn rasters_are_converted_and_drawn() {
    let dir = tempfile::tempdir().unwrap();
    let ascii = "ncols 3\nnrows 3\nxllcenter 0\nyllcenter 0\ncellsize 10\n1 2 3\n4 9 6\n7 8 9\n";
    std::fs::write(dir.path().join("a.asc"), ascii).unwrap();
    for target in ["a.tif", "a.exr", "a.npy", "a.png", "a.r16", "a.pgm", "a.glb", "a.obj", "a.ply", "a.stl", "b.asc"] {
        let done = landform(dir.path(), &["convert", "a.asc", target]);
        assert!(done.status.success(), "{target}: {}", text(&done.stderr));
    }
    assert!(landform(dir.path(), &["convert", "a.r16", "c.asc"]).status.success());
    assert!(landform(dir.path(), &["render", "a.tif", "v.png", "--size", "64"]).status.success());
    assert!(landform(dir.path(), &["render", "a.tif", "m.png", "--size", "64", "--view", "map"]).status.success());
    let quiet = landform(dir.path(), &["render", "a.tif", "q.png", "--size", "64", "--quiet", "--threads", "1"]);
    assert!(quiet.status.success() && quiet.stdout.is_empty() && quiet.stderr.is_empty());
    let same =
        |a: &str, b: &str| std::fs::read(dir.path().join(a)).unwrap() == std::fs::read(dir.path().join(b)).unwrap();
    assert!(same("v.png", "q.png"));
    let wrong = landform(dir.path(), &["convert", "a.asc", "a.xyz"]);
    assert!(text(&wrong.stderr).contains("error:") && !wrong.status.success());
}

#[test]
fn voxels_are_written_and_read_again() {
    let dir = tempfile::tempdir().unwrap();
    let make = r#"[[stage]]
use = "rock_volume"
grid = { size = ["12 m", "9 m", "6 m"], cell_size = "1 m" }
[[stage]]
use = "write_volume"
path = "porosity.nrrd"
field = "porosity"
"#;
    // The file's own field needs no ground before it.
    let read = |path: &str| {
        format!(
            r#"[[stage]]
use = "volume_file"
path = "{path}"
empty_above = 0.99
[[stage]]
use = "write_volume"
path = "again.nrrd"
field = "porosity"
"#
        )
    };
    std::fs::write(dir.path().join("make.toml"), make).unwrap();
    let made = landform(dir.path(), &["run", "make.toml", "-o", "a", "-q"]);
    assert!(made.status.success(), "{}", text(&made.stderr));
    std::fs::write(dir.path().join("read.toml"), read("a/porosity.nrrd")).unwrap();
    let again = landform(dir.path(), &["run", "read.toml", "-o", "b", "-q"]);
    assert!(again.status.success(), "{}", text(&again.stderr));
    let bytes = |file: &str| std::fs::read(dir.path().join(file)).unwrap();
    assert!(bytes("a/porosity.nrrd") == bytes("b/again.nrrd"));
}

#[test]
fn a_value_is_fitted_to_a_target() {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("r.toml"), SMALL).unwrap();
    let over = ["fit", "r.toml", "--over", "uplift.rate=0.2 mm/yr..0.6 mm/yr"];
    let fit = |more: &[&str]| landform(dir.path(), &[&over, more].concat());
    let most = fit(&["--most", "max_m", "--runs", "5", "-o", "t.csv"]);
    assert!(most.status.success(), "{}", text(&most.stderr));
    assert_eq!(text(&most.stdout).trim(), "--set \"uplift.rate=0.6 mm/yr\"");
    let seeded = fit(&["--most", "max_m", "--runs", "2", "--seed", "5"]);
    assert!(text(&seeded.stdout).trim().ends_with(" --seed 5"), "{}", text(&seeded.stdout));
    let table = text(&std::fs::read(dir.path().join("t.csv")).unwrap());
    assert!(table.starts_with("seed,uplift.rate,min_m") && table.lines().count() == 6);
    let far = fit(&["--column", "max_m", "--target", "1e6", "--runs", "3"]);
    assert!(!far.status.success() && text(&far.stderr).contains("nearest is"), "{}", text(&far.stderr));
    assert!(text(&far.stdout).contains("--set \"uplift.rate=0.6 mm/yr\""), "the nearest is printed");
    for (more, message) in [
        (&["--most", "max"][..], "`max_m`?"),
        (&["--most", "max_m", "-o", "r.toml"], ".csv"),
        (&["--column", "max_m"], "--target"),
        (&["--most", "max_m", "--least", "min_m"], "cannot be used with"),
        (&["--most", "max_m", "--over", "uplift.rate=1..2"], "twice"),
        (&["--most", "max_m", "--over", "stream_power.talus_angle=20..30"], "talus_angle"),
    ] {
        let wrong = fit(more);
        assert!(!wrong.status.success() && text(&wrong.stderr).contains(message), "{}", text(&wrong.stderr));
    }
}

#[test]
fn a_recipe_is_varied_over_seeds_and_keys() {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("r.toml"), SMALL).unwrap();
    let args = [
        "vary",
        "r.toml",
        "-n",
        "2",
        "--over",
        "uplift.rate=0.2 mm/yr,0.6 mm/yr",
        "--sheet",
        "s.png",
        "--table",
        "t.csv",
        "--size",
        "40",
    ];
    let vary = landform(dir.path(), &args);
    assert!(vary.status.success(), "{}", text(&vary.stderr));
    let table = text(&std::fs::read(dir.path().join("t.csv")).unwrap());
    assert_eq!(table.lines().count(), 5);
    assert!(std::fs::read(dir.path().join("s.png")).unwrap().starts_with(b"\x89PNG"));
    assert!(!dir.path().join("out").exists(), "nothing is exported");
    for (over, message) in
        [("uplift.rte=1", "no parameter `rte`"), ("rate", "--over STAGE.key=a,b,c"), ("lift.rate=1", "lift")]
    {
        let vary = landform(dir.path(), &["vary", "r.toml", "--over", over]);
        assert!(!vary.status.success() && text(&vary.stderr).contains(message), "{}", text(&vary.stderr));
    }
}
