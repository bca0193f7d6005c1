//! Where a raster's samples lie.

use landform_core::grid::{Grid, Registration, Shape};
use landform_core::{Error, Result};

/// A rotation that moves the farthest sample by less than this part of a cell is none.
const LEAST_ROTATION: f64 = 0.01;

/// Distances and place of samples, in the units of the file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Placement {
    /// Distance between columns and between rows.
    pub(super) spacing: [f64; 2],
    /// Position of the first sample.
    pub(super) origin: [f64; 2],
    /// Whether a sample stands for a point or for a pixel.
    pub(super) registration: Registration,
}

impl Placement {
    /// By x = t0 + col t1 + row t2 and y = t3 + col t4 + row t5, which are those of a pixel's
    /// corner if samples are areas.
    ///
    /// # Errors
    /// [`Error::Format`] where it is rotated or flipped, or says nothing sound.
    pub(super) fn of_transform(
        format: &'static str,
        t: [f64; 6],
        shape: Shape,
        registration: Registration,
    ) -> Result<Self> {
        let [x, dx, row_x, y, col_y, dy] = t;
        let wrong =
            |what: String, hint: Option<&str>| Err(Error::Format { format, what, hint: hint.map(String::from) });
        if t.iter().any(|v| !v.is_finite()) || dx == 0.0 && row_x == 0.0 || dy == 0.0 && col_y == 0.0 {
            return wrong(format!("its cells are {dx} x {dy}; expected > 0"), None);
        }
        let cells = |shift: f64, count: usize, cell: f64| (shift * count as f64).abs() > LEAST_ROTATION * cell.abs();
        if dx <= 0.0 || dy >= 0.0 || cells(row_x, shape.rows, dx) || cells(col_y, shape.cols, dy) {
            let hint = "warp it north-up first: gdalwarp in.tif out.tif";
            return wrong(
                format!("it is rotated or flipped (cells of {dx} x {dy}, shear {row_x}, {col_y})"),
                Some(hint),
            );
        }
        let half = if registration == Registration::Area { 0.5 } else { 0.0 };
        Ok(Self { spacing: [dx, -dy], origin: [x + half * dx, y + half * dy], registration })
    }

    /// The grid of so many rows and columns there.
    ///
    /// # Errors
    /// As [`Grid::new`].
    pub(super) fn grid(&self, shape: Shape) -> Result<Grid> {
        let mut grid = Grid::new(shape, self.spacing)?;
        grid.origin = self.origin;
        grid.georeference.registration = self.registration;
        Ok(grid)
    }

    /// Whether the coordinates, of which nothing is said, can hardly be metres.
    pub(super) fn looks_like_degrees(&self, shape: Shape) -> bool {
        let [dx, dy] = self.spacing;
        let extent = [dx * (shape.cols - 1) as f64, dy * (shape.rows - 1) as f64];
        let [west, north] = self.origin;
        let on_earth = west.abs() <= 360.0 && north <= 90.1 && north - extent[1] >= -90.1;
        // Arc seconds hardly ever come out as whole millimetres; surveyors' cells do.
        let is_whole = |v: f64| (v * 1e3 - (v * 1e3).round()).abs() < 1e-6 * (v * 1e3);
        let tiny = dx < 0.1 && !(is_whole(dx) && is_whole(dy));
        // A whole globe, or a hemisphere, in cells of up to two degrees.
        let near = |a: f64, b: f64| (a - b).abs() <= dx.max(dy);
        let globe = dx <= 2.0 && near(extent[0], 360.0) && near(north, 90.0);
        on_earth && (tiny || globe)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SHAPE: Shape = Shape::new(16, 16);

    fn placed(t: [f64; 6]) -> Result<Placement> {
        Placement::of_transform("GeoTIFF", t, SHAPE, Registration::Area)
    }

    #[test]
    fn a_rotation_that_moves_nothing_is_none_and_others_are_refused() {
        let upright = placed([500_000.0, 30.0, 0.0, 4_200_000.0, 0.0, -30.0]).unwrap();
        assert_eq!(upright.origin, [500_015.0, 4_199_985.0]);
        assert_eq!(placed([500_000.0, 30.0, 1e-9, 4_200_000.0, -1e-9, -30.0]).unwrap(), upright);
        for t in [
            [0.0, 30.0, 0.1, 0.0, 0.0, -30.0],
            [0.0, -30.0, 0.0, 0.0, 0.0, -30.0],
            [0.0, 30.0, 0.0, 0.0, 0.0, 30.0],
            [0.0, 0.0, 30.0, 0.0, 30.0, 0.0],
        ] {
            let text = placed(t).unwrap_err().to_string();
            assert!(text.contains("rotated or flipped"), "{text}");
        }
        assert!(placed([0.0, f64::NAN, 0.0, 0.0, 0.0, -1.0]).is_err());
        assert!(placed([0.0, 0.0, 0.0, 0.0, 0.0, 0.0]).is_err());
    }

    #[test]
    fn arc_seconds_are_degrees_and_centimetres_are_not() {
        let at = |cell: f64, west: f64, north: f64| {
            let registration = Registration::Point;
            Placement { spacing: [cell, cell], origin: [west, north], registration }.looks_like_degrees(SHAPE)
        };
        for seconds in [1.0 / 3.0, 1.0, 3.0, 7.5, 15.0, 30.0] {
            assert!(at(seconds / 3_600.0, 10.0, 45.0), "{seconds}");
        }
        for metres in [0.001, 0.01, 0.025, 0.05, 0.5, 30.0] {
            assert!(!at(metres, 0.0, 0.8), "{metres}");
        }
        assert!(!at(1.0 / 3_600.0, 500_000.0, 4_200_000.0));
    }
}
