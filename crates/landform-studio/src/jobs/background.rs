//! Builds, exports and small pictures, one after the other beside the previews.

use std::collections::VecDeque;
use std::path::PathBuf;
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::time::Instant;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use landform::core::terrain::{Body, Surface, Visit, not_a_surface};
use landform::core::verb::{CancelToken, MemoryOutput};
use landform::io::export::{ViewKind, WritePicture};
use landform::io::files::Folder;
use landform::io::format::encode_png;
use landform::io::memory;
use landform::io::render::Picture;
use landform::recipe::{Cache, Options, Outputs, Ran, Recipe, Signal};
use landform::{Error, Result};
use serde_json::json;

use super::state::{Board, Building, Lap};
use super::whole;
use crate::hub::{Hub, lock};

/// Tasks that wait.
const MOST_WAITING: usize = 64;
/// Side of a small picture, pixels.
const SMALL: usize = 256;

/// Something to do in the background.
pub(crate) struct Task {
    pub(crate) recipe: Recipe,
    /// Places of the recipe's stages in the list of steps.
    pub(crate) steps: Vec<usize>,
    pub(crate) work: Work,
}

pub(crate) enum Work {
    /// The recipe with its files.
    Build,
    /// One file of it.
    Export,
    /// A small picture with a seed.
    Contact(u64),
}

impl Work {
    fn name(&self) -> &'static str {
        match self {
            Self::Build => "build",
            Self::Export => "export",
            Self::Contact(_) => "contact",
        }
    }
}

/// Does tasks in order.
pub(crate) struct Background {
    desk: Mutex<Desk>,
    wake: Condvar,
    hub: Arc<Hub>,
    /// Cache of small pictures.
    small: Cache,
    output: PathBuf,
    salt: String,
}

#[derive(Default)]
struct Desk {
    tasks: VecDeque<Task>,
    running: Option<CancelToken>,
    closed: bool,
}

impl Background {
    /// Writes to `output`; `salt` differs between builds of the program, as for the cache there.
    pub(crate) fn new(hub: Arc<Hub>, output: PathBuf, salt: String, memory: u64) -> Self {
        let (desk, wake, small) = (Mutex::default(), Condvar::new(), Cache::in_memory(memory));
        Self { desk, wake, hub, small, output, salt }
    }

    /// Puts tasks to those that wait.
    ///
    /// # Errors
    /// [`Error::Recipe`] if too many do.
    pub(crate) fn ask(&self, tasks: Vec<Task>) -> Result<()> {
        let mut desk = lock(&self.desk);
        if desk.tasks.len() + tasks.len() > MOST_WAITING {
            let hint = Some("wait, or cancel them".into());
            return Err(Error::Recipe { at: None, what: "too many builds and pictures wait already".into(), hint });
        }
        desk.tasks.extend(tasks);
        self.wake.notify_one();
        Ok(())
    }

    /// Cancels what runs and what waits; whether there was something.
    pub(crate) fn cancel(&self) -> bool {
        let mut desk = lock(&self.desk);
        let waited = !desk.tasks.is_empty();
        desk.tasks.clear();
        desk.running.iter().for_each(CancelToken::cancel);
        waited || desk.running.is_some()
    }

    pub(crate) fn close(&self) {
        self.cancel();
        lock(&self.desk).closed = true;
        self.wake.notify_one();
    }

    /// Works until it is closed.
    pub(crate) fn work(&self, board: &Board) {
        loop {
            let (task, cancel) = {
                let mut desk = lock(&self.desk);
                desk.running = None;
                if desk.tasks.is_empty() {
                    drop(desk);
                    board.set(&self.hub, |state| state.building = None);
                    desk = lock(&self.desk);
                }
                let task = loop {
                    if desk.closed {
                        return;
                    }
                    match desk.tasks.pop_front() {
                        Some(task) => break task,
                        None => desk = self.wake.wait(desk).unwrap_or_else(PoisonError::into_inner),
                    }
                };
                let cancel = CancelToken::default();
                desk.running = Some(cancel.clone());
                (task, cancel)
            };
            let (began, name) = (Instant::now(), task.work.name());
            match whole(|| self.run(&task, &cancel, board)) {
                Ok(true) => self.hub.log("note", &format!("{name}: done in {:.1} s", began.elapsed().as_secs_f64())),
                Ok(false) => self.hub.log("note", &format!("{name}: cancelled")),
                Err(error) => {
                    let hint = error.hint().map_or(String::new(), |hint| format!("; {hint}"));
                    self.hub.log("error", &format!("{name}: {error}{hint}"));
                    self.hub.event(
                        &json!({ "tell": "failed", "what": name, "error": error.to_string(), "hint": error.hint() }),
                    );
                }
            }
        }
    }

    /// Does a task; false if it was cancelled.
    fn run(&self, task: &Task, cancel: &CancelToken, board: &Board) -> Result<bool> {
        let (began, lap) = (Instant::now(), Lap::default());
        let waiting = lock(&self.desk).tasks.len();
        let building = Mutex::new(Building { what: task.work.name(), waiting, ..Building::default() });
        let progress = |signal: Signal| {
            if let Signal::Stage { index, cached, .. } = signal {
                lap.begin(index, cached);
            }
            let mut building = lock(&building);
            building.seconds = began.elapsed().as_secs_f64();
            match &signal {
                Signal::Stage { index, of, name, .. } => {
                    building.stage = task.steps.get(index - 1).copied();
                    (building.of, building.name, building.part) = (*of, name.clone(), None);
                }
                Signal::Step { part, .. } => building.part = *part,
                Signal::Note(note) if matches!(task.work, Work::Build) => self.hub.log("note", note),
                _ => {}
            }
            board.nudge(&self.hub, |state| state.building = Some(building.clone()));
        };
        board.set(&self.hub, |state| state.building = Some(lock(&building).clone()));
        let options = Options { cancel: cancel.clone(), progress: &progress, ..Options::default() };
        match task.work {
            Work::Contact(seed) => self.contact(&task.recipe, seed, options),
            _ => self.build(&task.recipe, options, began),
        }
    }

    fn build(&self, recipe: &Recipe, options: Options, began: Instant) -> Result<bool> {
        let mut folder = Folder::create(&self.output)?;
        let cache = Cache::on_disk(&self.output.join(".landform").join("cache"));
        let plan = recipe.plan(Some(&cache), &self.salt)?;
        if let Some(available) = memory::available().filter(|available| plan.bytes > *available) {
            return Err(Error::Memory { what: "this recipe".into(), needed: plan.bytes, available });
        }
        self.check_files(recipe, &folder)?;
        let options = Options { cache: Some(&cache), salt: self.salt.clone(), ..options };
        let Ran::ToTheEnd(..) = recipe.run(&mut folder, &options)? else { return Ok(false) };
        let files: Vec<_> = folder
            .written()
            .iter()
            .map(|file| {
                let path = file.strip_prefix(&self.output).unwrap_or(file).display().to_string();
                json!({ "path": path, "bytes": std::fs::metadata(file).map_or(0, |meta| meta.len()) })
            })
            .collect();
        self.hub.event(&json!({ "tell": "built", "files": files, "seconds": began.elapsed().as_secs_f64() }));
        Ok(true)
    }

    /// Refuses what would write over a link, or over a file that the recipe reads.
    fn check_files(&self, recipe: &Recipe, folder: &Folder) -> Result<()> {
        let state = self.output.join(".landform");
        if std::fs::symlink_metadata(&state).is_ok_and(|meta| meta.is_symlink()) {
            return Err(Error::Outside { name: "output".into(), path: state.display().to_string(), by_link: true });
        }
        let inputs: Vec<PathBuf> = recipe.inputs().filter_map(|path| path.canonicalize().ok()).collect();
        let root = self.output.canonicalize().map_err(|e| Error::io("find", &self.output, e))?;
        let over = |path: &str| {
            let what = format!("`{path}` would be written over a file that the recipe reads");
            Error::Recipe { at: None, what, hint: Some("give it another `path`".into()) }
        };
        for path in recipe.outputs() {
            folder.check(&path)?;
            if self.output.join(&path).canonicalize().is_ok_and(|target| inputs.contains(&target)) {
                return Err(over(&path));
            }
        }
        let mut inside = inputs.iter().filter_map(|input| input.strip_prefix(&root).ok()?.to_str());
        inside.find(|path| recipe.is_frame(path)).map_or(Ok(()), |path| Err(over(path)))
    }

    fn contact(&self, recipe: &Recipe, seed: u64, options: Options) -> Result<bool> {
        let options = Options { cache: Some(&self.small), outputs: Outputs::Nothing, ..options };
        let Ran::ToTheEnd(ground, _) = recipe.run(&mut MemoryOutput::default(), &options)? else { return Ok(false) };
        let picture = WritePicture { view: ViewKind::Map, size: SMALL, ..WritePicture::default() };
        let picture = ground.visit(Drawing(picture.in_environment(&recipe.environment)))?;
        let png = encode_png(&picture.pixels, picture.shape)?;
        self.hub.event(&json!({ "tell": "contact", "seed": seed, "png": STANDARD.encode(png) }));
        Ok(true)
    }
}

struct Drawing(WritePicture);

impl Visit for Drawing {
    type Out = Result<Picture>;

    fn surface<T: Surface>(self, terrain: &T) -> Result<Picture> {
        self.0.draw(terrain)
    }

    fn body<T: Body>(self, _: &T) -> Self::Out {
        Err(not_a_surface(T::KIND, "a picture"))
    }
}
