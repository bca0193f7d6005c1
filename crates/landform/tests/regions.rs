//! Levels and windows of recipes.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on panics")]

use std::path::Path;

use landform::core::terrain::{AnyTerrain, HeightField, NodeSurface};
use landform::core::verb::{MemoryOutput, Reach};
use landform::recipe::{GALLERY, Options, Ran, Recipe, Stage, Verb, stages};

/// Cells of a length that is no fraction of two, so that positions round.
const GROUND: &str = "seed = 3\n[[stage]]\nuse = \"noise\"\ngrid = { size = [\"4.1 km\", \"3.3 km\"], cell_size = \"98.7 m\" }\n\
                      wavelength = \"900 m\"\namplitude = \"150 m\"\n";

/// Parameters of stages beside the defaults.
const VARIANTS: &[(&str, &str)] = &[
    ("add", "elevation = { formula = \"50*u + 20*noise(300) + 0.1*z\", unit = \"m\" }"),
    ("add", "elevation = { field = \"elevation\", unit = \"m\" }"),
    ("mask", "slope = [\"5 deg\", \"40 deg\"]\naspect = [\"0 deg\", \"90 deg\"]"),
    ("derive", "fields = [\"slope\", \"local_relief\"]\nradius = \"250 m\""),
    ("blend", "mode = \"higher\"\nsoftness = \"9 m\"\nlayer = { use = \"shape\", form = \"cone\", high = \"100 m\" }"),
    ("warp", "amplitude = \"210 m\"\nwavelength = \"700 m\"\namount = { formula = \"u\" }"),
    ("shape", "form = \"steps\"\ndirection = \"30 deg\""),
    ("noise", "fractal = \"ridged\"\nwarp = \"200 m\""),
    ("surface", "elevation = { formula = \"100*r + noise()\", unit = \"m\" }"),
    ("layered_ground", "surface = { formula = \"100*v\", unit = \"m\" }\nrock = \"folded\""),
    (
        "layered_ground",
        "surface = { formula = \"100*v\", unit = \"m\" }\ntop = \"90 m\"\ndip = \"4 deg\"\n\
      layers = [ { material = \"soil\", depth = \"2 m\" } ]",
    ),
];

fn read(text: &str) -> Recipe {
    Recipe::parse(text, "test", Path::new("."), &[]).unwrap_or_else(|e| panic!("{e}\n{text}"))
}

fn run(recipe: &Recipe) -> HeightField {
    match recipe.run(&mut MemoryOutput::default(), &Options::default()).unwrap() {
        Ran::ToTheEnd(terrain, _) => match &*terrain {
            AnyTerrain::HeightField(field) => field.clone(),
            other => panic!("a {}", other.kind()),
        },
        Ran::Interrupted(_) => panic!("interrupted"),
    }
}

fn text(stage: &Stage, parameters: &str) -> String {
    let clock = "clock = { dt = \"20 kyr\", iterations = 3 }\n";
    let clock = if stage.verb == Verb::Process { clock } else { "" };
    let grid = "grid = { size = [\"4.1 km\", \"3.3 km\"], cell_size = \"98.7 m\" }\n";
    let (head, grid) = if stage.verb == Verb::Generate { ("seed = 3\n", grid) } else { (GROUND, "") };
    format!("{head}[[stage]]\nuse = \"{}\"\n{grid}{clock}{parameters}\n", stage.name)
}

#[test]
fn a_stage_that_looks_only_so_far_makes_the_same_bits_in_a_window() {
    let mut tried = 0;
    for stage in stages().filter(|s| s.verb.changes_terrain() && s.verb != Verb::Convert && s.inputs.is_empty()) {
        let of_stage = VARIANTS.iter().filter(|v| v.0 == stage.name).map(|v| v.1);
        for parameters in std::iter::once("").chain(of_stage) {
            let json = (stage.form.defaults)();
            let finite = !parameters.is_empty() || stage.read(&json).is_ok_and(|s| s.reach() != Reach::Whole);
            if !finite {
                continue;
            }
            let recipe = read(&text(stage, parameters));
            let whole = run(&recipe);
            // Two windows that overlap and together have all of the ground.
            for bounds in
                [[[0.0, 0.0], [2400.0, 3300.0]], [[1700.0, 0.0], [4100.0, 3300.0]], [[900.0, 800.0], [2e3, 2e3]]]
            {
                let part = run(&recipe.within(bounds).unwrap_or_else(|e| panic!("{} {parameters}: {e}", stage.name)));
                let [first, last] = whole.grid().nodes_within(bounds, 0.0).unwrap();
                let expected = whole.window(&whole.grid().window(first, last).unwrap()).unwrap();
                assert!(part.elevation() == expected.elevation(), "{}: {parameters}", stage.name);
                assert!(part.layers() == expected.layers(), "{}: {parameters}", stage.name);
                for (name, values) in expected.fields.iter() {
                    let same = |a: f64, b: f64| a == b || (a.is_nan() && b.is_nan());
                    let found = part.fields.find(name).unwrap().to_f64();
                    let equal = found.iter().zip(values.to_f64()).all(|(a, b)| same(*a, b));
                    assert!(equal, "{} {parameters}: {name}", stage.name);
                }
                tried += 1;
            }
        }
    }
    assert!(tried >= 3 * 16, "{tried} windows were tried");
}

#[test]
fn a_window_is_refused_where_the_whole_ground_matters() {
    let river = format!("{GROUND}[[stage]]\nuse = \"stream_power\"\nclock = {{ dt = \"1 kyr\", iterations = 1 }}\n");
    let error = read(&river).within([[0.0, 0.0], [1e3, 1e3]]).unwrap_err().to_string();
    assert!(error.contains("stream_power") && error.contains("whole ground"), "{error}");
    let error = read(GROUND).within([[9e3, 0.0], [1e4, 1e3]]).unwrap().plan(None, "").unwrap_err().to_string();
    assert!(error.contains("region"), "{error}");
    assert!(read(GROUND).within([[0.0, 0.0], [0.0, 1e3]]).is_err());
    assert!(read(GROUND).within([[0.0, f64::NAN], [2.0, 1e3]]).is_err());
}

#[test]
fn every_recipe_of_the_gallery_has_a_coarser_level() {
    let level = "1/2".parse().unwrap();
    for recipe in GALLERY {
        let whole = read(recipe.text);
        let coarse = whole.at(level).unwrap_or_else(|e| panic!("{}: {e}", recipe.name));
        let nodes = |r: &Recipe| r.plan(None, "").map(|p| p.stages.iter().map(|s| s.nodes).max().unwrap_or(0));
        // Files beside a recipe of the gallery are not here.
        if let (Ok(fine), Ok(few)) = (nodes(&whole), nodes(&coarse)) {
            let share = few as f64 / fine as f64;
            // A quarter of the nodes, of volumes an eighth.
            let is_volume = ["rock_volume", "tunnels", "to_voxels"].iter().any(|stage| recipe.text.contains(stage));
            let shares = if is_volume { 0.1..0.2 } else { 0.2..0.35 };
            assert!(shares.contains(&share), "{}: {few} of {fine}", recipe.name);
        }
    }
}

#[test]
fn a_coarser_level_is_the_same_land() {
    let recipe = read(GROUND);
    let (fine, coarse) = (run(&recipe), run(&recipe.at("1/2".parse().unwrap()).unwrap()));
    assert_eq!(coarse.grid().shape.cols, fine.grid().shape.cols.div_ceil(2));
    // Octaves below two cells are left out, so heights differ by a share of what those have.
    let off = |i: usize| (coarse.elevation()[i] - fine.elevation_at(coarse.position(i))).abs();
    let mean = (0..coarse.elevation().len()).map(off).sum::<f64>() / coarse.elevation().len() as f64;
    assert!(mean < 10.0, "{mean} m of 150");
}
