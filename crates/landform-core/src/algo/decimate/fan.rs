//! Triangles around a node, by half-edges: half-edge 3 t + k goes from corner k of triangle t to
//! the next.

/// No half-edge, or no node.
const NONE: u32 = u32::MAX;

/// Triangles with their neighbours over edges.
pub(super) struct Fans {
    corners: Vec<u32>,
    /// The half-edge of the triangle on the other side.
    twins: Vec<u32>,
    /// A half-edge that leaves a node; none for nodes that stay where they are.
    out: Vec<u32>,
}

fn next(half: u32) -> u32 {
    if half % 3 == 2 { half - 2 } else { half + 1 }
}

fn previous(half: u32) -> u32 {
    if half.is_multiple_of(3) { half + 2 } else { half - 1 }
}

impl Fans {
    pub(super) fn new(nodes: usize, triangles: &[[u32; 3]]) -> Self {
        let corners: Vec<u32> = triangles.iter().flatten().copied().collect();
        // Half-edges by the node that they leave.
        let mut first = vec![0_u32; nodes + 1];
        for &i in &corners {
            first[i as usize + 1] += 1;
        }
        for i in 0..nodes {
            first[i + 1] += first[i];
        }
        let (mut place, mut leaving) = (first.clone(), vec![0_u32; corners.len()]);
        for (half, &i) in corners.iter().enumerate() {
            leaving[place[i as usize] as usize] = half as u32;
            place[i as usize] += 1;
        }
        let of = |i: u32| &leaving[first[i as usize] as usize..first[i as usize + 1] as usize];
        let to = |half: u32| corners[next(half) as usize];
        let twin = |half: u32| {
            let (a, b) = (corners[half as usize], to(half));
            of(b).iter().copied().find(|&other| to(other) == a).unwrap_or(NONE)
        };
        let twins = (0..corners.len() as u32).map(twin).collect();
        let out = (0..nodes as u32).map(|i| of(i).first().copied().unwrap_or(NONE)).collect();
        let counts: Vec<u32> = first.windows(2).map(|w| w[1] - w[0]).collect();
        let mut fans = Self { corners, twins, out };
        fans.hold_pinched(&counts);
        fans
    }

    /// Nodes at which parts of the surface touch stay where they are.
    fn hold_pinched(&mut self, counts: &[u32]) {
        let mut fan = Vec::new();
        for node in 0..counts.len() as u32 {
            let whole = self.around(node, &mut fan).is_some() && fan.len() == counts[node as usize] as usize;
            if !whole {
                self.out[node as usize] = NONE;
            }
        }
    }

    /// The half-edges that leave a node, counter-clockwise, from the border if it is there; whether
    /// they close. None for nodes that stay.
    pub(super) fn around(&self, node: u32, fan: &mut Vec<u32>) -> Option<bool> {
        fan.clear();
        let some = self.out[node as usize];
        if some == NONE {
            return None;
        }
        let (mut start, mut closed) = (some, false);
        while self.twins[start as usize] != NONE {
            start = next(self.twins[start as usize]);
            if start == some {
                closed = true;
                break;
            }
        }
        let mut half = start;
        loop {
            fan.push(half);
            half = self.twins[previous(half) as usize];
            if half == NONE || half == start {
                return Some(closed);
            }
        }
    }

    /// The k-th neighbour of a fan; the last one of an open fan follows its triangles.
    pub(super) fn neighbour(&self, fan: &[u32], k: usize) -> u32 {
        match fan.get(k) {
            Some(&half) => self.corners[next(half) as usize],
            None => self.corners[previous(fan[fan.len() - 1]) as usize],
        }
    }

    /// Corners of the triangle of a half-edge, from the node that it leaves.
    pub(super) fn corners(&self, half: u32) -> [u32; 3] {
        [half, next(half), previous(half)].map(|h| self.corners[h as usize])
    }

    /// Draws the node of a fan onto one of its neighbours.
    pub(super) fn collapse(&mut self, fan: &[u32], target: u32) {
        let node = self.corners[fan[0] as usize];
        self.out[node as usize] = NONE;
        let held = self.out[target as usize] == NONE;
        for &half in fan {
            let [_, a, b] = self.corners(half);
            if a == target {
                self.join(self.twins[next(half) as usize], self.twins[previous(half) as usize]);
            } else if b == target {
                self.join(self.twins[next(half) as usize], self.twins[half as usize]);
            } else {
                self.corners[half as usize] = target;
                continue;
            }
            [half, next(half), previous(half)].iter().for_each(|&h| self.corners[h as usize] = NONE);
        }
        for &half in fan.iter().filter(|&&half| self.corners[half as usize] != NONE) {
            for h in [half, next(half), previous(half)] {
                let from = self.corners[h as usize] as usize;
                if self.out[from] != NONE {
                    self.out[from] = h;
                }
            }
        }
        debug_assert!(held == (self.out[target as usize] == NONE));
    }

    /// Makes two half-edges twins; either may be none.
    fn join(&mut self, a: u32, b: u32) {
        for (one, other) in [(a, b), (b, a)] {
            if one != NONE {
                self.twins[one as usize] = other;
            }
        }
    }

    /// The triangles that are left.
    pub(super) fn triangles(&self) -> impl Iterator<Item = [u32; 3]> {
        self.corners.as_chunks::<3>().0.iter().copied().filter(|t| t[0] != NONE)
    }

    /// Whether a triangle is left.
    pub(super) fn has(&self, triangle: usize) -> bool {
        self.corners[3 * triangle] != NONE
    }
}
