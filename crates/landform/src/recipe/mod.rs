//! Recipes: a list of stages in TOML, checked whole before anything runs.

mod cache;
mod clock;
mod entry;
mod gallery;
mod help;
mod parse;
mod plan;
mod run;
mod stages;
mod tree;
mod vary;
mod watch;

pub use clock::{Clock, Until};
pub use gallery::{GALLERY, GalleryRecipe};
pub use help::{Citation, Parameter, catalogue, cite, describe, parameters, schema};
pub use landform_core::stage::{Stage, Verb};
pub use landform_core::terrain::AnyTerrain;
pub use parse::{Override, Recipe};
pub use plan::{Plan, PlannedStage};
pub use run::{Options, Progress, Ran, Signal};
pub use stages::stages;
pub use vary::{Over, Row, Sweep, contact_sheet};
pub use watch::Watch;
