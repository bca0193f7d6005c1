//! The studio: requests of pages come in, jobs and tells go out.

use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

use landform::io::memory;
use landform::recipe::{Level, Override, Recipe};
use landform::{Error, Result};
use serde_json::{Map, Value as Json, json};

use crate::hub::{Hub, Page, Slot, lock};
use crate::jobs::{Background, Charts, Order, Piece, Task, Tool, Work, Worker, halved};
use crate::protocol::{Numbered, Request};
use crate::root::{Root, random_word};
use crate::session::{Session, refusal, verb, view_of};
use crate::text::{self, Key};

/// Most memory for ground of earlier runs, bytes.
const MOST_KEPT: u64 = 1 << 30;
/// Seeds of one sheet.
const MOST_SEEDS: usize = 32;
/// Nodes of a small picture's ground are about so many.
const SMALL_NODES: u64 = 128 * 128;

/// How a recipe is to be run.
#[derive(Clone, Copy, Default)]
struct Way {
    /// The one level; from coarse to fine if none.
    level: Option<Level>,
    dragging: bool,
    /// When the change was made, by the page's clock, and when it came, ms.
    stamp: Option<(f64, f64)>,
    /// Whether every step is shown.
    watched: bool,
    /// The stage whose processes go on from where they are.
    goes_on: Option<usize>,
}

/// Whether a value is one of a process and not of its clock or place.
fn is_of_a_process(process: Option<usize>, key: &[Key]) -> bool {
    let others = ["clock", "label", "from", "with", "watch", "use", "process"];
    process.is_some() || !matches!(key.first(), Some(Key::Name(name)) if others.contains(&name.as_str()))
}

/// A session with its pages and its threads.
pub(crate) struct Studio {
    pub(crate) hub: Arc<Hub>,
    pub(crate) session: Arc<Mutex<Session>>,
    pub(crate) output: PathBuf,
    root: Arc<Root>,
    worker: Arc<Worker>,
    charts: Arc<Charts>,
    background: Arc<Background>,
    threads: Vec<std::thread::JoinHandle<()>>,
}

impl Studio {
    /// # Errors
    /// [`Error::Io`] if the root is not there.
    pub(crate) fn new(root: &Path, output: &Path, salt: &str) -> Result<Self> {
        let root = Arc::new(Root::new(root)?);
        let hub = Arc::new(Hub::new(random_word()?));
        let session = Arc::new(Mutex::new(Session::new(root.clone(), output)));
        let kept = memory::available().map_or(MOST_KEPT, |left| (left / 8).min(MOST_KEPT));
        let charts = Arc::new(Charts::new(hub.clone()));
        let background = Arc::new(Background::new(hub.clone(), output.into(), salt.into(), kept / 8));
        let (told, of) = (hub.clone(), session.clone());
        let timed = move |revision, seconds| {
            let mut session = lock(&of);
            if session.revision == revision {
                session.take_times(seconds);
                told.tell(Slot::Recipe, &view_of(&session));
            }
        };
        let worker = Arc::new(Worker::new(hub.clone(), charts.clone(), kept, timed));
        let mut threads = Vec::new();
        let mut spawn = |name: &str, work: Box<dyn FnOnce() + Send>| -> Result<()> {
            let thread = std::thread::Builder::new().name(name.into()).spawn(work);
            threads.push(thread.map_err(|e| Error::io("start", name, e))?);
            Ok(())
        };
        spawn(
            "preview",
            Box::new({
                let worker = worker.clone();
                move || worker.work()
            }),
        )?;
        spawn(
            "charts",
            Box::new({
                let charts = charts.clone();
                move || charts.work()
            }),
        )?;
        spawn(
            "background",
            Box::new({
                let (background, worker) = (background.clone(), worker.clone());
                move || background.work(&worker.board)
            }),
        )?;
        hub.tell(Slot::Recipe, &view_of(&lock(&session)));
        Ok(Self { hub, session, output: output.into(), root, worker, charts, background, threads })
    }

    /// Opens a recipe of the gallery or a file, before pages come.
    ///
    /// # Errors
    /// If it cannot be read.
    pub(crate) fn open(&self, gallery: Option<&str>, path: Option<&str>) -> Result<()> {
        {
            let mut session = lock(&self.session);
            match (gallery, path) {
                (Some(name), None) => session.open_gallery(name)?,
                (None, Some(path)) => session.open_file(path)?,
                _ => return Err(Error::parameter("open", "both or none", "either `gallery` or `path`")),
            }
            self.hub.forget();
            self.hub.tell(Slot::Recipe, &view_of(&session));
        }
        self.worker.stop();
        self.worker.forget();
        self.preview(None);
        Ok(())
    }

    /// Answers a request of a page.
    pub(crate) async fn take(&self, page: &Page, Numbered { request, what }: Numbered) {
        let silent = matches!(what, Request::Ack { .. });
        let answer = match self.act(page, what).await {
            Ok(Json::Null) => json!({ "tell": "done", "request": request }),
            Ok(mut more) => {
                more["tell"] = "done".into();
                more["request"] = request.into();
                more
            }
            Err(error) => refusal(request, &error),
        };
        if !silent || request > 0 {
            page.answer(answer).await;
        }
    }

    async fn act(&self, page: &Page, what: Request) -> Result<Json> {
        match what {
            Request::Hello { protocol } => {
                if protocol.is_some_and(|protocol| protocol != 1) {
                    return Err(Error::parameter("protocol", protocol.unwrap_or(0), "1: load the page again"));
                }
                page.answer(json!({ "tell": "welcome", "protocol": 1, "version": env!("CARGO_PKG_VERSION"),
                    "session": self.hub.session, "root": self.root.folder().display().to_string(),
                    "output": self.output.display().to_string(), "can": ["paint", "stroke"] }))
                    .await;
                self.hub.welcome(page);
            }
            Request::Ack { frame } => page.acknowledge(frame),
            Request::Open { gallery, path } => self.open(gallery.as_deref(), path.as_deref())?,
            Request::Run { level } => {
                let level = if level == "build" { "1".into() } else { level };
                let level = if level == "auto" { None } else { Some(level.parse()?) };
                self.check_recipe()?;
                self.run(Way { level, watched: level.is_some(), ..Way::default() });
            }
            Request::Pause => {
                self.worker.control.pause();
                let busy = self.worker.is_busy();
                self.worker.board.set(&self.hub, |state| state.paused = busy);
            }
            Request::Play { pace } => {
                self.run_again()?;
                self.worker.control.play(pace);
                self.worker.board.set(&self.hub, |state| state.paused = false);
            }
            Request::Step => {
                self.run_again()?;
                self.worker.control.step();
            }
            Request::Stop => {
                self.worker.stop();
                self.worker.control.play(None);
            }
            Request::Show { fields, stage } => {
                let wants = fields.is_some_and(|fields| page.want(fields));
                let mut session = lock(&self.session);
                let moved = session.shown != stage;
                session.shown = stage;
                drop(session);
                if (wants || moved) && lock(&self.session).reading.recipe.is_some() {
                    self.show_again(moved);
                }
            }
            Request::Paint { field, tool, radius, strength, points } => {
                self.paint(field.as_deref(), &tool, Piece { tool: Tool::Raise, radius, strength, points })?;
            }
            Request::Build => {
                let (recipe, steps) = self.check_recipe()?;
                self.background.ask(vec![Task { recipe, steps, work: Work::Build }])?;
            }
            Request::CancelBuild => {
                if !self.background.cancel() {
                    return Err(Error::Recipe { at: None, what: "nothing is being built".into(), hint: None });
                }
            }
            Request::Export { name, parameters } => self.export(&name, parameters)?,
            Request::Contact { seeds } => self.contact(&seeds)?,
            Request::Save { path } => {
                let mut session = lock(&self.session);
                let file = session.save(path.as_deref())?;
                self.hub.tell(Slot::Recipe, &view_of(&session));
                return Ok(json!({ "path": file.display().to_string() }));
            }
            Request::Command => {
                let command = lock(&self.session).command();
                return Ok(json!({ "command": command, "text": command }));
            }
            edit => return self.edit(&edit),
        }
        Ok(Json::Null)
    }

    fn edit(&self, edit: &Request) -> Result<Json> {
        let (dragging, stamp) = match edit {
            Request::Set { dragging, stamp, .. } => (*dragging, stamp.map(|page| (page, self.hub.clock()))),
            _ => (false, None),
        };
        let mut session = lock(&self.session);
        let changed = session.edit(edit)?;
        let revision = session.revision;
        let is_right = session.reading.recipe.is_some();
        if changed {
            self.hub.tell(Slot::Recipe, &view_of(&session));
        }
        drop(session);
        let process = match edit {
            Request::Set { stage: Some(stage), process, key, .. } if is_of_a_process(*process, key) => {
                lock(&self.session).steps().iter().position(|step| step == stage)
            }
            _ => None,
        };
        // The end of a drag asks for the finer levels, though no value changes any more.
        if is_right && (changed || (!dragging && matches!(edit, Request::Set { .. }))) {
            self.run(Way { dragging, stamp, goes_on: process.filter(|_| dragging), ..Way::default() });
        }
        Ok(json!({ "revision": revision }))
    }

    /// The recipe, if nothing is wrong with it, and the places of its stages among the steps.
    fn check_recipe(&self) -> Result<(Recipe, Vec<usize>)> {
        let session = lock(&self.session);
        let recipe = session.reading.recipe.clone().ok_or_else(|| {
            let first = session.reading.errors.first();
            let what =
                first.map_or("there is no recipe yet".into(), |first| format!("the recipe is wrong: {}", first.what));
            Error::Recipe { at: None, what, hint: first.and_then(|first| first.hint.clone()) }
        })?;
        Ok((recipe, session.steps()))
    }

    /// Asks for a run that shows what it comes to.
    fn preview(&self, level: Option<Level>) {
        self.run(Way { level, ..Way::default() });
    }

    /// Asks for a run.
    fn run(&self, way: Way) {
        if !way.watched {
            // Only a run that is looked at from step to step is held.
            self.worker.control.play(None);
        }
        let session = lock(&self.session);
        let Some(recipe) = session.reading.recipe.clone() else { return };
        let nodes = session.reading.planned.iter().map(|stage| stage.0).max().unwrap_or(0);
        let (steps, shown, revision) = (session.steps(), session.shown_on(), session.revision);
        let Way { level, dragging, stamp, watched, goes_on } = way;
        self.worker.ask(Order { recipe, revision, steps, nodes, level, dragging, stamp, shown, watched, goes_on });
    }

    /// Paints into the model that runs or is held; where none is, the last process goes on from its
    /// end.
    fn paint(&self, field: Option<&str>, tool: &str, piece: Piece) -> Result<()> {
        if let Some(field) = field.filter(|field| *field != "elevation") {
            return Err(Error::parameter("field", format!("`{field}`"), "`elevation`, the one that is painted so far"));
        }
        let tool = match tool {
            "raise" => Tool::Raise,
            "lower" => Tool::Lower,
            "smooth" => Tool::Smooth,
            "level" => Tool::Level,
            other => return Err(Error::parameter("tool", format!("`{other}`"), "raise, lower, smooth or level")),
        };
        let piece = Piece { tool, ..piece };
        if self.worker.is_watched() {
            self.worker.easel.put(piece)?;
            self.worker.control.nudge();
            return Ok(());
        }
        let (recipe, _) = self.check_recipe()?;
        let level = self.worker.board.get().level.parse().ok();
        let processes = recipe.listed().iter().rposition(|stage| stage.clock.is_some());
        let last = processes.filter(|&stage| level.is_some_and(|level| self.worker.can_go_on(level, stage)));
        let Some(last) = last else {
            let hint = Some("press Play or Step, and paint while it runs or is held".into());
            return Err(Error::Recipe { at: None, what: "no process runs that could be painted on".into(), hint });
        };
        self.worker.easel.put(piece)?;
        self.worker.control.play(None);
        self.run(Way { level, watched: true, goes_on: Some(last), ..Way::default() });
        Ok(())
    }

    /// Runs with every step shown, unless something runs.
    fn run_again(&self) -> Result<()> {
        if !self.worker.is_watched() {
            self.check_recipe()?;
            let level = self.worker.board.get().level.parse().ok();
            self.run(Way { level, watched: true, ..Way::default() });
        }
        Ok(())
    }

    /// Shows the ground anew, from the cache as far as it goes.
    fn show_again(&self, moved: bool) {
        if moved {
            self.preview(None);
        } else if !self.worker.is_busy() {
            let level = self.worker.board.get().level.parse().ok();
            self.preview(level);
        }
    }

    /// One export of the ground that is shown.
    fn export(&self, name: &str, parameters: Map<String, Json>) -> Result<()> {
        if verb(name).as_deref() != Some("export") {
            return Err(Error::parameter("use", format!("`{name}`"), "the name of an export, such as `write_raster`"));
        }
        let (recipe, _) = self.check_recipe()?;
        let session = lock(&self.session);
        let last = session.shown_on().unwrap_or(usize::MAX);
        let text = text::only_ground(session.history.now(), last, name, &parameters)?;
        let (recipe, steps) = (Recipe::parse(&text, &recipe.title, &recipe.folder, &[])?, session.steps());
        drop(session);
        self.root.check(&recipe)?;
        recipe.plan(None, "")?;
        self.background.ask(vec![Task { recipe, steps, work: Work::Export }])
    }

    fn contact(&self, seeds: &[u64]) -> Result<()> {
        if seeds.is_empty() || seeds.len() > MOST_SEEDS {
            return Err(Error::parameter("seeds", format!("{} seeds", seeds.len()), &format!("1 to {MOST_SEEDS}")));
        }
        let (recipe, steps) = self.check_recipe()?;
        let session = lock(&self.session);
        let nodes = session.reading.planned.iter().map(|stage| stage.0).max().unwrap_or(0);
        let text = session.history.now().clone();
        drop(session);
        let coarse = (0..=6).find(|&k| nodes >> (2 * k) <= 2 * SMALL_NODES).unwrap_or(6);
        let task = |&seed: &u64| {
            let set = Override::parse(&format!("seed={seed}"))?;
            let whole = Recipe::parse(&text, &recipe.title, &recipe.folder, &[set])?;
            // Some stages need more cells.
            let level = (0..=coarse).rev().find_map(|k| whole.at(halved(k)).ok());
            let recipe = level.ok_or_else(|| Error::Empty { what: "this recipe".into() })?;
            Ok(Task { recipe, steps: steps.clone(), work: Work::Contact(seed) })
        };
        self.background.ask(seeds.iter().map(task).collect::<Result<_>>()?)
    }

    /// Ends all threads.
    fn end(&mut self) {
        self.hub.close();
        self.worker.close();
        self.charts.close();
        self.background.close();
        self.threads.drain(..).for_each(|thread| {
            thread.join().ok();
        });
    }
}

impl Drop for Studio {
    fn drop(&mut self) {
        self.end();
    }
}
