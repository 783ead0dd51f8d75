//! Straight running: whether a small angle of the bar grows, over speed and position of the bar.

use std::sync::atomic::AtomicBool;

use ezy_core::integrate::Method;
use ezy_core::model::Scene;
use ezy_core::simulate::Simulation;
use ezy_study::report::figure::Figure;
use ezy_study::report::page::Page;
use ezy_study::report::table::{Table, fixed};

use super::error::StudyError;
use super::motion::Motion;
use super::output::{Output, Plate};
use crate::ezy_roller::Coast;

/// Largest speed of the figure, m/s.
const FASTEST: f64 = 3.0;
/// Speeds on each side of the figure.
const N_SPEEDS: usize = 31;
/// Angle of the bar from which the growth is measured, rad: its square is the error.
const SMALL_ANGLE: f64 = 1e-8;
/// Of that run: what it leaves of the angle is a hundred-thousandth.
const TOLERANCE: f64 = 1e-13;
/// When the growth is measured, s: the fading mode is a hundred-thousandth of the other one by then, and the angle still below 0.01 rad.
const MEASURED_S: [f64; 2] = [2.2, 2.4];

/// Where the bar stands while the EzyRoller runs straight.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Bar {
    /// Ahead of the seat: the front wheel leads.
    Ahead,
    /// Folded back beneath the seat: the front wheel trails.
    Folded,
}

/// The eigenvalues of the angle between seat and bar about straight running, 1/s, the larger one first; a pair as its real part twice,
/// which these never are. They are proportional to `speed`, m/s, which is below zero backwards.
///
/// With L = a + b ± (c + d), p = ±(c + d), q = a + b, J₁ = m₁ a² + i₁ and J₂ = m₂ c² + i₂, + for a bar that is ahead, the skates and the hinge leave
/// L ψ₁' = v β − p β' of the heading of the seat and L ψ₂' = v β + q β' of the bar, and the work of their inertial forces along β' vanishes:
///
/// (J₁ p² + J₂ q²) β'' + v (m₁ a p² − J₁ p + J₂ q ∓ m₂ c q²) β' − v² (m₁ a p ± m₂ c q) β = 0.
pub fn eigenvalues(roller: &Coast, bar: Bar, speed: f64) -> [f64; 2] {
    let Coast { a, b, c, d, m1, i1, m2, i2, .. } = *roller;
    let side = if bar == Bar::Ahead { 1.0 } else { -1.0 };
    let (c, d) = (side * c, side * d);
    let (p, q) = (c + d, a + b);
    let (j1, j2) = (m1 * a * a + i1, m2 * c * c + i2);
    let inertia = j1 * p * p + j2 * q * q;
    let damping = m1 * a * p * p - j1 * p + j2 * q - m2 * c * q * q;
    let stiffness = -(m1 * a * p + m2 * c * q);
    let half = -0.5 * damping / inertia;
    let root = (half * half - stiffness / inertia).max(0.0).sqrt();
    let of = [half + root, half - root].map(|s| s * speed);
    [of[0].max(of[1]), of[0].min(of[1])]
}

/// What the part found.
pub struct Straight {
    /// How fast a small angle grows ahead at 1 m/s, 1/s: by a run.
    pub measured: f64,
    /// The same, by the eigenvalue.
    pub expected: f64,
}

impl Straight {
    /// Measures the growth, and puts figure and numbers on the page.
    pub fn study(page: &mut Page, output: &Output, interrupt: &AtomicBool) -> Result<Self, StudyError> {
        let scene = Coast::default();
        let found = Self { measured: growth(&scene, interrupt)?, expected: eigenvalues(&scene, Bar::Ahead, 1.0)[0] };
        page.section("straight", "Straight on: does it stay?");
        page.paragraph(
            "With the bar in line with the seat the EzyRoller runs straight on at any speed, forwards or backwards, with the bar ahead or folded back. A small \
             angle of the bar is a sum of two modes exp(s t), and both eigenvalues s are proportional to the speed.",
        );
        page.html(&table(&scene).html("Eigenvalues of straight running at 1 m/s"));
        output.plate(page, plate(&scene))?;
        page.paragraph(&format!(
            "Forwards it is stable with the bar folded back, as a caster is, and with the bar ahead it folds: at 1 m/s a small angle doubles within {:.2} s. Backwards \
             it is the other way round for the folded bar, and with the bar ahead it is unstable too. In a run from {SMALL_ANGLE:e} rad the angle grows by {:.4} 1/s, where the \
             eigenvalue says {:.4}. Built with the feature analysis, ezy linearize ezyroller/coast --start bar.phi=0 finds them from the model file.",
            std::f64::consts::LN_2 / found.expected,
            found.measured,
            found.expected,
        ));
        Ok(found)
    }
}

/// How fast the logarithm of the angle grows in a run at 1 m/s, 1/s.
fn growth(scene: &dyn Scene, interrupt: &AtomicBool) -> Result<f64, StudyError> {
    let [first, last] = MEASURED_S;
    let simulation = Simulation::new(scene).start("bar.phi", SMALL_ANGLE).method(Method::dop853(TOLERANCE));
    let simulation = simulation.until(last).every(last - first).interrupted_by(interrupt);
    let motion = Motion::finished(scene, simulation.run()?)?;
    let angle = motion.seat_less_bar("phi")?;
    let n = angle.len();
    Ok((angle[n - 1] / angle[n - 2]).abs().ln() / (last - first))
}

fn table(scene: &Coast) -> Table {
    let mut table = Table::new(["bar", "runs", "s1 [1/s]", "s2 [1/s]", "stability"]);
    for (bar, word) in [(Bar::Ahead, "ahead"), (Bar::Folded, "folded back")] {
        for (speed, runs) in [(1.0, "forwards"), (-1.0, "backwards")] {
            let s = eigenvalues(scene, bar, speed);
            let verdict = if s[0] < 0.0 { "stable" } else { "unstable" };
            table.push([word, runs, &fixed(s[0], 6), &fixed(s[1], 6), verdict]);
        }
    }
    table
}

fn plate<'a>(scene: &Coast) -> Plate<'a> {
    let n = N_SPEEDS as i32 - 1;
    let speeds: Vec<f64> = (-n..=n).map(|i| FASTEST * f64::from(i) / f64::from(n)).collect();
    // in proportion to the speed
    let of = |bar: Bar| eigenvalues(scene, bar, 1.0).map(|s| speeds.iter().map(|v| s * v).collect::<Vec<f64>>());
    let [ahead, folded] = [Bar::Ahead, Bar::Folded].map(of);
    let ends = vec![-FASTEST, FASTEST];
    // both in one look, with a gap between
    let twice = [&speeds[..], &[f64::NAN], &speeds].concat();
    let both = |of: &[Vec<f64>; 2]| [&of[0][..], &[f64::NAN], &of[1]].concat();
    let figure =
        Figure::plane("Eigenvalues of straight running", "speed [m/s], below zero backwards", "eigenvalue [1/s]")
            .guide("", ends, vec![0.0, 0.0])
            .line("bar ahead", twice.clone(), both(&ahead))
            .line("bar folded back", twice, both(&folded));
    let [[ahead_1, ahead_2], [folded_1, folded_2]] = [ahead, folded];
    Plate {
        name: "straight_eigenvalues",
        figure,
        columns: vec![
            ("speed [m/s]", speeds),
            ("ahead, first [1/s]", ahead_1),
            ("ahead, second [1/s]", ahead_2),
            ("folded, first [1/s]", folded_1),
            ("folded, second [1/s]", folded_2),
        ],
        caption: "Both eigenvalues of the angle between seat and bar over the speed. Above the dotted line a small angle grows. The flat line is that of both bars."
            .to_owned(),
        alternative: "Straight lines through the origin. To the right, forwards, both of the folded bar fall below zero; with the bar ahead one rises steeply."
            .to_owned(),
    }
}
