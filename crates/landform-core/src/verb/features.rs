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
        }
    }
}
