//! Kinds of features in recipes.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::feature::FeatureKind;

/// Several features of a kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum FeatureWord {
    /// Reaches of rivers.
    Rivers,
    /// Lakes.
    Lakes,
    /// Drainage basins.
    Basins,
    /// Lines between land and sea.
    Coasts,
    /// Lines of one elevation.
    Contours,
    /// Passages under the ground.
    Conduits,
    /// Places where water sinks into the ground.
    Sinkholes,
    /// Places where water leaves the ground.
    Springs,
    /// Places where passages open to the surface.
    Entrances,
    /// Roads.
    Paths,
    /// Objects that stand on the ground.
    Objects,
}

impl FeatureWord {
    /// The kind that the word names.
    pub fn kind(self) -> FeatureKind {
        match self {
            Self::Rivers => FeatureKind::River,
            Self::Lakes => FeatureKind::Lake,
            Self::Basins => FeatureKind::Basin,
            Self::Coasts => FeatureKind::Coast,
            Self::Contours => FeatureKind::Contour,
            Self::Conduits => FeatureKind::Conduit,
            Self::Sinkholes => FeatureKind::Sinkhole,
            Self::Springs => FeatureKind::Spring,
            Self::Entrances => FeatureKind::Entrance,
            Self::Paths => FeatureKind::Path,
            Self::Objects => FeatureKind::Object,
        }
    }
}
