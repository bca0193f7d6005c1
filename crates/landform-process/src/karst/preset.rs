//! Patterns of networks.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Pattern of a network (Palmer 1991, Origin and morphology of limestone caves, GSA Bulletin 103).
///
/// ```
/// use landform_process::karst::{KarstNetwork, Preset};
///
/// assert_eq!(KarstNetwork::default().preset, Preset::Branchwork);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Preset {
    /// A tree: water from sinkholes joins on its way.
    #[default]
    Branchwork,
    /// A tree with some loops.
    Mixed,
    /// Many loops of round tubes: floods find several ways.
    Anastomotic,
    /// A net of two families of fractures.
    RectilinearMaze,
    /// Rooms and holes in all directions.
    Spongework,
}

impl Preset {
    /// Blind side passages for each sinkhole.
    pub(super) fn dead_ends(self) -> f64 {
        match self {
            Self::Branchwork => 1.9,
            Self::Mixed => 2.1,
            Self::Anastomotic => 2.1,
            Self::RectilinearMaze | Self::Spongework => 0.0,
        }
    }

    /// Loops for each end.
    pub(super) fn loops(self) -> f64 {
        match self {
            Self::Branchwork => 0.0,
            Self::Mixed => 0.17,
            Self::Anastomotic => 0.5,
            Self::RectilinearMaze | Self::Spongework => 0.0,
        }
    }

    /// Whether passages fill a zone.
    pub(super) fn is_maze(self) -> bool {
        matches!(self, Self::RectilinearMaze | Self::Spongework)
    }
}
