//! Whether nodes stand on the centres of their cells while water runs.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Where the nodes of a raster stand.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Lattice {
    /// Off the centres of their cells, up to half a cell each way, so that rivers do not follow the
    /// lattice. Heights go there by smooth curves when the run begins, and back to the centres when
    /// it ends.
    #[default]
    Jittered,
    /// On the centres of their cells. Rivers then keep to eight directions.
    Regular,
}
