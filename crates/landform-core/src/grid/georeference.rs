//! Where a raster lies on the Earth.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

/// Whether a file's sample is the value at a point or over the area of a pixel.
///
/// Inside, every raster is node-registered: the value belongs to the point. A pixel-is-area file's
/// samples are taken at the pixels' centres; the registration is remembered so that the file is
/// written back as it came.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum Registration {
    /// Samples at points (GTRasterTypeGeoKey 2).
    #[default]
    Point,
    /// Samples over pixels (GTRasterTypeGeoKey 1).
    Area,
}

/// Coordinate reference system and registration, carried from file to file.
#[derive(Clone, Debug, PartialEq, Default, Serialize, Deserialize)]
pub struct Georeference {
    /// EPSG code; none for local metres.
    pub epsg: Option<u16>,
    /// Whether coordinates are longitude and latitude in degrees.
    pub geographic: bool,
    /// Registration of the file it came from.
    pub registration: Registration,
    /// A system that the code alone does not tell, as the file states it: carried, not understood.
    pub keys: Option<Arc<GeoKeys>>,
    /// The longitude and latitude that local metres were made from.
    pub degrees: Option<Degrees>,
}

/// A coordinate reference system as GeoTIFF states it.
#[derive(Clone, Debug, PartialEq, Default, Serialize, Deserialize)]
pub struct GeoKeys {
    /// The key directory.
    pub directory: Vec<u16>,
    /// Parameters that are real numbers.
    pub numbers: Vec<f64>,
    /// Parameters that are text.
    pub text: String,
}

/// Longitude and latitude of local metres.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Degrees {
    /// Longitude and latitude of (0, 0), degrees.
    pub origin: [f64; 2],
    /// Metres in a degree of longitude and of latitude.
    pub metres: [f64; 2],
    /// EPSG code of the degrees.
    pub epsg: Option<u16>,
}

impl Degrees {
    /// Longitude and latitude of a position in local metres.
    pub fn of(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.origin[0] + x / self.metres[0], self.origin[1] + y / self.metres[1]]
    }
}
