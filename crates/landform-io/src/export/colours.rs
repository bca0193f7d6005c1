//! The colours of the ground as a picture that lies on a mesh.

use landform_core::Result;
use landform_core::grid::Shape;
use landform_core::terrain::{HeightField, NodeSurface};
use landform_core::verb::Environment;

use crate::format::{Texture, encode_png};
use crate::render::colour_map;

/// Pixels along the longer side, where no other number is asked for.
const MOST_PIXELS: usize = 4096;

/// The power of two nearest to a number by its ratio.
fn power_of_two(n: usize) -> usize {
    let above = n.next_power_of_two();
    if above > 1 && n * n < above * (above / 2) { above / 2 } else { above }
}

/// The ground's colours on a mesh of all nodes of a raster that have data, in their order. `size`
/// is the picture's longer side, pixels.
pub(super) fn ground_texture(field: &HeightField, environment: &Environment, size: Option<usize>) -> Result<Texture> {
    let shape = field.grid().shape;
    let longer = shape.rows.max(shape.cols);
    let pixels = |n: usize| match size {
        Some(size) => ((size * n) as f64 / longer as f64).round().max(1.0) as usize,
        None => power_of_two(n).min(MOST_PIXELS),
    };
    let picture = colour_map(field, Shape::new(pixels(shape.rows), pixels(shape.cols)), environment.sea(None));
    // Pixels stand over nodes: the outer ones reach half a cell beyond.
    let place = |i: usize| {
        let cell = shape.cell(i);
        let part = |k: usize, n: usize| ((k as f64 + 0.5) / n as f64) as f32;
        [part(cell.col, shape.cols), part(cell.row, shape.rows)]
    };
    let nodes = 0..field.elevation().len();
    let places = nodes.filter(|&i| !field.elevation()[i].is_nan()).map(place).collect();
    Ok(Texture { places, png: encode_png(&picture.pixels, picture.shape)? })
}
