//! Errors in the report: claim, finding, measurement.

use ezy_study::report::page::Page;
use ezy_study::report::table::Table;

use super::error::StudyError;
use super::findings::Findings;
use super::parts::row;
use super::slips::slips;
use super::steps::REPORT_STEP_S;
use crate::ezy_roller::Driven;

/// Puts the list on the page.
pub fn write(page: &mut Page, found: &Findings<'_>, driven: &Driven) -> Result<(), StudyError> {
    page.section("claims", "Errors in the report");
    page.paragraph(
        "The report is \"Multibody Dynamics B, Assignment 8\" of 4 July 2019, in which this vehicle was studied first. Coordinates, constraints \
         and the scheme of integrating and projecting are taken over from it. Some of its printed formulas, parts of its listing and most of its \
         conclusions about energy are wrong. The table lists what changes a result or a conclusion; its last column is computed in this run.",
    );
    let mut table = Table::new(["part", "the report", "the equations", "measured here"]);
    for row in conclusions(found).into_iter().chain(method(found)).chain(slips(found, driven)?) {
        table.push(row);
    }
    page.html(&format!("<div class=\"claims\">{}</div>", table.html("Claims and findings")));
    page.paragraph(UNUSED);
    Ok(())
}

/// Slips that change no number.
const UNUSED: &str = "The table leaves out slips that change no number. The stages k₃ and k₄ are printed as f f(…). In the listing, S₁ has cos φ₂ in place of cos φ₁, but \
    S is never used. The function for the constraints never assigns its third output, that for the \
    projection of velocities is partly commented out, parameters and torque are repeated inside the functions, so that a change of the globals \
    has no effect on the motion, applied forces are computed and not used, and the number of steps is not rounded to an integer. \
    The coasting run is not in the listing.";

/// What was concluded from the figures.
fn conclusions(found: &Findings<'_>) -> Vec<[String; 4]> {
    let Findings { drive, steps, growth, .. } = found;
    let [(from_0, to_0, exponent_0), .., (from_1, to_1, exponent_1)] = growth.exponents[..] else { return Vec::new() };
    let (first, last) = (growth.instants[0], growth.instants[growth.instants.len() - 1]);
    vec![
        row(
            [
                "(j)",
                "work and kinetic energy differ because the integration accumulates errors; they never agree",
                "they agree to rounding once work is integrated as a state; the gap is the quadrature error of the right-endpoint sum",
            ],
            format!(
                "state: gap {:.0e} J at most; sum: {:.3e} J at h = {} s, order {:.3} in h; {:.3e} J at the report's h = {REPORT_STEP_S} s",
                drive.energy_gap,
                steps.sum_gap[steps.sum_gap.len() - 1],
                steps.steps[steps.steps.len() - 1],
                steps.sum_order(),
                steps.sum_gap_at_report_step
            ),
        ),
        row(
            [
                "(g), (h)",
                "the speed nears its maximum and the kinetic energy will level off",
                "nothing is lost in this model, so both grow without bound, ever more slowly",
            ],
            format!(
                "{:.4} m/s and {:.3} J at 600 s, {:.4} m/s and {:.2} J at {:.0} s",
                growth.speed, growth.energy, last.speed, last.energy, last.t
            ),
        ),
        row(
            [
                "(h)",
                "the kinetic energy has the shape of an exponential",
                "it is quadratic at first, then slower than linear",
            ],
            format!(
                "d ln(kinetic energy)/d ln t is {exponent_0:.2} from {from_0} to {to_0} s and {exponent_1:.2} from {from_1} to {to_1} s"
            ),
        ),
        row(
            [
                "(i)",
                "the relative rate changes its frequency and is damped while a transient dies out",
                "nothing damps; it follows the frequency of the torque while its phase slides, and it shrinks because the speed grows",
            ],
            format!(
                "half period of the torque {:.3} s, of the rate {:.3} s in the first and {:.3} s in the last 20 s; half swing of the hinge {:.4} rad at {:.3} m/s, {:.4} rad at {:.3} m/s; energy gap {:.0e} J",
                drive.torque_half_period,
                drive.half_periods[0],
                drive.half_periods[1],
                first.swing,
                first.speed,
                last.swing,
                last.speed,
                drive.energy_gap
            ),
        ),
        row(
            [
                "(i)",
                "the figure shows torque and bar rate minus seat rate",
                "torque times that rate is minus the power; seat rate minus bar rate drives",
            ],
            format!(
                "integral of torque times the plotted rate {:.4} J, work {:.4} J",
                drive.work_of_opposite_rate, drive.end_work
            ),
        ),
    ]
}

/// What is said about projection and about the clock.
fn method(found: &Findings<'_>) -> Vec<[String; 4]> {
    let Findings { projections, steps, drive, .. } = found;
    let n_report = (drive.motion.run.last().t / REPORT_STEP_S).round() as usize;
    let clock = (0..n_report).fold(0.0, |t, _| t + REPORT_STEP_S);
    let last = steps.drift.len() - 1;
    vec![
        row(
            [
                "(j)",
                "without projection the constraints would drift like the work",
                "in one minute they hardly drift at all",
            ],
            format!("largest |C| without any projection {:.0e} m at h = {} s", steps.drift[last], steps.steps[last]),
        ),
        row(
            [
                "(d)",
                "the position projection repeats its step up to ten times (listing: C is never re-evaluated)",
                "the violation is then overshot ninefold; the listing has it switched off",
            ],
            format!(
                "|C| after ten such passes is {:.2} times |C| before; re-evaluated, {:.0e} m after {} passes",
                projections.without_reevaluation, projections.euclidean.position_residual, projections.euclidean.passes
            ),
        ),
        row(
            [
                "(d)",
                "main loop: velocities are projected before the positions",
                "positions first, then velocities at the corrected positions",
            ],
            format!(
                "in this order |C| is {:.0e} m and the velocity residual {:.0e} m/s at most over the driven run",
                drive.residuals[0], drive.residuals[1]
            ),
        ),
        row(
            [
                "(f)",
                "time is counted by t = t + h",
                "the rounding of every addition stays in the clock; t = n h has none",
            ],
            format!("clock at the end off by {:.1e} s with h = {REPORT_STEP_S} s", clock - drive.motion.run.last().t),
        ),
    ]
}
