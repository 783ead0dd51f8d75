//! Points in a box, by their number alone.

use chacha20::ChaCha8Rng;
use chacha20::rand_core::{Rng as _, SeedableRng as _};

/// How samples are spread over their ranges.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Design {
    /// Latin hypercube: each range is cut into as many parts as there are samples, and each part has one sample.
    #[default]
    LatinHypercube,
    /// Independent, uniform.
    Random,
}

impl Design {
    /// `lhs` or `random`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::LatinHypercube => "lhs",
            Self::Random => "random",
        }
    }
}

/// Samples over ranges of several values. Sample `i` depends on the seed, the design, the number of samples and `i`, not on those before.
#[derive(Debug, Clone, PartialEq)]
pub struct Samples {
    pub(super) design: Design,
    pub(super) n: u64,
    pub(super) seed: u64,
    /// Name, lower end, upper end.
    pub(super) ranges: Vec<(String, f64, f64)>,
}

impl Samples {
    /// `n` samples; ranges follow by [`Samples::over`].
    pub fn new(design: Design, n: u64, seed: u64) -> Self {
        Self { design, n, seed, ranges: Vec::new() }
    }

    /// Spreads the samples over `low` to `high` of a value, too.
    #[must_use]
    pub fn over(mut self, name: impl Into<String>, low: f64, high: f64) -> Self {
        self.ranges.push((name.into(), low, high));
        self
    }

    /// Value `k` of sample `i`.
    pub(super) fn value(&self, i: u64, k: usize) -> f64 {
        let (_, low, high) = self.ranges[k];
        let mut random = ChaCha8Rng::seed_from_u64(self.seed);
        random.set_stream(k as u64);
        // two words of 32 bits a sample, behind the keys
        random.set_word_pos(2 * (N_ROUNDS as u128 + u128::from(i)));
        let uniform = unit(random.next_u64());
        let part = match self.design {
            Design::Random => uniform,
            Design::LatinHypercube => {
                random.set_word_pos(0);
                let keys = [0; N_ROUNDS].map(|_| random.next_u64());
                (permuted(i, self.n, &keys) as f64 + uniform) / self.n as f64
            }
        };
        // in this form both ends are met, and no overflow lies between them
        low * (1.0 - part) + high * part
    }
}

/// A number from 0 to less than 1, of 53 bits.
fn unit(bits: u64) -> f64 {
    (bits >> 11) as f64 * (0.5 * f64::EPSILON)
}

/// Rounds of the Feistel network: from four on it passes for random (Luby and Rackoff, SIAM J. Comput. 17, 1988).
const N_ROUNDS: usize = 4;

/// Place of `i` in a permutation of `0..n`, without a table: a Feistel network on the next power of four, repeated until it comes back
/// into the range (cycle walking: Black and Rogaway, CT-RSA 2002).
fn permuted(i: u64, n: u64, keys: &[u64; N_ROUNDS]) -> u64 {
    let half = (u64::BITS - n.saturating_sub(1).leading_zeros()).div_ceil(2).max(1);
    let mask = (1 << half) - 1;
    let mut place = i;
    loop {
        let (mut left, mut right) = (place >> half, place & mask);
        for key in keys {
            (left, right) = (right, left ^ (mixed(right ^ key) & mask));
        }
        place = left << half | right;
        if place < n {
            return place;
        }
    }
}

/// The finaliser of SplitMix64 (Steele, Lea and Flood, OOPSLA 2014).
fn mixed(mut x: u64) -> u64 {
    x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    fn numbers(design: Design, n: u64, k: usize) -> Vec<f64> {
        let samples = Samples::new(design, n, 7).over("a", 0.0, 1.0).over("b", 0.0, 1.0);
        (0..n).map(|i| samples.value(i, k)).collect()
    }

    #[test]
    fn analytic_each_part_of_a_latin_hypercube_has_one_sample() {
        for n in [1, 2, 3, 4, 5, 16, 17, 100, 1000] {
            for k in 0..2 {
                let parts: HashSet<u64> =
                    numbers(Design::LatinHypercube, n, k).iter().map(|x| (x * n as f64) as u64).collect();
                assert_eq!(parts, (0..n).collect(), "{n} samples");
            }
        }
    }

    /// Mean and correlation of independent uniform numbers lie within four standard deviations: 1/√(12 n) and 1/√n.
    #[test]
    fn analytic_random_samples_have_the_moments_of_uniform_ones() {
        const N: u64 = 10_000;
        let deviations = 4.0 / (N as f64).sqrt();
        for design in [Design::Random, Design::LatinHypercube] {
            let [a, b] = [0, 1].map(|k| numbers(design, N, k));
            let mean = |x: &[f64]| x.iter().sum::<f64>() / N as f64;
            let product: Vec<f64> = a.iter().zip(&b).map(|(a, b)| 12.0 * (a - 0.5) * (b - 0.5)).collect();
            for x in [&a, &b] {
                assert!((mean(x) - 0.5).abs() <= deviations / 12f64.sqrt(), "{}", mean(x));
            }
            assert!(mean(&product).abs() <= deviations, "{}", mean(&product));
            // neighbours in the list are no neighbours in the range: each lag has no correlation either
            let lagged: Vec<f64> = a.windows(2).map(|pair| 12.0 * (pair[0] - 0.5) * (pair[1] - 0.5)).collect();
            assert!(mean(&lagged).abs() <= deviations, "{}", mean(&lagged));
        }
    }

    #[test]
    fn invariant_sample_depends_on_its_seed_and_meets_its_range() {
        let of = |seed| Samples::new(Design::Random, 100, seed).over("a", -3.0, 5.0);
        let [one, same, other] = [1, 1, 2].map(|seed| (0..100).map(|i| of(seed).value(i, 0)).collect::<Vec<_>>());
        assert!(one == same && one != other && one.iter().all(|x| (-3.0..5.0).contains(x)));
        assert_eq!(Samples::new(Design::Random, 9, 1).over("a", 2.0, 2.0).value(4, 0), 2.0);
        assert!(Samples::new(Design::Random, 9, 1).over("a", -f64::MAX, f64::MAX).value(4, 0).is_finite());
    }
}
