//! Sets that are joined: union-find with path halving.

/// Sets of numbers, each with one of them as its root.
///
/// ```
/// use landform_core::algo::DisjointSets;
///
/// let mut sets = DisjointSets::new(4);
/// assert!(sets.join(3, 1) && sets.join(2, 3), "they were apart");
/// assert!(!sets.join(1, 2), "they were not");
/// assert_eq!([0, 1, 2, 3].map(|x| sets.root(x)), [0, 1, 1, 1]);
/// ```
pub struct DisjointSets {
    parent: Vec<u32>,
}

impl DisjointSets {
    /// Each of 0..count alone.
    ///
    /// ```
    /// assert_eq!(landform_core::algo::DisjointSets::new(3).root(2), 2);
    /// ```
    pub fn new(count: usize) -> Self {
        Self { parent: (0..count as u32).collect() }
    }

    /// The root of a number's set.
    ///
    /// ```
    /// let mut sets = landform_core::algo::DisjointSets::new(3);
    /// sets.join(1, 2);
    /// assert_eq!(sets.root(2), 1);
    /// ```
    pub fn root(&mut self, mut x: u32) -> u32 {
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

    /// Makes one set of two, with the lower root as its root; whether they were two.
    ///
    /// ```
    /// let mut sets = landform_core::algo::DisjointSets::new(2);
    /// assert_eq!([sets.join(1, 0), sets.join(1, 0)], [true, false]);
    /// ```
    pub fn join(&mut self, a: u32, b: u32) -> bool {
        let (a, b) = (self.root(a), self.root(b));
        self.put_under(a.max(b), a.min(b));
        a != b
    }
}
