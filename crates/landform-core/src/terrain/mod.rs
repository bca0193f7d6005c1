//! The representations of a terrain, and their capabilities.
//!
//! A representation implements [`Terrain`], and traits for its capabilities: [`Ground`] (elevation
//! of its surface), [`NodeSurface`] (one elevation per node of a graph), [`Erodible`] (solid can be
//! removed and deposited around a point), [`Refine`] (it has coarser forms). An algorithm requires
//! capabilities, never a representation. [`AnyTerrain`] holds one of any kind and has the only
//! `match` over kinds in the project.
//!
//! Every node surface may be layered: [`Layers`] holds beds of rock and loose layers such as soil,
//! sand and snow.
//!
//! Sand that is deposited raises the surface:
//!
//! ```
//! use landform_core::grid::{Grid, Shape};
//! use landform_core::terrain::{HeightField, NodeSurface};
//!
//! let mut ground = HeightField::new(Grid::new(Shape::new(1, 3), [10.0, 10.0])?, vec![100.0; 3])?;
//! ground.change_depth("sand", &[0.0, 2.0, 0.0])?;
//! assert_eq!(ground.elevation(), [100.0, 102.0, 100.0]);
//! assert_eq!(ground.layers().map(|l| l.surface(1, 102.0).name.as_str()), Some("sand"));
//! # Ok::<(), landform_core::Error>(())
//! ```

mod any;
mod coarsen;
mod convert;
mod cubic;
mod erode;
mod gaussian;
mod ground;
mod height_field;
mod jittered;
mod layers;
mod material;
mod mesh;
mod sea;
mod voxel_grid;
mod window;

use std::borrow::Cow;
use std::sync::Arc;

use serde::Serialize;
use serde::de::DeserializeOwned;

pub use any::{AnyTerrain, Body, Rasterize, Representation, Surface, Visit, bytes_a_node, not_a_surface};
pub use convert::{
    Interpolation, ValuesRaster, height_field_from_mesh, mesh_parts_from_height_field, resample, sample_by,
};
pub use cubic::cubic_from_mesh;
pub use erode::{Brush, Erodible, Removed};
pub use gaussian::gaussian_from_mesh;
pub use ground::{Bounds, Ground};
pub use height_field::HeightField;
pub use layers::{Bed, Column, Layer, Layers, MovedVolume, Stratum};
pub use material::{Material, MaterialParams, Materials};
pub use mesh::Mesh;
pub use sea::sea_level;
pub use voxel_grid::{VoxelGrid, nothing_solid};

use crate::feature::Features;
use crate::field::{Fields, Values, names};
use crate::grid::{Degrees, Domain, Status};
use crate::{Error, Result, parallel};

/// Which representation a terrain is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Kind {
    /// A raster of elevations.
    HeightField,
    /// An irregular triangulated surface.
    Mesh,
    /// Voxels of materials and of nothing.
    VoxelGrid,
}

impl Kind {
    /// What it is called in messages: "height field".
    pub const fn name(self) -> &'static str {
        match self {
            Self::HeightField => "height field",
            Self::Mesh => "mesh",
            Self::VoxelGrid => "voxel grid",
        }
    }
}

impl std::fmt::Display for Kind {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

/// Common trait of all representations.
pub trait Terrain: Clone + Send + Sync + Serialize + DeserializeOwned + 'static {
    /// Which representation it is.
    const KIND: Kind;
    /// Bytes a node while processes run, measured.
    const BYTES_A_NODE: u64;

    /// How many nodes or voxels it has.
    fn nodes(&self) -> usize;

    /// Volume of the ground above z = 0, m³ (negative below).
    fn volume(&self) -> f64;

    /// Looks for a number that is NaN or infinite where it must not be.
    ///
    /// # Errors
    /// If there is such a number: the name of the field and the index of the node.
    fn check_finite(&self) -> Result<(), (&'static str, usize)>;
}

/// A terrain that has coarser forms of itself.
pub trait Refine: Terrain {
    /// The same ground with about a quarter of the nodes; none if it has too few.
    fn coarser(&self) -> Option<Self>;

    /// Takes the shape of a coarser form of the same ground, base levels excepted.
    fn take_shape_of(&mut self, coarse: &Self);

    /// Changes as a coarser form of the same ground did between two states: elevations and layers,
    /// base levels excepted. What is finer than the coarse nodes stays.
    fn take_change_of(&mut self, before: &Self, after: &Self);
}

/// A terrain with one elevation per node of a graph, as flow, uplift and creep need it.
pub trait NodeSurface: Terrain {
    /// The graph.
    type Domain: Domain;

    /// The graph of the nodes, with base levels on the open border (or where
    /// [`NodeSurface::set_status`] put them) and nodata masked. **Cost** O(1) after the first call
    /// for a status.
    fn domain(&self) -> Arc<Self::Domain>;

    /// Sets the status of every node (see [`Outlets`](crate::verb::Outlets)); none goes back to
    /// what the border says.
    fn set_status(&mut self, status: Option<Vec<Status>>);

    /// The status of every node as the border alone says.
    fn border(&self) -> Vec<Status>;

    /// Elevation per node, m; NaN on masked nodes.
    fn elevation(&self) -> &[f64];

    /// Layers of the ground; none where it is one material.
    fn layers(&self) -> Option<&Layers>;

    /// Elevation and layers, to the methods of this trait alone.
    #[doc(hidden)]
    fn parts_mut(&mut self) -> (&mut [f64], &mut Option<Box<Layers>>);

    /// Position of a node, m.
    fn position(&self, node: usize) -> [f64; 2];

    /// The rectangle around all nodes: [west, south], [east, north].
    fn bounds(&self) -> [[f64; 2]; 2];

    /// As [`NodeSurface::bounds`]; of the whole, where this is a window of it.
    fn whole_bounds(&self) -> [[f64; 2]; 2] {
        self.bounds()
    }

    /// Optional fields.
    fn fields(&self) -> &Fields;

    /// Optional fields, to change.
    fn fields_mut(&mut self) -> &mut Fields;

    /// Rivers, lakes and other features that a stage found.
    fn features(&self) -> &Features;

    /// Features, to change.
    fn features_mut(&mut self) -> &mut Features;

    /// EPSG code of the coordinates, if they have one.
    fn epsg(&self) -> Option<u16> {
        None
    }

    /// The longitude and latitude that its metres were made from, if they were.
    fn degrees(&self) -> Option<Degrees> {
        None
    }

    /// Moves the ground: beside [`NodeSurface::change_nodes`] and [`NodeSurface::change_depth`] the
    /// one way in which its surface changes. `update` is given the elevations (m); layers follow by
    /// `layer`.
    ///
    /// **Cost** that of `update`; on layered ground O(nodes · layers) more.
    fn change<R>(&mut self, layer: Layer, update: impl FnOnce(&mut [f64]) -> R) -> R {
        if self.layers().is_none() {
            return update(self.parts_mut().0);
        }
        let domain = self.domain();
        let before = self.elevation().to_vec();
        let (z, layers) = self.parts_mut();
        let result = update(z);
        if let Some(layers) = layers {
            layers.follow(layer, &before, z, &|i| domain.area(i));
        }
        result
    }

    /// Moves the surface of some nodes, each once, by its rise (m): as [`NodeSurface::change`] with
    /// [`Layer::Surface`] of the material of a number, at the cost of these nodes alone. `cut` is
    /// told the number of each material that is removed, and its volume, m³.
    ///
    /// ```
    /// use landform_core::grid::{Grid, Shape};
    /// use landform_core::terrain::{HeightField, NodeSurface};
    ///
    /// let mut ground = HeightField::new(Grid::new(Shape::new(1, 2), [10.0; 2])?, vec![5.0; 2])?;
    /// let mut removed = 0.0;
    /// ground.change_nodes(0, &[(1, -2.0)], |_, volume| removed += volume);
    /// assert_eq!((ground.elevation()[1], removed), (3.0, 200.0));
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    fn change_nodes(&mut self, material: u8, rises: &[(usize, f64)], mut cut: impl FnMut(u8, f64)) {
        let domain = self.domain();
        let (z, layers) = self.parts_mut();
        for &(node, rise) in rises {
            let before = z[node];
            z[node] += rise;
            match layers {
                Some(layers) => layers.follow_node(node, [before, z[node]], material, domain.area(node), &mut cut),
                None if rise < 0.0 => cut(0, -rise * domain.area(node)),
                None => {}
            }
        }
    }

    /// Nodes with data nearer than `radius` to a place (m), each with the square of its distance
    /// (m²), in their order; without any the nearest node alone.
    ///
    /// **Cost** O(nodes) by default; on a raster O(nodes that are near).
    ///
    /// ```
    /// use landform_core::grid::{Grid, Shape};
    /// use landform_core::terrain::{HeightField, NodeSurface};
    ///
    /// let ground = HeightField::new(Grid::new(Shape::new(1, 3), [10.0; 2])?, vec![0.0; 3])?;
    /// assert_eq!(ground.nodes_near([10.0, 0.0], 10.0), [(1, 0.0)]);
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    fn nodes_near(&self, at: [f64; 2], radius: f64) -> Vec<(usize, f64)> {
        let z = self.elevation();
        let square = |i: usize| {
            let [x, y] = self.position(i);
            (x - at[0]) * (x - at[0]) + (y - at[1]) * (y - at[1])
        };
        let valid = (0..z.len()).filter(|&i| !z[i].is_nan()).map(|i| (i, square(i)));
        let near: Vec<_> = valid.clone().filter(|n| n.1 < radius * radius).collect();
        if near.is_empty() { valid.min_by(|a, b| a.1.total_cmp(&b.1)).into_iter().collect() } else { near }
    }

    /// Sets the depth (m) of a loose layer on every node; the surface rises or sinks with it,
    /// nodata excepted. The layer is made where there is none.
    ///
    /// # Errors
    /// [`Error::Parameter`] for a material that is not in the table; [`Error::Shape`] if the length
    /// is not that of the nodes.
    fn change_depth(&mut self, material: &str, depth: &[f64]) -> Result<()> {
        let (z, layers) = self.parts_mut();
        if depth.len() != z.len() {
            let (found, expected) = (format!("{} values", depth.len()), z.len().to_string());
            return Err(Error::Shape { what: format!("depth of {material}"), found, expected });
        }
        let layers = layers.get_or_insert_with(|| Box::new(Layers::rock(&Materials::default(), depth.len())));
        let old = layers.depth_mut(material)?;
        parallel::for_pieces_mut2(z, old, parallel::PIECE, |first, z, old| {
            for ((z, old), &new) in z.iter_mut().zip(old).zip(&depth[first..]) {
                let moved = (*z - *old) + new;
                *z = if new != *old { moved } else { *z };
                *old = new;
            }
        });
        Ok(())
    }

    /// Makes sure that the ground has layers, with a table of materials.
    fn make_layered(&mut self, materials: &Materials) {
        let (z, layers) = self.parts_mut();
        let nodes = z.len();
        layers.get_or_insert_with(|| Box::new(Layers::rock(materials, nodes)));
    }

    /// Replaces the layers of the ground; the surface does not change.
    fn set_layers(&mut self, new: Option<Layers>) {
        *self.parts_mut().1 = new.map(Box::new);
    }

    /// Depth of a loose layer on every node, m; none where there never was one.
    fn depth(&self, material: &str) -> Option<&[f64]> {
        self.layers()?.depth(material)
    }

    /// The values of a name, as they are stored: "elevation", "surface_material", the depth of a
    /// loose layer ("sand_depth"), or an optional field.
    ///
    /// # Errors
    /// [`Error::MissingField`], naming `needed_by` and what there is.
    fn named(&self, name: &str, needed_by: &str) -> Result<Cow<'_, Values>> {
        if let Some(values) = self.fields().find(name) {
            return Ok(Cow::Borrowed(values));
        }
        let depth = |material: &str| self.depth(material).map(<[f64]>::to_vec);
        let values = match (name, self.layers()) {
            ("elevation", _) => Some(Values::F64(self.elevation().to_vec())),
            ("surface_material", Some(layers)) => {
                let z = self.elevation();
                Some(Values::U8(parallel::map(z.len(), |i| layers.surface_number(i, z[i]))))
            }
            _ => name.strip_suffix(names::DEPTH_SUFFIX).and_then(depth).map(Values::F64),
        };
        values.map(Cow::Owned).ok_or_else(|| Error::MissingField {
            name: name.into(),
            needed_by: needed_by.into(),
            available: self.names(),
        })
    }

    /// Every name that [`NodeSurface::named`] knows.
    fn names(&self) -> Vec<String> {
        let layers = self.layers().map(|l| {
            let depths = l.loose().map(|m| format!("{m}{}", names::DEPTH_SUFFIX));
            std::iter::once("surface_material".to_string()).chain(depths).collect::<Vec<_>>()
        });
        let fields = self.fields().names().map(String::from);
        std::iter::once("elevation".to_string()).chain(layers.into_iter().flatten()).chain(fields).collect()
    }

    /// The field of a name as real numbers.
    ///
    /// # Errors
    /// Where [`NodeSurface::named`] fails.
    fn real(&self, name: &str, needed_by: &str) -> Result<Vec<f64>> {
        Ok(self.named(name, needed_by)?.to_f64())
    }
}
