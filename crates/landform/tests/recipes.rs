//! Broken recipes: what is said, and where.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on panics")]

use std::path::Path;

use landform::core::Error;
use landform::recipe::{Override, Recipe};

const HEAD: &str = "[[stage]]\nuse = \"flat\"\n";
const EVOLVE: &str =
    "[[stage]]\nuse = \"flat\"\n[[stage]]\nuse = \"evolve\"\nclock = { dt = \"1 kyr\", duration = \"1 Myr\" }\n";

fn after_head(text: &str) -> String {
    format!("{HEAD}{text}")
}

fn process(text: &str) -> String {
    format!("{EVOLVE}process = [ {text} ]\n")
}

/// Recipe, line (0: none), part of the message, part of the hint.
fn broken() -> Vec<(String, usize, &'static str, &'static str)> {
    let s = String::from;
    vec![
        (s(""), 0, "no stages", "[[stage]]"),
        (s("seed = 1"), 0, "no stages", ""),
        (s("seed = "), 1, "", ""),
        (s("[[stage]\nuse = 1"), 1, "", ""),
        (s("[[stage]]\nuse = \"flat\n"), 2, "", ""),
        (s("sede = 1\n[[stage]]\nuse = \"flat\""), 1, "`sede` is not known here", "did you mean `seed`?"),
        (s("stages = []"), 1, "`stages` is not known", "did you mean `stage`?"),
        (s("stage = 3"), 1, "`stage` is not a list", "write [[stage]]"),
        (s("seed = -1\n[[stage]]\nuse = \"flat\""), 1, "`seed` is -1", ""),
        (s("seed = \"x\"\n[[stage]]\nuse = \"flat\""), 1, "`seed` is not a whole number", ""),
        (s("seed = 1.5\n[[stage]]\nuse = \"flat\""), 1, "`seed` is 1.5", ""),
        (s("title = 4\n[[stage]]\nuse = \"flat\""), 1, "`title` is not a text", ""),
        (s("[[stage]]\nsize = 3"), 1, "no `use`", ""),
        (s("[[stage]]\nuse = 3"), 2, "`use` is not a text", ""),
        (after_head("[[stage]]\nuse = \"write_raster\"\npath = \"z.ppm\""), 5, "a file of colours", ""),
        (after_head("[[stage]]\nuse = \"snow\"\ncarry = \"1e18 m\""), 5, "`carry` is", ""),
        (after_head("[[stage]]\nuse = \"snow\"\ngrowth = 1e308"), 5, "`growth` is", ""),
        (s("[[stage]]\nuse = \"stream_graph\"\nsize = [\"1e-308 m\", \"1 km\"]"), 3, "`size", ""),
        (after_head("[[stage]]\nuse = \"dunes\"\nsteps = -1"), 5, "`iterations` is `steps` in the recipe", ""),
        (s("[[stage]]\nuse = \"stream_grap\""), 2, "`stream_grap` is not known", "did you mean `stream_graph`?"),
        (s("[[stage]]\nuse = \"xyzzy\""), 2, "`xyzzy` is not known", "landform stages"),
        (s("[[stage]]\nuse = \"write_raster\""), 2, "has no terrain to work on", "begin with a generator"),
        (s("[[stage]]\nuse = \"flat\"\nclok = 1"), 3, "`flat` has no parameter `clok`", ""),
        (s("[[stage]]\nuse = \"flat\"\ncel_size = \"5 m\""), 3, "no parameter `cel_size`", "did you mean `cell_size`?"),
        (s("[[stage]]\nuse = \"flat\"\ncell_size = \"5 yr\""), 3, "`yr` has the wrong dimension", ""),
        (s("[[stage]]\nuse = \"flat\"\ncell_size = \"5 KM\""), 3, "did you mean `km`?", ""),
        (s("[[stage]]\nuse = \"flat\"\ncell_size = \"five m\""), 3, "does not start with a number", ""),
        (s("[[stage]]\nuse = \"flat\"\ncell_size = \"0 m\""), 3, "`grid.cell_size` is 0 m; expected > 0 m", ""),
        (s("[[stage]]\nuse = \"flat\"\ncell_size = \"-5 m\""), 3, "`grid.cell_size` is -5 m", ""),
        (s("[[stage]]\nuse = \"flat\"\ncell_size = true"), 3, "expected a length such as", ""),
        (s("[[stage]]\nuse = \"flat\"\ncell_size = nan"), 3, "not finite", ""),
        (s("[[stage]]\nuse = \"flat\"\ncell_size = 2020-01-01"), 3, "a date is not expected", ""),
        (s("[[stage]]\nuse = \"flat\"\nsize = [\"1 km\"]"), 3, "size`: invalid length 1", ""),
        (s("[[stage]]\nuse = \"flat\"\nclock = { dt = \"1 yr\" }"), 3, "takes no `clock`", ""),
        (s("[[stage]]\nuse = \"noise\"\nhurst = 1.5"), 3, "`hurst` is 1.5; expected at least 0 and at most 1", ""),
        (s("[[stage]]\nuse = \"noise\"\noctaves = 0"), 3, "`octaves` is 0", ""),
        (s("[[stage]]\nuse = \"stream_graph\"\nnodes = 3"), 3, "`nodes` is 3", ""),
        (s("[[stage]]\nuse = \"stream_graph\"\nnodes = -3"), 3, "`nodes`", ""),
        (s("[[stage]]\nuse = \"stream_graph\"\nopen = []"), 3, "`open` is []", ""),
        (s("[[stage]]\nuse = \"stream_graph\"\nopen = [\"up\"]"), 3, "there is no \"up\", expected one of north", ""),
        (
            s("[[stage]]\nuse = \"noise\"\nbasis = \"perlinn\""),
            3,
            "there is no \"perlinn\"",
            "did you mean \"perlin\"?",
        ),
        (s("[[stage]]\nuse = \"elevation_file\""), 1, "`path` is \"\"", ""),
        (after_head("[[stage]]\nuse = \"uplift\""), 4, "process `uplift` has no `clock`", "for example clock"),
        (after_head("[[stage]]\nuse = \"uplift\"\nclock = { dt = \"1 kyr\" }"), 5, "`clock` is without end", ""),
        (after_head("[[stage]]\nuse = \"uplift\"\nclock = { duration = \"1 kyr\" }"), 5, "`dt` is 0 yr", ""),
        (
            after_head("[[stage]]\nuse = \"uplift\"\nclock = { dt = 5, duration = \"1 kyr\" }"),
            5,
            "the unit is missing",
            "",
        ),
        (
            after_head("[[stage]]\nuse = \"uplift\"\nclock = { dt = \"1 kyr\", until = \"stedy\" }"),
            5,
            "there is no \"stedy\"",
            "",
        ),
        (after_head("[[stage]]\nuse = \"evolve\""), 4, "`evolve` has no `clock`", ""),
        (EVOLVE.into(), 4, "`evolve` has no `process`", ""),
        (format!("{EVOLVE}process = []"), 6, "`process` is empty", ""),
        (format!("{EVOLVE}process = 3"), 6, "`process` is not a list", ""),
        (format!("{EVOLVE}proces = []"), 4, "`evolve` has no `process`", ""),
        (process("{ rate = \"1 mm/yr\" }"), 6, "this process has no `use`", ""),
        (process("{ use = \"flat\" }"), 6, "`flat` is no process", ""),
        (process("{ use = \"uplift\", rte = \"1 mm/yr\" }"), 6, "no parameter `rte`", "did you mean `rate`?"),
        (process("{ use = \"uplift\", rate = \"1 m2/yr\" }"), 6, "wrong dimension", ""),
        (process("{ use = \"uplift\", rate = 0.4 }"), 6, "the unit is missing", ""),
        (process("{ use = \"uplift\", rate = { formula = \"1 +\", unit = \"mm/yr\" } }"), 6, "character 4", ""),
        (process("{ use = \"uplift\", rate = { formula = \"q\", unit = \"mm/yr\" } }"), 6, "`q` is not known", ""),
        (process("{ use = \"uplift\", rate = { formula = \"1\" } }"), 6, "`unit` is missing", ""),
        (process("{ use = \"uplift\", rate = { image = \"a.png\" } }"), 6, "needs `black` and `white`", ""),
        (
            process("{ use = \"uplift\", rate = { imag = \"a.png\" } }"),
            6,
            "unknown field `imag`",
            "did you mean `image`?",
        ),
        (process("{ use = \"stream_power\", slope_exponent = 9 }"), 6, "`slope_exponent` is 9", ""),
        (process("{ use = \"stream_power\", talus_angle = 35 }"), 6, "the unit is missing", ""),
        (process("{ use = \"stream_power\", talus_angle = \"95 deg\" }"), 6, "at most 85 deg", ""),
        (process("{ use = \"stream_power\", erodibility = \"-1e-6\" }"), 6, "`erodibility` is", ""),
        (process("{ use = \"stream_power\", outlets = \"lake\" }"), 6, "expected \"border\"", ""),
        (
            process("{ use = \"linear_diffusion\", difusivity = \"1 m2/yr\" }"),
            6,
            "no parameter `difusivity`",
            "`diffusivity`?",
        ),
        (after_head("[[stage]]\nuse = \"to_height_field\""), 4, "does not work on a height field", ""),
        (
            s("[[stage]]\nuse = \"stream_graph\"\n[[stage]]\nuse = \"write_raster\""),
            4,
            "does not work on a mesh",
            "put `to_height_field`",
        ),
        (
            after_head("[[stage]]\nuse = \"write_raster\"\npath = \"a.jpg\""),
            5,
            "expected a name that ends with one of .tif",
            "",
        ),
        (after_head("[[stage]]\nuse = \"write_picture\"\npath = \"a.jpg\""), 5, "ends with .png", ""),
        (after_head("[[stage]]\nuse = \"write_picture\"\nview = \"top\""), 5, "there is no \"top\"", ""),
        (after_head("[[stage]]\nuse = \"drainage\"\nfrom = \"x\""), 5, "has the label `x`", ""),
        (
            s("[[stage]]\nuse = \"flat\"\nlabel = \"a\"\n[[stage]]\nuse = \"flat\"\nlabel = \"a\""),
            6,
            "is given twice",
            "",
        ),
        (process("{ use = \"stream_power\", outlets = [] }"), 6, "`outlets` is []", ""),
        (
            process("{ use = \"stream_power\", outlets = { border_where = { formula = \"u\" }, below = 3 } }"),
            6,
            "`outlets.below` is 3",
            "",
        ),
        (process("{ use = \"stream_power\", deposition = -1 }"), 6, "`deposition` is -1", ""),
        (process("{ use = \"stream_power\", descent = \"up\" }"), 6, "there is no \"up\"", ""),
        (process("{ use = \"stream_power\", talus_relaxation = \"1 mm/yr\" }"), 6, "together with talus_angle", ""),
        (process("{ use = \"stream_power\", sea_level = \"1 yr\" }"), 6, "wrong dimension", ""),
        (
            process("{ use = \"stream_power\", sea_level = { times = [\"1 yr\"], values = [] } }"),
            6,
            "as many of each",
            "",
        ),
        (
            after_head("[[stage]]\nuse = \"uplift\"\nclock = { dt = \"1 kyr\", max_steps = 3, refine = 2 }"),
            5,
            "`refine` is 2",
            "",
        ),
        (
            after_head("[[stage]]\nuse = \"uplift\"\nclock = { dt = \"1 kyr\", max_steps = 3 }\nwatch = {}"),
            6,
            "without anything to write",
            "",
        ),
        (
            after_head(
                "[[stage]]\nuse = \"uplift\"\nclock = { dt = \"1 kyr\", max_steps = 3 }\nwatch = { animation = \"a.mp4\" }",
            ),
            6,
            "ends with .gif",
            "",
        ),
        (
            after_head(
                "[[stage]]\nuse = \"uplift\"\nclock = { dt = \"1 kyr\", max_steps = 3 }\nwatch = { tabel = \"a.csv\" }",
            ),
            6,
            "no parameter `tabel`",
            "`table`?",
        ),
        (after_head("[[stage]]\nuse = \"write_features\"\npath = \"a.shp\""), 5, "ends with .geojson", ""),
        (
            after_head("[[stage]]\nuse = \"write_heightmap\"\npreset = \"unity\"\npath = \"a.png\""),
            6,
            "ends with .raw",
            "",
        ),
        (after_head("[[stage]]\nuse = \"write_mesh\"\nsolid_base = \"0 m\""), 5, "`solid_base` is 0 m", ""),
        (
            after_head("[[stage]]\nuse = \"write_report\"\n[[stage]]\nuse = \"write_report\""),
            0,
            "both write `report.html`",
            "",
        ),
    ]
}

#[test]
fn broken_recipes_say_what_is_wrong_where_and_what_to_do() {
    let table = broken();
    assert!(table.len() >= 40);
    for (text, line, message, hint) in table {
        let error = Recipe::parse(&text, "t", Path::new("."), &[]).expect_err(&text);
        let Error::Recipe { at, .. } = &error else { panic!("{text}: {error}") };
        assert_eq!(at.map_or(0, |a| a.0), line, "{text}\n{error}");
        assert!(error.to_string().contains(message), "{text}\n{error}");
        assert!(error.hint().unwrap_or_default().contains(hint), "{text}\n{error}\n{:?}", error.hint());
    }
}

#[test]
fn recipes_with_wrong_sets_say_which() {
    let set = |text: &str| {
        Override::parse(text)
            .and_then(|o| Recipe::parse(HEAD, "t", Path::new("."), &[o]))
            .map(|_| ())
            .map_err(|e| e.to_string())
    };
    assert!(set("flat.cell_size=\"20 m\"").is_ok());
    assert!(set("flat.cell_size=20 m").is_ok(), "the shell eats quotes");
    assert!(set("seed=9").is_ok());
    for (text, message) in [
        ("flat", "not understood"),
        ("=3", "not understood"),
        ("flat..x=3", "not understood"),
        ("cell_size=3", "of which stage is `cell_size`?"),
        ("uplift.rate=3", "`uplift` is not in the recipe"),
        ("plinth.rate=3", "neither a stage nor a label"),
        ("flat.cell_size=\"5 yr\"", "wrong dimension"),
    ] {
        assert!(set(text).unwrap_err().contains(message), "{text}: {:?}", set(text));
    }
}

#[test]
fn a_label_or_a_process_can_be_set() {
    let text = process("{ use = \"uplift\", rate = \"1 mm/yr\" }")
        .replace("use = \"flat\"", "use = \"flat\"\nlabel = \"plain\"");
    let o = |s: &str| Override::parse(s).unwrap();
    for set in ["plain.elevation=4 m", "uplift.rate=2 mm/yr", "evolve.clock.dt=5 kyr"] {
        Recipe::parse(&text, "t", Path::new("."), &[o(set)]).unwrap_or_else(|e| panic!("{set}: {e}"));
    }
    assert!(Recipe::parse(&text, "t", Path::new("."), &[o("uplift.rate=2 kg")]).is_err());
}

#[test]
fn absurd_sizes_are_refused_before_memory_is_taken() {
    for text in [
        "[[stage]]\nuse = \"flat\"\nsize = [\"1e9 km\", \"1e9 km\"]\ncell_size = \"1 mm\"",
        "[[stage]]\nuse = \"stream_graph\"\nsize = [\"1e6 km\", \"1e6 km\"]\nspacing = \"1 m\"",
        "[[stage]]\nuse = \"spectral_fbm\"\nsize = [\"1e7 km\", \"1 km\"]\ncell_size = \"1 m\"",
    ] {
        let recipe = Recipe::parse(text, "t", Path::new("."), &[]).unwrap();
        match recipe.plan(None, "") {
            Err(_) => {}
            Ok(plan) => assert!(plan.bytes > 1 << 36, "{text}: {}", plan.bytes),
        }
    }
    let missing =
        Recipe::parse("[[stage]]\nuse = \"elevation_file\"\npath = \"none.tif\"", "t", Path::new("."), &[]).unwrap();
    let error = missing.plan(None, "").unwrap_err();
    assert!(error.to_string().contains("cannot read") && error.hint().is_some(), "{error}");
}

#[test]
fn fields_that_no_stage_leaves_are_refused_before_the_run() {
    let plan = |text: &str| {
        let text = format!(
            "[[stage]]\nuse = \"noise\"\ngrid = {{ size = [\"1 km\", \"1 km\"], cell_size = \"100 m\" }}\n{text}"
        );
        let recipe = Recipe::parse(&text, "test", std::path::Path::new("."), &[]).unwrap();
        recipe.plan(None, "").map_err(|e| format!("{e} {}", e.hint().unwrap_or_default()))
    };
    let write = |field: &str| format!("[[stage]]\nuse = \"write_raster\"\nfield = \"{field}\"\npath = \"a.tif\"\n");
    let drained = format!("[[stage]]\nuse = \"drainage\"\n{}", write("drainage_area"));
    let chosen = format!("[[stage]]\nuse = \"mask\"\nname = \"beach\"\n{}", write("beach"));
    for text in [write("elevation"), write("sand_depth"), write("surface_material"), drained.clone(), chosen] {
        plan(&text).unwrap();
    }
    let error = plan(&write("drainage_area")).unwrap_err();
    assert!(error.contains("field `drainage_area` is missing; `write_raster` needs it"), "{error}");
    let error = plan(&drained.replace("drainage_area", "drainage_aera")).unwrap_err();
    assert!(error.contains("stage 3") && error.contains("did you mean `drainage_area`"), "{error}");
    let network = |stage: &str| format!("[[stage]]\nuse = \"karst_network\"\n[[stage]]\nuse = \"{stage}\"\n");
    for stage in ["measure_network", "write_survey", "tunnels"] {
        plan(&network(stage)).unwrap();
        let error = plan(&format!("[[stage]]\nuse = \"{stage}\"\n")).unwrap_err();
        assert!(error.contains("no conduits") && error.contains("`karst_network`"), "{error}");
    }
    let long = network("write_survey").replace("karst_network\"", "karst_network\"\nbend = \"5 km\"");
    assert!(plan(&long).unwrap_err().contains("1 m to 250 m on this map"));
    // A value that a map of a field gives, and ground that is made anew.
    let by_field = "[[stage]]\nuse = \"blend\"\namount = { field = \"beach\" }\n";
    assert!(plan(by_field).unwrap_err().contains("field `beach` is missing"));
    let anew = format!("[[stage]]\nuse = \"drainage\"\n[[stage]]\nuse = \"noise\"\n{}", write("basin"));
    assert!(plan(&anew).unwrap_err().contains("field `basin` is missing"));
}

#[test]
fn what_is_wrong_with_a_value_set_from_outside_is_said_of_it() {
    let text = "[[stage]]\nuse = \"flat\"\nelevation = \"3 m\"\n";
    let parse = |sets: &[&str]| {
        let sets: Vec<_> = sets.iter().map(|s| landform::recipe::Override::parse(s).unwrap()).collect();
        Recipe::parse(text, "test", std::path::Path::new("."), &sets)
    };
    parse(&["flat.elevation=4 m"]).unwrap();
    for (sets, said) in [
        (&["flat.elevation=high"][..], "`--set flat.elevation=high`: `flat`, `elevation`: `high` is not a length"),
        (&["flat.elevation=4 m", "flat.elevaton=4 m"], "`--set flat.elevaton=4 m`: `flat` has no parameter"),
        (&["noise.seed=1"], "`--set noise.seed=1`: `noise` is not in the recipe"),
    ] {
        let error = parse(sets).unwrap_err();
        assert!(matches!(error, landform::core::Error::Override { .. }), "{error:?}");
        assert!(error.to_string().starts_with(said), "{error}");
    }
    // A recipe that is wrong by itself is blamed for it.
    let wrong = text.replace("3 m", "x");
    let set = landform::recipe::Override::parse("seed=2").unwrap();
    let error = Recipe::parse(&wrong, "test", std::path::Path::new("."), &[set]).unwrap_err();
    assert!(matches!(error, landform::core::Error::Recipe { at: Some((3, _)), .. }), "{error:?}");
}

#[test]
fn what_fails_in_a_plan_names_its_line() {
    let flat = "[[stage]]\nuse = \"flat\"\ngrid = { size = [\"2 km\", \"2 km\"], cell_size = \"100 m\" }\n";
    let cases = [
        ("[[stage]]\nuse = \"write_raster\"\npath = \"a.tif\"\nfield = \"nonsense\"\n", "line 7", "nonsense"),
        (
            "[[stage]]\nuse = \"channel_erosion\"\niterations = 2\nsprings = [{ at = [\"9 km\", \"1 km\"], discharge = \"1 m3/s\" }]\n",
            "line 7",
            "a place on the map, 0 to 2000 m east",
        ),
        (
            "[[stage]]\nuse = \"crop\"\nregion = [\"1 km\", \"1 km\", \"2 km\", \"2 km\"]\n\
             [[stage]]\nuse = \"stream_automaton\"\nsprings = [[\"500 m\", \"500 m\"]]\n",
            "line 9",
            "1000 to 2000 m east",
        ),
    ];
    for (text, line, what) in cases {
        let recipe = Recipe::parse(&format!("{flat}{text}"), "r.toml", Path::new("."), &[]).unwrap();
        let error = recipe.plan(None, "").unwrap_err().to_string();
        assert!(error.contains(line) && error.contains(what), "{error}");
    }
}
