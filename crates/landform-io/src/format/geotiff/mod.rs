//! GeoTIFF: float32 or int16; deflate, LZW or plain; tiles or strips; predictors 2 and 3; georeference and nodata.
//!
//! Reading goes through the `tiff` crate. It writes strips only, so tiles, predictors and compression are laid out here on
//! top of its directory writer.
//!
//! # Sources
//! TIFF 6.0 (sections 14 and 15) and Adobe's technical note 3 (floating-point predictor); OGC GeoTIFF 1.1 for keys.

mod keys;
mod read;
mod write;

pub(super) use read::read;
pub(super) use write::write;

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
    /// 16-bit whole numbers, rounded; nodata is −32768.
    Int16,
}

/// What can be chosen.
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

const NAME: &str = "GeoTIFF";

#[cfg(test)]
mod tests;
