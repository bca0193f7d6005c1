//! Where water leaves.

use landform_core::Result;
use landform_core::terrain::NodeSurface;
use landform_core::units::Length;
use landform_core::verb::{Context, Edit, NamedOutlets, Outlets, Params, Source};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Sets where water leaves the ground, for all later stages that have no outlets of their own.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct SetOutlets {
    /// The outlets: "border", "valleys", "sea", a list of sides, or a table with `border_where` and
    /// `below`, or with `mask`.
    pub outlets: Outlets,
    /// Sea level, for "sea". If not given, it is the environment's, or else 0 m.
    pub sea_level: Option<Length>,
}

impl Default for SetOutlets {
    fn default() -> Self {
        Self { outlets: Outlets::Named(NamedOutlets::Border), sea_level: None }
    }
}

impl Params for SetOutlets {
    const NAME: &'static str = "set_outlets";
    const SOURCES: &'static [Source] = &[];

    fn check(&self) -> Result<()> {
        self.outlets.check()
    }
}

impl<T: NodeSurface> Edit<T> for SetOutlets {
    fn edit(&self, terrain: &mut T, context: &Context) -> Result<()> {
        let level = context.environment.level_or(self.sea_level, context.time);
        self.outlets.apply(terrain, level, context)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use landform_core::grid::{Grid, Shape, Status};
    use landform_core::terrain::HeightField;

    #[test]
    fn what_was_said_holds_for_what_follows() {
        let grid = Grid::new(Shape::new(5, 5), [10.0, 10.0]).unwrap();
        let mut field = HeightField::new(grid, (0..25).map(f64::from).collect()).unwrap();
        let south: SetOutlets = serde_json::from_str(r#"{"outlets":["south"]}"#).unwrap();
        south.edit(&mut field, &Context::default()).unwrap();
        let held =
            |field: &HeightField| field.chosen_status().unwrap().iter().filter(|&&s| s == Status::BaseLevel).count();
        assert_eq!(held(&field), 5);
        let sea: SetOutlets = serde_json::from_str(r#"{"outlets":"sea","sea_level":"2.5 m"}"#).unwrap();
        sea.edit(&mut field, &Context::default()).unwrap();
        assert_eq!(held(&field), 3);
        let dry: SetOutlets = serde_json::from_str(r#"{"outlets":"sea","sea_level":"-1 m"}"#).unwrap();
        assert!(dry.edit(&mut field, &Context::default()).is_err());
    }
}
