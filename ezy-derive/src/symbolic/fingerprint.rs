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
}
