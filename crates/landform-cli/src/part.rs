//! Parts of a recipe: coarser cells, or a window.

use landform::core::units::Length;
use landform::core::{Error, Result};
use landform::recipe::Recipe;

#[derive(clap::Args)]
pub(crate) struct Part {
    /// Share of the resolution, for a preview: 1/2, 1/4, ... 1/64. Extents, rates and times do not
    /// change.
    #[arg(long, value_name = "1/N")]
    level: Option<String>,
    /// Builds this window only, in metres or with units; for recipes whose stages do not need the
    /// whole ground.
    #[arg(long, value_name = "WEST,SOUTH,EAST,NORTH", allow_hyphen_values = true)]
    region: Option<String>,
}

impl Part {
    /// The part of a recipe that was read.
    pub(crate) fn of(&self, recipe: Result<Recipe>) -> Result<Recipe> {
        let mut recipe = recipe?;
        if let Some(level) = &self.level {
            recipe = recipe.at(level.parse()?)?;
        }
        match &self.region {
            Some(region) => recipe.within(corners(region)?),
            None => Ok(recipe),
        }
    }
}

fn corners(text: &str) -> Result<[[f64; 2]; 2]> {
    let sides: Vec<f64> = text.split(',').map(|t| Length::parse(t.trim()).map(Length::si)).collect::<Result<_>>()?;
    match sides[..] {
        [west, south, east, north] => Ok([[west, south], [east, north]]),
        _ => Err(Error::parameter("region", text, "west,south,east,north, for example 0,0,2km,2km")),
    }
}
