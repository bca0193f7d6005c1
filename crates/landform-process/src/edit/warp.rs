//! Ground displaced sideways.

use landform_core::algo::noise::fbm;
use landform_core::field::Values;
use landform_core::terrain::{HeightField, Interpolation, Layer, NodeSurface, sample_by};
use landform_core::units::{Length, RatioDimension};
use landform_core::verb::{Context, Edit, Params, Reach, Source, Varying};
use landform_core::{Result, math, parallel};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Displaces the ground sideways by noise: straight lines bend and circles become irregular. Beyond
/// the border the ground is mirrored.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Warp {
    /// Greatest displacement. It is rarely more than half of this.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1e7))]
    pub amplitude: Length,
    /// Length of the coarsest waves of the displacement.
    #[schemars(extend("x-above" = 0.0))]
    pub wavelength: Length,
    /// Number of octaves, each half as long.
    #[schemars(extend("x-min" = 1, "x-max" = 24))]
    pub octaves: u32,
    /// Hurst exponent of the displacement: 1 is smooth, 0 is rough.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1.0))]
    pub hurst: f64,
    /// Fraction of the displacement that is applied, 0 to 1; may vary in space, as a mask.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1.0))]
    pub amount: Varying<RatioDimension>,
}

impl Default for Warp {
    fn default() -> Self {
        Self {
            amplitude: Length::of(300.0),
            wavelength: Length::of(2_000.0),
            octaves: 4,
            hurst: 1.0,
            amount: landform_core::units::Ratio::of(1.0).into(),
        }
    }
}

impl Params for Warp {
    const NAME: &'static str = "warp";
    const SOURCES: &'static [Source] = &[Source {
        authors: "Ebert, Musgrave, Peachey, Perlin & Worley (2003)",
        title: "Texturing and Modeling: A Procedural Approach, third edition, Morgan Kaufmann",
        doi: "",
    }];

    fn reach(&self) -> Reach {
        Reach::Distance(self.amplitude.si()).or(self.amount.reach())
    }
}

impl Edit<HeightField> for Warp {
    fn edit(&self, terrain: &mut HeightField, context: &Context) -> Result<()> {
        let amount = self.amount.resolve("amount", terrain, context)?;
        let (amplitude, wave) = (self.amplitude.si(), self.wavelength.si());
        let gain = math::pow(2.0, -self.hurst);
        let [lo, hi] = terrain.whole_bounds();
        let grid = terrain.grid().clone();
        let from: Vec<[f64; 2]> = parallel::map(grid.len(), |i| {
            let p = grid.position(i);
            [0, 1].map(|k| {
                let noise = fbm(context.seed.with(k as u64), p[0] / wave, p[1] / wave, self.octaves, 2.0, gain);
                mirrored(p[k] + amount.at(i).clamp(0.0, 1.0) * amplitude * noise, lo[k], hi[k])
            })
        });
        let moved = |values: &[f64], interpolation: Interpolation| {
            parallel::map(grid.len(), |i| {
                let v = sample_by(interpolation, &grid, values, from[i]);
                // Data stays where data was: what was drawn from nodata stays as it is.
                if v.is_nan() || values[i].is_nan() { values[i] } else { v }
            })
        };
        let elevation = moved(terrain.elevation(), Interpolation::Cubic);
        let layers = terrain.layers().map(|l| l.mapped(|values| moved(values, Interpolation::Linear)));
        terrain.set_layers(None);
        terrain.change(Layer::Bedrock, |z| z.copy_from_slice(&elevation));
        terrain.set_layers(layers);
        let fields: Vec<(String, Vec<f64>)> = terrain
            .fields
            .iter()
            .filter_map(|(name, values)| match values {
                Values::F64(v) => Some((name.to_string(), moved(v, Interpolation::Linear))),
                _ => None,
            })
            .collect();
        for (name, values) in fields {
            terrain.fields.insert_values(&name, Values::F64(values))?;
        }
        Ok(())
    }
}

/// A coordinate beyond the border as far within it.
fn mirrored(v: f64, lo: f64, hi: f64) -> f64 {
    let width = hi - lo;
    if width <= 0.0 {
        return lo;
    }
    let t = (v - lo).rem_euclid(2.0 * width);
    (lo + if t > width { 2.0 * width - t } else { t }).clamp(lo, hi)
}

#[cfg(test)]
mod tests {
    use super::*;
    use landform_core::grid::{Grid, Shape};
    use landform_core::random::Seed;

    #[test]
    fn a_straight_ridge_winds_and_keeps_its_height() {
        let grid = Grid::new(Shape::new(101, 101), [10.0, 10.0]).unwrap();
        let ridge = |i: usize| 100.0 - (grid.position(i)[0] - 500.0).abs() / 10.0;
        let mut terrain = HeightField::new(grid.clone(), (0..grid.len()).map(ridge).collect()).unwrap();
        let warp = Warp { amplitude: Length::of(100.0), wavelength: Length::of(400.0), ..Warp::default() };
        warp.edit(&mut terrain, &Context { seed: Seed(4), ..Context::default() }).unwrap();
        let z = terrain.elevation();
        let crest: Vec<usize> =
            (0..101).map(|r| (0..101).max_by(|&a, &b| z[r * 101 + a].total_cmp(&z[r * 101 + b])).unwrap()).collect();
        let (least, most) = (crest.iter().min().unwrap(), crest.iter().max().unwrap());
        assert!(most - least >= 4 && *least >= 40 && *most <= 60, "{crest:?}");
        assert!(z.iter().all(|v| v.is_finite()) && (0..101).all(|r| z[r * 101 + crest[r]] > 98.0));
        let still = Warp { amplitude: Length::of(0.0), ..warp };
        let before = z.to_vec();
        still.edit(&mut terrain, &Context { seed: Seed(4), ..Context::default() }).unwrap();
        assert!(terrain.elevation().iter().zip(&before).all(|(a, b)| (a - b).abs() < 1e-9));
    }
}
