//! Fewer triangles for a surface with one elevation a node, within an error in metres.
//!
//! # Model
//! A node is removed by drawing it along an edge onto a neighbour: its triangles are drawn with it,
//! two vanish. What remains are nodes of the surface itself, and triangles that cover the same
//! plan. Every node that was removed is known to the triangle that it lies in, so that its vertical
//! distance from the new surface is measured, not estimated.
//!
//! | symbol | meaning |
//! |---|---|
//! | e | greatest vertical distance of a removed node from the surface, m |
//! | q | shape of a triangle in plan, 4√3 area / Σ side²: 1 if equilateral |
//!
//! # Method
//! Nodes are taken from a queue in the order of the cost that they had when they were last looked
//! at: their own distance from the surface without them and the greatest distance known around
//! them, both over the tolerance, plus a little for thin triangles and long edges. A node whose
//! surroundings changed is looked at anew. It goes if the measured error of all nodes around it
//! stays within the tolerance and no triangle turns over or becomes a sliver; of several neighbours
//! the cheapest is tried first. Passes are repeated while they remove a fiftieth of the nodes.
//!
//! A node of a border goes only along a border that is straight there, so that the outline and
//! holes keep their plan; corners stay, and nodes where borders touch. The result is as closed, and
//! as free of folds, as the surface was. It does not depend on threads.
//!
//! # Limits
//! The error is that of nodes. Between them, on a triangle that crosses many, the old facets may
//! stand off by more, though by no more than their own relief.
//!
//! # Sources
//! Schroeder, Zarge & Lorensen 1992 (removal of vertices by their distance); Hoppe 1996 (edges
//! drawn together, a queue); Garland & Heckbert 1995 (the error of a height field is that at its
//! nodes).
//!
//! # Checked by
//! `tests`: the error at every node by an independent search, the plan's area, closed edges, planes
//! and cones with known answers, holes.

mod error;
mod fan;
#[cfg(test)]
mod tests;

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use error::Errors;
use fan::Fans;

use crate::math;

/// Passes are repeated while they remove this share of the nodes.
const WORTH_A_PASS: f64 = 0.02;
/// What thin triangles cost beside an error of the tolerance.
const THIN: f64 = 0.1;
/// What a doubling of the longest edge costs beside an error of the tolerance.
const LONG: f64 = 0.02;

/// A surface with fewer triangles.
///
/// ```
/// use landform_core::algo::decimate::decimate;
///
/// // Four nodes around one in the middle, 1 m above them.
/// let points = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 2.0, 0.0], [0.0, 2.0, 0.0], [1.0, 1.0, 1.0]];
/// let triangles = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]];
/// assert_eq!(decimate(&points, &triangles, 0.5).kept.len(), 5);
/// let flat = decimate(&points, &triangles, 1.0);
/// assert_eq!((flat.kept, flat.triangles.len()), (vec![0, 1, 2, 3], 2));
/// assert_eq!(flat.error, 1.0);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Decimated {
    /// The nodes that remain, in their order.
    pub kept: Vec<u32>,
    /// Triangles between them, numbered as in `kept`.
    pub triangles: Vec<[u32; 3]>,
    /// Greatest vertical distance of a removed node from the surface, m.
    pub error: f64,
}

/// Removes nodes while every node of the surface lies within `tolerance`, m, above or below the
/// triangles that remain. Triangles are counter-clockwise in plan and have two at an edge at most.
pub fn decimate(points: &[[f64; 3]], triangles: &[[u32; 3]], tolerance: f64) -> Decimated {
    let mut work = Work::new(points, triangles, tolerance);
    if tolerance >= 0.0 {
        loop {
            let before = work.nodes;
            let removed = work.pass();
            if (removed as f64) < WORTH_A_PASS * before as f64 || removed == 0 {
                break;
            }
        }
    }
    work.result()
}

/// A node in the queue.
struct Entry {
    cost: f64,
    node: u32,
    /// State of the node's surroundings when the cost was found.
    seen: u32,
}

impl PartialEq for Entry {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}
impl Eq for Entry {}
impl PartialOrd for Entry {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
impl Ord for Entry {
    /// The cheapest is the greatest: a heap gives it first.
    fn cmp(&self, other: &Self) -> Ordering {
        other.cost.total_cmp(&self.cost).then(other.node.cmp(&self.node))
    }
}

struct Work<'a> {
    points: &'a [[f64; 3]],
    tolerance: f64,
    /// Length of an edge that counts as long, m.
    scale: f64,
    fans: Fans,
    errors: Errors,
    /// How often the triangles around a node changed.
    changes: Vec<u32>,
    /// Nodes left.
    nodes: usize,
    /// The triangles around a node, and the neighbours that it may be drawn onto.
    fan: Vec<u32>,
    targets: Vec<(f64, u32)>,
}

impl<'a> Work<'a> {
    fn new(points: &'a [[f64; 3]], triangles: &[[u32; 3]], tolerance: f64) -> Self {
        let fans = Fans::new(points.len(), triangles);
        let area: f64 = triangles.iter().map(|t| plan_area(t.map(|i| points[i as usize]))).sum();
        Self {
            points,
            tolerance,
            scale: (2.0 * area / triangles.len().max(1) as f64).sqrt(),
            errors: Errors::new(points.len(), triangles.len()),
            changes: vec![0; points.len()],
            nodes: points.len(),
            fans,
            fan: Vec::new(),
            targets: Vec::new(),
        }
    }

    /// Looks at every node once, and again where its surroundings changed; how many went.
    fn pass(&mut self) -> usize {
        let mut queue = BinaryHeap::with_capacity(self.nodes);
        for node in 0..self.points.len() as u32 {
            if let Some(cost) = self.look(node) {
                queue.push(Entry { cost, node, seen: self.changes[node as usize] });
            }
        }
        let mut removed = 0;
        while let Some(Entry { cost, node, seen }) = queue.pop() {
            let Some(now) = self.look(node) else { continue };
            let state = self.changes[node as usize];
            if state != seen && now > cost {
                queue.push(Entry { cost: now, node, seen: state });
            } else if self.remove(node) {
                removed += 1;
            }
        }
        self.nodes -= removed;
        removed
    }

    /// Finds the neighbours that a node may be drawn onto, by cost; the cost of the cheapest.
    fn look(&mut self, node: u32) -> Option<f64> {
        self.targets.clear();
        let closed = self.fans.around(node, &mut self.fan)?;
        let known = self.fan.iter().map(|h| self.errors.of(h / 3)).fold(0.0, f64::max);
        let worst_now = self.fan.iter().map(|&h| shape(self.corners(h))).fold(1.0, f64::min);
        let neighbours = self.fan.len() + usize::from(!closed);
        let is_straight = !closed && self.is_straight(node);
        for k in 0..neighbours {
            let is_along = k == 0 || k + 1 == neighbours;
            let target = self.fans.neighbour(&self.fan, k);
            if !(closed || is_along && is_straight) {
                continue;
            }
            if let Some(cost) = self.cost(node, target, worst_now) {
                self.targets.push((cost + known / self.tolerance.max(f64::MIN_POSITIVE), target));
            }
        }
        self.targets.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        self.targets.first().map(|target| target.0)
    }

    /// Corners in plan order of a triangle, from the node that a half-edge leaves.
    fn corners(&self, half: u32) -> [[f64; 3]; 3] {
        self.fans.corners(half).map(|i| self.points[i as usize])
    }

    /// Whether the border is straight at a node, whose fan is at hand.
    fn is_straight(&self, node: u32) -> bool {
        let ends = [0, self.fan.len()].map(|k| self.points[self.fans.neighbour(&self.fan, k) as usize]);
        let [a, b] = ends.map(|p| sub(p, self.points[node as usize]));
        let across = a[0] * b[1] - a[1] * b[0];
        let along = a[0] * b[0] + a[1] * b[1];
        along < 0.0 && across.abs() <= 1e-9 * -along
    }

    /// What it costs to draw a node onto a neighbour: its own error over the tolerance, and the
    /// shape of the triangles. None if a triangle turns over, gets thin, or the error is too large.
    fn cost(&self, node: u32, target: u32, worst_now: f64) -> Option<f64> {
        let (at, to) = (self.points[node as usize], self.points[target as usize]);
        let (mut worst, mut longest, mut inside, mut own) = (1.0_f64, 0.0_f64, f64::NEG_INFINITY, f64::INFINITY);
        for &half in &self.fan {
            let [_, a, b] = self.fans.corners(half);
            if a == target || b == target {
                continue;
            }
            let corners = [to, self.points[a as usize], self.points[b as usize]];
            let quality = shape(corners);
            worst = worst.min(quality);
            if !(quality > 0.0) {
                return None;
            }
            longest = [a, b].map(|i| plan_length(sub(self.points[i as usize], to))).into_iter().fold(longest, f64::max);
            let weights = error::weights(corners, at);
            let least = weights.into_iter().fold(f64::INFINITY, f64::min);
            if least > inside {
                inside = least;
                own = (error::height(corners, weights) - at[2]).abs();
            }
        }
        // Slivers may be mended, but not made.
        let is_sliver = worst < SLIVER && worst < worst_now;
        if !own.is_finite() || own > self.tolerance || is_sliver {
            return None;
        }
        let long = math::log2((longest / self.scale).max(1.0));
        Some(own / self.tolerance.max(f64::MIN_POSITIVE) + THIN * (1.0 - worst) + LONG * long)
    }

    /// Draws a node, just looked at, onto the first neighbour that keeps the error; whether it
    /// went.
    fn remove(&mut self, node: u32) -> bool {
        for k in 0..self.targets.len() {
            let target = self.targets[k].1;
            if self.errors.try_move(self.points, &self.fans, &self.fan, node, target, self.tolerance) {
                for &half in &self.fan {
                    let [_, a, b] = self.fans.corners(half);
                    self.changes[a as usize] += 1;
                    self.changes[b as usize] += 1;
                }
                self.fans.collapse(&self.fan, target);
                return true;
            }
        }
        false
    }

    fn result(self) -> Decimated {
        let mut number = vec![u32::MAX; self.points.len()];
        let (mut kept, mut triangles) = (Vec::with_capacity(self.nodes), Vec::new());
        for node in 0..self.points.len() as u32 {
            if !self.errors.is_removed(node) {
                number[node as usize] = kept.len() as u32;
                kept.push(node);
            }
        }
        triangles.extend(self.fans.triangles().map(|t| t.map(|i| number[i as usize])));
        Decimated { kept, triangles, error: self.errors.greatest(&self.fans) }
    }
}

/// Triangles thinner than this are not made.
const SLIVER: f64 = 0.05;

fn sub(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn plan_length(v: [f64; 3]) -> f64 {
    (v[0] * v[0] + v[1] * v[1]).sqrt()
}

/// Area in plan, positive if counter-clockwise.
fn plan_area([a, b, c]: [[f64; 3]; 3]) -> f64 {
    let (u, v) = (sub(b, a), sub(c, a));
    0.5 * (u[0] * v[1] - u[1] * v[0])
}

/// Shape in plan: 1 if equilateral, 0 if flat, negative if turned over.
fn shape([a, b, c]: [[f64; 3]; 3]) -> f64 {
    let squares: f64 = [sub(b, a), sub(c, b), sub(a, c)].iter().map(|v| v[0] * v[0] + v[1] * v[1]).sum();
    if squares > 0.0 { 4.0 * 3.0_f64.sqrt() * plan_area([a, b, c]) / squares } else { 0.0 }
}
