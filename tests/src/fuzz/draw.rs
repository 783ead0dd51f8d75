//! Numbers that repeat on every machine.

/// SplitMix64 (Steele, Lea, Flood, OOPSLA 2014).
pub struct Draw(u64);

/// Numbers at the edge of what a double can hold, and beyond.
const EDGES: [f64; 14] = [
    0.0,
    -0.0,
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::MAX,
    f64::MIN,
    f64::MIN_POSITIVE,
    5e-324,
    -5e-324,
    1e300,
    -1e300,
    1e-300,
    f64::EPSILON,
];

impl Draw {
    /// Number `i` of a series that belongs to a seed.
    pub fn new(seed: u64, i: u64) -> Self {
        let mut draw = Self(seed.rotate_left(32) ^ i);
        draw.next();
        draw
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A whole number below `n`; 0 when there is none.
    pub fn below(&mut self, n: usize) -> usize {
        (self.next() >> 33) as usize % n.max(1)
    }

    /// Whether something happens that does so once in `n` times.
    pub fn once_in(&mut self, n: usize) -> bool {
        self.below(n) == 0
    }

    /// Uniform.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Of every size between two powers of ten alike.
    pub fn decades(&mut self, low: f64, high: f64) -> f64 {
        10.0_f64.powf(self.between(low, high))
    }

    /// A number in place of `usual`: most are of its size, a few are of any size, fewer are none at all.
    pub fn instead_of(&mut self, usual: f64, wild: bool) -> f64 {
        let size = if usual == 0.0 || !usual.is_finite() { 1.0 } else { usual };
        match self.below(if wild { 12 } else { 6 }) {
            0 | 1 => size * self.decades(-0.5, 0.5),
            2 => size * self.decades(-4.0, 4.0),
            3 => size * self.between(-1.0, 1.0),
            4 | 5 => usual,
            6 => EDGES[self.below(EDGES.len())],
            7 => self.decades(-300.0, 300.0) * if self.once_in(2) { -1.0 } else { 1.0 },
            8 => -size,
            _ => size * self.decades(-10.0, 10.0),
        }
    }
}
