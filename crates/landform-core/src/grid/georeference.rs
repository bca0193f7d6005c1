//! Where a raster lies on the Earth.

use serde::{Deserialize, Serialize};

/// Whether a file's sample stands for a point or for the area of a pixel.
///
/// Inside, every raster is node-registered: the value belongs to the point. A pixel-is-area file's samples are taken at
/// the pixels' centres; the registration is remembered so that the file is written back as it came.
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
}
