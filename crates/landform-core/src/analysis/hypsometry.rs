//! Hypsometry: the area of ground at each height.
//!
//! # Method
//! The curve is the sorted elevations themselves. Its shape is judged on 101 points smoothed by a
//! Gaussian of five: the signs of the second derivative from the heights down, where it is at least
//! a tenth of its greatest amount.
//!
//! # Sources
//! Strahler (1952): curve, integral, family of model curves (Eq. 2.9 of Pytel's thesis) and
//! classes; (mean − min)/(max − min) is the exact integral of the curve (Pike & Wilson 1971).
//! Harlin (1978): skew of the curve taken as a density. Pytel's thesis 2.4.1 for unusual curves.

use serde::{Deserialize, Serialize};

use crate::{math, parallel};

/// The hypsometric curve and what follows from it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Hypsometry {
    /// Ratio (mean − min)/(max − min); NaN for flat ground.
    pub integral: f64,
    /// The same with elevations cut to their 0.1st and 99.9th percentiles: it does not depend on
    /// two cells.
    pub integral_clipped: f64,
    /// Relative elevation (0 to 1) above which each of 0, 1/100, …, 1 of the area lies.
    pub curve: Vec<f64>,
    /// Skew of the curve (Harlin 1978); greater where relief stands on a wide low plain.
    pub curve_skew: f64,
    /// Skew of the elevations.
    pub elevation_skew: f64,
    /// Strahler's model curve.
    pub model: ModelCurve,
    /// Class of the curve.
    pub class: HypsometricClass,
    /// Why, in a phrase.
    pub reason: String,
}

/// Strahler's family y = [(d − X)/X · a/(d − a)]^z, X = (d − a) x + a.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ModelCurve {
    /// Ratio a/d, 0 to 1.
    pub ratio: f64,
    /// Exponent z.
    pub exponent: f64,
    /// Root mean square distance from the curve, in relative elevation.
    pub rms: f64,
}

impl ModelCurve {
    /// Relative elevation at relative area `x`.
    pub fn at(&self, x: f64) -> f64 {
        let r = self.ratio;
        let big = (1.0 - r) * x + r;
        math::pow(((1.0 - big) / big * r / (1.0 - r)).max(0.0), self.exponent)
    }
}

/// Strahler's stages, and a class for curves that fit none.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum HypsometricClass {
    /// Young: most of the ground is still high. Integral above 0.60.
    Inequilibrium,
    /// Mature: integral 0.35 to 0.60.
    Equilibrium,
    /// Old, with isolated heights: integral below 0.35.
    Monadnock,
    /// A curve that erosion by water does not leave.
    Unusual,
    /// No relief.
    Flat,
}

impl HypsometricClass {
    /// The word.
    pub fn name(self) -> &'static str {
        match self {
            Self::Inequilibrium => "inequilibrium",
            Self::Equilibrium => "equilibrium",
            Self::Monadnock => "monadnock",
            Self::Unusual => "unusual",
            Self::Flat => "flat",
        }
    }
}

/// Hypsometry of elevations (m) of equal areas; NaN is ignored. **Cost** O(n log n).
///
/// ```
/// use landform_core::analysis::hypsometry;
///
/// let ramp: Vec<f64> = (0..=100).map(f64::from).collect();
/// assert!((hypsometry(&ramp).integral - 0.5).abs() < 1e-12);
/// ```
pub fn hypsometry(elevation: &[f64]) -> Hypsometry {
    let mut z: Vec<f64> = elevation.iter().copied().filter(|z| z.is_finite()).collect();
    parallel::sort_by(&mut z, |a, b| b.total_cmp(a));
    of_sorted(&z)
}

/// As [`hypsometry`], of elevations (m) sorted from the highest down.
pub fn of_sorted(z: &[f64]) -> Hypsometry {
    let (Some(&max), Some(&min)) = (z.first(), z.last()) else { return flat() };
    if !(max > min) {
        return flat();
    }
    let n = z.len();
    let relative = |z: f64| (z - min) / (max - min);
    let mean = parallel::sum(n, |i| z[i]) / n as f64;
    let curve: Vec<f64> = (0..=100).map(|k| relative(z[(k * (n - 1) + 50) / 100])).collect();
    let (low, high) = (quantile(z, 0.999), quantile(z, 0.001));
    let clipped = parallel::sum(n, |i| z[i].clamp(low, high)) / n as f64;
    let moment = |p: u32| parallel::sum(n, |i| math::powi(z[i] - mean, p)) / n as f64;
    let integral = relative(mean);
    // Steps of few elevations are no inflections.
    let (class, reason) = if n < LEAST_NODES { classify(&[], integral) } else { classify(&curve, integral) };
    Hypsometry {
        integral,
        integral_clipped: (clipped - low) / (high - low),
        curve_skew: curve_skew(z, &relative),
        elevation_skew: moment(3) / (moment(2) * moment(2).sqrt()),
        model: fit(z, &relative),
        class,
        reason,
        curve,
    }
}

fn flat() -> Hypsometry {
    Hypsometry {
        integral: f64::NAN,
        integral_clipped: f64::NAN,
        curve: Vec::new(),
        curve_skew: f64::NAN,
        elevation_skew: f64::NAN,
        model: ModelCurve { ratio: f64::NAN, exponent: f64::NAN, rms: f64::NAN },
        class: HypsometricClass::Flat,
        reason: "there is no relief".into(),
    }
}

/// Fewer elevations make no curve to be judged by its bends.
const LEAST_NODES: usize = 300;

/// Value below which the part 1 − `above` of descending values lies, linear between them.
fn quantile(descending: &[f64], above: f64) -> f64 {
    let at = above * (descending.len() - 1) as f64;
    let k = (at as usize).min(descending.len().saturating_sub(2));
    math::lerp(descending[k], descending[(k + 1).min(descending.len() - 1)], at - k as f64)
}

fn curve_skew(z: &[f64], relative: &(impl Fn(f64) -> f64 + Sync)) -> f64 {
    let n = z.len() as f64;
    let a = |i: usize| (i as f64 + 0.5) / n;
    let total = parallel::sum(z.len(), |i| relative(z[i]));
    let mean = parallel::sum(z.len(), |i| relative(z[i]) * a(i)) / total;
    let moment = |p: u32| parallel::sum(z.len(), |i| relative(z[i]) * math::powi(a(i) - mean, p)) / total;
    moment(3) / (moment(2) * moment(2).sqrt())
}

/// Least squares at 200 relative areas: the ratio by golden section on its logarithm, for each the
/// exponent likewise.
fn fit(z: &[f64], relative: &impl Fn(f64) -> f64) -> ModelCurve {
    let points: Vec<(f64, f64)> = (0..200)
        .map(|k| (f64::from(k) + 0.5) / 200.0)
        .map(|x| (x, relative(z[((x * z.len() as f64) as usize).min(z.len() - 1)])))
        .collect();
    let error = |ratio: f64, exponent: f64| {
        let model = ModelCurve { ratio, exponent, rms: 0.0 };
        let sum: f64 = points.iter().map(|&(x, y)| (model.at(x) - y) * (model.at(x) - y)).sum();
        (sum / points.len() as f64).sqrt()
    };
    let best_exponent = |ratio: f64| golden(math::log(0.01), math::log(8.0), &|e| error(ratio, math::exp(e)));
    // The ratio is searched on its logit, which has one valley in practice; a coarse sweep finds
    // it.
    let ratio_of = |t: f64| 1.0 / (1.0 + math::exp(-t));
    let at = |t: f64| error(ratio_of(t), math::exp(best_exponent(ratio_of(t))));
    let sweep: Vec<f64> = (0..=24).map(|k| -9.0 + 0.6 * f64::from(k)).collect();
    let coarse =
        sweep.iter().map(|&t| at(t)).enumerate().fold((0, f64::INFINITY), |a, b| if b.1 < a.1 { b } else { a });
    let middle = sweep[coarse.0];
    let t = golden(middle - 0.6, middle + 0.6, &at);
    let (ratio, exponent) = (ratio_of(t), math::exp(best_exponent(ratio_of(t))));
    ModelCurve { ratio, exponent, rms: error(ratio, exponent) }
}

/// The place of the least value of a function with one valley.
fn golden(mut lo: f64, mut hi: f64, f: &dyn Fn(f64) -> f64) -> f64 {
    const PART: f64 = 0.618_033_988_749_894_9;
    let (mut a, mut b) = (hi - PART * (hi - lo), lo + PART * (hi - lo));
    let (mut fa, mut fb) = (f(a), f(b));
    for _ in 0..36 {
        if fa < fb {
            (hi, b, fb) = (b, a, fa);
            a = hi - PART * (hi - lo);
            fa = f(a);
        } else {
            (lo, a, fa) = (a, b, fb);
            b = lo + PART * (hi - lo);
            fb = f(b);
        }
    }
    0.5 * (lo + hi)
}

/// The class of a curve and why.
pub fn classify(curve: &[f64], integral: f64) -> (HypsometricClass, String) {
    use HypsometricClass::{Equilibrium, Inequilibrium, Monadnock, Unusual};
    let bends = bends(curve);
    let by_integral = if integral > 0.60 {
        (Inequilibrium, "more than 0.60 of the block is left")
    } else if integral < 0.35 {
        (Monadnock, "less than 0.35 of the block is left")
    } else {
        (Equilibrium, "between 0.35 and 0.60 of the block is left")
    };
    let shape = match bends.as_slice() {
        [] => "the curve is straight",
        [true] => "concave throughout",
        [true, false] => "concave in the heights, convex below, one inflection",
        [false] => {
            return (Unusual, "convex throughout: rock or deep gorges rather than valleys rule the shape".into());
        }
        [false, true] => {
            return (
                Unusual,
                "convex in the heights and concave below: a tableland over a low plain, not valleys".into(),
            );
        }
        more => {
            let text = format!("{} inflections: several levels, as of terraces, plains or a sea floor", more.len() - 1);
            return (Unusual, text);
        }
    };
    (by_integral.0, format!("{}; {shape}", by_integral.1))
}

/// Runs of concave-up (true) and convex (false) from the heights down.
fn bends(curve: &[f64]) -> Vec<bool> {
    let n = curve.len();
    if n < 21 {
        return Vec::new();
    }
    let weight = |d: f64| math::exp(-0.5 * d * d / 25.0);
    let smooth: Vec<f64> = (0..n)
        .map(|i| {
            // Local straight line, so that the ends are not pulled inwards.
            let (mut s, mut sx, mut sy, mut sxx, mut sxy) = (0.0, 0.0, 0.0, 0.0, 0.0);
            for j in i.saturating_sub(15)..(i + 16).min(n) {
                let d = j as f64 - i as f64;
                let w = weight(d);
                s += w;
                sx += w * d;
                sy += w * curve[j];
                sxx += w * d * d;
                sxy += w * d * curve[j];
            }
            (sxx * sy - sx * sxy) / (s * sxx - sx * sx)
        })
        .collect();
    // The outermost points depend on the few highest and lowest cells.
    let second: Vec<f64> = (8..n - 8).map(|i| smooth[i + 5] + smooth[i - 5] - 2.0 * smooth[i]).collect();
    let greatest = second.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    let mut bends: Vec<bool> = Vec::new();
    if greatest < 2e-3 {
        return bends;
    }
    for v in second.into_iter().filter(|v| v.abs() > 0.1 * greatest) {
        if bends.last() != Some(&(v > 0.0)) {
            bends.push(v > 0.0);
        }
    }
    bends
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plane_has_integral_one_half_and_a_straight_curve() {
        let z: Vec<f64> = (0..1001).map(f64::from).collect();
        let h = hypsometry(&z);
        assert!((h.integral - 0.5).abs() < 1e-12);
        assert!(h.curve.iter().enumerate().all(|(k, c)| (c - (1.0 - k as f64 / 100.0)).abs() < 1e-12));
        assert_eq!(h.class, HypsometricClass::Equilibrium);
        assert_eq!(hypsometry(&[f64::NAN]).class, HypsometricClass::Flat);
        assert_eq!(hypsometry(&[2.0; 9]).class, HypsometricClass::Flat);
    }

    #[test]
    fn integrals_of_solids_are_known_and_equal_that_of_the_curve() {
        // A cone: 1/3; a paraboloid: 1/2; the identity with the trapezoid of the sorted elevations
        // to 1e-9.
        let n = 801;
        let disc = |f: &dyn Fn(f64) -> f64| -> Vec<f64> {
            (0..n * n)
                .map(|i| math::hypot((i % n) as f64 / 400.0 - 1.0, (i / n) as f64 / 400.0 - 1.0))
                .map(|r| if r <= 1.0 { f(r) } else { f64::NAN })
                .collect()
        };
        for (z, expected) in [(disc(&|r| 1.0 - r), 1.0 / 3.0), (disc(&|r| 1.0 - r * r), 0.5)] {
            let h = hypsometry(&z);
            assert!((h.integral - expected).abs() < 2e-3, "{}", h.integral);
            let mut sorted: Vec<f64> = z.into_iter().filter(|v| !v.is_nan()).collect();
            sorted.sort_unstable_by(f64::total_cmp);
            let (lo, hi) = (sorted[0], sorted[sorted.len() - 1]);
            // Each cell is a step of equal area.
            let sum: f64 = sorted.iter().map(|v| (v - lo) / (hi - lo)).sum::<f64>() / sorted.len() as f64;
            assert!((h.integral - sum).abs() < 1e-9);
        }
    }

    #[test]
    fn strahlers_family_is_found_again() {
        for (ratio, exponent) in [(0.01, 0.3), (0.1, 0.5), (0.5, 1.5)] {
            let truth = ModelCurve { ratio, exponent, rms: 0.0 };
            let z: Vec<f64> = (0..40_000).map(|i| truth.at((f64::from(i) + 0.5) / 40_000.0)).collect();
            // The family reaches 1 and 0 at its ends only.
            let z: Vec<f64> = z.into_iter().chain([1.0, 0.0]).collect();
            let found = hypsometry(&z).model;
            assert!(found.rms < 2e-3, "{found:?}");
            assert!(
                (found.ratio / ratio - 1.0).abs() < 0.1 && (found.exponent / exponent - 1.0).abs() < 0.05,
                "{found:?}"
            );
        }
    }

    #[test]
    fn curves_are_classed_by_shape_and_integral() {
        let class = |f: &dyn Fn(f64) -> f64| {
            let curve: Vec<f64> = (0..=100).map(|k| f(f64::from(k) / 100.0)).collect();
            let integral = curve.iter().sum::<f64>() / 101.0;
            classify(&curve, integral).0
        };
        let strahler = |ratio, exponent| move |x: f64| ModelCurve { ratio, exponent, rms: 0.0 }.at(x);
        assert_eq!(class(&strahler(0.1, 0.2)), HypsometricClass::Inequilibrium);
        assert_eq!(class(&strahler(0.05, 0.35)), HypsometricClass::Equilibrium);
        assert_eq!(class(&strahler(0.01, 0.4)), HypsometricClass::Monadnock);
        assert_eq!(class(&|x| 1.0 - x * x), HypsometricClass::Unusual);
        assert_eq!(class(&|x| 1.0 - math::smoothstep(0.0, 1.0, x)), HypsometricClass::Unusual);
        let terraces = |x: f64| 1.0 - x - 0.12 * math::sin(12.0 * x);
        assert_eq!(class(&terraces), HypsometricClass::Unusual);
    }
}
