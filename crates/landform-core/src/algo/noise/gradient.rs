//! Gradient noise on a hashed lattice, and octaves of it.
//!
//! # Sources
//! Perlin (2002): quintic fade. Gradients are unit vectors in 16 directions chosen by hash, so that
//! there is no table and no period. Gradient noise is zero at every lattice point; octaves are
//! therefore shifted against each other.

use crate::math::{floor, lerp};
use crate::random::Seed;

const DIRECTIONS: [[f64; 2]; 16] = {
    const A: f64 = 0.923_879_532_511_286_7;
    const B: f64 = 0.382_683_432_365_089_8;
    const C: f64 = std::f64::consts::FRAC_1_SQRT_2;
    [
        [1.0, 0.0],
        [A, B],
        [C, C],
        [B, A],
        [0.0, 1.0],
        [-B, A],
        [-C, C],
        [-A, B],
        [-1.0, 0.0],
        [-A, -B],
        [-C, -C],
        [-B, -A],
        [0.0, -1.0],
        [B, -A],
        [C, -C],
        [A, -B],
    ]
};

/// Gradient noise at (x, y), lattice spacing 1; in about [−1, 1], mean 0.
pub fn gradient_noise(seed: Seed, x: f64, y: f64) -> f64 {
    let (x0, y0) = (floor(x), floor(y));
    let corners = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)];
    within(corners.map(|(dx, dy)| direction(seed, x0 + dx, y0 + dy)), x - x0, y - y0)
}

/// Gradient noise at (x, y) and how it rises along x and y, lattice spacing 1. **Cost** about half
/// as much again as [`gradient_noise`].
///
/// ```
/// use landform_core::algo::noise::{gradient_noise, gradient_noise_and_rise};
/// use landform_core::random::Seed;
///
/// let (value, [east, _]) = gradient_noise_and_rise(Seed(1), 0.3, 0.7);
/// assert_eq!(value, gradient_noise(Seed(1), 0.3, 0.7));
/// let rise = (gradient_noise(Seed(1), 0.301, 0.7) - gradient_noise(Seed(1), 0.299, 0.7)) / 0.002;
/// assert!((east - rise).abs() < 1e-4);
/// ```
pub fn gradient_noise_and_rise(seed: Seed, x: f64, y: f64) -> (f64, [f64; 2]) {
    let (x0, y0) = (floor(x), floor(y));
    let corners = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)];
    let g = corners.map(|(dx, dy)| direction(seed, x0 + dx, y0 + dy));
    let (fx, fy) = (x - x0, y - y0);
    let plane = |k: usize| g[k][0] * (fx - corners[k].0) + g[k][1] * (fy - corners[k].1);
    let planes = [0, 1, 2, 3].map(plane);
    let (u, v) = (fade(fx), fade(fy));
    let fade_rise = |t: f64| 30.0 * t * t * (t - 1.0) * (t - 1.0);
    let mean = |k: usize| lerp(lerp(g[0][k], g[1][k], u), lerp(g[2][k], g[3][k], u), v);
    let across_x = lerp(planes[1] - planes[0], planes[3] - planes[2], v);
    let across_y = lerp(planes[2] - planes[0], planes[3] - planes[1], u);
    let rise = [mean(0) + fade_rise(fx) * across_x, mean(1) + fade_rise(fy) * across_y];
    (within(g, fx, fy), rise.map(|r| std::f64::consts::SQRT_2 * r))
}

/// Gradient noise at many points, lattice spacing 1. The gradients of a lattice cell are kept while
/// points stay in it, so points in line cost a few operations each; the bits are those of
/// [`gradient_noise`].
pub(super) fn gradient_noise_along(seed: Seed, xs: &[f64], ys: &[f64], out: &mut [f64]) {
    let mut cell = [f64::NAN; 2];
    let mut g = [[0.0; 2]; 4];
    for ((&x, &y), out) in xs.iter().zip(ys).zip(out) {
        let (x0, y0) = (floor(x), floor(y));
        if cell != [x0, y0] {
            let east = cell == [x0 - 1.0, y0];
            cell = [x0, y0];
            g = if east {
                [g[1], direction(seed, x0 + 1.0, y0), g[3], direction(seed, x0 + 1.0, y0 + 1.0)]
            } else {
                [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)].map(|(dx, dy)| direction(seed, x0 + dx, y0 + dy))
            };
        }
        *out = within(g, x - x0, y - y0);
    }
}

fn direction(seed: Seed, x: f64, y: f64) -> [f64; 2] {
    let key = (x as i64 as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ (y as i64 as u64).rotate_left(32);
    DIRECTIONS[(seed.bits(key) >> 60) as usize]
}

fn fade(t: f64) -> f64 {
    t * t * t * (t * (t * 6.0 - 15.0) + 10.0)
}

/// Noise in a lattice cell from the gradients at its corners (south-west, south-east, north-west,
/// north-east).
fn within(g: [[f64; 2]; 4], fx: f64, fy: f64) -> f64 {
    let dot = |g: [f64; 2], dx: f64, dy: f64| g[0] * (fx - dx) + g[1] * (fy - dy);
    let (u, v) = (fade(fx), fade(fy));
    std::f64::consts::SQRT_2
        * lerp(lerp(dot(g[0], 0.0, 0.0), dot(g[1], 1.0, 0.0), u), lerp(dot(g[2], 0.0, 1.0), dot(g[3], 1.0, 1.0), u), v)
}

/// Octaves of gradient noise, each `lacunarity` times finer and `gain` times weaker; in about [−1,
/// 1].
pub fn fbm(seed: Seed, x: f64, y: f64, octaves: u32, lacunarity: f64, gain: f64) -> f64 {
    let (mut sum, mut total, mut amplitude, mut frequency) = (0.0, 0.0, 1.0, 1.0);
    for octave in 0..octaves {
        let seed = seed.with(u64::from(octave));
        let shift = [seed.uniform(1), seed.uniform(2)];
        sum += amplitude * gradient_noise(seed, x * frequency + shift[0], y * frequency + shift[1]);
        total += amplitude;
        amplitude *= gain;
        frequency *= lacunarity;
    }
    if total > 0.0 { sum / total } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_is_centred_bounded_and_continuous() {
        let (mut sum, mut most) = (0.0, 0.0_f64);
        for i in 0..40_000 {
            let (x, y) = (f64::from(i % 200) * 0.37, f64::from(i / 200) * 0.41);
            let v = fbm(Seed(2), x, y, 5, 2.0, 0.5);
            sum += v;
            most = most.max(v.abs());
            assert!((v - fbm(Seed(2), x + 1e-9, y, 5, 2.0, 0.5)).abs() < 1e-6);
        }
        assert!((sum / 40_000.0).abs() < 0.02 && most < 1.0 && most > 0.4, "{sum} {most}");
    }

    #[test]
    fn noise_is_zero_on_the_lattice() {
        assert_eq!(gradient_noise(Seed(1), 3.0, -7.0), 0.0);
    }
}
