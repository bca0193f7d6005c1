//! What is written while processes run: a table of steps, pictures, an animation.

use std::fmt::Write;
use std::ops::ControlFlow;

use landform_core::algo::flow::{Flow, node_areas};
use landform_core::sim::{Every, View};
use landform_core::terrain::NodeSurface;
use landform_core::units::{Duration, YEAR};
use landform_core::verb::{Output, Params, relative_path};
use landform_core::{Error, Result};
use landform_io::export::{Drawable, ViewKind, WritePicture};
use landform_io::format::{animation_extension, encode_animation, encode_png};
use landform_io::render::Picture;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::AnyTerrain;
use super::any_terrain::Held;

/// What to write while processes run.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Watch {
    /// Table of steps (CSV): time, elevations, lakes, change, volumes.
    pub table: Option<String>,
    /// Animation, by its extension: gif, or png (APNG).
    pub animation: Option<String>,
    /// Pictures (PNG), numbered before the extension.
    pub frames: Option<String>,
    /// Time from one look to the next; steps are shortened to meet it. Or give `steps`.
    #[schemars(extend("x-above" = 0.0))]
    pub every: Option<Duration>,
    /// Steps from one look to the next.
    #[schemars(extend("x-min" = 1))]
    pub steps: u64,
    /// What pictures show.
    pub view: ViewKind,
    /// Longer side of pictures, pixels.
    #[schemars(extend("x-min" = 16, "x-max" = 4096))]
    pub size: usize,
    /// Perspective only: factor on elevations.
    #[schemars(extend("x-above" = 0.0, "x-max" = 100.0))]
    pub exaggeration: f64,
    /// Whether the table has a column of seconds on the wall, which differ from run to run.
    pub seconds: bool,
}

impl Default for Watch {
    fn default() -> Self {
        Self {
            table: None,
            animation: None,
            frames: None,
            every: None,
            steps: 1,
            view: ViewKind::Map,
            size: 480,
            exaggeration: 1.0,
            seconds: false,
        }
    }
}

/// More would fill memory before the animation is written.
const MOST_FRAMES: usize = 5_000;

impl Watch {
    pub(super) fn check(&self) -> Result<()> {
        for path in [&self.table, &self.animation, &self.frames].into_iter().flatten() {
            relative_path(path)?;
        }
        if let Some(path) = &self.animation {
            animation_extension(path)?;
        }
        if let Some(path) = &self.frames
            && !path.to_lowercase().ends_with(".png")
        {
            return Err(Error::parameter("frames", format!("\"{path}\""), "a name that ends with .png"));
        }
        if self.table.is_none() && self.animation.is_none() && self.frames.is_none() {
            return Err(Error::parameter("watch", "without anything to write", "`table`, `animation` or `frames`"));
        }
        self.picture().validate()
    }

    pub(super) fn interval(&self) -> Every {
        self.every.map_or(Every::Steps(self.steps), |t| Every::Time(t.si()))
    }

    fn picture(&self) -> WritePicture {
        WritePicture { view: self.view, size: self.size, exaggeration: self.exaggeration, ..WritePicture::default() }
    }
}

/// What was seen so far.
pub(super) struct Watcher<'a> {
    watch: &'a Watch,
    rows: String,
    frames: Vec<Picture>,
    started: std::time::Instant,
}

impl<'a> Watcher<'a> {
    pub(super) fn new(watch: &'a Watch) -> Self {
        let seconds = if watch.seconds { ",seconds" } else { "" };
        let rows = format!(
            "step,time_yr,dt_yr,lakes,min_m,mean_m,max_m,residual,supplied_m3,eroded_m3,deposited_m3,exported_m3{seconds}\n"
        );
        Self { watch, rows, frames: Vec::new(), started: std::time::Instant::now() }
    }

    pub(super) fn look<T: Held>(&mut self, view: &View<T>) -> Result<ControlFlow<()>> {
        let terrain = view.terrain.clone().wrap();
        if self.watch.table.is_some() {
            match &terrain {
                AnyTerrain::HeightField(t) => self.row(t, view),
                AnyTerrain::Mesh(t) => self.row(t, view),
            }
        }
        if self.watch.animation.is_some() || self.watch.frames.is_some() {
            if self.frames.len() == MOST_FRAMES {
                return Err(Error::parameter("watch", format!("more than {MOST_FRAMES} frames"), "a longer `every`"));
            }
            self.frames.push(terrain.draw(&self.watch.picture())?);
        }
        Ok(ControlFlow::Continue(()))
    }

    fn row<S: NodeSurface, T>(&mut self, terrain: &S, view: &View<T>) {
        let (domain, z) = (terrain.domain(), terrain.elevation());
        let areas = node_areas(&*domain);
        let mut flow = Flow::new();
        flow.route(&*domain, z, &mut areas.clone());
        let finite = || z.iter().zip(&areas).filter(|(z, _)| z.is_finite());
        let min = finite().fold(f64::INFINITY, |m, (z, _)| m.min(*z));
        let max = finite().fold(f64::NEG_INFINITY, |m, (z, _)| m.max(*z));
        let mean = finite().map(|(z, a)| z * a).sum::<f64>() / areas.iter().sum::<f64>();
        let (c, residual) = (view.change, view.residual.map_or(String::new(), |r| format!("{r:.6e}")));
        // Text in memory cannot fail to be written.
        let _ = write!(
            self.rows,
            "{},{:.9e},{:.9e},{},{min:.6},{mean:.6},{max:.6},{residual},{:.9e},{:.9e},{:.9e},{:.9e}",
            view.steps,
            view.time / YEAR,
            view.dt / YEAR,
            flow.lakes(),
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

    /// Writes what was seen.
    pub(super) fn finish(self, out: &mut dyn Output) -> Result<()> {
        if let Some(path) = &self.watch.table {
            out.put(path, self.rows.as_bytes())?;
        }
        if let Some(path) = &self.watch.frames {
            let stem = &path[..path.len() - ".png".len()];
            for (k, frame) in self.frames.iter().enumerate() {
                out.put(&format!("{stem}_{:04}.png", k + 1), &encode_png(&frame.pixels, frame.shape)?)?;
            }
        }
        match &self.watch.animation {
            Some(path) => out.put(path, &encode_animation(path, &self.frames)?),
            None => Ok(()),
        }
    }
}

impl AnyTerrain {
    /// A picture of it.
    ///
    /// # Errors
    /// As [`WritePicture::draw`].
    pub fn draw(&self, picture: &WritePicture) -> Result<Picture> {
        fn of<T: Drawable>(terrain: &T, picture: &WritePicture) -> Result<Picture> {
            picture.draw(terrain)
        }
        match self {
            Self::HeightField(t) => of(t, picture),
            Self::Mesh(t) => of(t, picture),
        }
    }
}
