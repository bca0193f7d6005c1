//! Runs that begin on coarser cells: their rivers are the preview's.

#![allow(clippy::unwrap_used, reason = "a test may fail")]

use std::path::Path;
use std::sync::Mutex;

use landform::core::field::names;
use landform::core::terrain::{HeightField, NodeSurface, Terrain};
use landform::core::verb::MemoryOutput;
use landform::recipe::{AnyTerrain, Options, Ran, Recipe, Signal};

/// A range that rises slowly, then fast, and a part of its clock.
fn range(seed: u64, clock: &str) -> String {
    format!(
        "seed = {seed}\n[[stage]]\nuse = \"spectral_fbm\"\ngrid = {{ size = [\"7680 m\", \"7680 m\"], cell_size = \"60 m\" }}\n\
         hurst = 0.7\ndeviation = \"20 m\"\n[[stage]]\nuse = \"evolve\"\n\
         clock = {{ dt = \"20 kyr\", duration = \"4 Myr\"{clock} }}\nprocess = [\n\
         {{ use = \"uplift\", rate = {{ times = [\"0 yr\", \"3.1 Myr\", \"3.2 Myr\", \"4 Myr\"], \
            values = [\"0.12 mm/yr\", \"0.12 mm/yr\", \"0.9 mm/yr\", \"0.9 mm/yr\"] }} }},\n\
         {{ use = \"stream_power\", erodibility = \"1.5e-5 1/yr\", area_exponent = 0.45, deposition = 0.4 }},\n\
         {{ use = \"linear_diffusion\", diffusivity = \"0.02 m2/yr\" }},\n]\n"
    )
}

fn parse(text: &str) -> Recipe {
    Recipe::parse(text, "a test", Path::new("."), &[]).unwrap()
}

fn raster(recipe: &Recipe) -> HeightField {
    let Ran::ToTheEnd(terrain, _) = recipe.run(&mut MemoryOutput::default(), &Options::default()).unwrap() else {
        panic!("nobody stopped it")
    };
    let AnyTerrain::HeightField(field) = &*terrain else { panic!("not a raster") };
    field.clone()
}

/// Largest drainage area of the nodes within half a coarse cell of each coarse node.
fn on_coarse_nodes(fine: &HeightField, factor: usize) -> Vec<f64> {
    let (shape, area) = (fine.grid().shape, fine.fields().get(&names::DRAINAGE_AREA, "a test").unwrap());
    let (rows, cols) = ((shape.rows - 1) / factor + 1, (shape.cols - 1) / factor + 1);
    let near = |k: usize, of: usize| (k * factor).saturating_sub(factor / 2)..(k * factor + factor / 2 + 1).min(of);
    let largest = |i: usize| {
        let nodes = near(i / cols, shape.rows).flat_map(|r| near(i % cols, shape.cols).map(move |c| shape.index(r, c)));
        nodes.map(|node| area[node]).fold(0.0, f64::max)
    };
    (0..rows * cols).map(largest).collect()
}

/// The nodes of the largest hundredth.
fn largest_hundredth(values: &[f64]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|&a, &b| values[b].total_cmp(&values[a]));
    order.truncate(values.len() / 100);
    order
}

#[test]
fn the_rivers_of_a_build_are_those_of_its_preview() {
    for seed in [1, 2] {
        let build = parse(&range(seed, ", refine = 2"));
        let preview = raster(&build.at("1/4".parse().unwrap()).unwrap());
        let (area, cols) = (preview.fields().get(&names::DRAINAGE_AREA, "a test").unwrap(), preview.grid().shape.cols);
        let seen = largest_hundredth(area);
        let built = largest_hundredth(&on_coarse_nodes(&raster(&build), 4));
        let near = |&i: &usize| {
            let far = |a: usize, b: usize| a.abs_diff(b) * a.abs_diff(b);
            seen.iter().any(|&j| far(i / cols, j / cols) + far(i % cols, j % cols) <= 4)
        };
        let share = built.iter().filter(|i| near(i)).count() as f64 / built.len() as f64;
        assert!(share > 0.9, "seed {seed}: {share}");
    }
}

#[test]
fn a_build_goes_as_its_previews_until_its_cells_are_halved() {
    // A preview is the whole run on coarse cells; stopped at the halving it is where the build was.
    let build = parse(&range(3, ", refine = 2, refine_at = [\"1 Myr\", \"3 Myr\"]"));
    let stopped = range(3, "").replace("4 Myr\" }", "1 Myr\" }");
    let plain = raster(&parse(&stopped).at("1/4".parse().unwrap()).unwrap());
    let seen = Mutex::new(Vec::new());
    let watched = range(3, ", refine = 2, refine_at = [\"1 Myr\", \"3 Myr\"]")
        .replace("process = [", "watch = { table = \"t.csv\", every = \"1 Myr\" }\nprocess = [");
    let progress = |signal: Signal| {
        if let Signal::Step { steps, time, .. } = signal {
            seen.lock().unwrap().push((steps, time));
        }
    };
    let mut out = MemoryOutput::default();
    parse(&watched).run(&mut out, &Options { progress: &progress, ..Options::default() }).unwrap();
    // Each step is told once, and looks go on through the halvings.
    let seen = seen.into_inner().unwrap();
    assert!(seen.iter().enumerate().all(|(k, s)| s.0 == k as u64 + 1) && seen.len() == 200);
    let table = String::from_utf8(out.0["t.csv"].clone()).unwrap();
    assert_eq!(table.lines().count(), 5, "{table}");
    // The greatest height that was seen at the first halving is the preview's, but for the planes
    // between its nodes.
    let heights = |field: &HeightField| field.elevation().iter().copied().fold(0.0, f64::max);
    let column = table.lines().next().unwrap().split(',').position(|c| c.starts_with("max")).unwrap();
    let first: f64 = table.lines().nth(1).unwrap().split(',').nth(column).unwrap().parse().unwrap();
    assert!((first / heights(&plain) - 1.0).abs() < 0.2, "{first} {}", heights(&plain));
    let half = build.at("1/2".parse().unwrap()).unwrap();
    assert_eq!(raster(&half).grid().shape.rows, 65);
}

#[test]
fn beds_and_meshes_are_refined_too() {
    let bedded = "[[stage]]\nuse = \"layered_ground\"\ngrid = { size = [\"3 km\", \"3 km\"], cell_size = \"50 m\" }\n\
        surface = { formula = \"200 + 5*noise(x/400, y/400)\", unit = \"m\" }\ntop = \"400 m\"\n\
        [[stage]]\nuse = \"evolve\"\nclock = { dt = \"10 kyr\", duration = \"600 kyr\", refine = 2 }\n\
        process = [ { use = \"uplift\", rate = \"0.5 mm/yr\" }, { use = \"stream_power\" } ]\n";
    let field = raster(&parse(bedded));
    let layers = field.layers().unwrap();
    // Beds rose by 0.5 mm/yr for 600 kyr wherever the ground did.
    let middle = field.grid().shape.index(30, 30);
    assert!((layers.datum(middle).unwrap() - 700.0).abs() < 1.0, "{:?}", layers.datum(middle));
    let mesh = "seed = 4\n[[stage]]\nuse = \"stream_graph\"\nsize = [\"4 km\", \"4 km\"]\nspacing = \"80 m\"\n\
        [[stage]]\nuse = \"evolve\"\nclock = { dt = \"20 kyr\", duration = \"2 Myr\", refine = 1 }\n\
        process = [ { use = \"uplift\" }, { use = \"stream_power\" } ]\n";
    let of = |text: &str| match parse(text).run(&mut MemoryOutput::default(), &Options::default()).unwrap() {
        Ran::ToTheEnd(terrain, _) => match &*terrain {
            AnyTerrain::Mesh(mesh) => mesh.volume(),
            _ => panic!("not a mesh"),
        },
        Ran::Interrupted(_) => panic!("nobody stopped it"),
    };
    let (refined, plain) = (of(mesh), of(&mesh.replace(", refine = 1", "")));
    assert!((refined / plain - 1.0).abs() < 0.1, "{refined} {plain}");
}

#[test]
fn a_run_from_coarse_to_fine_can_be_stopped_and_resumed() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("c.lfc");
    let text = range(5, ", refine = 1, refine_at = [\"2 Myr\"]");
    let recipe = parse(&text).at("1/4".parse().unwrap()).unwrap();
    // At that level nothing is coarser; the recipe at its own level has a coarser one.
    assert_eq!(raster(&recipe), raster(&parse(&range(5, "")).at("1/4".parse().unwrap()).unwrap()));
    let recipe = parse(&text.replace("60 m", "240 m"));
    let whole = raster(&recipe);
    for (at, kept) in [(50, false), (150, true)] {
        let cancel = landform::core::verb::CancelToken::default();
        let progress = |signal: Signal| match signal {
            Signal::Step { steps, .. } if steps == at => cancel.cancel(),
            _ => {}
        };
        let options = Options {
            cancel: cancel.clone(),
            checkpoint: Some(path.clone()),
            progress: &progress,
            ..Options::default()
        };
        let ran = recipe.run(&mut MemoryOutput::default(), &options).unwrap();
        let Ran::Interrupted(left) = ran else { panic!("it was asked to stop") };
        assert_eq!((left.is_some(), path.is_file()), (kept, kept), "step {at}");
        let options = Options { checkpoint: Some(path.clone()), resume: true, ..Options::default() };
        let Ran::ToTheEnd(terrain, _) = recipe.run(&mut MemoryOutput::default(), &options).unwrap() else { panic!() };
        assert!(terrain.elevation() == whole.elevation(), "step {at}");
    }
}

#[test]
fn clocks_that_cannot_be_refined_are_refused() {
    let wrong = [
        (", iterations = 9, refine = 1", "`refine` is 1"),
        (", refine = 7", "`refine` is 7"),
        (", refine = 1, refine_at = [\"1 Myr\", \"2 Myr\"]", "`refine` is 1"),
        (", refine_at = [\"2 Myr\"]", "`refine` is 0"),
        (", refine = 2, refine_at = [\"2 Myr\", \"1 Myr\"]", "`refine_at` is 2000000 yr, 1000000 yr"),
        (", refine = 1, refine_at = [\"4 Myr\"]", "`refine_at` is 4000000 yr"),
        (", refine_at = [\"1 Myr\"], until = \"steady\"", "`refine_at`"),
    ];
    for (clock, what) in wrong {
        let error = Recipe::parse(&range(1, clock), "a test", Path::new("."), &[]).unwrap_err().to_string();
        assert!(error.contains(what), "{clock}: {error}");
    }
}

#[test]
fn what_coarser_cells_cannot_do_is_told_of_them() {
    let text = range(1, ", refine = 2").replace("deposition = 0.4", "outlets = { mask = { formula = \"x < 30\" } }");
    let text = text.replace("{ use = \"linear_diffusion\", diffusivity = \"0.02 m2/yr\" },", "");
    let one = text.replace("x < 30", "(x-1980)^2 + (y-1980)^2 < 900");
    let run = |text: &str| parse(text).run(&mut MemoryOutput::default(), &Options::default());
    assert!(run(&text).is_ok());
    let error = run(&one).unwrap_err().to_string();
    assert!(error.contains("on the coarser cells of `refine`, 4 times as long"), "{error}");
    // A window of coarser cells would lie elsewhere.
    let flat = "[[stage]]\nuse = \"flat\"\ngrid = { size = [\"3 km\", \"3 km\"], cell_size = \"50 m\" }\n\
        [[stage]]\nuse = \"uplift\"\nclock = { dt = \"10 kyr\", duration = \"100 kyr\", refine = 1 }\n";
    let within = |text: &str| parse(text).within([[100.0, 100.0], [900.0, 900.0]]);
    assert!(within(flat).is_err() && within(&flat.replace(", refine = 1", "")).is_ok());
}
