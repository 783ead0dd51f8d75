//! Random states to look at a scene from.

use crate::model::{Scene, SceneInfo};

/// Number of random states.
pub const N_STATES: usize = 1000;

/// A scene with its inputs and constants, and the states at which it is looked at. The states need not fulfil the constraints:
/// the equations hold everywhere.
pub struct Probe<'s, S: Scene + ?Sized> {
    pub scene: &'s S,
    pub info: &'static SceneInfo,
    pub fixed: Vec<f64>,
    pub states: Vec<RandomState>,
}

pub struct RandomState {
    pub t: f64,
    pub q: Vec<f64>,
    pub v: Vec<f64>,
}

impl<'s, S: Scene + ?Sized> Probe<'s, S> {
    pub fn new(scene: &'s S, fixed: &[f64]) -> Self {
        let info = scene.info();
        let mut random = SplitMix64(0x9E37_79B9_7F4A_7C15);
        // lengths and speeds of the order of one, angles all around
        let size = |unit: &str| if unit == "rad" { std::f64::consts::PI } else { 2.0 };
        let states = (0..N_STATES)
            .map(|_| RandomState {
                t: info.until_s * 0.5 * (1.0 + random.symmetric()),
                q: info.coordinates.iter().map(|c| size(c.unit) * random.symmetric()).collect(),
                v: info.coordinates.iter().map(|_| 2.0 * random.symmetric()).collect(),
            })
            .collect();
        Self { scene, info, fixed: fixed.to_vec(), states }
    }
}

/// A small generator with a fixed seed, so that a failure comes back.
///
/// # Source
/// Steele, Lea, Flood, OOPSLA 2014.
struct SplitMix64(u64);

impl SplitMix64 {
    /// Uniform in −1 … 1.
    fn symmetric(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^= z >> 31;
        (z >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

/// The largest error met so far; a NaN stays.
#[derive(Default)]
pub struct Worst {
    pub error: f64,
    pub n_compared: usize,
}

impl Worst {
    /// Compares one number with its oracle, relative to `size` (at least one).
    pub fn compare(&mut self, value: f64, oracle: f64, size: f64) {
        let error = (value - oracle).abs() / size.max(1.0);
        if error > self.error || error.is_nan() {
            self.error = error;
        }
        self.n_compared += 1;
    }
}
