//! Ground as rows of numbers for the page.

use std::borrow::Cow;
use std::sync::Mutex;

use landform::core::algo::flow::{Flow, node_areas};
use landform::core::field::names::unit_of;
use landform::core::terrain::{AnyTerrain, Body, HeightField, Mesh, NodeSurface, Surface, ValuesRaster, Visit};
use landform::core::verb::Context;
use landform::recipe::stages;
use landform::{Error, Result};

use crate::hub::lock;
use crate::protocol::Layer;

/// Rows and columns of a picture's layers.
pub(crate) struct Rows {
    pub(crate) rows: usize,
    pub(crate) cols: usize,
    pub(crate) cell_size: [f64; 2],
    /// Place of the south-west node, m.
    pub(crate) origin: [f64; 2],
    pub(crate) layers: Vec<Layer>,
}

/// Names of the fields that can be asked for, with their units.
pub(crate) fn names(ground: &AnyTerrain) -> Vec<(String, &'static str)> {
    let unit = |name: &str| unit_of(name).unwrap_or(if name.ends_with("_depth") { "m" } else { "1" });
    let mut names = ground.names();
    for found in ["elevation", "drainage_area", "lake_depth", "slope"] {
        if names.iter().all(|name| name != found) {
            names.push(found.into());
        }
    }
    names.into_iter().map(|name| (name.clone(), unit(&name))).collect()
}

/// Rasters over meshes that were drawn before.
#[derive(Default)]
pub(crate) struct Rasters(Mutex<Option<Known>>);

/// Places of a mesh's nodes, the size of cells (m), the cells.
type Known = (Vec<[f64; 2]>, f64, ValuesRaster);

impl Rasters {
    /// Elevation and the fields that there are of those wanted, on at most `most` rows and columns.
    ///
    /// # Errors
    /// If the ground has no surface.
    pub(crate) fn layers(&self, ground: &AnyTerrain, wanted: &[String], most: usize) -> Result<Rows> {
        let surface = surface_of(ground)?;
        let values = surface.visit(Fields(wanted));
        if let Ok(mesh) = surface.get::<Mesh>("studio") {
            return self.of_mesh(mesh, values, most);
        }
        let field = surface.get::<HeightField>("studio")?;
        Ok(thinned(field, values, most))
    }

    fn of_mesh(&self, mesh: &Mesh, values: Vec<(String, Vec<f64>)>, most: usize) -> Result<Rows> {
        let area = mesh.area();
        let cell = (0.5 * (area / mesh.positions().len().max(1) as f64).sqrt()).max(area.sqrt() / most as f64);
        let mut known = lock(&self.0);
        let fits = known.as_ref().is_some_and(|(at, size, _)| *size == cell && at == mesh.positions());
        if !fits {
            *known = Some((mesh.positions().to_vec(), cell, ValuesRaster::over(mesh, cell)?));
        }
        let Some((.., raster)) = &*known else { return Err(nothing()) };
        let grid = raster.grid();
        let field = HeightField::new(grid.clone(), vec![0.0; grid.len()])?;
        // What is found on the raster has no values yet.
        let of = |(name, values): (String, Vec<f64>)| {
            let values = if values.is_empty() { values } else { raster.of(mesh, &values) };
            (name, values)
        };
        Ok(thinned(&field, values.into_iter().map(of).collect(), most))
    }
}

fn nothing() -> Error {
    Error::Empty { what: "the ground".into() }
}

/// The ground, or the uppermost surface of voxels.
fn surface_of(ground: &AnyTerrain) -> Result<Cow<'_, AnyTerrain>> {
    if ground.kind().is_surface() {
        return Ok(Cow::Borrowed(ground));
    }
    let stage = stages().find(|stage| stage.name == "uppermost_surface").ok_or_else(nothing)?;
    let read = stage.read(&(stage.form.defaults)()).map_err(|_| nothing())?;
    read.apply(Some(ground), &Context::default()).map(Cow::Owned)
}

/// Elevation and fields, one value a node.
struct Fields<'a>(&'a [String]);

impl Visit for Fields<'_> {
    type Out = Vec<(String, Vec<f64>)>;

    fn surface<T: Surface>(self, terrain: &T) -> Self::Out {
        let mut all = vec![("elevation".to_string(), terrain.elevation().to_vec())];
        let mut routed = None;
        for name in self.0 {
            let known = terrain.real(name, "studio").ok();
            let values = known.or_else(|| match name.as_str() {
                "drainage_area" => Some(routed.get_or_insert_with(|| route(terrain)).1.clone()),
                "lake_depth" | "water_depth" => {
                    let level = routed.get_or_insert_with(|| route(terrain)).0.water_level(terrain.elevation());
                    Some(level.iter().zip(terrain.elevation()).map(|(level, z)| level - z).collect())
                }
                _ => None,
            });
            all.extend(values.map(|values| (name.clone(), values)));
        }
        if self.0.iter().any(|name| name == "slope") && all.iter().all(|(name, _)| name != "slope") {
            // Found on the raster, from the elevations that are shown.
            all.push(("slope".into(), Vec::new()));
        }
        all
    }

    fn body<T: Body>(self, _: &T) -> Self::Out {
        Vec::new()
    }
}

fn route<T: NodeSurface>(terrain: &T) -> (Flow, Vec<f64>) {
    let domain = terrain.domain();
    let (mut flow, mut area) = (Flow::new(), node_areas(&*domain));
    flow.route(&*domain, terrain.elevation(), &mut area);
    (flow, area)
}

/// Every so many-th row and column, so that there are not too many.
fn thinned(field: &HeightField, values: Vec<(String, Vec<f64>)>, most: usize) -> Rows {
    let grid = field.grid();
    let (rows, cols) = (grid.shape.rows, grid.shape.cols);
    let step = rows.max(cols).div_ceil(most.max(1)).max(1);
    let thin = |values: &[f64]| -> Vec<f32> {
        let row = |row: usize| (0..cols).step_by(step).map(move |col| row * cols + col);
        (0..rows).step_by(step).flat_map(row).map(|i| values[i] as f32).collect()
    };
    let spacing = grid.spacing.map(|s| s * step as f64);
    let (shown_rows, shown_cols) = (rows.div_ceil(step), cols.div_ceil(step));
    let mut layers: Vec<Layer> = Vec::new();
    for (name, values) in values {
        let shown = if values.is_empty() && name == "slope" && !layers.is_empty() {
            slope(&layers[0].values, shown_rows, shown_cols, spacing)
        } else {
            thin(&values)
        };
        layers.push(Layer::new(&name, shown));
    }
    let [west, north] = grid.position(0);
    let south = north - (shown_rows.max(1) - 1) as f64 * spacing[1];
    Rows { rows: shown_rows, cols: shown_cols, cell_size: spacing, origin: [west, south], layers }
}

/// Rise over run between the neighbours on both sides.
fn slope(z: &[f32], rows: usize, cols: usize, [dx, dy]: [f64; 2]) -> Vec<f32> {
    let at = |row: usize, col: usize| f64::from(z[row * cols + col]);
    let one = |row: usize, col: usize| {
        let (w, e) = (col.saturating_sub(1), (col + 1).min(cols - 1));
        let (n, s) = (row.saturating_sub(1), (row + 1).min(rows - 1));
        let x = (at(row, e) - at(row, w)) / ((e - w).max(1) as f64 * dx);
        let y = (at(s, col) - at(n, col)) / ((s - n).max(1) as f64 * dy);
        (x * x + y * y).sqrt() as f32
    };
    (0..rows).flat_map(|row| (0..cols).map(move |col| (row, col))).map(|(row, col)| one(row, col)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use landform::core::grid::{Edges, Grid, Shape};
    use landform::core::terrain::{Layer as Ground, Representation};

    fn wanted(names: &[&str]) -> Vec<String> {
        names.iter().map(|n| (*n).to_string()).collect()
    }

    #[test]
    fn a_raster_is_thinned_and_has_what_is_asked_for() {
        let grid = Grid::new(Shape::new(9, 17), [10.0, 10.0]).unwrap();
        let ramp = (0..9 * 17).map(|i| 2.0 * (i % 17) as f64).collect();
        let ground = HeightField::new(grid, ramp).unwrap().wrap();
        let rasters = Rasters::default();
        let rows = rasters.layers(&ground, &wanted(&["slope", "drainage_area", "lake_depth", "no_such"]), 9).unwrap();
        assert_eq!((rows.rows, rows.cols, rows.cell_size), (5, 9, [20.0, 20.0]));
        let names: Vec<_> = rows.layers.iter().map(|l| l.name.as_str()).collect();
        assert_eq!(names, ["elevation", "drainage_area", "lake_depth", "slope"]);
        assert!(rows.layers[3].values.iter().all(|&s| (s - 0.2).abs() < 1e-6));
        assert_eq!((rows.layers[0].min, rows.layers[0].max), (0.0, 32.0));
    }

    #[test]
    fn a_mesh_is_sampled_and_one_node_is_no_trouble() {
        let sites = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0], [5.0, 5.0]];
        let mut mesh = Mesh::delaunay(&sites, Edges::default()).unwrap();
        let rise: Vec<f64> = mesh.positions().iter().map(|p| p[0]).collect();
        mesh.change(Ground::Bedrock, |z| z.copy_from_slice(&rise));
        let rasters = Rasters::default();
        for _ in 0..2 {
            let rows = rasters.layers(&mesh.clone().wrap(), &wanted(&["slope"]), 64).unwrap();
            assert!((rows.layers[0].max - 10.0).abs() < 1e-6 && rows.rows > 2);
            let inner = rows.cols + 1;
            assert!((rows.layers[1].values[inner] - 1.0).abs() < 1e-5);
        }
        let one = HeightField::new(Grid::new(Shape::new(1, 1), [1.0; 2]).unwrap(), vec![3.0]).unwrap().wrap();
        assert_eq!(rasters.layers(&one, &wanted(&["slope"]), 64).unwrap().layers[1].values, [0.0]);
    }
}
