//! GeoTIFF: any plain numbers; deflate, LZW, ZSTD (read only) or plain; tiles or strips;
//! predictors; georeference, nodata, masks.
//!
//! Directories are read and written through the `tiff` crate, which writes strips only and reads no
//! bands beside the colours, no ZSTD and no absent tiles: blocks of samples are laid out here.
//!
//! # Sources
//! TIFF 6.0 (sections 14 and 15) and Adobe's technical note 3 (floating-point predictor); OGC
//! GeoTIFF 1.1 for keys.

mod blocks;
mod keys;
mod metadata;
mod numbers;
mod read;
mod unpack;
mod write;

pub(super) use numbers::half;
pub(super) use read::{read, read_header, read_mask};
pub(super) use write::write;

use std::io::Cursor;

use landform_core::Error;
use tiff::decoder::Decoder;

use super::{Compression, DataType, GeotiffOptions};

const NAME: &str = "GeoTIFF";

type Reader<'a> = Decoder<Cursor<&'a [u8]>>;

fn fail(error: tiff::TiffError) -> Error {
    match error {
        tiff::TiffError::IoError(e) if e.kind() == std::io::ErrorKind::UnexpectedEof => {
            Error::format(NAME, "it ends before its data does: truncated")
        }
        error => Error::format(NAME, error),
    }
}

#[cfg(test)]
mod tests;
