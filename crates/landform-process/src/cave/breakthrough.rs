//! When an open passage first leads from an inlet to an outlet, and whose passage it joins.

use landform_core::algo::lattice::Lattice;

/// A breakthrough.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Breakthrough {
    /// Iteration, from 1.
    pub(super) iteration: u32,
    /// Number of the outlet, from 0.
    pub(super) outlet: usize,
    /// The inlet whose passage is joined on the way, from 0; none if it leads to the outlet itself.
    pub(super) joins: Option<usize>,
}

/// Open voxels that hang together, and the ends that they touch.
pub(super) struct Watch<'a> {
    lattice: &'a Lattice,
    parent: Vec<u32>,
    is_open: Vec<bool>,
    inlets: Vec<Vec<usize>>,
    outlets: Vec<Vec<usize>>,
    /// The inlet, from 1, on whose way to the outlet a voxel lies.
    way: Vec<u8>,
    pub(super) found: Vec<Option<Breakthrough>>,
}

impl<'a> Watch<'a> {
    pub(super) fn new(lattice: &'a Lattice, inlets: Vec<Vec<usize>>, outlets: Vec<Vec<usize>>) -> Self {
        let n = lattice.stored();
        let found = vec![None; inlets.len()];
        let (parent, is_open, way) = ((0..n as u32).collect(), vec![false; n], vec![0; n]);
        Self { lattice, parent, is_open, inlets, outlets, way, found }
    }

    fn root(&mut self, i: usize) -> usize {
        let mut i = i as u32;
        while self.parent[i as usize] != i {
            self.parent[i as usize] = self.parent[self.parent[i as usize] as usize];
            i = self.parent[i as usize];
        }
        i as usize
    }

    /// Opens voxels and looks for breakthroughs.
    pub(super) fn open(&mut self, iteration: u32, opened: &[usize], pressure: &[u32]) {
        for &i in opened {
            self.is_open[i] = true;
            for k in 0..landform_core::algo::lattice::NEIGHBOURS {
                let beside = self.lattice.neighbour(i, k);
                if self.is_open[beside] {
                    let (a, b) = (self.root(i), self.root(beside));
                    self.parent[a.max(b)] = a.min(b) as u32;
                }
            }
        }
        if opened.is_empty() {
            return;
        }
        for inlet in 0..self.inlets.len() {
            if self.found[inlet].is_none()
                && let Some((from, outlet)) = self.reached(inlet)
            {
                let joins = self.follow(from, inlet, pressure);
                self.found[inlet] = Some(Breakthrough { iteration, outlet, joins });
            }
        }
    }

    /// An open voxel of an inlet that hangs together with one of an outlet.
    fn reached(&mut self, inlet: usize) -> Option<(usize, usize)> {
        for from in self.inlets[inlet].clone().into_iter().filter(|&i| self.is_open[i]).collect::<Vec<_>>() {
            let root = self.root(from);
            for outlet in 0..self.outlets.len() {
                for k in 0..self.outlets[outlet].len() {
                    let to = self.outlets[outlet][k];
                    if self.is_open[to] && self.root(to) == root {
                        return Some((from, outlet));
                    }
                }
            }
        }
        None
    }

    /// Down the pressure from an inlet; the inlet whose way is met.
    fn follow(&mut self, from: usize, inlet: usize, pressure: &[u32]) -> Option<usize> {
        let mut at = from;
        loop {
            if self.way[at] != 0 {
                return Some(usize::from(self.way[at]) - 1);
            }
            self.way[at] = inlet as u8 + 1;
            // The border holds pressure 0 too, and is never open.
            let open = self.lattice.neighbours(at).filter(|&i| self.is_open[i]);
            let next = open.min_by_key(|&i| (pressure[i], i)).filter(|&i| pressure[i] < pressure[at])?;
            at = next;
        }
    }
}
