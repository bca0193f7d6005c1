use serde_json::json;

use super::*;
use crate::text::{Key, blocks};

const TEXT: &str = "# A hill that rises.\nseed = 3 # lucky\n\n[environment]\nsea_level = \"0 m\"\n\n# The start.\n[[stage]]\nuse = \"flat\"\n    grid = { size = [\"1 km\", \"1 km\"], cell_size = \"100 m\" } # small\n\n[[stage]]\nuse = \"evolve\"\n    clock = { dt = \"1 kyr\", duration = \"5 kyr\" }\nprocess = [\n  { use = \"uplift\", rate = \"1 mm/yr\" }, # up\n    \x20 { use = \"linear_diffusion\" },\n]\n\n[[stage]]\nuse = \"write_raster\" # the end\n";

fn session() -> (tempfile::TempDir, Session) {
    let folder = tempfile::tempdir().unwrap();
    let root = Arc::new(Root::new(folder.path()).unwrap());
    let mut session = Session::new(root, &folder.path().join("out"));
    session.edit(&Request::Text { text: TEXT.into() }).unwrap();
    (folder, session)
}

fn set(stage: Option<usize>, process: Option<usize>, key: &[&str], value: Json) -> Request {
    let key = key.iter().map(|key| Key::Name((*key).into())).collect();
    Request::Set { stage, process, key, value, dragging: false, stamp: None }
}

#[test]
fn a_page_gets_steps_values_and_errors_with_places() {
    let (_folder, mut session) = session();
    let view = view_of(&session);
    assert_eq!(view["errors"], json!([]), "{view}");
    assert_eq!((&view["seed"], &view["stages"][1]["line"]), (&json!(3), &json!(12)));
    assert_eq!(view["stages"][1]["processes"][1]["values"]["diffusivity"], "0.01 m2/yr");
    assert_eq!(view["stages"][1]["values"]["clock"]["tolerance"], 0.001);
    assert_eq!(view["stages"][0]["nodes"], 121);
    session.edit(&set(Some(1), Some(0), &["rate"], json!("1 m"))).unwrap();
    session.edit(&set(Some(0), None, &["elevatoin"], json!("1 m"))).unwrap();
    let view = view_of(&session);
    let errors = view["errors"].as_array().unwrap();
    assert_eq!(errors.len(), 2, "{errors:?}");
    assert!(errors.iter().any(|e| e["stage"] == 0 && e["hint"].as_str().unwrap().contains("elevation")));
    assert!(errors.iter().any(|e| e["stage"] == 1 && e["line"] == 17), "{errors:?}");
    assert_eq!(view["stages"][0]["given"]["elevatoin"], "1 m");
    for hostile in ["", "[[stage", "= = =", "[[stage]]\n", "stage = 3", "\u{0}", "[[stage]]\nuse = 5", "seed = -1"] {
        session.edit(&Request::Text { text: hostile.into() }).unwrap();
        assert!(!session.reading.errors.is_empty() && view_of(&session)["errors"].is_array(), "{hostile}");
    }
    let long = "#".repeat(MOST_TEXT + 1);
    assert!(session.edit(&Request::Text { text: long }).is_err());
}

#[test]
fn a_thousand_edits_taken_back_give_the_first_bytes() {
    let (_folder, mut session) = session();
    // A fixed row of numbers that look random.
    let mut number = 12_345_u64;
    let mut draw = |below: usize| {
        number = number.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (number >> 33) as usize % below.max(1)
    };
    let mut changes = 0;
    let mut texts = vec![session.history.now().clone()];
    for k in 0..1_000 {
        let steps = blocks(session.history.now()).len();
        let request = match draw(9) {
            0 => set(None, None, &["seed"], json!(k)),
            1 => set(Some(draw(steps)), None, &["clock", "dt"], json!(format!("{} yr", 1 + draw(99)))),
            2 => set(Some(draw(steps)), Some(draw(3)), &["rate"], json!(format!("{k} mm/yr"))),
            3 => set(Some(draw(steps)), None, &["grid", "cell_size"], json!(null)),
            4 => Request::Insert { at: draw(steps + 1), name: "add".into(), process_of: None },
            5 => Request::Insert { at: draw(4), name: "uplift".into(), process_of: Some(draw(steps)) },
            6 => Request::Remove { stage: draw(steps), process: [None, Some(draw(4))][draw(2)] },
            7 => Request::Move { stage: draw(steps), to: draw(steps) },
            _ => Request::Toggle { stage: draw(steps) },
        };
        if session.edit(&request).is_ok_and(|changed| changed) {
            changes += 1;
            texts.push(session.history.now().clone());
            assert!(
                session.history.now().parse::<toml_edit::DocumentMut>().is_ok(),
                "{request:?}\n{}",
                session.history.now()
            );
        }
    }
    assert!(changes > 400, "{changes}");
    for text in texts.iter().rev().skip(1) {
        assert!(session.edit(&Request::Undo).unwrap());
        assert_eq!(session.history.now(), text);
    }
    assert_eq!(&**session.history.now(), TEXT);
    for text in &texts[1..] {
        assert!(session.edit(&Request::Redo).unwrap());
        assert_eq!(session.history.now(), text);
    }
    assert!(session.edit(&Request::Redo).is_err());
}

#[test]
fn a_drag_is_taken_back_at_once() {
    let (_folder, mut session) = session();
    for k in 1..=20 {
        let Request::Set { stage, process, key, .. } = set(Some(1), Some(0), &["rate"], json!(null)) else { panic!() };
        let value = json!(format!("{k} mm/yr"));
        session.edit(&Request::Set { stage, process, key, value, dragging: k < 20, stamp: None }).unwrap();
    }
    assert!(session.history.now().contains("\"20 mm/yr\" }, # up"));
    session.edit(&Request::Undo).unwrap();
    assert_eq!(&**session.history.now(), TEXT);
}

#[test]
fn steps_that_are_off_stay_in_the_text() {
    let (_folder, mut session) = session();
    session.edit(&Request::Toggle { stage: 1 }).unwrap();
    let view = view_of(&session);
    assert_eq!((&view["stages"][1]["on"], &view["stages"][1]["use"]), (&json!(false), &json!("evolve")));
    assert_eq!(view["stages"][2]["nodes"], 121, "{view}");
    assert_eq!(session.steps(), [0, 2]);
    session.shown = Some(1);
    assert_eq!(session.shown_on(), Some(0));
    session.edit(&Request::Toggle { stage: 1 }).unwrap();
    assert_eq!(&**session.history.now(), TEXT);
}

#[test]
fn every_stage_can_be_put_in_and_shown() {
    let (_folder, mut session) = session();
    let names: Vec<&str> = landform::recipe::stages().map(|stage| stage.name).chain(["evolve"]).collect();
    for name in names {
        session.edit(&Request::Insert { at: 1, name: name.into(), process_of: None }).unwrap();
        let view = view_of(&session);
        assert_eq!(view["stages"][1]["use"], name);
        assert!(view["stages"][1]["values"].is_object(), "{name}");
        session.edit(&Request::Undo).unwrap();
    }
    assert!(session.edit(&Request::Insert { at: 0, name: "upluft".into(), process_of: None }).is_err());
}

#[test]
fn files_are_opened_and_saved_below_the_root_alone() {
    let (folder, mut session) = session();
    assert!(session.open_file("../x.toml").is_err() && session.open_file("none.toml").is_err());
    std::fs::write(folder.path().join("a.toml"), TEXT).unwrap();
    session.open_file("a.toml").unwrap();
    assert!(session.is_saved() && session.command().contains("a.toml"));
    session.edit(&set(None, None, &["seed"], json!(4))).unwrap();
    assert!(!session.is_saved());
    session.save(None).unwrap();
    assert!(session.is_saved());
    assert_eq!(std::fs::read_to_string(folder.path().join("a.toml")).unwrap(), TEXT.replace("seed = 3", "seed = 4"));
    for bad in ["../b.toml", "b.sh", "/tmp/b.toml", "out/.landform/b.toml"] {
        assert!(session.save(Some(bad)).is_err(), "{bad}");
    }
    session.save(Some("inner/b.toml")).unwrap();
    assert!(session.save(Some("a.toml")).is_err(), "another file is not written over");
    // What another program wrote is not lost.
    std::fs::write(folder.path().join("inner/b.toml"), "seed = 9").unwrap();
    assert!(session.save(None).is_err());
}

#[test]
fn a_gallery_recipe_comes_with_its_data() {
    let (folder, mut session) = session();
    session.open_gallery("painted_uplift").unwrap();
    assert_eq!(view_of(&session)["errors"], json!([]));
    session.save(None).unwrap();
    assert!(folder.path().join("data/uplift_strokes.png").is_file());
    assert_eq!(view_of(&session)["errors"], json!([]));
    assert!(session.open_gallery("nowhere").is_err());
}

#[test]
fn a_stroke_becomes_part_of_a_value_and_is_taken_back() {
    let (_folder, mut session) = session();
    let stroke = |key: &str, strength: Json, points: Vec<Vec<f64>>| Request::Stroke {
        stage: 1,
        process: Some(0),
        key: vec![Key::Name(key.into())],
        tool: None,
        radius: json!(200),
        strength,
        points,
    };
    let line = vec![vec![100.04, 500.0, 0.333_333], vec![900.0, 500.0, 1.0, 0.5]];
    session.edit(&stroke("rate", json!(2.5), line.clone())).unwrap();
    assert_eq!(session.reading.errors, []);
    let points = "[[100.0, 500.0, 0.33], [900.0, 500.0, 1.0, 0.5]]";
    let value = format!(
        "rate = {{ strokes = [{{ tool = \"raise\", radius = \"200 m\", strength = \"2.5 mm/yr\", points = {points} }}], base = \"1 mm/yr\" }}"
    );
    assert!(session.history.now().contains(&value), "{}", session.history.now());
    let once = session.history.now().clone();
    session.edit(&stroke("rate", json!("1 mm/yr"), line.clone())).unwrap();
    assert_eq!(session.reading.errors, []);
    assert_eq!(session.history.now().matches("tool = ").count(), 2);
    session.edit(&Request::Undo).unwrap();
    assert_eq!(*session.history.now(), once);
    session.edit(&Request::Undo).unwrap();
    assert_eq!(&**session.history.now(), TEXT);
    assert!(session.edit(&stroke("rat", json!(1), line.clone())).is_err());
    assert!(session.edit(&stroke("rate", json!(1), vec![])).is_err());
    let long = vec![vec![123_456.7, 123_456.7, 0.25, 12.34]; 2_000];
    session.edit(&stroke("rate", json!(1), long.clone())).unwrap();
    assert!(session.edit(&stroke("rate", json!(1), long)).is_err(), "more than 64 kB");
}
