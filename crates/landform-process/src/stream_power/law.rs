//! The law of one step at one node: the drop that the river leaves, and the drop at which the slope
//! is stable.
//!
//! # Sources
//! Braun & Willett (2013): eq. 22 for n = 1, eqs. 23–24 (Newton) otherwise. Bell (thesis), eq. 3.7,
//! for the talus slope: the thesis' text is a rate law, used here where a rate is given
//! (implicitly, after the river's part); its code is a clamp.

use landform_core::math;

/// The law for one step.
pub(super) struct Law {
    pub(super) area_exponent: f64,
    pub(super) slope_exponent: f64,
    /// Tangent of the talus angle.
    pub(super) greatest_slope: f64,
    /// Talus relaxation: lowering (m) in the step per unit of slope above the talus slope; infinite
    /// for a clamp.
    pub(super) relaxation: f64,
    /// Slope that ground approaches and does not exceed; infinite for none.
    pub(super) limiting_slope: f64,
    /// Whether each material has its own, on layered ground.
    pub(super) limits_by_material: bool,
    /// Drainage area below which erosion no longer falls with it, m².
    pub(super) least_area: f64,
    /// Sea level, at which rivers end, m; negative infinity without a sea.
    pub(super) sea_level: f64,
    /// Deposition coefficient G.
    pub(super) deposition: f64,
    /// Value that A^m S^n must exceed.
    pub(super) threshold: f64,
    pub(super) dt: f64,
}

impl Law {
    /// F of the erosion F (z − z_r)ⁿ in the step at a node with drainage area `area`, `length` from
    /// its receiver.
    #[inline]
    pub(super) fn strength(&self, erodibility: f64, area: f64, length: f64) -> f64 {
        let strength = erodibility * self.dt * math::pow(area.max(self.least_area), self.area_exponent);
        strength / if self.slope_exponent == 1.0 { length } else { math::pow(length, self.slope_exponent) }
    }

    /// The drop from a node to its receiver that erosion leaves of `drop`, where ground cannot
    /// stand `most` above: the root x of x + F xⁿ/(1 − x/most) = drop.
    #[inline]
    pub(super) fn worn(&self, drop: f64, strength: f64, most: f64) -> f64 {
        match (self.slope_exponent == 1.0, most.is_finite()) {
            (true, false) => drop / (1.0 + strength),
            (true, true) => {
                let part = drop / most;
                let all = 1.0 + strength + part;
                2.0 * drop / (all + (all * all - 4.0 * part).sqrt())
            }
            (false, _) => newton(drop, strength, self.slope_exponent, most),
        }
    }

    /// Slope and intercept of the tangent of the erosion F xⁿ/(1 − x/most) at a drop x; `per_most`
    /// is one over `most`.
    #[inline]
    pub(super) fn tangent(&self, strength: f64, x: f64, per_most: f64) -> [f64; 2] {
        let n = self.slope_exponent;
        if n == 1.0 && per_most == 0.0 {
            return [strength, 0.0];
        }
        let x = x.max(1e-9);
        let per_left = 1.0 / (1.0 - x * per_most).max(1e-9);
        let (power, steepness) = if n == 1.0 {
            (strength * x, strength)
        } else {
            let power = strength * math::pow(x, n);
            (power, n * power / x)
        };
        let value = power * per_left;
        let slope = steepness * per_left + value * per_most * per_left;
        [slope, value - slope * x]
    }

    /// Whether there is a slope that ground does not exceed.
    pub(super) fn has_limit(&self) -> bool {
        self.limits_by_material || self.limiting_slope.is_finite()
    }

    /// Whether erosion is not in proportion to the drop.
    pub(super) fn is_curved(&self) -> bool {
        self.slope_exponent != 1.0 || self.has_limit()
    }

    /// The drop over `length` that is left where ground stands up to `limit` above the receiver,
    /// and whether this limit, not the river, decides.
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

/// The root x in [0, h] of x + f xⁿ/(1 − x/most) = h: Newton's iteration, bisecting where it would
/// leave the bracket.
fn newton(h: f64, f: f64, n: f64, most: f64) -> f64 {
    if f == 0.0 {
        return h;
    }
    let top = h.min(most);
    let (mut lo, mut hi, mut x) = (0.0, top, if top < most { top } else { 0.5 * top });
    for _ in 0..200 {
        let left = 1.0 - x / most;
        let power = math::pow(x, n) / left;
        let error = x + f * power - h;
        if error > 0.0 {
            hi = x;
        } else {
            lo = x;
        }
        let derivative = 1.0 + f * power * (n / x + 1.0 / (most * left));
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
                    let x = newton(h, f, n, f64::INFINITY);
                    assert!(x >= 0.0 && x <= h);
                    // The step that Newton would still take from here.
                    let left = (x + f * math::pow(x, n) - h) / (1.0 + f * n * math::pow(x, n - 1.0));
                    assert!(f == 0.0 || left.abs() <= 1e-12 * h, "n {n} f {f} h {h} x {x} left {left}");
                }
            }
        }
        for n in [0.6, 1.0, 2.0] {
            for (h, f, most) in [(50.0, 1e-3, 10.0), (5.0, 3.0, 10.0), (1e4, 1e2, 27.0), (1e-3, 1.0, 27.0)] {
                let x = newton(h, f, n, most);
                let left = (x + f * math::pow(x, n) / (1.0 - x / most) - h) / h;
                assert!(x < most && left.abs() <= 1e-9, "n {n} f {f} h {h} x {x} left {left}");
            }
        }
        assert!((newton(5.0, 2.0, 1.0, f64::INFINITY) - 5.0 / 3.0).abs() < 1e-14);
    }
}
