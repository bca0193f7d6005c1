//! Nodes from the highest to the lowest.

const DIGIT: u32 = 11;
const BUCKETS: usize = 1 << DIGIT;

/// Nodes by height (m), the highest first; equals by node. NaN is left out. Radix sort by 2⁻³² of
/// the relief, then what is nearer: O(n) but for level ground.
pub fn highest_first(height: &[f64]) -> Vec<usize> {
    let (lo, hi) = height.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), &h| (a.min(h), b.max(h)));
    let scale = if hi > lo { f64::from(u32::MAX) / (hi - lo) } else { 0.0 };
    let key = |(i, &h): (usize, &f64)| u64::from(((hi - h) * scale) as u32) << 32 | i as u64;
    let mut keys: Vec<u64> = height.iter().enumerate().filter(|h| !h.1.is_nan()).map(key).collect();
    let mut spare = vec![0; keys.len()];
    for pass in 0..3 {
        let shift = 32 + pass * DIGIT;
        let digit = |k: u64| (k >> shift) as usize & (BUCKETS - 1);
        let mut start = [0usize; BUCKETS];
        keys.iter().for_each(|&k| start[digit(k)] += 1);
        let mut sum = 0;
        for s in &mut start {
            sum += std::mem::replace(s, sum);
        }
        for &k in &keys {
            let at = &mut start[digit(k)];
            spare[*at] = k;
            *at += 1;
        }
        std::mem::swap(&mut keys, &mut spare);
    }
    for run in keys.chunk_by_mut(|a, b| a >> 32 == b >> 32).filter(|run| run.len() > 1) {
        let at = |k: u64| height[k as u32 as usize];
        run.sort_unstable_by(|&a, &b| at(b).total_cmp(&at(a)).then(a.cmp(&b)));
    }
    keys.into_iter().map(|key| key as u32 as usize).collect()
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
        let order = highest_first(&z);
        assert_eq!(order.len(), 4999);
        assert!(order.windows(2).all(|w| z[w[0]] >= z[w[1]]));
        assert_eq!(highest_first(&[1.0, 1.0, 1.0]), [0, 1, 2]);
    }
}
