//! A stage whose parameters have been read.

use std::any::Any;
use std::fmt;

use serde_json::Value as Json;

use super::parameters::{Parameters, Refusal};
use super::row::{Act, Run, Stage};
use crate::terrain::{AnyTerrain, HeightField, Kind, Terrain, bytes_a_node};
use crate::units::place_text;
use crate::verb::{Context, ELEVATIONS, Estimate, Landscape, Output, OwnClock, Params, Reach, coarser};
use crate::{Error, Result};

/// A stage with its parameters, read once and ready to run.
#[derive(Clone)]
pub struct ReadStage {
    stage: &'static Stage,
    parameters: Parameters,
}

impl fmt::Debug for ReadStage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.stage.name, self.parameters.normal)
    }
}

impl Stage {
    /// Reads and validates parameters, once.
    ///
    /// # Errors
    /// [`Refusal`] if a parameter is wrong, with its place or its name.
    pub fn read(&'static self, json: &Json) -> Result<ReadStage, Refusal> {
        (self.form.read)(json).map(|parameters| ReadStage::new(self, parameters))
    }

    /// The stage with given parameters.
    ///
    /// # Errors
    /// [`Error::Parameter`] if one is out of range.
    pub fn with<P: Params>(&'static self, params: P) -> Result<ReadStage> {
        params.validate()?;
        Ok(ReadStage::new(self, Parameters::new(params)?))
    }
}

impl ReadStage {
    pub(super) fn new(stage: &'static Stage, parameters: Parameters) -> Self {
        Self { stage, parameters }
    }

    /// Its row.
    pub fn stage(&self) -> &'static Stage {
        self.stage
    }

    /// The parameters in customary units, defaults included.
    pub fn parameters(&self) -> &Json {
        &self.parameters.normal
    }

    /// Files that it will write, below the output folder.
    pub fn outputs(&self) -> &[String] {
        &self.parameters.outputs
    }

    /// Refuses lengths that do not fit a map of known size, and places off one of known corner too.
    ///
    /// # Errors
    /// [`Error::Parameter`] with the range of the length, or the map's corners.
    pub fn check_places(&self, before: &Estimate) -> Result<()> {
        if before.extent.iter().any(|side| *side > 0.0) {
            (self.stage.form.check_on)(&*self.parameters.value, before.extent)?;
        }
        let Some([w, s]) = before.origin else { return Ok(()) };
        let [e, n] = [w + before.extent[0], s + before.extent[1]];
        match self.parameters.places.iter().find(|(_, [x, y])| !(w..=e).contains(x) || !(s..=n).contains(y)) {
            Some((name, [x, y])) => {
                let allowed = format!("a place on the map, {w:.0} to {e:.0} m east and {s:.0} to {n:.0} m north");
                Err(Error::parameter(name, place_text([x.round(), y.round()]), &allowed))
            }
            None => Ok(()),
        }
    }

    /// Fields that it leaves.
    pub fn leaves(&self) -> impl Iterator<Item = &str> {
        self.stage.writes.iter().copied().chain(self.parameters.leaves.iter().map(String::as_str))
    }

    /// How far around a node the ground can affect the result there.
    pub fn reach(&self) -> Reach {
        self.parameters.reach
    }

    /// Whether nodes of a raster should stand off the centres of their cells while it runs.
    pub fn jitters(&self) -> bool {
        self.parameters.jitters
    }

    /// The stage where cells are `factor` times as long.
    ///
    /// # Errors
    /// [`Refusal`] if a parameter leaves its range there.
    pub fn coarser(&self, factor: u32) -> Result<Self, Refusal> {
        self.stage.read(&coarser(&(self.stage.form.schema)(), self.parameters(), factor))
    }

    /// The fastest that it raises ground by itself, m/s, where that is known before a run.
    fn raises(&self) -> Option<f64> {
        (self.stage.form.raises)(&*self.parameters.value)
    }

    /// What a user should know before it runs on ground like `before`, which is raised at up to
    /// `raised` (m/s) on the same clock.
    fn warning(&self, before: &Estimate, raised: f64) -> Option<String> {
        (self.stage.form.warning)(&*self.parameters.value, before, raised)
    }

    /// The clock that it brings with it, if it is a process that does.
    pub fn own_clock(&self) -> Option<OwnClock> {
        match self.stage.acts.first()?.run {
            Run::Process { own_clock, .. } => own_clock(&*self.parameters.value),
            _ => None,
        }
    }

    fn act(&self, kind: Option<Kind>) -> Result<&Act> {
        self.stage.act_on(kind).ok_or_else(|| Error::Unsupported {
            what: format!("`{}`", self.stage.name),
            on: kind.map_or("landscape without a terrain".into(), |k| k.to_string()),
            supports: self.stage.kinds().map(|k| format!("a {k}")).collect::<Vec<_>>().join(" or "),
        })
    }

    /// Memory and nodes that the stage will need on such a terrain.
    ///
    /// # Errors
    /// If it is known without a run that the stage would fail.
    pub fn estimate(&self, kind: Option<Kind>, before: Estimate, context: &Context) -> Result<Estimate> {
        let params = &*self.parameters.value;
        match self.act(kind)?.run {
            Run::Generate { estimate, .. } => estimate(params, context),
            Run::Edit { estimate, .. } | Run::Convert { estimate, .. } => estimate(params, before),
            _ => Ok(Estimate { bytes: before.nodes * bytes_a_node_of(&[self], kind), ..before }),
        }
    }

    /// Makes or changes a terrain, for stages that do so at once; `terrain` is the one before.
    ///
    /// # Errors
    /// If the stage fails; [`Error::Unsupported`] without a terrain to work on, or for a process.
    pub fn apply(&self, terrain: Option<&AnyTerrain>, context: &Context) -> Result<AnyTerrain> {
        let params = &*self.parameters.value;
        let act = self.act(terrain.map(AnyTerrain::kind))?;
        match (act.run, terrain) {
            (Run::Generate { make, .. }, _) => make(params, context),
            (Run::Convert { convert, .. }, Some(terrain)) => convert(params, terrain),
            (Run::Edit { edit, .. }, Some(terrain)) => {
                let mut terrain = terrain.clone();
                edit(params, &mut terrain, context)?;
                Ok(terrain)
            }
            (_, terrain) => {
                terrain.cloned().ok_or(Error::Recipe { at: None, what: "there is no terrain yet".into(), hint: None })
            }
        }
    }

    /// Adds a process to a [`crate::sim::Model`], given as what it is.
    ///
    /// # Errors
    /// As [`crate::sim::Model::add`]; [`Error::Unsupported`] for a model of another kind of
    /// terrain, or another stage.
    pub fn add_to(&self, kind: Kind, model: &mut dyn Any) -> Result<()> {
        match self.act(Some(kind))?.run {
            Run::Process { add, .. } => add(&*self.parameters.value, model),
            _ => Ok(()),
        }
    }

    /// Measures or writes; files go to `out`.
    ///
    /// # Errors
    /// If the stage fails; the error is the stage's own.
    pub fn report(&self, landscape: &Landscape<'_, AnyTerrain>, out: &mut dyn Output) -> Result<()> {
        let params = &*self.parameters.value;
        match self.act(Some(landscape.terrain.kind()))?.run {
            Run::Export(export) => export(params, landscape, out),
            Run::Measure(measure) => {
                let (path, value) = measure(params, landscape)?;
                let text = serde_json::to_string_pretty(&value).map_err(|e| Error::format("JSON", e))?;
                out.put(&path, text.as_bytes())
            }
            _ => Ok(()),
        }
    }
}

/// What users should know of stages that run together on ground like `before`, each beside its
/// name.
///
/// ```
/// use landform_core::stage::warnings_of;
/// use landform_core::verb::Estimate;
///
/// assert!(warnings_of(&[], &Estimate::default()).is_empty());
/// ```
pub fn warnings_of(parts: &[ReadStage], before: &Estimate) -> Vec<String> {
    let raised = parts.iter().filter_map(ReadStage::raises).sum();
    let told = |part: &ReadStage| part.warning(before, raised).map(|what| format!("`{}`: {what}", part.stage.name));
    parts.iter().filter_map(told).collect()
}

/// Bytes a node that stages take which run together on a kind of terrain.
///
/// ```
/// use landform_core::stage::bytes_a_node_of;
/// use landform_core::terrain::Kind;
///
/// // Elevations alone.
/// assert_eq!(bytes_a_node_of(&[], Some(Kind::HeightField)), 16);
/// ```
pub fn bytes_a_node_of(parts: &[&ReadStage], kind: Option<Kind>) -> u64 {
    let measured = parts.iter().map(|part| part.parameters.bytes_a_node);
    match (kind, measured.sum::<Option<u64>>()) {
        (Some(HeightField::KIND), Some(own)) => ELEVATIONS + own,
        (Some(kind), _) => bytes_a_node(kind),
        (None, _) => 0,
    }
}
