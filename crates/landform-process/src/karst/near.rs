//! Places by cubic cells, to find those near a place.

use std::collections::BTreeMap;

use landform_core::terrain::Bounds;

use super::space::{Vector, distance};

pub(super) struct Near<'a> {
    places: &'a [Vector],
    low: Vector,
    cell: f64,
    count: [usize; 3],
    start: Vec<u32>,
    sorted: Vec<u32>,
}

impl<'a> Near<'a> {
    /// Cells of about `reach` m.
    pub(super) fn new(places: &'a [Vector], reach: f64) -> Self {
        let Bounds { low, high } = Bounds::around(places);
        let low = if places.is_empty() { [0.0; 3] } else { low };
        let side = |k: usize| (high[k] - low[k]).max(0.0);
        let cell = reach.max(side(0).max(side(1)).max(side(2)) / 256.0).max(1e-9);
        let count = [0, 1, 2].map(|k| (side(k) / cell) as usize + 1);
        let mut near = Self {
            places,
            low,
            cell,
            count,
            start: vec![0; count.iter().product::<usize>() + 1],
            sorted: vec![0; places.len()],
        };
        let cells: Vec<usize> = places.iter().map(|p| near.index([0, 1, 2].map(|k| near.axis(p[k], k)))).collect();
        cells.iter().for_each(|&c| near.start[c + 1] += 1);
        (1..near.start.len()).for_each(|c| near.start[c] += near.start[c - 1]);
        let mut at = near.start.clone();
        for (i, &c) in cells.iter().enumerate() {
            near.sorted[at[c] as usize] = i as u32;
            at[c] += 1;
        }
        near
    }

    fn axis(&self, v: f64, k: usize) -> usize {
        (((v - self.low[k]) / self.cell).max(0.0) as usize).min(self.count[k] - 1)
    }

    fn index(&self, [x, y, z]: [usize; 3]) -> usize {
        (z * self.count[1] + y) * self.count[0] + x
    }

    /// Numbers of the places within a distance, cell by cell.
    pub(super) fn within(&self, at: Vector, reach: f64) -> Vec<u32> {
        let mut found = Vec::new();
        let range = |k: usize| self.axis(at[k] - reach, k)..=self.axis(at[k] + reach, k);
        for z in range(2) {
            for y in range(1) {
                for x in range(0) {
                    let c = self.index([x, y, z]);
                    let held = &self.sorted[self.start[c] as usize..self.start[c + 1] as usize];
                    found.extend(held.iter().filter(|i| distance(self.places[**i as usize], at) <= reach));
                }
            }
        }
        found
    }
}

/// Nodes by cubic cells, as they come.
pub(super) struct Cells {
    cell: f64,
    nodes: BTreeMap<[i64; 3], Vec<u32>>,
}

impl Cells {
    /// Cells of a length, m.
    pub(super) fn new(cell: f64) -> Self {
        Self { cell, nodes: BTreeMap::new() }
    }

    fn cell(&self, at: Vector) -> [i64; 3] {
        at.map(|v| (v / self.cell).floor() as i64)
    }

    pub(super) fn add(&mut self, node: u32, at: Vector) {
        self.nodes.entry(self.cell(at)).or_default().push(node);
    }

    /// Nodes in the cell of a place and those next to it.
    pub(super) fn around(&self, at: Vector) -> impl Iterator<Item = u32> {
        let [x, y, z] = self.cell(at);
        let next = move |k: i64| [x + k % 3 - 1, y + k / 3 % 3 - 1, z + k / 9 - 1];
        (0..27).filter_map(move |k| self.nodes.get(&next(k))).flatten().copied()
    }
}
