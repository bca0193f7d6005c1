//! Growth and linkage of channels: pressure, water, dissolution.
//!
//! # Method
//! Pytel, section 5.2.2, with its errata. All is counted in whole numbers: porosity and water in
//! 2⁻²⁴ of a voxel, pressure in 2⁻²⁴ of the highest. Sums have no order and no rounding: water is
//! conserved to the unit, and a mirror image of the rock has the mirror image of the cave.
//!
//! - Pressure: `P(N) ≤ P(S) + k(S)·d(S, N)` from the outlets, by Dijkstra; `k` is the rate of
//!   channels where S is one, else that of rock over its permeability. A voxel that becomes a
//!   channel lowers its surroundings: only they are marched again.
//! - Water: a voxel gives to neighbours of lower pressure in proportion to the difference and to
//!   their permeability, at most what they have room for. All read what was there before anyone
//!   gave; where more comes than there is room, each giver gives its share (the thesis updates in
//!   place, in the order of visits).
//! - Dissolution: `f = (w_a f_a + f_c)^m`, with `f_c` the water that came and `f_a` the mean over
//!   the 26 neighbours of what came to those of lower pressure, times the permeability up to 4;
//!   porosity grows by `min(w_0 f s, 1 − P)`, s the solubility.
//! - A voxel opens only beside one that open voxels join to an inlet. Water that has seeped through
//!   the pores of rock is saturated and widens them up to that bound, no further (the thesis opens
//!   voids that no passage leads to).

use landform_core::algo::lattice::{Lattice, NEIGHBOURS, lower};
use landform_core::math;

/// A whole, in units.
pub(super) const ONE: u32 = 1 << 24;
/// Permeability above which walls give way no faster.
const MOST_PERMEABLE: f32 = 4.0;

/// The rock, stored as the lattice says; zeros in the border.
#[derive(Clone)]
pub(super) struct Rock {
    /// Units.
    pub(super) porosity: Vec<u32>,
    /// Over that of plain rock.
    pub(super) permeability: Vec<f32>,
    /// 0 to 1.
    pub(super) solubility: Vec<f32>,
}

/// How channels grow.
#[derive(Clone, Copy, Debug)]
pub(super) struct Law {
    /// Units of pressure a metre in rock and in channels.
    pub(super) rates: [f32; 2],
    /// Porosity above which a voxel is open, units.
    pub(super) open: u32,
    /// w_0, w_a, m.
    pub(super) dissolution: f64,
    pub(super) aside: f64,
    pub(super) exponent: f64,
}

/// Water that entered, left and is in the rock, units.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Budget {
    pub(super) supplied: u64,
    pub(super) drained: u64,
}

/// Channels on the way.
pub(super) struct Growth<'a> {
    pub(super) lattice: &'a Lattice,
    pub(super) rock: Rock,
    law: Law,
    pub(super) pressure: Vec<u32>,
    pub(super) water: Vec<u32>,
    pub(super) budget: Budget,
    inlets: Vec<usize>,
    outlets: Vec<usize>,
    slopes: Vec<f32>,
    /// Permeability in 1/64.
    weights: Vec<u16>,
    /// Voxels with water, each once.
    wet: Vec<u32>,
    is_wet: Vec<bool>,
    /// Water that is to come, and room for it, of the voxels that are `met`.
    coming: Vec<u32>,
    room: Vec<u32>,
    came: Vec<u32>,
    met: Vec<u32>,
    gifts: Vec<(u32, u32, u32)>,
    aside: Vec<u32>,
    beside: Vec<u32>,
    /// Open voxels that hang together with an inlet, and all that may open: those beside them.
    joined: Vec<bool>,
    may_open: Vec<bool>,
}

impl<'a> Growth<'a> {
    /// At its start: `pressure` is that of the zones (units), lowered here from the outlets.
    /// Channels are the voxels of `channel` and those that are open.
    pub(super) fn new(
        lattice: &'a Lattice,
        rock: Rock,
        law: Law,
        pressure: Vec<u32>,
        channel: &[bool],
        [inlets, outlets]: [Vec<usize>; 2],
    ) -> Self {
        let n = lattice.stored();
        let [in_rock, in_channel] = law.rates;
        let mut slopes = vec![0.0; n];
        let mut weights = vec![0; n];
        let mut is_outlet = vec![false; n];
        outlets.iter().for_each(|&i| is_outlet[i] = true);
        let mut channels = Vec::new();
        for i in lattice.voxels() {
            let is_channel = channel[i] || rock.porosity[i] > law.open || is_outlet[i];
            channels.extend(is_channel.then_some(i));
            slopes[i] = if is_channel { in_channel } else { (in_rock / rock.permeability[i]).max(in_channel) };
            weights[i] = (64.0 * rock.permeability[i]).clamp(1.0, 65_535.0) as u16;
        }
        let mut growth = Self {
            lattice,
            rock,
            law,
            pressure,
            water: vec![0; n],
            budget: Budget::default(),
            inlets,
            outlets,
            slopes,
            weights,
            wet: Vec::new(),
            is_wet: vec![false; n],
            coming: vec![0; n],
            room: vec![0; n],
            came: vec![0; n],
            met: Vec::new(),
            gifts: Vec::new(),
            aside: vec![0; n],
            beside: Vec::new(),
            joined: vec![false; n],
            may_open: vec![false; n],
        };
        for k in 0..growth.inlets.len() {
            let inlet = growth.inlets[k];
            growth.may_open[inlet] = true;
            if growth.rock.porosity[inlet] > growth.law.open {
                growth.join(inlet);
            }
        }
        growth.outlets.iter().for_each(|&i| growth.pressure[i] = 0);
        lower(lattice, &mut growth.pressure, &growth.slopes, &channels);
        growth
    }

    /// One iteration. Returns the voxels that opened.
    pub(super) fn step(&mut self) -> Vec<usize> {
        self.supply();
        self.offer();
        self.give();
        self.drain();
        let opened = self.dissolve();
        opened.iter().for_each(|&i| self.slopes[i] = self.law.rates[1]);
        // After all of them: what opened in this iteration leads on in the next.
        opened.iter().for_each(|&i| self.join(i));
        if !opened.is_empty() {
            lower(self.lattice, &mut self.pressure, &self.slopes, &opened);
        }
        opened
    }

    /// Joins an open voxel, and all open ones behind it, to an inlet.
    fn join(&mut self, first: usize) {
        let mut queue = vec![first];
        while let Some(i) = queue.pop() {
            if std::mem::replace(&mut self.joined[i], true) {
                continue;
            }
            for to in self.lattice.neighbours(i) {
                self.may_open[to] = true;
                if self.rock.porosity[to] > self.law.open {
                    queue.push(to);
                }
            }
        }
    }

    /// Inlets are filled.
    fn supply(&mut self) {
        for k in 0..self.inlets.len() {
            let i = self.inlets[k];
            let more = self.rock.porosity[i] - self.water[i];
            self.water[i] += more;
            self.budget.supplied += u64::from(more);
            self.came[i] = more;
            self.met.push(i as u32);
            if !std::mem::replace(&mut self.is_wet[i], true) {
                self.wet.push(i as u32);
            }
        }
    }

    /// What each wet voxel would give to each neighbour.
    fn offer(&mut self) {
        self.gifts.clear();
        for &from in &self.wet {
            let (i, here) = (from as usize, self.pressure[from as usize]);
            let (mut weights, mut rooms, mut sum) = ([0_u64; NEIGHBOURS], [0_u32; NEIGHBOURS], 0);
            for k in 0..NEIGHBOURS {
                let to = self.lattice.neighbour(i, k);
                rooms[k] = self.rock.porosity[to] - self.water[to];
                if rooms[k] > 0 && self.pressure[to] < here {
                    // Below 2^34: times the room it fits.
                    weights[k] = u64::from((here - self.pressure[to]).div_ceil(64)) * u64::from(self.weights[to]);
                    sum += weights[k];
                }
            }
            if sum == 0 {
                continue;
            }
            let want = |k: usize| weights[k] * u64::from(rooms[k]) / sum;
            let (all, water) = ((0..NEIGHBOURS).map(want).sum::<u64>(), u64::from(self.water[i]));
            for k in (0..NEIGHBOURS).filter(|&k| weights[k] > 0) {
                let amount = if all > water { want(k) * water / all } else { want(k) } as u32;
                if amount > 0 {
                    let to = self.lattice.neighbour(i, k);
                    if self.coming[to] == 0 {
                        self.room[to] = rooms[k];
                        self.met.push(to as u32);
                    }
                    self.coming[to] += amount;
                    self.gifts.push((from, to as u32, amount));
                }
            }
        }
    }

    fn give(&mut self) {
        for &(from, to, amount) in &self.gifts {
            let (from, to) = (from as usize, to as usize);
            let (coming, room) = (self.coming[to], self.room[to]);
            let gift =
                if coming > room { (u64::from(amount) * u64::from(room) / u64::from(coming)) as u32 } else { amount };
            self.water[from] -= gift;
            self.water[to] += gift;
            self.came[to] += gift;
        }
        for &i in &self.met {
            self.coming[i as usize] = 0;
            if self.water[i as usize] > 0 && !std::mem::replace(&mut self.is_wet[i as usize], true) {
                self.wet.push(i);
            }
        }
    }

    /// Outlets are emptied.
    fn drain(&mut self) {
        for &i in &self.outlets {
            self.budget.drained += u64::from(std::mem::take(&mut self.water[i]));
        }
        let (water, is_wet) = (&self.water, &mut self.is_wet);
        self.wet.retain(|&i| {
            is_wet[i as usize] = water[i as usize] > 0;
            is_wet[i as usize]
        });
    }

    /// Porosity grows where water came, and beside it. Returns the voxels that opened.
    fn dissolve(&mut self) -> Vec<usize> {
        self.met.sort_unstable();
        self.met.dedup();
        for &m in &self.met {
            let i = m as usize;
            let (came, here) = (self.came[i], self.pressure[i]);
            if came == 0 || self.law.aside == 0.0 {
                continue;
            }
            for to in self.lattice.neighbours(i) {
                if self.rock.porosity[to] > 0 && self.pressure[to] >= here {
                    if self.aside[to] == 0 {
                        self.beside.push(to as u32);
                    }
                    self.aside[to] += came;
                }
            }
        }
        let mut opened = Vec::new();
        let met = std::mem::take(&mut self.met);
        let beside = std::mem::take(&mut self.beside);
        for &i in met.iter().chain(&beside) {
            self.widen(i as usize, &mut opened);
        }
        for &i in met.iter().chain(&beside) {
            (self.came[i as usize], self.aside[i as usize]) = (0, 0);
        }
        (self.met, self.beside) = (met, beside);
        self.met.clear();
        self.beside.clear();
        opened.sort_unstable();
        opened
    }

    fn widen(&mut self, i: usize, opened: &mut Vec<usize>) {
        let [came, aside] = [self.came[i], self.aside[i]].map(|v| f64::from(v) / f64::from(ONE));
        // Once for a voxel that is both.
        (self.came[i], self.aside[i]) = (0, 0);
        // Walls give way along fractures and planes between beds first.
        let aside = aside / NEIGHBOURS as f64 * f64::from(self.rock.permeability[i].min(MOST_PERMEABLE));
        let f = math::pow(self.law.aside * aside + came, self.law.exponent);
        let more = (self.law.dissolution * f * f64::from(self.rock.solubility[i]) * f64::from(ONE)) as u32;
        let before = self.rock.porosity[i];
        let most = if before > self.law.open || self.may_open[i] { ONE } else { self.law.open };
        let after = before.saturating_add(more).min(most);
        self.rock.porosity[i] = after;
        if before <= self.law.open && after > self.law.open {
            opened.push(i);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn law(rates: [f64; 2]) -> Law {
        let rates = rates.map(|r| (r * f64::from(ONE)) as f32);
        Law { rates, open: ONE / 2, dissolution: 0.15, aside: 0.25, exponent: 1.0 }
    }

    fn rock(lattice: &Lattice, porosity: f64, permeability: impl Fn([usize; 3]) -> f32) -> Rock {
        let n = lattice.voxels().count();
        Rock {
            porosity: lattice.padded(std::iter::repeat_n((porosity * f64::from(ONE)) as u32, n), 0),
            permeability: lattice.padded(lattice.voxels().map(|i| permeability(lattice.place(i))), 0.0),
            solubility: lattice.padded(std::iter::repeat_n(1.0, n), 0.0),
        }
    }

    fn grown<'a>(
        lattice: &'a Lattice,
        rock: Rock,
        ends: [Vec<usize>; 2],
        channel: &[bool],
        steps: usize,
    ) -> Growth<'a> {
        let pressure = lattice.padded(std::iter::repeat_n(ONE, lattice.stored()), 0);
        let mut growth = Growth::new(lattice, rock, law([0.05, 0.001]), pressure, channel, ends);
        for _ in 0..steps {
            growth.step();
            let held: u64 = growth.water.iter().map(|w| u64::from(*w)).sum();
            assert_eq!(growth.budget.supplied, growth.budget.drained + held, "water is lost");
            assert!(growth.water.iter().zip(&growth.rock.porosity).all(|(w, p)| w <= p && *p <= ONE));
        }
        growth
    }

    #[test]
    fn a_mirror_image_of_the_rock_has_the_mirror_image_of_the_cave() {
        let lattice = Lattice::new([17, 13, 7], [1.0; 3]);
        let tile = |[x, y, z]: [usize; 3]| 1.0 + ((x.min(16 - x) * 7 + y * 3 + z * 5) % 11) as f32 * 0.2;
        let ends = [vec![lattice.at([4, 2, 3]), lattice.at([12, 2, 3])], vec![lattice.at([8, 12, 3])]];
        let none = vec![false; lattice.stored()];
        let growth = grown(&lattice, rock(&lattice, 0.1, tile), ends, &none, 120);
        let mirror = |i: usize| {
            let [x, y, z] = lattice.place(i);
            lattice.at([16 - x, y, z])
        };
        let same = |values: &[u32]| lattice.voxels().all(|i| values[i] == values[mirror(i)]);
        assert!(same(&growth.pressure) && same(&growth.water) && same(&growth.rock.porosity));
        assert!(growth.budget.drained > 0 && growth.rock.porosity.iter().any(|p| *p > ONE / 2));
    }

    #[test]
    fn all_that_opens_hangs_together_with_an_inlet() {
        let lattice = Lattice::new([40, 30, 10], [1.0; 3]);
        let tile = |[x, y, z]: [usize; 3]| 0.3 + ((x * 7 + y * 3 + z * 5) % 11) as f32 * 0.5;
        let ends = [vec![lattice.at([2, 8, 8]), lattice.at([3, 24, 7])], vec![lattice.at([39, 14, 1])]];
        let none = vec![false; lattice.stored()];
        let growth = grown(&lattice, rock(&lattice, 0.1, tile), ends.clone(), &none, 300);
        let open: Vec<bool> = growth.rock.porosity.iter().map(|p| *p > ONE / 2).collect();
        assert!(open.iter().filter(|o| **o).count() > 50);
        let mut reached = vec![false; open.len()];
        let mut queue = ends[0].clone();
        while let Some(i) = queue.pop() {
            reached[i] = true;
            queue.extend(lattice.neighbours(i).filter(|&to| open[to] && !reached[to]));
        }
        assert!(lattice.voxels().all(|i| reached[i] || !open[i]), "a void that water has no way to");
    }

    #[test]
    fn water_rises_in_the_far_arm_of_a_bend() {
        // A U of channels in a sheet: down on the left, along the floor, up on the right.
        let lattice = Lattice::new([12, 1, 12], [1.0; 3]);
        let is_pipe = |[x, _, z]: [usize; 3]| x == 2 || x == 9 || (z == 1 && (2..=9).contains(&x));
        let channel: Vec<bool> =
            (0..lattice.stored()).map(|i| lattice.is_inside(i) && is_pipe(lattice.place(i))).collect();
        let ends = [vec![lattice.at([2, 0, 11])], vec![lattice.at([9, 0, 11])]];
        let tight = |place: [usize; 3]| if is_pipe(place) { 1.0 } else { 0.01 };
        let growth = grown(&lattice, rock(&lattice, 0.3, tight), ends, &channel, 200);
        assert!(growth.budget.drained > 0, "nothing came out of the far arm");
    }

    #[test]
    fn pressure_after_all_marches_is_that_of_one_march_over_all() {
        let lattice = Lattice::new([20, 14, 6], [1.0; 3]);
        let ends = [vec![lattice.at([1, 6, 3])], vec![lattice.at([18, 7, 2])]];
        let none = vec![false; lattice.stored()];
        let tile = |[x, y, z]: [usize; 3]| 1.0 + ((x * 7 + y * 3 + z * 5) % 11) as f32 * 0.2;
        let growth = grown(&lattice, rock(&lattice, 0.2, tile), ends, &none, 150);
        let mut whole = lattice.padded(std::iter::repeat_n(ONE, lattice.stored()), 0);
        growth.outlets.iter().for_each(|&i| whole[i] = 0);
        let all: Vec<usize> = lattice.voxels().collect();
        lower(&lattice, &mut whole, &growth.slopes, &all);
        assert!(whole == growth.pressure);
    }
}
