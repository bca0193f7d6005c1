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

use super::{Compression, DataType, GeotiffOptions};

const NAME: &str = "GeoTIFF";

#[cfg(test)]
mod tests;
