//! What every stage must keep, swept over the table of stages.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on panics")]

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use landform::core::grid::{Domain, Status};
use landform::core::parallel::with_threads;
use landform::core::random::Seed;
use landform::core::sim::Model;
use landform::core::terrain::{
    Body, Bounds, Ground, HeightField, Kind, Layer, Mesh, NodeSurface, Representation, Surface, Terrain, VoxelGrid,
};
use landform::core::verb::{CancelToken, MemoryOutput};
use landform::io::export::WritePicture;
use landform::recipe::{
    AnyTerrain, Axis, Cache, Options, Outputs, Override, Ran, Recipe, Signal, Stage, Sweep, Verb, contact_sheet,
    parameters, schema, stages,
};

fn start(kind: Kind) -> &'static str {
    match kind {
        Kind::Mesh => {
            "[[stage]]\nuse = \"stream_graph\"\nsize = [\"8 km\", \"8 km\"]\nnodes = 400\nroughness = \"80 m\"\n"
        }
        Kind::VoxelGrid => {
            "[[stage]]\nuse = \"noise\"\nsize = [\"4 km\", \"3 km\"]\ncell_size = \"200 m\"\namplitude = \"150 m\"\n\
             [[stage]]\nuse = \"to_voxels\"\nvoxel_height = \"20 m\"\n"
        }
        _ => "[[stage]]\nuse = \"noise\"\nsize = [\"4 km\", \"3 km\"]\ncell_size = \"200 m\"\namplitude = \"150 m\"\n",
    }
}

fn recipe(text: &str) -> Recipe {
    Recipe::parse(text, "test", Path::new("."), &[]).unwrap_or_else(|e| panic!("{e}\n{text}"))
}

fn run(text: &str) -> AnyTerrain {
    match recipe(text).run(&mut MemoryOutput::default(), &Options::default()).unwrap() {
        Ran::ToTheEnd(terrain, _) => (*terrain).clone(),
        Ran::Interrupted(_) => panic!("interrupted"),
    }
}

/// What stands before a stage that needs a terrain.
fn head(stage: &Stage) -> &'static str {
    stage.kinds().next().map(start).unwrap_or_default()
}

/// Every process on every kind of terrain that it runs on.
fn processes() -> impl Iterator<Item = (&'static Stage, Kind)> {
    stages().filter(|s| s.verb == Verb::Process).flat_map(|s| s.kinds().map(move |k| (s, k)))
}

fn process_recipe((stage, kind): (&Stage, Kind), steps: u64) -> String {
    let clock = format!("clock = {{ dt = \"20 kyr\", iterations = {steps} }}");
    format!("seed = 5\n{}\n[[stage]]\nuse = \"{}\"\n{clock}\n", start(kind), stage.name)
}

#[test]
fn names_are_snake_case_and_each_kind_appears_once() {
    let mut seen = BTreeSet::new();
    for stage in stages() {
        assert!(stage.name.chars().all(|c| c.is_ascii_lowercase() || c == '_'), "{}", stage.name);
        assert!(seen.insert(stage.name), "{} is listed twice", stage.name);
        let kinds: BTreeSet<_> = stage.kinds().collect();
        assert!(kinds.len() == stage.kinds().count() && !stage.acts.is_empty(), "{}", stage.name);
        assert!(!stage.summary().is_empty(), "{} says nothing", stage.name);
    }
}

#[test]
fn every_parameter_has_a_meaning_and_a_default_inside_its_range() {
    for stage in stages() {
        for p in parameters(stage.name).unwrap() {
            assert!(p.meaning.len() > 8 && p.meaning.ends_with('.'), "{}.{}: `{}`", stage.name, p.name, p.meaning);
        }
        let given = if stage.inputs.is_empty() { "" } else { "path = \"x.tif\"\n" };
        let head = head(stage);
        let clock = if stage.verb == Verb::Process { "clock = { dt = \"1 kyr\", iterations = 1 }\n" } else { "" };
        recipe(&format!("{head}[[stage]]\nuse = \"{}\"\n{given}{clock}", stage.name));
    }
}

#[test]
fn no_parameter_bears_a_word_of_recipes() {
    for stage in stages() {
        for p in (stage.form.properties)() {
            let reserved = ["use", "label", "from", "with", "clock", "watch", "process"].contains(&p.0.as_str());
            assert!(!reserved, "`{}` of `{}` could never be given", p.0, stage.name);
        }
        let reserved = stage.renamed.iter().any(|r| ["use", "label", "with", "process"].contains(&r.0));
        assert!(!reserved, "{}", stage.name);
    }
}

#[test]
fn several_mistakes_are_told_at_once() {
    let text = "[[stage]]\nuse = \"flat\"\nelevatoin = 3\n[[stage]]\nuse = \"add\"\nelevation = \"3 yr\"\n\
                [[stage]]\nuse = \"write_picture\"\npath = \"a.jpg\"\n";
    let error = Recipe::parse(text, "t", Path::new("."), &[]).unwrap_err();
    let landform::core::Error::Several(errors) = &error else { panic!("{error}") };
    assert_eq!(errors.len(), 3);
    let text = error.to_string();
    assert!(text.contains("line 3: ") && text.contains("line 6: ") && text.contains("line 9: "), "{text}");
}

#[test]
fn nothing_leaves_the_output_folder_unless_it_is_allowed() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    let write = |path: &str, allowed: bool| {
        let text = format!("{}[[stage]]\nuse = \"write_raster\"\npath = \"{path}\"\n", start(Kind::HeightField));
        let mut recipe = recipe(&text);
        recipe.allow_outside = allowed;
        let mut output = landform::io::files::Folder::create(&out).unwrap().may_leave(allowed);
        recipe.run(&mut output, &Options::default()).map(drop).map_err(|e| e.to_string())
    };
    assert!(write("../a.tif", false).unwrap_err().contains("out of the output folder"));
    assert!(write(&folder.path().join("b.tif").display().to_string(), false).is_err());
    assert!(write("c/../../a.tif", false).is_err());
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink(folder.path(), out.join("link")).unwrap();
        assert!(write("link/d.tif", false).unwrap_err().contains("a link leads out"));
        write("link/d.tif", true).unwrap();
    }
    write("../a.tif", true).unwrap();
    let mut there: Vec<_> = std::fs::read_dir(folder.path()).unwrap().map(|f| f.unwrap().file_name()).collect();
    there.sort();
    assert_eq!(there, ["a.tif", "d.tif", "out"]);
}

#[test]
fn unknown_words_are_refused_by_every_stage() {
    for stage in stages() {
        let head = head(stage);
        let clock = if stage.verb == Verb::Process { "clock = { dt = \"1 kyr\", iterations = 1 }\n" } else { "" };
        let text = format!("{head}[[stage]]\nuse = \"{}\"\n{clock}no_such_word = 1\n", stage.name);
        let error = Recipe::parse(&text, "t", Path::new("."), &[]).unwrap_err().to_string();
        assert!(error.contains("no_such_word"), "{}: {error}", stage.name);
    }
}

fn fields(terrain: &AnyTerrain) -> (Vec<f64>, Vec<String>) {
    fn of<T: NodeSurface>(t: &T) -> (Vec<f64>, Vec<String>) {
        (t.elevation().to_vec(), t.names().into_iter().filter(|n| n != "elevation").collect())
    }
    struct Values;
    impl landform::core::terrain::Visit for Values {
        type Out = (Vec<f64>, Vec<String>);
        fn surface<T: Surface>(self, terrain: &T) -> Self::Out {
            of(terrain)
        }
        fn body<T: Body>(self, _: &T) -> Self::Out {
            (Vec::new(), Vec::new())
        }
    }
    terrain.visit(Values)
}

#[test]
fn processes_give_finite_numbers_and_write_only_what_they_declare() {
    for (stage, kind) in processes() {
        let (z, names) = fields(&run(&process_recipe((stage, kind), 2)));
        assert!(z.iter().all(|v| v.is_finite()), "{}", stage.name);
        for name in names {
            assert!(stage.writes.contains(&name.as_str()), "{} wrote `{name}`", stage.name);
        }
        assert!(stage.writes.contains(&"elevation"));
    }
}

#[test]
fn mass_budgets_close() {
    for (stage, kind) in processes() {
        let budgets = std::sync::Mutex::new(Vec::new());
        let options = Options {
            progress: &|signal| {
                if let Signal::Outcome(o) = signal {
                    budgets.lock().unwrap().push(o.budget);
                }
            },
            ..Options::default()
        };
        recipe(&process_recipe((stage, kind), 10)).run(&mut MemoryOutput::default(), &options).unwrap();
        for budget in budgets.lock().unwrap().iter() {
            assert!(budget.imbalance() < 1e-9, "{} on a {kind}: {:e}", stage.name, budget.imbalance());
            assert!(budget.sediment_imbalance() < 1e-9, "{}: {:e}", stage.name, budget.sediment_imbalance());
        }
    }
}

#[test]
fn results_do_not_depend_on_threads() {
    for (stage, kind) in processes() {
        let text = process_recipe((stage, kind), 3).replace("nodes = 400", "nodes = 30000").replace("200 m", "25 m");
        let one = with_threads(1, || run(&text)).unwrap();
        let four = with_threads(4, || run(&text)).unwrap();
        assert!(one == four, "{} on a {kind}", stage.name);
    }
}

#[test]
fn an_interrupted_run_resumes_to_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    for (stage, kind) in processes() {
        let text = process_recipe((stage, kind), 6);
        let whole = run(&text);
        for stop_at in 1..6 {
            let checkpoint = folder.path().join(format!("{}-{kind}-{stop_at}.lfc", stage.name));
            let cancel = CancelToken::default();
            let stopper = cancel.clone();
            let options = Options {
                checkpoint: Some(checkpoint.clone()),
                cancel,
                progress: &|signal| {
                    if matches!(signal, Signal::Step { steps, .. } if steps == stop_at) {
                        stopper.cancel();
                    }
                },
                ..Options::default()
            };
            let ran = recipe(&text).run(&mut MemoryOutput::default(), &options).unwrap();
            assert!(matches!(ran, Ran::Interrupted(Some(_))), "{}", stage.name);
            let options = Options { checkpoint: Some(checkpoint.clone()), resume: true, ..Options::default() };
            match recipe(&text).run(&mut MemoryOutput::default(), &options).unwrap() {
                Ran::ToTheEnd(terrain, _) => assert!(*terrain == whole, "{} at {stop_at}", stage.name),
                Ran::Interrupted(_) => panic!("interrupted again"),
            }
            assert!(!checkpoint.exists(), "a finished run leaves no checkpoint");
        }
    }
}

#[test]
fn the_same_recipe_in_cells_of_half_the_size_is_the_same_land() {
    let land = |cell: &str| {
        let text = format!(
            "seed = 4\n[[stage]]\nuse = \"noise\"\nsize = [\"12 km\", \"12 km\"]\ncell_size = \"{cell}\"\namplitude = \"120 m\"\n\
             [[stage]]\nuse = \"evolve\"\nclock = {{ duration = \"1 Myr\", dt = \"20 kyr\" }}\nprocess = [\n\
             {{ use = \"uplift\", rate = \"0.3 mm/yr\" }},\n{{ use = \"stream_power\", erodibility = \"2e-6\" }},\n\
             {{ use = \"linear_diffusion\", diffusivity = \"0.05 m2/yr\" }} ]\n"
        );
        let (z, _) = fields(&run(&text));
        z.iter().sum::<f64>() / z.len() as f64
    };
    let (coarse, fine) = (land("200 m"), land("100 m"));
    // Drainage area grows cell by cell, so finer hillslopes erode a little less.
    assert!((coarse / fine - 1.0).abs() < 0.12, "{coarse} {fine}");
}

#[test]
fn seeds_matter_and_inserting_a_stage_does_not_reshuffle() {
    let base = start(Kind::Mesh);
    assert!(run(&format!("seed = 1\n{base}")) == run(&format!("seed = 1\n{base}")));
    assert!(run(&format!("seed = 1\n{base}")) != run(&format!("seed = 2\n{base}")));
    let inserted = format!("seed = 1\n[[stage]]\nuse = \"flat\"\n{base}");
    assert!(run(&format!("seed = 1\n{base}")) == run(&inserted));
}

#[test]
fn stages_branch_and_the_cache_spares_what_did_not_change() {
    let folder = tempfile::tempdir().unwrap();
    let ran = |text: &str| {
        let cached = std::sync::Mutex::new(Vec::new());
        let cache = Cache::on_disk(folder.path());
        let options = Options {
            cache: Some(&cache),
            progress: &|signal| {
                if let Signal::Stage { cached: c, .. } = signal {
                    cached.lock().unwrap().push(c);
                }
            },
            ..Options::default()
        };
        let Ran::ToTheEnd(terrain, history) = recipe(text).run(&mut MemoryOutput::default(), &options).unwrap() else {
            panic!("interrupted")
        };
        (cached.into_inner().unwrap(), terrain, history)
    };
    let text = |depth: &str| {
        format!(
            "{}label = \"ground\"\n[[stage]]\nuse = \"add\"\nelevation = \"{depth}\"\n\
             [[stage]]\nuse = \"fill_depressions\"\nfrom = \"ground\"\n[[stage]]\nuse = \"measure_summary\"\n",
            start(Kind::HeightField)
        )
    };
    let (cached, first, history) = ran(&text("5 m"));
    assert_eq!(cached, [false, false, false, false]);
    assert_eq!(history.len(), 2, "the branch did not pass through `add`");
    let (cached, second, again) = ran(&text("5 m"));
    assert_eq!(cached, [true, true, true, false]);
    assert!(first == second && history == again);
    assert_eq!(ran(&text("6 m")).0, [true, false, true, false]);
    // A damaged file of the cache is found out, and the stage is run again.
    for file in std::fs::read_dir(folder.path()).unwrap().flatten() {
        let bytes = std::fs::read(file.path()).unwrap();
        std::fs::write(file.path(), &bytes[..bytes.len() / 2]).unwrap();
    }
    assert!(ran(&text("5 m")).1 == first);
}

#[test]
fn the_schema_knows_every_stage() {
    let schema = schema();
    for stage in stages() {
        assert_eq!(schema["$defs"][stage.name]["properties"]["use"]["const"], stage.name);
    }
    assert!(schema["$defs"]["evolve"].is_object() && schema["$defs"]["clock"].is_object());
    let text = schema.to_string();
    assert!(!text.contains("```"), "examples for Rust are not for recipes");
    for reference in text.split("\"#/$defs/").skip(1).map(|r| r.split('"').next().unwrap()) {
        assert!(schema["$defs"][reference].is_object(), "{reference} is not defined");
    }
}

#[test]
fn volumes_are_measured_alike_on_both_representations() {
    let text = format!("{}[[stage]]\nuse = \"to_height_field\"\ncell_size = \"100 m\"\n", start(Kind::Mesh));
    let (AnyTerrain::Mesh(mesh), AnyTerrain::HeightField(raster)) = (run(start(Kind::Mesh)), run(&text)) else {
        panic!("kinds")
    };
    // The raster's border cells stick out by half a cell, at elevation 0.
    assert!((raster.volume() / mesh.volume() - 1.0).abs() < 0.05, "{} {}", raster.volume(), mesh.volume());
}

const WATCHED: &str = "seed = 3\n[[stage]]\nuse = \"stream_graph\"\nnodes = 500\nsize = [\"8 km\", \"8 km\"]\n\
    [[stage]]\nuse = \"evolve\"\nclock = { dt = \"40 kyr\", duration = \"1 Myr\" }\n\
    watch = { table = \"t.csv\", animation = \"a.gif\", frames = \"f/f.png\", every = \"250 kyr\", size = 32 }\n\
    process = [ { use = \"uplift\" }, { use = \"stream_power\", deposition = 0.5 } ]\n";

#[test]
fn a_watched_run_writes_what_it_saw_even_from_the_cache() {
    let folder = tempfile::tempdir().unwrap();
    let cache = Cache::on_disk(folder.path());
    let options = || Options { cache: Some(&cache), ..Options::default() };
    let (mut first, mut again) = (MemoryOutput::default(), MemoryOutput::default());
    recipe(WATCHED).run(&mut first, &options()).unwrap();
    recipe(WATCHED).run(&mut again, &options()).unwrap();
    assert!(first.0 == again.0, "the same bytes");
    let names: Vec<&str> = first.0.keys().map(String::as_str).collect();
    assert_eq!(names, ["a.gif", "f/f_0001.png", "f/f_0002.png", "f/f_0003.png", "f/f_0004.png", "t.csv"]);
    let table = String::from_utf8(first.0["t.csv"].clone()).unwrap();
    let times: Vec<f64> = table.lines().skip(1).map(|l| l.split(',').nth(1).unwrap().parse().unwrap()).collect();
    assert!(times.iter().zip([2.5e5, 5e5, 7.5e5, 1e6]).all(|(a, b)| (a / b - 1.0).abs() < 1e-9), "{times:?}");
    let quiet = Options { outputs: Outputs::Nothing, ..Options::default() };
    let mut nothing = MemoryOutput::default();
    recipe(WATCHED).run(&mut nothing, &quiet).unwrap();
    assert!(nothing.0.is_empty());
}

#[test]
fn a_sweep_runs_every_combination_and_its_rows_do_not_depend_on_threads() {
    let sweep = Sweep {
        keep: true,
        seeds: vec![4, 5],
        over: vec![
            Axis::parse("uplift.rate=0.2 mm/yr,0.4 mm/yr").unwrap(),
            Axis::parse("stream_power.deposition=0;1").unwrap(),
        ],
    };
    let text = WATCHED.lines().filter(|l| !l.starts_with("watch")).collect::<Vec<_>>().join("\n");
    let load = |overrides: &[Override]| Recipe::parse(&text, "test", Path::new("."), overrides);
    let table = |threads| {
        with_threads(threads, || {
            let (rows, failure) = sweep.run(load, None, &CancelToken::default(), |_, _| {}).unwrap();
            assert!(failure.is_none());
            let sheet = contact_sheet(&rows, &WritePicture { size: 24, ..WritePicture::default() }, 2).unwrap();
            (sweep.table(&rows), sheet)
        })
        .unwrap()
    };
    let (one, two) = (table(1), table(2));
    assert!(one == two);
    let lines: Vec<&str> = one.0.lines().collect();
    assert_eq!(lines.len(), 9);
    assert!(lines[0].starts_with("seed,uplift.rate,stream_power.deposition,min_m"));
    assert!(lines[1].starts_with("4,0.2 mm/yr,0,") && lines[8].starts_with("5,0.4 mm/yr,1,"));
    assert!(one.1.shape.rows > 3 * 13 && one.1.shape.cols > 3 * 24);
    assert!(
        Axis::parse("uplift.rate").is_err() && Axis::parse("a.b=1,,2").is_err() && Axis::parse("seed=1,2").is_err()
    );
    let nested = Axis::parse("a.b={ formula = \"max(u, 1)\", unit = \"m\" },[1, 2]").unwrap();
    assert_eq!(nested.values.len(), 2, "{nested:?}");
    let twice = Sweep { over: vec![nested.clone(), nested], ..Sweep::default() };
    assert!(twice.runs(1).unwrap_err().to_string().contains("twice"));
}

#[test]
fn features_of_both_representations_only_run_downhill() {
    for more in ["", "[[stage]]\nuse = \"to_height_field\"\ncell_size = \"100 m\"\n"] {
        let text = format!(
            "{}[[stage]]\nuse = \"stream_power\"\nclock = {{ dt = \"20 kyr\", iterations = 4 }}\n{more}\
             [[stage]]\nuse = \"write_features\"\nleast_area = \"0.5 km2\"\n",
            start(Kind::Mesh)
        );
        let mut out = MemoryOutput::default();
        recipe(&text).run(&mut out, &Options::default()).unwrap();
        let json: serde_json::Value = serde_json::from_slice(&out.0["features.geojson"]).unwrap();
        let features = json["features"].as_array().unwrap();
        let of = |kind: &str| features.iter().filter(|f| f["properties"]["kind"] == kind).collect::<Vec<_>>();
        assert!(of("river").len() > 5 && !of("lake").is_empty() && !of("basin").is_empty());
        let ids: BTreeSet<&str> = of("river").iter().map(|r| r["properties"]["id"].as_str().unwrap()).collect();
        assert_eq!(ids.len(), of("river").len());
        for river in of("river") {
            let z: Vec<f64> =
                river["geometry"]["coordinates"].as_array().unwrap().iter().map(|p| p[2].as_f64().unwrap()).collect();
            assert!(z.windows(2).all(|w| w[1] <= w[0]), "{river}");
            if let Some(to) = river["properties"]["flows_to"].as_str() {
                assert!(ids.contains(to));
            }
        }
        for lake in of("lake") {
            for ring in lake["geometry"]["coordinates"].as_array().unwrap() {
                let ring = ring.as_array().unwrap();
                assert!(ring.len() >= 5 && ring.first() == ring.last());
            }
        }
    }
}

#[test]
fn looking_at_fixed_times_is_part_of_the_recipe() {
    let text = WATCHED.replace("every = \"250 kyr\"", "every = \"70 kyr\"");
    let plain = text.lines().filter(|l| !l.starts_with("watch")).collect::<Vec<_>>().join("\n");
    let folder = tempfile::tempdir().unwrap();
    let cache = Cache::on_disk(folder.path());
    let ran = |text: &str, outputs: Outputs| {
        let options = Options { cache: Some(&cache), outputs, ..Options::default() };
        match recipe(text).run(&mut MemoryOutput::default(), &options).unwrap() {
            Ran::ToTheEnd(terrain, _) => terrain,
            Ran::Interrupted(_) => panic!("interrupted"),
        }
    };
    let (watched, unwatched) = (ran(&text, Outputs::All), ran(&plain, Outputs::All));
    assert!(watched != unwatched, "steps are shortened to the looks, and the cache knows it");
    assert!(*unwatched == run(&plain));
    assert!(cache.clear().unwrap() > 0);
    assert!(ran(&text, Outputs::Nothing) == watched, "a quiet run takes the same steps");
}

#[test]
fn a_sea_that_leaves_the_map_is_an_error_that_says_when() {
    let text = format!(
        "{}[[stage]]\nuse = \"evolve\"\nclock = {{ dt = \"100 kyr\", duration = \"1 Myr\" }}\nprocess = [ {{ use = \"uplift\" }},\n\
         {{ use = \"stream_power\", outlets = \"sea\", sea_level = \"1 m\" }} ]\n",
        start(Kind::Mesh)
    );
    let error = recipe(&text).run(&mut MemoryOutput::default(), &Options::default()).unwrap_err().to_string();
    assert!(error.contains("after 0.1000 Myr no ground is at or under 1 m"), "{error}");
}

/// A terrain in mid-run, edited, goes on as a run that begins on the edited terrain at that time.
#[test]
fn an_edit_in_mid_run_equals_a_fresh_start_for_every_process() {
    fn check<T: Representation + PartialEq>(stage: &'static Stage, terrain: &T, edit: impl Fn(&mut T)) {
        let part = stage.read(&serde_json::json!({})).unwrap_or_else(|e| panic!("{}: {e:?}", stage.name));
        let model = |terrain: T| {
            let mut model = Model::new(terrain);
            part.add_to(T::KIND, &mut model).unwrap();
            model.dt(3e11).seed(Seed(8))
        };
        let mut edited = model(terrain.clone());
        edited.advance_steps(3).unwrap();
        let before = edited.terrain().clone();
        edited.edit(&edit).unwrap();
        let mut fresh = {
            let mut terrain = before;
            edit(&mut terrain);
            model(terrain).begin_at(edited.time(), edited.steps())
        };
        fresh.start().unwrap();
        assert!(edited.terrain() == fresh.terrain(), "{} on a {}: after the edit", stage.name, T::KIND);
        edited.advance_steps(3).unwrap();
        fresh.advance_steps(3).unwrap();
        edited.finish().unwrap();
        fresh.finish().unwrap();
        assert!(edited.terrain() == fresh.terrain(), "{} on a {}", stage.name, T::KIND);
        let budget = edited.budget();
        assert!(budget.imbalance() < 1e-9, "{}: {:e}", stage.name, budget.imbalance());
        assert!(budget.sediment_imbalance() < 1e-9, "{}: {:e}", stage.name, budget.sediment_imbalance());
    }
    /// A hill, a hollow, and other outlets.
    fn reshape<T: NodeSurface>(terrain: &mut T) {
        let n = terrain.elevation().len();
        terrain.change(Layer::Bedrock, |z| (n / 3..n / 3 + n / 20).for_each(|i| z[i] += 40.0));
        terrain.change(Layer::Surface("sediment"), |z| (n / 2..n / 2 + n / 20).for_each(|i| z[i] -= 15.0));
        let mut status = terrain.domain().status().to_vec();
        if let Some(first) = status.iter().position(|&s| s == Status::BaseLevel) {
            status[first] = Status::Interior;
        }
        terrain.set_status(Some(status));
    }
    fn hollow(ground: &mut VoxelGrid) {
        let Bounds { low, high } = ground.bounding_box();
        let middle = [0, 1, 2].map(|k| 0.5 * (low[k] + high[k]));
        assert!(ground.empty(Bounds { low, high: middle }, |_| true) > 0);
    }
    for (stage, kind) in processes() {
        match run(start(kind)) {
            AnyTerrain::HeightField(t) => check::<HeightField>(stage, &t, reshape),
            AnyTerrain::Mesh(t) => check::<Mesh>(stage, &t, reshape),
            AnyTerrain::VoxelGrid(t) => check::<VoxelGrid>(stage, &t, hollow),
            other => panic!("{}", other.kind()),
        }
    }
}

/// All Rust files under a folder.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten().map(|e| e.path());
    let files = entries.flat_map(|path| if path.is_dir() { sources(&path) } else { vec![path] });
    files.filter(|path| path.extension().is_some_and(|e| e == "rs")).collect()
}

#[test]
fn there_is_one_match_on_representations() {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut arms = Vec::new();
    for member in ["landform-core", "landform-process", "landform-io", "landform", "landform-cli"] {
        let files = sources(&crates.join(member).join("src"));
        assert!(!files.is_empty(), "{member}");
        for file in files {
            let text = std::fs::read_to_string(&file).unwrap();
            let kinds = ["HeightField", "Mesh", "VoxelGrid"].map(|kind| format!("AnyTerrain::{kind}("));
            let is_arm = |line: &&str| kinds.iter().any(|kind| line.contains(kind));
            let visits = text.matches("=> visitor.surface(").count();
            arms.extend((0..visits + text.lines().filter(is_arm).count()).map(|_| file.clone()));
        }
    }
    assert_eq!(arms.len(), 1, "{arms:?}");
    assert!(arms[0].ends_with("terrain/any.rs"));
}

/// The recipe that fixes the words of caves: inlets break through, one joins the other, and every
/// file comes.
#[test]
fn a_limestone_cave_is_dissolved_measured_and_written() {
    let text = include_str!("../gallery/75_limestone_cave.toml")
        .replace("view = \"cutaway\"", "view = \"cutaway\"\nsize = 96");
    let ran = |threads| {
        with_threads(threads, || {
            let mut out = MemoryOutput::default();
            let Ran::ToTheEnd(terrain, _) = recipe(&text).run(&mut out, &Options::default()).unwrap() else {
                panic!("interrupted")
            };
            (terrain, out)
        })
        .unwrap()
    };
    let (terrain, out) = ran(2);
    assert_eq!(out.0.keys().collect::<Vec<_>>(), ["cave.glb", "cave.json", "cave.png", "cave.svx", "cave.vti"]);
    let measured: serde_json::Value = serde_json::from_slice(&out.0["cave.json"]).unwrap();
    assert_eq!((measured["breakthroughs"].as_u64(), measured["captures"].as_u64()), (Some(2), Some(1)));
    let ground = terrain.get::<VoxelGrid>("the test").unwrap();
    let empty = (ground.plan().len() * ground.levels() - ground.solids()) as f64;
    assert_eq!(measured["volume_m3"].as_f64(), Some(empty));
    let coverage = measured["rectangular"]["coverage_percent"].as_f64().unwrap();
    let product = measured["rectangular"]["density_m_m2"].as_f64().unwrap() * measured["width_m"].as_f64().unwrap();
    assert!((coverage / (100.0 * product) - 1.0).abs() < 1e-12);
    assert!(String::from_utf8_lossy(&out.0["cave.svx"]).contains("*data passage"));
    let (_, again) = ran(1);
    assert!(again.0 == out.0, "the number of threads shows");
}

/// The recipe of a karst network that fixes its words, on coarser voxels: every file comes, and the
/// network is as natural ones.
#[test]
fn a_karst_network_is_grown_measured_and_hollowed_out() {
    let text = include_str!("../gallery/77_karst_network.toml")
        .replace("cell_size = \"4 m\"", "cell_size = \"16 m\"")
        .replace("view = \"cutaway\"", "view = \"cutaway\"\nsize = 96");
    let mut out = MemoryOutput::default();
    recipe(&text).run(&mut out, &Options::default()).unwrap();
    let names: Vec<&String> = out.0.keys().collect();
    assert_eq!(names, ["network.geojson", "network.json", "network.png", "network.svx", "passages.stl"]);
    let measured: serde_json::Value = serde_json::from_slice(&out.0["network.json"]).unwrap();
    assert!(measured["in_range"].as_u64().unwrap() >= 7, "{measured}");
    assert_eq!((measured["parts"].as_u64(), measured["pattern"].as_str()), (Some(1), Some("branchwork")));
    let survey = String::from_utf8_lossy(&out.0["network.svx"]);
    assert_eq!(survey.lines().filter(|l| l.starts_with("*entrance")).count(), 41);
}

/// The recipe that fixes the words of particles, on coarser cells: rain on heights, then waves on
/// voxels of the same hill; every file comes, whatever the number of threads.
#[test]
fn rain_and_then_waves_erode_a_hill() {
    let text = r#"
seed = 8
[[stage]]
use = "surface"
label = "hill"
grid = { size = ["2 km", "2 km"], cell_size = "50 m" }
elevation = { formula = "160 - 130*smoothstep(0.55, 0.75, u) + 12*noise(x/400, y/400)", unit = "m" }
[[stage]]
use = "particle_erosion"
phenomenon = "rain"
particles = 100
iterations = 10
[[stage]]
use = "write_raster"
field = "elevation"
path = "rain_on_heights.tif"
[[stage]]
use = "to_voxels"
from = "hill"
cell_size = "25 m"
depth = "60 m"
[[stage]]
use = "particle_erosion"
phenomenon = "coastal"
sea_level = "60 m"
flow = { uniform = ["-1 m/s", "0 m/s", "0 m/s"] }
particles = 80
iterations = 3
[[stage]]
use = "write_mesh"
path = "coast.glb"
[[stage]]
use = "write_picture"
view = "perspective"
size = 64
path = "coast.png"
"#;
    let ran = |threads| {
        with_threads(threads, || {
            let mut out = MemoryOutput::default();
            recipe(text).run(&mut out, &Options::default()).unwrap();
            out
        })
        .unwrap()
    };
    let out = ran(1);
    assert_eq!(out.0.keys().collect::<Vec<_>>(), ["coast.glb", "coast.png", "rain_on_heights.tif"]);
    assert!(ran(3).0 == out.0, "the number of threads shows");
    let mesh = text.replace("use = \"surface\"", "use = \"stream_graph\"").replace(
        "grid = { size = [\"2 km\", \"2 km\"], cell_size = \"50 m\" }",
        "size = [\"2 km\", \"2 km\"]\nnodes = 200",
    );
    let mesh: String = mesh.lines().filter(|l| !l.starts_with("elevation")).map(|l| format!("{l}\n")).collect();
    let run = |r: Recipe| r.run(&mut MemoryOutput::default(), &Options::default()).map(drop);
    let refused = Recipe::parse(&mesh, "t", Path::new("."), &[]).and_then(run).unwrap_err().to_string();
    assert!(refused.contains("mesh") && refused.contains("particle_erosion"), "{refused}");
}

/// The recipe that fixes the words of what engines take, small: every file comes, tiles share their
/// borders, weights sum to 255, and the number of threads does not show.
#[test]
fn a_landscape_for_an_engine_is_written_whole() {
    let text = include_str!("data/for_an_engine.toml")
        .replace("spacing = \"40 m\"", "spacing = \"200 m\"")
        .replace("cell_size = \"8 m\"", "cell_size = \"32 m\"")
        .replace("spacing = \"6 m\"", "spacing = \"60 m\"");
    let ran = |threads| {
        with_threads(threads, || {
            let mut out = MemoryOutput::default();
            recipe(&text).run(&mut out, &Options::default()).unwrap();
            out.0
        })
        .unwrap()
    };
    let files = ran(2);
    let has = |name: &str| assert!(files.contains_key(name), "{name} of {:?}", files.keys());
    ["height_x0_y0.png", "height_x1_y1.png", "height.png.md", "land.glb", "splines.json", "trees.csv"]
        .into_iter()
        .for_each(has);
    let grey = |name: &str| landform::io::format::read_grey(&files[name]).unwrap();
    let (west, east) = (grey("height_x0_y0.png"), grey("height_x1_y0.png"));
    let last = west.cols - 1;
    assert!((0..west.rows).all(|r| west.values[r * west.cols + last] == east.values[r * east.cols]));
    let layers = ["rock", "sediment", "grass"].map(|name| grey(&format!("weights/{name}.png")));
    for i in 0..layers[0].values.len() {
        let sum: f64 = layers.iter().map(|layer| (255.0 * layer.values[i]).round()).sum();
        assert!(sum == 255.0, "{sum} in pixel {i}");
    }
    let splines: serde_json::Value = serde_json::from_slice(&files["splines.json"]).unwrap();
    let all = splines["splines"].as_array().unwrap();
    let road = all.iter().find(|s| s["kind"] == "path").unwrap();
    assert!(all.iter().any(|s| s["kind"] == "river") && road["properties"]["steepest_deg"].as_f64().unwrap() < 8.001);
    assert!(String::from_utf8_lossy(&files["trees.csv"]).lines().count() > 1000);
    assert!(ran(1) == files, "the number of threads shows");
}
