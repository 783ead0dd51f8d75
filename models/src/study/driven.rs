//! Parts (f) to (i): driven for one minute.

use std::f64::consts::PI;

use ezy_core::model::Scene;
use ezy_study::report::figure::Figure;
use ezy_study::report::page::Page;

use super::error::StudyError;
use super::motion::{Motion, Path};
use super::output::{Output, Plate};
use super::parts::largest;
use crate::ezy_roller::Driven;
use std::sync::atomic::AtomicBool;

const STEP_S: f64 = 1e-3;
const EVERY_S: f64 = 0.02;
/// How much of the paths the second figure shows, s.
const BEGINNING_S: f64 = 8.0;
/// The first and last stretch over which half periods are compared, s.
const STRETCH_S: f64 = 20.0;

/// What parts (f) to (i) found.
pub struct Drive {
    /// The samples.
    pub motion: Motion<'static>,
    /// Speed of the seat at the end, m/s.
    pub end_speed: f64,
    /// Kinetic energy at the end, J.
    pub end_energy: f64,
    /// Work at the end, J.
    pub end_work: f64,
    /// Largest |kinetic energy − work| on the way, J.
    pub energy_gap: f64,
    /// Largest constraint residuals on the way: positions, velocities.
    pub residuals: [f64; 2],
    /// Time between sign changes of the torque, s.
    pub torque_half_period: f64,
    /// Mean time between sign changes of the relative rate in the first and the last 20 s, s.
    pub half_periods: [f64; 2],
    /// Largest relative rate in the first and the last 20 s, rad/s.
    pub rate_swings: [f64; 2],
    /// Mean heading of the seat over the last period of the torque, rad: it begins at zero.
    pub turn: f64,
    /// Integral of torque times (bar rate − seat rate), J.
    pub work_of_opposite_rate: f64,
}

impl Drive {
    /// Runs for as long as the scene says.
    pub fn measure(scene: &'static Driven, interrupt: &AtomicBool) -> Result<Self, StudyError> {
        let motion = Motion::new(scene, STEP_S, scene.info().until_s, EVERY_S, interrupt)?;
        let (t, rate, torque) = (motion.column("t")?, motion.seat_less_bar("omega")?, motion.force("seat.phi")?);
        let last = motion.run.last();
        let (first_end, last_begin) = (STRETCH_S, scene.info().until_s - STRETCH_S);
        let early: Vec<usize> = (0..t.len()).filter(|i| t[*i] <= first_end).collect();
        let late: Vec<usize> = (0..t.len()).filter(|i| t[*i] >= last_begin).collect();
        let trapezoid = |i: usize| -0.5 * (torque[i] * rate[i] + torque[i - 1] * rate[i - 1]) * (t[i] - t[i - 1]);
        Ok(Self {
            end_speed: motion.speed()?.last().copied().unwrap_or(f64::NAN),
            end_energy: last.energy.kinetic,
            end_work: last.energy.work,
            energy_gap: largest(motion.run.samples().map(|s| s.energy.balance)),
            residuals: [
                largest(motion.run.samples().map(|s| s.position_residual)),
                largest(motion.run.samples().map(|s| s.velocity_residual)),
            ],
            turn: {
                let phi = motion.column("seat.phi")?;
                let n_period = (2.0 * PI / scene.omega / EVERY_S).round() as usize;
                phi[phi.len() - n_period..].iter().sum::<f64>() / n_period as f64
            },
            torque_half_period: PI / scene.omega,
            half_periods: [mean_half_period(&t, &rate, &early), mean_half_period(&t, &rate, &late)],
            rate_swings: [largest(early.iter().map(|i| rate[*i])), largest(late.iter().map(|i| rate[*i]))],
            work_of_opposite_rate: (1..t.len()).map(trapezoid).sum(),
            motion,
        })
    }

    /// Puts figures and numbers on the page.
    pub fn write(&self, page: &mut Page, output: &Output) -> Result<(), StudyError> {
        let (a, c, t) = (self.motion.path("A")?, self.motion.path("C")?, self.motion.column("t")?);
        page.section("f", "(f) Driven: paths of the wheels");
        page.paragraph(&format!(
            "From rest, with the bar folded back over the seat, a torque M₀ cos ωt acts on the seat and its reaction on the bar. \
             The roller first turns by {:.0} degrees. Then it moves along a line about which it sways.",
            self.turn.abs().to_degrees()
        ));
        output.plate(page, path_plate("driven_paths", "Driven for one minute", [&a, &c], &t, 10.0))?;
        let n = t.iter().filter(|t| **t <= BEGINNING_S).count();
        let beginning = |path: &Path| (path.0[..n].to_vec(), path.1[..n].to_vec());
        let (a, c) = (beginning(&a), beginning(&c));
        output.plate(page, path_plate("driven_paths_beginning", "The first eight seconds", [&a, &c], &t[..n], 2.0))?;

        let (speed, omega) = (self.motion.speed()?, self.motion.column("seat.omega")?);
        page.section("g", "(g) Driven: speed and angular velocity of body 1");
        let figure = Figure::time_series("Speed and angular velocity of the seat", "time [s]", "speed [m/s]")
            .line("speed of the centre of mass", t.clone(), speed.clone())
            .panel("angular velocity [rad/s]")
            .line("angular velocity", t.clone(), omega.clone());
        output.plate(page, Plate {
            name: "driven_speed",
            figure,
            columns: vec![("t [s]", t.clone()), ("speed [m/s]", speed), ("seat.omega [rad/s]", omega)],
            caption: format!("Speed and angular velocity of body 1 (the seat). At 60 s the speed is {:.6} m/s and still growing.", self.end_speed),
            alternative: "The speed grows from zero with a ripple; the angular velocity swings about zero, at first lopsidedly.".to_owned(),
        })?;

        let kinetic = self.motion.column("kinetic")?;
        page.section("h", "(h) Driven: kinetic energy");
        output.plate(
            page,
            Plate {
                name: "driven_energy",
                figure: Figure::time_series("Kinetic energy", "time [s]", "kinetic energy [J]").line(
                    "kinetic energy",
                    t.clone(),
                    kinetic.clone(),
                ),
                columns: vec![("t [s]", t.clone()), ("kinetic energy [J]", kinetic)],
                caption: format!(
                    "Kinetic energy of both bodies; {:.6} J at 60 s. The section on long runs shows how it continues.",
                    self.end_energy
                ),
                alternative:
                    "The kinetic energy grows, at first like the square of time, later about in proportion to time."
                        .to_owned(),
            },
        )?;

        let (torque, rate) = (self.motion.force("seat.phi")?, self.motion.seat_less_bar("omega")?);
        page.section("i", "(i) Driven: torque and relative angular velocity at B");
        let title = "Torque on the seat, and angular velocity of the seat relative to the bar";
        let figure = Figure::time_series(title, "time [s]", "torque [N·m]")
            .line("torque on the seat", t.clone(), torque.clone())
            .panel("angular velocity [rad/s]")
            .line("seat rate minus bar rate", t.clone(), rate.clone());
        output.plate(page, Plate {
            name: "driven_hinge",
            figure,
            columns: vec![("t [s]", t), ("torque on the seat [N*m]", torque), ("seat.omega - bar.omega [rad/s]", rate)],
            caption: "Torque on body 1 and the rate of body 1 relative to body 2: with these signs torque times rate is the power that drives.".to_owned(),
            alternative: "The torque swings evenly between plus and minus 2 N·m; the relative rate swings with it, less and less.".to_owned(),
        })?;
        page.paragraph(&format!(
            "The torque changes its sign every {:.3} s. The relative rate does so every {:.3} s on the average of the first {STRETCH_S:.0} s and \
             every {:.3} s on that of the last {STRETCH_S:.0} s. It follows the frequency of the torque; the small difference is its phase, which \
             slides against that of the torque while the speed grows, ever more slowly. Its largest value falls from {:.3} to {:.3} rad/s.",
            self.torque_half_period, self.half_periods[0], self.half_periods[1], self.rate_swings[0], self.rate_swings[1]
        ));
        Ok(())
    }
}

/// The paths of both wheels, with a mark on that of A every `mark_s` seconds.
fn path_plate<'a>(name: &'a str, title: &str, [a, c]: [&Path; 2], t: &[f64], mark_s: f64) -> Plate<'a> {
    let marked: Vec<usize> = (0..t.len()).step_by((mark_s / EVERY_S).round() as usize).collect();
    let at = |values: &[f64]| marked.iter().map(|i| values[*i]).collect();
    let figure = Figure::track(title)
        .line("rear wheel A", a.0.clone(), a.1.clone())
        .line("front wheel C", c.0.clone(), c.1.clone())
        .marks(&format!("A every {mark_s} s"), at(&a.0), at(&a.1));
    let figure = marked.iter().fold(figure, |figure, i| figure.note(a.0[*i], a.1[*i], &format!("{:.0} s", t[*i])));
    let columns = vec![
        ("t [s]", t.to_vec()),
        ("A.x [m]", a.0.clone()),
        ("A.y [m]", a.1.clone()),
        ("C.x [m]", c.0.clone()),
        ("C.y [m]", c.1.clone()),
    ];
    let end = t.last().copied().unwrap_or(f64::NAN);
    Plate {
        name,
        figure,
        columns,
        caption: format!(
            "Paths of the wheels A (body 1) and C (body 2) from 0 to {end:.0} s, with marks of time on that of A; equal axes."
        ),
        alternative: "Both wheels sway about a line that runs down to the right; the front wheel sways more."
            .to_owned(),
    }
}

/// Mean time between sign changes among the samples `which`, each change found by linear interpolation.
fn mean_half_period(t: &[f64], rate: &[f64], which: &[usize]) -> f64 {
    let crossing = |pair: &[usize]| {
        let (i, j) = (pair[0], pair[1]);
        (rate[i] * rate[j] < 0.0).then(|| t[i] + (t[j] - t[i]) * rate[i] / (rate[i] - rate[j]))
    };
    let crossings: Vec<f64> = which.windows(2).filter_map(crossing).collect();
    match (crossings.first(), crossings.last()) {
        (Some(first), Some(last)) if crossings.len() > 1 => (last - first) / (crossings.len() - 1) as f64,
        _ => f64::NAN,
    }
}
