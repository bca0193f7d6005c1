//! Options of a GeoTIFF that is written.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How samples are packed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Compression {
    /// Deflate, with a predictor.
    #[default]
    Deflate,
    /// LZW, with a predictor.
    Lzw,
    /// Not at all.
    None,
}

/// Type of the samples.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum DataType {
    /// 32-bit floats; nodata is −9999.
    #[default]
    Float32,
    /// 64-bit floats; nodata is −9999.
    Float64,
    /// 16-bit whole numbers, rounded; nodata is −32768.
    Int16,
    /// 32-bit whole numbers without sign; there is no nodata.
    Uint32,
    /// Bytes; there is no nodata.
    Uint8,
}

/// Options of a GeoTIFF.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GeotiffOptions {
    /// Type of the samples.
    pub data_type: DataType,
    /// How they are packed.
    pub compression: Compression,
    /// Side of the tiles, a multiple of 16; strips if none.
    pub tile: Option<usize>,
}

impl Default for GeotiffOptions {
    fn default() -> Self {
        Self { data_type: DataType::Float32, compression: Compression::Deflate, tile: Some(512) }
    }
}
