//! Pictures in the page.

use base64::Engine;
use landform_core::Result;
use landform_core::algo::derivative::{position_index, quadratic, slope};
use landform_core::algo::flow::{Flow, node_areas};
use landform_core::analysis::{Density, Drawings, SPECTRUM_PLOT};
use landform_core::field::Values;
use landform_core::grid::Shape;
use landform_core::terrain::{HeightField, Interpolation, NodeSurface, resample};
use landform_core::{math, parallel};
use std::borrow::Cow;

use crate::format::encode_png;
use crate::render::{MapStyle, Picture, Ramp, View, field_map, perspective, shaded_map, value_picture};

const WIDTH: usize = 1100;
const SMALL: usize = 520;
/// More nodes than this along a side cost time and show nothing in a picture.
const MOST_SIDE: usize = 1600;

/// The raster, or means of it if it has more nodes than a picture can show.
pub(super) fn shrunk(raster: &HeightField) -> Result<Cow<'_, HeightField>> {
    shrunk_to(raster, MOST_SIDE)
}

fn shrunk_to(raster: &HeightField, most: usize) -> Result<Cow<'_, HeightField>> {
    let shape = raster.grid().shape;
    let longer = shape.rows.max(shape.cols);
    if longer <= most {
        return Ok(Cow::Borrowed(raster));
    }
    let part = |n: usize| (n * most / longer).max(2);
    let grid = raster.grid().with_shape(part(shape.rows), part(shape.cols))?;
    resample(raster, &grid, Interpolation::Linear).map(Cow::Owned)
}

pub(super) fn figure(picture: &Picture, caption: &str) -> Result<String> {
    let png = encode_png(&picture.pixels, picture.shape)?;
    let data = base64::engine::general_purpose::STANDARD.encode(png);
    Ok(format!(
        "<figure><img width=\"{}\" height=\"{}\" alt=\"{caption}\" src=\"data:image/png;base64,{data}\"><figcaption>{caption}</figcaption></figure>",
        picture.shape.cols, picture.shape.rows
    ))
}

pub(super) fn perspective_figure(raster: &HeightField) -> Result<String> {
    let view = View { width: WIDTH, height: WIDTH * 9 / 16, ..View::default() };
    figure(
        &perspective(raster, &view),
        "Perspective view from the south-south-west, sun in the west-north-west, no exaggeration.",
    )
}

pub(super) fn map_figure(raster: &HeightField) -> Result<String> {
    let style = MapStyle { size: WIDTH, ..MapStyle::default() };
    figure(&shaded_map(raster, &style)?, "Shaded relief with rivers and lakes; north is up.")
}

/// The plane of wave numbers.
pub(super) fn spectrum_figure(drawings: Option<&Drawings>) -> Result<String> {
    let Some(values) = drawings.and_then(|d| d.spectrum.as_ref()) else { return Ok(String::new()) };
    figure(
        &plot_picture(values),
        "Density of relief over the plane of wave numbers, density and radius logarithmic: long waves in the middle, north up. Self-affine ground is an even cone; streaks are directions, crosses and lattices are traces of a grid.",
    )
}

fn plot_picture(values: &[f64]) -> Picture {
    value_picture(Shape::new(SPECTRUM_PLOT, SPECTRUM_PLOT), values, Ramp::Dusk)
}

/// The plane of wave numbers as a picture.
pub(crate) fn spectrum_picture(density: &Density) -> Picture {
    plot_picture(&density.log_plot(SPECTRUM_PLOT))
}

/// Maps of what follows from the ground: name, caption, values, style.
fn fields(raster: &HeightField) -> Vec<(&'static str, &'static str, Vec<f64>, MapStyle)> {
    let (grid, z) = (raster.grid(), raster.elevation());
    let style = MapStyle { size: SMALL, ramp: Ramp::Dusk, ..MapStyle::default() };
    let degrees = slope(grid, z);
    let degrees = parallel::map(degrees.len(), |i| math::atan(degrees[i]).to_degrees());
    let domain = raster.domain();
    let (mut flow, mut area) = (Flow::new(), node_areas(&*domain));
    flow.route(&*domain, z, &mut area);
    parallel::update(&mut area, |i, a| *a = if z[i].is_nan() { f64::NAN } else { *a });
    let radius = (grid.shape.rows.min(grid.shape.cols) / 40).max(2);
    // Curvature has long tails: its cube root shows what is in between.
    let bend = |v: f64| v.signum() * math::pow(v.abs(), 1.0 / 3.0);
    vec![
        ("slope", "Slope, degrees: dark is level.", degrees, style),
        (
            "drainage_area",
            "Drainage area, logarithmic.",
            area,
            MapStyle { logarithmic: true, ramp: Ramp::Water, ..style },
        ),
        (
            "plan_curvature",
            "Curvature of contours: bright spurs, dark hollows.",
            parallel::map(z.len(), |i| bend(quadratic(grid, z, i).plan_curvature().clamp(-0.2, 0.2))),
            MapStyle { ramp: Ramp::Grey, ..style },
        ),
        (
            "position_index",
            "Elevation against the mean around: bright ridges, dark valleys.",
            position_index(grid.shape, z, radius),
            style,
        ),
    ]
}

pub(super) fn field_figures(raster: &HeightField) -> Result<String> {
    let list = fields(raster);
    // Shading costs more than anything else: it is done on as many nodes as are shown.
    let mut carrier = raster.clone();
    for (name, _, values, _) in &list {
        carrier.fields.insert_values(name, Values::F64(values.clone()))?;
    }
    let shown = shrunk_to(&carrier, SMALL * 5 / 4)?;
    let figures = list
        .iter()
        .map(|(name, caption, _, style)| figure(&field_map(&shown, &shown.real(name, "the report")?, style)?, caption))
        .collect::<Result<Vec<_>>>()?;
    Ok(format!("<div class=\"plots\">{}</div>", figures.concat()))
}

/// The maps as pictures of their own: name and picture.
pub(crate) fn field_pictures(raster: &HeightField) -> Result<Vec<(&'static str, Picture)>> {
    let small = shrunk(raster)?;
    let mut list = vec![("map", shaded_map(&small, &MapStyle::default())?)];
    for (name, _, values, style) in fields(&small) {
        list.push((name, field_map(&small, &values, &MapStyle { size: 1400, ..style })?));
    }
    Ok(list)
}
