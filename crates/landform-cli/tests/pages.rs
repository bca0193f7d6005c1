//! The pages for users: every recipe in them is read, every command is run.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on panics")]

use std::path::Path;
use std::process::Command;

/// The blocks of a page in a language.
fn blocks<'a>(page: &'a str, language: &str) -> Vec<&'a str> {
    let fence = format!("```{language}\n");
    page.split(fence.as_str()).skip(1).filter_map(|rest| rest.split("```").next()).collect()
}

/// The words of a command; quoted ones may have spaces.
fn words(line: &str) -> Vec<String> {
    let parts = line.split('"').enumerate();
    parts
        .flat_map(|(k, part)| match k % 2 {
            0 => part.split_whitespace().map(String::from).collect(),
            _ => vec![part.to_string()],
        })
        .collect()
}

/// Runs a page in an empty folder; the files that are there afterwards.
fn follow(page: &str, files: &[&str]) {
    let text = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/users").join(page));
    let (text, dir) = (text.unwrap(), tempfile::tempdir().unwrap());
    for recipe in blocks(&text, "toml") {
        let name = recipe.lines().next().unwrap().trim_start_matches("# ");
        std::fs::write(dir.path().join(name), recipe).unwrap();
    }
    let commands: Vec<&str> = blocks(&text, "sh").into_iter().flat_map(str::lines).collect();
    assert!(commands.len() > 3, "{page}: {commands:?}");
    for command in commands {
        let words = words(command);
        assert_eq!(words[0], "landform", "{page}: {command}");
        let run = Command::new(env!("CARGO_BIN_EXE_landform")).current_dir(&dir).args(&words[1..]).output().unwrap();
        assert!(run.status.success(), "{page}: {command}\n{}", String::from_utf8_lossy(&run.stderr));
    }
    for file in files {
        assert!(dir.path().join(file).is_file(), "{page}: no {file}");
    }
}

#[test]
fn a_world_builder_gets_what_the_page_promises() {
    let weights = ["rock.png", "sediment.png", "grass.png", "weights.md"].map(|file| format!("out/weights/{file}"));
    let mut files: Vec<&str> = weights.iter().map(String::as_str).collect();
    files.extend([
        "seeds.png",
        "seeds.csv",
        "out/height.png",
        "out/height.png.md",
        "out/trees.csv",
        "out/trees.csv.md",
    ]);
    files.extend(["out/splines.json", "out/splines.json.md", "out/land.glb", "out/valley.png", "steeper/land.glb"]);
    follow("world_builders.md", &files);
}

#[test]
fn a_geomorphologist_gets_what_the_page_promises() {
    let files = ["out/drainage.json", "out/report.html", "runs.csv", "numbers.json", "measured.html", "difference.png"];
    follow(
        "geomorphologists.md",
        &[&files[..], &["out/profiles.csv", "out/swath.csv", "out/steady.vtk", "out/steady.nc"]].concat(),
    );
}

#[test]
fn a_roboticist_gets_what_the_page_promises() {
    let files = ["gazebo/world.sdf", "gazebo/world_heights.png", "gazebo/world.sdf.md", "mujoco/world.xml"];
    let more = ["mujoco/world.hfield", "isaac/world.usda", "isaac/world_colours.png", "ground_LOD2.stl", "stones.csv"];
    let files: Vec<String> = files.iter().chain(&more).map(|file| format!("out/{file}")).collect();
    let mut files: Vec<&str> = files.iter().map(String::as_str).collect();
    files.extend(["field_4/mujoco/world.hfield", "rough/gazebo/world.sdf"]);
    follow("simulation.md", &files);
}
