//! Fewer nodes for the same ground, and back: for runs that go from coarse to fine.

use super::convert::{ValuesRaster, elevation_raster, sample_by};
use super::{HeightField, Interpolation, Layer, Layers, Mesh, NodeSurface, Rasterize, height_field};
use crate::field::{Fields, names};
use crate::grid::{Domain, Edges, Grid, Shape, Status};
use crate::parallel;

/// With fewer nodes than this there is no further coarse level.
const FEWEST: usize = 200;

impl Mesh {
    /// A mesh of about a quarter of the nodes, all of them nodes of this one: none nearer to
    /// another than twice the usual distance. Corners come first, then base levels, then the
    /// border, then the rest, so that outlets stay. Status and fields are those of the
    /// nodes. **Cost** O(n log n).
    pub(super) fn quarter(&self) -> Option<Self> {
        let n = self.positions().len();
        if n < 4 * FEWEST {
            return None;
        }
        let [lo, hi] = self.bounds();
        let (area, status) = (self.area(), self.graph().status());
        // Poisson-disk nodes stand sqrt(0.62 a) apart, if each has the area a.
        let least = 2.0 * (0.62 * area / n as f64).sqrt();
        let mut kept = Thinned::new([lo, hi], least);
        let rank = |i: usize| {
            let p = self.positions()[i];
            let sides = (0..2).filter(|&k| p[k] == lo[k] || p[k] == hi[k]).count();
            match (sides, status[i]) {
                (2, _) => 0,
                (_, Status::BaseLevel) => 1,
                (1, _) => 2,
                _ => 3,
            }
        };
        for wanted in 0..4 {
            for i in (0..n).filter(|&i| rank(i) == wanted) {
                kept.add(self.positions()[i], i as u32);
            }
        }
        let mut kept = kept.nodes;
        kept.sort_unstable();
        let sites: Vec<_> = kept.iter().map(|&i| self.positions()[i as usize]).collect();
        let mut coarse = Self::delaunay(&sites, Edges::default()).ok()?;
        // The corners were kept, so that the curve that numbers the nodes is the same.
        debug_assert_eq!(coarse.positions(), sites);
        if coarse.positions() != sites {
            return None;
        }
        let of = |values: &[Status]| kept.iter().map(|&i| values[i as usize]).collect();
        coarse.set_border(of(&self.border()), of(status));
        coarse.change(Layer::Bedrock, |z| {
            z.iter_mut().zip(&kept).for_each(|(z, &i)| *z = self.elevation()[i as usize]);
        });
        coarse.set_layers(self.layers().map(|l| thinned(l, &kept)));
        coarse.fields = pick(&self.fields, &kept);
        Some(coarse)
    }

    /// Takes the elevation of interior nodes from a coarser mesh, linearly.
    pub(super) fn take_from(&mut self, coarse: &Self) {
        let spacing = 0.4 * (coarse.area() / coarse.positions().len() as f64).sqrt();
        let Ok((grid, z)) = elevation_raster(coarse, spacing) else { return };
        let domain = self.domain();
        let positions = self.positions().to_vec();
        self.change(Layer::Bedrock, |fine| {
            set_interior(fine, domain.status(), |i, _| height_field::sample(&grid, &z, positions[i]));
        });
    }

    /// Changes as a coarser mesh did between two states, linearly between its nodes.
    pub(super) fn take_change(&mut self, before: &Self, after: &Self) {
        let spacing = 0.4 * (before.area() / before.positions().len() as f64).sqrt();
        let Ok(raster) = ValuesRaster::over(before, spacing) else { return };
        let positions = self.positions().to_vec();
        let spread = |change: &[f64]| {
            let values = raster.of(before, change);
            parallel::map(positions.len(), |i| or_none(height_field::sample(raster.grid(), &values, positions[i])))
        };
        add_change(self, [before, after], spread);
    }
}

/// A change, or none at holes and beyond the sides.
fn or_none(change: f64) -> f64 {
    if change.is_finite() { change } else { 0.0 }
}

/// Adds what changed between two states of a coarser form, brought to the nodes by `spread`.
fn add_change<T: NodeSurface>(terrain: &mut T, [before, after]: [&T; 2], spread: impl Fn(&[f64]) -> Vec<f64>) {
    let (old, new) = (before.elevation(), after.elevation());
    let raised = spread(&parallel::map(old.len(), |i| or_none(new[i] - old[i])));
    if let Some(after) = after.layers() {
        terrain.make_layered(after.materials());
    }
    let mut layers = terrain.layers().cloned();
    if let (Some(layers), Some(new)) = (&mut layers, after.layers()) {
        let bare = Layers::rock(new.materials(), old.len());
        layers.add_change(before.layers().unwrap_or(&bare), new, &spread);
    }
    let domain = terrain.domain();
    terrain.change(Layer::Bedrock, |z| set_interior(z, domain.status(), |i, z| z + raised[i]));
    // The layers were changed along with the surface, not by it.
    terrain.set_layers(layers);
    for key in names::SUMS {
        let Ok(new) = after.fields().get(key, "") else { continue };
        let old = before.fields().get(key, "").ok();
        let more = spread(&parallel::map(new.len(), |i| or_none(new[i] - old.map_or(0.0, |old| old[i]))));
        terrain.fields_mut().add(key, &more);
    }
}

/// Nodes that keep their distance, found through a lattice of cells that hold one each.
struct Thinned {
    low: [f64; 2],
    least: f64,
    cell: f64,
    shape: Shape,
    cells: Vec<[f64; 2]>,
    nodes: Vec<u32>,
}

impl Thinned {
    fn new([lo, hi]: [[f64; 2]; 2], least: f64) -> Self {
        let cell = least / std::f64::consts::SQRT_2;
        let count = |k: usize| ((hi[k] - lo[k]) / cell) as usize + 1;
        let shape = Shape::new(count(1), count(0));
        Self { low: lo, least, cell, shape, cells: vec![[f64::INFINITY; 2]; shape.len()], nodes: Vec::new() }
    }

    fn add(&mut self, p: [f64; 2], node: u32) {
        let at = |k: usize| ((p[k] - self.low[k]) / self.cell) as usize;
        let (row, col) = (at(1).min(self.shape.rows - 1), at(0).min(self.shape.cols - 1));
        for r in row.saturating_sub(2)..(row + 3).min(self.shape.rows) {
            for c in col.saturating_sub(2)..(col + 3).min(self.shape.cols) {
                let q = self.cells[self.shape.index(r, c)];
                if (p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) < self.least * self.least {
                    return;
                }
            }
        }
        self.cells[self.shape.index(row, col)] = p;
        self.nodes.push(node);
    }
}

impl HeightField {
    /// Every second node of every second row, or the outlet beside it. **Cost** O(n).
    pub(super) fn quarter(&self) -> Option<Self> {
        if let Some(jitter) = self.grid().jitter {
            return self.at_centres().quarter()?.off_centres(jitter.seed);
        }
        let shape = self.grid().shape;
        if shape.len() < 4 * FEWEST || shape.rows < 5 || shape.cols < 5 {
            return None;
        }
        let coarse = Shape::new(shape.rows.div_ceil(2), shape.cols.div_ceil(2));
        let status = self.chosen_status();
        let is_base = |i: usize| status.is_some_and(|s| s[i] == Status::BaseLevel);
        // A chosen outlet represents its four nodes.
        let stands_for = |i: usize| {
            let cell = coarse.cell(i);
            let of = |k: usize| {
                let (row, col) =
                    ((2 * cell.row + k / 2).min(shape.rows - 1), (2 * cell.col + k % 2).min(shape.cols - 1));
                shape.index(row, col)
            };
            (0..4).map(of).find(|&i| is_base(i)).unwrap_or(of(0)) as u32
        };
        let kept: Vec<u32> = (0..coarse.len()).map(stands_for).collect();
        let spacing = self.grid().spacing.map(|s| 2.0 * s);
        let grid = Grid {
            shape: coarse,
            spacing,
            origin: self.grid().origin,
            edges: self.grid().edges,
            georeference: self.grid().georeference.clone(),
            frame: None,
            jitter: None,
        };
        let z = kept.iter().map(|&i| self.elevation()[i as usize]).collect();
        let mut field = Self::new(grid, z).ok()?;
        if let Some(status) = status {
            field.set_status(Some(kept.iter().map(|&i| status[i as usize]).collect()));
        }
        field.set_layers(self.layers().map(|l| thinned(l, &kept)));
        field.fields = pick(&self.fields, &kept);
        Some(field)
    }

    /// Takes the elevation of interior nodes from a coarser raster, bilinearly; nodes beyond it or
    /// beside its nodata keep theirs.
    pub(super) fn take_from(&mut self, coarse: &Self) {
        let domain = self.domain();
        let grid = self.grid().clone();
        let [[west, south], [east, north]] = coarse.bounds();
        let coarse = coarse.at_centres();
        self.change(Layer::Bedrock, |z| {
            set_interior(z, domain.status(), |i, _| {
                let [x, y] = grid.position(i);
                coarse.elevation_at([x.clamp(west, east), y.clamp(south, north)])
            });
        });
    }

    /// Changes as a coarser raster did between two states, by smooth curves through its nodes.
    pub(super) fn take_change(&mut self, before: &Self, after: &Self) {
        let (before, after) = (before.at_centres(), after.at_centres());
        let (fine, coarse) = (self.grid().clone(), before.grid());
        let [[west, south], [east, north]] = before.bounds();
        let spread = |change: &[f64]| {
            parallel::map(fine.len(), |i| {
                let [x, y] = fine.position(i);
                let there = [x.clamp(west, east), y.clamp(south, north)];
                or_none(sample_by(Interpolation::Cubic, coarse, change, there))
            })
        };
        add_change(self, [&before, &after], spread);
    }
}

fn set_interior(elevation: &mut [f64], status: &[Status], new: impl Fn(usize, f64) -> f64 + Sync) {
    parallel::update(elevation, |i, z| {
        if status[i] == Status::Interior {
            let new = new(i, *z);
            *z = if new.is_finite() { new } else { *z };
        }
    });
}

pub(super) fn thinned(layers: &Layers, kept: &[u32]) -> Layers {
    layers.mapped(|values| kept.iter().map(|&i| values[i as usize]).collect())
}

pub(super) fn pick(fields: &Fields, kept: &[u32]) -> Fields {
    let mut picked = Fields::sized(kept.len());
    for (name, values) in fields.iter().filter(|(name, _)| *name != "receiver") {
        // As many as are kept, so that it cannot be refused.
        let _ = picked.insert_values(name, values.picked(kept));
    }
    picked
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algo::sampling::poisson_disk;
    use crate::random::Seed;
    use crate::terrain::Refine;

    #[test]
    fn a_plane_survives_coarsening_and_refining() {
        let plane = |[x, y]: [f64; 2]| 3.0 + 0.5 * x - 0.25 * y;
        let sites = poisson_disk([1000.0, 800.0], 8.0, Seed(1)).unwrap();
        let mut mesh = Mesh::delaunay(&sites, Edges::default()).unwrap();
        let positions = mesh.positions().to_vec();
        mesh.change(Layer::Bedrock, |z| z.iter_mut().zip(&positions).for_each(|(z, &p)| *z = plane(p)));
        let coarse = mesh.coarser().unwrap();
        let ratio = mesh.positions().len() as f64 / coarse.positions().len() as f64;
        assert!((3.0..5.0).contains(&ratio), "{ratio}");
        assert!((coarse.area() / mesh.area() - 1.0).abs() < 1e-9);
        let before = mesh.elevation().to_vec();
        mesh.change(Layer::Bedrock, |z| z.iter_mut().for_each(|z| *z += 7.0));
        mesh.take_shape_of(&coarse);
        for (i, z) in mesh.elevation().iter().enumerate() {
            let raised = if mesh.graph().status()[i] == Status::Interior { 0.0 } else { 7.0 };
            assert!((z - before[i] - raised).abs() < 1e-6, "node {i}");
        }
        let grid = Grid::new(Shape::new(40, 41), [10.0, 10.0]).unwrap();
        let z: Vec<f64> = (0..grid.len()).map(|i| plane(grid.position(i))).collect();
        let mut field = HeightField::new(grid, z.clone()).unwrap();
        let coarse = field.coarser().unwrap();
        assert_eq!(coarse.grid().shape, Shape::new(20, 21));
        field.take_shape_of(&coarse);
        assert!(field.elevation().iter().zip(&z).filter(|(a, b)| (*a - *b).abs() > 1e-9).count() <= 41);
    }
}
