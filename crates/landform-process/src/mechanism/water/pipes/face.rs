//! A step of pipes, for a whole row of them at once: no branches, so that the compiler can take
//! several together.

use super::{GRAVITY, THIN};

/// What all pipes of a direction share in a step.
#[derive(Clone, Copy)]
pub(super) struct Kind {
    /// The pipe's length over the step, m/s.
    pace: f64,
    /// Change of speed by a metre of difference in level, 1/s.
    pull: f64,
    friction: f64,
    /// The greatest speed, m/s.
    most: f64,
    /// Volume that crosses by depth and speed, m s.
    opening: f64,
}

/// Pipes beside each other, all in one direction: a value per pipe.
#[derive(Clone, Copy)]
pub(super) struct Line<'a> {
    /// Ground and water where the pipes begin and where they end.
    pub(super) ground: [&'a [f64]; 2],
    pub(super) water: [&'a [f64]; 2],
    pub(super) speed: &'a [f64],
    /// Speed in the pipes in line with these, before their beginnings and after their ends, and the
    /// water at those pipes' far ends.
    pub(super) speed_beyond: [&'a [f64]; 2],
    pub(super) water_beyond: [&'a [f64]; 2],
    /// Speed in the four pipes across, at both ends.
    pub(super) speed_across: [&'a [f64]; 4],
}

impl<'a> Line<'a> {
    /// Some of the pipes.
    pub(super) fn part(&self, range: std::ops::Range<usize>) -> Self {
        let cut = |s: &'a [f64]| &s[range.clone()];
        Self {
            ground: self.ground.map(cut),
            water: self.water.map(cut),
            speed: cut(self.speed),
            speed_beyond: self.speed_beyond.map(cut),
            water_beyond: self.water_beyond.map(cut),
            speed_across: self.speed_across.map(cut),
        }
    }
}

impl Kind {
    pub(super) fn new(length: f64, width: f64, dt: f64, roughness: f64) -> Self {
        Self {
            pace: length / dt,
            pull: dt * GRAVITY / length,
            friction: GRAVITY * roughness * roughness * dt,
            // No faster than a wave would cross the cell.
            most: 0.9 * length / dt,
            opening: width * dt,
        }
    }

    /// Speeds after the step and the volumes that would cross. Returns the greatest speed.
    pub(super) fn flow(&self, line: &Line<'_>, speed: &mut [f64], volume: &mut [f64]) -> f64 {
        let n = speed.len().min(volume.len());
        let (speed, volume) = (&mut speed[..n], &mut volume[..n]);
        let Line { ground, water, speed: old, speed_beyond: [u0, u1], water_beyond: [b0, b1], speed_across } =
            line.part(0..n);
        let ([g0, g1], [w0, w1], [a, b, c, d]) = (ground, water, speed_across);
        for i in 0..n {
            let across = 0.25 * ((a[i] + b[i]) + (c[i] + d[i]));
            (speed[i], volume[i]) =
                self.through([g0[i], g1[i]], [w0[i], w1[i]], [old[i], across], (u0[i], b0[i]), (u1[i], b1[i]));
        }
        fastest(speed)
    }

    #[inline(always)]
    fn through(
        &self,
        g: [f64; 2],
        [wi, wj]: [f64; 2],
        [speed, across]: [f64; 2],
        before: (f64, f64),
        after: (f64, f64),
    ) -> (f64, f64) {
        let [hi, hj] = [g[0] + wi, g[1] + wj];
        let rise = hj - hi;
        let height = greater(hi, hj) - greater(g[0], g[1]);
        // Ground without a height is a wall.
        let is_open = (height > THIN) & !rise.is_nan();
        // Momentum comes with the flow into the nodes at both ends, from upstream; implicit, since
        // a thin front takes it up at once.
        let flow = |speed: f64, from: f64, to: f64| speed * if speed > 0.0 { from } else { to };
        let own = flow(speed, wi, wj);
        let from_before = greater(flow(before.0, before.1, wi) + own, 0.0);
        let from_after = greater(-flow(after.0, wj, after.1) - own, 0.0);
        let stays = self.pace * (wi + wj);
        let all = stays + from_before + from_after;
        let momentum = speed * stays + from_before * before.0 + from_after * after.0;
        // A front runs as fast as what follows it.
        let momentum = if (wi < THIN) & (after.0 < speed) { after.0 * all } else { momentum };
        let momentum = if (wj < THIN) & (before.0 > speed) { before.0 * all } else { momentum };
        let pushed = momentum - self.pull * rise * all;
        let slowed = self.rub(pushed / all, [speed, across], drag(height));
        let limited = greater(if slowed < self.most { slowed } else { self.most }, -self.most);
        let upstream = if limited > 0.0 { wi } else { wj };
        let open = if upstream < height { upstream } else { height };
        if is_open { (limited, limited * open * self.opening) } else { (0.0, 0.0) }
    }
}

impl Kind {
    /// The speed after friction over the step, implicit: the root of u (1 + k |U|) = `pushed`, so
    /// that steady flow keeps Manning's speed however long the step is. |U| is the whole speed: with
    /// a pipe's own, water would leave the fall line for a diagonal. `across` is the old speed
    /// across the pipe, from which follows what pushes there.
    #[inline(always)]
    fn rub(&self, pushed: f64, [speed, across]: [f64; 2], drag: f64) -> f64 {
        let k = self.friction * drag;
        let pushed_across = across * (1.0 + k * (speed * speed + across * across).sqrt());
        let whole = (pushed * pushed + pushed_across * pushed_across).sqrt();
        2.0 * pushed / (1.0 + (1.0 + 4.0 * k * whole).sqrt())
    }
}

/// The greater of two; unlike [`f64::max`] one instruction, since it does not look for NaN.
#[inline(always)]
pub(super) fn greater(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

fn fastest(speed: &[f64]) -> f64 {
    let (fours, rest) = speed.as_chunks::<4>();
    let mut most = [0.0; 4];
    for four in fours {
        for (m, u) in most.iter_mut().zip(four) {
            *m = greater(*m, u.abs());
        }
    }
    most.iter().chain(rest).fold(0.0, |m, u| greater(m, u.abs()))
}

/// x^(-4/3) for normal x > 0, to 3e-4: roughness is never known so exactly.
#[inline(always)]
fn drag(x: f64) -> f64 {
    // x^(-1/3) to within 4 %: minus a third of the exponent (two thirds less one, as fast as a
    // product of 32 bits), with the bias put right.
    let bits = x.to_bits();
    let r = f64::from_bits(0x553E_F0FF_289D_D796_u64.wrapping_add((bits >> 32) * 0xAAAA_AAAA).wrapping_sub(bits));
    let s = r * r;
    // The binomial series of (1 - e)^(-4/3).
    let e = 1.0 - x * s * r;
    s * s * (1.0 + e * (4.0 / 3.0 + e * (14.0 / 9.0 + e * (140.0 / 81.0))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn drag_is_the_power_that_it_says() {
        for k in -60..60 {
            let x = 1.37 * landform_core::math::pow(1.3, f64::from(k));
            let d = drag(x);
            assert!((d * d * d * x * x * x * x - 1.0).abs() < 1e-3, "{x} {d}");
        }
    }
}
