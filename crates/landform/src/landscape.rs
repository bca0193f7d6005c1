//! An owned landscape, which can be opened, evolved, measured and saved.

use std::path::Path;
use std::sync::Arc;

use landform_core::random::Seed;
use landform_core::sim::{Simulation, Stop};
use landform_core::stage::{ReadStage, Verb};
use landform_core::terrain::{
    AnyTerrain, Body, HeightField, NodeSurface, Representation, Surface, Visit, not_a_surface,
};
use landform_core::verb::{Context, Environment, Event, MemoryOutput, Outcome, Output, Params, Stopped};
use landform_core::{Error, Result};
use landform_io::export::{WriteMesh, WritePicture, WriteRaster};
use landform_io::files::{Folder, write_whole};
use landform_io::format::{
    MeshFile, RasterFile, Reading, mesh_file_from_height_field, mesh_file_from_mesh, mesh_format, raster_format,
    read_raster, sidecar_path,
};
use landform_io::import::{FileMaps, in_degrees};

use crate::recipe::{model_of, stages};

/// A terrain with its environment and its history.
///
/// ```
/// use landform::prelude::*;
///
/// # fn main() -> landform::Result<()> {
/// # let folder = std::env::temp_dir().join(format!("landform-doc-{}", std::process::id()));
/// # std::fs::create_dir_all(&folder).unwrap();
/// # let (dem, after) = (folder.join("dem.asc"), folder.join("after.tif"));
/// # let rows = (0..24).map(|r| (0..24).map(|c| ((r * 7 + c * 3) % 11).to_string()).collect::<Vec<_>>().join(" "));
/// # let head = "ncols 24\nnrows 24\nxllcorner 0\nyllcorner 0\ncellsize 100\n";
/// # std::fs::write(&dem, head.to_string() + &rows.collect::<Vec<_>>().join("\n")).unwrap();
/// let mut land = Landscape::open(&dem)?;
/// land.evolve(kyr(10.0), myr(0.2))
///     .with(Uplift { rate: mm_per_yr(0.5).into() })
///     .with(StreamPower::default())
///     .run()?;
/// land.save(&after)?;
/// # std::fs::remove_dir_all(&folder).ok();
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug)]
pub struct Landscape {
    /// The terrain.
    pub terrain: AnyTerrain,
    /// Sea level, rain, winds and materials.
    pub environment: Arc<Environment>,
    /// Stages so far, oldest first.
    pub history: Vec<Event>,
    /// Title, for pictures and reports.
    pub title: String,
    /// Seed of everything that is random.
    pub seed: u64,
    /// What the files that were read say and nobody follows, and what was assumed of them.
    pub notes: Vec<String>,
}

impl<T: Representation> From<T> for Landscape {
    fn from(terrain: T) -> Self {
        Self::of(terrain.wrap())
    }
}

impl Landscape {
    /// A terrain by itself.
    pub fn of(terrain: AnyTerrain) -> Self {
        let (environment, history, title, notes) = Default::default();
        Self { terrain, environment, history, title, seed: 0, notes }
    }

    /// Reads an elevation file: GeoTIFF, ESRI ASCII, PNG, PNM, EXR, NPY, RAW16. Water leaves by the
    /// low points of the border. What was assumed of the file is in [`Landscape::notes`].
    ///
    /// # Errors
    /// [`Error::Io`] or [`Error::Format`] if the file cannot be read; [`Error::InDegrees`] if it is
    /// in degrees, since slopes need metres.
    pub fn open(path: impl AsRef<Path>) -> Result<Self> {
        let path = path.as_ref();
        let Reading { mut field, notes } = read_raster(path)?;
        if in_degrees(field.grid()) {
            return Err(Error::InDegrees { path: path.display().to_string(), convertible: false });
        }
        let valleys = landform_core::verb::Outlets::Named(landform_core::verb::NamedOutlets::Valleys);
        valleys.apply(&mut field, 0.0, &Context::default())?;
        let title = path.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
        Ok(Self { title, notes, ..Self::of(field.wrap()) })
    }

    /// Writes the surface: the extension says whether as a raster (tif, asc, exr, npy, png, pgm,
    /// r16) or as triangles (glb, obj, ply, stl).
    ///
    /// # Errors
    /// [`Error::Parameter`] if the extension is not known, or if it asks for a raster of a mesh
    /// (`to_height_field` makes one); [`Error::Io`] if the file cannot be written.
    pub fn save(&self, path: impl AsRef<Path>) -> Result<()> {
        let path = path.as_ref();
        if let Ok(format) = mesh_format(path) {
            return write_whole(path, &(format.write)(&self.triangles()?)?);
        }
        let format = raster_format(path)?;
        let field = self.terrain.get::<HeightField>("save")?;
        let file = RasterFile::real(field.grid(), field.elevation(), "elevation", "m", self.seed);
        write_whole(path, &(format.write)(&file)?)?;
        match format.sidecar(&file) {
            Some(sidecar) => write_whole(sidecar_path(&path.display().to_string()).as_ref(), &sidecar.text()?),
            None => Ok(()),
        }
    }

    fn triangles(&self) -> Result<MeshFile> {
        match self.terrain.get::<HeightField>("save") {
            Ok(field) => Ok(mesh_file_from_height_field(field)),
            Err(_) => self.terrain.get("save").map(mesh_file_from_mesh),
        }
    }

    /// Writes a field of a raster: "elevation", "drainage_area" and what else it has. The extension
    /// says how: tif, asc, exr, npy, png, pgm, r16.
    ///
    /// ```
    /// use landform::prelude::*;
    ///
    /// # let path = std::env::temp_dir().join(format!("landform-raster-{}.tif", std::process::id()));
    /// let grid = Grid::new(Shape::new(2, 2), [10.0, 10.0])?;
    /// let land = Landscape::from(HeightField::new(grid, vec![0.0, 1.0, 2.0, 3.0])?);
    /// land.save_raster("elevation", &path)?;
    /// # std::fs::remove_file(&path).ok();
    /// # Ok::<(), landform::Error>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`WriteRaster`]; [`Error::Io`] if the file cannot be written.
    pub fn save_raster(&self, field: &str, path: impl AsRef<Path>) -> Result<()> {
        let (folder, path) = place(path.as_ref());
        self.export(WriteRaster { field: field.into(), path, ..WriteRaster::default() }, folder).map(drop)
    }

    /// Writes the surface as triangles: glb, obj, ply, stl, vtk. [`WriteMesh`] has more to choose
    /// from.
    ///
    /// ```
    /// use landform::prelude::*;
    ///
    /// # let path = std::env::temp_dir().join(format!("landform-mesh-{}.ply", std::process::id()));
    /// let grid = Grid::new(Shape::new(3, 3), [10.0, 10.0])?;
    /// let land = Landscape::from(HeightField::new(grid, vec![1.0; 9])?);
    /// land.save_mesh(&path)?;
    /// # std::fs::remove_file(&path).ok();
    /// # Ok::<(), landform::Error>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`WriteMesh`]; [`Error::Io`] if the file cannot be written.
    pub fn save_mesh(&self, path: impl AsRef<Path>) -> Result<()> {
        let (folder, path) = place(path.as_ref());
        self.export(WriteMesh { path, ..WriteMesh::default() }, folder).map(drop)
    }

    /// Writes a view of the land in perspective, as PNG. [`WritePicture`] has more to choose from.
    ///
    /// ```
    /// use landform::prelude::*;
    ///
    /// # let path = std::env::temp_dir().join(format!("landform-picture-{}.png", std::process::id()));
    /// let grid = Grid::new(Shape::new(3, 3), [10.0, 10.0])?;
    /// let land = Landscape::from(HeightField::new(grid, vec![1.0; 9])?);
    /// land.save_picture(&path)?;
    /// # std::fs::remove_file(&path).ok();
    /// # Ok::<(), landform::Error>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`WritePicture`]; [`Error::Io`] if the file cannot be written.
    pub fn save_picture(&self, path: impl AsRef<Path>) -> Result<()> {
        let (folder, path) = place(path.as_ref());
        self.export(WritePicture { path, ..WritePicture::default() }, folder).map(drop)
    }

    /// Writes what a stage that exports writes, below a folder; what it tells besides, such as that
    /// ground was resampled.
    ///
    /// ```
    /// use landform::io::export::WriteRaster;
    /// use landform::prelude::*;
    ///
    /// # let folder = std::env::temp_dir().join(format!("landform-export-{}", std::process::id()));
    /// let grid = Grid::new(Shape::new(3, 3), [10.0, 10.0])?;
    /// let land = Landscape::from(HeightField::new(grid, vec![1.0; 9])?);
    /// land.export(WriteRaster { path: "ground.npy".into(), ..WriteRaster::default() }, &folder)?;
    /// # std::fs::remove_dir_all(&folder).ok();
    /// # Ok::<(), landform::Error>(())
    /// ```
    ///
    /// # Errors
    /// Those of the stage, and of its parameters; [`Error::Io`] if a file cannot be written.
    pub fn export<P: Params>(&self, params: P, folder: impl AsRef<Path>) -> Result<Vec<String>> {
        let stage = read(&params)?;
        let mut out = Folder::create(folder.as_ref())?;
        stage.report(&self.view(), &mut out)?;
        Ok(out.take_notes())
    }

    /// Applies a stage that changes the landscape at once: a generator, an edit or a conversion.
    ///
    /// ```
    /// use landform::prelude::*;
    /// use landform::process::generate::{Flat, GridParams};
    ///
    /// let plain = Flat { grid: GridParams::of([400.0, 400.0], 100.0), ..Flat::default() };
    /// let mut land = Landscape::from(plain.generate(&Context::default())?);
    /// land.apply(Add { elevation: metres(3.0).into() })?;
    /// assert!(land.terrain.elevation().iter().all(|&z| z == 3.0));
    /// assert_eq!(land.history.len(), 1);
    /// # Ok::<(), landform::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Unsupported`] if the stage does not work on this kind of terrain or does not act at
    /// once; or if the stage fails.
    pub fn apply<P: Params>(&mut self, params: P) -> Result<&mut Self> {
        let stage = read(&params)?;
        if !matches!(stage.stage().verb, Verb::Generate | Verb::Edit | Verb::Convert) {
            let (what, supports) = (format!("`{}`", P::NAME), "`evolve`, or an output".into());
            return Err(Error::Unsupported { what, on: "landscape at once".into(), supports });
        }
        let maps = FileMaps::new(Path::new(""));
        let seed = Seed(self.seed).named(&format!("{}#{}", P::NAME, self.history.len()));
        let context = Context { seed, maps: &maps, environment: &self.environment, ..Context::default() };
        self.terrain = stage.apply(Some(&self.terrain), &context)?;
        self.notes.extend(maps.take_notes());
        self.record(&[stage], None);
        Ok(self)
    }

    /// Measures: the values as JSON, as the stage would write them.
    ///
    /// # Errors
    /// If the stage fails; the error is the stage's own.
    pub fn measure<P: Params>(&self, params: P) -> Result<serde_json::Value> {
        let stage = read(&params)?;
        let mut out = MemoryOutput::default();
        stage.report(&self.view(), &mut out)?;
        let bytes = out.0.into_values().next().unwrap_or_default();
        serde_json::from_slice(&bytes).map_err(|e| Error::format("JSON", e))
    }

    /// The view of the landscape that measures and exports get.
    pub fn view(&self) -> landform_core::verb::Landscape<'_, AnyTerrain> {
        let mut view = landform_core::verb::Landscape::plain(&self.terrain);
        (view.environment, view.history) = (&self.environment, &self.history);
        (view.seed, view.title) = (self.seed, &self.title);
        view
    }

    /// Prepares a run of processes in steps of `dt` for `duration`, both in s
    /// ([`kyr`](crate::prelude::kyr), [`myr`](crate::prelude::myr)).
    pub fn evolve(&mut self, dt: f64, duration: f64) -> Evolution<'_> {
        Evolution { land: self, dt, stop: Stop::time(duration), parts: Ok(Vec::new()) }
    }

    fn record(&mut self, parts: &[ReadStage], outcome: Option<Outcome>) {
        let names: Vec<&str> = parts.iter().map(|p| p.stage().name).collect();
        let sources = parts.iter().flat_map(|p| p.stage().sources);
        let parameters: Vec<_> = parts.iter().map(|p| p.parameters().clone()).collect();
        self.history.push(Event {
            stage: names.join(" + "),
            parameters: serde_json::Value::from(parameters).to_string(),
            sources: sources.map(|s| [s.authors, s.title, s.doi].map(String::from)).collect(),
            outcome,
        });
    }
}

/// The folder of a path, and the name in it.
fn place(path: &Path) -> (&Path, String) {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    (folder, path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default())
}

/// A stage of the table from its parameters.
fn read<P: Params>(params: &P) -> Result<ReadStage> {
    let unknown = || Error::Recipe { at: None, what: format!("stage `{}` is not in the table", P::NAME), hint: None };
    let stage = stages().find(|s| s.name == P::NAME).ok_or_else(unknown)?;
    stage.with(params.clone())
}

/// A run of processes on a landscape, before it starts.
#[must_use = "call `run`"]
pub struct Evolution<'a> {
    land: &'a mut Landscape,
    dt: f64,
    stop: Stop,
    parts: Result<Vec<ReadStage>>,
}

impl Evolution<'_> {
    /// Adds a process; in each step they act in this order.
    pub fn with<P: Params>(mut self, params: P) -> Self {
        self.parts = self.parts.and_then(|mut parts| {
            parts.push(read(&params)?);
            Ok(parts)
        });
        self
    }

    /// Stops earlier, once the greatest change of a step is at most `tolerance` of what uplift
    /// alone would have raised.
    pub fn or_steady(mut self, tolerance: f64) -> Self {
        self.stop = self.stop.or_steady(tolerance);
        self
    }

    /// Runs to the end.
    ///
    /// # Errors
    /// If a parameter of a process is wrong, or a process fails while it runs;
    /// [`Error::Unsupported`] if a process does not work on this kind of terrain. The landscape is
    /// then as before.
    pub fn run(self) -> Result<Outcome> {
        let Self { land, dt, stop, parts } = self;
        let parts = parts?;
        let maps = Arc::new(FileMaps::new(Path::new("")));
        let running = Running { land, dt, stop, parts: &parts, maps: maps.clone() };
        let (terrain, outcome) = land.terrain.visit(running)?;
        land.notes.extend(maps.take_notes());
        debug_assert!(outcome.stopped != Stopped::Cancelled, "nobody could");
        land.terrain = terrain;
        land.record(&parts, Some(outcome));
        Ok(outcome)
    }
}

struct Running<'a> {
    land: &'a Landscape,
    dt: f64,
    stop: Stop,
    parts: &'a [ReadStage],
    maps: Arc<FileMaps>,
}

impl Visit for Running<'_> {
    type Out = Result<(AnyTerrain, Outcome)>;

    fn surface<T: Surface>(self, terrain: &T) -> Self::Out {
        let seed = Seed(self.land.seed).named(&format!("evolve#{}", self.land.history.len()));
        let model = model_of(terrain, self.parts, seed)?;
        let model = model.dt(self.dt).maps(self.maps).environment(self.land.environment.clone());
        let mut run = Simulation::of(model).until(self.stop);
        let outcome = run.run()?;
        Ok((run.into_terrain().at_centres().into_owned().wrap(), outcome))
    }

    fn body<T: Body>(self, _: &T) -> Self::Out {
        Err(not_a_surface(T::KIND, "a process on a clock"))
    }
}
