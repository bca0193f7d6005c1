//! Rasters in longitude and latitude.
//!
//! # Method
//! Distances east shrink with the cosine of the latitude. One scale for the whole raster, that of
//! its middle, is wrong by half of the change between its middle and its southern or northern side.
//! Rasters where this error exceeds 5 % are refused: they need a projection.
//!
//! # Sources
//! Metres per degree: series on the WGS 84 ellipsoid (American Practical Navigator, table 7).

use landform_core::grid::{Degrees, Georeference, Grid};
use landform_core::{Error, Result, math};

use crate::format::is_web_mercator;

/// The greatest relative error of distances that is accepted.
const MOST_ERROR: f64 = 0.05;
/// Radius of the Mercator projection of web maps, m.
pub(super) const EQUATORIAL_RADIUS: f64 = 6_378_137.0;

/// Whether coordinates are degrees: the file says so, or was taken so when it was read.
pub fn in_degrees(grid: &Grid) -> bool {
    grid.georeference.geographic
}

/// How many of its units a metre is at the middle of a raster in the Mercator projection of web
/// maps, whose units are metres at the equator only; none in other systems.
pub fn mercator_stretch(grid: &Grid) -> Option<f64> {
    grid.georeference.epsg.filter(|e| is_web_mercator(*e))?;
    let [[_, south], [_, north]] = grid.bounds();
    // Latitude is the Gudermannian of y over the radius; the stretch 1 / cos of that is cosh.
    let up = math::exp(0.5 * (south + north) / EQUATORIAL_RADIUS);
    Some(0.5 * (up + 1.0 / up))
}

/// Refuses a raster of a web map's projection where its units are further from metres than degrees
/// may be.
///
/// # Errors
/// [`Error::Parameter`].
pub(super) fn check_stretch(grid: &Grid) -> Result<()> {
    match mercator_stretch(grid) {
        Some(stretch) if !(stretch - 1.0 <= MOST_ERROR) => {
            let value = format!("EPSG:3857, {}", stretch_text(stretch));
            Err(Error::parameter("coordinates", value, "metres: warp it to UTM first"))
        }
        _ => Ok(()),
    }
}

/// What a stretch does, in words.
pub fn stretch_text(stretch: f64) -> String {
    let latitude = math::acos((1.0 / stretch).min(1.0)).to_degrees();
    format!(
        "whose units are {:.3} m at {latitude:.1} degrees of latitude: slopes come out {stretch:.2} times too gentle, areas {:.2} times too large",
        1.0 / stretch,
        stretch * stretch
    )
}

/// Metres per degree of longitude and of latitude.
fn metres_per_degree(latitude: f64) -> [f64; 2] {
    let c = |k: f64| math::cos(k * latitude.to_radians());
    [
        111_412.84 * c(1.0) - 93.5 * c(3.0) + 0.118 * c(5.0),
        111_132.92 - 559.82 * c(2.0) + 1.175 * c(4.0) - 0.0023 * c(6.0),
    ]
}

/// Converts longitude and latitude to metres at the middle latitude. Returns the greatest relative
/// error of distances that this causes.
///
/// # Errors
/// [`Error::Parameter`] if the error is more than 5 %, or if latitudes are beyond 90 degrees.
pub fn metres_from_degrees(grid: &mut Grid) -> Result<f64> {
    let (north, south) = (grid.origin[1], grid.origin[1] - grid.extent()[1]);
    if !(north <= 90.0 + 1e-6 && south >= -90.0 - 1e-6) {
        let value = format!("latitudes from {south:.3} to {north:.3}");
        return Err(Error::parameter("coordinates", value, "latitudes between -90 and 90 degrees"));
    }
    let middle = 0.5 * (north + south);
    let [east, up] = metres_per_degree(middle);
    let error = [north, south].map(|l| (metres_per_degree(l)[0] / east - 1.0).abs()).into_iter().fold(0.0, f64::max);
    if !(error <= MOST_ERROR) {
        let value = format!(
            "degrees from {south:.2} to {north:.2} north: metres of one latitude would be {:.0} % wrong at the sides",
            100.0 * error
        );
        return Err(Error::parameter(
            "coordinates",
            value,
            "metres: warp it to an equal-area projection or to UTM first",
        ));
    }
    let degrees = Degrees { origin: [grid.origin[0], south], metres: [east, up], epsg: grid.georeference.epsg };
    grid.spacing = [grid.spacing[0] * east, grid.spacing[1] * up];
    grid.origin = [0.0, grid.extent()[1]];
    let others = std::mem::take(&mut grid.georeference);
    grid.georeference = Georeference { epsg: None, geographic: false, degrees: Some(degrees), ..others };
    Ok(error)
}

#[cfg(test)]
mod tests {
    use super::*;
    use landform_core::grid::Shape;

    fn grid(south: f64, north: f64) -> Grid {
        let mut grid = Grid::new(Shape::new(11, 5), [0.01, (north - south) / 10.0]).unwrap();
        grid.origin = [10.0, north];
        grid.georeference.geographic = true;
        grid
    }

    #[test]
    fn small_maps_become_metres_and_large_ones_are_refused() {
        let mut small = grid(45.0, 45.1);
        assert!(in_degrees(&small));
        assert!(metres_from_degrees(&mut small).unwrap() < 0.001);
        assert!((small.spacing[0] / 788.0 - 1.0).abs() < 0.002 && (small.spacing[1] / 1111.4 - 1.0).abs() < 0.001);
        assert!(!in_degrees(&small));
        let text = metres_from_degrees(&mut grid(49.0, 61.0)).unwrap_err().to_string();
        assert!(text.contains("% wrong"), "{text}");
        assert!(metres_from_degrees(&mut grid(85.0, 95.0)).is_err());
        assert!(metres_from_degrees(&mut grid(-3.0, 3.0)).unwrap() < 0.002);
    }

    #[test]
    fn degrees_come_back_as_degrees() {
        let source = grid(45.0, 45.1);
        let mut metres = source.clone();
        metres_from_degrees(&mut metres).unwrap();
        assert!(metres.georeference.epsg.is_none() && !in_degrees(&metres));
        let back = metres.in_its_system();
        assert!(back.georeference.geographic);
        for k in 0..2 {
            assert!((back.spacing[k] / source.spacing[k] - 1.0).abs() < 1e-12);
            assert!((back.origin[k] - source.origin[k]).abs() < 1e-9);
        }
    }

    #[test]
    fn units_of_web_maps_are_metres_at_the_equator_only() {
        let at = |y: f64, epsg: u16| {
            let mut grid = Grid::new(Shape::new(3, 3), [30.0, 30.0]).unwrap();
            grid.origin = [1_000_000.0, y];
            grid.georeference.epsg = Some(epsg);
            grid
        };
        // 60 degrees north.
        let north = at(8_399_737.9, 3857);
        assert!((mercator_stretch(&north).unwrap() - 2.0).abs() < 1e-4);
        let text = check_stretch(&north).unwrap_err().to_string();
        assert!(text.contains("0.500 m at 60.0 degrees") && text.contains("2.00 times too gentle"), "{text}");
        assert!(check_stretch(&at(-8_399_737.9, 3857)).is_err() && check_stretch(&at(500.0, 3857)).is_ok());
        assert_eq!(mercator_stretch(&at(8_399_737.9, 32_611)), None);
    }
}
