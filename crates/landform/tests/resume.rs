//! Runs that are interrupted and gone on with, and what they leave beside their terrain.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on panics")]

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use landform::core::Error;
use landform::core::verb::{CancelToken, MemoryOutput};
use landform::prelude::Landscape;
use landform::recipe::{Cache, Options, Ran, Recipe, Signal};

/// Twelve steps that are watched.
fn watched(name: &str) -> String {
    format!(
        "[[stage]]\nuse = \"evolve\"\nlabel = \"{name}\"\nclock = {{ dt = \"10 kyr\", duration = \"120 kyr\" }}\n\
         watch = {{ table = \"{name}.csv\", animation = \"{name}.gif\", frames = \"{name}.png\", steps = 2, size = 16 }}\n\
         process = [ {{ use = \"uplift\" }}, {{ use = \"stream_power\" }} ]\n"
    )
}

fn text(stages: &str) -> String {
    let head = "seed = 2\n[[stage]]\nuse = \"noise\"\ngrid = { size = [\"3 km\", \"3 km\"], cell_size = \"300 m\" }\n";
    format!("{head}{stages}")
}

fn recipe(stages: &str) -> Recipe {
    Recipe::parse(&text(stages), "t", Path::new("."), &[]).unwrap()
}

/// What a run left and said.
#[derive(Default)]
struct Told {
    files: BTreeMap<String, Vec<u8>>,
    notes: Vec<String>,
    /// Steps of which it told, in order.
    steps: Vec<u64>,
    ended: bool,
}

/// A run that saves after each step; `each` is called in each, before it is saved.
fn run(stages: &str, options: Options, each: impl Fn(&CancelToken, usize, u64) + Sync) -> Result<Told, Error> {
    let (cancel, stage) = (CancelToken::default(), Mutex::new(0));
    let said = Mutex::new(Told::default());
    let progress = |signal: Signal| match signal {
        Signal::Stage { index, .. } => *stage.lock().unwrap() = index,
        Signal::Step { steps, .. } => {
            said.lock().unwrap().steps.push(steps);
            each(&cancel, *stage.lock().unwrap(), steps);
        }
        Signal::Note(note) => said.lock().unwrap().notes.push(note),
        Signal::Outcome(_) => {}
    };
    let mut out = MemoryOutput::default();
    let options = Options { cancel: cancel.clone(), checkpoint_every: 0.0, progress: &progress, ..options };
    let ran = recipe(stages).run(&mut out, &options)?;
    let said = said.into_inner().unwrap();
    Ok(Told { files: out.0, ended: matches!(ran, Ran::ToTheEnd(..)), ..said })
}

fn to_the_end(stages: &str, options: Options) -> Told {
    let told = run(stages, options, |_, _, _| {}).unwrap();
    assert!(told.ended);
    told
}

fn stopped(stages: &str, options: Options, at: (usize, u64)) -> Told {
    let told = run(stages, options, |cancel, stage, steps| {
        if (stage, steps) == at {
            cancel.cancel();
        }
    });
    let told = told.unwrap();
    assert!(!told.ended);
    told
}

fn kept(path: &Path, resume: bool) -> Options<'static> {
    Options { checkpoint: Some(path.into()), resume, ..Options::default() }
}

/// Copies a checkpoint with what lies beside it, as a kill would leave it.
fn copy(from: &Path, to: &Path) {
    std::fs::copy(from, to).unwrap();
    std::fs::create_dir_all(pieces(to)).unwrap();
    for piece in std::fs::read_dir(pieces(from)).unwrap() {
        let piece = piece.unwrap();
        std::fs::copy(piece.path(), pieces(to).join(piece.file_name())).unwrap();
    }
}

fn pieces(path: &Path) -> PathBuf {
    path.with_extension("watch")
}

#[test]
fn a_resumed_run_shows_all_that_was_watched() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("c.lfc");
    let stages = watched("a");
    let whole = to_the_end(&stages, Options::default());
    assert_eq!(whole.files.len(), 8, "a table, an animation and six frames");
    for at in [1, 2, 5, 10] {
        stopped(&stages, kept(&path, false), (2, at));
        let again = stopped(&stages, kept(&path, true), (2, at + 1));
        assert_eq!(again.steps, [at + 1]);
        let resumed = to_the_end(&stages, kept(&path, true));
        assert!(resumed.files == whole.files, "stopped at {at}");
        assert!(!path.exists() && !pieces(&path).exists(), "nothing is left");
    }
}

#[test]
fn a_killed_run_shows_all_that_was_watched() {
    let folder = tempfile::tempdir().unwrap();
    let (path, left) = (folder.path().join("c.lfc"), folder.path().join("left.lfc"));
    let stages = watched("a");
    let whole = run(&stages, kept(&path, false), |_, _, steps| {
        if steps == 8 {
            copy(&path, &left);
        }
    });
    // The kill came between what was seen and the model.
    let ends = |name: &str| pieces(&left).join(name);
    std::fs::copy(ends("000000000007.lfc"), ends("000000000009.lfc")).unwrap();
    let resumed = to_the_end(&stages, kept(&left, true));
    assert_eq!(resumed.steps, [8, 9, 10, 11, 12]);
    assert!(resumed.files == whole.unwrap().files);
}

#[test]
fn a_watched_stage_before_the_interrupted_one_leaves_its_state_alone() {
    let folder = tempfile::tempdir().unwrap();
    let (path, cache) = (folder.path().join("c.lfc"), Cache::on_disk(&folder.path().join("cache")));
    let stages = watched("a") + &watched("b");
    let whole = to_the_end(&stages, Options::default());
    let cached = |resume| Options { cache: Some(&cache), ..kept(&path, resume) };
    stopped(&stages, cached(false), (3, 7));
    stopped(&stages, cached(true), (2, 3));
    let resumed = to_the_end(&stages, cached(true));
    assert_eq!(resumed.steps, (1..=12).chain(8..=12).collect::<Vec<_>>(), "only the first begins anew");
    assert!(resumed.files == whole.files);
}

#[test]
fn a_run_afresh_says_that_it_could_go_on_and_spares_what_is_further() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("c.lfc");
    let stages = watched("a");
    let whole = to_the_end(&stages, kept(&path, false));
    assert!(whole.notes.is_empty(), "{:?}", whole.notes);
    stopped(&stages, kept(&path, false), (2, 6));
    let afresh = stopped(&stages, kept(&path, false), (2, 3));
    let note = afresh.notes.join("\n");
    assert!(note.contains("--resume") && note.contains("step 6") && note.contains("c.lfc"), "{note}");
    let resumed = to_the_end(&stages, kept(&path, true));
    assert_eq!(resumed.steps[0], 7);
    assert!(resumed.files == whole.files);
    let nothing = to_the_end(&stages, kept(&path, true));
    assert!(nothing.notes.join("\n").contains("no checkpoint"), "{:?}", nothing.notes);
}

#[test]
fn what_cannot_be_gone_on_from_is_named_with_the_way_on() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("c.lfc");
    let stages = watched("a");
    stopped(&stages, kept(&path, false), (2, 6));
    let spoil = |file: &Path, spoilt: &[u8], stages: &str| {
        let whole = std::fs::read(file).unwrap();
        std::fs::write(file, spoilt).unwrap();
        let error = run(stages, kept(&path, true), |_, _, _| {}).err().unwrap();
        std::fs::write(file, whole).unwrap();
        assert!(error.hint().unwrap_or_default().contains("without --resume"), "{error}: {:?}", error.hint());
        error.to_string()
    };
    let model = std::fs::read(&path).unwrap();
    let mut damaged = model.clone();
    damaged[model.len() / 2] ^= 1;
    for spoilt in [&damaged[..], &model[..model.len() - 3], &model[..20], b"no state"] {
        let said = spoil(&path, spoilt, &stages);
        assert!(said.contains("c.lfc"), "{said}");
    }
    let piece = pieces(&path).join("000000000004.lfc");
    let said = spoil(&piece, b"LANDFRM2", &stages);
    assert!(said.contains("000000000004.lfc"), "{said}");
    let other = stages.replace("size = 16", "size = 20");
    let said = spoil(&path, &model, &other);
    assert!(said.contains("`watch` asked for something else"), "{said}");
    std::fs::rename(&piece, folder.path().join("away")).unwrap();
    let said = spoil(&path, &model, &stages);
    assert!(said.contains("after step 3 is missing"), "{said}");
    assert!(to_the_end(&stages, kept(&path, false)).ended, "afresh it runs");
}

#[test]
fn numbered_frames_take_no_other_file_s_name() {
    let parsed = |more: &str| Recipe::parse(&text(&(watched("a") + more)), "t", Path::new("."), &[]);
    let picture = |path: &str| format!("[[stage]]\nuse = \"write_picture\"\npath = \"{path}\"\n");
    for path in ["a_0001.png", "a_0003.png", "./b/../a_5000.png"] {
        let error = parsed(&picture(path)).unwrap_err();
        assert!(error.to_string().contains(path.rsplit('/').next().unwrap()) && error.hint().is_some(), "{error}");
    }
    assert!(parsed(&watched("b").replace("b.png", "a.PNG")).is_err(), "two films of one name");
    for path in ["a.png", "a_01.png", "a_0000.png", "a_5001.png", "b/a_0001.png", "a_0001_0001.png"] {
        assert!(parsed(&picture(path)).is_ok(), "{path}");
    }
    let recipe = parsed("").unwrap();
    assert!(recipe.is_frame("a_0002.png") && !recipe.is_frame("a.png") && !recipe.is_frame("b_0002.png"));
}

#[test]
fn a_landscape_keeps_what_was_noted_of_its_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.pgm");
    std::fs::write(&path, "P2\n4 4\n255\n1 2 3 4\n2 3 4 5\n3 4 5 6\n4 5 6 7\n").unwrap();
    let land = Landscape::open(&path).unwrap();
    let noted = landform::io::format::read_raster(&path).unwrap().notes;
    assert!(!noted.is_empty() && land.notes == noted, "{:?}", land.notes);
}
