//! Colours of the ground.

use landform_core::algo::derivative::Gradient;
use landform_core::algo::noise::{Basis, Fractal, FractalKind};
use landform_core::grid::Grid;
use landform_core::math;
use landform_core::random::Seed;
use landform_core::terrain::HeightField;

use super::View;
use crate::render::colour::{Rgb, blend, from_oklab, hex, to_oklab};
use crate::render::cover::Cover;
use crate::render::ground;

/// Colours of the ground: each a pair between which patches vary, in Oklab, so that a node's colour
/// is a few plain means.
struct Inks {
    meadow: [Rgb; 2],
    heath: [Rgb; 2],
    forest: [Rgb; 2],
    rock: [Rgb; 2],
    snow: Rgb,
    river: Rgb,
}

impl Inks {
    fn new() -> Self {
        let ink = |code: u32| to_oklab(hex(code));
        Self {
            meadow: ground::MEADOW.map(ink),
            heath: ground::HEATH.map(ink),
            forest: ground::FOREST.map(ink),
            rock: ground::ROCK.map(ink),
            snow: ink(ground::SNOW),
            river: ink(0x35617f),
        }
    }
}

/// What the ground's colours follow.
pub(super) struct Paint {
    inks: Inks,
    river: Vec<f64>,
    cover: Cover,
    low: f64,
    relief: f64,
    exaggeration: f64,
}

/// Noise on a row of nodes, which paint follows.
pub(super) struct PaintedRow {
    patches: Vec<f64>,
    stands: Vec<f64>,
}

impl Paint {
    /// `river` as [`waters`](crate::render::waters) has it; empty where none are drawn.
    pub(super) fn new(field: &HeightField, river: Vec<f64>, (lo, hi): (f64, f64), view: &View) -> Self {
        let (exaggeration, low) = (view.exaggeration, ground::low_land(lo, hi, view.sea_level));
        Self {
            inks: Inks::new(),
            river,
            cover: Cover::of(field),
            low: low * exaggeration,
            relief: ((hi - low) * exaggeration).max(1e-9),
            exaggeration,
        }
    }

    /// Whether sand lies on the ground.
    pub(super) fn is_desert(&self) -> bool {
        self.cover.is_desert()
    }

    /// How rough a node is up close: 1, and less under sand and snow.
    pub(super) fn roughness(&self, i: usize) -> f64 {
        1.0 - 0.8 * self.cover.smooth(i)
    }

    /// Patches of ground (about -1 to 1) and stands of trees on a row of a raster; no stands in a
    /// desert.
    pub(super) fn row(&self, grid: &Grid, row: usize) -> PaintedRow {
        let cols = grid.shape.cols;
        let size = grid.extent()[0].max(grid.extent()[1]).max(1e-9);
        let noise = |waves: f64, seed: u64, octaves: u32, lacunarity: f64, gain: f64| {
            let fractal = Fractal { basis: Basis::Perlin, kind: FractalKind::Fbm, octaves, lacunarity, gain };
            let places = (0..cols).map(|col| grid.position(row * cols + col));
            let (xs, ys): (Vec<f64>, Vec<f64>) = places.map(|[x, y]| (waves * x / size, waves * y / size)).unzip();
            let mut noise = vec![0.0; cols];
            fractal.along(Seed(seed), &xs, &ys, &mut noise);
            noise
        };
        let stands =
            if self.is_desert() || self.cover.has_objects() { Vec::new() } else { noise(60.0, 5, 6, 2.1, 0.7) };
        PaintedRow { patches: noise(24.0, 3, 5, 2.0, 0.55), stands }
    }

    /// The colour of a node at `z` of the given slope, whose place in its row is `col`.
    pub(super) fn ground(&self, row: &PaintedRow, col: usize, i: usize, z: f64, gradient: Gradient) -> Rgb {
        let (patch, stands) = (row.patches[col], row.stands.get(col));
        let slope = gradient.slope() / self.exaggeration;
        let height = (z - self.low) / self.relief + 0.07 * patch;
        let mean = |a: Rgb, b: Rgb, t: f64| blend(a, b, t.clamp(0.0, 1.0));
        let patched = |[a, b]: [Rgb; 2], strength: f64| mean(a, b, 0.5 + strength * patch);
        let Inks { meadow, heath, forest, rock, snow: white, river: blue } = &self.inks;
        let ([heath_from, heath_to], [rock_from, rock_to]) = (ground::HEATH_BEGINS, ground::ROCK_BEGINS);
        let mut colour =
            mean(patched(*meadow, 0.8), patched(*heath, 0.7), math::smoothstep(heath_from, heath_to, height));
        if let Some(stands) = stands {
            // Trees like the shade, and leave heights and the steepest ground.
            let shady = (-gradient.y / self.exaggeration).clamp(-0.6, 0.6);
            let room = 0.43 + 0.6 * stands + 0.6 * patch + 0.7 * shady - 1.3 * math::smoothstep(0.40, 0.72, height);
            let share = math::smoothstep(0.2, 0.75, room - math::smoothstep(0.75, 1.2, slope));
            colour = mean(colour, patched(*forest, 0.8), 0.9 * share);
        }
        let steep = math::smoothstep(rock_from, rock_to, slope + 0.12 * patch + 0.3 * (height - 0.35).max(0.0));
        colour = mean(colour, patched(*rock, 0.8), steep);
        let line = ground::snow_line(self.relief / self.exaggeration);
        let snow = math::smoothstep(line - 0.02, line + 0.1, height)
            * (1.0 - math::smoothstep(ground::SNOW_ENDS[0], ground::SNOW_ENDS[1], slope + 0.2 * patch));
        colour = mean(colour, *white, snow);
        let river = self.river.get(i).copied().unwrap_or(0.0);
        if river > 0.45 {
            colour = mean(colour, *blue, math::smoothstep(0.45, 0.8, river));
        }
        self.cover.tint(from_oklab(colour), i, 0.92 + 0.08 * patch)
    }
}
