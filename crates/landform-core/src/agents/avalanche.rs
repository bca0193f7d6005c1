//! Avalanches: one event makes similar events around it more likely.

use super::{RasterSites, Search, Sites};
use crate::grid::Link;

/// How an avalanche's effect falls off with distance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Falloff {
    /// It does not fall off up to the radius.
    Constant,
    /// Linearly to 0 at the radius.
    Linear,
    /// As a parabola to 0 at the radius, level at the origin.
    Smooth,
}

impl Falloff {
    /// The weight at a part (0 to 1) of the radius.
    #[inline]
    pub fn at(self, part: f64) -> f64 {
        match self {
            Self::Constant => 1.0,
            Self::Linear => (1.0 - part).max(0.0),
            Self::Smooth => (1.0 - part * part).max(0.0),
        }
    }
}

/// Triggers an avalanche: `change` is called with every site within `radius` m of the origin (which
/// comes first) that can be reached along links that `through` lets pass, with the weight that the
/// event has there. **Cost** O(sites in the radius), whatever the size of the graph.
pub fn avalanche<D: Sites>(
    sites: &D,
    search: &mut Search,
    origin: usize,
    radius: f64,
    falloff: Falloff,
    through: impl FnMut(usize, Link) -> bool,
    mut change: impl FnMut(usize, f64),
) {
    search.within(sites, origin, radius, through, |site, distance| {
        change(site, falloff.at(distance / radius));
        true
    });
}

/// Lets events trigger events until none is left: `topple` acts on a site and pushes those that it
/// may have triggered. The last one pushed is taken first. `pending` holds the first ones and is
/// scratch afterwards. The caller's rule must lose something with every topple, or this does not
/// end.
pub fn cascade(pending: &mut Vec<usize>, mut topple: impl FnMut(usize, &mut Vec<usize>)) {
    while let Some(site) = pending.pop() {
        topple(site, pending);
    }
}

/// The sites around any site of a raster that an event reaches, with weights, found once: the fast
/// form of [`avalanche()`] where no link is excluded.
#[derive(Clone, Debug)]
pub struct Stencil {
    /// Columns east, rows south, weight.
    reach: Vec<(i32, i32, f64)>,
}

impl Stencil {
    /// A disc of a radius, m; the centre is part of it.
    pub fn disc(spacing: [f64; 2], radius: f64, falloff: Falloff) -> Self {
        Self::of(spacing, radius, falloff, |_| true)
    }

    /// A cone: the part of a disc within `half_angle` of a direction (x east, y north), without the
    /// centre.
    pub fn cone(spacing: [f64; 2], radius: f64, direction: [f64; 2], half_angle: f64, falloff: Falloff) -> Self {
        let length = (direction[0] * direction[0] + direction[1] * direction[1]).sqrt();
        let least = crate::math::cos(half_angle) - 1e-12;
        Self::of(spacing, radius, falloff, |[x, y]| {
            let d = (x * x + y * y).sqrt();
            d > 0.0 && (x * direction[0] + y * direction[1]) >= least * d * length
        })
    }

    fn of(spacing: [f64; 2], radius: f64, falloff: Falloff, holds: impl Fn([f64; 2]) -> bool) -> Self {
        let [cols, rows] = spacing.map(|s| (radius / s).floor() as i32);
        let mut reach = Vec::new();
        for r in -rows..=rows {
            for c in -cols..=cols {
                let at = [f64::from(c) * spacing[0], -f64::from(r) * spacing[1]];
                let d = (at[0] * at[0] + at[1] * at[1]).sqrt();
                if d <= radius && holds(at) {
                    reach.push((c, r, falloff.at(d / radius)));
                }
            }
        }
        Self { reach }
    }

    /// Number of sites that an event reaches.
    pub fn len(&self) -> usize {
        self.reach.len()
    }

    /// Whether it reaches none.
    pub fn is_empty(&self) -> bool {
        self.reach.is_empty()
    }

    /// Columns east, rows south and weight of every site that an event reaches.
    ///
    /// ```
    /// use landform_core::agents::{Falloff, Stencil};
    ///
    /// let disc = Stencil::disc([10.0; 2], 10.0, Falloff::Constant);
    /// assert_eq!(disc.offsets().count(), 5);
    /// ```
    pub fn offsets(&self) -> impl Iterator<Item = (i32, i32, f64)> {
        self.reach.iter().copied()
    }

    /// Calls `change` with every site that an event at `origin` reaches, and its weight. Sides do
    /// what the raster's edges say.
    #[inline]
    pub fn apply(&self, sites: &RasterSites, origin: usize, mut change: impl FnMut(usize, f64)) {
        for &(c, r, weight) in &self.reach {
            if let Some(site) = sites.moved(origin, i64::from(c), i64::from(r)) {
                change(site, weight);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::Connectivity;
    use super::*;
    use crate::grid::{Edge, Edges, Grid, Shape};

    #[test]
    fn a_stencil_is_the_avalanche_with_nothing_in_the_way() {
        let mut grid = Grid::new(Shape::new(30, 40), [2.0, 2.0]).unwrap();
        grid.edges = Edges::all(Edge::Periodic);
        let sites = RasterSites::new(&grid, Connectivity::Eight).unwrap();
        let (mut a, mut b) = (vec![0.0; 1200], vec![0.0; 1200]);
        let mut search = Search::new(1200);
        for origin in [0, 615, 1199] {
            avalanche(&sites, &mut search, origin, 9.0, Falloff::Linear, |_, _| true, |i, w| a[i] += w);
            Stencil::disc([2.0; 2], 9.0, Falloff::Linear).apply(&sites, origin, |i, w| b[i] += w);
        }
        assert!(a.iter().zip(&b).all(|(a, b)| (a - b).abs() < 1e-12) && a[0] >= 1.0);
    }

    #[test]
    fn a_cone_opens_downwind() {
        let cone = Stencil::cone([1.0; 2], 10.0, [1.0, 0.0], 15f64.to_radians(), Falloff::Constant);
        assert!(cone.reach.iter().all(|&(c, r, _)| c > 0 && r.abs() * 3 <= c));
        assert!(cone.reach.contains(&(10, 0, 1.0)) && !cone.is_empty() && cone.len() > 15);
    }

    #[test]
    fn bak_tang_and_wiesenfelds_pile_does_not_care_for_the_order() {
        // The abelian sandpile: the same end whatever topples first.
        let n = 15;
        let pile = |reverse: bool| {
            let mut grains: Vec<u32> = (0..n * n).map(|i| 3 + (i as u32 * 7) % 5).collect();
            let mut pending: Vec<usize> = (0..n * n).collect();
            if reverse {
                pending.reverse();
            }
            cascade(&mut pending, |i, pending| {
                if grains[i] < 4 {
                    return;
                }
                grains[i] -= 4;
                pending.push(i);
                let (r, c) = (i / n, i % n);
                for (rr, cc) in [(r.wrapping_sub(1), c), (r + 1, c), (r, c.wrapping_sub(1)), (r, c + 1)] {
                    if rr < n && cc < n {
                        grains[rr * n + cc] += 1;
                        pending.push(rr * n + cc);
                    }
                }
            });
            grains
        };
        assert!(pile(false) == pile(true) && pile(true).iter().all(|&g| g < 4));
    }
}
