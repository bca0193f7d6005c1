//! Shortest ways by number of edges, and how many of them lead over each vertex.
//!
//! Brandes (2001), A faster algorithm for betweenness centrality, Journal of Mathematical
//! Sociology 25.

/// What the shortest ways of a graph say.
pub(super) struct Paths {
    pub(super) parts: usize,
    /// Mean length of a way; parts weigh by their vertices.
    pub(super) mean: f64,
    pub(super) dominance: f64,
}

pub(super) fn of(joined: &[Vec<u32>]) -> Paths {
    let n = joined.len();
    let mut over = vec![0.0; n];
    let mut search = Search::new(n);
    let (mut parts, mut weighted) = (0.0, 0.0);
    for source in 0..n {
        let (reached, total) = search.from(source as u32, joined, &mut over);
        // Each of a part's vertices counts as that share of the part.
        parts += 1.0 / reached as f64;
        weighted += if reached > 1 { total as f64 / (reached - 1) as f64 } else { 0.0 };
    }
    let pairs = (n as f64 - 1.0) * (n as f64 - 2.0);
    let most = over.iter().copied().fold(0.0, f64::max);
    let short: f64 = over.iter().map(|b| most - b).sum();
    Paths {
        parts: f64::round(parts) as usize,
        mean: if n > 0 { weighted / n as f64 } else { 0.0 },
        dominance: if pairs > 0.0 { short / pairs / (n as f64 - 1.0) } else { 0.0 },
    }
}

struct Search {
    far: Vec<u32>,
    ways: Vec<f64>,
    share: Vec<f64>,
    order: Vec<u32>,
}

impl Search {
    fn new(n: usize) -> Self {
        Self { far: vec![u32::MAX; n], ways: vec![0.0; n], share: vec![0.0; n], order: Vec::with_capacity(n) }
    }

    /// Adds to each vertex the part of ways from `source` that lead over it; returns how many
    /// vertices were reached and the sum of their distances.
    fn from(&mut self, source: u32, joined: &[Vec<u32>], over: &mut [f64]) -> (usize, u64) {
        self.far.fill(u32::MAX);
        self.order.clear();
        self.order.push(source);
        (self.far[source as usize], self.ways[source as usize], self.share[source as usize]) = (0, 1.0, 0.0);
        let (mut next, mut total) = (0, 0);
        while let Some(&v) = self.order.get(next) {
            next += 1;
            let at = self.far[v as usize];
            total += u64::from(at);
            for &w in &joined[v as usize] {
                let to = w as usize;
                if self.far[to] == u32::MAX {
                    (self.far[to], self.ways[to], self.share[to]) = (at + 1, 0.0, 0.0);
                    self.order.push(w);
                }
                if self.far[to] == at + 1 {
                    self.ways[to] += self.ways[v as usize];
                }
            }
        }
        for &w in self.order.iter().rev() {
            let (far, part) = (self.far[w as usize], (1.0 + self.share[w as usize]) / self.ways[w as usize]);
            for &v in joined[w as usize].iter().filter(|v| self.far[**v as usize] + 1 == far) {
                self.share[v as usize] += self.ways[v as usize] * part;
            }
            if w != source {
                over[w as usize] += self.share[w as usize];
            }
        }
        (self.order.len(), total)
    }
}
