//! Recipes: a list of stages in TOML, checked whole before anything runs.

mod any_terrain;
mod cache;
mod clock;
mod entry;
mod gallery;
mod help;
mod parse;
mod plan;
mod run;
mod stage;
mod stages;
mod tree;
mod vary;
mod watch;

pub use any_terrain::AnyTerrain;
pub use clock::{Clock, Until};
pub use gallery::{GALLERY, GalleryRecipe};
pub use help::{Citation, Parameter, catalogue, cite, describe, parameters, schema};
pub use parse::{Override, Recipe};
pub use plan::{Plan, PlannedStage};
pub use run::{Options, Progress, Ran, Signal};
pub use stage::{Stage, Verb};
pub use stages::STAGES;
pub use vary::{Over, Row, Sweep, contact_sheet};
pub use watch::Watch;
