//! The ground along a road: which nodes it moves, and by how much.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use landform_core::terrain::{HeightField, NodeSurface};

use super::Profile;

/// A road's cross-section.
#[derive(Clone, Copy, Debug)]
pub(super) struct Section {
    /// Half of the width of the flattened strip, m.
    pub(super) half: f64,
    /// Fall per metre from the middle to the edges.
    pub(super) camber: f64,
    /// Slopes of cut and fill beside it.
    pub(super) cut: f64,
    pub(super) fill: f64,
}

/// A node that a road may move.
#[derive(Clone, Copy, Debug)]
struct Beside {
    node: u32,
    /// Height of the ground, m.
    z: f64,
    /// Distance from the middle of the road, m.
    away: f64,
    /// Height of the road there, unshifted, m.
    road: f64,
    bridge: bool,
}

/// The nodes along a road.
pub(super) struct Corridor<'a> {
    profile: &'a Profile,
    section: Section,
    nodes: Vec<Beside>,
    /// Whether the road is a bridge at each of its places.
    bridge: Vec<bool>,
    cell_area: f64,
}

/// The farthest that slopes of cut and fill go, in half-widths of the strip.
const FARTHEST: f64 = 40.0;

impl Section {
    /// The height of ground at `z`, `away` from the middle of a road at `road`.
    fn height(&self, z: f64, away: f64, road: f64, bridge: bool) -> f64 {
        let edge = road - self.camber * away.min(self.half);
        let beyond = (away - self.half).max(0.0);
        let low = if bridge { f64::NEG_INFINITY } else { edge - self.fill * beyond };
        z.clamp(low, edge + self.cut * beyond)
    }
}

impl<'a> Corridor<'a> {
    pub(super) fn of(terrain: &HeightField, profile: &'a Profile, section: Section, bridge_above: f64) -> Self {
        let off = profile.height.iter().zip(&profile.ground).map(|(h, z)| h - z);
        let bridge: Vec<bool> = off.clone().map(|off| off > bridge_above).collect();
        let most = off.fold(0.0, |most: f64, off| most.max(off.abs()));
        let [dx, dy] = terrain.grid().spacing;
        let slopes = 4.0 * most / section.cut.min(section.fill);
        let reach = section.half + slopes.min(FARTHEST * section.half) + 3.0 * dx.max(dy);
        let z = terrain.elevation();
        let beside = |(node, along, away): (usize, f64, f64)| {
            let k = (along as usize).min(profile.line.len() - 1);
            let next = (k + 1).min(profile.line.len() - 1);
            let road = profile.height[k] + (along - k as f64) * (profile.height[next] - profile.height[k]);
            Beside { node: node as u32, z: z[node], away, road, bridge: bridge[k] }
        };
        let nodes = near_line(terrain, &profile.line, reach).into_iter().filter(|n| !z[n.0].is_nan());
        let nodes = nodes.map(beside).collect();
        Self { profile, section, nodes, bridge, cell_area: terrain.grid().cell_area() }
    }

    pub(super) fn half(&self) -> f64 {
        self.section.half
    }

    fn height(&self, node: &Beside, shift: f64) -> f64 {
        self.section.height(node.z, node.away, node.road + shift, node.bridge)
    }

    /// Volumes of cut and fill with the road shifted up, m³.
    pub(super) fn volumes(&self, shift: f64) -> [f64; 2] {
        let mut sums = [0.0; 2];
        for node in &self.nodes {
            let rise = self.height(node, shift) - node.z;
            sums[usize::from(rise > 0.0)] += rise.abs() * self.cell_area;
        }
        sums
    }

    /// The shift up with which fill is `balance` times the cut: the higher the road, the more fill.
    pub(super) fn balanced(&self, balance: f64) -> f64 {
        let lacks = |shift: f64| {
            let [cut, fill] = self.volumes(shift);
            fill < balance * cut
        };
        let mut reach = self.nodes.iter().map(|n| (n.road - n.z).abs()).fold(0.0, f64::max);
        reach += self.section.camber * self.section.half;
        let (mut low, mut high) = (-reach, reach);
        if !lacks(low) || lacks(high) {
            // All of the road is a bridge, or lies on the ground.
            return 0.0;
        }
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if lacks(middle) {
                low = middle;
            } else {
                high = middle;
            }
        }
        0.5 * (low + high)
    }

    /// The nodes that change, and their new heights, m.
    pub(super) fn moved(&self, shift: f64) -> Vec<(u32, f64)> {
        let new = self.nodes.iter().map(|n| (n.node, self.height(n, shift), n.z));
        new.filter(|(_, new, z)| new != z).map(|(node, new, _)| (node, new)).collect()
    }

    /// Where bridges begin and end, m from the start.
    pub(super) fn bridges(&self) -> Vec<[f64; 2]> {
        let mut found: Vec<[f64; 2]> = Vec::new();
        for (k, _) in self.bridge.iter().enumerate().filter(|(_, b)| **b) {
            let at = self.profile.at[k];
            match found.last_mut() {
                Some(last) if k > 0 && self.bridge[k - 1] => last[1] = at,
                _ => found.push([at, at]),
            }
        }
        found
    }
}

/// Nodes within `reach` m of a line of even places, by index: the place along it (a number of
/// places and a part) that is nearest, and the distance. Places spread from node to node, each to
/// the nodes that it is nearest to.
fn near_line(terrain: &HeightField, line: &[[f64; 2]], reach: f64) -> Vec<(usize, f64, f64)> {
    let grid = terrain.grid();
    let (shape, position) = (grid.shape, |node: usize| {
        let cell = grid.shape.cell(node);
        [grid.x(cell.col), grid.y(cell.row)]
    });
    let mut best: Vec<(f64, f64)> = vec![(f64::INFINITY, 0.0); shape.len()];
    let mut heap = BinaryHeap::new();
    let offer = |node: usize, near: usize, best: &mut Vec<(f64, f64)>, heap: &mut BinaryHeap<_>| {
        let (along, away) = nearest(line, position(node), near);
        if away <= reach && away < best[node].0 {
            best[node] = (away, along);
            heap.push(Reverse((away.to_bits(), node)));
        }
    };
    for (k, &place) in line.iter().enumerate() {
        if let Some(node) = grid.node_at(place) {
            offer(node, k, &mut best, &mut heap);
        }
    }
    while let Some(Reverse((bits, node))) = heap.pop() {
        let (away, along) = best[node];
        if away.to_bits() != bits {
            continue;
        }
        let cell = shape.cell(node);
        for row in cell.row.saturating_sub(1)..(cell.row + 2).min(shape.rows) {
            for col in cell.col.saturating_sub(1)..(cell.col + 2).min(shape.cols) {
                offer(shape.index(row, col), along as usize, &mut best, &mut heap);
            }
        }
    }
    let is_near = |b: &(f64, f64)| b.0.is_finite();
    best.iter().enumerate().filter(|(_, b)| is_near(b)).map(|(node, b)| (node, b.1, b.0)).collect()
}

/// The place along a line nearest to a point, walking from place `k`, and its distance.
fn nearest(line: &[[f64; 2]], p: [f64; 2], mut k: usize) -> (f64, f64) {
    let square = |k: usize| (line[k][0] - p[0]) * (line[k][0] - p[0]) + (line[k][1] - p[1]) * (line[k][1] - p[1]);
    k = k.min(line.len() - 1);
    loop {
        if k + 1 < line.len() && square(k + 1) < square(k) {
            k += 1;
        } else if k > 0 && square(k - 1) < square(k) {
            k -= 1;
        } else {
            break;
        }
    }
    // On the stretches before and after it.
    let mut found = (k as f64, square(k).sqrt());
    for a in k.saturating_sub(1)..=k {
        let Some(&end) = line.get(a + 1) else { continue };
        let along = [end[0] - line[a][0], end[1] - line[a][1]];
        let length = along[0] * along[0] + along[1] * along[1];
        if !(length > 0.0) {
            continue;
        }
        let t = (((p[0] - line[a][0]) * along[0] + (p[1] - line[a][1]) * along[1]) / length).clamp(0.0, 1.0);
        let d = [line[a][0] + t * along[0] - p[0], line[a][1] + t * along[1] - p[1]];
        let away = (d[0] * d[0] + d[1] * d[1]).sqrt();
        if away < found.1 {
            found = (a as f64 + t, away);
        }
    }
    found
}
