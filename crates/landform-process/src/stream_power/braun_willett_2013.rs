//! The implicit sweep.
//!
//! # Sources
//! Braun & Willett (2013): eq. 22 for n = 1, eqs. 23–24 (Newton) otherwise. Bell (thesis), eq. 3.7, for the talus slope: the
//! seed's text is a rate law, taken here where a rate is given (implicitly, after the river's part); its code is a clamp.

use landform_core::algo::flow::Flow;
use landform_core::grid::{Domain, NO_SLOT};
use landform_core::math;
use landform_core::verb::Resolved;

/// The law for one step.
pub(super) struct Law {
    pub(super) area_exponent: f64,
    pub(super) slope_exponent: f64,
    /// Tangent of the talus angle.
    pub(super) greatest_slope: f64,
    /// Distance (m) that a slope one above the talus slope gives way in the step; infinite for a clamp.
    pub(super) relaxation: f64,
    /// Level of the sea, below which no river sees; negative infinity without one.
    pub(super) sea_level: f64,
    /// Deposition coefficient G.
    pub(super) deposition: f64,
    /// What A^m S^n must exceed.
    pub(super) threshold: f64,
    pub(super) dt: f64,
}

impl Law {
    /// F of the erosion F (z − z_r)ⁿ in the step at a node with drainage area `area`, `length` from its receiver.
    #[inline]
    pub(super) fn strength(&self, erodibility: f64, area: f64, length: f64) -> f64 {
        let strength = erodibility * self.dt * math::pow(area, self.area_exponent);
        strength / if self.slope_exponent == 1.0 { length } else { math::pow(length, self.slope_exponent) }
    }

    /// What a drop of `drop` from a node to its receiver wears down to.
    #[inline]
    pub(super) fn worn(&self, drop: f64, strength: f64) -> f64 {
        if self.slope_exponent == 1.0 { drop / (1.0 + strength) } else { newton(drop, strength, self.slope_exponent) }
    }

    /// How far the talus slope is reached in the step from above, 0 to 1.
    #[inline]
    pub(super) fn slide(&self, length: f64) -> f64 {
        if self.relaxation.is_finite() { self.relaxation / (length + self.relaxation) } else { 1.0 }
    }
}

/// Lowers every node towards its receiver, from the outlets upwards; returns the volume taken, m³. `area` is drainage area.
pub(super) fn sweep<D: Domain>(
    domain: &D,
    flow: &Flow,
    law: &Law,
    erodibility: &Resolved,
    area: &[f64],
    z: &mut [f64],
) -> f64 {
    let (slots, receivers) = (flow.slots(), flow.receivers());
    let clamped = law.greatest_slope.is_finite();
    let mut volume = 0.0;
    for &i in flow.order().iter().rev() {
        let i = i as usize;
        let (old, base) = (z[i], z[receivers[i] as usize].max(law.sea_level));
        // Outlets are their own receivers; lake floors lie at or below theirs.
        if !(old > base) || slots[i] == NO_SLOT {
            continue;
        }
        // Roots and divisions hide behind the wait for memory: a pass of their own would cost more, even on two threads.
        let length = domain.distance(i, slots[i]);
        let strength = law.strength(erodibility.at(i), area[i], length);
        // A threshold is a rate that the ground is spared.
        let spared = law.threshold * erodibility.at(i) * law.dt;
        let mut new = if law.slope_exponent == 1.0 {
            (old + spared + strength * base) / (1.0 + strength)
        } else {
            base + law.worn(old + spared - base, strength)
        };
        if spared > 0.0 {
            new = new.min(old);
        }
        let limit = base + law.greatest_slope * length;
        if clamped && new > limit {
            new += (limit - new) * law.slide(length);
        }
        z[i] = new;
        volume += (old - new) * domain.area(i);
    }
    volume
}

/// The root x in [0, h] of x + f xⁿ = h: Newton's iteration, bisecting where it would leave the bracket.
fn newton(h: f64, f: f64, n: f64) -> f64 {
    if f == 0.0 {
        return h;
    }
    let (mut lo, mut hi, mut x) = (0.0, h, h);
    for _ in 0..200 {
        let power = math::pow(x, n);
        let error = x + f * power - h;
        if error > 0.0 {
            hi = x;
        } else {
            lo = x;
        }
        let derivative = 1.0 + f * n * power / x;
        let next = x - error / derivative;
        let next = if next > lo && next < hi { next } else { 0.5 * (lo + hi) };
        if (next - x).abs() <= 1e-15 * h || next == x {
            return next;
        }
        x = next;
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn newton_finds_the_root_over_the_legal_range() {
        for n in [0.5, 0.6, 0.9, 1.0, 1.3, 2.0, 4.0] {
            for f in [0.0, 1e-9, 1e-3, 1.0, 1e3, 1e9] {
                for h in [1e-6, 1.0, 3e3] {
                    let x = newton(h, f, n);
                    assert!(x >= 0.0 && x <= h);
                    // The step that Newton would still take from here.
                    let left = (x + f * math::pow(x, n) - h) / (1.0 + f * n * math::pow(x, n - 1.0));
                    assert!(f == 0.0 || left.abs() <= 1e-12 * h, "n {n} f {f} h {h} x {x} left {left}");
                }
            }
        }
        assert!((newton(5.0, 2.0, 1.0) - 5.0 / 3.0).abs() < 1e-14);
    }
}
