//! From degrees to metres over a whole country.
//!
//! # Sources
//! Lambert's azimuthal equal-area projection (Snyder 1987, p. 185) on the sphere of the Earth's
//! area, radius 6371.007 km.

use crate::math;

/// Longitudes and latitudes in degrees as metres east and north of `centre` (longitude, latitude).
pub fn project(points: &[[f64; 2]], centre: [f64; 2]) -> Vec<[f64; 2]> {
    const RADIUS: f64 = 6_371_007.2;
    let [lon0, lat0] = centre.map(f64::to_radians);
    let (s0, c0) = (math::sin(lat0), math::cos(lat0));
    points
        .iter()
        .map(|p| {
            let [lon, lat] = p.map(f64::to_radians);
            let (s, c) = (math::sin(lat), math::cos(lat));
            let cos_d = math::cos(lon - lon0);
            let k = RADIUS * (2.0 / (1.0 + s0 * s + c0 * c * cos_d)).sqrt();
            [k * c * math::sin(lon - lon0), k * (c0 * s - s0 * c * cos_d)]
        })
        .collect()
}
