//! A raster of elevations.

use std::sync::{Arc, OnceLock};

use serde::{Deserialize, Serialize};

use super::{Kind, Layers, NodeSurface, Refine, Terrain};
use crate::feature::Features;
use crate::field::Fields;
use crate::grid::{Degrees, Domain, Grid, RasterDomain, Shape, Status};
use crate::{Error, Result, parallel};

/// One elevation per node of a regular grid. Nodata is NaN in the elevation, and nowhere else.
///
/// ```
/// use landform_core::grid::{Grid, Shape};
/// use landform_core::terrain::HeightField;
///
/// let grid = Grid::new(Shape::new(2, 2), [10.0, 10.0])?;
/// let ground = HeightField::new(grid, vec![0.0, 10.0, 0.0, 10.0])?;
/// assert_eq!(ground.elevation_at([5.0, 5.0]), 5.0);
/// assert!(ground.elevation_at([11.0, 5.0]).is_nan());
/// # Ok::<(), landform_core::Error>(())
/// ```
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct HeightField {
    grid: Grid,
    elevation: Vec<f64>,
    /// Which nodes have data; empty if all have.
    valid: Arc<Vec<bool>>,
    /// Status of every node, where it is not what the edges say.
    status: Option<Arc<Vec<Status>>>,
    layers: Option<Box<Layers>>,
    features: Features,
    /// Optional fields, in the grid's order.
    pub fields: Fields,
    /// The graph for the status, made at its first use.
    #[serde(skip)]
    domain: OnceLock<Arc<RasterDomain>>,
}

impl PartialEq for HeightField {
    fn eq(&self, other: &Self) -> bool {
        let of = |f: &Self| (f.grid.clone(), f.valid.clone(), f.status.clone());
        of(self) == of(other)
            && self.elevation == other.elevation
            && self.layers == other.layers
            && self.features == other.features
            && self.fields == other.fields
    }
}

impl HeightField {
    /// From a grid and its elevations, row-major from the north-west, m; NaN is nodata.
    ///
    /// # Errors
    /// [`Error::Shape`] if the lengths differ; [`Error::NonFinite`] if an elevation is infinite;
    /// [`Error::Empty`] if all are nodata.
    pub fn new(grid: Grid, elevation: Vec<f64>) -> Result<Self> {
        if elevation.len() != grid.len() {
            return Err(Error::Shape {
                what: "elevation".into(),
                found: format!("{} values", elevation.len()),
                expected: format!("{} ({})", grid.len(), grid.shape),
            });
        }
        if let Some(node) = parallel::find_first(elevation.len(), |i| elevation[i].is_infinite()) {
            return Err(Error::NonFinite { field: "elevation".into(), node, after: "reading".into() });
        }
        if parallel::find_first(elevation.len(), |i| elevation[i].is_finite()).is_none() {
            return Err(Error::Empty { what: "the elevation".into() });
        }
        let holes = parallel::find_first(elevation.len(), |i| elevation[i].is_nan()).is_some();
        let valid = if holes { parallel::map(elevation.len(), |i| !elevation[i].is_nan()) } else { Vec::new() };
        let fields = Fields::sized(elevation.len());
        let domain = OnceLock::new();
        Ok(Self {
            grid,
            elevation,
            valid: Arc::new(valid),
            status: None,
            layers: None,
            features: Features::default(),
            fields,
            domain,
        })
    }

    /// The grid.
    pub fn grid(&self) -> &Grid {
        &self.grid
    }

    /// Puts the raster elsewhere, or changes its spacing or what its sides do.
    ///
    /// # Errors
    /// [`Error::Shape`] for a grid of another shape.
    pub fn set_grid(&mut self, grid: Grid) -> Result<()> {
        if grid.shape != self.grid.shape {
            let (found, expected) = (grid.shape.to_string(), self.grid.shape.to_string());
            return Err(Error::Shape { what: "the grid".into(), found, expected });
        }
        self.grid = grid;
        self.domain = OnceLock::new();
        Ok(())
    }

    /// The status of every node where it is not what the edges say.
    pub fn chosen_status(&self) -> Option<&[Status]> {
        self.status.as_deref().map(Vec::as_slice)
    }

    /// Whether a node has data.
    pub fn is_valid(&self, node: usize) -> bool {
        self.valid.get(node).copied().unwrap_or(true)
    }

    /// Number of nodes without data.
    pub fn nodata_count(&self) -> usize {
        self.valid.iter().filter(|v| !**v).count()
    }

    /// Bilinear elevation (m) at a position, or NaN outside or beside nodata.
    pub fn elevation_at(&self, position: [f64; 2]) -> f64 {
        sample(&self.grid, &self.elevation, position)
    }
}

impl HeightField {
    /// Bilinear elevation (m) at a position, and its slope east and north; none outside and beside
    /// nodata.
    pub(super) fn height_and_slope(&self, position: [f64; 2]) -> Option<(f64, [f64; 2])> {
        let Shape { rows, cols } = self.grid.shape;
        let ([u, v], [dx, dy]) = (self.grid.col_row(position), self.grid.spacing);
        let edge = 1e-9;
        if !(u >= -edge && v >= -edge && u <= (cols - 1) as f64 + edge && v <= (rows - 1) as f64 + edge) {
            return None;
        }
        let (u, v) = (u.clamp(0.0, (cols - 1) as f64), v.clamp(0.0, (rows - 1) as f64));
        let (col, row) = ((u as usize).min(cols.saturating_sub(2)), (v as usize).min(rows.saturating_sub(2)));
        let (east, south) = ((col + 1).min(cols - 1), (row + 1).min(rows - 1));
        let z = |row: usize, col: usize| self.elevation[row * cols + col];
        let (fu, fv) = (u - col as f64, v - row as f64);
        let [a, b, c, d] = [z(row, col), z(row, east), z(south, col), z(south, east)];
        let whole = (a * (1.0 - fu) + b * fu) * (1.0 - fv) + (c * (1.0 - fu) + d * fu) * fv;
        // Beside nodata only what has a weight counts.
        let height = if whole.is_nan() { self.elevation_at(position) } else { whole };
        if height.is_nan() {
            return None;
        }
        let slope = [((b - a) * (1.0 - fv) + (d - c) * fv) / dx, ((a - c) * (1.0 - fu) + (b - d) * fu) / dy];
        // Beside nodata the surface may end at the position itself.
        Some((height, slope.map(|s| if s.is_nan() { 0.0 } else { s })))
    }
}

/// Bilinear value of a raster at a position, or NaN outside or beside nodata. A rounding error
/// outside still counts as in.
pub(super) fn sample(grid: &Grid, values: &[f64], position: [f64; 2]) -> f64 {
    let [u, v] = grid.col_row(position);
    let (cols, rows) = (grid.shape.cols, grid.shape.rows);
    let edge = 1e-9;
    if !(u >= -edge && v >= -edge && u <= (cols - 1) as f64 + edge && v <= (rows - 1) as f64 + edge) {
        return f64::NAN;
    }
    let (u, v) = (u.clamp(0.0, (cols - 1) as f64), v.clamp(0.0, (rows - 1) as f64));
    let (c, r) = ((u as usize).min(cols.saturating_sub(2)), (v as usize).min(rows.saturating_sub(2)));
    let (fu, fv) = (u - c as f64, v - r as f64);
    let at = |dr: usize, dc: usize, w: f64| {
        if w == 0.0 { 0.0 } else { w * values[grid.shape.index((r + dr).min(rows - 1), (c + dc).min(cols - 1))] }
    };
    at(0, 0, (1.0 - fu) * (1.0 - fv)) + at(0, 1, fu * (1.0 - fv)) + at(1, 0, (1.0 - fu) * fv) + at(1, 1, fu * fv)
}

impl Terrain for HeightField {
    const KIND: Kind = Kind::HeightField;
    const BYTES_A_NODE: u64 = 150;

    fn nodes(&self) -> usize {
        self.elevation.len()
    }

    fn volume(&self) -> f64 {
        let area = self.grid.cell_area();
        parallel::sum(self.elevation.len(), |i| if self.elevation[i].is_nan() { 0.0 } else { self.elevation[i] * area })
    }

    fn check_finite(&self) -> Result<(), (&'static str, usize)> {
        let wrong = |i: usize| !self.elevation[i].is_finite() && self.is_valid(i);
        let in_layers = || self.layers.as_ref().and_then(|l| l.find_non_finite());
        match parallel::find_first(self.elevation.len(), wrong) {
            Some(i) => Err(("elevation", i)),
            None => in_layers().map_or(Ok(()), |i| Err(("depth of a layer", i))),
        }
    }
}

impl Refine for HeightField {
    fn coarser(&self) -> Option<Self> {
        self.quarter()
    }

    fn take_shape_of(&mut self, coarse: &Self) {
        self.take_from(coarse);
    }

    fn take_change_of(&mut self, before: &Self, after: &Self) {
        self.take_change(before, after);
    }
}

impl NodeSurface for HeightField {
    type Domain = RasterDomain;

    fn domain(&self) -> Arc<RasterDomain> {
        let make = || {
            let mut domain = RasterDomain::new(&self.grid, &self.valid);
            if let Some(status) = &self.status {
                domain.set_status(status.to_vec());
            }
            Arc::new(domain)
        };
        self.domain.get_or_init(make).clone()
    }

    fn border(&self) -> Vec<Status> {
        RasterDomain::new(&self.grid, &self.valid).status().to_vec()
    }

    fn set_status(&mut self, status: Option<Vec<Status>>) {
        self.status = status.map(Arc::new);
        self.domain = OnceLock::new();
    }

    fn elevation(&self) -> &[f64] {
        &self.elevation
    }

    fn layers(&self) -> Option<&Layers> {
        self.layers.as_deref()
    }

    fn parts_mut(&mut self) -> (&mut [f64], &mut Option<Box<Layers>>) {
        (&mut self.elevation, &mut self.layers)
    }

    fn position(&self, node: usize) -> [f64; 2] {
        self.grid.position(node)
    }

    fn bounds(&self) -> [[f64; 2]; 2] {
        self.grid.bounds()
    }

    fn whole_bounds(&self) -> [[f64; 2]; 2] {
        self.grid.whole().bounds()
    }

    fn fields(&self) -> &Fields {
        &self.fields
    }

    fn fields_mut(&mut self) -> &mut Fields {
        &mut self.fields
    }

    fn features(&self) -> &Features {
        &self.features
    }

    fn features_mut(&mut self) -> &mut Features {
        &mut self.features
    }

    fn nodes_near(&self, at: [f64; 2], radius: f64) -> Vec<(usize, f64)> {
        let Shape { rows, cols } = self.grid.shape;
        let ([u, v], [dx, dy]) = (self.grid.col_row(at), self.grid.spacing);
        let within = |at: f64, reach: f64, n: usize| {
            let low = (at - reach).ceil().clamp(0.0, n as f64) as usize;
            low..((at + reach).floor() + 1.0).clamp(low as f64, n as f64) as usize
        };
        let (across, down) = (within(u, radius / dx, cols), within(v, radius / dy, rows));
        let mut near = Vec::with_capacity(across.len() * down.len());
        for row in down {
            let south = (row as f64 - v) * dy;
            for col in across.clone() {
                let (east, node) = ((col as f64 - u) * dx, row * cols + col);
                let square = east * east + south * south;
                if square < radius * radius && !self.elevation[node].is_nan() {
                    near.push((node, square));
                }
            }
        }
        if near.is_empty()
            && let Some(node) = self.grid.node_at(at).filter(|&i| !self.elevation[i].is_nan())
        {
            near.push((node, 0.0));
        }
        near
    }

    fn epsg(&self) -> Option<u16> {
        self.grid.georeference.epsg
    }

    fn degrees(&self) -> Option<Degrees> {
        self.grid.georeference.degrees
    }
}
