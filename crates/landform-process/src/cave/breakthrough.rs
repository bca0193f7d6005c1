//! When an open passage first leads from an inlet to an outlet, and whose passage it joins.

use landform_core::algo::DisjointSets;
use landform_core::algo::lattice::Lattice;

use super::Ends;

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
    ends: &'a Ends,
    hanging: DisjointSets,
    is_open: Vec<bool>,
    /// The inlet, from 1, on whose way to the outlet a voxel lies.
    way: Vec<u8>,
    pub(super) found: Vec<Option<Breakthrough>>,
}

impl<'a> Watch<'a> {
    pub(super) fn new(lattice: &'a Lattice, ends: &'a Ends) -> Self {
        let n = lattice.stored();
        let (is_open, way, found) = (vec![false; n], vec![0; n], vec![None; ends.inlets.len()]);
        Self { lattice, ends, hanging: DisjointSets::new(n), is_open, way, found }
    }

    /// Opens voxels and looks for breakthroughs.
    pub(super) fn open(&mut self, iteration: u32, opened: &[usize], pressure: &[u32]) {
        for &i in opened {
            self.is_open[i] = true;
            for beside in self.lattice.neighbours(i).filter(|&beside| self.is_open[beside]) {
                self.hanging.join(i as u32, beside as u32);
            }
        }
        if opened.is_empty() {
            return;
        }
        for inlet in 0..self.found.len() {
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
        let ends = self.ends;
        for &from in ends.inlets[inlet].0.iter().filter(|&&i| self.is_open[i]) {
            let root = self.hanging.root(from as u32);
            let mut leads_to = |to: &usize| self.is_open[*to] && self.hanging.root(*to as u32) == root;
            if let Some(outlet) = ends.outlets.iter().position(|voxels| voxels.iter().any(&mut leads_to)) {
                return Some((from, outlet));
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
