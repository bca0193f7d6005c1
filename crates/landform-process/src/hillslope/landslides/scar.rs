//! What breaks off: the ground around a foot that stands above the rupture surface.
//!
//! The surface rises from the foot at one angle in all directions away from it, so that a scar is a
//! bowl on a slope, and on a profile the wedge between two planes.

use std::collections::VecDeque;

use landform_core::grid::{Domain, Status};

/// Ground this little above the rupture surface stays, m.
const FILM: f64 = 1e-6;

/// A rupture surface.
pub(super) struct Rupture {
    pub(super) foot: usize,
    /// Its rise over the distance from the foot.
    pub(super) slope: f64,
    /// Nothing is dug lower than this, m.
    pub(super) floor: f64,
    /// Greatest area, m².
    pub(super) greatest_area: f64,
}

/// What a slide took.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Scar {
    /// Area, m².
    pub(super) area: f64,
    /// Volume, m³.
    pub(super) volume: f64,
}

/// Where nodes are.
pub(super) struct Places<'a> {
    pub(super) position: &'a dyn Fn(usize) -> [f64; 2],
    /// Distance after which the ground repeats, east and north, m; infinite where it ends.
    pub(super) periods: [f64; 2],
}

impl Places<'_> {
    fn distance(&self, a: usize, b: usize) -> f64 {
        let (a, b) = ((self.position)(a), (self.position)(b));
        let [x, y] = [0, 1].map(|k| {
            let apart = (a[k] - b[k]).abs();
            apart.min((self.periods[k] - apart).abs())
        });
        (x * x + y * y).sqrt()
    }
}

/// Buffers of the search.
#[derive(Clone, Debug, Default)]
pub(super) struct Search {
    /// The slide that last looked at a node, from 1.
    seen: Vec<u32>,
    slide: u32,
    queue: VecDeque<u32>,
    /// Nodes of the last slide, and how far each was lowered, m.
    pub(super) dug: Vec<(u32, f64)>,
}

impl Search {
    /// Takes away the ground that stands above a rupture surface and hangs together with its foot,
    /// the nearest links first. **Cost** O(nodes taken).
    pub(super) fn dig<D: Domain>(&mut self, domain: &D, places: &Places, rupture: &Rupture, z: &mut [f64]) -> Scar {
        self.next_slide(z.len());
        let status = domain.status();
        let (base, mut scar) = (z[rupture.foot], Scar::default());
        self.seen[rupture.foot] = self.slide;
        self.queue.push_back(rupture.foot as u32);
        while let Some(at) = self.queue.pop_front() {
            for link in domain.neighbours(at as usize) {
                let to = link.to;
                if self.seen[to] == self.slide || status[to] != Status::Interior {
                    continue;
                }
                self.seen[to] = self.slide;
                let left = (base + rupture.slope * places.distance(rupture.foot, to)).max(rupture.floor);
                let area = domain.area(to);
                if !(z[to] > left + FILM) || scar.area + area > rupture.greatest_area {
                    continue;
                }
                let depth = z[to] - left;
                z[to] = left;
                scar.area += area;
                scar.volume += depth * area;
                self.dug.push((to as u32, depth));
                self.queue.push_back(to as u32);
            }
        }
        scar
    }

    fn next_slide(&mut self, nodes: usize) {
        if self.seen.len() != nodes || self.slide == u32::MAX {
            (self.seen, self.slide) = (vec![0; nodes], 0);
        }
        self.slide += 1;
        self.dug.clear();
    }
}
