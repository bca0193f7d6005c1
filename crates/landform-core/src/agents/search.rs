//! Searches in the graph around a site.

use super::Sites;
use crate::grid::Link;

/// Searches that share scratch memory: after the first, none allocates. **Memory** 4 bytes a site.
#[derive(Clone, Debug, Default)]
pub struct Search {
    /// The call in which a site was last seen.
    seen: Vec<u32>,
    call: u32,
    queue: Vec<u32>,
}

impl Search {
    /// For graphs of this many sites.
    pub fn new(sites: usize) -> Self {
        Self { seen: vec![0; sites], call: 0, queue: Vec::new() }
    }

    fn begin(&mut self, sites: usize) {
        self.call = self.call.wrapping_add(1);
        if self.call == 0 || self.seen.len() < sites {
            self.seen.clear();
            self.seen.resize(sites, 0);
            self.call = 1;
        }
        self.queue.clear();
    }

    /// Breadth-first from `origin` to sites at most `radius` (m) away in a straight line, along
    /// links that `through` (from, to) lets pass: uphill only, along a coast only, inside a cone.
    /// `visit` sees each site once with its distance, the origin first; false ends it.
    pub fn within<D: Sites>(
        &mut self,
        sites: &D,
        origin: usize,
        radius: f64,
        mut through: impl FnMut(usize, Link) -> bool,
        mut visit: impl FnMut(usize, f64) -> bool,
    ) {
        self.begin(sites.len());
        self.seen[origin] = self.call;
        self.queue.push(origin as u32);
        if !visit(origin, 0.0) {
            return;
        }
        let mut next = 0;
        while let Some(&site) = self.queue.get(next) {
            next += 1;
            for near in sites.neighbours(site as usize) {
                if self.seen[near.to] == self.call || !through(site as usize, near) {
                    continue;
                }
                let distance = sites.distance(origin, near.to);
                if distance > radius {
                    continue;
                }
                self.seen[near.to] = self.call;
                self.queue.push(near.to as u32);
                if !visit(near.to, distance) {
                    return;
                }
            }
        }
    }

    /// Walks from `origin` along a direction (any length) until `reach` m, an open side, or `visit`
    /// says false. Sites come in order, each once in a row, without the origin, with their distance
    /// along the ray.
    pub fn ray<D: Sites>(
        sites: &D,
        origin: usize,
        direction: [f64; 3],
        reach: f64,
        mut visit: impl FnMut(usize, f64) -> bool,
    ) {
        let length = direction.iter().map(|d| d * d).sum::<f64>().sqrt();
        if !(length > 0.0) {
            return;
        }
        let (pace, mut last) = (sites.pace(), origin);
        for k in 1.. {
            let along = f64::from(k) * pace;
            if along > reach * (1.0 + 1e-12) {
                return;
            }
            let Some(site) = sites.step(origin, direction.map(|d| d / length * along)) else { return };
            if site != last && !visit(site, along) {
                return;
            }
            last = site;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Connectivity, RasterSites};
    use super::*;
    use crate::grid::{Edge, Edges, Grid, Neighbours, Shape};

    fn raster(edge: Edge) -> RasterSites {
        let mut grid = Grid::new(Shape::new(21, 20), [1.0, 1.0]).unwrap();
        grid.edges = Edges::all(edge);
        RasterSites::new(&grid, Connectivity::Eight).unwrap()
    }

    #[test]
    fn a_radius_finds_the_disc_and_a_filter_bends_it() {
        let sites = raster(Edge::Periodic);
        let mut search = Search::new(sites.len());
        let mut found = 0;
        search.within(
            &sites,
            0,
            5.0,
            |_, _| true,
            |_, d| {
                assert!(d <= 5.0);
                found += 1;
                true
            },
        );
        // Lattice points in a disc of radius 5 (Gauss's circle).
        assert_eq!(found, 81);
        // Uphill only, on ground that rises east: never west of the origin.
        let height = |i: usize| i % 20;
        let mut sum = 0;
        search.within(
            &sites,
            10 * 20 + 10,
            4.0,
            |from, to| height(to.to) > height(from),
            |i, _| {
                assert!(height(i) >= 10);
                sum += 1;
                true
            },
        );
        assert!(sum > 8);
        let mut first = Vec::new();
        search.within(
            &sites,
            7,
            9.0,
            |_, _| true,
            |i, _| {
                first.push(i);
                first.len() < 3
            },
        );
        assert_eq!(first.len(), 3);
    }

    #[test]
    fn a_ray_walks_straight_and_ends_at_an_open_side() {
        let walk = |edge: Edge, direction| {
            let mut seen = Vec::new();
            Search::ray(&raster(edge), 10 * 20 + 15, direction, 8.0, |i, _| {
                seen.push(i);
                true
            });
            seen
        };
        assert_eq!(walk(Edge::Open, [1.0, 0.0, 0.0]), [216, 217, 218, 219]);
        assert_eq!(walk(Edge::Periodic, [2.0, 0.0, 0.0])[4..], [200, 201, 202, 203]);
        assert_eq!(walk(Edge::Open, [0.0, 1.0, 0.0]).last(), Some(&(2 * 20 + 15)));
        assert_eq!(walk(Edge::Open, [0.0; 3]), [0usize; 0]);
    }
}
