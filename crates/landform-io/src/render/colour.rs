//! Colour: linear light, Oklab, ramps.
//!
//! # Sources
//! Ottosson (2020), Oklab. The stops of the ramps are our own; each rises steadily in lightness
//! where it shows a quantity.

use std::sync::LazyLock;

use landform_core::math::{cbrt, lerp, pow};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Linear red, green, blue.
pub(super) type Rgb = [f64; 3];

/// A colour ramp.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Ramp {
    /// Green lowlands to bare heights; blue below sea level.
    #[default]
    Terrain,
    /// Dark blue over green to yellow: any quantity.
    Dusk,
    /// White to deep blue: water.
    Water,
    /// Black to white.
    Grey,
}

const TERRAIN: &[u32] = &[0x5f7a4f, 0x87965b, 0xb0a871, 0xbfa379, 0xb1957b, 0xac9a8a, 0xb5aaa0, 0xc9c3bc];
const DUSK: &[u32] = &[0x1b1f4b, 0x2b4a73, 0x2f7484, 0x4c9a80, 0x93b966, 0xe2d05f, 0xfdf3b0];
const WATER: &[u32] = &[0xf4f6f4, 0xc8dde6, 0x8fbcd6, 0x5692c0, 0x2f67a1, 0x1c3f74, 0x0f2148];
const GREY: &[u32] = &[0x101010, 0xf8f8f8];
const SEA: &[u32] = &[0x9cc3d3, 0x6fa3c0, 0x487fa8, 0x2d5c8a, 0x1d3f69, 0x132a4a];

impl Ramp {
    /// Colour at `t` from 0 to 1.
    pub(super) fn at(self, t: f64) -> Rgb {
        let stops = match self {
            Self::Terrain => TERRAIN,
            Self::Dusk => DUSK,
            Self::Water => WATER,
            Self::Grey => GREY,
        };
        along(stops, t)
    }
}

/// Colour of the sea floor seen through water: 0 at the shore, 1 at the deepest.
pub(super) fn sea(t: f64) -> Rgb {
    along(SEA, t)
}

fn along(stops: &[u32], t: f64) -> Rgb {
    let x = t.clamp(0.0, 1.0) * (stops.len() - 1) as f64;
    let k = (x as usize).min(stops.len() - 2);
    mix(hex(stops[k]), hex(stops[k + 1]), x - k as f64)
}

/// Linear colour of an sRGB hex code.
pub(super) fn hex(code: u32) -> Rgb {
    [16, 8, 0].map(|shift| from_srgb(f64::from(code >> shift & 0xff) / 255.0))
}

fn from_srgb(v: f64) -> f64 {
    if v <= 0.04045 { v / 12.92 } else { pow((v + 0.055) / 1.055, 2.4) }
}

/// 8-bit sRGB of a linear colour.
pub(super) fn to_srgb(colour: Rgb) -> [u8; 3] {
    static SCALE: LazyLock<SrgbScale> = LazyLock::new(SrgbScale::new);
    let scale = &*SCALE;
    colour.map(|v| scale.nearest(v))
}

/// Light at which each of the 8-bit steps begins: a power for each pixel would cost more than to
/// look it up.
struct SrgbScale {
    begins: [f64; 256],
    /// The step at the beginning of each of equal parts of the light.
    guess: [u8; SrgbScale::PARTS + 1],
}

impl SrgbScale {
    const PARTS: usize = 2048;

    fn new() -> Self {
        let begins = std::array::from_fn(|k| from_srgb((k as f64 - 0.5) / 255.0));
        let guess = std::array::from_fn(|part| {
            let light = part as f64 / Self::PARTS as f64;
            (begins.partition_point(|b| *b <= light) - 1) as u8
        });
        Self { begins, guess }
    }

    fn nearest(&self, light: f64) -> u8 {
        let light = light.clamp(0.0, 1.0);
        let mut step = self.guess[(light * Self::PARTS as f64) as usize];
        while step < 255 && self.begins[usize::from(step) + 1] <= light {
            step += 1;
        }
        step
    }
}

/// Mixture in Oklab, even to the eye.
pub(super) fn mix(a: Rgb, b: Rgb, t: f64) -> Rgb {
    let (a, b) = (to_oklab(a), to_oklab(b));
    from_oklab([0, 1, 2].map(|k| lerp(a[k], b[k], t.clamp(0.0, 1.0))))
}

/// A linear colour in Oklab, where colours are mixed by plain means.
pub(super) fn to_oklab([r, g, b]: Rgb) -> Rgb {
    let l = root(0.412_221_470_8 * r + 0.536_332_536_3 * g + 0.051_445_992_9 * b);
    let m = root(0.211_903_498_2 * r + 0.680_699_545_1 * g + 0.107_396_956_6 * b);
    let s = root(0.088_302_461_9 * r + 0.281_718_837_6 * g + 0.629_978_700_5 * b);
    [
        0.210_454_255_3 * l + 0.793_617_785_0 * m - 0.004_072_046_8 * s,
        1.977_998_495_1 * l - 2.428_592_205_0 * m + 0.450_593_709_9 * s,
        0.025_904_037_1 * l + 0.782_771_766_2 * m - 0.808_675_766_0 * s,
    ]
}

fn root(v: f64) -> f64 {
    cbrt(v.max(0.0))
}

/// The linear colour of one in Oklab.
pub(super) fn from_oklab([lightness, a, b]: Rgb) -> Rgb {
    let cube = |v: f64| v * v * v;
    let l = cube(lightness + 0.396_337_777_4 * a + 0.215_803_757_3 * b);
    let m = cube(lightness - 0.105_561_345_8 * a - 0.063_854_172_8 * b);
    let s = cube(lightness - 0.089_484_177_5 * a - 1.291_485_548_0 * b);
    [
        4.076_741_662_1 * l - 3.307_711_591_3 * m + 0.230_969_929_2 * s,
        -1.268_438_004_6 * l + 2.609_757_401_1 * m - 0.341_319_396_5 * s,
        -0.004_196_086_3 * l - 0.703_418_614_7 * m + 1.707_614_701_0 * s,
    ]
    .map(|v| v.max(0.0))
}

/// Plain mixture of light.
pub(super) fn blend(a: Rgb, b: Rgb, t: f64) -> Rgb {
    [0, 1, 2].map(|k| lerp(a[k], b[k], t))
}

/// A colour times a factor.
pub(super) fn scale(a: Rgb, f: f64) -> Rgb {
    a.map(|v| v * f)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn srgb_and_oklab_go_there_and_back() {
        for code in [0x000000, 0xffffff, 0x5f7a4f, 0x1b1f4b, 0xff0000] {
            let colour = hex(code);
            let back = to_srgb(from_oklab(to_oklab(colour)));
            let expected = [16, 8, 0].map(|s| (code >> s & 0xff) as u8);
            assert!(back.iter().zip(expected).all(|(a, b)| a.abs_diff(b) <= 1), "{code:x} {back:?}");
        }
    }

    #[test]
    fn steps_of_srgb_are_those_of_the_formula() {
        for k in 0..=100_000 {
            let v = f64::from(k) / 100_000.0;
            let s = if v <= 0.003_130_8 { 12.92 * v } else { 1.055 * pow(v, 1.0 / 2.4) - 0.055 };
            assert_eq!(to_srgb([v, 0.0, 0.0])[0], (s * 255.0 + 0.5) as u8, "{v}");
        }
        assert_eq!(to_srgb([-1.0, 7.0, f64::NAN]), [0, 255, 0]);
    }

    #[test]
    fn ramps_rise_steadily_in_lightness() {
        for ramp in [Ramp::Dusk, Ramp::Grey] {
            let lightness: Vec<f64> = (0..=50).map(|k| to_oklab(ramp.at(f64::from(k) / 50.0))[0]).collect();
            assert!(lightness.windows(2).all(|w| w[1] > w[0]));
        }
    }
}
