//! Nodes from the highest to the lowest.

/// Sorts nodes by height, the highest first; equals by node. NaN is left out. Radix sort by 2⁻³² of the relief, then what is nearer: O(n)
/// but for level ground.
#[derive(Clone, Debug, Default)]
pub(super) struct HighestFirst {
    keys: Vec<u64>,
    spare: Vec<u64>,
}

const DIGIT: u32 = 11;
const BUCKETS: usize = 1 << DIGIT;

impl HighestFirst {
    /// The nodes, in the low 32 bits.
    pub(super) fn sort(&mut self, height: &[f64]) -> &[u64] {
        let (lo, hi) = height.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), &h| (a.min(h), b.max(h)));
        let scale = if hi > lo { f64::from(u32::MAX) / (hi - lo) } else { 0.0 };
        self.keys.clear();
        let key = |(i, &h): (usize, &f64)| u64::from(((hi - h) * scale) as u32) << 32 | i as u64;
        self.keys.extend(height.iter().enumerate().filter(|h| !h.1.is_nan()).map(key));
        self.spare.resize(self.keys.len(), 0);
        for pass in 0..3 {
            let shift = 32 + pass * DIGIT;
            let digit = |k: u64| (k >> shift) as usize & (BUCKETS - 1);
            let mut start = [0usize; BUCKETS];
            self.keys.iter().for_each(|&k| start[digit(k)] += 1);
            let mut sum = 0;
            for s in &mut start {
                sum += std::mem::replace(s, sum);
            }
            for &k in &self.keys {
                let at = &mut start[digit(k)];
                self.spare[*at] = k;
                *at += 1;
            }
            std::mem::swap(&mut self.keys, &mut self.spare);
        }
        for run in self.keys.chunk_by_mut(|a, b| a >> 32 == b >> 32).filter(|run| run.len() > 1) {
            let at = |k: u64| height[k as u32 as usize];
            run.sort_unstable_by(|&a, &b| at(b).total_cmp(&at(a)).then(a.cmp(&b)));
        }
        &self.keys
    }

    /// The nodes as they were last sorted.
    pub(super) fn nodes(&self) -> impl Iterator<Item = usize> + '_ {
        self.keys.iter().map(|key| *key as u32 as usize)
    }
}

#[cfg(test)]
mod tests {
    use landform_core::random::Seed;

    use super::*;

    #[test]
    fn heights_fall_along_the_order() {
        let mut z: Vec<f64> = (0..5000).map(|i| 700.0 * Seed(4).uniform(i) - 300.0).collect();
        z[17] = f64::NAN;
        z[18] = z[19];
        z[20] = z[19] * (1.0 - f64::EPSILON);
        let mut sorter = HighestFirst::default();
        let order: Vec<usize> = sorter.sort(&z).iter().map(|k| *k as u32 as usize).collect();
        assert_eq!(order.len(), 4999);
        assert!(order.windows(2).all(|w| z[w[0]] >= z[w[1]]));
        assert_eq!(HighestFirst::default().sort(&[1.0, 1.0, 1.0]).len(), 3);
    }
}
