//! Energies, powers, and what else a scene says of its state.

use super::tolerances::geometry::TOLERANCE;
use super::{MotionError, System, max_abs};
use crate::model::{Derived as _, Equations as _, Scene as _, SceneRef, StickSlipInfo, StopInfo};

impl<P: SceneRef> System<P> {
    /// Work of the largest multiplier over the tolerance of positions, J: a body that is held gains or loses as much by rounding.
    /// Test: `monitors.rs`, a plate that cannot move.
    pub(crate) fn work_of_rounding(&self, multipliers: &[f64]) -> f64 {
        TOLERANCE * self.geometry.length * max_abs(multipliers)
    }

    /// ½ vᵀ M v, J.
    pub fn kinetic_energy(&self, v: &[f64]) -> f64 {
        0.5 * self.mass.iter().zip(v).map(|(m, v)| m * v * v).sum::<f64>()
    }

    /// Potential energy, J; zero where no force has a potential.
    pub fn potential_energy(&self, t: f64, q: &[f64]) -> f64 {
        self.scene.potential_energy(&self.fixed, t, q)
    }

    /// Power of each effect, W; `lambda` are the multipliers at this state. Writes `n_e`, or nothing into an empty
    /// `out`, which costs nothing.
    #[inline]
    pub fn power(&self, t: f64, q: &[f64], v: &[f64], lambda: &[f64], out: &mut [f64]) {
        if !out.is_empty() {
            self.scene.power(&self.fixed, t, q, v, lambda, out);
        }
    }

    /// Values of the events of the scene; writes `n_s`.
    pub(crate) fn events(&self, t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        self.scene.events(&self.fixed, t, q, v, out);
    }

    /// What the skate with a limit holds up to, N, and the velocity across it, m/s.
    pub(crate) fn stick_slip(&self, t: f64, q: &[f64], v: &[f64]) -> [f64; 2] {
        let mut stick_slip = [0.0; 2];
        self.scene.stick_slip(&self.fixed, t, q, v, &mut stick_slip);
        stick_slip
    }

    /// The same where the skate can hold or slide.
    ///
    /// # Errors
    /// [`MotionError::SkateLimit`].
    pub(crate) fn checked_stick_slip(
        &self,
        info: &StickSlipInfo,
        t: f64,
        q: &[f64],
        v: &[f64],
    ) -> Result<[f64; 2], MotionError> {
        let [limit, velocity] = self.stick_slip(t, q, v);
        if limit > 0.0 {
            Ok([limit, velocity])
        } else {
            Err(MotionError::SkateLimit { t, skate: info.name, value: limit })
        }
    }

    /// Distances to the ends of the stop with their rates, and the restitution; writes what `Derived::stop` does.
    pub(crate) fn stop(&self, t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        self.scene.stop(&self.fixed, t, q, v, out);
    }

    /// The same where the distances are numbers.
    ///
    /// # Errors
    /// [`MotionError::StopNotFinite`].
    pub(crate) fn checked_stop(
        &self,
        info: &StopInfo,
        t: f64,
        q: &[f64],
        v: &[f64],
        out: &mut [f64],
    ) -> Result<(), MotionError> {
        self.stop(t, q, v, out);
        for (end, &value) in out.iter().step_by(2).take(info.hits.len()).enumerate() {
            if !value.is_finite() {
                return Err(MotionError::StopNotFinite {
                    t,
                    stop: info.name,
                    end: info.end(end),
                    what: "distance",
                    value,
                });
            }
        }
        Ok(())
    }

    /// Outputs of the scene; writes `n_o`.
    pub fn outputs(&self, t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        self.scene.outputs(&self.fixed, t, q, v, out);
    }
}
