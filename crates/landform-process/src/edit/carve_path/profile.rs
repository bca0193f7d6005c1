//! The line of a road and its height along it.

use landform_core::math::{hypot, lerp};
use landform_core::{Error, Result};

/// The most places along a road.
const MOST: f64 = 4e6;

/// A road's middle.
pub(super) struct Profile {
    /// Places at even distances, m.
    pub(super) line: Vec<[f64; 2]>,
    /// Distance from the start, m.
    pub(super) at: Vec<f64>,
    /// Height of the ground, or the water, m.
    pub(super) ground: Vec<f64>,
    /// Height of the road, m.
    pub(super) height: Vec<f64>,
}

impl Profile {
    /// A profile with grades of at most `steepest` along a line, whose corners are rounded over
    /// `rounding` m on each side, and its own bends over `ease` m.
    ///
    /// # Errors
    /// [`Error::Parameter`] for a line without length, of too many cells, or without ground.
    pub(super) fn along(
        line: &[[f64; 2]],
        pace: f64,
        rounding: f64,
        level: impl Fn([f64; 2]) -> f64,
        steepest: f64,
        ease: f64,
    ) -> Result<Self> {
        let mut line = even(line, pace)?;
        let reach = |length: f64| (length / pace).min(MOST) as usize;
        if rounding > 0.0 {
            for _ in 0..2 {
                line = averaged(&line, reach(0.5 * rounding));
            }
            line = even(&line, pace)?;
        }
        let mut at = vec![0.0; line.len()];
        for k in 1..line.len() {
            at[k] = at[k - 1] + length(line[k - 1], line[k]);
        }
        let ground = filled(line.iter().map(|&p| level(p)).collect())?;
        let [under, above] = [-1.0, 1.0].map(|sign| envelope(&ground, &at, steepest, sign));
        let mean: Vec<[f64; 2]> = under.iter().zip(&above).map(|(u, a)| [0.5 * (u + a), 0.0]).collect();
        // A mean of neighbours is no steeper than they are.
        let eased = averaged(&mean, reach(0.5 * ease)).into_iter().map(|v| v[0]).collect();
        let height = no_steeper(eased, &at, steepest);
        Ok(Self { line, at, ground, height })
    }
}

fn length(a: [f64; 2], b: [f64; 2]) -> f64 {
    hypot(b[0] - a[0], b[1] - a[1])
}

/// The same line with places at even distances of at most `pace` m.
fn even(line: &[[f64; 2]], pace: f64) -> Result<Vec<[f64; 2]>> {
    let whole: f64 = line.windows(2).map(|w| length(w[0], w[1])).sum();
    let count = (whole / pace).ceil();
    if !(whole > 0.0 && count <= MOST) {
        let expected = format!("a road of at most {MOST:e} half cells");
        return Err(Error::parameter("points", format!("{whole} m of road on cells of {} m", 2.0 * pace), &expected));
    }
    let count = count.max(1.0) as usize;
    let (mut places, mut k, mut before) = (Vec::with_capacity(count + 1), 0, 0.0);
    for n in 0..=count {
        let at = whole * n as f64 / count as f64;
        while k + 2 < line.len() && before + length(line[k], line[k + 1]) < at {
            before += length(line[k], line[k + 1]);
            k += 1;
        }
        let part = length(line[k], line[k + 1]);
        let t = if part > 0.0 { ((at - before) / part).clamp(0.0, 1.0) } else { 0.0 };
        places.push([0, 1].map(|c| lerp(line[k][c], line[k + 1][c], t)));
    }
    Ok(places)
}

/// Means over `reach` values on both sides; over fewer near the ends, which stay.
fn averaged(values: &[[f64; 2]], reach: usize) -> Vec<[f64; 2]> {
    let n = values.len();
    let start = values[0];
    // Sums of what differs from the start, so that large coordinates lose nothing.
    let mut sums = vec![[0.0; 2]; n + 1];
    for k in 0..n {
        sums[k + 1] = [0, 1].map(|c| sums[k][c] + (values[k][c] - start[c]));
    }
    let mean = |k: usize| {
        let r = reach.min(k).min(n - 1 - k);
        [0, 1].map(|c| start[c] + (sums[k + r + 1][c] - sums[k - r][c]) / (2 * r + 1) as f64)
    };
    (0..n).map(|k| if k == 0 || k + 1 == n { values[k] } else { mean(k) }).collect()
}

/// Heights without gaps: those beside a hole hold on.
fn filled(mut ground: Vec<f64>) -> Result<Vec<f64>> {
    let first = ground
        .iter()
        .copied()
        .find(|z| z.is_finite())
        .ok_or_else(|| Error::parameter("points", "a line without ground", "a line over ground with data"))?;
    let mut last = first;
    for z in &mut ground {
        if !z.is_finite() {
            *z = last;
        }
        last = *z;
    }
    Ok(ground)
}

/// The least profile above the ground (`sign` 1), or the greatest under it (−1), whose grade is at
/// most `steepest`.
fn envelope(ground: &[f64], at: &[f64], steepest: f64, sign: f64) -> Vec<f64> {
    let mut height: Vec<f64> = ground.iter().map(|z| sign * z).collect();
    for k in 1..height.len() {
        height[k] = height[k].max(height[k - 1] - steepest * (at[k] - at[k - 1]));
    }
    for k in (1..height.len()).rev() {
        height[k - 1] = height[k - 1].max(height[k] - steepest * (at[k] - at[k - 1]));
    }
    height.into_iter().map(|z| sign * z).collect()
}

/// Heights whose grade is at most `steepest`, where distances are not quite even.
fn no_steeper(mut height: Vec<f64>, at: &[f64], steepest: f64) -> Vec<f64> {
    for k in 1..height.len() {
        let most = steepest * (at[k] - at[k - 1]);
        height[k] = height[k].clamp(height[k - 1] - most, height[k - 1] + most);
    }
    height
}
