//! Part (j) and the order of the method: the same scenes with smaller and smaller steps.

use ezy_core::dynamics::{Projection, State, System};
use ezy_core::integrate::Method;
use ezy_core::linalg::Backend;
use ezy_core::model::Scene;
use ezy_core::record::coordinate_index;
use ezy_core::simulate::Simulation;
use ezy_study::report::figure::Figure;
use ezy_study::report::page::Page;
use ezy_study::report::table::Table;

use super::driven::Drive;
use super::error::StudyError;
use super::motion::Motion;
use super::output::{Output, Plate};
use super::parts::{geometric, largest, log_slope};
use crate::ezy_roller::{Coast, Driven};
use std::sync::atomic::AtomicBool;

/// Steps, s: halved from 0.04.
const LARGEST_STEP_S: f64 = 0.04;
const N_STEPS: usize = 6;
/// The step of the report, s.
pub const REPORT_STEP_S: f64 = 1e-4;

/// What the runs with smaller and smaller steps found.
pub struct Steps {
    /// Steps, s.
    pub steps: Vec<f64>,
    /// |kinetic energy − work| at the end with work summed as in the report, J.
    pub sum_gap: Vec<f64>,
    /// The same with work integrated as a state, J.
    pub state_gap: Vec<f64>,
    /// Largest difference of the end coordinates to those of half the step: driven, coasting.
    pub differences: [Vec<f64>; 2],
    /// Largest |C| of the driven run without any projection, per step, m.
    pub drift: Vec<f64>,
    /// |kinetic energy − summed work| at the end with the step of the report, J.
    pub sum_gap_at_report_step: f64,
    /// Time and summed work of the run with the largest step.
    coarse_sum: (Vec<f64>, Vec<f64>),
}

impl Steps {
    /// Runs both scenes with every step.
    pub fn measure(driven: &Driven, interrupt: &AtomicBool) -> Result<Self, StudyError> {
        let steps = geometric(LARGEST_STEP_S, 0.5, N_STEPS);
        let coast = Coast::default();
        let (mut sum_gap, mut state_gap, mut drift) = (Vec::new(), Vec::new(), Vec::new());
        let (mut driven_ends, mut coast_ends) = (Vec::new(), Vec::new());
        let mut coarse_sum = None;
        for &h in &steps {
            let motion = Motion::new(driven, h, driven.info().until_s, h, interrupt)?;
            let last = motion.run.last();
            let sum = right_endpoint_sum(&motion)?;
            sum_gap.push((last.energy.kinetic - sum.last().copied().unwrap_or(f64::NAN)).abs());
            state_gap.push((last.energy.kinetic - last.energy.work).abs());
            driven_ends.push(last.coordinates.to_vec());
            coarse_sum.get_or_insert((motion.column("t")?, sum));
            let until = coast.info().until_s;
            coast_ends.push(Motion::new(&coast, h, until, until, interrupt)?.run.last().coordinates.to_vec());
            let free = Simulation::new(driven as &dyn Scene).method(Method::rk4(h));
            let free = free.project(Projection::None).every(1.0).run()?;
            let free = Motion::finished(driven, free)?;
            drift.push(largest(free.run.samples().map(|s| s.position_residual)));
        }
        let differences =
            [driven_ends, coast_ends].map(|ends| ends.windows(2).map(|pair| distance(&pair[0], &pair[1])).collect());
        let coarse_sum = coarse_sum.unwrap_or_default();
        let sum_gap_at_report_step = right_endpoint_gap(driven, REPORT_STEP_S)?;
        Ok(Self { steps, sum_gap, state_gap, differences, drift, sum_gap_at_report_step, coarse_sum })
    }

    /// Measured orders of the method: driven, coasting.
    pub fn orders(&self) -> [f64; 2] {
        self.differences.each_ref().map(|d| log_slope(&self.steps[..d.len()], d))
    }

    /// Order of the summed work in the step.
    pub fn sum_order(&self) -> f64 {
        log_slope(&self.steps, &self.sum_gap)
    }

    /// Part (j).
    pub fn write_work(&self, page: &mut Page, output: &Output, drive: &Drive) -> Result<(), StudyError> {
        page.section("j", "(j) Driven: work and kinetic energy");
        page.paragraph(&format!(
            "The work of the torque is integrated together with the motion, as one more state with the power as its rate. It then agrees \
             with the kinetic energy to {:.0e} J all the way. The report sums torque at the end of a step times the turn within the step; \
             that sum is a quadrature rule of first order, and its gap is its own: it is proportional to the step.",
            drive.energy_gap
        ));
        let motion = &drive.motion;
        let (t, kinetic, work) = (motion.column("t")?, motion.column("kinetic")?, motion.column("work")?);
        let (t_sum, sum) = self.coarse_sum.clone();
        let figure = Figure::time_series("Work and kinetic energy", "time [s]", "energy [J]")
            .band("kinetic energy", t.clone(), kinetic.clone())
            .line("work, as a state", t.clone(), work.clone())
            .line(&format!("right-endpoint sum, h = {} s", self.steps[0]), t_sum.clone(), sum.clone());
        output.plate(page, Plate {
            name: "driven_work",
            figure,
            columns: vec![
                ("t [s]", t),
                ("kinetic energy [J]", kinetic),
                ("work [J]", work),
                ("t of the sum [s]", t_sum),
                ("right-endpoint sum [J]", sum),
            ],
            caption: "Kinetic energy and work of the torque (one line on the other), and the sum of the report with a large step, so that its gap can be seen.".to_owned(),
            alternative: "Kinetic energy and work coincide; the right-endpoint sum falls behind by about one joule in one minute.".to_owned(),
        })?;
        let law =
            |order: i32, gap: f64| self.steps.iter().map(|h| 0.3 * gap * (h / self.steps[0]).powi(order)).collect();
        let (guide, fourth): (Vec<f64>, Vec<f64>) = (law(1, self.sum_gap[0]), law(4, self.state_gap[0]));
        let figure = Figure::log_log("Gap between kinetic energy and work at 60 s", "step h [s]", "gap [J]")
            .points("right-endpoint sum", self.steps.clone(), self.sum_gap.clone())
            .points("work as a state", self.steps.clone(), self.state_gap.clone())
            .guide("slopes 1 and 4", self.steps.clone(), guide)
            .guide("slopes 1 and 4", self.steps.clone(), fourth);
        output.plate(page, Plate {
            name: "work_gap",
            figure,
            columns: vec![
                ("h [s]", self.steps.clone()),
                ("gap of the right-endpoint sum [J]", self.sum_gap.clone()),
                ("gap of work as a state [J]", self.state_gap.clone()),
            ],
            caption: format!(
                "The gap of the right-endpoint sum is of order {:.3} in the step; at the report's step of 1e-4 s it is {:.3e} J. \
                 That of the state falls with the order of the method until rounding.",
                self.sum_order(),
                self.sum_gap_at_report_step
            ),
            alternative: "The gap of the right-endpoint sum falls along slope one from one joule; that of the state falls along slope four to 1e-12 J.".to_owned(),
        })
    }

    /// The order of the method.
    pub fn write_order(&self, page: &mut Page, output: &Output) -> Result<(), StudyError> {
        let [driven, coast] = &self.differences;
        let [driven_order, coast_order] = self.orders();
        let h = &self.steps[..driven.len()];
        page.section("accuracy", "How accurate the numbers are");
        page.paragraph(
            "Each run is repeated with half the step, and the end coordinates are compared. The difference estimates the error of the \
             larger step (to 1/16 of it, since the order is 4).",
        );
        let guide: Vec<f64> = h.iter().map(|h| 0.2 * driven[0] * (h / self.steps[0]).powi(4)).collect();
        let figure = Figure::log_log("Order of the method", "step h [s]", "difference of the end coordinates [m, rad]")
            .points("driven, 60 s", h.to_vec(), driven.clone())
            .points("coasting, 1 s", h.to_vec(), coast.clone())
            .guide("slope 4", h.to_vec(), guide);
        output.plate(
            page,
            Plate {
                name: "order",
                figure,
                columns: vec![
                    ("h [s]", h.to_vec()),
                    ("driven: difference to h/2", driven.clone()),
                    ("coasting: difference to h/2", coast.clone()),
                ],
                caption: format!("Fourth order: measured {driven_order:.3} (driven) and {coast_order:.3} (coasting)."),
                alternative: "Both curves fall along slope four.".to_owned(),
            },
        )?;
        let mut table = Table::new([
            "step [s]",
            "driven: difference to half the step",
            "ratio",
            "largest |C| without projection [m]",
        ]);
        for i in 0..driven.len() {
            let ratio = driven.get(i + 1).map_or(String::new(), |next| format!("{:.2}", driven[i] / next));
            table.push([format!("{}", h[i]), format!("{:.2e}", driven[i]), ratio, format!("{:.1e}", self.drift[i])]);
        }
        page.html(
            &table.html("Driven run with half the step each time; a method of order four divides the difference by 16"),
        );
        Ok(())
    }
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    largest(a.iter().zip(b).map(|(a, b)| a - b))
}

/// Torque at the end of each step times the relative turn within it, summed as in the listing of the report.
fn right_endpoint_sum(motion: &Motion<'_>) -> Result<Vec<f64>, StudyError> {
    let (torque, turn) = (motion.force("seat.phi")?, motion.seat_less_bar("phi")?);
    let mut sum = 0.0;
    let mut sums = vec![0.0];
    for j in 1..turn.len() {
        sum += torque[j] * (turn[j] - turn[j - 1]);
        sums.push(sum);
    }
    Ok(sums)
}

/// |kinetic energy − right-endpoint sum| at the end of a run that keeps nothing on its way, so that the step may be
/// small. Nothing is projected: the drift of one minute is far below the gap.
fn right_endpoint_gap(driven: &dyn Scene, step_s: f64) -> Result<f64, StudyError> {
    let info = driven.info();
    let (seat, bar) = (coordinate_index(&info, "seat.phi")?, coordinate_index(&info, "bar.phi")?);
    let fixed = System::new(driven, Backend::Auto)?.fixed().to_vec();
    let mut force = vec![0.0; info.n_coordinates()];
    let (mut turned, mut sum) = (None, 0.0);
    let mut add = |t: f64, q: &[f64], v: &[f64]| {
        let turn = q[seat] - q[bar];
        driven.applied_force(&fixed, t, q, v, &mut force);
        sum += turned.map_or(0.0, |turned| force[seat] * (turn - turned));
        turned = Some(turn);
        sum
    };
    // what is called at the start of each step sees the end of the one before
    let run = Simulation::new(driven)
        .method(Method::rk4(step_s))
        .project(Projection::None)
        .every(info.until_s)
        .control_by_index(|t, State { q, v, .. }, _| {
            add(t, q, v);
        })
        .run()?;
    let end = run.last();
    Ok((end.energy.kinetic - add(end.t, end.coordinates, end.velocities)).abs())
}
