//! The pendulum that parallel cranks are.
//!
//! Every crank turns by φ, and the coupler translates with the heads: its velocity is l φ'. With crank k of mass m, centre of mass
//! at e from its foot and inertia J about it, and a coupler of mass M,
//!
//! ```text
//! T = ½ I φ'²,       I = Σ (J + m e²) + M l²
//! V = g S sin φ,     S = Σ m e + M l
//! I φ'' = −g S cos φ
//! ```
//!
//! Neither the coupler's inertia nor the places of the feet appear. The equation is integrated by its Taylor series, whose recurrence
//! is written here: with s = sin φ, c = cos φ, w = φ' and κ = g S/I,
//!
//! ```text
//! (k+1) φ_{k+1} = w_k,   (k+1) w_{k+1} = −κ c_k,   (k+1) s_{k+1} = Σ c_i w_{k−i},   (k+1) c_{k+1} = −Σ s_i w_{k−i}
//! ```
//!
//! The same series with δφ' = δw, δw' = κ s δφ follows how errors grow.

use super::mechanism::{Cranks, GRAVITY};

/// Order of the series: with steps of [`REACH`] the first term left out is below 1e-17 of the state.
const ORDER: usize = 24;

/// Part of the time 1/(|w| + √κ), in which the motion changes, that a step takes.
const REACH: f64 = 0.125;

/// I φ'' = −g S cos φ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pendulum {
    /// κ = g S/I, 1/s².
    pub kappa: f64,
}

/// Angle from the horizontal, rad, and its rate, rad/s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Swing {
    /// rad
    pub angle: f64,
    /// rad/s
    pub rate: f64,
}

/// The motion up to one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Course {
    /// Where it ends.
    pub end: Swing,
    /// Largest |φ'| on the way, rad/s.
    pub fastest: f64,
    /// Smallest |φ'| in the level positions on the way, rad/s; infinite without one.
    pub slowest_level: f64,
    /// Level positions on the way.
    pub n_level: u32,
    /// By how much an error made on the way is larger at the end: the largest, over all times of the error, of the norm of
    /// (δφ, δφ'/Ω) with Ω = [`Course::pace`].
    pub growth: f64,
    /// Ω = fastest + √κ, rad/s: what the motion does in a second.
    pub pace: f64,
}

impl Pendulum {
    /// The one that these cranks are.
    pub fn of(cranks: &Cranks) -> Self {
        let (mut inertia, mut moment) = (0.0, 0.0);
        for crank in &cranks.cranks {
            inertia += crank.inertia_kg_m2 + crank.mass_kg * crank.centre_m * crank.centre_m;
            moment += crank.mass_kg * crank.centre_m;
        }
        inertia += cranks.coupler_kg * cranks.length_m * cranks.length_m;
        moment += cranks.coupler_kg * cranks.length_m;
        Self { kappa: GRAVITY * moment / inertia }
    }

    /// φ'²/2 + κ sin φ, which is constant, 1/s².
    pub fn energy(&self, at: Swing) -> f64 {
        0.5 * at.rate * at.rate + self.kappa * at.angle.sin()
    }

    /// From `start` for `duration_s`; cranks are level at `level` and half a turn from it.
    pub fn run(&self, start: Swing, level: f64, duration_s: f64) -> Course {
        let (mut now, mut rest) = (start, [0.0; 2]);
        // columns: what a unit of δφ and of δw at the start have become
        let mut columns = [[1.0, 0.0], [0.0, 1.0]];
        let mut seen = vec![columns];
        let (mut t, mut fastest, mut slowest_level, mut n_level) = (0.0, start.rate.abs(), f64::INFINITY, 0);
        while t < duration_s {
            let longest = REACH / (now.rate.abs() + self.kappa.sqrt());
            let h = if duration_s - t > 1.5 * longest { longest } else { duration_s - t };
            let before = now;
            let change = self.step(&mut now, &mut columns, h);
            now.angle = compensated(before.angle, change[0], &mut rest[0]);
            now.rate = compensated(before.rate, change[1], &mut rest[1]);
            t = if h < longest || duration_s - t <= 1.5 * longest { duration_s } else { t + h };
            fastest = fastest.max(now.rate.abs());
            let turns = |at: Swing| ((at.angle - level) / std::f64::consts::PI).floor();
            if turns(before) != turns(now) {
                let at = level + turns(before).max(turns(now)) * std::f64::consts::PI;
                n_level += 1;
                // by the energy; a rounding below zero is zero
                slowest_level = slowest_level.min((2.0 * (self.energy(start) - self.kappa * at.sin())).max(0.0).sqrt());
            }
            seen.push(columns);
        }
        let pace = fastest + self.kappa.sqrt();
        let growth = seen.iter().map(|from| norm(&product(&columns, &inverse(from)), pace)).fold(0.0, f64::max);
        Course { end: now, fastest, slowest_level, n_level, growth, pace }
    }

    /// Change of the state in a step, and the columns after it.
    fn step(&self, now: &mut Swing, columns: &mut [[f64; 2]; 2], h: f64) -> [f64; 2] {
        let mut phi = [0.0; ORDER + 1];
        let (mut w, mut s, mut c) = (phi, phi, phi);
        (phi[0], w[0], s[0], c[0]) = (now.angle, now.rate, now.angle.sin(), now.angle.cos());
        let mut along = [[[0.0; ORDER + 1]; 2]; 2];
        for (along, column) in along.iter_mut().zip(&*columns) {
            (along[0][0], along[1][0]) = (column[0], column[1]);
        }
        for k in 0..ORDER {
            let over = 1.0 / (k + 1) as f64;
            let product = |a: &[f64], b: &[f64]| (0..=k).map(|i| a[i] * b[k - i]).sum::<f64>();
            phi[k + 1] = over * w[k];
            let (next_s, next_c) = (over * product(&c, &w), -over * product(&s, &w));
            w[k + 1] = -over * self.kappa * c[k];
            for [of_phi, of_w] in &mut along {
                of_phi[k + 1] = over * of_w[k];
                of_w[k + 1] = over * self.kappa * product(&s, of_phi);
            }
            (s[k + 1], c[k + 1]) = (next_s, next_c);
        }
        let sum = |of: &[f64]| of[1..].iter().rev().fold(0.0, |sum, x| (sum + x) * h);
        for (column, along) in columns.iter_mut().zip(&along) {
            for (x, of) in column.iter_mut().zip(along) {
                *x += sum(of);
            }
        }
        [sum(&phi), sum(&w)]
    }
}

/// `x + by`, with what rounding cuts off in `rest`.
fn compensated(x: f64, by: f64, rest: &mut f64) -> f64 {
    let by = by + *rest;
    let sum = x + by;
    *rest = (x - sum) + by;
    sum
}

/// Columns of the product of two matrices, each given by its columns.
fn product(a: &[[f64; 2]; 2], b: &[[f64; 2]; 2]) -> [[f64; 2]; 2] {
    b.map(|b| [a[0][0] * b[0] + a[1][0] * b[1], a[0][1] * b[0] + a[1][1] * b[1]])
}

/// Of a matrix with determinant 1, as no pendulum without friction changes it.
fn inverse(a: &[[f64; 2]; 2]) -> [[f64; 2]; 2] {
    [[a[1][1], -a[0][1]], [-a[1][0], a[0][0]]]
}

/// Largest sum of a row for (δφ, δw/Ω).
fn norm(columns: &[[f64; 2]; 2], pace: f64) -> f64 {
    let of_phi = columns[0][0].abs() + pace * columns[1][0].abs();
    let of_w = columns[0][1].abs() / pace + columns[1][1].abs();
    of_phi.max(of_w)
}
