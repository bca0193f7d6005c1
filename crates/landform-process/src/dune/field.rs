//! Sand in whole units on the ground of a terrain in metres.

use std::collections::VecDeque;

use landform_core::agents::Sand;
use landform_core::grid::Shape;
use landform_core::terrain::{HeightField, NodeSurface};
use landform_core::verb::{Context, Resolved};
use landform_core::{Error, Result, math};
use serde::{Deserialize, Serialize};

use super::params::{Borders, Dunes, UNITS_A_SLAB};

/// The layer that dunes are made of.
pub(super) const SAND: &str = "sand";

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
    /// Units that are gone, as far as steps have reported them.
    reported: i64,
    /// Whether what leaves on one side enters on the other.
    torus: bool,
    /// Sand as it was written last, m.
    #[serde(skip)]
    written: Vec<f64>,
}

/// Sites that are looked at together for what others changed.
const LOOK: usize = 1 << 10;

impl Field {
    /// Takes the sand that lies on a terrain, and at the start of a run adds the sand of the
    /// parameters.
    pub(super) fn lay(params: &Dunes, terrain: &HeightField, context: &Context) -> Result<Self> {
        let slab = params.slab_on(terrain.grid());
        let unit = slab / f64::from(UNITS_A_SLAB);
        let z = terrain.elevation();
        let lying = terrain.depth(SAND).unwrap_or(&[]);
        let lying = |i: usize| lying.get(i).copied().filter(|d| d.is_finite()).unwrap_or(0.0).max(0.0);
        let more = match context.step {
            0 => params.sand.resolve("sand", terrain, context)?,
            _ => Resolved::Uniform(0.0),
        };
        let highest = landform_core::parallel::max(z.len(), |i| z[i].abs() + more.at(i).abs() + lying(i));
        if highest / unit > f64::from(1 << 27) {
            let most = unit * f64::from(1 << 27);
            return Err(Error::parameter(
                "slab",
                format!("{slab} m"),
                &format!("thicker slabs, or ground within {most:.0} m"),
            ));
        }
        let ground: Vec<f64> = (0..z.len()).map(|i| z[i] - lying(i)).collect();
        let known = beside_holes(terrain.grid().shape, &ground);
        let units = known.iter().map(|g| (g / unit).round() as i32).collect();
        let torus = params.borders == Borders::Periodic;
        let steps = Sand::steps_of(params.repose.si(), terrain.grid().spacing, unit, UNITS_A_SLAB);
        let mut sand = Sand::new(terrain.grid().shape, torus, units, steps, UNITS_A_SLAB);
        let sea = params.sea_at(context.environment, context.time);
        for i in 0..z.len() {
            if ground[i].is_nan() || ground[i] < sea {
                sand.make_sink(i);
                continue;
            }
            let depth = more.at(i);
            if depth < 0.0 {
                return Err(Error::AtNode { name: "sand".into(), node: i, value: depth, expected: "at least 0 m" });
            }
            // Whole slabs, rounded at random, are the first unevenness on which the wind acts.
            let uneven = if context.step == 0 { context.seed.uniform(i as u64) } else { 0.0 };
            let slabs = (depth / slab + uneven).floor() as i32;
            sand.lay(i, slabs * UNITS_A_SLAB + (lying(i) / unit).round() as i32);
        }
        sand.settle();
        Ok(Self { sand, ground, unit, left: 0, reported: 0, torus, written: Vec::new() })
    }

    /// Units that are gone and that no step has reported yet.
    pub(super) fn newly_lost(&mut self) -> i64 {
        let gone = self.sand.swallowed() + self.left;
        gone - std::mem::replace(&mut self.reported, gone)
    }

    /// Height of a slab, m.
    pub(super) fn slab(&self) -> f64 {
        self.unit * f64::from(UNITS_A_SLAB)
    }

    /// Whether what leaves on one side enters on the other.
    pub(super) fn is_torus(&self) -> bool {
        self.torus
    }

    /// Reads ground and sand after other processes.
    pub(super) fn take_over(&mut self, terrain: &HeightField) {
        let (z, lying) = (terrain.elevation(), terrain.depth(SAND).unwrap_or(&[]));
        let n = z.len().min(lying.len());
        for first in (0..n).step_by(LOOK) {
            let sites = first..(first + LOOK).min(n);
            let depths = self.sand.depths_of(sites.clone());
            let (z, lying) = (&z[sites.clone()], &lying[sites.clone()]);
            // All at once, since it is seldom that anything changed.
            let ground = self.ground[sites.clone()].iter();
            let known =
                z.iter().zip(lying).zip(ground.zip(depths)).fold(true, |known, ((&z, &lying), (&ground, depth))| {
                    known & self.is_known(z, lying, ground, depth)
                });
            if !known {
                z.iter().zip(lying).zip(sites).for_each(|((&z, &lying), site)| self.take_over_at(site, z, lying));
            }
        }
    }

    /// Whether elevation and sand of a site are its ground and depth, but for rounding.
    #[inline]
    fn is_known(&self, z: f64, lying: f64, ground: f64, depth: i32) -> bool {
        let same = |a: f64, b: f64| (a - b).abs() < 1e-6 * self.unit;
        let own = f64::from(depth) * self.unit;
        z.is_nan() | (same(z, ground + own) & same(lying, own))
    }

    fn take_over_at(&mut self, site: usize, z: f64, lying: f64) {
        if !self.is_known(z, lying, self.ground[site], self.sand.depth(site)) {
            let depth = (lying / self.unit).round() as i32;
            self.ground[site] = z - f64::from(depth) * self.unit;
            self.sand.set_site(site, (self.ground[site] / self.unit).round() as i32, depth);
        }
    }

    /// Writes the depth of the sand; the surface follows.
    pub(super) fn write(&mut self, terrain: &mut HeightField) -> Result<()> {
        self.written.clear();
        self.written.extend(self.sand.depths().map(|d| f64::from(d) * self.unit));
        terrain.change_depth(SAND, &self.written)
    }

    /// The site where sand lands that starts at a row and column and hops this many columns east
    /// and rows south; none if it leaves.
    #[inline]
    pub(super) fn hop(&self, (row, col): (usize, usize), cols: i64, rows: i64) -> Option<usize> {
        let shape = self.sand.shape();
        let (c, r) = (col as i64 + cols, row as i64 + rows);
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

/// Rows and columns of sites, by multiplication: a division would keep the wind's hops waiting.
pub(super) struct Places {
    cols: u64,
    /// 2⁶³ / cols, rounded up: exact for sites below 2³².
    inverse: u64,
}

impl Places {
    pub(super) fn new(shape: Shape) -> Self {
        let cols = shape.cols as u64;
        Self { cols, inverse: (1 << 63) / cols + 1 }
    }

    /// Row and column of a site.
    #[inline]
    pub(super) fn of(&self, site: usize) -> (usize, usize) {
        let row = ((u128::from(self.inverse) * site as u128) >> 63) as u64;
        (row as usize, site - (row * self.cols) as usize)
    }
}

/// The ground, and in its holes that of the nearest site with data, so that sand does not fall into
/// them as into a pit.
fn beside_holes(shape: Shape, ground: &[f64]) -> Vec<f64> {
    let mut known = ground.to_vec();
    let mut next: VecDeque<usize> = (0..known.len()).filter(|&i| !known[i].is_nan()).collect();
    if next.len() == known.len() {
        return known;
    }
    while let Some(i) = next.pop_front() {
        let cell = shape.cell(i);
        let (rows, cols) = (cell.row.saturating_sub(1)..=cell.row + 1, cell.col.saturating_sub(1)..=cell.col + 1);
        for (row, col) in rows.flat_map(|r| cols.clone().map(move |c| (r, c))) {
            if row < shape.rows && col < shape.cols && known[shape.index(row, col)].is_nan() {
                known[shape.index(row, col)] = known[i];
                next.push_back(shape.index(row, col));
            }
        }
    }
    known
}
