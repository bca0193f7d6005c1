//! Growth of corals by the light that reaches them.

use landform_core::math;

/// Part of the greatest rate below which nothing grows.
const DARK: f64 = 1e-5;
/// A depth of which the rate is kept, so that reefs that keep up need none, m.
const SHALLOW: f64 = 5.0;
/// Part of an e-fold of the light by which depth may change within one part of a step.
const FINE: f64 = 0.1;
/// Most parts that a step is cut into.
const MOST_PARTS: f64 = 4096.0;

/// Rate of upward growth by depth: G(w) = G_m tanh((I_0 / I_k) exp(-k w)).
///
/// ```
/// use landform_process::reef::Light;
///
/// // Per year: 12 mm/yr, 2000 and 250 uE m-2 s-1, 0.1 1/m.
/// let light = Light::new(0.012, 2000.0, 250.0, 0.1);
/// assert!((light.rate(30.0) - 0.00454).abs() < 5e-6);
/// // A sea that rises by 5 mm/yr drowns what lies deeper than this.
/// assert!((light.drowning_depth(0.005).unwrap() - 28.9).abs() < 0.05);
/// assert_eq!(light.drowning_depth(0.013), None);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    most: f64,
    ratio: f64,
    extinction: f64,
    /// Depth below which nothing grows, m.
    dark: f64,
    /// Rate at [`SHALLOW`].
    shallow: f64,
}

/// The sea over a place during one step.
///
/// ```
/// use landform_process::reef::{Light, Water};
///
/// // A place 10 m deep in a still sea, in a kyr: it reaches low water and stops.
/// let sea = Water { depth: 10.0, rise: 0.0, low: 0.5, factor: 1.0, time: 1000.0 };
/// let light = Light::new(0.012, 2000.0, 250.0, 0.1);
/// assert!((light.grown(&sea) - 9.5).abs() < 1e-9);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Water {
    /// Depth at the start, m; negative over land.
    pub depth: f64,
    /// By how much the depth would grow in the step if nothing grew in it, m.
    pub rise: f64,
    /// Depth at low water, above which nothing grows, m.
    pub low: f64,
    /// Factor on the rate, at least 0: what shelter leaves of it.
    pub factor: f64,
    /// Length of the step, in the units of time of the rate.
    pub time: f64,
}

impl Light {
    /// From the greatest rate (m per unit of time), the light at the surface and that at which
    /// growth saturates (of one unit), and the extinction (1/m).
    ///
    /// ```
    /// use landform_process::reef::Light;
    ///
    /// // No light, no growth.
    /// assert_eq!(Light::new(0.012, 0.0, 250.0, 0.1).rate(5.0), 0.0);
    /// ```
    pub fn new(most: f64, light: f64, saturation: f64, extinction: f64) -> Self {
        let ratio = light / saturation;
        let dark = if ratio > DARK { math::log(ratio / DARK) / extinction } else { 0.0 };
        let law = Self { most, ratio, extinction, dark, shallow: 0.0 };
        Self { shallow: law.rate(SHALLOW), ..law }
    }

    /// Rate at a depth (m), in the unit of the greatest rate; above water that at the surface.
    ///
    /// ```
    /// use landform_process::reef::Light;
    ///
    /// let light = Light::new(0.012, 2000.0, 250.0, 0.1);
    /// assert!(light.rate(10.0) > light.rate(20.0));
    /// ```
    #[inline]
    pub fn rate(&self, depth: f64) -> f64 {
        self.most * math::tanh(self.ratio * math::exp(-self.extinction * depth.max(0.0)))
    }

    /// Depth (m) from which a reef cannot catch up with a sea that rises at a rate (of the unit of
    /// the greatest rate) over its ground; none if it drowns from any depth. A reef in shallower
    /// water reaches the surface. With a rate that is not positive no depth is too great.
    ///
    /// w* = ln(I_0 / (I_k atanh(s / G_m))) / k
    ///
    /// ```
    /// use landform_process::reef::Light;
    ///
    /// let light = Light::new(0.012, 2000.0, 250.0, 0.1);
    /// assert_eq!(light.drowning_depth(0.0), Some(f64::INFINITY));
    /// ```
    pub fn drowning_depth(&self, rise: f64) -> Option<f64> {
        if rise <= 0.0 {
            return Some(f64::INFINITY);
        }
        let depth = math::log(self.ratio / math::atanh(rise / self.most)) / self.extinction;
        (rise < self.rate(0.0)).then_some(depth)
    }

    /// Height that grows at a place in a step, m. Growth stops at low water, and goes on with the
    /// water.
    ///
    /// ```
    /// use landform_process::reef::{Light, Water};
    ///
    /// let land = Water { depth: -3.0, rise: 0.0, low: 0.5, factor: 1.0, time: 10.0 };
    /// assert_eq!(Light::new(0.012, 2000.0, 250.0, 0.1).grown(&land), 0.0);
    /// ```
    pub fn grown(&self, water: &Water) -> f64 {
        let Water { depth, rise, low, factor, time } = *water;
        let (end, shallowest) = (depth + rise, depth.min(depth + rise).max(low));
        if !(depth.max(end) > low) || shallowest > self.dark || !(factor > 0.0 && time > 0.0) {
            return 0.0;
        }
        // Of a step in which the sea floods the place, what is left of it.
        let dry = if depth < low { (low - depth) / rise } else { 0.0 };
        let (depth, rise, time) = (depth.max(low), rise * (1.0 - dry), time * (1.0 - dry));
        // As fast as in the deepest water it would still reach low water: it does.
        let least = || factor * if end <= SHALLOW { self.shallow } else { self.rate(end) };
        if rise >= 0.0 && least() * time >= end - low {
            return end - low;
        }
        self.integrated(&Water { depth, rise, time, ..*water })
    }

    /// Growth by the midpoint rule, in parts in which the light changes little.
    fn integrated(&self, water: &Water) -> f64 {
        let Water { depth, rise, low, factor, time } = *water;
        // As fast as an e-fold of the light higher up.
        let fast = self.rate((depth.min(depth + rise) - 1.0 / self.extinction).max(low));
        let change = factor * fast * time + rise.abs();
        let parts = (self.extinction * change / FINE).ceil().clamp(1.0, MOST_PARTS);
        let (dt, up) = (time / parts, rise / parts);
        let (mut depth, mut grown) = (depth, 0.0);
        for _ in 0..parts as usize {
            let half = depth + 0.5 * (up - factor * self.rate(depth) * dt);
            let more = factor * self.rate(half.max(low)) * dt;
            // Up to low water at the end of the part, and never down.
            let more = more.min(depth + up - low).max(0.0);
            grown += more;
            depth += up - more;
        }
        grown
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Per year, as in the table of Bosscher & Schlager's ranges.
    fn light() -> Light {
        Light::new(0.012, 2000.0, 250.0, 0.1)
    }

    #[test]
    fn cr1_rates_are_those_of_the_formula() {
        let expected = |w: f64| 0.012 * math::tanh(8.0 * math::exp(-0.1 * w));
        for w in [0.0, 0.3, 10.0, 20.0, 30.0, 50.0, 120.0] {
            assert!((light().rate(w) - expected(w)).abs() < 1e-12, "{w}");
        }
        let table = [(0.0, 12.0), (10.0, 11.93), (20.0, 9.53), (30.0, 4.54), (50.0, 0.65)];
        assert!(table.iter().all(|&(w, mm)| (1e3 * light().rate(w) - mm).abs() < 5e-3));
        let drowning = [(1.0, 45.6), (3.0, 34.4), (5.0, 28.9), (8.0, 23.0), (10.0, 19.0)];
        for (mm, depth) in drowning {
            let found = light().drowning_depth(1e-3 * mm).unwrap();
            assert!((found - depth).abs() < 0.05, "{mm} mm/yr: {found}");
            assert!((light().rate(found) - 1e-3 * mm).abs() < 1e-12);
        }
        assert_eq!(light().drowning_depth(0.0), Some(f64::INFINITY));
        assert_eq!(light().drowning_depth(0.012), None);
    }

    /// Depth after steps of `dt` years in a sea that rises over the ground.
    fn after(years: f64, dt: f64, mut depth: f64, rate: f64) -> f64 {
        for _ in 0..(years / dt) as usize {
            let water = Water { depth, rise: rate * dt, low: 0.0, factor: 1.0, time: dt };
            depth += water.rise - light().grown(&water);
        }
        depth
    }

    #[test]
    fn cr2_reefs_catch_up_or_give_up_on_either_side_of_the_drowning_depth() {
        for rate in [0.001, 0.003, 0.005, 0.008, 0.010] {
            let edge = light().drowning_depth(rate).unwrap();
            for dt in [50.0, 1_000.0, 10_000.0] {
                let (near, far) = (after(2e5, dt, edge - 0.1, rate), after(2e5, dt, edge + 0.1, rate));
                assert!(near.abs() < 1e-9, "{rate} in steps of {dt} yr caught up to {near}");
                assert!(far > 100.0, "{rate} in steps of {dt} yr gave up at {far}");
            }
        }
    }

    #[test]
    fn steps_of_a_thousand_years_agree_with_short_ones_and_never_pass_low_water() {
        for (depth, rate) in [(30.0, 0.004), (45.0, 0.0), (20.0, -0.002), (-3.0, 0.006), (60.0, 0.001)] {
            let (long, short) = (after(6_000.0, 1_000.0, depth, rate), after(6_000.0, 2.0, depth, rate));
            assert!((long - short).abs() < 0.1, "{depth} {rate}: {long} {short}");
            assert!(long >= 0.0 || rate < 0.0, "{long}");
        }
        // The sea falls past a reef, which stays as high as it was: no growth, and no loss.
        let fallen = Water { depth: 2.0, rise: -5.0, low: 0.5, factor: 1.0, time: 100.0 };
        let grown = light().grown(&fallen);
        assert!((0.0..=1.5).contains(&grown), "{grown}");
        let wild = Water { depth: 10.0, rise: 1e300, low: 0.5, factor: 1.0, time: 1e300 };
        assert!(light().grown(&wild).is_finite() && light().grown(&Water { rise: f64::NAN, ..wild }) == 0.0);
    }
}
