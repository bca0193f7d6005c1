//! How sand slips: looks at a site's neighbours, and avalanches.

use super::{Sand, depth_of, word};
use crate::grid::Shape;

/// (column, row, which of the steps), nearest first so that ties go along the axes.
pub(super) const AROUND: [(i32, i32, usize); 8] =
    [(1, 0, 0), (0, -1, 1), (-1, 0, 0), (0, 1, 1), (1, -1, 2), (-1, -1, 2), (-1, 1, 2), (1, 1, 2)];

impl Sand {
    /// Row and column of a site; 32-bit division is several times as fast.
    #[inline]
    fn place(&self, site: usize) -> (usize, usize) {
        let (site, cols) = (site as u32, self.shape.cols as u32);
        ((site / cols) as usize, (site % cols) as usize)
    }

    /// The neighbour in a direction; none over a side that sand does not slip over.
    #[inline]
    pub(super) fn beside(&self, site: usize, by: (i32, i32, usize)) -> Option<usize> {
        let Shape { rows, cols } = self.shape;
        let (row, col) = self.place(site);
        // Wrapping arithmetic takes care of -1.
        let (c, r) = (col.wrapping_add_signed(by.0 as isize), row.wrapping_add_signed(by.1 as isize));
        if c < cols && r < rows {
            return Some(self.within(site, by));
        }
        let wrap = |at: usize, n: usize| if at == n { 0 } else { at.min(n - 1) };
        self.torus.then(|| self.shape.index(wrap(r, rows), wrap(c, cols)))
    }

    /// The neighbour in a direction in which the field goes on.
    #[inline]
    fn within(&self, site: usize, by: (i32, i32, usize)) -> usize {
        site.wrapping_add_signed(by.1 as isize * self.shape.cols as isize + by.0 as isize)
    }

    /// Heights of the neighbours in the order of [`AROUND`]; none on the rim.
    #[inline]
    fn around(&self, site: usize) -> Option<[i32; 8]> {
        if self.sites[site] & word::RIM != 0 {
            return None;
        }
        let row = |at: usize| self.surface.get(at - 1..)?.first_chunk::<3>();
        let (up, at, down) = (row(site - self.shape.cols)?, row(site)?, row(site + self.shape.cols)?);
        Some([at[2], up[1], at[0], down[1], up[2], up[0], down[0], down[2]])
    }

    /// The neighbour that the site stands above by most over what is allowed, if it does.
    #[inline]
    fn downhill(&self, site: usize) -> Option<usize> {
        let z = self.surface[site];
        let [x, y, d] = self.steps;
        let Some(h) = self.around(site) else {
            return self.over_the_rim(site, |n| Some(z - self.surface[n]));
        };
        // Almost always at rest: one look without branches.
        let along = (h[1].min(h[3]) + y).min(h[0].min(h[2]) + x);
        if z <= along.min(h[4].min(h[5]).min(h[6].min(h[7])) + d) {
            return None;
        }
        let mut best = (0, None);
        for (by, h) in AROUND.iter().zip(h) {
            let over = z - h - self.steps[by.2];
            if over > best.0 {
                best = (over, Some(by));
            }
        }
        best.1.map(|&by| self.within(site, by))
    }

    /// The neighbour with sand that stands above the site by most over what is allowed, if one
    /// does.
    #[inline]
    fn uphill(&self, site: usize) -> Option<usize> {
        let z = self.surface[site];
        let [x, y, d] = self.steps;
        let Some(h) = self.around(site) else {
            return self.over_the_rim(site, |n| (depth_of(self.sites[n]) > 0).then(|| self.surface[n] - z));
        };
        let along = (h[1].max(h[3]) - y).max(h[0].max(h[2]) - x);
        if z >= along.max(h[4].max(h[5]).max(h[6].max(h[7])) - d) {
            return None;
        }
        let mut best = (0, None);
        for (&by, h) in AROUND.iter().zip(h) {
            let over = h - z - self.steps[by.2];
            if over > best.0 {
                let n = self.within(site, by);
                if depth_of(self.sites[n]) > 0 {
                    best = (over, Some(n));
                }
            }
        }
        best.1
    }

    /// The neighbour of a site on the rim for which `drop` is most over what is allowed; none where
    /// it is not, or there is no drop.
    #[cold]
    fn over_the_rim(&self, site: usize, drop: impl Fn(usize) -> Option<i32>) -> Option<usize> {
        let mut best = (0, None);
        for by in AROUND {
            if let Some(n) = self.beside(site, by)
                && let Some(drop) = drop(n)
            {
                let over = drop - self.steps[by.2];
                if over > best.0 {
                    best = (over, Some(n));
                }
            }
        }
        best.1
    }

    /// Lets sand slip from a site that was raised.
    #[inline]
    pub(super) fn slip_from(&mut self, site: usize) {
        if let Some(to) = self.downhill(site) {
            self.pending.clear();
            self.fall(site, to);
            self.avalanche();
        }
    }

    /// Lets sand slip into a site that was lowered.
    #[inline]
    pub(super) fn slip_into(&mut self, site: usize) {
        if let Some(from) = self.uphill(site) {
            self.pending.clear();
            self.fall(from, site);
            self.avalanche();
        }
    }

    /// Moves a slab from a site to a lower neighbour; both sites and those above the first are
    /// examined again.
    #[inline]
    fn fall(&mut self, from: usize, to: usize) {
        // At most half of the drop, so that every fall brings sand down and avalanches end; where
        // it towers, more than a slab at once.
        let drop = self.surface[from] - self.surface[to];
        let over = drop - self.steps[0].max(self.steps[1]).max(self.steps[2]);
        let amount = self.slab.max(over / 4).min(self.depth(from)).min((drop / 2).max(1));
        self.add(from, -amount);
        if self.is_sink(to) {
            self.swallowed += i64::from(amount);
        } else {
            self.add(to, amount);
        }
        self.pending.extend([from, to]);
    }

    fn avalanche(&mut self) {
        while let Some(site) = self.pending.pop() {
            if self.depth(site) > 0
                && let Some(to) = self.downhill(site)
            {
                self.fall(site, to);
            } else if !self.is_sink(site)
                && let Some(from) = self.uphill(site)
            {
                self.fall(from, site);
                // There may be more above.
                self.pending.push(site);
            }
        }
    }
}
