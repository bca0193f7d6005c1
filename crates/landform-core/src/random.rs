//! Randomness by key: a value depends on (seed, key) and on nothing else.
//!
//! No generator is shared, so the order of visits, the number of threads and the insertion of a
//! stage change nothing. The mixing function is the finalizer of SplitMix64 (Steele, Lea & Flood
//! 2014), applied twice over the keys.

use crate::math;

/// The seed of a stage, a step or a particle.
///
/// ```
/// use landform_core::random::Seed;
///
/// let step = |seed: u64| Seed(seed).named("uplift").with(3);
/// assert_eq!(step(7).uniform(42), step(7).uniform(42));
/// assert_ne!(step(7).bits(42), step(8).bits(42));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default, serde::Serialize, serde::Deserialize)]
pub struct Seed(pub u64);

const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;

#[inline]
fn mix(mut x: u64) -> u64 {
    x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}

impl Seed {
    /// A seed for something inside this one: a step, a particle, an octave.
    #[inline]
    pub fn with(self, key: u64) -> Self {
        Self(mix(mix(self.0.wrapping_add(GOLDEN)) ^ key.wrapping_mul(GOLDEN).wrapping_add(GOLDEN)))
    }

    /// A seed for a named part.
    pub fn named(self, name: &str) -> Self {
        name.bytes().fold(self.with(name.len() as u64), |s, b| s.with(u64::from(b)))
    }

    /// 64 random bits for `key`.
    #[inline]
    pub fn bits(self, key: u64) -> u64 {
        mix(self.with(key).0)
    }

    /// A number in [0, 1) for `key`, on a lattice of 2⁻⁵³.
    #[inline]
    pub fn uniform(self, key: u64) -> f64 {
        (self.bits(key) >> 11) as f64 * (1.0 / (1u64 << 53) as f64)
    }

    /// A pair of independent standard normal numbers for `key` (Box and Muller 1958).
    pub fn normal_pair(self, key: u64) -> (f64, f64) {
        let u = 1.0 - self.uniform(key.wrapping_mul(2));
        let angle = std::f64::consts::TAU * self.uniform(key.wrapping_mul(2).wrapping_add(1));
        let radius = (-2.0 * math::log(u)).sqrt();
        (radius * math::cos(angle), radius * math::sin(angle))
    }

    /// A stream of bits, for inner loops that draw by the million.
    #[inline]
    pub fn stream(self) -> Stream {
        Stream(self.0)
    }

    /// A sequence of draws, for algorithms that are sequential by nature.
    pub fn draws(self) -> Draws {
        Draws { seed: self, count: 0 }
    }
}

/// A sequence of draws from one seed.
#[derive(Clone, Debug)]
pub struct Draws {
    seed: Seed,
    count: u64,
}

impl Draws {
    /// The next number in [0, 1).
    #[inline]
    pub fn uniform(&mut self) -> f64 {
        self.count += 1;
        self.seed.uniform(self.count)
    }

    /// The next index below `n`; 0 if `n` is 0.
    #[inline]
    pub fn below(&mut self, n: usize) -> usize {
        ((self.uniform() * n as f64) as usize).min(n.saturating_sub(1))
    }
}

/// A stream of random bits from one seed: SplitMix64 as published, one mixing a draw.
#[derive(Clone, Debug)]
pub struct Stream(u64);

impl Stream {
    /// The next 64 bits.
    #[inline]
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(GOLDEN);
        mix(self.0)
    }

    /// An index below `n` (at most 2³²) from 32 bits.
    #[inline]
    pub fn index(bits: u32, n: usize) -> usize {
        ((u64::from(bits) * n as u64) >> 32) as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const GOLDEN_BITS: u64 = 10_757_405_495_910_471_621;

    #[test]
    fn uniform_numbers_fill_the_unit_interval_evenly() {
        let seed = Seed(7);
        let mut bins = [0usize; 10];
        for i in 0..100_000 {
            bins[(seed.uniform(i) * 10.0) as usize] += 1;
        }
        assert!(bins.iter().all(|&b| (9_600..10_400).contains(&b)), "{bins:?}");
    }

    #[test]
    fn normal_numbers_have_mean_zero_and_variance_one() {
        let (mut sum, mut squares) = (0.0, 0.0);
        for i in 0..50_000 {
            let (a, b) = Seed(3).normal_pair(i);
            sum += a + b;
            squares += a * a + b * b;
        }
        assert!((sum / 1e5).abs() < 0.015 && (squares / 1e5 - 1.0).abs() < 0.02);
    }

    #[test]
    fn golden_values_do_not_change() {
        assert_eq!(Seed(7).bits(0), GOLDEN_BITS);
        assert_ne!(Seed(7).named("noise"), Seed(7).named("noise2"));
        assert_ne!(Seed(7).with(0), Seed(7));
    }
}
