//! Poisson-disk sampling of a rectangle, with evenly spaced nodes along its border.
//!
//! # Method
//! Bridson's dart throwing from an active list, k = 30 candidates uniform in the area of the
//! annulus [r, 2r], on a background grid of r/√2. The border is laid first, at spacings of at least
//! r and, for sides longer than a few r, below √2·r: then no inner node lies in a border edge's
//! diametral circle, so that every Voronoi cell ends at the rectangle and the hull *is* the
//! rectangle.
//!
//! # Sources
//! Bridson (2007). Bell's thesis (chapter 3) looks one cell away for conflicts; with cells of r/√2
//! it has to be two, or a quarter of the points come too close (validation notes 2.10).

use crate::random::{Draws, Seed};
use crate::{Error, Result};

const CANDIDATES: usize = 30;
const YOUNGEST: usize = 64;
/// Points per r² of area that Bridson's algorithm leaves with k = 30, measured here on 10⁶ points.
const DENSITY: f64 = 0.615;
const MOST_POINTS: f64 = 2e7;
const FREE: [f64; 2] = [f64::INFINITY; 2];

/// The least distance at which a rectangle of `size` gets about `count` nodes (to about 1 % from
/// 1,000 nodes up).
pub fn spacing_for_count(size: [f64; 2], count: usize) -> f64 {
    let (area, half_border) = (size[0] * size[1], size[0] + size[1]);
    // Border nodes stand at 1/r a metre and keep inner ones away: the count is DENSITY a/r² + c
    // b/r.
    const BORDER: f64 = 1.16;
    let b = BORDER * half_border;
    (b + (b * b + 4.0 * count as f64 * DENSITY * area).sqrt()) / (2.0 * count as f64)
}

/// Points at least `spacing` apart in [0, size.x] × [0, size.y], border nodes first, none left out
/// where one fits (all but a few per cent of the plane is within `spacing` of a point).
///
/// **Cost** O(n), about 0.2 s for 10⁵.
///
/// # Errors
/// [`Error::Parameter`] for sizes that are not positive, a spacing above half of a side, or more
/// than 2·10⁷ points.
pub fn poisson_disk(size: [f64; 2], spacing: f64, seed: Seed) -> Result<Vec<[f64; 2]>> {
    check(size, spacing)?;
    let mut sampler = Sampler::new(size, spacing);
    for p in border(size, spacing) {
        sampler.add(p);
    }
    sampler.grow(&mut seed.draws());
    Ok(sampler.points)
}

/// As [`poisson_disk`], without nodes along the border: the algorithm as published, from one point.
///
/// ```
/// use landform_core::algo::sampling::scattered;
/// use landform_core::random::Seed;
///
/// let points = scattered([100.0, 60.0], 10.0, Seed(1))?;
/// assert!((30..60).contains(&points.len()));
/// assert!(points.iter().all(|[x, y]| (0.0..100.0).contains(x) && (0.0..60.0).contains(y)));
/// # Ok::<(), landform_core::Error>(())
/// ```
///
/// # Errors
/// Where [`poisson_disk`] fails.
pub fn scattered(size: [f64; 2], spacing: f64, seed: Seed) -> Result<Vec<[f64; 2]>> {
    check(size, spacing)?;
    let mut sampler = Sampler::new(size, spacing);
    let mut draws = seed.draws();
    let first = size.map(|side| side * draws.uniform());
    sampler.add(first);
    sampler.grow(&mut draws);
    Ok(sampler.points)
}

fn check(size: [f64; 2], spacing: f64) -> Result<()> {
    if size.iter().any(|s| !(s.is_finite() && *s > 0.0)) {
        return Err(Error::parameter("size", format!("{} x {} m", size[0], size[1]), "> 0 m"));
    }
    if !(spacing > 0.0 && spacing <= 0.5 * size[0].min(size[1])) {
        return Err(Error::parameter("spacing", format!("{spacing} m"), "> 0 m and at most half of the shorter side"));
    }
    if size[0] * size[1] / (spacing * spacing) > MOST_POINTS / DENSITY {
        return Err(Error::parameter("spacing", format!("{spacing} m"), "at most 20 million nodes"));
    }
    Ok(())
}

fn border([w, h]: [f64; 2], spacing: f64) -> Vec<[f64; 2]> {
    let count = |side: f64| (side / spacing).floor().max(1.0) as usize;
    let (nx, ny) = (count(w), count(h));
    let mut points = Vec::with_capacity(2 * (nx + ny));
    for i in 0..nx {
        let x = w * i as f64 / nx as f64;
        points.push([x, 0.0]);
        points.push([w - x, h]);
    }
    for i in 0..ny {
        let y = h * i as f64 / ny as f64;
        points.push([w, y]);
        points.push([0.0, h - y]);
    }
    points
}

struct Sampler {
    size: [f64; 2],
    spacing: f64,
    cell: f64,
    cols: usize,
    rows: usize,
    /// The point in each cell; two cells of free border on all sides.
    grid: Vec<[f64; 2]>,
    points: Vec<[f64; 2]>,
}

impl Sampler {
    fn new(size: [f64; 2], spacing: f64) -> Self {
        let cell = spacing / std::f64::consts::SQRT_2;
        let (cols, rows) = ((size[0] / cell) as usize + 5, (size[1] / cell) as usize + 5);
        Self { size, spacing, cell, cols, rows, grid: vec![FREE; cols * rows], points: Vec::new() }
    }

    fn cell_of(&self, p: [f64; 2]) -> usize {
        let (row, col) = ((p[1] / self.cell) as usize, (p[0] / self.cell) as usize);
        (row.min(self.rows - 5) + 2) * self.cols + col.min(self.cols - 5) + 2
    }

    fn add(&mut self, p: [f64; 2]) {
        let cell = self.cell_of(p);
        self.grid[cell] = p;
        self.points.push(p);
    }

    /// No cell farther away holds a point within the spacing; the four corners of the block do not
    /// either.
    fn is_free(&self, p: [f64; 2]) -> bool {
        let centre = self.cell_of(p);
        let r2 = self.spacing * self.spacing;
        let far = |q: &[f64; 2]| (p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) >= r2;
        // The nearest rows first: they are the likeliest to refuse.
        [(0, 2), (1, 2), (-1, 2), (2, 1), (-2, 1)].into_iter().all(|(row, reach): (isize, usize)| {
            let middle = centre.wrapping_add_signed(row * self.cols as isize);
            self.grid[middle - reach..=middle + reach].iter().all(far)
        })
    }

    fn grow(&mut self, draws: &mut Draws) {
        let mut active: Vec<u32> = (0..self.points.len() as u32).collect();
        while !active.is_empty() {
            // Among the youngest: what is near in space is then near in memory.
            let k = active.len() - 1 - draws.below(active.len().min(YOUNGEST));
            let centre = self.points[active[k] as usize];
            match (0..CANDIDATES).find_map(|_| self.candidate(centre, draws)) {
                Some(p) => {
                    active.push(self.points.len() as u32);
                    self.add(p);
                }
                None => {
                    active.swap_remove(k);
                }
            }
        }
    }

    fn candidate(&self, centre: [f64; 2], draws: &mut Draws) -> Option<[f64; 2]> {
        // From a square until it hits the annulus: uniform in area, without sine and cosine.
        let offset = loop {
            let [x, y] = [4.0 * draws.uniform() - 2.0, 4.0 * draws.uniform() - 2.0];
            if (1.0..=4.0).contains(&(x * x + y * y)) {
                break [x * self.spacing, y * self.spacing];
            }
        };
        let p = [centre[0] + offset[0], centre[1] + offset[1]];
        let inside = p[0] > 0.0 && p[1] > 0.0 && p[0] < self.size[0] && p[1] < self.size[1];
        (inside && self.is_free(p)).then_some(p)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math;

    #[test]
    fn no_two_points_are_closer_than_the_spacing_and_no_hole_is_left() {
        let points = poisson_disk([100.0, 70.0], 2.0, Seed(1)).unwrap();
        let mut nearest = f64::INFINITY;
        for (i, p) in points.iter().enumerate() {
            for q in &points[..i] {
                nearest = nearest.min(math::hypot(p[0] - q[0], p[1] - q[1]));
            }
        }
        assert!(nearest >= 2.0, "{nearest}");
        let (mut far, mut probes) = (0, 0);
        for i in 0..200 {
            for j in 0..140 {
                let q = [i as f64 * 0.5, j as f64 * 0.5];
                let d = points.iter().map(|p| math::hypot(p[0] - q[0], p[1] - q[1])).fold(f64::INFINITY, f64::min);
                assert!(d < 4.0);
                probes += 1;
                far += usize::from(d > 2.0);
            }
        }
        assert!((far as f64) < 0.02 * probes as f64, "{far} of {probes}");
    }

    #[test]
    fn the_count_asked_for_is_nearly_the_count_given() {
        for count in [1_000, 5_000, 20_000] {
            let size = [32_768.0, 20_000.0];
            let got = poisson_disk(size, spacing_for_count(size, count), Seed(4)).unwrap().len();
            assert!((got as f64 / count as f64 - 1.0).abs() < 0.02, "{count} asked, {got} given");
        }
    }

    #[test]
    fn bad_sizes_are_refused() {
        assert!(poisson_disk([0.0, 1.0], 0.1, Seed(0)).is_err());
        assert!(poisson_disk([1.0, 1.0], 0.9, Seed(0)).is_err());
        assert!(poisson_disk([1e9, 1e9], 1.0, Seed(0)).is_err());
        assert!(poisson_disk([1.0, f64::NAN], 0.1, Seed(0)).is_err());
    }
}
