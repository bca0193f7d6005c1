//! Sand in whole units on the ground of a terrain in metres.

use landform_core::agents::Sand;
use landform_core::field::names;
use landform_core::terrain::{HeightField, NodeSurface};
use landform_core::verb::Context;
use landform_core::{Error, Result, math};
use serde::{Deserialize, Serialize};

use super::params::{Borders, Dunes, UNITS_A_SLAB};

/// Sand on the ground of a terrain.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Field {
    pub(super) sand: Sand,
    /// Hard ground, m; NaN on nodata.
    ground: Vec<f64>,
    /// Height of a unit, m.
    pub(super) unit: f64,
    /// Units that left over the sides.
    pub(super) left: i64,
    /// Units added up in [`Field::take_over`] by others.
    torus: bool,
}

impl Field {
    /// Lays the sand of the parameters on a terrain, beside what lies there.
    pub(super) fn lay(params: &Dunes, terrain: &HeightField, context: &Context) -> Result<Self> {
        let slab = params.slab_on(&terrain.grid);
        let unit = slab / f64::from(UNITS_A_SLAB);
        let z = terrain.elevation();
        let lying = terrain.fields().get(&names::SAND_DEPTH, "dunes").unwrap_or(&[]);
        let lying = |i: usize| lying.get(i).copied().filter(|d| d.is_finite()).unwrap_or(0.0).max(0.0);
        let more = params.sand.resolve("sand", terrain, context)?;
        let highest = landform_core::parallel::max(z.len(), |i| z[i].abs() + more.at(i).abs() + lying(i));
        if highest / unit > f64::from(1 << 28) {
            let most = unit * f64::from(1 << 28);
            return Err(Error::parameter(
                "slab",
                format!("{slab} m"),
                &format!("thicker slabs, or ground within {most:.0} m"),
            ));
        }
        let ground: Vec<f64> = (0..z.len()).map(|i| z[i] - lying(i)).collect();
        let units = ground.iter().map(|g| if g.is_nan() { 0 } else { (g / unit).round() as i32 }).collect();
        let torus = params.borders == Borders::Periodic;
        let steps = Sand::steps_of(params.repose.si(), terrain.grid.spacing, unit, UNITS_A_SLAB);
        let mut sand = Sand::new(terrain.grid.shape, torus, units, steps, UNITS_A_SLAB);
        let sea = params.sea_level.si();
        for i in 0..z.len() {
            if ground[i].is_nan() || ground[i] < sea {
                sand.make_sink(i);
                continue;
            }
            let depth = more.at(i);
            if depth < 0.0 {
                return Err(Error::parameter("sand", format!("{depth} m at node {i}"), "at least 0 m everywhere"));
            }
            // Whole slabs, rounded at random, are the first unevenness that wind takes hold of.
            let slabs = (depth / slab + context.seed.uniform(i as u64)).floor() as i32;
            sand.lay(i, slabs * UNITS_A_SLAB + (lying(i) / unit).round() as i32);
        }
        sand.settle();
        Ok(Self { sand, ground, unit, left: 0, torus })
    }

    /// Height of a slab, m.
    pub(super) fn slab(&self) -> f64 {
        self.unit * f64::from(UNITS_A_SLAB)
    }

    /// Whether what leaves on one side enters on the other.
    pub(super) fn is_torus(&self) -> bool {
        self.torus
    }

    /// Sand of every site, units.
    pub(super) fn depths(&self) -> impl Iterator<Item = i32> {
        (0..self.ground.len()).map(|i| self.sand.depth(i))
    }

    /// Elevation of a site, m.
    fn elevation(&self, i: usize) -> f64 {
        self.ground[i] + f64::from(self.sand.depth(i)) * self.unit
    }

    /// Takes ground and sand as other processes have left them: sand by its field, if they wrote it; else what was lowered was sand first,
    /// and hard ground where none is left.
    pub(super) fn take_over(&mut self, terrain: &HeightField) {
        let z = terrain.elevation();
        let written = terrain.fields().get(&names::SAND_DEPTH, "dunes").unwrap_or(&[]);
        for i in 0..z.len() {
            let (own, known) = (self.sand.depth(i), self.elevation(i));
            let told = written.get(i).copied().unwrap_or(f64::from(own) * self.unit);
            let is_told = told != f64::from(own) * self.unit;
            if z[i].is_nan() || z[i] == known && !is_told {
                continue;
            }
            let depth = if is_told {
                (told / self.unit).round() as i32
            } else {
                own - ((known - z[i]) / self.unit).round().clamp(0.0, f64::from(own)) as i32
            };
            self.ground[i] = z[i] - f64::from(depth) * self.unit;
            self.sand.set_site(i, (self.ground[i] / self.unit).round() as i32, depth);
        }
    }

    /// Writes elevation and depth of sand.
    pub(super) fn write(&self, terrain: &mut HeightField) {
        for i in 0..self.ground.len() {
            if !self.ground[i].is_nan() {
                terrain.elevation_mut()[i] = self.elevation(i);
            }
        }
        let depth = self.depths().map(|d| f64::from(d) * self.unit).collect();
        terrain.fields_mut().insert(&names::SAND_DEPTH, depth);
    }

    /// The site where sand comes down that starts at a site and hops so many columns east and rows south; none if it leaves.
    #[inline]
    pub(super) fn hop(&self, site: usize, cols: i64, rows: i64) -> Option<usize> {
        let shape = self.sand.shape();
        let wide = shape.cols as u32;
        let (c, r) = (i64::from(site as u32 % wide) + cols, i64::from(site as u32 / wide) + rows);
        if (c as u64) < shape.cols as u64 && (r as u64) < shape.rows as u64 {
            return Some(shape.index(r as usize, c as usize));
        }
        self.torus
            .then(|| shape.index(r.rem_euclid(shape.rows as i64) as usize, c.rem_euclid(shape.cols as i64) as usize))
    }

    /// Columns and rows of a hop along a wind, as real numbers.
    pub(super) fn cells_of(&self, towards: [f64; 2], distance: f64, spacing: [f64; 2]) -> [f64; 2] {
        [towards[0] * distance / spacing[0], -towards[1] * distance / spacing[1]]
    }

    /// tan of an angle as a fall in units over a distance, m.
    pub(super) fn fall(&self, angle: f64, distance: f64) -> f32 {
        (math::tan(angle) * distance / self.unit) as f32
    }
}
