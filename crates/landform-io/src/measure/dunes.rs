//! Measures of a dune field.
//!
//! The winds that made it are those of the last stage of the history in which sand was blown.

use landform_core::Result;
use landform_core::analysis::{Dunes, dunes, shadow_error};
use landform_core::field::names;
use landform_core::terrain::{HeightField, NodeSurface};
use landform_core::units::Angle;
use landform_core::verb::{Event, Landscape, Measure, Params, Rose, Source, Wind, check_path};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;

/// Measures dunes: height, spacing, direction of crests, bare ground, share of sand near repose,
/// and the type of the dunes.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct MeasureDunes {
    /// Path below the output folder.
    pub path: String,
    /// Winds that made them. If none are given, they are those of the last `dunes`, or else the
    /// environment's, or a west wind.
    pub wind: Vec<Wind>,
    /// Angle of repose of the sand.
    #[schemars(extend("x-above" = 0.0, "x-max" = 80.0))]
    pub repose: Angle,
    /// Whether the map is periodic: opposite sides meet.
    pub periodic: bool,
}

impl Default for MeasureDunes {
    fn default() -> Self {
        Self { path: "dunes.json".into(), wind: Vec::new(), repose: Angle::of(33.0), periodic: true }
    }
}

impl Params for MeasureDunes {
    const NAME: &'static str = "measure_dunes";
    const SOURCES: &'static [Source] = &[Source {
        authors: "Wasson & Hyde (1983)",
        title: "Factors determining desert dune type, Nature 304",
        doi: "10.1038/304337a0",
    }];

    fn outputs(&self) -> Vec<String> {
        vec![self.path.clone()]
    }

    fn check(&self) -> Result<()> {
        if !self.wind.is_empty() {
            Rose::new("wind", &self.wind)?;
        }
        check_path(&self.path, &["json"])
    }
}

impl Measure<HeightField> for MeasureDunes {
    type Out = Dunes;

    fn path(&self) -> &str {
        &self.path
    }

    fn measure(&self, landscape: &Landscape<'_, HeightField>) -> Result<Dunes> {
        let terrain = landscape.terrain;
        let sand = &terrain.real("sand_depth", Self::NAME)?;
        let wind = if self.wind.is_empty() { winds_of(landscape.history) } else { self.wind.clone() };
        let rose = landscape.environment.rose(&wind)?;
        let (grid, z) = (terrain.grid(), terrain.elevation());
        let mut found = dunes(grid, z, sand, &rose, self.repose.si(), self.periodic);
        if let Ok(shelter) = terrain.fields().get(&names::SHELTER, Self::NAME) {
            found.shadow = Some(shadow_error(grid, z, shelter, &rose, self.periodic));
        }
        Ok(found)
    }
}

/// The stage whose winds are looked for.
const DUNES: &str = "dunes";

/// Winds of the last stage in which sand was blown; none if it took the environment's, or there is
/// no such stage.
fn winds_of(history: &[Event]) -> Vec<Wind> {
    let last = history.iter().rev().map(dunes_in).find(|found| !found.is_empty()).unwrap_or_default();
    let winds =
        last.into_iter().filter_map(|mut params| serde_json::from_value::<Vec<Wind>>(params["wind"].take()).ok());
    winds.flatten().collect()
}

/// Parameters of every `dunes` of a stage: the stage itself, or processes on a clock.
fn dunes_in(event: &Event) -> Vec<Value> {
    let is_dunes = event.stage == DUNES || event.stage.ends_with(&format!("({DUNES})"));
    match serde_json::from_str(&event.parameters) {
        // As the library records it: one table for each name.
        Ok(Value::Array(parts)) => {
            event.stage.split(" + ").zip(parts).filter(|(name, _)| *name == DUNES).map(|(_, params)| params).collect()
        }
        Ok(params) if is_dunes => vec![params],
        Ok(mut params) => match params["process"].take() {
            Value::Array(parts) => parts.into_iter().filter(|part| part["use"] == DUNES).collect(),
            _ => Vec::new(),
        },
        Err(_) => Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn event(stage: &str, parameters: &str) -> Event {
        Event { stage: stage.into(), parameters: parameters.into(), sources: Vec::new(), outcome: None }
    }

    #[test]
    fn winds_are_those_that_blew_last() {
        let south = r#"{ "wind": [{ "from": "180 deg", "weight": 1.0 }], "sand": 3.0 }"#;
        let on_a_clock = format!(
            r#"{{ "clock": {{}}, "process": [{{ "use": "uplift" }}, {{ "use": "dunes", {} }}]}}"#,
            &south[1..south.len() - 1]
        );
        let from_south = vec![Wind::from(180.0, 1.0)];
        for history in [
            vec![event("dunes", south), event("smooth", "{}")],
            vec![event("dunes", r#"{ "wind": [{ "from": "90 deg" }] }"#), event("deep (dunes)", south)],
            vec![event("evolve", &on_a_clock)],
            vec![event("uplift + dunes", &format!("[{{}}, {south}]"))],
        ] {
            assert_eq!(winds_of(&history), from_south, "{history:?}");
        }
        assert!(winds_of(&[event("dunes", r#"{ "wind": [] }"#)]).is_empty());
        assert!(winds_of(&[event("dunes of another", "no json"), event("flat", "[]")]).is_empty());
    }
}
