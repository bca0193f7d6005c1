//! Loose material in slabs that slips at the angle of repose.

use serde::{Deserialize, Serialize};

use crate::grid::Shape;
use crate::math;

/// Sand on hard ground, in whole units, so that its amount is kept exactly. Wherever it is put or
/// taken, it slips at once until no site stands above a neighbour by more than the angle of repose
/// allows; hard ground may have any slope. Eight neighbours; a torus, or a field whose sides sand
/// does not slip over.
///
/// **Cost** of putting or taking: O(1) for sand at rest, and the length of the avalanche else;
/// never the size of the field.
///
/// ```
/// use landform_core::agents::Sand;
/// use landform_core::grid::Shape;
///
/// let mut pile = Sand::new(Shape::new(9, 9), true, vec![0; 81], [2, 2, 3], 1);
/// pile.put(40, 50);
/// assert_eq!(pile.total(), 50);
/// assert!(pile.surface()[36..45].windows(2).all(|w| (w[0] - w[1]).abs() <= 2));
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Sand {
    shape: Shape,
    torus: bool,
    /// Top of ground and sand, units.
    surface: Vec<i32>,
    /// Sand, units; negative marks sites that swallow what falls on them.
    depth: Vec<i32>,
    /// Greatest step to a neighbour along x, along y and diagonally, units.
    steps: [i32; 3],
    /// Units that slip at once.
    slab: i32,
    swallowed: i64,
    #[serde(skip)]
    pending: Vec<usize>,
}

/// Depth of sites that swallow.
const SINK: i32 = -1;
/// (column, row, which of the steps), nearest first so that ties go along the axes.
const AROUND: [(i32, i32, usize); 8] =
    [(1, 0, 0), (0, -1, 1), (-1, 0, 0), (0, 1, 1), (1, -1, 2), (-1, -1, 2), (-1, 1, 2), (1, 1, 2)];

impl Sand {
    /// Sand of depth 0 on hard ground.
    ///
    /// `ground` and everything else in units; `slab` is how much slips at once. The angle of repose
    /// is given as tan times the spacing over the height of a unit, for steps along x, y and the
    /// diagonal in turn: see [`Sand::steps_of`].
    pub fn new(shape: Shape, torus: bool, ground: Vec<i32>, steps: [i32; 3], slab: i32) -> Self {
        let depth = vec![0; ground.len()];
        Self {
            shape,
            torus,
            surface: ground,
            depth,
            steps: steps.map(|s| s.max(1)),
            slab: slab.max(1),
            swallowed: 0,
            pending: Vec::new(),
        }
    }

    /// Greatest steps in units for an angle of repose, radians, in slabs of so many units of height
    /// `unit`: whole slabs, at least one, along the axes not above the angle, diagonally the
    /// nearest to it (else piles would be pyramids: two slabs either way).
    pub fn steps_of(repose: f64, spacing: [f64; 2], unit: f64, slab: i32) -> [i32; 3] {
        let [dx, dy] = spacing;
        let height = unit * f64::from(slab);
        // A billionth more, so that an angle made of whole slabs allows just those.
        let slabs = |distance: f64| math::tan(repose) * distance / height * (1.0 + 1e-9);
        [slabs(dx).floor(), slabs(dy).floor(), slabs((dx * dx + dy * dy).sqrt()).round()]
            .map(|n| slab * (n as i32).max(1))
    }

    /// Rows and columns.
    pub fn shape(&self) -> Shape {
        self.shape
    }

    /// Top of ground and sand, units.
    pub fn surface(&self) -> &[i32] {
        &self.surface
    }

    /// Sand at a site, units.
    #[inline]
    pub fn depth(&self, site: usize) -> i32 {
        self.depth[site].max(0)
    }

    /// Whether a site swallows sand.
    #[inline]
    pub fn is_sink(&self, site: usize) -> bool {
        self.depth[site] < 0
    }

    /// All sand on the field, units.
    pub fn total(&self) -> i64 {
        self.depth.iter().map(|&d| i64::from(d.max(0))).sum()
    }

    /// Sand that sinks took so far, units.
    pub fn swallowed(&self) -> i64 {
        self.swallowed
    }

    /// Thickness of a slab, units that slip at once.
    pub fn slab(&self) -> i32 {
        self.slab
    }

    /// Sets the height of the hard ground and the sand on it, after a change from outside. Sand
    /// that is then too steep slips when it is next touched; sites that swallow keep no sand.
    pub fn set_site(&mut self, site: usize, ground: i32, depth: i32) {
        if !self.is_sink(site) {
            self.depth[site] = depth.max(0);
        }
        self.surface[site] = ground + self.depth(site);
    }

    /// Takes up to `units` of sand without letting any slip; call [`Sand::settle`] after. Returns
    /// the units taken.
    pub fn lift(&mut self, site: usize, units: i32) -> i32 {
        let taken = units.min(self.depth(site));
        self.depth[site] -= taken.max(0);
        self.surface[site] -= taken.max(0);
        taken
    }

    /// Sets the units that slip at once from now on.
    pub fn set_slab(&mut self, units: i32) {
        self.slab = units.max(1);
    }

    /// Makes a site a sink: it swallows the sand that falls on it and the sand that lies there.
    pub fn make_sink(&mut self, site: usize) {
        let lying = self.depth(site);
        self.surface[site] -= lying;
        self.swallowed += i64::from(lying);
        self.depth[site] = SINK;
    }

    /// Puts sand without letting it slip: for beginnings; call [`Sand::settle`] after.
    pub fn lay(&mut self, site: usize, units: i32) {
        if self.is_sink(site) {
            self.swallowed += i64::from(units);
        } else {
            self.depth[site] += units;
            self.surface[site] += units;
        }
    }

    /// Puts sand, and lets it slip.
    #[inline]
    pub fn put(&mut self, site: usize, units: i32) {
        if self.is_sink(site) {
            self.swallowed += i64::from(units);
            return;
        }
        self.depth[site] += units;
        self.surface[site] += units;
        self.slip_from(site);
    }

    /// Takes up to `units` of sand, and lets sand slip into the gap. Returns the units taken.
    #[inline]
    pub fn take(&mut self, site: usize, units: i32) -> i32 {
        let taken = units.min(self.depth(site));
        if taken > 0 {
            self.depth[site] -= taken;
            self.surface[site] -= taken;
            self.slip_into(site);
        }
        taken
    }

    /// Lets all sand slip that is too steep.
    pub fn settle(&mut self) {
        for site in 0..self.shape.len() {
            if self.depth[site] > 0 {
                self.slip_from(site);
            }
        }
    }

    /// Row and column of a site; 32-bit division is several times as fast.
    #[inline]
    fn place(&self, site: usize) -> (usize, usize) {
        let (site, cols) = (site as u32, self.shape.cols as u32);
        ((site / cols) as usize, (site % cols) as usize)
    }

    /// The neighbour in a direction; none over a side that sand does not slip over.
    #[inline]
    fn beside(&self, site: usize, col: usize, row: usize, by: (i32, i32, usize)) -> Option<usize> {
        let Shape { rows, cols } = self.shape;
        // Wrapping arithmetic takes care of -1.
        let (c, r) = (col.wrapping_add_signed(by.0 as isize), row.wrapping_add_signed(by.1 as isize));
        if c < cols && r < rows {
            return Some((site as isize + by.1 as isize * cols as isize + by.0 as isize) as usize);
        }
        let wrap = |at: usize, n: usize| if at == n { 0 } else { at.min(n - 1) };
        self.torus.then(|| self.shape.index(wrap(r, rows), wrap(c, cols)))
    }

    /// The neighbour that the site stands above by most over what is allowed, if it does.
    #[inline]
    fn downhill(&self, site: usize) -> Option<usize> {
        let z = self.surface[site];
        let Shape { rows, cols } = self.shape;
        let (row, col) = self.place(site);
        let [x, y, d] = self.steps;
        if row > 0 && row + 1 < rows && col > 0 && col + 1 < cols {
            // Almost always at rest: one look without branches.
            let s = &self.surface;
            let (up, at, down) =
                (&s[site - cols - 1..site - cols + 2], &s[site - 1..site + 2], &s[site + cols - 1..site + cols + 2]);
            let along = up[1].min(down[1]).saturating_add(y).min(at[0].min(at[2]).saturating_add(x));
            let across = up[0].min(up[2]).min(down[0].min(down[2])).saturating_add(d);
            if z <= along.min(across) {
                return None;
            }
        }
        self.extreme(site, col, row, |n| Some(z - self.surface[n]))
    }

    /// The neighbour with sand that stands above the site by most over what is allowed, if one
    /// does.
    #[inline]
    fn uphill(&self, site: usize) -> Option<usize> {
        let z = self.surface[site];
        let Shape { rows, cols } = self.shape;
        let (row, col) = self.place(site);
        let [x, y, d] = self.steps;
        if row > 0 && row + 1 < rows && col > 0 && col + 1 < cols {
            let s = &self.surface;
            let (up, at, down) =
                (&s[site - cols - 1..site - cols + 2], &s[site - 1..site + 2], &s[site + cols - 1..site + cols + 2]);
            let along = (up[1].max(down[1]) - y).max(at[0].max(at[2]) - x);
            let across = up[0].max(up[2]).max(down[0].max(down[2])) - d;
            if z >= along.max(across) {
                return None;
            }
        }
        self.extreme(site, col, row, |n| (self.depth[n] > 0).then(|| self.surface[n] - z))
    }

    /// The neighbour for which `drop` is most over what is allowed; none where it is not, or there
    /// is no drop.
    fn extreme(&self, site: usize, col: usize, row: usize, drop: impl Fn(usize) -> Option<i32>) -> Option<usize> {
        let mut best = (0, None);
        for by in AROUND {
            if let Some(n) = self.beside(site, col, row, by)
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

    #[inline]
    fn slip_from(&mut self, site: usize) {
        if let Some(to) = self.downhill(site) {
            self.pending.clear();
            self.fall(site, to);
            self.avalanche();
        }
    }

    #[inline]
    fn slip_into(&mut self, site: usize) {
        if let Some(from) = self.uphill(site) {
            self.pending.clear();
            self.fall(from, site);
            self.avalanche();
        }
    }

    /// Moves a slab from a site to a lower neighbour; both sites and those above the first are
    /// examined again.
    fn fall(&mut self, from: usize, to: usize) {
        // At most half of the drop, so that every fall brings sand down and avalanches end; where
        // it towers, more than a slab at once.
        let drop = self.surface[from] - self.surface[to];
        let over = drop - self.steps[0].max(self.steps[1]).max(self.steps[2]);
        let amount = self.slab.max(over / 4).min(self.depth[from]).min((drop / 2).max(1));
        self.depth[from] -= amount;
        self.surface[from] -= amount;
        if self.is_sink(to) {
            self.swallowed += i64::from(amount);
        } else {
            self.depth[to] += amount;
            self.surface[to] += amount;
        }
        self.pending.extend([from, to]);
    }

    fn avalanche(&mut self) {
        while let Some(site) = self.pending.pop() {
            if self.depth[site] > 0
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Seed;

    fn worst(sand: &Sand) -> i32 {
        let mut worst = i32::MIN;
        for site in 0..sand.shape.len() {
            if sand.depth[site] > 0 {
                let (row, col) = (site / sand.shape.cols, site % sand.shape.cols);
                for by in AROUND {
                    if let Some(n) = sand.beside(site, col, row, by) {
                        worst = worst.max(sand.surface[site] - sand.surface[n] - sand.steps[by.2]);
                    }
                }
            }
        }
        worst
    }

    #[test]
    fn nothing_is_lost_and_nothing_stands_steeper_than_repose() {
        for torus in [true, false] {
            let shape = Shape::new(23, 31);
            let ground = (0..shape.len()).map(|i| if i % 31 == 7 { 60 } else { 0 }).collect();
            let mut sand = Sand::new(shape, torus, ground, [16, 16, 22], 8);
            let mut draws = Seed(4).draws();
            let mut kept = 0;
            for k in 0..20_000 {
                let site = draws.below(shape.len());
                if k % 3 == 0 {
                    kept -= i64::from(sand.take(site, 8));
                } else {
                    sand.put(site, 8);
                    kept += 8;
                }
            }
            assert_eq!(sand.total(), kept);
            assert!(worst(&sand) <= 0, "{}", worst(&sand));
        }
    }

    #[test]
    fn a_pile_is_a_round_cone() {
        let shape = Shape::new(81, 81);
        let mut sand =
            Sand::new(shape, false, vec![0; shape.len()], Sand::steps_of(33f64.to_radians(), [1.0; 2], 0.04, 8), 8);
        for _ in 0..12_000 {
            sand.put(40 * 81 + 40, 8);
        }
        let top = sand.surface[40 * 81 + 40];
        let reach = |dc: usize, dr: usize| {
            (1..40).take_while(|&k| sand.depth(shape.index(40 + k * dr, 40 + k * dc)) > 0).count() as f64
        };
        let (along, across) = (reach(1, 0), reach(1, 1) * 2f64.sqrt());
        assert!(top > 250 && (along / across - 1.0).abs() < 0.15, "{top} {along} {across}");
    }

    #[test]
    fn a_sink_swallows_what_slips_into_it() {
        let shape = Shape::new(9, 9);
        let mut sand = Sand::new(shape, false, vec![0; 81], [2, 2, 2], 1);
        (0..9).for_each(|r| sand.make_sink(r * 9));
        for _ in 0..500 {
            sand.put(40, 1);
        }
        assert!(sand.swallowed() > 0);
        assert_eq!(sand.total() + sand.swallowed(), 500);
    }
}
