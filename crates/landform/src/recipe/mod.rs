//! Recipes: lists of stages in TOML, checked completely before anything runs.
//!
//! ```
//! use std::path::Path;
//! use landform::{core::verb::MemoryOutput, recipe::{Options, Recipe}};
//!
//! let text = r#"
//! [[stage]]
//! use = "flat"
//! grid = { size = ["400 m", "400 m"], cell_size = "100 m" }
//! [[stage]]
//! use = "write_raster""#;
//! let recipe = Recipe::parse(text, "plain", Path::new("."), &[])?;
//! assert_eq!(recipe.plan(None, "")?.stages[0].nodes, 25);
//! let mut out = MemoryOutput::default();
//! recipe.run(&mut out, &Options::default())?;
//! assert!(out.0.contains_key("elevation.tif"));
//! # Ok::<(), landform::Error>(())
//! ```

mod cache;
mod checkpoint;
mod clock;
mod coarse;
mod entry;
mod evolve;
mod fields;
mod fit;
mod gallery;
mod help;
mod level;
mod listing;
mod look;
mod options;
mod parse;
mod paths;
mod plan;
mod region;
mod run;
mod runs;
mod schema;
mod sequence;
mod stages;
mod table;
mod tree;
mod vary;
mod watch;

pub use cache::{CACHE_LIMIT, Cache, Kept};
pub use clock::{Clock, Until};
pub(crate) use evolve::model_of;
pub use fit::{Aim, Fit, Fitted, Span};
pub use gallery::{GALLERY, GalleryRecipe};
pub use help::{Citation, Parameter, catalogue, cite, describe, parameters};
pub use landform_core::stage::{Stage, Verb};
pub use landform_core::terrain::AnyTerrain;
pub use level::Level;
pub use listing::{Listed, Part};
pub use look::{Change, Left, Looker, Moment};
pub use options::{Options, Outputs, Progress, Signal};
pub use parse::{Override, Recipe};
pub use plan::{Plan, PlannedStage};
pub use run::Ran;
pub use runs::Row;
pub use schema::schema;
pub use stages::stages;
pub use vary::{Axis, Sweep, contact_sheet};
pub use watch::Watch;
