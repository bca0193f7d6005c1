//! The implicit step on any graph: conjugate gradients.

use landform_core::grid::{Domain, Status};
use landform_core::verb::Resolved;
use landform_core::{Error, Result, parallel};

use super::{TOLERANCE, between};

const MOST_ITERATIONS: usize = 20_000;

/// Links with their conductances, m²/s, in compressed rows.
#[derive(Clone, Debug)]
pub(super) struct Links {
    start: Vec<u32>,
    links: Vec<(u32, f64)>,
    area: Vec<f64>,
    inner: Vec<bool>,
}

impl Links {
    pub(super) fn new<D: Domain>(domain: &D, diffusivity: &Resolved) -> Self {
        let status = domain.status();
        let links = |i: usize| {
            let all = domain.neighbours(i).filter(move |_| status[i] != Status::Masked);
            all.map(move |link| (link.to as u32, between(domain, diffusivity, i, link))).filter(|l| l.1 > 0.0)
        };
        let area = (0..domain.len()).map(|i| domain.area(i)).collect();
        Self::of(links, area, |i| status[i] == Status::Interior)
    }

    /// Of the links of each node, its area, and whether it changes.
    pub(super) fn of<L: Iterator<Item = (u32, f64)>>(
        links_of: impl Fn(usize) -> L,
        area: Vec<f64>,
        changes: impl Fn(usize) -> bool,
    ) -> Self {
        let (mut start, mut links) = (vec![0], Vec::new());
        for i in 0..area.len() {
            links.extend(links_of(i));
            start.push(links.len() as u32);
        }
        let inner = (0..area.len()).map(changes).collect();
        Self { start, links, area, inner }
    }

    fn row(&self, i: usize) -> &[(u32, f64)] {
        &self.links[self.start[i] as usize..self.start[i + 1] as usize]
    }

    /// Volume flux out of node `i`, m³/s.
    #[inline]
    fn flux(&self, z: &[f64], i: usize) -> f64 {
        self.row(i).iter().map(|&(j, g)| g * (z[i] - z[j as usize])).sum()
    }

    /// The change of every node in one backward-Euler step, by conjugate gradients.
    pub(super) fn change(&self, z: &[f64], dt: f64) -> Result<Vec<f64>> {
        let n = z.len();
        let inner = |i: usize| self.inner[i];
        let diagonal = parallel::map(n, |i| {
            if inner(i) { self.area[i] / dt + self.row(i).iter().map(|l| l.1).sum::<f64>() } else { 1.0 }
        });
        let mut residual = parallel::map(n, |i| if inner(i) { -self.flux(z, i) } else { 0.0 });
        let norm = |v: &[f64]| parallel::sum(n, |i| v[i] * v[i] / diagonal[i]);
        let start = norm(&residual);
        let mut change = vec![0.0; n];
        if start == 0.0 {
            return Ok(change);
        }
        let mut direction = parallel::map(n, |i| residual[i] / diagonal[i]);
        let (mut product, mut image) = (start, vec![0.0; n]);
        for _ in 0..MOST_ITERATIONS {
            parallel::fill(&mut image, |i| {
                if inner(i) { direction[i] * self.area[i] / dt + self.flux(&direction, i) } else { 0.0 }
            });
            let alpha = product / parallel::sum(n, |i| direction[i] * image[i]);
            parallel::update(&mut change, |i, v| *v += alpha * direction[i]);
            parallel::update(&mut residual, |i, v| *v -= alpha * image[i]);
            let next = norm(&residual);
            if next <= TOLERANCE * TOLERANCE * start {
                return Ok(change);
            }
            let beta = next / product;
            product = next;
            parallel::update(&mut direction, |i, v| *v = residual[i] / diagonal[i] + beta * *v);
        }
        Err(Error::NotConverged {
            what: "linear diffusion".into(),
            iterations: MOST_ITERATIONS,
            residual: (product / start).sqrt(),
        })
    }
}
