//! A terrain of any representation: what recipes pass from stage to stage.

use landform_core::terrain::{HeightField, Mesh, Terrain};
use landform_core::{Error, Result};
use serde::{Deserialize, Serialize};

/// A terrain of any representation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum AnyTerrain {
    /// A raster.
    HeightField(HeightField),
    /// An irregular mesh.
    Mesh(Mesh),
}

/// A representation that [`AnyTerrain`] can hold.
pub(super) trait Held: Terrain {
    fn wrap(self) -> AnyTerrain;
    fn of(any: &AnyTerrain) -> Option<&Self>;
    fn of_mut(any: &mut AnyTerrain) -> Option<&mut Self>;
}

macro_rules! held {
    ($type:ident) => {
        impl Held for $type {
            fn wrap(self) -> AnyTerrain {
                AnyTerrain::$type(self)
            }
            fn of(any: &AnyTerrain) -> Option<&Self> {
                if let AnyTerrain::$type(t) = any { Some(t) } else { None }
            }
            fn of_mut(any: &mut AnyTerrain) -> Option<&mut Self> {
                if let AnyTerrain::$type(t) = any { Some(t) } else { None }
            }
        }
    };
}
held!(HeightField);
held!(Mesh);

impl AnyTerrain {
    /// What the representation is called.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::HeightField(_) => HeightField::KIND,
            Self::Mesh(_) => Mesh::KIND,
        }
    }

    pub(super) fn unsupported(&self, what: &str, supports: &str) -> Error {
        Error::Unsupported { what: format!("`{what}`"), on: self.kind().into(), supports: format!("a {supports}") }
    }

    pub(super) fn get<T: Held>(&self, what: &str) -> Result<&T> {
        T::of(self).ok_or_else(|| self.unsupported(what, T::KIND))
    }

    pub(super) fn get_mut<T: Held>(&mut self, what: &str) -> Result<&mut T> {
        let error = self.unsupported(what, T::KIND);
        T::of_mut(self).ok_or(error)
    }
}
