//! Colours that ground has by its slope and height, wherever it is drawn in perspective.

use landform_core::math;
use landform_core::terrain::{HeightField, NodeSurface};

pub(crate) use super::cover::SAND;

/// Colours of the ground: each a pair between which patches vary, sRGB.
pub(crate) const MEADOW: [u32; 2] = [0x59693c, 0x7d7d50];
pub(crate) const HEATH: [u32; 2] = [0x7a7056, 0x92856c];
pub(crate) const FOREST: [u32; 2] = [0x2f3f28, 0x465634];
pub(crate) const ROCK: [u32; 2] = [0x7d736a, 0x9d948a];
pub(crate) const SNOW: u32 = 0xdfe4ea;
/// Deep water.
pub(crate) const DEEP: u32 = 0x1f4e6b;
/// Clear water over a shallow floor.
pub(crate) const LAGOON: u32 = 0x3fa3ad;
/// Depth over which clear water becomes deep, m.
pub(crate) const DEEPENS: f64 = 40.0;
/// Plain rock of a cut side, under soil and far below.
pub(crate) const CUT: [u32; 2] = [0x857a6e, 0x6d645b];
/// The sky overhead and at the horizon.
pub(crate) const SKY: [u32; 2] = [0x8fb2d6, 0xe6ebee];
/// Parts of the relief between which meadows become heath.
pub(crate) const HEATH_BEGINS: [f64; 2] = [0.18, 0.55];
/// Slopes between which rock shows, rise over run.
pub(crate) const ROCK_BEGINS: [f64; 2] = [0.30, 0.75];
/// Slopes between which snow slides off, rise over run.
pub(crate) const SNOW_ENDS: [f64; 2] = [0.7, 1.2];

/// Part of the relief (m) above which snow lies: the lower the land, the nearer to its top.
pub(crate) fn snow_line(relief: f64) -> f64 {
    math::lerp(1.1, 0.72, math::smoothstep(800.0, 1800.0, relief))
}

/// Level from which heights are counted in land between two levels, m: the sea's, where it rises
/// from it.
pub(crate) fn low_land(low: f64, high: f64, sea: f64) -> f64 {
    if low < sea && high > sea { sea } else { low }
}

/// Whether the sea stands over ground between two levels, m: where some rises from it, and wherever
/// there are corals.
pub(crate) fn has_sea(field: &HeightField, (low, high): (f64, f64), sea: f64) -> bool {
    low < sea && (high > sea || has_coral(field))
}

/// Whether corals grew on the ground.
pub(crate) fn has_coral(field: &HeightField) -> bool {
    field.depth("coral").is_some()
}

/// Whether loose sand lies on the ground.
pub(crate) fn is_desert(field: &HeightField) -> bool {
    field.depth("sand").is_some()
}
