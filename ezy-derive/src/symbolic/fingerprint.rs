//! Values of coefficients at one random point of a finite field, to decide equality.
//!
//! Two rational expressions that agree at a random point modulo two 61-bit primes are equal, but for a
//! probability of about `degree / 2^122` (Schwartz 1980, Zippel 1979). The point is fixed, so results repeat.

/// Value modulo two primes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Fingerprint([u64; 2]);

/// 2^61 − 1 and the next smaller prime, 2^61 − 31.
const PRIMES: [u64; 2] = [(1 << 61) - 1, (1 << 61) - 31];

impl Fingerprint {
    pub const ZERO: Self = Self([0, 0]);
    pub const ONE: Self = Self([1, 1]);

    /// The exact value of a finite number: mantissa times a power of two.
    pub fn number(x: f64) -> Self {
        if x == 0.0 {
            return Self::ZERO;
        }
        let bits = x.abs().to_bits();
        let raw_exponent = (bits >> 52) as i64;
        let fraction = bits & ((1 << 52) - 1);
        let (mantissa, exponent) =
            if raw_exponent == 0 { (fraction, -1074) } else { (fraction | (1 << 52), raw_exponent - 1075) };
        let two = Self([2, 2]);
        let power = two.power(exponent.unsigned_abs());
        let power = if exponent < 0 { power.inverse() } else { power };
        let value = Self(PRIMES.map(|p| mantissa % p)).mul(power);
        if x < 0.0 { value.neg() } else { value }
    }

    /// A random value that belongs to a key, such as a parameter or a function with its arguments.
    pub fn random(key: &[u64]) -> Self {
        let mut state = 0x9e37_79b9_7f4a_7c15_u64;
        for &word in key {
            state = mix(state ^ word);
        }
        Self(std::array::from_fn(|i| {
            state = mix(state);
            state % PRIMES[i]
        }))
    }

    pub fn words(self) -> [u64; 2] {
        self.0
    }

    pub fn add(self, other: Self) -> Self {
        self.zip(other, |a, b, p| (a + b) % p)
    }

    pub fn mul(self, other: Self) -> Self {
        self.zip(other, |a, b, p| (u128::from(a) * u128::from(b) % u128::from(p)) as u64)
    }

    pub fn neg(self) -> Self {
        self.zip(self, |a, _, p| (p - a) % p)
    }

    /// Reciprocal; zero has none and yields zero.
    pub fn inverse(self) -> Self {
        Self(std::array::from_fn(|i| self.power(PRIMES[i] - 2).0[i]))
    }

    fn power(self, mut exponent: u64) -> Self {
        let (mut base, mut out) = (self, Self::ONE);
        while exponent > 0 {
            if exponent & 1 == 1 {
                out = out.mul(base);
            }
            base = base.mul(base);
            exponent >>= 1;
        }
        out
    }

    fn zip(self, other: Self, f: impl Fn(u64, u64, u64) -> u64) -> Self {
        Self(std::array::from_fn(|i| f(self.0[i], other.0[i], PRIMES[i])))
    }
}

/// SplitMix64 (Steele, Lea, Flood 2014).
fn mix(x: u64) -> u64 {
    let mut z = x.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_fingerprint_of_dyadic_numbers_follows_field_arithmetic() {
        let half = Fingerprint::number(0.5);
        assert_eq!(half.add(half), Fingerprint::ONE);
        assert_eq!(Fingerprint::number(-3.0).add(Fingerprint::number(3.0)), Fingerprint::ZERO);
        assert_eq!(Fingerprint::number(0.1).mul(Fingerprint::number(0.1).inverse()), Fingerprint::ONE);
        assert_eq!(Fingerprint::number(1e300).mul(Fingerprint::number(1e300).inverse()), Fingerprint::ONE);
    }

    /// Whether `n` is prime (Miller, Rabin); with these bases certain below 2^64.
    fn is_prime(n: u64) -> bool {
        let multiply = |a: u64, b: u64| (u128::from(a) * u128::from(b) % u128::from(n)) as u64;
        let power = |base: u64, exponent: u64| {
            (0..64).rev().fold(1, |x, i| {
                let square = multiply(x, x);
                if exponent >> i & 1 == 1 { multiply(square, base) } else { square }
            })
        };
        let twos = (n - 1).trailing_zeros();
        [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37].iter().all(|&base| {
            let mut x = power(base, (n - 1) >> twos);
            let starts = x == 1;
            let found = (0..twos).any(|_| {
                let is_minus_one = x == n - 1;
                x = multiply(x, x);
                is_minus_one
            });
            starts || found
        })
    }

    #[test]
    fn analytic_moduli_are_the_two_largest_primes_of_61_bits() {
        assert_eq!(PRIMES, [2_305_843_009_213_693_951, 2_305_843_009_213_693_921]);
        assert!(PRIMES.into_iter().all(is_prime));
        assert!((PRIMES[1] + 1..PRIMES[0]).all(|n| !is_prime(n)));
    }

    /// 2^61 is 1 and 31 modulo the two primes.
    #[test]
    fn analytic_fingerprints_of_numbers_are_their_values() {
        for (x, expected) in [
            (0.0, [0, 0]),
            (1.0, [1, 1]),
            (3.0, [3, 3]),
            (-1.0, PRIMES.map(|p| p - 1)),
            (2.0_f64.powi(60), [1 << 60; 2]),
            (2.0_f64.powi(61), [1, 31]),
            (3.0 * 2.0_f64.powi(70), [3 << 9, (3 * 31) << 9]),
            (2.0_f64.powi(52) + 1.0, [(1 << 52) + 1; 2]),
        ] {
            assert_eq!(Fingerprint::number(x).words(), expected, "{x}");
        }
        // parts of powers of two, down to the smallest number there is
        for exponent in [1, 52, 53, 700, 1022, 1023, 1073, 1074] {
            let small = 2.0_f64.powi(-exponent / 2) * 2.0_f64.powi(-(exponent - exponent / 2));
            let back = Fingerprint::number(2.0).power(exponent as u64);
            assert_eq!(Fingerprint::number(small).mul(back), Fingerprint::ONE, "2^-{exponent}");
            let three = Fingerprint::number(3.0 * small).mul(back);
            assert!(3.0 * small == 0.0 || three == Fingerprint::number(3.0), "3 2^-{exponent}");
        }
        let next = f64::from_bits(1.1_f64.to_bits() + 1);
        assert_ne!(Fingerprint::number(1.1), Fingerprint::number(next));
    }

    #[test]
    fn cross_field_operations_are_those_of_large_numbers() {
        let keys = (0..40).map(|i| Fingerprint::random(&[7, i]));
        let edge = [Fingerprint::ZERO, Fingerprint::ONE, Fingerprint(PRIMES.map(|p| p - 1))];
        let all: Vec<Fingerprint> = keys.chain(edge).collect();
        for x in &all {
            for y in &all {
                for (i, p) in PRIMES.into_iter().enumerate() {
                    let (a, b) = (u128::from(x.0[i]), u128::from(y.0[i]));
                    let p = u128::from(p);
                    assert!(a < p, "a value is below its modulus");
                    assert_eq!(u128::from(x.add(*y).0[i]), (a + b) % p);
                    assert_eq!(u128::from(x.mul(*y).0[i]), a * b % p);
                }
            }
            assert_eq!(x.add(x.neg()), Fingerprint::ZERO);
            let expected = if *x == Fingerprint::ZERO { Fingerprint::ZERO } else { Fingerprint::ONE };
            assert_eq!(x.mul(x.inverse()), expected);
        }
        let cube = all[0].mul(all[0]).mul(all[0]);
        assert_eq!([all[0].power(3), all[0].power(1), all[0].power(0)], [cube, all[0], Fingerprint::ONE]);
    }

    /// The first numbers of SplitMix64 from 1234567, as its authors give them; each is the mix of the state before it.
    #[test]
    fn reference_keys_are_mixed_by_splitmix64() {
        let expected = [6_457_827_717_110_365_317, 3_203_168_211_198_807_973, 9_817_491_932_198_370_423];
        let state = |i: u64| 1_234_567_u64.wrapping_add(i.wrapping_mul(0x9e37_79b9_7f4a_7c15));
        assert_eq!([0, 1, 2].map(|i| mix(state(i))), expected);
    }

    #[test]
    fn invariant_keys_that_differ_have_different_values() {
        let keys: [&[u64]; 8] = [&[], &[0], &[1], &[0, 0], &[0, 1], &[1, 0], &[1, 1], &[2, 1, 0]];
        let found: std::collections::HashSet<Fingerprint> = keys.iter().map(|key| Fingerprint::random(key)).collect();
        assert_eq!(found.len(), keys.len());
        assert!(found.iter().flat_map(|value| value.words()).all(|word| word > 1 << 40), "they are spread");
    }
}
