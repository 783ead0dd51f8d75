//! Magnitude and phase over the frequency.

use super::spectrum::Spectrum;
use super::tolerances::transfer::{FAR, NARROW};
use super::transfer::Transfer;
use std::f64::consts::{PI, TAU};

/// G(iω) by magnitude and phase.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BodePoint {
    /// ω, rad/s.
    pub omega: f64,
    /// |G|, in the unit of the output over that of the input.
    pub magnitude: f64,
    /// arg G, rad, without jumps of a turn: from −π up to below π at the first frequency, and continuous from there on. At a pole or zero on the
    /// imaginary axis it jumps as with a little damping, by −π or π.
    pub phase: f64,
}

impl BodePoint {
    /// 20 lg |G|, dB.
    pub fn decibels(&self) -> f64 {
        20.0 * self.magnitude.log10()
    }
}

impl Transfer {
    /// Magnitude and phase at ascending frequencies, rad/s. Frequencies of poles are left out.
    ///
    /// The phase is followed by the angles under which poles and zeros see the way from one frequency to the next, so that it is right however
    /// far apart these are.
    ///
    /// # Cost
    /// O(n²) for each frequency.
    pub fn bode(&self, omegas: &[f64]) -> Vec<BodePoint> {
        let mut points: Vec<BodePoint> = Vec::with_capacity(omegas.len());
        for &omega in omegas {
            let Some(g) = self.at_frequency(omega) else { continue };
            let angle = g.arg();
            let phase = match points.last() {
                Some(last) => {
                    let expected = last.phase + self.turn([last.omega, omega]);
                    angle + TAU * ((expected - angle) / TAU).round()
                }
                // rounding does not choose between half a turn and its negative
                None if angle > PI - FAR => angle - TAU,
                None => angle,
            };
            points.push(BodePoint { omega, magnitude: g.norm(), phase });
        }
        points
    }

    /// By how much the phase turns between two frequencies.
    fn turn(&self, ends: [f64; 2]) -> f64 {
        let sum = |of: &Spectrum| -> f64 {
            let axis = of.rounding();
            let angle = |s: &nalgebra::Complex<f64>| match ends.map(|omega| omega - s.im) {
                [a, b] if s.re.abs() <= axis => {
                    if a < 0.0 && b > 0.0 {
                        PI
                    } else {
                        0.0
                    }
                }
                [a, b] => (b / -s.re).atan() - (a / -s.re).atan(),
            };
            of.eigenvalues.iter().map(angle).sum()
        };
        sum(&self.zeros) - sum(&self.poles)
    }

    /// Frequencies for a Bode plot, rad/s: `n` evenly spaced ones on a logarithmic axis from `first` to `last`, and more beside poles and zeros
    /// with little damping, whose peaks and notches would be missed.
    pub fn frequencies(&self, [first, last]: [f64; 2], n: usize) -> Vec<f64> {
        let steps = n.saturating_sub(1).max(1);
        let even = (0..=steps).map(|i| first * (last / first).powf(i as f64 / steps as f64));
        let narrow = [&self.poles, &self.zeros].into_iter().flat_map(|of| &of.eigenvalues);
        let beside = narrow.filter(|s| s.im > 0.0).flat_map(|s| {
            let width = s.re.abs().max(NARROW * s.im);
            // half the width apart in the middle, then farther and farther
            let away = (-1..=6).map(move |i| width * 2f64.powi(i));
            away.flat_map(|away| [s.im - away, s.im + away]).chain([s.im])
        });
        let mut all: Vec<f64> = even.chain(beside.filter(|omega| *omega > first && *omega < last)).collect();
        all.sort_by(f64::total_cmp);
        all.dedup();
        all
    }

    /// The frequencies around all poles and zeros that are not zero, as whole decades, rad/s; around 1 rad/s where there is none.
    pub fn span(&self) -> [f64; 2] {
        let sizes = || [&self.poles, &self.zeros].into_iter().flat_map(|of| &of.eigenvalues).map(|s| s.norm());
        let least = sizes().fold(f64::INFINITY, f64::min);
        let most = sizes().fold(0.0, f64::max);
        if !(least > 0.0 && most > 0.0 && least.is_finite()) {
            return [0.1, 10.0];
        }
        // at half a decade from the last pole its share of the phase is within 18° of what it will be
        let half = 10f64.sqrt();
        [10f64.powf((least / half).log10().floor()), 10f64.powf((most * half).log10().ceil())]
    }
}
