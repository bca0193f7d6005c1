//! Which places lie on a feature, or near one.

use super::{Feature, Geometry, Polygon};

/// Marks the places that lie on one of the features (inside, for areas) or within `buffer` metres
/// of it. **Cost** for every stretch of a line the places in the cells that it passes; for every
/// area its edges times the places in its rectangle.
pub fn near<'a>(features: impl Iterator<Item = &'a Feature>, buffer: f64, places: &[[f64; 2]]) -> Vec<bool> {
    let mut marked = vec![false; places.len()];
    let buckets = Buckets::new(places, buffer);
    for feature in features {
        match &feature.geometry {
            Geometry::Area(parts) => {
                for part in parts {
                    buckets.mark_inside(part, places, &mut marked);
                    part.iter().for_each(|ring| buckets.mark_line(ring, buffer, places, &mut marked));
                }
            }
            Geometry::Network { nodes, edges } => {
                let flat = |i: u32| [nodes[i as usize][0], nodes[i as usize][1]];
                for [a, b] in edges {
                    buckets.mark_line(&[flat(*a), flat(*b)], buffer, places, &mut marked);
                }
            }
            Geometry::Points(points) => {
                points.iter().for_each(|p| buckets.mark_line(&[[p[0], p[1]]], buffer, places, &mut marked));
            }
            _ => buckets.mark_line(&feature.places(), buffer, places, &mut marked),
        }
    }
    marked
}

/// Places by square cells.
struct Buckets {
    low: [f64; 2],
    cell: f64,
    cols: usize,
    rows: usize,
    start: Vec<u32>,
    places: Vec<u32>,
}

impl Buckets {
    fn new(places: &[[f64; 2]], buffer: f64) -> Self {
        let wide = |(lo, hi): ([f64; 2], [f64; 2]), p: &[f64; 2]| {
            ([lo[0].min(p[0]), lo[1].min(p[1])], [hi[0].max(p[0]), hi[1].max(p[1])])
        };
        let (low, high) = places.iter().fold(([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]), wide);
        let [w, h] = [0, 1].map(|k| (high[k] - low[k]).max(0.0));
        // A few places a cell, and no cell much smaller than the buffer.
        let cell = (w * h / places.len().max(1) as f64 * 4.0).sqrt().max(0.5 * buffer).max(w.max(h) / 4096.0);
        let cell = if cell > 0.0 { cell } else { 1.0 };
        let (cols, rows) = ((w / cell) as usize + 1, (h / cell) as usize + 1);
        let mut buckets =
            Self { low, cell, cols, rows, start: vec![0; cols * rows + 1], places: vec![0; places.len()] };
        let of: Vec<usize> = places.iter().map(|p| buckets.cell_of(*p)).collect();
        of.iter().for_each(|&c| buckets.start[c + 1] += 1);
        (0..cols * rows).for_each(|c| buckets.start[c + 1] += buckets.start[c]);
        let mut at = buckets.start.clone();
        for (i, &c) in of.iter().enumerate() {
            buckets.places[at[c] as usize] = i as u32;
            at[c] += 1;
        }
        buckets
    }

    fn axis(&self, v: f64, k: usize) -> usize {
        let count = if k == 0 { self.cols } else { self.rows };
        (((v - self.low[k]) / self.cell).max(0.0) as usize).min(count - 1)
    }

    fn cell_of(&self, p: [f64; 2]) -> usize {
        self.axis(p[1], 1) * self.cols + self.axis(p[0], 0)
    }

    /// Calls `visit` for every place in the cells of a rectangle.
    fn within(&self, low: [f64; 2], high: [f64; 2], mut visit: impl FnMut(usize)) {
        for row in self.axis(low[1], 1)..=self.axis(high[1], 1) {
            let (first, last) = (row * self.cols + self.axis(low[0], 0), row * self.cols + self.axis(high[0], 0));
            let (a, b) = (self.start[first] as usize, self.start[last + 1] as usize);
            self.places[a..b].iter().for_each(|&i| visit(i as usize));
        }
    }

    fn mark_line(&self, line: &[[f64; 2]], buffer: f64, places: &[[f64; 2]], marked: &mut [bool]) {
        let single = [line.first().copied().unwrap_or_default(); 2];
        let stretches = line.windows(2).map(|w| [w[0], w[1]]).chain((line.len() == 1).then_some(single));
        for [a, b] in stretches {
            let low = [0, 1].map(|k| a[k].min(b[k]) - buffer);
            let high = [0, 1].map(|k| a[k].max(b[k]) + buffer);
            self.within(low, high, |i| marked[i] |= square_distance(places[i], a, b) <= buffer * buffer);
        }
    }

    fn mark_inside(&self, part: &Polygon, places: &[[f64; 2]], marked: &mut [bool]) {
        let Some(outer) = part.first() else { return };
        let wide = |(lo, hi): ([f64; 2], [f64; 2]), p: &[f64; 2]| {
            ([lo[0].min(p[0]), lo[1].min(p[1])], [hi[0].max(p[0]), hi[1].max(p[1])])
        };
        let (low, high) = outer.iter().fold(([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]), wide);
        if low[0] <= high[0] {
            self.within(low, high, |i| marked[i] |= is_inside(places[i], part));
        }
    }
}

fn square_distance(p: [f64; 2], a: [f64; 2], b: [f64; 2]) -> f64 {
    let (along, to) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
    let length = along[0] * along[0] + along[1] * along[1];
    let t = if length > 0.0 { ((to[0] * along[0] + to[1] * along[1]) / length).clamp(0.0, 1.0) } else { 0.0 };
    let d = [to[0] - t * along[0], to[1] - t * along[1]];
    d[0] * d[0] + d[1] * d[1]
}

/// Whether a place lies inside a polygon: an odd number of edges of its rings lies to the east.
fn is_inside([x, y]: [f64; 2], rings: &Polygon) -> bool {
    let mut inside = false;
    for ring in rings {
        for (k, a) in ring.iter().enumerate() {
            let b = ring[(k + 1) % ring.len()];
            if (a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]) {
                inside = !inside;
            }
        }
    }
    inside
}

#[cfg(test)]
mod tests {
    use super::super::FeatureKind;
    use super::*;

    fn feature(geometry: Geometry) -> Feature {
        Feature { id: "1".into(), kind: FeatureKind::River, geometry, properties: Vec::new() }
    }

    #[test]
    fn buffers_of_lines_and_areas_with_holes() {
        let places: Vec<[f64; 2]> = (0..10_000).map(|i| [f64::from(i % 100), f64::from(i / 100)]).collect();
        let count = |geometry: Geometry, buffer: f64| {
            let feature = feature(geometry);
            near(std::iter::once(&feature), buffer, &places).iter().filter(|m| **m).count()
        };
        let line = || Geometry::Line(vec![[10.0, 50.0, 0.0], [40.0, 50.0, 0.0], [40.0, 80.0, 0.0]]);
        assert_eq!(count(line(), 0.0), 61);
        // Two stretches of 30 m with 3 m to either side, less their overlap, with half discs at the
        // ends.
        let found = count(line(), 3.0) as f64;
        let expected = 2.0 * 30.0 * 6.0 + std::f64::consts::PI * 9.0;
        assert!((found / expected - 1.0).abs() < 0.2, "{found} {expected}");
        let ring = |lo: f64, hi: f64| vec![[lo, lo], [hi, lo], [hi, hi], [lo, hi], [lo, lo]];
        assert_eq!(count(Geometry::Area(vec![vec![ring(9.5, 29.5), ring(14.5, 19.5)]]), 0.0), 20 * 20 - 5 * 5);
        assert_eq!(count(Geometry::Point([50.0, 50.0, 0.0]), 1.0), 5);
        assert_eq!(near(std::iter::empty(), 5.0, &places).iter().filter(|m| **m).count(), 0);
    }
}
