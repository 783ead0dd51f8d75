//! Long runs: does the speed have a limit?

use ezy_study::report::figure::Figure;
use ezy_study::report::page::Page;
use ezy_study::report::table::Table;

use super::averaged::{Averaged, MEAN_POWER};
use super::error::StudyError;
use super::motion::Motion;
use super::output::{Output, Plate};
use super::parts::{half_swing, largest};
use crate::ezy_roller::{Driven, DrivenOnTarmac};
use std::sync::atomic::AtomicBool;

/// Ten minutes, with a step that leaves the energy balance at rounding.
const TEN_MINUTES_S: f64 = 600.0;
const FINE_STEP_S: f64 = 2.5e-3;
/// A hundred minutes, eighty steps to a period of the torque.
const LONG_S: f64 = 6000.0;
const LONG_STEP_S: f64 = 0.025;
const EVERY_S: f64 = 0.05;
/// Samples in one period of the torque, 2 s.
const SAMPLES_A_PERIOD: usize = 40;
/// Ends of the stretches over which the growth of the kinetic energy is measured, s.
const STRETCHES_S: [f64; 10] = [1.0, 3.0, 10.0, 30.0, 60.0, 120.0, 300.0, 600.0, 2000.0, 6000.0];
/// Times at which the table of speeds has a row, s.
const TIMES_S: [f64; 5] = [60.0, 120.0, 600.0, 2000.0, 6000.0];

/// The state of the long run near one time.
#[derive(Debug, Clone, Copy)]
pub struct Instant {
    /// Time, s.
    pub t: f64,
    /// Forward speed, m/s.
    pub speed: f64,
    /// Kinetic energy, J.
    pub energy: f64,
    /// Half of the hinge's swing over the period before, rad.
    pub swing: f64,
}

/// What the long runs found.
pub struct Growth {
    /// Forward speed after ten minutes, m/s.
    pub speed: f64,
    /// Kinetic energy after ten minutes, J.
    pub energy: f64,
    /// Largest |kinetic energy − work| within ten minutes, J.
    pub balance: f64,
    /// d ln(kinetic energy) / d ln t over each stretch: from, to, exponent.
    pub exponents: Vec<(f64, f64, f64)>,
    /// Speed, energy and swing of the long run.
    pub instants: Vec<Instant>,
    /// lim v⁵/t by the averaged equation, m⁵/s⁶.
    pub limit: f64,
    /// Times and speeds by the averaged equation.
    averaged: (Vec<f64>, Vec<f64>),
    /// Times and speeds of the long run, at full periods.
    long: (Vec<f64>, Vec<f64>),
    /// Mean speed over the last period with rolling resistance, after five and after ten minutes, m/s.
    pub resisted: [f64; 2],
}

impl Growth {
    /// Runs for ten and for a hundred minutes, and with rolling resistance for ten.
    pub fn measure(scene: &Driven, interrupt: &AtomicBool) -> Result<Self, StudyError> {
        let fine = Motion::new(scene, FINE_STEP_S, TEN_MINUTES_S, EVERY_S, interrupt)?;
        let long = Motion::new(scene, LONG_STEP_S, LONG_S, EVERY_S, interrupt)?;
        let (t, v, energy) = (long.column("t")?, long.forward_speed()?, long.column("kinetic")?);
        let hinge = long.seat_less_bar("phi")?;
        let index = |time: f64| (time / EVERY_S).round() as usize;
        let instant = |time: f64| {
            let i = index(time);
            Instant { t: time, speed: v[i], energy: energy[i], swing: half_swing(&hinge[i - SAMPLES_A_PERIOD..=i]) }
        };
        let exponent = |pair: &[f64]| {
            let [from, to] = [pair[0], pair[1]];
            (from, to, (energy[index(to)] / energy[index(from)]).ln() / (to / from).ln())
        };
        let law = Averaged::of(scene)?;
        let start = instant(TIMES_S[0]);
        let tarmac = DrivenOnTarmac::default();
        let resisted = Motion::new(&tarmac, LONG_STEP_S, TEN_MINUTES_S, EVERY_S, interrupt)?.forward_speed()?;
        let last_period = |time: f64| mean(&resisted[index(time) - SAMPLES_A_PERIOD..index(time)]);
        Ok(Self {
            speed: fine.forward_speed()?.last().copied().unwrap_or(f64::NAN),
            energy: fine.run.last().energy.kinetic,
            balance: largest(fine.run.samples().map(|s| s.energy.balance)),
            exponents: STRETCHES_S.windows(2).map(exponent).collect(),
            instants: TIMES_S.map(instant).to_vec(),
            limit: law.limit(),
            averaged: law.integrate(start.t, start.speed),
            long: (SAMPLES_A_PERIOD..t.len()).step_by(SAMPLES_A_PERIOD).map(|i| (t[i], v[i])).unzip(),
            resisted: [last_period(0.5 * TEN_MINUTES_S), last_period(TEN_MINUTES_S)],
        })
    }

    /// v⁵/t by the averaged equation at its latest time: time, value.
    pub fn latest_ratio(&self) -> (f64, f64) {
        let (t, v) = &self.averaged;
        t.last().zip(v.last()).map_or((f64::NAN, f64::NAN), |(t, v)| (*t, v.powi(5) / t))
    }

    /// Puts figure and tables on the page.
    pub fn write(&self, page: &mut Page, output: &Output) -> Result<(), StudyError> {
        page.section("long", "Long runs: the speed has no limit");
        page.paragraph(&format!(
            "After 600 s the roller moves at {:.4} m/s with {:.3} J, and is still gaining. Kinetic energy and work differ by {:.0e} J at \
             most on the way: nothing is lost, so nothing can balance the work of the torque. The gain only slows down, because a faster \
             roller is steered back harder and its hinge swings less under the same torque.",
            self.speed, self.energy, self.balance
        ));
        let (t_end, ratio) = self.latest_ratio();
        let (t, v) = &self.long;
        let (t_averaged, v_averaged) = &self.averaged;
        let guide_t = vec![t_averaged[0], t_end];
        let guide_v = guide_t.iter().map(|t| (self.limit * t).powf(0.2)).collect();
        let figure = Figure::log_log("Speed in long runs", "time [s]", "forward speed [m/s]")
            .line("full equations", t.clone(), v.clone())
            .line("averaged equation", t_averaged.clone(), v_averaged.clone())
            .guide("limit law, slope 1/5", guide_t, guide_v);
        output.plate(page, Plate {
            name: "long_run",
            figure,
            columns: vec![
                ("t [s]", t.clone()),
                ("forward speed [m/s]", v.clone()),
                ("t of the averaged equation [s]", t_averaged.clone()),
                ("speed by the averaged equation [m/s]", v_averaged.clone()),
            ],
            caption: "Speed of the driven roller by the full equations and by the averaged equation, which starts from them at 60 s.".to_owned(),
            alternative: "The speed keeps growing; the averaged equation continues the full one and bends towards slope one fifth.".to_owned(),
        })?;
        page.paragraph(
            "The averaged equation follows from linearising about the straight, folded configuration at speed v: the mean power P(v) of \
             the torque over a period, with (m₁ + m₂) v dv/dt = P(v). P is positive at every speed and falls like K/v³, so in the end v grows \
             like the fifth root of 5 K t/(m₁ + m₂).",
        );
        page.equation(MEAN_POWER);
        page.paragraph(
            "Here A = J₁ l + J₂ L²/l, B = J₁ + m₁ a l + (L/l)(J₂ + m₂ c L) and D = m₁ a + m₂ c L/l with the moments of inertia about the wheels \
             J₁ = I₁ + m₁ a² and J₂ = I₂ + m₂ c², and K = lim v³ P(v) = (M₀²/2) ((L − l)²/l) B ω²/D².",
        );
        page.html(&self.speed_table().html("Speed and swing of the hinge in the long run"));
        page.html(&self.exponent_table().html("Growth of the kinetic energy: 2 is quadratic, 1 linear, 0.4 the limit law; an exponential would make the exponent grow with time"));
        page.paragraph(&format!(
            "v⁵/t tends to 5 K/(m₁ + m₂) = {:.4} m⁵/s⁶ by the averaged equation, very slowly: it is {ratio:.4} at {t_end:.0e} s. A bounded speed takes dissipation: with the \
             rolling resistance of the scene driven_on_tarmac the mean speed is {:.4} m/s after 300 s and {:.4} m/s after 600 s.",
            self.limit, self.resisted[0], self.resisted[1]
        ));
        Ok(())
    }

    fn speed_table(&self) -> Table {
        let mut table = Table::new([
            "time [s]",
            "speed [m/s]",
            "kinetic energy [J]",
            "half swing of the hinge [rad]",
            "v⁵/t [m⁵/s⁶]",
        ]);
        for at in &self.instants {
            let ratio = at.speed.powi(5) / at.t;
            table.push([
                format!("{}", at.t),
                format!("{:.4}", at.speed),
                format!("{:.3}", at.energy),
                format!("{:.4}", at.swing),
                format!("{ratio:.4}"),
            ]);
        }
        table
    }

    fn exponent_table(&self) -> Table {
        let mut table = Table::new(["from [s]", "to [s]", "d ln(kinetic energy) / d ln(time)"]);
        for (from, to, exponent) in &self.exponents {
            table.push([from.to_string(), to.to_string(), format!("{exponent:.2}")]);
        }
        table
    }
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}
