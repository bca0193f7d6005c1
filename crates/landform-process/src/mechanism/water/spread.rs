//! Shares of a site's water among its lower neighbours.
//!
//! # Sources
//! Pytel (2015), figure 4.11 for columns and listing 4.2 for averages. Columns are levelled in
//! closed form: neighbours are raised in order of height until the water is used up, which gives
//! the same result as the thesis' steps of raising m sites to the level of the next. Levels count
//! as far below a site as they would lie a cell away from it: by height alone, as in the thesis,
//! the corner is lower than the side on nearly every slope, and all water runs along diagonals.
//! Equal shares turn water up to 6 degrees towards the sides, those by distance less than 3.

use landform_core::grid::{Domain, Neighbours, RasterDomain};

/// Differences of height below this are ignored, m: a power of two, so that heights are rounded
/// exactly.
pub(super) const GRAIN: f64 = 1.0 / (1 << 22) as f64;

/// Rule of sharing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rule {
    /// The neighbours down the steepest slopes first, each raised to the level of the next; `depth`
    /// m of water where all the water of the map runs, less with the root of the flow.
    Columns {
        /// The depth, m.
        depth: f64,
    },
    /// All lower neighbours, as one over the square of the distance to them, whatever the slope.
    Average,
    /// All lower neighbours, in proportion to the slopes to them.
    Weighted,
}

/// The lower neighbours of a site, the one down the steepest slope first: node, drop and share,
/// before shares are set the nearness.
#[derive(Clone, Copy, Debug, Default)]
pub struct FlowPartition {
    list: [(u32, f64, f64); 8],
    len: usize,
}

impl FlowPartition {
    /// The neighbours whose ground is lower than a node's, with drops to the levels (m) that
    /// `level` gives, scaled to a cell's distance; those whose level is not lower are left out.
    #[inline]
    pub fn from_neighbours(domain: &RasterDomain, ground: &[f64], node: usize, level: impl Fn(usize) -> f64) -> Self {
        let (z, cell, mut lower) = (ground[node], domain.cell(), Self::default());
        for link in domain.neighbours(node).filter(|l| ground[l.to] < z) {
            let level = level(link.to);
            if level < z {
                let drop = (z - level) * (domain.steepness(node, link.slot) * cell);
                let near = cell * domain.inverse_distance(node, link.slot);
                lower.push(link.to, [drop, near * near]);
            }
        }
        lower
    }

    /// Adds a neighbour, by its drop: how far its level lies below the site's over a cell's
    /// distance, m, > 0; and by its nearness: one over the square of the distance to it, in cells.
    #[inline]
    pub fn push(&mut self, node: usize, [drop, near]: [f64; 2]) {
        let mut k = self.len;
        while k > 0 && self.list[k - 1].1 < drop {
            self.list[k] = self.list[k - 1];
            k -= 1;
        }
        self.list[k] = (node as u32, drop, near);
        self.len += 1;
    }

    /// Whether there are none.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Nodes and shares, which add up to 1 once they are set; neighbours without a share are left
    /// out.
    #[inline]
    pub fn weights(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        self.list[..self.len].iter().filter(|l| l.2 > 0.0).map(|l| (l.0 as usize, l.2))
    }

    /// Level (m, above the site) to which `water` (m) on it raises it and its neighbours: the
    /// common level of those that get wet, at most level with the site; shares are depths.
    ///
    /// With n neighbours that end up wet the level is (water − their drops) / n, and one more
    /// term where the site stays wet.
    pub fn equalise(&mut self, water: f64) -> f64 {
        let (mut left, mut sum) = (water, 0.0);
        let mut level = 0.0;
        for m in 0..=self.len {
            let next = if m < self.len { -self.list[m].1 } else { 0.0 };
            let room = m as f64 * next - sum;
            if m > 0 && water <= room {
                level = (water + sum) / m as f64;
                left = 0.0;
                break;
            }
            sum += next;
        }
        if left > 0.0 {
            level = (water + sum) / (self.len + 1) as f64;
        }
        for l in &mut self.list[..self.len] {
            l.2 = (level + l.1).max(0.0);
        }
        level
    }

    /// Sets the shares of a site through which `part` of all the map's water runs.
    #[inline]
    pub fn set_weights(&mut self, rule: Rule, part: f64) {
        if self.is_empty() {
            return;
        }
        let total: f64 = match rule {
            Rule::Columns { depth } => {
                let water = depth * part.sqrt();
                // On level ground rivers keep together.
                let is_level = self.list[0].1 < 0.5 * GRAIN;
                if self.len == 1 || is_level || water <= self.list[0].1 - self.list[1].1 {
                    self.list[..self.len].iter_mut().for_each(|l| l.2 = 0.0);
                    self.list[0].2 = 1.0;
                    return;
                }
                self.equalise(water);
                self.list[..self.len].iter().map(|l| l.2).sum()
            }
            Rule::Average => self.list[..self.len].iter().map(|l| l.2).sum(),
            Rule::Weighted => {
                self.list[..self.len].iter_mut().for_each(|l| l.2 = l.1);
                self.list[..self.len].iter().map(|l| l.2).sum()
            }
        };
        self.list[..self.len].iter_mut().for_each(|l| l.2 /= total);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lower(top: f64, levels: &[f64]) -> FlowPartition {
        let mut lower = FlowPartition::default();
        levels.iter().enumerate().for_each(|(k, &l)| lower.push(k, [top - l, 1.0]));
        lower
    }

    #[test]
    fn columns_end_on_the_level_of_water_filling() {
        // WC3: level = (w + sum of wet heights) / number of wet sites.
        let cases: [(&[f64], f64, f64, f64); 5] = [
            (&[1.0, 2.0, 5.0], 9.0, 0.5, 1.5),
            (&[2.0, 1.0, 5.0], 9.0, 3.0, 3.0),
            (&[1.0, 2.0, 5.0], 9.0, 10.0, 6.0),
            (&[1.0, 2.0, 5.0], 9.0, 25.0, 10.5),
            (&[3.0], 4.0, 5.0, 6.0),
        ];
        for (heights, top, water, expected) in cases {
            let mut l = lower(top, heights);
            let level = top + l.equalise(water);
            assert!((level - expected).abs() < 1e-12, "{heights:?} {water}: {level}");
            let given: f64 = l.weights().map(|s| s.1).sum();
            let kept = (level - top).max(0.0);
            assert!((given + kept - water).abs() < 1e-12, "WC1");
        }
    }

    #[test]
    fn shares_add_up_and_columns_prefer_the_lowest() {
        for rule in [Rule::Columns { depth: 2.0 }, Rule::Average, Rule::Weighted] {
            let mut l = lower(5.0, &[4.0, 1.0, 2.5, 3.0]);
            l.set_weights(rule, 1.0);
            let total: f64 = l.weights().map(|s| s.1).sum();
            assert!((total - 1.0).abs() < 1e-15);
            let of = |node: usize| l.weights().find(|s| s.0 == node).map_or(0.0, |s| s.1);
            match rule {
                Rule::Columns { .. } => assert!(of(1) > 0.8 && of(0) == 0.0),
                Rule::Average => assert_eq!(of(0), 0.25),
                Rule::Weighted => assert!((of(1) - 4.0 / 9.5).abs() < 1e-15),
            }
        }
    }
}
