//! Promises about recipes and the files that they write, which no other test holds.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on panics")]

use std::path::Path;

use landform::core::terrain::NodeSurface;
use landform::core::verb::{CancelToken, MemoryOutput};
use landform::io::format::read_raster;
use landform::recipe::{AnyTerrain, Axis, Options, Override, Ran, Recipe, Signal, Sweep};

const NOISE: &str = "[[stage]]\nuse = \"noise\"\ngrid = { size = [\"4 km\", \"3 km\"], cell_size = \"200 m\" }\n\
                     amplitude = \"150 m\"\n";

fn parse(text: &str) -> landform::core::Result<Recipe> {
    Recipe::parse(text, "test", Path::new("."), &[])
}

fn run(text: &str) -> (AnyTerrain, MemoryOutput) {
    let mut out = MemoryOutput::default();
    match parse(text).unwrap().run(&mut out, &Options::default()).unwrap() {
        Ran::ToTheEnd(terrain, _) => ((*terrain).clone(), out),
        Ran::Interrupted(_) => panic!("interrupted"),
    }
}

#[test]
fn counts_are_written_as_whole_numbers() {
    let text = format!(
        "{NOISE}[[stage]]\nuse = \"drainage\"\n\
         [[stage]]\nuse = \"write_raster\"\nfield = \"receiver\"\npath = \"r.tif\"\n\
         [[stage]]\nuse = \"write_raster\"\nfield = \"receiver\"\npath = \"r.npy\"\n"
    );
    let (terrain, out) = run(&text);
    let receivers = terrain.get::<landform::core::terrain::HeightField>("test").unwrap();
    let receivers = receivers.named("receiver", "test").unwrap().to_f64();
    assert!(String::from_utf8_lossy(&out.0["r.npy"][..128]).contains("'<u4'"));
    // Tag 258, bits of a sample, is 32; tag 339, their format, is 1: whole numbers without sign.
    let tiff = &out.0["r.tif"];
    let tag = |number: u16, value: u16| {
        let [n, v] = [number.to_le_bytes(), value.to_le_bytes()];
        tiff.windows(12).any(|w| w[..2] == n && w[2..8] == [3, 0, 1, 0, 0, 0] && w[8..10] == v)
    };
    assert!(tiff.starts_with(b"II") && tag(258, 32) && tag(339, 1));
    let folder = tempfile::tempdir().unwrap();
    for name in ["r.tif", "r.npy"] {
        std::fs::write(folder.path().join(name), &out.0[name]).unwrap();
        let read = read_raster(&folder.path().join(name)).unwrap();
        assert!(read.field.elevation() == receivers, "{name}");
    }
}

#[test]
fn classes_are_written_as_bytes_with_their_legend() {
    let text = "[[stage]]\nuse = \"layered_ground\"\ngrid = { size = [\"1 km\", \"1 km\"], cell_size = \"50 m\" }\n\
                surface = { formula = \"100 + 0.2*x\", unit = \"m\" }\n\
                beds = [ { material = \"limestone\", thickness = \"30 m\" }, { material = \"shale\", thickness = \"40 m\" } ]\n\
                top = \"250 m\"\n[[stage]]\nuse = \"write_raster\"\nfield = \"surface_material\"\npath = \"m.png\"\n";
    let (_, out) = run(text);
    // Bits of a sample, and colour type grey.
    assert_eq!(out.0["m.png"][24..26], [8, 0]);
    let sidecar: serde_json::Value = serde_json::from_slice(&out.0["m.png.landform.json"]).unwrap();
    let legend = sidecar["legend"].to_string();
    assert!(legend.contains("limestone") && legend.contains("shale"), "{sidecar}");
}

#[test]
fn parts_of_a_coral_coast_are_written_as_bytes_with_their_legend() {
    let text = "[[stage]]\nuse = \"coral_island\"\ngrid = { size = [\"6 km\", \"6 km\"], cell_size = \"100 m\" }\n\
                outline = { radius = \"1.6 km\", roughness = 0.15 }\n\
                profile = [ [\"0 m\", \"600 m\"], [\"900 m\", \"180 m\"], [\"1600 m\", \"0 m\"], [\"2600 m\", \"-900 m\"] ]\n\
                [[stage]]\nuse = \"evolve\"\nclock = { dt = \"10 kyr\", duration = \"500 kyr\" }\nprocess = [\n\
                { use = \"uplift\", rate = \"-0.4 mm/yr\" },\n\
                { use = \"stream_power\", erodibility = \"1e-7 1/yr\", outlets = \"sea\" },\n\
                { use = \"reef_growth\", max_rate = \"12 mm/yr\", light = 2000, saturation = 250, extinction = \"0.1 1/m\" } ]\n\
                [[stage]]\nuse = \"write_raster\"\nfield = \"labels\"\npath = \"labels.png\"\n";
    let (terrain, out) = run(text);
    assert_eq!(out.0["labels.png"][24..26], [8, 0]);
    let sidecar: serde_json::Value = serde_json::from_slice(&out.0["labels.png.landform.json"]).unwrap();
    assert_eq!(
        (&sidecar["legend"]["4"], &sidecar["legend"]["6"]),
        (&"lagoon".into(), &"reef crest".into()),
        "{sidecar}"
    );
    let field = terrain.get::<landform::core::terrain::HeightField>("test").unwrap();
    let labels = field.named("labels", "test").unwrap().to_f64();
    for part in [1.0, 4.0, 6.0, 7.0, 8.0] {
        assert!(labels.iter().filter(|l| **l == part).count() > 10, "{part}");
    }
}

#[test]
fn old_words_are_read_with_a_note() {
    let old =
        format!("{NOISE}[[stage]]\nuse = \"threshold_erosion\"\nperturbations = 2\nshaken = 0.2\nhollows = \"end\"\n");
    let told = parse(&old).unwrap().notes.join("\n");
    assert!(["`iterations`", "`perturbed`", "`depressions`"].iter().all(|word| told.contains(word)), "{told}");
    let new = format!(
        "{NOISE}[[stage]]\nuse = \"threshold_erosion\"\niterations = 2\nperturbed = 0.2\ndepressions = \"end\"\n"
    );
    assert!(parse(&new).unwrap().notes.is_empty());
    assert!(run(&old).0 == run(&new).0);
}

#[test]
fn words_with_another_meaning_are_no_labels() {
    for label in ["environment", "materials", "grid"] {
        let text = NOISE.replace("use =", &format!("label = \"{label}\"\nuse ="));
        let error = parse(&text).unwrap_err().to_string();
        assert!(error.contains(label), "{error}");
    }
}

#[test]
fn one_file_spelt_in_two_ways_is_refused() {
    for other in ["./a.tif", "b/../a.tif", ".//a.tif"] {
        let write = |path: &str| format!("[[stage]]\nuse = \"write_raster\"\npath = \"{path}\"\n");
        let error = parse(&format!("{NOISE}{}{}", write("a.tif"), write(other))).unwrap_err().to_string();
        assert!(error.contains("both write"), "{other}: {error}");
    }
}

#[test]
fn rounds_of_cells_are_told_not_to_compare_between_levels() {
    let text = format!("{NOISE}[[stage]]\nuse = \"dunes\"\niterations = 2\n");
    let coarse = parse(&text).unwrap().at("1/2".parse().unwrap()).unwrap();
    assert!(coarse.notes.iter().any(|n| n.contains("cannot be compared")), "{:?}", coarse.notes);
}

#[test]
fn a_stage_overrides_the_environment() {
    let coast = |environment: &str, stage: &str| {
        let text = format!(
            "{environment}[[stage]]\nuse = \"noise\"\nsize = [\"4 km\", \"3 km\"]\ncell_size = \"200 m\"\namplitude = \"150 m\"\n\
             [[stage]]\nuse = \"stream_power\"\noutlets = \"sea\"\n{stage}clock = {{ dt = \"20 kyr\", iterations = 3 }}\n"
        );
        run(&text).0
    };
    let environment = "[environment]\nsea_level = \"20 m\"\n";
    let said = coast(environment, "");
    assert!(said != coast("[environment]\nsea_level = \"-30 m\"\n", ""));
    assert!(coast(environment, "sea_level = \"-30 m\"\n") == coast("[environment]\nsea_level = \"-30 m\"\n", ""));
    assert!(said == coast("", "sea_level = \"20 m\"\n"));
}

#[test]
fn a_sweep_has_a_column_for_every_number_of_every_measure() {
    let text = format!("{NOISE}[[stage]]\nuse = \"measure_summary\"\n[[stage]]\nuse = \"measure_directions\"\n");
    let load = |overrides: &[Override]| Recipe::parse(&text, "test", Path::new("."), overrides);
    let over = vec![Axis::parse("noise.hurst=0.6,0.9").unwrap()];
    let sweep = Sweep { over, ..Sweep::default() };
    let (rows, _) = sweep.run(load, None, &CancelToken::default(), |_, _| {}).unwrap();
    let table = sweep.table(&rows);
    let lines: Vec<Vec<&str>> = table.lines().map(|line| line.split(',').collect()).collect();
    let column = |name: &str| lines[0].iter().position(|c| *c == name).unwrap_or_else(|| panic!("{name}: {table}"));
    let (_, out) = run(&text);
    let mut names = Vec::new();
    for (file, json) in out.0.iter().filter(|(file, _)| file.ends_with(".json")) {
        let json: serde_json::Value = serde_json::from_slice(json).unwrap();
        let stage = if file.contains("direction") { "measure_directions" } else { "measure_summary" };
        numbers(&json, stage, &mut names);
    }
    for name in &names {
        let at = column(name);
        assert!(lines[1..].iter().all(|l| l[at].parse::<f64>().is_ok()), "{name}: {table}");
    }
    assert!(names.len() > 12, "{names:?}");
}

/// Names of all numbers of a value.
fn numbers(json: &serde_json::Value, name: &str, names: &mut Vec<String>) {
    match json {
        serde_json::Value::Number(_) => names.push(name.into()),
        serde_json::Value::Object(map) => map.iter().for_each(|(k, v)| numbers(v, &format!("{name}.{k}"), names)),
        _ => {}
    }
}

#[test]
fn planes_of_one_slope_are_told_before_and_after_the_run() {
    let text = |talus: &str| {
        format!(
            "[[stage]]\nuse = \"noise\"\ngrid = {{ size = [\"3 km\", \"3 km\"], cell_size = \"100 m\" }}\namplitude = \"20 m\"\n\
             [[stage]]\nuse = \"evolve\"\nclock = {{ dt = \"50 kyr\", iterations = 20 }}\nprocess = [ {{ use = \"uplift\", \
             rate = \"1 mm/yr\" }}, {{ use = \"stream_power\", erodibility = \"1e-6 1/yr\"{talus} }} ]\n"
        )
    };
    let notes = |talus: &str| {
        let recipe = parse(&text(talus)).unwrap();
        let planned: Vec<String> = recipe.plan(None, "").unwrap().stages.iter().flat_map(|s| s.notes.clone()).collect();
        let told = std::sync::Mutex::new(Vec::new());
        let progress = |signal: Signal| {
            if let Signal::Note(note) = signal {
                told.lock().unwrap().push(note);
            }
        };
        recipe.run(&mut MemoryOutput::default(), &Options { progress: &progress, ..Options::default() }).unwrap();
        (planned.join("\n"), told.into_inner().unwrap().join("\n"))
    };
    // A = (U/(K tan 30°))²: 1e-3/(1e-6 · .577) = 1732, squared 3 km².
    let (planned, told) = notes(", talus_angle = \"30 deg\"");
    assert!(planned.contains("3.00 km2"), "{planned}");
    assert!(told.contains(&planned) && told.contains("of the land stands at the talus angle of 30 degrees"), "{told}");
    assert_eq!(notes(""), (String::new(), String::new()));
}

#[test]
fn cells_finer_than_a_mesh_are_told() {
    let notes = |more: &str| {
        let text = format!(
            "[[stage]]\nuse = \"stream_graph\"\nsize = [\"2 km\", \"2 km\"]\nspacing = \"100 m\"\n\
             [[stage]]\nuse = \"to_height_field\"\n{more}\n"
        );
        parse(&text).unwrap().plan(None, "").unwrap().stages[1].notes.join("\n")
    };
    assert!(notes("cell_size = \"20 m\"").contains("finer than the mesh"), "{}", notes("cell_size = \"20 m\""));
    assert_eq!(notes("cell_size = \"20 m\"\nmethod = \"cubic\""), "");
    assert_eq!(notes("cell_size = \"100 m\""), "");
}
