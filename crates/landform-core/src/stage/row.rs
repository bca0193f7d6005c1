//! A row of the table of stages.

use std::any::Any;

use serde_json::Value as Json;

use super::parameters::{Parameters, Refusal, typed};
use crate::feature::FeatureKind;
use crate::sim::Model;
use crate::terrain::{AnyTerrain, Kind, Representation};
use crate::verb::{
    Context, Convert, Edit, Estimate, Export, Generator, Landscape, Measure, Output, OwnClock, Params, Process, Reach,
    Source, add_hints, properties, schema_of,
};
use crate::{Error, Result};

/// What a stage does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verb {
    /// Makes a terrain.
    Generate,
    /// Changes it once.
    Edit,
    /// Changes its representation.
    Convert,
    /// Changes it over time.
    Process,
    /// Measures it.
    Measure,
    /// Writes files.
    Export,
}

impl Verb {
    /// The verb as a heading.
    pub fn title(self) -> &'static str {
        match self {
            Self::Generate => "generate",
            Self::Edit => "edit",
            Self::Convert => "convert",
            Self::Process => "process",
            Self::Measure => "measure",
            Self::Export => "export",
        }
    }

    /// Whether the terrain after it differs from the one before.
    pub fn changes_terrain(self) -> bool {
        !matches!(self, Self::Measure | Self::Export)
    }
}

/// A stage: a description of its parameters, and a function for each kind of terrain.
#[derive(Debug)]
pub struct Stage {
    /// Name in recipes.
    pub name: &'static str,
    /// What it does.
    pub verb: Verb,
    /// Papers behind it.
    pub sources: &'static [Source],
    /// Keys whose value is a path that is read.
    pub inputs: &'static [&'static str],
    /// Whether it takes other landscapes.
    pub with: bool,
    /// Kinds of features that the landscape must have.
    pub needs: &'static [FeatureKind],
    /// Fields that a process changes.
    pub writes: &'static [&'static str],
    /// Keys of earlier recipes, and their names now.
    pub renamed: &'static [(&'static str, &'static str)],
    /// Keys of earlier recipes that are still read, and the key that says the same now.
    pub obsolete: &'static [(&'static str, &'static str)],
    /// Description of its parameters.
    pub form: Form,
    /// Functions, one for each kind of terrain.
    pub acts: &'static [Act],
    /// The module whose row it is.
    pub module: &'static str,
}

/// Description of a stage's parameters.
#[derive(Clone, Copy, Debug)]
pub struct Form {
    /// Name and schema of each parameter.
    pub properties: fn() -> Vec<(String, Json)>,
    /// JSON schema.
    pub schema: fn() -> Json,
    /// Defaults, in customary units.
    pub defaults: fn() -> Json,
    /// How far around a node the ground can affect the result there, with the default parameters.
    pub reach: fn() -> Reach,
    /// Checks parameters against the extent of a map, m.
    pub(super) check_on: fn(&dyn Any, [f64; 2]) -> Result<()>,
    /// The fastest that the stage raises ground by itself, m/s.
    pub(super) raises: fn(&dyn Any) -> Option<f64>,
    /// What a user should know before a run on such ground, raised at up to a rate, m/s.
    pub(super) warning: fn(&dyn Any, &Estimate, f64) -> Option<String>,
    /// Reads and validates.
    pub(super) read: fn(&Json) -> Result<Parameters, Refusal>,
}

impl Form {
    /// Description of the parameters of a type.
    pub const fn of<P: Params>() -> Self {
        Self {
            properties: properties::<P>,
            schema: || {
                let mut schema = schema_of::<P>();
                add_hints(&mut schema, &defaults_of::<P>(), P::INPUTS);
                schema
            },
            defaults: defaults_of::<P>,
            reach: || P::default().reach(),
            check_on: |params, extent| typed::<P>(params)?.check_on(extent),
            raises: |params| typed::<P>(params).ok()?.raises(),
            warning: |params, before, raised| typed::<P>(params).ok()?.warning(before, raised),
            read: |json| {
                let params: P = serde_path_to_error::deserialize(json).map_err(Refusal::Shape)?;
                params.validate().map_err(Refusal::Value)?;
                Parameters::new(params).map_err(Refusal::Value)
            },
        }
    }
}

fn defaults_of<P: Params>() -> Json {
    serde_json::to_value(P::default()).unwrap_or_default()
}

/// What a stage does on a kind of terrain.
#[derive(Clone, Copy, Debug)]
pub struct Act {
    /// Kind of terrain that it needs; none for generators.
    pub on: Option<Kind>,
    /// Kind of terrain after it; none if it changes nothing.
    pub to: Option<Kind>,
    /// Function that runs it with the parameters that were read.
    pub run: Run,
}

/// Functions that run a stage with parameters that were read.
#[derive(Clone, Copy, Debug)]
pub enum Run {
    /// Makes a terrain.
    Generate {
        /// Makes it.
        make: fn(&dyn Any, &Context) -> Result<AnyTerrain>,
        /// Estimates its nodes and memory.
        estimate: fn(&dyn Any, &Context) -> Result<Estimate>,
    },
    /// Changes a terrain once.
    Edit {
        /// Changes it.
        edit: fn(&dyn Any, &mut AnyTerrain, &Context) -> Result<()>,
        /// Estimates its nodes and memory.
        estimate: fn(&dyn Any, Estimate) -> Result<Estimate>,
    },
    /// Changes the representation.
    Convert {
        /// Changes it.
        convert: fn(&dyn Any, &AnyTerrain) -> Result<AnyTerrain>,
        /// Estimates its nodes and memory.
        estimate: fn(&dyn Any, Estimate) -> Result<Estimate>,
    },
    /// Changes a terrain over time.
    Process {
        /// Adds itself to a [`Model`] of its kind of terrain.
        add: fn(&dyn Any, &mut dyn Any) -> Result<()>,
        /// The clock that it brings.
        own_clock: fn(&dyn Any) -> Option<OwnClock>,
    },
    /// Measures a terrain: path and value.
    Measure(MeasureFn),
    /// Writes files.
    Export(fn(&dyn Any, &Landscape<'_, AnyTerrain>, &mut dyn Output) -> Result<()>),
}

/// Gives the path of a measure and its value.
type MeasureFn = fn(&dyn Any, &Landscape<'_, AnyTerrain>) -> Result<(String, Json)>;

/// A generator's act.
pub const fn generate<P: Generator<T>, T: Representation>() -> Act {
    let run = Run::Generate {
        make: |params, context| Ok(typed::<P>(params)?.generate(context)?.wrap()),
        estimate: |params, context| typed::<P>(params)?.estimate(context),
    };
    Act { on: None, to: Some(T::KIND), run }
}

/// An edit's act.
pub const fn edit<P: Edit<T>, T: Representation>() -> Act {
    let run = Run::Edit {
        edit: |params, terrain, context| typed::<P>(params)?.edit(terrain.get_mut::<T>(P::NAME)?, context),
        estimate: |params, before| Ok(typed::<P>(params)?.estimate(before)),
    };
    Act { on: Some(T::KIND), to: Some(T::KIND), run }
}

/// A conversion's act.
pub const fn convert<P: Convert<S, T>, S: Representation, T: Representation>() -> Act {
    let run = Run::Convert {
        convert: |params, terrain| Ok(typed::<P>(params)?.convert(terrain.get::<S>(P::NAME)?)?.wrap()),
        estimate: |params, source| Ok(typed::<P>(params)?.estimate(source)),
    };
    Act { on: Some(S::KIND), to: Some(T::KIND), run }
}

/// A process' act.
pub const fn process<P: Process<T>, T: Representation>() -> Act {
    let run = Run::Process {
        add: |params, model| match model.downcast_mut::<Model<T>>() {
            Some(model) => model.add(typed::<P>(params)?.clone()),
            None => Err(Error::Unsupported {
                what: P::NAME.into(),
                on: "another terrain".into(),
                supports: T::KIND.to_string(),
            }),
        },
        own_clock: |params| typed::<P>(params).ok().and_then(P::own_clock),
    };
    Act { on: Some(T::KIND), to: Some(T::KIND), run }
}

/// A measure's act.
pub const fn measure<P: Measure<T>, T: Representation>() -> Act {
    let run = Run::Measure(|params, landscape| {
        let params = typed::<P>(params)?;
        let terrain = landscape.terrain.get::<T>(P::NAME)?;
        let value = serde_json::to_value(params.measure(&landscape.with(terrain))?);
        Ok((params.path().into(), value.map_err(|e| Error::format("measure", e))?))
    });
    Act { on: Some(T::KIND), to: None, run }
}

/// An export's act.
pub const fn export<P: Export<T>, T: Representation>() -> Act {
    let run = Run::Export(|params, landscape, out| {
        let terrain = landscape.terrain.get::<T>(P::NAME)?;
        typed::<P>(params)?.export(&landscape.with(terrain), out)
    });
    Act { on: Some(T::KIND), to: None, run }
}

impl Stage {
    /// A row without acts.
    pub const fn new<P: Params>(verb: Verb, writes: &'static [&'static str]) -> Self {
        let (name, sources, inputs, with, needs) = (P::NAME, P::SOURCES, P::INPUTS, P::WITH, P::NEEDS);
        let (renamed, obsolete) = (P::RENAMED, P::OBSOLETE);
        let (form, acts, module) = (Form::of::<P>(), &[], "");
        Self { name, verb, sources, inputs, with, needs, writes, renamed, obsolete, form, acts, module }
    }

    /// The folder of its phenomenon, or of what reads, measures and writes.
    ///
    /// ```
    /// use landform_core::stage::{Stage, Verb};
    /// # use landform_core::verb::{Params, Source};
    /// # #[derive(Clone, Debug, Default, serde::Serialize, serde::Deserialize, schemars::JsonSchema)]
    /// # struct Melt {}
    /// # impl Params for Melt {
    /// #     const NAME: &'static str = "melt";
    /// #     const SOURCES: &'static [Source] = &[];
    /// # }
    /// let row = Stage { module: "landform_process::snow::melt", ..Stage::new::<Melt>(Verb::Edit, &[]) };
    /// assert_eq!(row.folder(), "snow");
    /// ```
    pub fn folder(&self) -> &'static str {
        self.module.split("::").nth(1).unwrap_or_default()
    }

    /// The act on a kind of terrain.
    pub fn act_on(&self, kind: Option<Kind>) -> Option<&Act> {
        self.acts.iter().find(|a| a.on.is_none() || a.on == kind)
    }

    /// The kinds of terrain that it runs on; none for generators.
    pub fn kinds(&self) -> impl Iterator<Item = Kind> {
        self.acts.iter().filter_map(|a| a.on)
    }

    /// The purpose of the stage, in a sentence or two.
    pub fn summary(&self) -> String {
        (self.form.schema)()["description"].as_str().unwrap_or_default().replace('\n', " ")
    }
}
