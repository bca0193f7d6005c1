//! Simple shapes.

use landform_core::grid::Grid;
use landform_core::units::{Angle, Length};
use landform_core::verb::{Context, Params, Reach, Source};
use landform_core::{Error, Result, math, parallel};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{GridParams, OnGrid};

/// A simple shape between two elevations: initial ground, or a pattern for other stages.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Shape {
    /// Extent and distance between nodes.
    pub grid: GridParams,
    /// Which shape.
    pub form: Form,
    /// Lowest elevation.
    pub low: Length,
    /// Highest elevation.
    pub high: Length,
    /// Ramp, steps and folds: compass direction in which the ground rises, or across which it is
    /// folded.
    pub direction: Angle,
    /// Folds: distance from crest to crest.
    #[schemars(extend("x-above" = 0.0))]
    pub wavelength: Length,
    /// Steps: number of levels.
    #[schemars(extend("x-min" = 2, "x-max" = 10_000))]
    pub levels: u32,
}

/// A simple shape.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Form {
    /// A plane that rises in the direction.
    #[default]
    Ramp,
    /// Level steps that rise in the direction.
    Steps,
    /// Sine waves across the direction: anticlines and synclines.
    Folds,
    /// A cone on the largest circle.
    Cone,
    /// A paraboloid on the largest circle.
    Dome,
    /// A roof over both axes: high where |x| + |y| is small.
    Diamond,
    /// A pyramid: high in the middle, falling equally to all four sides (1 - r of formulas).
    Radial,
}

impl Default for Shape {
    fn default() -> Self {
        Self {
            grid: GridParams::default(),
            form: Form::Ramp,
            low: Length::of(0.0),
            high: Length::of(1_000.0),
            direction: Angle::of(0.0),
            wavelength: Length::of(2_000.0),
            levels: 5,
        }
    }
}

impl Params for Shape {
    const NAME: &'static str = "shape";
    const RENAMED: &'static [(&'static str, &'static str)] = GridParams::RENAMED;
    const SOURCES: &'static [Source] = &[];

    fn reach(&self) -> Reach {
        Reach::Point
    }
}

impl Shape {
    /// Height from 0 to 1 at a position relative to the middle, in halves of the extent (`u`, `v`)
    /// and in m.
    fn at(&self, [u, v]: [f64; 2], [x, y]: [f64; 2], half: [f64; 2]) -> f64 {
        let (sx, sy) = (math::sin(self.direction.si()), math::cos(self.direction.si()));
        let along = x * sx + y * sy;
        // The corner furthest in the direction.
        let reach = half[0] * sx.abs() + half[1] * sy.abs();
        let ramp = if reach > 0.0 { (0.5 + 0.5 * along / reach).clamp(0.0, 1.0) } else { 0.0 };
        let smaller = half[0].min(half[1]);
        let radius = if smaller > 0.0 { math::hypot(x, y) / smaller } else { 0.0 };
        match self.form {
            Form::Ramp => ramp,
            Form::Steps => {
                let n = f64::from(self.levels);
                (ramp * n).floor().min(n - 1.0) / (n - 1.0)
            }
            Form::Folds => 0.5 + 0.5 * math::cos(std::f64::consts::TAU * along / self.wavelength.si()),
            Form::Cone => (1.0 - radius).max(0.0),
            Form::Dome => (1.0 - radius * radius).max(0.0),
            Form::Diamond => (1.0 - 0.5 * (u.abs() + v.abs())).max(0.0),
            Form::Radial => 1.0 - u.abs().max(v.abs()),
        }
    }
}

impl OnGrid for Shape {
    fn grid(&self) -> &GridParams {
        &self.grid
    }

    fn elevations(&self, grid: &Grid, _: &Context) -> Result<Vec<f64>> {
        let cell = grid.spacing[0].max(grid.spacing[1]);
        if self.form == Form::Folds && self.wavelength.si() < 2.0 * cell {
            return Err(Error::parameter(
                "wavelength",
                self.wavelength,
                &format!("at least two cells, {} m", 2.0 * cell),
            ));
        }
        let whole = grid.whole();
        let half = whole.extent().map(|e| 0.5 * e);
        let middle = [whole.origin[0] + half[0], whole.origin[1] - half[1]];
        let (low, high) = (self.low.si(), self.high.si());
        Ok(parallel::map(grid.len(), |i| {
            let p = grid.position(i);
            let d = [p[0] - middle[0], p[1] - middle[1]];
            let part = |k: usize| if half[k] > 0.0 { d[k] / half[k] } else { 0.0 };
            math::lerp(low, high, self.at([part(0), part(1)], d, half))
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use landform_core::random::Seed;
    use landform_core::terrain::NodeSurface;
    use landform_core::verb::Generator;

    fn make(form: Form, direction: f64) -> Vec<f64> {
        let shape = Shape {
            grid: GridParams::of([100.0; 2], 10.0),
            form,
            direction: Angle::from_si(direction.to_radians()),
            wavelength: Length::of(50.0),
            low: Length::of(10.0),
            high: Length::of(110.0),
            ..Shape::default()
        };
        shape.generate(&Context { seed: Seed(1), ..Context::default() }).unwrap().elevation().to_vec()
    }

    #[test]
    fn shapes_have_their_heights_where_they_should() {
        let at = |z: &[f64], row: usize, col: usize| z[row * 11 + col];
        let ramp = make(Form::Ramp, 90.0);
        assert!((at(&ramp, 3, 0) - 10.0).abs() < 1e-9 && (at(&ramp, 7, 10) - 110.0).abs() < 1e-9);
        let north = make(Form::Ramp, 0.0);
        assert!((at(&north, 0, 4) - 110.0).abs() < 1e-9 && (at(&north, 5, 4) - 60.0).abs() < 1e-9);
        let steps = make(Form::Steps, 0.0);
        let mut levels: Vec<i64> = steps.iter().map(|z| z.round() as i64).collect();
        levels.sort_unstable();
        levels.dedup();
        assert_eq!(levels, [10, 35, 60, 85, 110]);
        for form in [Form::Cone, Form::Dome, Form::Diamond, Form::Radial] {
            let z = make(form, 0.0);
            assert!((at(&z, 5, 5) - 110.0).abs() < 1e-9 && (at(&z, 0, 0) - 10.0).abs() < 1e-9, "{form:?}");
        }
        let folds = make(Form::Folds, 90.0);
        assert!((at(&folds, 2, 0) - at(&folds, 9, 5)).abs() < 1e-9 && (at(&folds, 0, 5) - 110.0).abs() < 1e-9);
    }
}
