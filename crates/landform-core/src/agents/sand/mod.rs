//! Loose material in slabs that slips at the angle of repose.

use std::ops::Range;

use serde::{Deserialize, Serialize};

mod slip;

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
    /// What lies on each site, in a word: the parts of [`word`].
    sites: Vec<u32>,
    /// Greatest step to a neighbour along x, along y and diagonally, units.
    steps: [i32; 3],
    /// Units that slip at once.
    slab: i32,
    swallowed: i64,
    #[serde(skip)]
    pending: Vec<usize>,
}

/// Parts of a site's word. Whether the wind finds sand there, and whether what lands stays, are one
/// comparison each.
mod word {
    /// Whether what lands stays for certain; always of sinks.
    pub(super) const KEEPS: u32 = 1 << 31;
    /// Whether the site swallows what falls on it.
    pub(super) const SINK: u32 = 1 << 30;
    /// A unit of sand.
    pub(super) const UNIT: u32 = 2;
    /// Whether the site is on a side of the field.
    pub(super) const RIM: u32 = 1;
}

/// Greatest depth of sand of a site, units.
const MOST: i32 = (1 << 29) - 1;

/// Sand of a site's word, units.
#[inline]
fn depth_of(site: u32) -> i32 {
    ((site & !(word::KEEPS | word::SINK)) / word::UNIT) as i32
}

/// Which sites of a field of sand are in shelter. At the beginning none is.
///
/// ```
/// use landform_core::agents::Sand;
/// use landform_core::grid::Shape;
///
/// let mut sand = Sand::new(Shape::new(1, 3), false, vec![0; 3], [9; 3], 1);
/// sand.shelter().1.set(0, &[true, true]);
/// assert_eq!([0, 1, 2].map(|site| sand.keeps(site)), [true, true, false]);
/// ```
pub struct Shelter<'a> {
    sites: &'a mut [u32],
}

impl Shelter<'_> {
    /// Marks which of a run of sites are in shelter, from the first on.
    ///
    /// ```
    /// use landform_core::agents::Sand;
    /// use landform_core::grid::Shape;
    ///
    /// let mut sand = Sand::new(Shape::new(1, 3), false, vec![0; 3], [9; 3], 1);
    /// sand.put(1, 4);
    /// sand.shelter().1.set(1, &[true]);
    /// sand.shelter().1.set(1, &[false]);
    /// assert!(sand.is_exposed(1));
    /// ```
    #[inline]
    pub fn set(&mut self, first: usize, are_sheltered: &[bool]) {
        for (site, &is_sheltered) in self.sites[first..].iter_mut().zip(are_sheltered) {
            // A sink keeps what lands, sheltered or not.
            let of_sink = (*site & word::SINK) * (word::KEEPS / word::SINK);
            *site = (*site & !word::KEEPS) | of_sink | (u32::from(is_sheltered) * word::KEEPS);
        }
    }
}

impl Sand {
    /// Sand of depth 0 on hard ground.
    ///
    /// `ground` and everything else in units; `slab` is how much slips at once. The angle of repose
    /// is given as tan times the spacing over the height of a unit, for steps along x, y and the
    /// diagonal in turn: see [`Sand::steps_of`].
    pub fn new(shape: Shape, torus: bool, ground: Vec<i32>, steps: [i32; 3], slab: i32) -> Self {
        let Shape { rows, cols } = shape;
        let is_rim = |row: usize, col: usize| row == 0 || row + 1 == rows || col == 0 || col + 1 == cols;
        let places = (0..rows).flat_map(|row| (0..cols).map(move |col| (row, col)));
        Self {
            shape,
            torus,
            surface: ground,
            sites: places.map(|(row, col)| if is_rim(row, col) { word::RIM } else { 0 }).collect(),
            // No drop is greater.
            steps: steps.map(|s| s.clamp(1, 1 << 29)),
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
        depth_of(self.sites[site])
    }

    /// Whether sand lies at a site that the wind reaches: see [`Sand::shelter`].
    ///
    /// ```
    /// use landform_core::agents::Sand;
    /// use landform_core::grid::Shape;
    ///
    /// let mut sand = Sand::new(Shape::new(1, 3), false, vec![0; 3], [9; 3], 1);
    /// sand.put(1, 4);
    /// assert_eq!([0, 1].map(|site| sand.is_exposed(site)), [false, true]);
    /// ```
    #[inline]
    pub fn is_exposed(&self, site: usize) -> bool {
        self.sites[site] as i32 >= word::UNIT as i32
    }

    /// Whether sand that lands at a site stays for certain: it is a sink or in shelter.
    ///
    /// ```
    /// use landform_core::agents::Sand;
    /// use landform_core::grid::Shape;
    ///
    /// let mut sand = Sand::new(Shape::new(1, 3), false, vec![0; 3], [9; 3], 1);
    /// sand.put(1, 4);
    /// sand.make_sink(2);
    /// assert_eq!([1, 2].map(|site| sand.keeps(site)), [false, true]);
    /// ```
    #[inline]
    pub fn keeps(&self, site: usize) -> bool {
        self.sites[site] & word::KEEPS != 0
    }

    /// The surface, units, and the shelter of the sites, to be marked from it.
    ///
    /// ```
    /// use landform_core::agents::Sand;
    /// use landform_core::grid::Shape;
    ///
    /// let mut sand = Sand::new(Shape::new(1, 3), false, vec![0; 3], [9; 3], 1);
    /// sand.put(1, 4);
    /// let (surface, mut shelter) = sand.shelter();
    /// assert_eq!(surface, [0, 4, 0]);
    /// shelter.set(1, &[true, false]);
    /// assert!(sand.keeps(1) && !sand.is_exposed(1));
    /// ```
    pub fn shelter(&mut self) -> (&[i32], Shelter<'_>) {
        (&self.surface, Shelter { sites: &mut self.sites })
    }

    /// Whether a site swallows sand.
    #[inline]
    pub fn is_sink(&self, site: usize) -> bool {
        self.sites[site] & word::SINK != 0
    }

    /// Sand of every site, units.
    ///
    /// ```
    /// use landform_core::agents::Sand;
    /// use landform_core::grid::Shape;
    ///
    /// let mut sand = Sand::new(Shape::new(1, 3), false, vec![0; 3], [9; 3], 1);
    /// sand.put(1, 4);
    /// assert!(sand.depths().eq([0, 4, 0]));
    /// ```
    pub fn depths(&self) -> impl Iterator<Item = i32> {
        self.depths_of(0..self.sites.len())
    }

    /// Sand of a range of sites, units.
    ///
    /// ```
    /// use landform_core::agents::Sand;
    /// use landform_core::grid::Shape;
    ///
    /// let mut sand = Sand::new(Shape::new(1, 3), false, vec![0; 3], [9; 3], 1);
    /// sand.put(1, 4);
    /// assert!(sand.depths_of(1..3).eq([4, 0]));
    /// ```
    pub fn depths_of(&self, sites: Range<usize>) -> impl Iterator<Item = i32> {
        self.sites[sites].iter().map(|&site| depth_of(site))
    }

    /// All sand on the field, units.
    pub fn total(&self) -> i64 {
        self.depths().map(i64::from).sum()
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
        let lying = self.depth(site);
        let depth = if self.is_sink(site) { 0 } else { depth.clamp(0, MOST) };
        self.add(site, depth - lying);
        self.surface[site] = ground + depth;
    }

    /// Adds sand, or takes away what is known to lie there.
    #[inline]
    fn add(&mut self, site: usize, units: i32) {
        self.sites[site] = self.sites[site].wrapping_add((units as u32).wrapping_mul(word::UNIT));
        self.surface[site] += units;
    }

    /// Takes up to `units` of sand without letting any slip; call [`Sand::settle`] after. Returns
    /// the units taken.
    pub fn lift(&mut self, site: usize, units: i32) -> i32 {
        let taken = units.min(self.depth(site));
        self.add(site, -taken.max(0));
        taken
    }

    /// Sets the units that slip at once from now on.
    pub fn set_slab(&mut self, units: i32) {
        self.slab = units.max(1);
    }

    /// Makes a site a sink: it swallows the sand that falls on it and the sand that lies there.
    pub fn make_sink(&mut self, site: usize) {
        let lying = self.depth(site);
        self.add(site, -lying);
        self.swallowed += i64::from(lying);
        self.sites[site] |= word::SINK | word::KEEPS;
    }

    /// Puts sand without letting it slip: for beginnings; call [`Sand::settle`] after.
    pub fn lay(&mut self, site: usize, units: i32) {
        if self.is_sink(site) {
            self.swallowed += i64::from(units);
        } else {
            self.add(site, units);
        }
    }

    /// Puts sand, and lets it slip.
    #[inline]
    pub fn put(&mut self, site: usize, units: i32) {
        if self.is_sink(site) {
            self.swallowed += i64::from(units);
            return;
        }
        self.add(site, units);
        self.slip_from(site);
    }

    /// Takes up to `units` of sand, and lets sand slip into the gap. Returns the units taken.
    #[inline]
    pub fn take(&mut self, site: usize, units: i32) -> i32 {
        let taken = units.min(self.depth(site));
        if taken > 0 {
            self.add(site, -taken);
            self.slip_into(site);
        }
        taken
    }

    /// Lets all sand slip that is too steep.
    pub fn settle(&mut self) {
        for site in 0..self.shape.len() {
            if self.depth(site) > 0 {
                self.slip_from(site);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::slip::AROUND;
    use super::*;
    use crate::random::Seed;

    fn worst(sand: &Sand) -> i32 {
        let mut worst = i32::MIN;
        for site in 0..sand.shape.len() {
            if sand.depth(site) > 0 {
                for by in AROUND {
                    if let Some(n) = sand.beside(site, by) {
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
