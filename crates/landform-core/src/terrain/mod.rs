//! The representations of a terrain, and what they have in common.
//!
//! Two exist: [`HeightField`] (a raster) and [`Mesh`] (an irregular planar graph). Layered, voxel and implicit terrains
//! get their own files beside these.

mod coarsen;
mod convert;
mod gaussian;
mod height_field;
mod mesh;
mod sea;

use std::sync::Arc;

use serde::Serialize;
use serde::de::DeserializeOwned;

pub use convert::{Interpolation, height_field_from_mesh, mesh_parts_from_height_field, resample, sample_by};
pub use gaussian::gaussian_from_mesh;
pub use height_field::HeightField;
pub use mesh::Mesh;
pub use sea::sea_level;

use crate::field::Fields;
use crate::grid::Domain;

/// What every representation is.
pub trait Terrain: Clone + Send + Sync + Serialize + DeserializeOwned + 'static {
    /// What it is called in messages: "height field".
    const KIND: &'static str;

    /// Volume of the ground above z = 0, m³ (negative below).
    fn volume(&self) -> f64;

    /// The first value that is NaN or infinite where it must not be: field and index.
    fn find_non_finite(&self) -> Option<(&'static str, usize)>;

    /// The values whose change from step to step tells whether the terrain is steady, m.
    fn watched(&self) -> &[f64];

    /// The same ground with about a quarter of the nodes; none if it has too few, or no coarser form.
    fn coarser(&self) -> Option<Self> {
        None
    }

    /// Takes the shape of a coarser form of the same ground, base levels excepted.
    fn take_elevation_of(&mut self, _coarse: &Self) {}
}

/// A terrain with one elevation per node of a graph: what flow, uplift and creep ask of a terrain.
pub trait NodeSurface: Terrain {
    /// The graph.
    type Domain: Domain;

    /// The graph of the nodes, with base levels on the open border (or where [`NodeSurface::set_status`] put them) and
    /// nodata masked.
    fn domain(&self) -> Arc<Self::Domain>;

    /// Sets the status of every node (see [`Outlets`](crate::verb::Outlets)); none goes back to what the border says.
    fn set_status(&mut self, status: Option<Vec<u8>>);

    /// The status of every node as the border alone says.
    fn border(&self) -> Vec<u8>;

    /// Elevation per node, m; NaN on masked nodes.
    fn elevation(&self) -> &[f64];

    /// Elevation per node, to change.
    fn elevation_mut(&mut self) -> &mut [f64];

    /// Position of a node, m.
    fn position(&self, node: usize) -> [f64; 2];

    /// The rectangle around all nodes: [west, south], [east, north].
    fn bounds(&self) -> [[f64; 2]; 2];

    /// Optional fields.
    fn fields(&self) -> &Fields;

    /// Optional fields, to change.
    fn fields_mut(&mut self) -> &mut Fields;

    /// EPSG code of the coordinates, if they have one.
    fn epsg(&self) -> Option<u16> {
        None
    }
}
