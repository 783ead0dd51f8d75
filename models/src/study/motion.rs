//! A finished run together with its scene, so that points and forces can be read off it.

use ezy_core::integrate::Method;
use ezy_core::model::Scene;
use ezy_core::record::{Sample, coordinate_index, find_name};
use ezy_core::simulate::{Outcome, Run, Simulation};

use super::error::StudyError;
use std::sync::atomic::AtomicBool;

/// A run to its end.
pub struct Motion<'s> {
    scene: &'s dyn Scene,
    fixed: Vec<f64>,
    /// The samples.
    pub run: Run,
}

/// Abscissae and ordinates of a path.
pub type Path = (Vec<f64>, Vec<f64>);

impl<'s> Motion<'s> {
    /// Runs `scene` by RK4 with both projections, with a sample every `every_s`.
    pub fn new(
        scene: &'s dyn Scene,
        step_s: f64,
        until_s: f64,
        every_s: f64,
        interrupt: &AtomicBool,
    ) -> Result<Self, StudyError> {
        let simulation = Simulation::new(scene).method(Method::rk4(step_s)).until(until_s).every(every_s).work();
        Self::finished(scene, simulation.interrupted_by(interrupt).run()?)
    }

    /// Takes a run that was made elsewhere.
    pub fn finished(scene: &'s dyn Scene, run: Run) -> Result<Self, StudyError> {
        if matches!(run.outcome, Outcome::Interrupted { .. }) {
            return Err(StudyError::Interrupted { page: None });
        }
        if !run.outcome.reached_end() {
            return Err(StudyError::Stopped { scene: scene.info().name, outcome: run.outcome.to_string() });
        }
        let mut fixed = scene.info().declared_values();
        scene.constants(&scene.parameters(), &mut fixed);
        Ok(Self { scene, fixed, run })
    }

    /// A column of every sample.
    pub fn column(&self, name: &str) -> Result<Vec<f64>, StudyError> {
        Ok(self.run.column(name)?)
    }

    /// The path of a named point.
    pub fn path(&self, point: &str) -> Result<Path, StudyError> {
        let info = self.scene.info();
        let i = find_name("point", point, info.points.iter().map(|p| &*p.name))?;
        let mut places = vec![0.0; 2 * info.points.len()];
        let place = |sample: Sample<'_>| {
            self.scene.points(&self.fixed, sample.t, sample.coordinates, &mut places);
            (places[2 * i], places[2 * i + 1])
        };
        Ok(self.run.samples().map(place).unzip())
    }

    /// The applied force that belongs to a coordinate, N or N m.
    pub fn force(&self, coordinate: &str) -> Result<Vec<f64>, StudyError> {
        let i = coordinate_index(&self.scene.info(), coordinate)?;
        let mut force = vec![0.0; self.scene.info().n_coordinates()];
        let component = |sample: Sample<'_>| {
            self.scene.applied_force(&self.fixed, sample.t, sample.coordinates, sample.velocities, &mut force);
            force[i]
        };
        Ok(self.run.samples().map(component).collect())
    }

    /// Speed of the seat's centre of mass, m/s.
    pub fn speed(&self) -> Result<Vec<f64>, StudyError> {
        let (x, y) = (self.column("seat.vx")?, self.column("seat.vy")?);
        Ok(x.iter().zip(&y).map(|(x, y)| x.hypot(*y)).collect())
    }

    /// Speed of wheel A along the seat, m/s.
    pub fn forward_speed(&self) -> Result<Vec<f64>, StudyError> {
        let (x, y, phi) = (self.column("seat.vx")?, self.column("seat.vy")?, self.column("seat.phi")?);
        Ok((0..x.len()).map(|i| x[i] * phi[i].cos() + y[i] * phi[i].sin()).collect())
    }

    /// A column of the seat less the same column of the bar.
    pub fn seat_less_bar(&self, component: &str) -> Result<Vec<f64>, StudyError> {
        let (seat, bar) = (self.column(&format!("seat.{component}"))?, self.column(&format!("bar.{component}"))?);
        Ok(seat.iter().zip(&bar).map(|(seat, bar)| seat - bar).collect())
    }
}
