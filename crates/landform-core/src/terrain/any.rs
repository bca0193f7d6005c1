//! A terrain of any representation: what is passed from stage to stage.

use std::borrow::Cow;

use serde::{Deserialize, Serialize};

use super::{
    Erodible, Ground, HeightField, Kind, Mesh, NodeSurface, Refine, Terrain, VoxelGrid, height_field_from_mesh,
};
use crate::random::Seed;
use crate::{Error, Result};

/// A surface from which a raster can be made.
pub trait Rasterize: NodeSurface {
    /// The raster itself, or one made from the surface for pictures and measures.
    ///
    /// # Errors
    /// Where [`HeightField::new`] fails.
    fn rasterized(&self) -> Result<Cow<'_, HeightField>>;

    /// The same ground on nodes off the centres of the cells, by a seed; none if nodes stand on no
    /// lattice, or do so already.
    fn jittered(&self, _: Seed) -> Option<Self> {
        None
    }

    /// The same ground on the centres of the cells, if its nodes stand off them.
    fn at_centres(&self) -> Cow<'_, Self> {
        Cow::Borrowed(self)
    }
}

impl Rasterize for HeightField {
    fn rasterized(&self) -> Result<Cow<'_, HeightField>> {
        Ok(self.at_centres())
    }

    fn jittered(&self, seed: Seed) -> Option<Self> {
        self.off_centres(seed)
    }

    fn at_centres(&self) -> Cow<'_, Self> {
        self.on_centres().map_or(Cow::Borrowed(self), Cow::Owned)
    }
}

impl Rasterize for Mesh {
    /// Cells of half the mean distance between nodes, within 2048² cells.
    fn rasterized(&self) -> Result<Cow<'_, HeightField>> {
        let area = self.area();
        let cell = 0.5 * (area / self.positions().len() as f64).sqrt();
        height_field_from_mesh(self, cell.max((area / (2048.0 * 2048.0)).sqrt())).map(Cow::Owned)
    }
}

/// What every surface that recipes pass on can do.
pub trait Surface: Rasterize + Ground + Refine + Representation {}

impl<T: Rasterize + Ground + Refine + Representation> Surface for T {}

/// What every body of ground that recipes pass on can do, whether or not it has one elevation a
/// node.
pub trait Body: Erodible + Representation {}

impl<T: Erodible + Representation> Body for T {}

/// A representation that [`AnyTerrain`] can hold.
pub trait Representation: Terrain {
    /// Puts it in.
    fn wrap(self) -> AnyTerrain;
    /// The terrain, if it has this representation.
    fn of(any: &AnyTerrain) -> Option<&Self>;
    /// The terrain to change, if it has this representation.
    fn of_mut(any: &mut AnyTerrain) -> Option<&mut Self>;
}

/// An operation on a terrain whose representation is known only at run time.
pub trait Visit {
    /// Result.
    type Out;
    /// Does it on a surface.
    fn surface<T: Surface>(self, terrain: &T) -> Self::Out;
    /// Does it on a body that has no single elevation a node.
    fn body<T: Body>(self, terrain: &T) -> Self::Out;
}

/// That `what` needs a surface with one elevation a node, and a terrain is none.
///
/// ```
/// use landform_core::terrain::{Kind, not_a_surface};
///
/// let error = not_a_surface(Kind::VoxelGrid, "a picture").to_string();
/// assert!(error.contains("a picture") && error.contains("voxel grid"));
/// ```
pub fn not_a_surface(kind: Kind, what: &str) -> Error {
    Error::Unsupported {
        what: what.into(),
        on: kind.to_string(),
        supports: "a height field or a mesh; `uppermost_surface` makes a height field of voxels".into(),
    }
}

/// The list of representations: everything that differs by kind is made from it.
macro_rules! representations {
    (surfaces: $($(#[$doc:meta])* $type:ident),*; bodies: $($(#[$body_doc:meta])* $body:ident),*) => {
        /// A terrain of any representation.
        #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
        #[non_exhaustive]
        pub enum AnyTerrain {
            $($(#[$doc])* $type($type),)*
            $($(#[$body_doc])* $body($body)),*
        }

        representations!(@each $($type),*, $($body),*);

        impl AnyTerrain {
            /// Shows the terrain to a visitor: the only `match` on representations.
            pub fn visit<V: Visit>(&self, visitor: V) -> V::Out {
                match self {
                    $(Self::$type(t) => visitor.surface(t),)*
                    $(Self::$body(t) => visitor.body(t)),*
                }
            }
        }

        impl AnyTerrain {
            /// Elevation per node, m; NaN on nodata. Empty for bodies without a single elevation a
            /// node.
            pub fn elevation(&self) -> &[f64] {
                // A visitor cannot hand out what it borrows.
                None$(.or_else(|| <$type>::of(self).map(NodeSurface::elevation)))*.unwrap_or(&[])
            }
        }

        impl Kind {
            /// Whether such a terrain has one elevation a node.
            ///
            /// ```
            /// use landform_core::terrain::Kind;
            ///
            /// assert!(Kind::Mesh.is_surface() && !Kind::VoxelGrid.is_surface());
            /// ```
            pub const fn is_surface(self) -> bool {
                matches!(self, $(Self::$type)|*)
            }
        }

        /// Bytes a node while processes run on a kind of terrain, measured.
        pub fn bytes_a_node(kind: Kind) -> u64 {
            [$(($type::KIND, $type::BYTES_A_NODE),)* $(($body::KIND, $body::BYTES_A_NODE)),*].iter().find(|k| k.0 == kind).map_or(0, |k| k.1)
        }
    };
    (@each $($type:ident),*) => {
        $(impl Representation for $type {
            fn wrap(self) -> AnyTerrain {
                AnyTerrain::$type(self)
            }
            fn of(any: &AnyTerrain) -> Option<&Self> {
                if let AnyTerrain::$type(t) = any { Some(t) } else { None }
            }
            fn of_mut(any: &mut AnyTerrain) -> Option<&mut Self> {
                if let AnyTerrain::$type(t) = any { Some(t) } else { None }
            }
        })*
    };
}

representations! {
    surfaces:
    /// A raster.
    HeightField,
    /// An irregular mesh.
    Mesh;
    bodies:
    /// Voxels.
    VoxelGrid
}

impl AnyTerrain {
    /// Which representation it is.
    pub fn kind(&self) -> Kind {
        struct KindOf;
        impl Visit for KindOf {
            type Out = Kind;
            fn surface<T: Surface>(self, _: &T) -> Kind {
                T::KIND
            }
            fn body<T: Body>(self, _: &T) -> Kind {
                T::KIND
            }
        }
        self.visit(KindOf)
    }

    /// The terrain as a representation, for `what`.
    ///
    /// # Errors
    /// [`Error::Unsupported`] if it is another one.
    pub fn get<T: Representation>(&self, what: &str) -> Result<&T> {
        T::of(self).ok_or_else(|| self.unsupported(what, T::KIND))
    }

    /// The terrain as a representation, for `what`, to change.
    ///
    /// # Errors
    /// [`Error::Unsupported`] if it is another one.
    pub fn get_mut<T: Representation>(&mut self, what: &str) -> Result<&mut T> {
        let error = self.unsupported(what, T::KIND);
        T::of_mut(self).ok_or(error)
    }

    fn unsupported(&self, what: &str, supports: Kind) -> Error {
        Error::Unsupported { what: format!("`{what}`"), on: self.kind().to_string(), supports: format!("a {supports}") }
    }

    /// Names of all values that can be asked for.
    pub fn names(&self) -> Vec<String> {
        struct Names;
        impl Visit for Names {
            type Out = Vec<String>;
            fn surface<T: Surface>(self, terrain: &T) -> Vec<String> {
                terrain.names()
            }
            fn body<T: Body>(self, _: &T) -> Vec<String> {
                Vec::new()
            }
        }
        self.visit(Names)
    }

    /// How many nodes or voxels it has.
    pub fn nodes(&self) -> usize {
        struct Nodes;
        impl Visit for Nodes {
            type Out = usize;
            fn surface<T: Surface>(self, terrain: &T) -> usize {
                terrain.nodes()
            }
            fn body<T: Body>(self, terrain: &T) -> usize {
                terrain.nodes()
            }
        }
        self.visit(Nodes)
    }
}
