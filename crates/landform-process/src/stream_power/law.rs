//! The law of one step at one node: the drop that the river leaves, and the drop at which the slope is stable.
//!
//! # Sources
//! Braun & Willett (2013): eq. 22 for n = 1, eqs. 23–24 (Newton) otherwise. Bell (thesis), eq. 3.7, for the talus slope: the
//! thesis' text is a rate law, used here where a rate is given (implicitly, after the river's part); its code is a clamp.

use landform_core::math;

/// The law for one step.
pub(super) struct Law {
    pub(super) area_exponent: f64,
    pub(super) slope_exponent: f64,
    /// Tangent of the talus angle.
    pub(super) greatest_slope: f64,
    /// Talus relaxation: lowering (m) in the step per unit of slope above the talus slope; infinite for a clamp.
    pub(super) relaxation: f64,
    /// Sea level, at which rivers end, m; negative infinity without a sea.
    pub(super) sea_level: f64,
    /// Deposition coefficient G.
    pub(super) deposition: f64,
    /// Value that A^m S^n must exceed.
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

    /// The drop from a node to its receiver that erosion leaves of `drop`.
    #[inline]
    pub(super) fn worn(&self, drop: f64, strength: f64) -> f64 {
        if self.slope_exponent == 1.0 { drop / (1.0 + strength) } else { newton(drop, strength, self.slope_exponent) }
    }

    /// The drop over `length` that is left where ground stands up to `limit` above the receiver, and whether this limit, not the
    /// river, decides.
    #[inline]
    pub(super) fn standing(&self, worn: f64, limit: f64, length: f64) -> (f64, bool) {
        if worn > limit { (worn + (limit - worn) * self.slide(length), true) } else { (worn, false) }
    }

    /// How far the talus slope is reached in the step from above, 0 to 1.
    #[inline]
    pub(super) fn slide(&self, length: f64) -> f64 {
        if self.relaxation.is_finite() { self.relaxation / (length + self.relaxation) } else { 1.0 }
    }
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
