//! A block of land and the camera before it, for other programs to draw.

use landform_core::math;
use landform_core::terrain::{HeightField, NodeSurface};

use super::camera::Camera;
use super::{View, block};
use crate::render::waters;

/// A block of land in local metres, and the camera that holds it: x east, y north from the
/// south-west corner, z up, elevations exaggerated.
#[derive(Clone, Debug)]
pub(crate) struct BlockView {
    /// Least and greatest elevation, m, not exaggerated.
    pub(crate) range: (f64, f64),
    /// Level of the block's foot, m.
    pub(crate) foot: f64,
    /// Depth of water over each node, m, not exaggerated: lakes and the sea.
    pub(crate) depth: Vec<f64>,
    /// Place of the camera, m.
    pub(crate) camera: [f64; 3],
    /// Direction in which it looks, of length 1.
    pub(crate) forward: [f64; 3],
    /// Angle of view from the left to the right of the picture, radians.
    pub(crate) angle: f64,
}

impl BlockView {
    /// The block that [`perspective`](super::perspective) draws.
    pub(crate) fn new(field: &HeightField, view: &View) -> Self {
        let (lo, hi) = block::range(field.elevation());
        let depth = block::water_depth(field, &waters(field).lake, (lo, hi), view.sea_level, view.water);
        let factor = view.exaggeration;
        let height = |(z, depth): (&f64, &f64)| (if z.is_nan() { lo } else { *z } + depth) * factor;
        let surface: Vec<f64> = field.elevation().iter().zip(&depth).map(height).collect();
        let extent = block::extent(field.grid());
        let (low, high) = (lo * factor, hi * factor);
        let foot = block::foot(extent, low, high);
        let camera = Camera::before(&block::outline(field.grid(), &surface, foot), extent, low, view);
        let angle = 2.0 * math::atan(camera.half_height * camera.aspect);
        Self { range: (lo, hi), foot, depth, camera: camera.at, forward: camera.forward, angle }
    }
}
