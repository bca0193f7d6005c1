//! Ground in voxels, from a recipe to files.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on panics")]

use std::path::Path;

use landform::core::parallel::with_threads;
use landform::core::terrain::{Erodible, Ground, HeightField, NodeSurface, Terrain, VoxelGrid};
use landform::core::verb::{CancelToken, MemoryOutput};
use landform::recipe::{AnyTerrain, Cache, Options, Override, Ran, Recipe, Sweep};

const RIDGE: &str = "seed = 2\n[[stage]]\nuse = \"layered_ground\"\n\
    grid = { size = [\"200 m\", \"120 m\"], cell_size = \"5 m\" }\n\
    surface = { formula = \"40 + 50*exp(-((x-100)/40)^2)\", unit = \"m\" }\n\
    beds = [ { material = \"limestone\", thickness = \"20 m\" }, { material = \"shale\", thickness = \"15 m\" } ]\n\
    top = \"100 m\"\n\
    [[stage]]\nuse = \"to_voxels\"\nvoxel_height = \"4 m\"\n\
    [[stage]]\nuse = \"tunnel\"\nalong = [[\"-10 m\", \"60 m\", \"55 m\"], [\"210 m\", \"60 m\", \"55 m\"]]\nradius = \"9 m\"\n";

fn run(text: &str, options: &Options) -> (AnyTerrain, MemoryOutput) {
    let mut out = MemoryOutput::default();
    let recipe = Recipe::parse(text, "test", Path::new("."), &[]).unwrap_or_else(|e| panic!("{e}"));
    match recipe.run(&mut out, options).unwrap() {
        Ran::ToTheEnd(terrain, _) => ((*terrain).clone(), out),
        Ran::Interrupted(_) => panic!("interrupted"),
    }
}

fn voxels(terrain: &AnyTerrain) -> &VoxelGrid {
    terrain.get::<VoxelGrid>("the test").unwrap()
}

#[test]
fn a_passage_leads_through_a_ridge_of_beds() {
    let (terrain, _) = run(RIDGE, &Options::default());
    let ground = voxels(&terrain);
    assert_eq!(terrain.nodes(), ground.plan().len() * ground.levels());
    assert!(ground.hit([2.0, 60.0, 55.0], [198.0, 60.0, 55.0]).is_none(), "one sees through");
    let beside = ground.hit([2.0, 20.0, 55.0], [198.0, 20.0, 55.0]);
    assert!(beside.is_some_and(|t| t > 0.2 && t < 0.5), "{beside:?}");
    assert!((ground.height_at([100.0, 60.0]).unwrap() - 90.0).abs() <= 2.0 + 1e-9, "the roof stands");
    let mut ground = ground.clone();
    let dug = ground.remove(landform::core::terrain::Brush { at: [100.0, 20.0, 60.0], radius: 30.0 }, 40_000.0);
    let names: Vec<&str> = dug.by_material.iter().map(|m| m.0.as_str()).collect();
    assert!(names.contains(&"limestone") && names.contains(&"shale"), "{names:?}");
}

#[test]
fn the_mesh_encloses_the_voxels_and_smooths_within_half_of_one() {
    let text = format!(
        "{RIDGE}[[stage]]\nuse = \"write_mesh\"\npath = \"a.obj\"\n\
         [[stage]]\nuse = \"write_mesh\"\npath = \"b.obj\"\nsmoothing = 8\n"
    );
    let (terrain, out) = run(&text, &Options::default());
    let ground = voxels(&terrain);
    let solid = ground.solids() as f64 * ground.voxel_volume();
    let blocks = volume(&out.0["a.obj"]);
    assert!((blocks / solid - 1.0).abs() < 1e-6, "{blocks} {solid}");
    assert!((volume(&out.0["b.obj"]) / solid - 1.0).abs() < 0.05);
    let (a, b) = (points(&out.0["a.obj"]), points(&out.0["b.obj"]));
    let near = |k: usize, side: f64| a.iter().zip(&b).all(|(p, q)| (p[k] - q[k]).abs() <= 0.5 * side + 1e-3);
    assert!(a.len() == b.len() && near(0, 5.0) && near(1, 5.0) && near(2, 4.0));
}

fn points(obj: &[u8]) -> Vec<[f64; 3]> {
    let text = std::str::from_utf8(obj).unwrap();
    let numbers = |line: &str| line.split_whitespace().skip(1).map(|v| v.parse().unwrap()).collect::<Vec<f64>>();
    text.lines().filter(|l| l.starts_with("v ")).map(numbers).map(|v| [v[0], v[1], v[2]]).collect()
}

fn volume(obj: &[u8]) -> f64 {
    let points = points(obj);
    let text = std::str::from_utf8(obj).unwrap();
    let corner = |word: &str| points[word.split('/').next().unwrap().parse::<usize>().unwrap() - 1];
    let six = |line: &str| {
        let [a, b, c]: [[f64; 3]; 3] =
            line.split_whitespace().skip(1).map(corner).collect::<Vec<_>>().try_into().unwrap();
        let cross = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]];
        a[0] * cross[0] + a[1] * cross[1] + a[2] * cross[2]
    };
    text.lines().filter(|l| l.starts_with("f ")).map(six).sum::<f64>() / 6.0
}

#[test]
fn voxels_pass_cache_and_threads_and_become_a_raster_again() {
    let folder = tempfile::tempdir().unwrap();
    let cache = Cache::on_disk(folder.path());
    let cached = || run(RIDGE, &Options { cache: Some(&cache), ..Options::default() }).0;
    let (first, again) = (cached(), cached());
    assert!(first == again);
    assert!(with_threads(3, || run(RIDGE, &Options::default()).0).unwrap() == first);
    let (raster, _) = run(&format!("{RIDGE}[[stage]]\nuse = \"uppermost_surface\"\n"), &Options::default());
    let raster = raster.get::<HeightField>("the test").unwrap();
    let bare = RIDGE.split("[[stage]]\nuse = \"tunnel\"").next().unwrap();
    let (whole, _) = run(bare, &Options::default());
    let roofed = |x: f64| raster.elevation_at([x, 60.0]);
    assert!((roofed(100.0) - voxels(&whole).height_at([100.0, 60.0]).unwrap()).abs() < 1e-9);
    assert!(roofed(40.0) <= voxels(&whole).height_at([40.0, 60.0]).unwrap(), "an open cutting at its mouth");
    assert!(raster.elevation().iter().all(|z| z.is_finite()));
    assert!(voxels(&whole).volume() > voxels(&first).volume());
}

#[test]
fn a_sweep_of_voxels_is_refused_before_it_runs() {
    let load = |overrides: &[Override]| Recipe::parse(RIDGE, "test", Path::new("."), overrides);
    let sweep = Sweep { seeds: vec![1, 2], ..Sweep::default() };
    let error = sweep.run(load, None, &CancelToken::default(), |_, _| panic!("it ran")).unwrap_err().to_string();
    assert!(error.contains("voxel grid"), "{error}");
}

#[test]
fn stages_of_surfaces_say_what_to_do_with_voxels() {
    for stage in
        ["use = \"drainage\"", "use = \"write_raster\"", "use = \"uplift\"\nclock = { dt = \"1 kyr\", iterations = 1 }"]
    {
        let text = format!("{RIDGE}[[stage]]\n{stage}\n");
        let error = Recipe::parse(&text, "test", Path::new("."), &[]).unwrap_err().to_string();
        assert!(error.contains("voxel grid") && error.contains("height field"), "{error}");
    }
}
