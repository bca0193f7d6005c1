//! Sets that are joined: union-find with path halving.

/// Sets of numbers, each with one of them as its root.
pub(crate) struct DisjointSets {
    parent: Vec<u32>,
}

impl DisjointSets {
    /// Each of 0..count alone.
    pub(crate) fn new(count: usize) -> Self {
        Self { parent: (0..count as u32).collect() }
    }

    /// The root of a number's set.
    pub(crate) fn root(&mut self, mut x: u32) -> u32 {
        while self.parent[x as usize] != x {
            self.parent[x as usize] = self.parent[self.parent[x as usize] as usize];
            x = self.parent[x as usize];
        }
        x
    }

    /// Puts the set of a root under another number.
    pub(crate) fn put_under(&mut self, root: u32, other: u32) {
        self.parent[root as usize] = other;
    }

    /// Makes one set of two; the lower root is its root.
    pub(crate) fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.root(a), self.root(b));
        self.put_under(a.max(b), a.min(b));
    }
}
