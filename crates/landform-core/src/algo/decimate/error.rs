//! Where removed nodes lie, and how far they are from the surface.

use super::fan::Fans;

/// No node.
const NONE: u32 = u32::MAX;

/// Removed nodes by the triangle that they lie in.
pub(super) struct Errors {
    /// First removed node of a triangle.
    first: Vec<u32>,
    /// The next one of the same triangle.
    next: Vec<u32>,
    removed: Vec<bool>,
    /// Greatest distance of a triangle's removed nodes, m.
    error: Vec<f64>,
    /// Nodes that are laid anew: node, place in the fan, distance.
    moved: Vec<(u32, u32, f64)>,
    around: Vec<(u32, [[f64; 3]; 3])>,
}

impl Errors {
    pub(super) fn new(nodes: usize, triangles: usize) -> Self {
        Self {
            first: vec![NONE; triangles],
            next: vec![NONE; nodes],
            removed: vec![false; nodes],
            error: vec![0.0; triangles],
            moved: Vec::new(),
            around: Vec::new(),
        }
    }

    /// Greatest distance of the removed nodes of a triangle, m.
    pub(super) fn of(&self, triangle: u32) -> f64 {
        self.error[triangle as usize]
    }

    pub(super) fn is_removed(&self, node: u32) -> bool {
        self.removed[node as usize]
    }

    /// Greatest distance of all, m.
    pub(super) fn greatest(&self, fans: &Fans) -> f64 {
        (0..self.error.len()).filter(|&t| fans.has(t)).map(|t| self.error[t]).fold(0.0, f64::max)
    }

    /// Lays a node and all removed ones around it into the triangles that are there when it is
    /// drawn onto a neighbour; changes nothing and returns false if one of them is farther from
    /// them than the tolerance.
    pub(super) fn try_move(
        &mut self,
        points: &[[f64; 3]],
        fans: &Fans,
        fan: &[u32],
        node: u32,
        target: u32,
        tolerance: f64,
    ) -> bool {
        self.around.clear();
        self.moved.clear();
        for &half in fan {
            let [_, a, b] = fans.corners(half);
            if a != target && b != target {
                self.around.push((half / 3, [target, a, b].map(|i| points[i as usize])));
            }
        }
        if !self.lay(points, node, tolerance) {
            return false;
        }
        for &half in fan {
            let mut other = self.first[half as usize / 3];
            while other != NONE {
                if !self.lay(points, other, tolerance) {
                    return false;
                }
                other = self.next[other as usize];
            }
        }
        for &half in fan {
            self.first[half as usize / 3] = NONE;
            self.error[half as usize / 3] = 0.0;
        }
        for &(other, triangle, distance) in &self.moved {
            let t = triangle as usize;
            self.next[other as usize] = self.first[t];
            self.first[t] = other;
            self.error[t] = self.error[t].max(distance);
        }
        self.removed[node as usize] = true;
        true
    }

    /// Finds the new triangle of a node; whether it is near enough.
    fn lay(&mut self, points: &[[f64; 3]], node: u32, tolerance: f64) -> bool {
        let at = points[node as usize];
        let mut best = (f64::NEG_INFINITY, NONE, f64::INFINITY);
        for &(triangle, corners) in &self.around {
            let weights = weights(corners, at);
            let least = weights.into_iter().fold(f64::INFINITY, f64::min);
            if least > best.0 {
                best = (least, triangle, (height(corners, weights) - at[2]).abs());
                if least >= 0.0 {
                    break;
                }
            }
        }
        self.moved.push((node, best.1, best.2));
        best.2 <= tolerance
    }
}

/// Weights of three corners at a place in plan; all are at least 0 inside.
pub(super) fn weights([a, b, c]: [[f64; 3]; 3], p: [f64; 3]) -> [f64; 3] {
    let cross = |o: [f64; 3], u: [f64; 3], v: [f64; 3]| (u[0] - o[0]) * (v[1] - o[1]) - (u[1] - o[1]) * (v[0] - o[0]);
    let (wa, wb, wc) = (cross(p, b, c), cross(p, c, a), cross(p, a, b));
    let sum = wa + wb + wc;
    [wa / sum, wb / sum, wc / sum]
}

/// Height of a plane through three corners.
pub(super) fn height(corners: [[f64; 3]; 3], weights: [f64; 3]) -> f64 {
    (0..3).map(|k| corners[k][2] * weights[k]).sum()
}
