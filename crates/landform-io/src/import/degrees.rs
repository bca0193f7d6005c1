//! Rasters in longitude and latitude.
//!
//! # Method
//! Distances east shrink with the cosine of the latitude. One scale for the whole raster, that of its middle, is wrong by half of the change between its middle and its
//! southern or northern side. Rasters where that passes 5 % are refused: they need a projection.
//!
//! # Sources
//! Metres per degree: series on the WGS 84 ellipsoid (American Practical Navigator, table 7).

use landform_core::terrain::HeightField;
use landform_core::{Error, Result, math};

/// The greatest relative error of distances that is accepted.
const MOST_ERROR: f64 = 0.05;

/// Whether coordinates are degrees: said so, or no system is named and they could hardly be metres.
pub fn in_degrees(field: &HeightField) -> bool {
    let grid = field.grid();
    let [x, y] = grid.origin;
    let tiny = grid.spacing[0] < 0.1 && x.abs() <= 360.0 && y.abs() <= 90.0 && [x, y] != [0.0, grid.extent()[1]];
    // A whole globe, or a hemisphere, in cells of up to two degrees.
    let [dx, dy] = grid.extent();
    let near = |a: f64, b: f64| (a - b).abs() <= grid.spacing[0].max(grid.spacing[1]);
    let globe = grid.spacing[0] <= 2.0 && near(dx, 360.0) && near(y, 90.0) && dy <= 181.0;
    grid.georeference.geographic || (grid.georeference.epsg.is_none() && (tiny || globe))
}

/// Metres per degree of longitude and of latitude.
fn metres_per_degree(latitude: f64) -> [f64; 2] {
    let c = |k: f64| math::cos(k * latitude.to_radians());
    [
        111_412.84 * c(1.0) - 93.5 * c(3.0) + 0.118 * c(5.0),
        111_132.92 - 559.82 * c(2.0) + 1.175 * c(4.0) - 0.0023 * c(6.0),
    ]
}

/// Takes longitude and latitude as metres at the middle latitude. Gives the greatest relative error of distances that this makes.
///
/// # Errors
/// [`Error::Parameter`] where the error is more than 5 %, or latitudes are beyond 90 degrees.
pub fn metres_from_degrees(field: &mut HeightField) -> Result<f64> {
    let mut grid = field.grid().clone();
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
    grid.spacing = [grid.spacing[0] * east, grid.spacing[1] * up];
    grid.origin = [0.0, grid.extent()[1]];
    grid.georeference = Default::default();
    field.set_grid(grid)?;
    Ok(error)
}

#[cfg(test)]
mod tests {
    use super::*;
    use landform_core::grid::{Grid, Shape};

    fn field(south: f64, north: f64) -> HeightField {
        let mut grid = Grid::new(Shape::new(11, 5), [0.01, (north - south) / 10.0]).unwrap();
        grid.origin = [10.0, north];
        grid.georeference.geographic = true;
        HeightField::new(grid, vec![1.0; 55]).unwrap()
    }

    #[test]
    fn small_maps_become_metres_and_large_ones_are_refused() {
        let mut small = field(45.0, 45.1);
        assert!(in_degrees(&small));
        assert!(metres_from_degrees(&mut small).unwrap() < 0.001);
        assert!(
            (small.grid().spacing[0] / 788.0 - 1.0).abs() < 0.002
                && (small.grid().spacing[1] / 1111.4 - 1.0).abs() < 0.001
        );
        assert!(!in_degrees(&small));
        let text = metres_from_degrees(&mut field(49.0, 61.0)).unwrap_err().to_string();
        assert!(text.contains("% wrong"), "{text}");
        assert!(metres_from_degrees(&mut field(85.0, 95.0)).is_err());
        assert!(metres_from_degrees(&mut field(-3.0, 3.0)).unwrap() < 0.002);
    }
}
