//! What lies on the ground: sand and snow.

use landform_core::field::{Key, names};
use landform_core::math;
use landform_core::terrain::{HeightField, NodeSurface};

use super::colour::{Rgb, hex, mix};

/// Sand and snow of a raster, as pictures show them.
#[derive(Clone, Debug, Default)]
pub(super) struct Cover {
    sand: Vec<f64>,
    snow: Vec<f64>,
    cell: f64,
}

const SAND: u32 = 0xd9b482;
const GRAVEL: u32 = 0x9c8567;
const SNOW: u32 = 0xe9edf3;

impl Cover {
    /// What lies on a raster.
    pub(super) fn of(field: &HeightField) -> Self {
        let depth = |key: &Key<f64>| field.fields().get(key, "").map(<[f64]>::to_vec).unwrap_or_default();
        let [dx, dy] = field.grid.spacing;
        Self { sand: depth(&names::SAND_DEPTH), snow: depth(&names::SNOW_DEPTH), cell: dx.min(dy) }
    }

    /// Whether the ground is a desert, where no water stands or runs.
    pub(super) fn is_desert(&self) -> bool {
        !self.sand.is_empty()
    }

    /// How much of a node sand covers, 0 to 1.
    fn sand(&self, i: usize) -> f64 {
        math::smoothstep(0.02, 0.25, self.sand[i] / self.cell)
    }

    /// How much of a node snow covers, 0 to 1.
    fn snow(&self, i: usize) -> f64 {
        math::smoothstep(0.02, 0.4, self.snow[i])
    }

    /// The colour of a node under what lies on it. `strength` of the desert's colours against the ground's own.
    pub(super) fn tint(&self, colour: Rgb, i: usize, strength: f64) -> Rgb {
        let mut colour = colour;
        if !self.sand.is_empty() {
            colour = mix(mix(colour, hex(GRAVEL), 0.85 * strength), mix(colour, hex(SAND), strength), self.sand(i));
        }
        if !self.snow.is_empty() {
            colour = mix(colour, hex(SNOW), self.snow(i));
        }
        colour
    }
}
