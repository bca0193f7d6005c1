//! Files that are written while processes run: a table of steps, pictures, an animation.

use std::borrow::Cow;
use std::fmt::Write;
use std::ops::ControlFlow;

use landform_core::algo::outlets::at_or_under;
use landform_core::analysis::{Summary, summary};
use landform_core::grid::{Domain, Status};
use landform_core::sim::{Every, View};
use landform_core::terrain::{AnyTerrain, Body, NodeSurface, Surface, Visit, not_a_surface};
use landform_core::units::{Duration, Length, YEAR};
use landform_core::verb::{Environment, Output, Params, file_path};
use landform_core::{Error, Result};
use landform_io::export::{ViewKind, WritePicture};
use landform_io::format::{animation_extension, encode_animation, encode_png};
use landform_io::render::Picture;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Clock;
use super::paths::plain;

/// Files to write while processes run.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Watch {
    /// Table of steps (CSV): time, elevations, lakes, change, volumes.
    pub table: Option<String>,
    /// Animation, by its extension: gif, or png (APNG).
    pub animation: Option<String>,
    /// Pictures (PNG), numbered before the extension.
    pub frames: Option<String>,
    /// Time from one picture or row to the next; steps are shortened to meet it. Instead, `steps`
    /// may be given.
    #[schemars(extend("x-above" = 0.0))]
    pub every: Option<Duration>,
    /// Number of steps from one picture or row to the next. If neither this nor `every` is given,
    /// it is 1.
    #[schemars(extend("x-min" = 1))]
    pub steps: Option<u64>,
    /// View that pictures show.
    pub view: ViewKind,
    /// Longer side of pictures, pixels.
    #[schemars(extend("x-min" = 16, "x-max" = 4096))]
    pub size: usize,
    /// Perspective only: factor on elevations.
    #[schemars(extend("x-above" = 0.0, "x-max" = 100.0))]
    pub exaggeration: f64,
    /// Whether pictures show the time.
    pub clock: bool,
    /// Whether the table has a column of wall-clock seconds, which differ from run to run.
    pub seconds: bool,
}

impl Default for Watch {
    fn default() -> Self {
        Self {
            table: None,
            animation: None,
            frames: None,
            every: None,
            steps: None,
            view: ViewKind::Map,
            size: 480,
            exaggeration: 1.0,
            clock: true,
            seconds: false,
        }
    }
}

/// More would fill memory before the animation is written.
const MOST_FRAMES: usize = 5_000;

impl Watch {
    /// Keys and paths of what is written.
    pub(super) fn paths(&self) -> impl Iterator<Item = (&'static str, &str)> {
        let all = [("table", &self.table), ("animation", &self.animation), ("frames", &self.frames)];
        all.into_iter().filter_map(|(key, path)| Some((key, path.as_deref()?)))
    }

    /// Path of a frame, numbered from 1.
    pub(super) fn frame(&self, number: usize) -> Option<String> {
        let path = self.frames.as_deref()?;
        // That it ends with .png, large or small, was checked.
        Some(format!("{}_{number:04}.png", path.get(..path.len().checked_sub(".png".len())?)?))
    }

    /// Files that are written, of the frames the first.
    pub(super) fn outputs(&self) -> impl Iterator<Item = String> {
        self.table.iter().chain(&self.animation).cloned().chain(self.frame(1))
    }

    /// Whether a file may be one of the frames.
    pub(super) fn is_frame(&self, path: &str) -> bool {
        let number = path.rsplit_once('_').and_then(|(_, end)| end.strip_suffix(".png")?.parse().ok());
        let number = number.filter(|number| (1..=MOST_FRAMES).contains(number));
        number.and_then(|number| self.frame(number)).is_some_and(|frame| plain(&frame) == plain(path))
    }

    pub(super) fn check(&self) -> Result<()> {
        for (key, path) in self.paths() {
            file_path(path).map_err(|_| Error::Outside { name: key.into(), path: path.to_string(), by_link: false })?;
        }
        if let Some(path) = &self.table
            && !path.to_lowercase().ends_with(".csv")
        {
            return Err(Error::extension("table", path, &["csv"]));
        }
        if self.every.is_some() && self.steps.is_some() {
            return Err(Error::parameter("steps", "given beside `every`", "one of the two"));
        }
        if let Some(path) = &self.animation {
            animation_extension(path)?;
        }
        if let Some(path) = &self.frames
            && !path.to_lowercase().ends_with(".png")
        {
            return Err(Error::extension("frames", path, &["png"]));
        }
        if self.table.is_none() && self.animation.is_none() && self.frames.is_none() {
            return Err(Error::parameter("watch", "without anything to write", "`table`, `animation` or `frames`"));
        }
        self.picture().validate()
    }

    /// Whether there will be something to see, and not too much.
    pub(super) fn fits(&self, clock: &Clock) -> Result<()> {
        let (Some(every), Some(duration)) = (self.every, clock.duration) else { return Ok(()) };
        let looks = duration.si() / every.si();
        if looks < 1.0 {
            return Err(Error::parameter("every", every, &format!("at most the clock's duration, {duration}")));
        }
        let draws = self.animation.is_some() || self.frames.is_some();
        if draws && looks > MOST_FRAMES as f64 {
            return Err(Error::parameter("every", every, &format!("at most {MOST_FRAMES} looks in {duration}")));
        }
        Ok(())
    }

    pub(super) fn interval(&self) -> Every {
        self.every.map_or(Every::Steps(self.steps.unwrap_or(1)), |t| Every::Time(t.si()))
    }

    fn picture(&self) -> WritePicture {
        WritePicture { view: self.view, size: self.size, exaggeration: self.exaggeration, ..WritePicture::default() }
    }
}

/// Rows and pictures so far.
pub(super) struct Watcher<'a> {
    watch: &'a Watch,
    environment: &'a Environment,
    rows: String,
    frames: Vec<Picture>,
    /// Bytes of rows and number of frames that a checkpoint holds.
    kept: (usize, usize),
    /// Whether steps have no length in time.
    timeless: bool,
    started: std::time::Instant,
}

impl<'a> Watcher<'a> {
    pub(super) fn new(watch: &'a Watch, environment: &'a Environment, timeless: bool) -> Self {
        let seconds = if watch.seconds { ",seconds" } else { "" };
        let rows = format!(
            "step,time_yr,dt_yr,lakes,min_m,mean_m,max_m,residual,supplied_m3,eroded_m3,deposited_m3,exported_m3{seconds}\n"
        );
        Self {
            watch,
            environment,
            kept: (rows.len(), 0),
            rows,
            frames: Vec::new(),
            timeless,
            started: std::time::Instant::now(),
        }
    }

    pub(super) fn look<T: Surface>(&mut self, view: &View<T>) -> Result<ControlFlow<()>> {
        let terrain = view.terrain.at_centres();
        let terrain = ashore(&*terrain);
        if self.watch.table.is_some() {
            self.row(&*terrain, view);
        }
        if self.watch.animation.is_some() || self.watch.frames.is_some() {
            if self.frames.len() == MOST_FRAMES {
                return Err(Error::parameter("watch", format!("more than {MOST_FRAMES} frames"), "a longer `every`"));
            }
            let sea_level = Some(Length::of(self.environment.sea_level_at(view.time)));
            let mut frame = WritePicture { sea_level, ..self.watch.picture() }.draw(&*terrain)?;
            if self.watch.clock {
                frame.label(&self.time(view.steps, view.time));
            }
            self.frames.push(frame);
        }
        Ok(ControlFlow::Continue(()))
    }

    /// Rows and pictures that no checkpoint holds yet.
    pub(super) fn since_last(&self) -> (&str, &[Picture]) {
        (&self.rows[self.kept.0..], &self.frames[self.kept.1..])
    }

    /// All rows and pictures so far are in a checkpoint.
    pub(super) fn is_kept(&mut self) {
        self.kept = (self.rows.len(), self.frames.len());
    }

    /// Takes back rows and pictures from a checkpoint.
    pub(super) fn recall(&mut self, rows: &str, frames: Vec<Picture>) {
        self.rows += rows;
        self.frames.extend(frames);
        self.is_kept();
    }

    /// The clock as pictures show it.
    fn time(&self, steps: u64, time: f64) -> String {
        if self.timeless {
            return format!("step {steps}");
        }
        let years = time / YEAR;
        match years {
            y if y >= 1e6 => format!("{:.2} Myr", y / 1e6),
            y if y >= 1e4 => format!("{:.1} kyr", y / 1e3),
            y if y >= 100.0 => format!("{y:.0} yr"),
            y if y >= 1.0 => format!("{y:.1} yr"),
            y => format!("{:.1} days", y * 365.25),
        }
    }

    fn row<S: NodeSurface, T>(&mut self, terrain: &S, view: &View<T>) {
        let Summary { min, mean, max, lakes, .. } = summary(terrain);
        let (c, residual) = (view.change, view.residual.map_or(String::new(), |r| format!("{r:.6e}")));
        // Text in memory cannot fail to be written.
        let _ = write!(
            self.rows,
            "{},{:.9e},{:.9e},{lakes},{min:.6},{mean:.6},{max:.6},{residual},{:.9e},{:.9e},{:.9e},{:.9e}",
            view.steps,
            view.time / YEAR,
            view.dt / YEAR,
            c.supplied,
            c.eroded,
            c.deposited,
            c.exported,
        );
        if self.watch.seconds {
            let _ = write!(self.rows, ",{:.4}", self.started.elapsed().as_secs_f64());
        }
        self.rows.push('\n');
    }

    /// Writes the rows and pictures; a note if there are none.
    pub(super) fn finish(self, out: &mut dyn Output) -> Result<Option<&'static str>> {
        if let Some(path) = &self.watch.table {
            out.put(path, self.rows.as_bytes())?;
        }
        for (k, frame) in self.frames.iter().enumerate() {
            if let Some(path) = self.watch.frame(k + 1) {
                out.put(&path, &encode_png(&frame.pixels, frame.shape)?)?;
            }
        }
        if self.frames.is_empty() && (self.watch.animation.is_some() || self.watch.frames.is_some()) {
            return Ok(Some("`watch` never looked: the run ended before its first time"));
        }
        if let Some(path) = &self.watch.animation {
            let frames: Vec<_> = self.frames.iter().map(|f| f.pixels.as_slice()).collect();
            out.put(path, &encode_animation(path, self.frames[0].shape, &frames)?)?;
        }
        Ok(None)
    }
}

/// The terrain with water at 0 m as outlets, where nothing else is one: while rivers end at a sea
/// that rises and falls, no node is held. Only then a copy is made.
fn ashore<T: Surface>(terrain: &T) -> Cow<'_, T> {
    if terrain.domain().status().contains(&Status::BaseLevel) {
        return Cow::Borrowed(terrain);
    }
    let mut copy = terrain.clone();
    copy.set_status(Some(at_or_under(0.0, terrain)));
    Cow::Owned(copy)
}

/// A picture of a terrain.
///
/// # Errors
/// Where [`WritePicture::draw`] fails.
pub(super) fn draw(terrain: &AnyTerrain, picture: &WritePicture) -> Result<Picture> {
    struct Drawing<'a>(&'a WritePicture);
    impl Visit for Drawing<'_> {
        type Out = Result<Picture>;
        fn surface<T: Surface>(self, terrain: &T) -> Result<Picture> {
            self.0.draw(terrain)
        }

        fn body<T: Body>(self, _: &T) -> Self::Out {
            Err(not_a_surface(T::KIND, "a picture"))
        }
    }
    terrain.visit(Drawing(picture))
}
