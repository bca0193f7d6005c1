//! Searches for a place in the unit cube at which a value comes to an aim.
//!
//! # Method
//! One axis: if the values at the ends, or at neighbours of five even places, lie on both sides of
//! a target, bisection between them; else golden sections around the best of the five. More axes:
//! the simplex search of Nelder and Mead, kept in the cube. A place without a value is worse than
//! any with one.
//!
//! # Sources
//! Nelder & Mead (1965), The Computer Journal 7; Kiefer (1953), Proceedings of the American
//! Mathematical Society 4, for golden sections.

use super::Aim;

/// Finds the value at a place, NaN where there is none; ends the search by none.
pub(super) type Probe<'a> = dyn FnMut(&[f64]) -> Option<f64> + 'a;

/// Width at which an interval or a simplex is a point.
const POINT: f64 = 1e-6;
/// (√5 − 1)/2.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

impl Aim {
    /// How far a value is from the aim; less is better.
    pub(super) fn misfit(self, value: f64) -> f64 {
        let misfit = match self {
            Self::Target(target) => (value - target).abs(),
            Self::Least => value,
            Self::Most => -value,
        };
        if misfit.is_nan() { f64::INFINITY } else { misfit }
    }

    /// Whether a target lies between two values.
    fn is_between(self, [a, b]: [f64; 2]) -> bool {
        matches!(self, Self::Target(target) if (a - target) * (b - target) <= 0.0)
    }
}

/// Searches until the interval or simplex is a point, or the probe ends it.
pub(super) fn search(axes: usize, aim: Aim, probe: &mut Probe) {
    // The probe keeps what it finds.
    let _ = if axes == 1 { along(aim, probe) } else { simplex(axes, aim, probe) };
}

/// Along one axis.
fn along(aim: Aim, probe: &mut Probe) -> Option<()> {
    let ends = [probe(&[0.0])?, probe(&[1.0])?];
    if aim.is_between(ends) {
        return bisect(aim, [0.0, 1.0], ends[0], probe);
    }
    let places = [0.0, 0.25, 0.5, 0.75, 1.0];
    let mut values = [ends[0], 0.0, 0.0, 0.0, ends[1]];
    for k in 1..4 {
        values[k] = probe(&[places[k]])?;
    }
    if let Some(k) = (0..4).find(|&k| aim.is_between([values[k], values[k + 1]])) {
        return bisect(aim, [places[k], places[k + 1]], values[k], probe);
    }
    let misfit = |k: &usize| aim.misfit(values[*k]);
    let best = (0..5).min_by(|a, b| misfit(a).total_cmp(&misfit(b))).unwrap_or(2);
    golden(aim, [places[best.saturating_sub(1)], places[(best + 1).min(4)]], probe)
}

/// Halves an interval whose ends' values lie on both sides of a target.
fn bisect(aim: Aim, [mut a, mut b]: [f64; 2], at_a: f64, probe: &mut Probe) -> Option<()> {
    let mut value = at_a;
    while b - a > POINT {
        let middle = 0.5 * (a + b);
        let found = probe(&[middle])?;
        if found.is_nan() {
            return golden(aim, [a, b], probe);
        }
        if aim.is_between([value, found]) {
            b = middle;
        } else {
            (a, value) = (middle, found);
        }
    }
    Some(())
}

/// Narrows an interval by golden sections around its least misfit.
fn golden(aim: Aim, [mut a, mut b]: [f64; 2], probe: &mut Probe) -> Option<()> {
    let mut misfit = |x: f64| Some(aim.misfit(probe(&[x])?));
    let (mut left, mut right) = (b - GOLDEN * (b - a), a + GOLDEN * (b - a));
    let (mut at_left, mut at_right) = (misfit(left)?, misfit(right)?);
    while b - a > POINT {
        if at_left <= at_right {
            (b, right, at_right) = (right, left, at_left);
            left = b - GOLDEN * (b - a);
            at_left = misfit(left)?;
        } else {
            (a, left, at_left) = (left, right, at_right);
            right = a + GOLDEN * (b - a);
            at_right = misfit(right)?;
        }
    }
    Some(())
}

/// The search by a simplex that is reflected, stretched and drawn together.
fn simplex(axes: usize, aim: Aim, probe: &mut Probe) -> Option<()> {
    let mut misfit = |at: &[f64]| Some(aim.misfit(probe(at)?));
    let start = |k: usize| (0..axes).map(|i| if k == i + 1 { 0.85 } else { 0.4 }).collect::<Vec<f64>>();
    let mut corners = Vec::with_capacity(axes + 1);
    for k in 0..=axes {
        let at = start(k);
        corners.push((misfit(&at)?, at));
    }
    let is_point = |corners: &[(f64, Vec<f64>)]| {
        let width = |i: usize| corners.iter().map(|c| (c.1[i] - corners[0].1[i]).abs()).fold(0.0, f64::max);
        (0..axes).map(width).fold(0.0, f64::max) <= POINT
    };
    loop {
        corners.sort_by(|a, b| a.0.total_cmp(&b.0));
        if is_point(&corners) {
            return Some(());
        }
        let worst = corners[axes].clone();
        let middle: Vec<f64> =
            (0..axes).map(|i| corners[..axes].iter().map(|c| c.1[i]).sum::<f64>() / axes as f64).collect();
        let beyond = |far: f64| -> Vec<f64> {
            (0..axes).map(|i| (middle[i] + far * (middle[i] - worst.1[i])).clamp(0.0, 1.0)).collect()
        };
        let reflected = (misfit(&beyond(1.0))?, beyond(1.0));
        if reflected.0 < corners[0].0 {
            let stretched = (misfit(&beyond(2.0))?, beyond(2.0));
            corners[axes] = if stretched.0 < reflected.0 { stretched } else { reflected };
            continue;
        }
        if reflected.0 < corners[axes - 1].0 {
            corners[axes] = reflected;
            continue;
        }
        let far = if reflected.0 < worst.0 { 0.5 } else { -0.5 };
        let drawn = (misfit(&beyond(far))?, beyond(far));
        if drawn.0 < worst.0.min(reflected.0) {
            corners[axes] = drawn;
            continue;
        }
        let best = corners[0].1.clone();
        for corner in &mut corners[1..] {
            let at: Vec<f64> = corner.1.iter().zip(&best).map(|(v, b)| 0.5 * (v + b)).collect();
            *corner = (misfit(&at)?, at);
        }
    }
}
