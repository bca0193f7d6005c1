//! One line of the table of stages: function pointers made from types.

use std::any::Any;

use landform_core::random::Seed;
use landform_core::sim::Simulation;
use landform_core::verb::{
    Context, Convert, Edit, Estimate, Event, Export, Generator, Landscape, Measure, Output, OwnClock, Params, Process,
    Source, properties,
};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::de::DeserializeOwned;
use serde_json::Value as Json;

use super::any_terrain::{AnyTerrain, Held};

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
    /// Tells something about it.
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

/// A stage: parameters, and what to do with them, for one kind of terrain.
#[derive(Debug)]
pub struct Stage {
    /// Name in recipes.
    pub name: &'static str,
    /// What it does.
    pub verb: Verb,
    /// Kind of terrain that it needs; none for generators.
    pub on: Option<&'static str>,
    /// Kind of terrain after it.
    pub to: &'static str,
    /// Papers behind it.
    pub sources: &'static [Source],
    /// Keys whose value is a path that is read.
    pub inputs: &'static [&'static str],
    /// Fields that a process needs.
    pub reads: &'static [&'static str],
    /// Fields that a process changes.
    pub writes: &'static [&'static str],
    pub(super) form: Form,
    pub(super) act: Act,
}

/// What is known of a stage's parameters.
#[derive(Clone, Copy, Debug)]
pub(super) struct Form {
    pub(super) properties: fn() -> Vec<(String, Json)>,
    pub(super) schema: fn() -> Json,
    pub(super) defaults: fn() -> Json,
    /// Reads, validates and writes back.
    pub(super) normalize: fn(&Json) -> Result<Json, Refusal>,
}

/// Why parameters were refused.
#[derive(Debug)]
pub(super) enum Refusal {
    /// By their shape, at a path.
    Shape(serde_path_to_error::Error<serde_json::Error>),
    /// By their value.
    Value(Error),
}

/// A landscape whose kind is only known when it runs.
pub(super) struct AnyLandscape<'a> {
    pub(super) terrain: &'a AnyTerrain,
    pub(super) history: &'a [Event],
    pub(super) seed: u64,
    pub(super) title: &'a str,
}

/// What to do.
#[derive(Clone, Copy, Debug)]
pub(super) enum Act {
    Generate {
        make: fn(&Json, &Context) -> Result<AnyTerrain>,
        estimate: fn(&Json, &Context) -> Result<Estimate>,
    },
    Edit {
        edit: fn(&Json, &mut AnyTerrain, &Context) -> Result<()>,
        estimate: fn(&Json, Estimate) -> Result<Estimate>,
    },
    Convert {
        convert: fn(&Json, &AnyTerrain) -> Result<AnyTerrain>,
        estimate: fn(&Json, Estimate) -> Result<Estimate>,
    },
    Process {
        /// Adds itself to a `Simulation<T>`.
        add: fn(&Json, &mut dyn Any) -> Result<()>,
        own_clock: fn(&Json) -> Result<Option<OwnClock>>,
    },
    /// Path and value.
    Measure(fn(&Json, &AnyTerrain) -> Result<(String, Json)>),
    Export(fn(&Json, &AnyLandscape, &mut dyn Output) -> Result<()>),
}

/// Parameters from JSON that was validated before.
fn params<P: DeserializeOwned>(json: &Json) -> Result<P> {
    serde_json::from_value(json.clone()).map_err(|e| Error::Recipe { at: None, what: e.to_string(), hint: None })
}

impl Form {
    const fn of<P: Params>() -> Self {
        Self {
            properties: properties::<P>,
            schema: schema_of::<P>,
            defaults: || serde_json::to_value(P::default()).unwrap_or_default(),
            normalize: |json| {
                let params: P = serde_path_to_error::deserialize(json).map_err(Refusal::Shape)?;
                params.validate().map_err(Refusal::Value)?;
                serde_json::to_value(&params).map_err(|e| Refusal::Value(Error::format("parameters", e)))
            },
        }
    }
}

/// The JSON schema of parameters.
pub(super) fn schema_of<P: JsonSchema>() -> Json {
    schemars::schema_for!(P).to_value()
}

impl Stage {
    const fn new<P: Params>(verb: Verb, on: Option<&'static str>, to: &'static str, act: Act) -> Self {
        Self {
            name: P::NAME,
            verb,
            on,
            to,
            sources: P::SOURCES,
            inputs: P::INPUTS,
            reads: &[],
            writes: &[],
            form: Form::of::<P>(),
            act,
        }
    }

    pub(super) const fn generator<P: Generator<T>, T: Held>() -> Self {
        let act = Act::Generate {
            make: |json, context| Ok(params::<P>(json)?.generate(context)?.wrap()),
            estimate: |json, context| params::<P>(json)?.estimate(context),
        };
        Self::new::<P>(Verb::Generate, None, T::KIND, act)
    }

    pub(super) const fn edit<P: Edit<T>, T: Held>() -> Self {
        let act = Act::Edit {
            edit: |json, terrain, context| params::<P>(json)?.edit(terrain.get_mut::<T>(P::NAME)?, context),
            estimate: |json, before| Ok(params::<P>(json)?.estimate(before)),
        };
        Self::new::<P>(Verb::Edit, Some(T::KIND), T::KIND, act)
    }

    pub(super) const fn convert<P: Convert<S, T>, S: Held, T: Held>() -> Self {
        let act = Act::Convert {
            convert: |json, terrain| Ok(params::<P>(json)?.convert(terrain.get::<S>(P::NAME)?)?.wrap()),
            estimate: |json, source| Ok(params::<P>(json)?.estimate(source)),
        };
        Self::new::<P>(Verb::Convert, Some(S::KIND), T::KIND, act)
    }

    pub(super) const fn process<P: Process<T>, T: Held>() -> Self {
        let act = Act::Process {
            add: |json, simulation| match simulation.downcast_mut::<Simulation<'static, T>>() {
                Some(simulation) => simulation.add(params::<P>(json)?),
                None => Err(Error::Unsupported {
                    what: P::NAME.into(),
                    on: "another terrain".into(),
                    supports: T::KIND.into(),
                }),
            },
            own_clock: |json| Ok(params::<P>(json)?.own_clock()),
        };
        Self { reads: P::READS, writes: P::WRITES, ..Self::new::<P>(Verb::Process, Some(T::KIND), T::KIND, act) }
    }

    pub(super) const fn measure<P: Measure<T>, T: Held>() -> Self {
        let act = Act::Measure(|json, terrain| {
            let params = params::<P>(json)?;
            let value = serde_json::to_value(params.measure(terrain.get::<T>(P::NAME)?)?);
            Ok((params.path().into(), value.map_err(|e| Error::format("measure", e))?))
        });
        Self::new::<P>(Verb::Measure, Some(T::KIND), T::KIND, act)
    }

    pub(super) const fn export<P: Export<T>, T: Held>() -> Self {
        let act = Act::Export(|json, landscape, out| {
            let AnyLandscape { history, seed, title, .. } = *landscape;
            let terrain = landscape.terrain.get::<T>(P::NAME)?;
            params::<P>(json)?.export(&Landscape { terrain, history, seed, title }, out)
        });
        Self::new::<P>(Verb::Export, Some(T::KIND), T::KIND, act)
    }

    /// The clock that the stage brings with it, if it is a process that does.
    pub(super) fn own_clock(&self, json: &Json) -> Result<Option<OwnClock>> {
        if let Act::Process { own_clock, .. } = self.act { own_clock(json) } else { Ok(None) }
    }

    /// What the stage is for, in a sentence or two.
    pub fn summary(&self) -> String {
        (self.form.schema)()["description"].as_str().unwrap_or_default().replace('\n', " ")
    }
}

/// The seed of a stage: inserting another stage leaves it as it is.
pub(super) fn stage_seed(recipe: u64, name: &str) -> Seed {
    Seed(recipe).named(name)
}
