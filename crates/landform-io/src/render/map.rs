//! The map: shaded relief in a colour ramp, with rivers and lakes; and maps of any field.

use landform_core::algo::derivative::hillshade;
use landform_core::field::names;
use landform_core::grid::{Grid, Shape};
use landform_core::terrain::{HeightField, NodeSurface};
use landform_core::{Result, math, parallel};

use super::colour::{Rgb, blend, hex, mix, scale, sea, to_srgb};
use super::cover::Cover;
use super::ground::has_sea;
use super::label::short;
use super::light::sky_view;
use super::perspective::ground_colours;
use super::{Picture, Ramp, Waters, waters};

/// How a map is drawn.
#[derive(Clone, Copy, Debug)]
pub struct MapStyle {
    /// Longer side, pixels.
    pub size: usize,
    /// Colour ramp.
    pub ramp: Ramp,
    /// Logarithmic scale, for fields such as drainage area.
    pub logarithmic: bool,
    /// Whether rivers and lakes are drawn.
    pub water: bool,
    /// Level of the sea, m.
    pub sea_level: f64,
}

impl Default for MapStyle {
    fn default() -> Self {
        Self { size: 1400, ramp: Ramp::Terrain, logarithmic: false, water: true, sea_level: 0.0 }
    }
}

const RIVER: u32 = 0x3f74a8;
const LAKE: u32 = 0x5b93bd;
const DEEP: u32 = 0x2f6494;
const NOTHING: u32 = 0xe9e7e2;
const UNCHANGED: u32 = 0xe2dfd9;
const LOST: u32 = 0x2b5d9e;
const GAINED: u32 = 0xb23a2c;

/// Shaded relief coloured by elevation.
///
/// # Errors
/// Where [`HeightField::new`] fails.
pub fn shaded_map(field: &HeightField, style: &MapStyle) -> Result<Picture> {
    let (grid, z) = (field.grid(), field.elevation());
    let (lo, hi) = range(z);
    let level = style.sea_level;
    let has_sea = has_sea(field, (lo, hi), level);
    let shade = relief(grid, z, hi - lo);
    let water = style.water.then(|| waters(field));
    let land_low = if has_sea { level } else { lo };
    let cover = Cover::of(field);
    let has_depth = field.fields().get(&names::WATER_DEPTH, "").is_ok();
    let colours = parallel::map(z.len(), |i| {
        if z[i].is_nan() {
            return hex(NOTHING);
        }
        let under_sea = has_sea && z[i] < level && !(has_depth && water.as_ref().is_some_and(|w| w.lake[i] > 0.0));
        let mut colour = if under_sea {
            cover.through_water(sea(((z[i] - level) / (lo - level)).sqrt()), i, level - z[i])
        } else {
            let height = (z[i] - land_low) / (hi - land_low).max(1e-9);
            // Of the ramp a little stays, lighter upwards.
            let ground = style.ramp.at(if cover.is_desert() { 0.45 + 0.5 * height } else { height });
            cover.tint(ground, i, 0.7)
        };
        colour = scale(colour, if under_sea { 0.5 + 0.5 * shade[i] } else { shade[i] });
        if let Some(water) = &water
            && !under_sea
        {
            if water.lake[i] > 0.0 {
                // Deeper is darker, up to some metres.
                let deep = math::smoothstep(0.0, 12.0, water.lake[i]);
                colour = mix(hex(LAKE), hex(DEEP), if has_depth { deep } else { 0.0 });
            } else if water.river[i] > 0.0 {
                colour = mix(colour, hex(RIVER), water.river[i]);
            }
        }
        colour
    });
    Ok(paint(grid.shape, &colours, style.size))
}

/// The colours of the ground from above, without light and shadow, with rivers, lakes and the sea.
pub(crate) fn colour_map(field: &HeightField, target: Shape, sea_level: Option<f64>) -> Picture {
    let (lo, _) = range(field.elevation());
    let Waters { lake, river } = waters(field);
    let mut colours = ground_colours(field, river, sea_level.unwrap_or(lo.min(0.0)));
    let z = field.elevation();
    parallel::update(&mut colours, |i, colour| {
        if z[i].is_nan() {
            *colour = hex(NOTHING);
        } else if sea_level.is_some_and(|sea| z[i] < sea) || lake[i] > 0.0 {
            *colour = hex(DEEP);
        }
    });
    let shape = field.grid().shape;
    let zoom = [target.rows as f64 / shape.rows as f64, target.cols as f64 / shape.cols as f64];
    stretched(shape, &colours, target, zoom)
}

/// Any field in a colour ramp over faint relief. On a logarithmic ramp zeros have the lowest
/// colour, and so has the lowest hundredth of what is above zero.
///
/// # Errors
/// Where [`HeightField::new`] fails.
pub fn field_map(field: &HeightField, values: &[f64], style: &MapStyle) -> Result<Picture> {
    Ok(ranged_field_map(field, values, style)?.0)
}

/// As [`field_map`], with a legend: what is shown, and the values at the ends of the ramp.
pub(crate) fn field_map_with_legend(
    field: &HeightField,
    values: &[f64],
    title: &str,
    style: &MapStyle,
) -> Result<Picture> {
    let (mut picture, (low, high)) = ranged_field_map(field, values, style)?;
    if low > high {
        return Ok(picture);
    }
    if style.logarithmic && values.iter().any(|&v| v > 0.0) {
        // The lowest colour is that of all that is less, too.
        let [least, most] = [low, high].map(|v| short(math::pow(10.0, v)));
        picture.legend(&format!("{title}, log"), style.ramp, [format!("<={least}"), most]);
    } else {
        let ends = if style.logarithmic { [0.0; 2] } else { [low, high] };
        picture.legend(title, style.ramp, ends.map(short));
    }
    Ok(picture)
}

fn ranged_field_map(field: &HeightField, values: &[f64], style: &MapStyle) -> Result<(Picture, (f64, f64))> {
    let (lo, hi) = range(field.elevation());
    let shade = relief(field.grid(), field.elevation(), hi - lo);
    let scaled = if style.logarithmic { logarithms(values) } else { values.to_vec() };
    let (a, b) = range(&scaled);
    let colours = parallel::map(scaled.len(), |i| {
        if scaled[i].is_nan() {
            return hex(NOTHING);
        }
        scale(style.ramp.at((scaled[i] - a) / (b - a).max(1e-300)), 0.75 + 0.25 * shade[i])
    });
    Ok((paint(field.grid().shape, &colours, style.size), (a, b)))
}

/// Decadic logarithms, cut off below at the first percentile of what is above zero.
fn logarithms(values: &[f64]) -> Vec<f64> {
    let mut positive: Vec<f64> = values.iter().copied().filter(|&v| v > 0.0 && v.is_finite()).collect();
    parallel::sort_by(&mut positive, f64::total_cmp);
    let least = positive.get(positive.len() / 100).copied().unwrap_or(1.0);
    values.iter().map(|&v| if v.is_nan() { v } else { math::log10(v.max(least)) }).collect()
}

/// Heights in m gained (red) and lost (blue) over grey relief; colours are as strong as the amount
/// against its 99th percentile.
///
/// # Errors
/// Where [`HeightField::new`] fails.
pub fn difference_map(field: &HeightField, difference: &[f64], size: usize) -> Result<Picture> {
    let (lo, hi) = range(field.elevation());
    let shade = relief(field.grid(), field.elevation(), hi - lo);
    let mut amounts: Vec<f64> = difference.iter().filter(|d| d.abs() > 0.0).map(|d| d.abs()).collect();
    parallel::sort_by(&mut amounts, f64::total_cmp);
    let strong = amounts.get(amounts.len() * 99 / 100).copied().unwrap_or(1.0);
    let colours = parallel::map(difference.len(), |i| {
        if difference[i].is_nan() {
            return hex(NOTHING);
        }
        let t = (difference[i].abs() / strong).min(1.0).sqrt();
        let colour = mix(hex(UNCHANGED), hex(if difference[i] < 0.0 { LOST } else { GAINED }), t);
        scale(colour, 0.45 + 0.55 * shade[i])
    });
    Ok(paint(field.grid().shape, &colours, size))
}

/// Values as a picture of their own shape, one pixel each, from the least to the greatest.
pub fn value_picture(shape: Shape, values: &[f64], ramp: Ramp) -> Picture {
    let (lo, hi) = range(values);
    let pixels = parallel::map(values.len(), |i| {
        if values[i].is_nan() {
            to_srgb(hex(NOTHING))
        } else {
            to_srgb(ramp.at((values[i] - lo) / (hi - lo).max(1e-300)))
        }
    });
    Picture { shape, pixels }
}

fn range(values: &[f64]) -> (f64, f64) {
    let range = |(a, b): (f64, f64), &v: &f64| (a.min(v), b.max(v));
    values.iter().filter(|v| v.is_finite()).fold((f64::INFINITY, f64::NEG_INFINITY), range)
}

/// Shading about 1: light from the north-west with a weaker one from the west and the north, dimmed
/// in valleys. Gentle relief is exaggerated until it shows.
fn relief(grid: &Grid, z: &[f64], height: f64) -> Vec<f64> {
    let extent = grid.extent()[0].max(grid.extent()[1]).max(grid.spacing[0]);
    let exaggeration = (0.12 * extent / height.max(1e-9)).clamp(1.0, 20.0);
    let tall: Vec<f64> = z.iter().map(|v| v * exaggeration).collect();
    let light = |azimuth: f64| hillshade(grid, z, azimuth.to_radians(), 42.0_f64.to_radians(), exaggeration);
    let (north_west, west, north) = (light(315.0), light(270.0), light(0.0));
    let sky = sky_view(grid, &tall);
    let level = math::sin(42.0_f64.to_radians());
    parallel::map(z.len(), |i| {
        let direct = (0.6 * north_west[i] + 0.2 * west[i] + 0.2 * north[i]) / level;
        (0.25 + 0.75 * direct) * (0.35 + 0.65 * sky[i])
    })
}

/// Node colours as a picture whose longer side has `size` pixels: bilinear when growing, mean when
/// shrinking.
fn paint(shape: Shape, colours: &[Rgb], size: usize) -> Picture {
    let longer = shape.rows.max(shape.cols) as f64;
    let zoom = size.max(1) as f64 / longer;
    let pixels_of = |n: usize| ((n as f64 * zoom).round() as usize).max(1);
    let target = Shape::new(pixels_of(shape.rows), pixels_of(shape.cols));
    stretched(shape, colours, target, [zoom; 2])
}

/// Node colours as a picture with `zoom` pixels a row and a column.
fn stretched(shape: Shape, colours: &[Rgb], target: Shape, zoom: [f64; 2]) -> Picture {
    let taps = zoom.map(|zoom| (1.0 / zoom).ceil().clamp(1.0, 16.0) as usize);
    let at = |r: f64, c: f64| {
        let (r, c) = (r.clamp(0.0, (shape.rows - 1) as f64), c.clamp(0.0, (shape.cols - 1) as f64));
        let (r0, c0) = (r as usize, c as usize);
        let (r1, c1) = ((r0 + 1).min(shape.rows - 1), (c0 + 1).min(shape.cols - 1));
        let (fr, fc) = (r - r0 as f64, c - c0 as f64);
        let row = |r: usize| blend(colours[shape.index(r, c0)], colours[shape.index(r, c1)], fc);
        blend(row(r0), row(r1), fr)
    };
    let pixels = parallel::map(target.len(), |i| {
        let pixel = target.cell(i);
        let mut sum = [0.0; 3];
        for a in 0..taps[0] {
            for b in 0..taps[1] {
                let part =
                    |n: usize, tap: usize, k: usize| (n as f64 + (tap as f64 + 0.5) / taps[k] as f64) / zoom[k] - 0.5;
                let colour = at(part(pixel.row, a, 0), part(pixel.col, b, 1));
                sum = [0, 1, 2].map(|k| sum[k] + colour[k]);
            }
        }
        to_srgb(scale(sum, 1.0 / (taps[0] * taps[1]) as f64))
    });
    Picture { shape: target, pixels }
}

#[cfg(test)]
mod tests {
    use super::super::{View, perspective};
    use super::*;

    #[test]
    fn the_sea_stands_at_its_level() {
        let at = |shift: f64| {
            let hills = (0..900).map(|i| 40.0 * math::sin(0.3 * f64::from(i % 30)) + f64::from(i / 30) - shift);
            HeightField::new(Grid::new(Shape::new(30, 30), [16.0, 16.0]).unwrap(), hills.collect()).unwrap()
        };
        let map = |shift: f64, sea_level: f64| {
            shaded_map(&at(shift), &MapStyle { size: 60, sea_level, ..MapStyle::default() }).unwrap()
        };
        let view = |shift: f64, sea_level: f64| {
            perspective(&at(shift), &View { width: 96, height: 54, sea_level, ..View::default() })
        };
        for draw in [&map as &dyn Fn(f64, f64) -> Picture, &view] {
            // Metres are added without rounding.
            let (lower, higher) = (draw(32.0, 0.0), draw(0.0, 32.0));
            let far = |(a, b): (&[u8; 3], &[u8; 3])| (0..3).any(|k| a[k].abs_diff(b[k]) > 2);
            let differ = lower.pixels.iter().zip(&higher.pixels).filter(|p| far(*p)).count();
            assert!(50 * differ < lower.pixels.len(), "{differ} of {}", lower.pixels.len());
            assert!(draw(0.0, 0.0) != higher);
        }
    }

    #[test]
    fn zeros_do_not_stretch_a_logarithmic_ramp() {
        let values: Vec<f64> = (0..1000).map(|i| if i < 15 { 0.0 } else { f64::from(i) }).collect();
        let (lo, hi) = range(&logarithms(&values));
        assert!(lo > 1.0 && hi < 3.0, "{lo} {hi}");
        assert_eq!(range(&logarithms(&[0.0, 0.0])), (0.0, 0.0));
    }
}
