//! From one representation to another: `target_from_source`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{HeightField, Mesh, NodeSurface, height_field, sea_level};
use crate::field::{Fields, Values};
use crate::grid::{Domain, Edge, Edges, Grid, Neighbours, Status};
use crate::{Result, parallel};

/// A raster of a mesh: linear on each triangle for real fields, the nearest corner's value for
/// identifiers.
///
/// Nodes outside of the hull become nodata. **Cost** O(nodes + cells), after Bell's O(cells ×
/// kernel).
///
/// `receiver`, which holds indices of nodes, is left behind. Outlets that were chosen come along.
///
/// ```
/// use landform_core::grid::Edges;
/// use landform_core::terrain::{Layer, Mesh, NodeSurface, height_field_from_mesh};
///
/// let sites = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0], [5.0, 5.0]];
/// let mut mesh = Mesh::delaunay(&sites, Edges::default())?;
/// let rise: Vec<f64> = mesh.positions().iter().map(|p| 0.5 * p[0]).collect();
/// mesh.change(Layer::Bedrock, |z| z.copy_from_slice(&rise));
/// let raster = height_field_from_mesh(&mesh, 5.0)?;
/// assert!((raster.elevation_at([2.5, 7.5]) - 1.25).abs() < 1e-9);
/// # Ok::<(), landform_core::Error>(())
/// ```
///
/// # Errors
/// Where [`Grid::covering`] fails.
pub fn height_field_from_mesh(mesh: &Mesh, cell_size: f64) -> Result<HeightField> {
    let mut grid = grid_over(mesh, cell_size)?;
    grid.edges = open_sides(mesh);
    let triangle = locate(mesh, &grid);
    let linear = |values: &[f64]| linear(mesh, &grid, &triangle, values);
    let corner = parallel::map(grid.len(), |i| match triangle[i] {
        u32::MAX => u32::MAX,
        t => {
            let corners = mesh.triangles()[t as usize];
            let weights = barycentric(mesh, corners, grid.position(i));
            let k = (0..3).max_by(|&a, &b| weights[a].total_cmp(&weights[b])).unwrap_or(0);
            corners[k]
        }
    });
    let elevation = linear(mesh.elevation());
    let mut fields = Fields::sized(grid.len());
    for (name, values) in mesh.fields.iter().filter(|(name, _)| *name != "receiver") {
        let values = match values {
            Values::F64(v) => Values::F64(linear(v)),
            Values::F32(_) => Values::F64(linear(&values.to_f64())),
            Values::U32(v) => Values::U32(at_corners(v, &corner)),
            Values::U8(v) => Values::U8(at_corners(v, &corner)),
        };
        fields.insert_values(name, values)?;
    }
    let mut field = HeightField::new(grid.clone(), elevation)?;
    field.set_layers(mesh.layers().map(|l| l.mapped(linear)));
    *field.features_mut() = mesh.features().clone();
    field.fields = fields;
    if let Some(status) = mesh.chosen_status() {
        let domain = field.domain();
        let masked = |i: usize| domain.status()[i] == Status::Masked;
        let under = |z: f64, level: f64| if z <= level { Status::BaseLevel } else { Status::Interior };
        let chosen = match sea_level(status, mesh.elevation()) {
            Some(level) => parallel::map(domain.len(), |i| under(field.elevation()[i], level)),
            None => at_corners(status, &corner),
        };
        let status = chosen.iter().enumerate().map(|(i, &s)| if masked(i) { Status::Masked } else { s }).collect();
        field.set_status(Some(status));
    }
    Ok(field)
}

/// Sides of a mesh along which water leaves. One without nodes of its own, as that of a round mesh,
/// is open.
fn open_sides(mesh: &Mesh) -> Edges {
    let [[w, s], [e, n]] = mesh.bounds();
    let near = 1e-9 * (e - w).max(n - s);
    let domain = mesh.domain();
    let side = |away: &dyn Fn([f64; 2]) -> f64, beside: &dyn Fn([f64; 2]) -> f64| {
        // Corners belong to two sides.
        let on = |at: [f64; 2]| away(at).abs() <= near && beside(at) > near;
        let mut nodes = (0..domain.len()).filter(|&i| on(mesh.positions()[i])).peekable();
        let is_empty = nodes.peek().is_none();
        if is_empty || nodes.any(|i| domain.status()[i] == Status::BaseLevel) { Edge::Open } else { Edge::Closed }
    };
    let along_x = |[x, _]: [f64; 2]| (x - w).min(e - x);
    let along_y = |[_, y]: [f64; 2]| (y - s).min(n - y);
    Edges {
        north: side(&|[_, y]| n - y, &along_x),
        south: side(&|[_, y]| y - s, &along_x),
        east: side(&|[x, _]| e - x, &along_y),
        west: side(&|[x, _]| x - w, &along_y),
    }
}

/// The values of the corners nearest to places; the plainest value where there is no triangle.
fn at_corners<V: Copy + Default>(values: &[V], corner: &[u32]) -> Vec<V> {
    corner.iter().map(|&c| values.get(c as usize).copied().unwrap_or_default()).collect()
}

/// Elevation of a mesh alone on a raster over its bounds, linear on each triangle.
///
/// # Errors
/// Where [`Grid::covering`] fails.
pub(super) fn elevation_raster(mesh: &Mesh, cell_size: f64) -> Result<(Grid, Vec<f64>)> {
    let cells = ValuesRaster::over(mesh, cell_size)?;
    let z = cells.of(mesh, mesh.elevation());
    Ok((cells.grid, z))
}

/// Cells over a mesh, and the triangle under each: for several values of the same nodes.
///
/// ```
/// use landform_core::grid::Edges;
/// use landform_core::terrain::{Mesh, ValuesRaster};
///
/// let sites = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0], [5.0, 5.0]];
/// let mesh = Mesh::delaunay(&sites, Edges::default())?;
/// let cells = ValuesRaster::over(&mesh, 5.0)?;
/// let east: Vec<f64> = mesh.positions().iter().map(|p| p[0]).collect();
/// assert_eq!(cells.of(&mesh, &east)[..3], [0.0, 5.0, 10.0]);
/// # Ok::<(), landform_core::Error>(())
/// ```
pub struct ValuesRaster {
    grid: Grid,
    triangle: Vec<u32>,
}

impl ValuesRaster {
    /// Cells of a size (m) over a mesh.
    ///
    /// ```
    /// # use landform_core::grid::Edges;
    /// # use landform_core::terrain::{Mesh, NodeSurface, ValuesRaster};
    /// # let sites = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0], [5.0, 5.0]];
    /// # let mesh = Mesh::delaunay(&sites, Edges::default())?;
    /// assert!(ValuesRaster::over(&mesh, 0.0).is_err());
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    ///
    /// # Errors
    /// Where [`Grid::covering`] fails.
    pub fn over(mesh: &Mesh, cell_size: f64) -> Result<Self> {
        let grid = grid_over(mesh, cell_size)?;
        let triangle = locate(mesh, &grid);
        Ok(Self { grid, triangle })
    }

    /// The cells.
    ///
    /// ```
    /// # use landform_core::grid::Edges;
    /// # use landform_core::terrain::{Mesh, NodeSurface, ValuesRaster};
    /// # let sites = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0], [5.0, 5.0]];
    /// # let mesh = Mesh::delaunay(&sites, Edges::default())?;
    /// assert_eq!(ValuesRaster::over(&mesh, 5.0)?.grid().len(), 9);
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    pub fn grid(&self) -> &Grid {
        &self.grid
    }

    /// Values of the cells, linear between those of the nodes; NaN outside.
    ///
    /// ```
    /// # use landform_core::grid::Edges;
    /// # use landform_core::terrain::{Mesh, NodeSurface, ValuesRaster};
    /// # let sites = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0], [5.0, 5.0]];
    /// # let mesh = Mesh::delaunay(&sites, Edges::default())?;
    /// let flat = ValuesRaster::over(&mesh, 5.0)?.of(&mesh, mesh.elevation());
    /// assert!(flat.iter().all(|&z| z == 0.0));
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    pub fn of(&self, mesh: &Mesh, values: &[f64]) -> Vec<f64> {
        linear(mesh, &self.grid, &self.triangle, values)
    }
}

fn grid_over(mesh: &Mesh, cell_size: f64) -> Result<Grid> {
    let [lo, hi] = mesh.bounds();
    let mut grid = Grid::covering([hi[0] - lo[0], hi[1] - lo[1]], cell_size)?;
    grid.origin = [lo[0], hi[1]];
    Ok(grid)
}

fn linear(mesh: &Mesh, grid: &Grid, triangle: &[u32], values: &[f64]) -> Vec<f64> {
    parallel::map(grid.len(), |i| match triangle[i] {
        u32::MAX => f64::NAN,
        t => {
            let corners = mesh.triangles()[t as usize];
            let weights = barycentric(mesh, corners, grid.position(i));
            (0..3).map(|k| weights[k] * values[corners[k] as usize]).sum()
        }
    })
}

pub(super) fn barycentric(mesh: &Mesh, corners: [u32; 3], p: [f64; 2]) -> [f64; 3] {
    let [a, b, c] = corners.map(|i| mesh.positions()[i as usize]);
    let cross = |o: [f64; 2], u: [f64; 2], v: [f64; 2]| (u[0] - o[0]) * (v[1] - o[1]) - (u[1] - o[1]) * (v[0] - o[0]);
    let total = cross(a, b, c);
    let w = [(cross(p, b, c) / total).clamp(0.0, 1.0), (cross(p, c, a) / total).clamp(0.0, 1.0)];
    [w[0], w[1], (1.0 - w[0] - w[1]).max(0.0)]
}

/// The triangle over each node of the grid (the first in order where several touch), or `u32::MAX`.
pub(super) fn locate(mesh: &Mesh, grid: &Grid) -> Vec<u32> {
    let mut owner = vec![u32::MAX; grid.len()];
    let (cols, rows) = (grid.shape.cols as f64, grid.shape.rows as f64);
    for (t, corners) in mesh.triangles().iter().enumerate() {
        let points = corners.map(|i| grid.col_row(mesh.positions()[i as usize]));
        let low = |k: usize| points.iter().map(|p| p[k]).fold(f64::INFINITY, f64::min);
        let high = |k: usize| points.iter().map(|p| p[k]).fold(f64::NEG_INFINITY, f64::max);
        let (r0, r1) = ((low(1) - 1e-9).ceil().max(0.0), (high(1) + 1e-9).floor().min(rows - 1.0));
        let (c0, c1) = ((low(0) - 1e-9).ceil().max(0.0), (high(0) + 1e-9).floor().min(cols - 1.0));
        if r0 > r1 || c0 > c1 {
            continue;
        }
        for row in r0 as usize..=r1 as usize {
            for col in c0 as usize..=c1 as usize {
                let i = grid.shape.index(row, col);
                if owner[i] == u32::MAX && inside(points, [col as f64, row as f64]) {
                    owner[i] = t as u32;
                }
            }
        }
    }
    owner
}

fn inside(t: [[f64; 2]; 3], p: [f64; 2]) -> bool {
    // Columns grow east and rows south, so a triangle that is counter-clockwise on the ground is
    // clockwise here.
    let side = |a: [f64; 2], b: [f64; 2]| (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) <= 1e-9;
    side(t[0], t[1]) && side(t[1], t[2]) && side(t[2], t[0])
}

/// Interpolation between nodes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Interpolation {
    /// Straight lines: no value beyond the nodes'.
    #[default]
    Linear,
    /// Smooth curves through the nodes (Catmull and Rom 1974): no creases, but a little beyond the
    /// nodes at sharp edges.
    Cubic,
}

/// A raster on another grid: interpolated where the new cells are not larger, else the mean over
/// the new cell. Nodata spreads to cells that lack data for half of their weight.
///
/// ```
/// use landform_core::grid::{Grid, Shape};
/// use landform_core::terrain::{HeightField, Interpolation, resample};
///
/// let coarse = Grid::new(Shape::new(3, 3), [10.0, 10.0])?;
/// let plane = HeightField::new(coarse, [0.0, 10.0, 20.0].repeat(3))?;
/// let fine = resample(&plane, &plane.grid().with_cell_size(5.0)?, Interpolation::Linear)?;
/// assert_eq!(fine.grid().shape, Shape::new(5, 5));
/// assert!((fine.elevation_at([15.0, 5.0]) - 15.0).abs() < 1e-9);
/// # Ok::<(), landform_core::Error>(())
/// ```
///
/// # Errors
/// Where [`HeightField::new`] fails.
pub fn resample(source: &HeightField, grid: &Grid, interpolation: Interpolation) -> Result<HeightField> {
    let ratio = |k: usize| (grid.spacing[k] / source.grid().spacing[k]).max(1.0);
    let (nx, ny) = (ratio(0).round().min(64.0) as usize, ratio(1).round().min(64.0) as usize);
    let value = |values: &[f64], i: usize| {
        let [x, y] = grid.position(i);
        let (mut sum, mut count) = (0.0, 0usize);
        for a in 0..ny {
            for b in 0..nx {
                let dx = ((b as f64 + 0.5) / nx as f64 - 0.5) * grid.spacing[0];
                let dy = ((a as f64 + 0.5) / ny as f64 - 0.5) * grid.spacing[1];
                let v = sample_within(interpolation, source.grid(), values, [x, y], [x + dx, y - dy]);
                if !v.is_nan() {
                    sum += v;
                    count += 1;
                }
            }
        }
        if count * 2 >= (nx * ny).max(1) || (count > 0 && on_rim(grid, i) && count * 4 >= nx * ny) {
            sum / count as f64
        } else {
            f64::NAN
        }
    };
    let elevation = parallel::map(grid.len(), |i| value(source.elevation(), i));
    let mut field = HeightField::new(grid.clone(), elevation)?;
    let on_grid = |values: &[f64]| parallel::map(grid.len(), |i| value(values, i));
    field.set_layers(source.layers().map(|l| l.mapped(on_grid)));
    *field.features_mut() = source.features().clone();
    for (name, values) in source.fields.iter() {
        if let Values::F64(v) = values {
            field.fields.insert_values(name, Values::F64(on_grid(v)))?;
        }
    }
    if let Some(status) = source.chosen_status() {
        let outlets = outlets_on(source.grid(), status, &field);
        field.set_status(Some(outlets));
    }
    Ok(field)
}

/// Outlets that were chosen, on another raster: nodes next to an old outlet, and those whose
/// nearest old node is one.
fn outlets_on(old: &Grid, status: &[Status], field: &HeightField) -> Vec<Status> {
    let (grid, z) = (field.grid(), field.elevation());
    let held = |i: usize| old.node_at(grid.position(i)).is_some_and(|k| status[k] == Status::BaseLevel);
    let mut new = parallel::map(grid.len(), |i| match (z[i].is_nan(), held(i)) {
        (true, _) => Status::Masked,
        (false, true) => Status::BaseLevel,
        (false, false) => Status::Interior,
    });
    for k in (0..status.len()).filter(|&k| status[k] == Status::BaseLevel) {
        if let Some(i) = grid.node_at(old.position(k)).filter(|&i| new[i] == Status::Interior) {
            new[i] = Status::BaseLevel;
        }
    }
    new
}

/// Value at a position beside a node. Beyond the sides it goes on as a plane would, if the node is
/// not beyond them: the mean about a node of the border is then one of the border.
fn sample_within(interpolation: Interpolation, grid: &Grid, values: &[f64], node: [f64; 2], position: [f64; 2]) -> f64 {
    let [lo, hi] = grid.bounds();
    let clamped = |p: [f64; 2]| [0, 1].map(|k| p[k].clamp(lo[k], hi[k]));
    let edge = clamped(position);
    let is_in = (0..2).all(|k| (clamped(node)[k] - node[k]).abs() <= 1e-9 * grid.spacing[k]);
    if edge == position || !is_in {
        return sample_by(interpolation, grid, values, position);
    }
    let mirrored = clamped([0, 1].map(|k| 2.0 * edge[k] - position[k]));
    2.0 * sample_by(interpolation, grid, values, edge) - sample_by(interpolation, grid, values, mirrored)
}

/// Value of a raster at a position (m) by either interpolation, NaN outside or beside nodata.
pub fn sample_by(interpolation: Interpolation, grid: &Grid, values: &[f64], position: [f64; 2]) -> f64 {
    if interpolation == Interpolation::Linear {
        return height_field::sample(grid, values, position);
    }
    let [u, v] = grid.col_row(position);
    let (cols, rows) = (grid.shape.cols as isize, grid.shape.rows as isize);
    let (c, r) = ((u.floor() as isize).clamp(0, cols - 1), (v.floor() as isize).clamp(0, rows - 1));
    let (fu, fv) = (weights((u - c as f64).clamp(0.0, 1.0)), weights((v - r as f64).clamp(0.0, 1.0)));
    if c >= 1 && c + 2 < cols && r >= 1 && r + 2 < rows {
        // All sixteen nodes are there; where one is nodata the sum is none.
        let first = grid.shape.index(r as usize - 1, c as usize - 1);
        let mut sum = 0.0;
        for (a, wv) in fv.iter().enumerate() {
            let row = &values[first + a * grid.shape.cols..][..4];
            fu.iter().zip(row).for_each(|(wu, value)| sum += wv * wu * value);
        }
        if !sum.is_nan() {
            return sum;
        }
    }
    let linear = height_field::sample(grid, values, position);
    if linear.is_nan() {
        return linear;
    }
    let mut sum = 0.0;
    for (a, wv) in fv.iter().enumerate() {
        for (b, wu) in fu.iter().enumerate() {
            for (row, k) in beyond(r + a as isize - 1, rows) {
                for (col, j) in beyond(c + b as isize - 1, cols) {
                    if k * j != 0.0 {
                        sum += wv * wu * k * j * values[grid.shape.index(row, col)];
                    }
                }
            }
        }
    }
    // Beside nodata there are not sixteen nodes.
    if sum.is_nan() { linear } else { sum }
}

/// A row or column as a sum of two that are there: itself, or beyond the sides as a plane goes on.
fn beyond(at: isize, count: isize) -> [(usize, f64); 2] {
    let edge = at.clamp(0, count - 1);
    let inner = (2 * edge - at).clamp(0, count - 1);
    if edge == at { [(at as usize, 1.0), (at as usize, 0.0)] } else { [(edge as usize, 2.0), (inner as usize, -1.0)] }
}

/// Catmull and Rom's weights of the four nodes around a point, the last of them 0 at a node.
fn weights(t: f64) -> [f64; 4] {
    let (t2, t3) = (t * t, t * t * t);
    [0.5 * (-t3 + 2.0 * t2 - t), 0.5 * (3.0 * t3 - 5.0 * t2 + 2.0), 0.5 * (-3.0 * t3 + 4.0 * t2 + t), 0.5 * (t3 - t2)]
}

fn on_rim(grid: &Grid, i: usize) -> bool {
    let cell = grid.shape.cell(i);
    cell.row == 0 || cell.col == 0 || cell.row + 1 == grid.shape.rows || cell.col + 1 == grid.shape.cols
}

/// Points (x, y, z in m) and counter-clockwise triangles of a raster; squares with a nodata corner
/// are left out.
pub fn mesh_parts_from_height_field(field: &HeightField) -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
    let shape = field.grid().shape;
    let z = field.elevation();
    let mut index = vec![u32::MAX; z.len()];
    let mut points = Vec::new();
    for i in 0..z.len() {
        if !z[i].is_nan() {
            index[i] = points.len() as u32;
            let [x, y] = field.grid().position(i);
            points.push([x, y, z[i]]);
        }
    }
    let mut triangles = Vec::new();
    for row in 0..shape.rows.saturating_sub(1) {
        for col in 0..shape.cols.saturating_sub(1) {
            let at = |r: usize, c: usize| index[shape.index(row + r, col + c)];
            let [nw, ne, sw, se] = [at(0, 0), at(0, 1), at(1, 0), at(1, 1)];
            for t in [[nw, sw, se], [nw, se, ne]] {
                if !t.contains(&u32::MAX) {
                    triangles.push(t);
                }
            }
        }
    }
    (points, triangles)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algo::sampling::poisson_disk;
    use crate::field::names;
    use crate::grid::Shape;
    use crate::random::Seed;
    use crate::terrain::Layer;

    #[test]
    fn a_raster_has_the_open_sides_of_its_mesh() {
        let sites: Vec<[f64; 2]> = (0..121).map(|i| [f64::from(i % 11) * 10.0, f64::from(i / 11) * 10.0]).collect();
        for edges in [
            Edges { south: Edge::Open, ..Edges::all(Edge::Closed) },
            Edges { north: Edge::Closed, ..Edges::all(Edge::Open) },
            Edges::all(Edge::Open),
        ] {
            let mesh = Mesh::delaunay(&sites, edges).unwrap();
            assert_eq!(height_field_from_mesh(&mesh, 10.0).unwrap().grid().edges, edges);
        }
    }

    #[test]
    fn a_plane_on_a_mesh_is_the_same_plane_on_a_raster() {
        let sites = poisson_disk([1000.0, 800.0], 25.0, Seed(1)).unwrap();
        let mut mesh = Mesh::delaunay(&sites, Edges::default()).unwrap();
        let plane = |[x, y]: [f64; 2]| 3.0 + 0.5 * x - 0.25 * y;
        for i in 0..mesh.graph().len() {
            let p = mesh.positions()[i];
            mesh.change(Layer::Bedrock, |z| z[i] = plane(p));
        }
        mesh.fields.insert(&names::BASIN, vec![4; mesh.graph().len()]).unwrap();
        let field = height_field_from_mesh(&mesh, 20.0).unwrap();
        assert_eq!(field.grid().shape, Shape::new(41, 51));
        for i in 0..field.grid().len() {
            assert!((field.elevation()[i] - plane(field.grid().position(i))).abs() < 1e-9);
        }
        assert!(field.fields.get(&names::BASIN, "test").unwrap().iter().all(|&b| b == 4));
    }

    #[test]
    fn resampling_keeps_a_plane_and_holes() {
        let grid = Grid::new(Shape::new(21, 21), [10.0, 10.0]).unwrap();
        let mut z: Vec<f64> = (0..grid.len()).map(|i| grid.position(i)[0] + 2.0 * grid.position(i)[1]).collect();
        for r in 8..13 {
            for c in 8..13 {
                z[r * 21 + c] = f64::NAN;
            }
        }
        let field = HeightField::new(grid.clone(), z).unwrap();
        let fine = resample(&field, &grid.with_cell_size(5.0).unwrap(), Interpolation::Linear).unwrap();
        assert!((fine.elevation_at([35.0, 45.0]) - 125.0).abs() < 1e-9);
        assert!(fine.elevation_at([100.0, 100.0]).is_nan());
        let coarse = resample(&field, &grid.with_cell_size(20.0).unwrap(), Interpolation::Linear).unwrap();
        assert_eq!(coarse.grid().shape, Shape::new(11, 11));
        assert!((coarse.elevation_at([40.0, 40.0]) - 120.0).abs() < 1e-9);
        assert!(coarse.elevation_at([100.0, 100.0]).is_nan());
        // The border too.
        for cell in [5.0, 20.0, 40.0] {
            for interpolation in [Interpolation::Linear, Interpolation::Cubic] {
                let other = resample(&field, &grid.with_cell_size(cell).unwrap(), interpolation).unwrap();
                for i in (0..other.grid().len()).filter(|&i| !other.elevation()[i].is_nan() && on_rim(other.grid(), i))
                {
                    let [x, y] = other.grid().position(i);
                    assert!((other.elevation()[i] - x - 2.0 * y).abs() < 1e-9, "{cell}: {x} {y}");
                }
            }
        }
    }

    #[test]
    fn cubic_curves_go_through_the_nodes_and_keep_planes() {
        let grid = Grid::new(Shape::new(6, 7), [10.0, 10.0]).unwrap();
        let rough: Vec<f64> = (0..42).map(|i| f64::from((i * 37) % 11)).collect();
        let plane: Vec<f64> = (0..42).map(|i| grid.position(i)[0] - 2.0 * grid.position(i)[1]).collect();
        for i in 0..42 {
            assert!((sample_by(Interpolation::Cubic, &grid, &rough, grid.position(i)) - rough[i]).abs() < 1e-12);
        }
        let at = [23.7, 21.2];
        assert!((sample_by(Interpolation::Cubic, &grid, &plane, at) - (at[0] - 2.0 * at[1])).abs() < 1e-12);
        assert!(sample_by(Interpolation::Cubic, &grid, &rough, [-5.0, 0.0]).is_nan());
    }
}
