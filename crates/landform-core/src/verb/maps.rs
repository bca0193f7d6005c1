//! Maps by path.

use std::path::Path;
use std::sync::Arc;

use crate::grid::Grid;
use crate::terrain::HeightField;
use crate::{Error, Result, math};

/// A grey picture, row 0 north, values from 0 (black) to 1 (white).
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// Rows.
    pub rows: usize,
    /// Columns.
    pub cols: usize,
    /// Row-major values, a part of white.
    pub values: Vec<f64>,
}

/// Reads maps. Core opens no file; the program that runs a recipe reads them.
pub trait Maps: Send + Sync {
    /// The bytes of a file, for what reads them itself.
    ///
    /// # Errors
    /// [`Error::Io`] if the file cannot be read, or there are no files.
    ///
    /// ```
    /// use landform_core::verb::{Maps, NoMaps};
    ///
    /// assert!(NoMaps.bytes("cave.npy".as_ref()).is_err());
    /// ```
    fn bytes(&self, path: &Path) -> Result<Vec<u8>> {
        Err(Error::io("read", path, std::io::ErrorKind::NotFound.into()))
    }

    /// Reads a picture as grey.
    ///
    /// # Errors
    /// [`Error::Io`] if the file cannot be read, [`Error::Format`] if its content is not valid.
    fn image(&self, path: &Path) -> Result<Image>;

    /// Reads a georeferenced raster; one that was read recently is not read again.
    ///
    /// # Errors
    /// [`Error::Io`] if the file cannot be read, [`Error::Format`] if its content is not valid.
    fn raster(&self, path: &Path) -> Result<Arc<HeightField>>;

    /// The grid of a georeferenced raster, without its samples where the format allows it.
    ///
    /// # Errors
    /// [`Error::Io`] if the file cannot be read, [`Error::Format`] if what it says of itself is not
    /// valid.
    fn grid(&self, path: &Path) -> Result<Grid> {
        self.raster(path).map(|raster| raster.grid().clone())
    }
}

/// No maps at all.
#[derive(Clone, Copy, Debug)]
pub struct NoMaps;

impl Maps for NoMaps {
    fn image(&self, path: &Path) -> Result<Image> {
        Err(Error::io("read", path, std::io::ErrorKind::NotFound.into()))
    }
    fn raster(&self, path: &Path) -> Result<Arc<HeightField>> {
        Err(Error::io("read", path, std::io::ErrorKind::NotFound.into()))
    }
}

impl Image {
    /// Bilinear value at (u east, v north), both 0 to 1 between the outer pixels' centres.
    pub fn at(&self, u: f64, v: f64) -> f64 {
        let x = u.clamp(0.0, 1.0) * (self.cols - 1) as f64;
        let y = (1.0 - v.clamp(0.0, 1.0)) * (self.rows - 1) as f64;
        let (c, r) = (x as usize, y as usize);
        let (c1, r1) = ((c + 1).min(self.cols - 1), (r + 1).min(self.rows - 1));
        let at = |r: usize, c: usize| self.values[r * self.cols + c];
        let (fx, fy) = (x - c as f64, y - r as f64);
        math::lerp(math::lerp(at(r, c), at(r, c1), fx), math::lerp(at(r1, c), at(r1, c1), fx), fy)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_image_is_stretched_from_edge_to_edge() {
        let image = Image { rows: 2, cols: 2, values: vec![0.0, 1.0, 0.5, 0.25] };
        assert_eq!(image.at(0.0, 1.0), 0.0);
        assert_eq!(image.at(1.0, 1.0), 1.0);
        assert_eq!(image.at(0.0, 0.0), 0.5);
        assert_eq!(image.at(0.5, 1.0), 0.5);
    }
}
