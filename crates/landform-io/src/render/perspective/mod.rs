//! Views in perspective: a block of land as before a model, or the land from a standpoint in it.
//!
//! # Method
//! Rays march through a pyramid of greatest elevations and are refined on the bilinear patch that
//! they hit. Sun and sky visibility are computed once per node ([`light`](super::light)) and
//! interpolated, as are normals and ground colours: grass on gentle low ground, bare soil and rock
//! with slope and height, snow on gentle high ground. Water is a surface above the ground (flat on
//! lakes, along the bed in rivers), tinted by its depth, and mirrors the sky by Schlick's law.
//! Several rays a pixel, jittered by key.
//!
//! From a standpoint the land goes on beyond the map, as if mirrors stood at its sides, or as the
//! sea; air takes away what is far.

mod block;
mod block_view;
mod camera;
mod paint;
mod relief;
mod scene;
mod sky;

use std::borrow::Cow;

use landform_core::algo::derivative::gradient;
use landform_core::grid::Shape;
use landform_core::parallel;
use landform_core::random::Seed;
use landform_core::terrain::{HeightField, NodeSurface, Refine};

use super::Picture;
use super::colour::{Rgb, blend, scale, to_srgb};
pub(crate) use block_view::BlockView;
use camera::Camera;
use paint::Paint;
use scene::Scene;

/// Where the camera stands and how the picture is made.
#[derive(Clone, Copy, Debug)]
pub struct View {
    /// Columns of the picture.
    pub width: usize,
    /// Rows of the picture.
    pub height: usize,
    /// Compass direction from which the camera looks, radians clockwise from north.
    pub from: f64,
    /// Angle by which the camera looks down, radians.
    pub tilt: f64,
    /// Compass direction of the sun, radians clockwise from north.
    pub sun: f64,
    /// Altitude of the sun, radians.
    pub sun_altitude: f64,
    /// Factor on elevations.
    pub exaggeration: f64,
    /// 1 frames the whole block; more comes closer.
    pub zoom: f64,
    /// Rays a pixel along each side.
    pub samples: usize,
    /// Whether rivers and lakes are drawn.
    pub water: bool,
    /// Level of the sea, m.
    pub sea_level: f64,
    /// Where the eye stands; none for a block that is seen from outside.
    pub standpoint: Option<Standpoint>,
}

/// A standpoint in the land.
///
/// ```
/// use landform_core::grid::{Grid, Shape};
/// use landform_core::terrain::HeightField;
/// use landform_io::render::{Standpoint, View, perspective};
///
/// let hills = (0..400).map(|i| f64::from(i * 7 % 40)).collect();
/// let land = HeightField::new(Grid::new(Shape::new(20, 20), [50.0, 50.0])?, hills)?;
/// let eye = Standpoint { height: Some(30.0), ..Standpoint::default() };
/// let view = View { width: 64, height: 36, standpoint: Some(eye), ..View::default() };
/// assert_eq!(perspective(&land, &view).pixels.len(), 64 * 36);
/// # Ok::<(), landform_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Standpoint {
    /// Place, m from the south-west corner; none for one with a wide view.
    pub at: Option<[f64; 2]>,
    /// Height of the eye over the ground, m; none for one that suits the relief.
    pub height: Option<f64>,
    /// Angle by which the eye looks down, radians; none for one that shows the skyline.
    pub tilt: Option<f64>,
}

impl Default for View {
    fn default() -> Self {
        Self {
            width: 1600,
            height: 900,
            from: 200.0_f64.to_radians(),
            tilt: 26.0_f64.to_radians(),
            sun: 285.0_f64.to_radians(),
            sun_altitude: 32.0_f64.to_radians(),
            exaggeration: 1.0,
            zoom: 1.0,
            samples: 2,
            water: true,
            sea_level: 0.0,
            standpoint: None,
        }
    }
}

/// Colours of the ground alone on every node, without light and shadow.
pub(super) fn ground_colours(field: &HeightField, river: Vec<f64>, sea_level: f64) -> Vec<Rgb> {
    let grid = field.grid();
    let view = View { sea_level, ..View::default() };
    let paint = Paint::new(field, river, block::range(field.elevation()), &view);
    let cols = grid.shape.cols;
    let mut colours = vec![[0.0; 3]; grid.len()];
    parallel::for_rows_mut(&mut colours, cols, |row, colours| {
        let painted = paint.row(grid, row);
        for (col, colour) in colours.iter_mut().enumerate() {
            let i = row * cols + col;
            let z = field.elevation()[i];
            if z.is_finite() {
                *colour = paint.ground(&painted, col, i, z, gradient(grid, field.elevation(), i));
            }
        }
    });
    colours
}

/// Draws a raster in perspective. Nodata is left out as if it lay at the foot of the block.
pub fn perspective(field: &HeightField, view: &View) -> Picture {
    let field = as_fine_as_seen(field, view);
    let scene = Scene::new(&field, view);
    let camera = match &view.standpoint {
        None => Camera::before(&scene.outline(), scene.relief.extent, scene.low, view),
        Some(standpoint) => Camera::within(&scene, view, standpoint),
    };
    let angle = camera.pixel_angle(view.height);
    let shape = Shape::new(view.height.max(1), view.width.max(1));
    let samples = view.samples.clamp(1, 8);
    let pixels = parallel::map(shape.len(), |i| {
        let pixel = shape.cell(i);
        let colour = mean_colour(samples, |s| {
            let seed = Seed(i as u64).with(s as u64);
            let x = pixel.col as f64 + ((s % samples) as f64 + seed.uniform(0)) / samples as f64;
            let y = pixel.row as f64 + ((s / samples) as f64 + seed.uniform(1)) / samples as f64;
            tone(scene.trace(camera.at, camera.ray(x / shape.cols as f64, y / shape.rows as f64), angle))
        });
        // A wide sky would show the steps of eight bits.
        let dither = if view.standpoint.is_some() { 0.012 * (Seed(i as u64).uniform(2) - 0.5) } else { 0.0 };
        to_srgb(scale(colour, 1.0 + dither))
    });
    Picture { shape, pixels }
}

/// Difference of two rays of a pixel, in linear light, up to which they stand for all of its rays.
const ALIKE: f64 = 0.02;

/// Mean colour of a pixel of `samples` by `samples` rays. Two at opposite corners are enough where
/// they are alike.
fn mean_colour(samples: usize, ray: impl Fn(usize) -> Rgb) -> Rgb {
    let all = samples * samples;
    let (first, last) = (ray(0), ray(all - 1));
    if all > 2 && (0..3).any(|k| (first[k] - last[k]).abs() > ALIKE) {
        let sum = (1..all - 1)
            .map(ray)
            .fold([0, 1, 2].map(|k| first[k] + last[k]), |sum, colour| [0, 1, 2].map(|k| sum[k] + colour[k]));
        return scale(sum, 1.0 / all as f64);
    }
    blend(first, last, 0.5)
}

/// Compresses highlights (Reinhard's curve with a white point), so that snow keeps its shading.
fn tone(colour: Rgb) -> Rgb {
    const WHITE: f64 = 2.2;
    colour.map(|v| v * (1.0 + v / (WHITE * WHITE)) / (1.0 + 0.55 * v))
}

/// Nodes a pixel of the picture's width beyond which a raster is coarsened before it is drawn. A
/// block stands askew, two thirds as wide as the picture; from a standpoint one looks closely.
const MOST_NODES_A_PIXEL: [f64; 2] = [1.0, 1.4];

/// The raster, coarsened where its nodes lie closer than the picture could show.
fn as_fine_as_seen<'a>(field: &'a HeightField, view: &View) -> Cow<'a, HeightField> {
    let mut field = Cow::Borrowed(field);
    let pixels = view.width.max(1) as f64 * view.zoom.max(1.0);
    let most = MOST_NODES_A_PIXEL[usize::from(view.standpoint.is_some())] * pixels;
    let is_too_fine = |field: &HeightField| {
        let Shape { rows, cols } = field.grid().shape;
        rows.min(cols) > 64 && rows.max(cols) as f64 > most
    };
    while is_too_fine(&field) {
        match field.coarser() {
            Some(mut coarser) => {
                *coarser.features_mut() = field.features().clone();
                field = Cow::Owned(coarser);
            }
            None => break,
        }
    }
    field
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vector::{self, dot, sub};
    use landform_core::grid::Grid;
    use landform_core::math;

    #[test]
    fn the_frame_holds_the_highest_summit() {
        let grid = Grid::new(Shape::new(40, 60), [10.0, 10.0]).unwrap();
        // One needle at a far corner.
        let z = (0..grid.len()).map(|i| if i == 3 * 60 + 4 { 400.0 } else { 0.0 }).collect();
        let field = HeightField::new(grid, z).unwrap();
        for from in [0.0, 1.0, 2.5, 4.0] {
            let view = View { width: 160, height: 90, from, ..View::default() };
            let scene = Scene::new(&field, &view);
            let camera = Camera::before(&scene.outline(), scene.relief.extent, scene.low, &view);
            for point in scene.outline() {
                let d = sub(point, camera.at);
                let far = dot(d, camera.forward) * camera.half_height;
                let (x, y) = (dot(d, camera.right) / (far * camera.aspect), dot(d, camera.up) / far);
                assert!(x.abs() < 1.0 && y.abs() < 1.0, "from {from}: {point:?} at {x}, {y}");
            }
        }
    }

    /// Ridges across a map, 40 m high at most.
    fn ridges(base: f64) -> HeightField {
        let grid = Grid::new(Shape::new(48, 64), [20.0, 20.0]).unwrap();
        let z = (0..grid.len()).map(|i| base + 20.0 + 20.0 * math::sin(0.4 * (i / 64) as f64 + 0.02 * (i % 64) as f64));
        HeightField::new(grid, z.collect()).unwrap()
    }

    fn within(at: Option<[f64; 2]>, from: f64) -> View {
        let standpoint = Some(Standpoint { at, height: Some(50.0), tilt: None });
        View { width: 96, height: 54, samples: 1, from, standpoint, water: false, ..View::default() }
    }

    #[test]
    fn land_goes_on_to_the_horizon_and_the_sea_does_too() {
        let view = within(Some([640.0, 900.0]), 0.3);
        let land = ridges(100.0);
        let scene = Scene::new(&land, &view);
        let camera = Camera::within(&scene, &view, &view.standpoint.unwrap());
        // A little under the level of the eye all rays meet land, far beyond the 1.3 km of the map.
        for k in 0..20 {
            let ray = camera.ray(f64::from(k) / 20.0, 0.5);
            let down = vector::normalize([ray[0], ray[1], -0.01]);
            let far = scene.distance_within(camera.at, down);
            assert!(far.is_some_and(|far| far > 100.0), "{k}: {far:?}");
        }
        // An island in the sea has no images.
        let grid = ridges(0.0).grid().clone();
        let cone = |i: usize| {
            60.0 - 0.4 * grid.position(i).iter().zip([640.0, 480.0]).map(|(a, b)| (a - b).abs()).sum::<f64>()
        };
        let z: Vec<f64> = (0..grid.len()).map(cone).collect();
        let island = HeightField::new(grid, z).unwrap();
        let scene = Scene::new(&island, &view);
        assert!(scene.is_in_sea());
        let eye = [640.0, 480.0, 90.0];
        assert_eq!(scene.distance_within(eye, vector::normalize([1.0, 0.0, 0.1])), None);
    }

    #[test]
    fn a_view_from_within_shows_land_under_a_sky() {
        for from in [0.0, 1.7, 3.1, 5.0] {
            let picture = perspective(&ridges(300.0), &within(None, from));
            let row = |r: usize| &picture.pixels[r * 96..(r + 1) * 96];
            let is_blue = |p: &&[u8; 3]| p[2] > p[0];
            assert!(row(0).iter().filter(is_blue).count() == 96, "from {from}: sky above");
            assert!(row(53).iter().filter(is_blue).count() < 20, "from {from}: ground below");
            assert_eq!(picture, perspective(&ridges(300.0), &within(None, from)));
        }
    }

    #[test]
    fn strange_ground_and_places_are_drawn() {
        let strip = HeightField::new(Grid::new(Shape::new(1, 5), [10.0, 10.0]).unwrap(), vec![1.0; 5]).unwrap();
        let mut z = ridges(0.0).elevation().to_vec();
        (0..700).for_each(|i| z[i] = f64::NAN);
        let holed = HeightField::new(ridges(0.0).grid().clone(), z).unwrap();
        for field in [strip, holed] {
            for at in [None, Some([-1e6, 1e9]), Some([0.0, 0.0])] {
                assert_eq!(perspective(&field, &within(at, 2.0)).pixels.len(), 96 * 54);
            }
        }
    }
}
