//! Where the equations say otherwise than the report: claim, finding, measurement.

use ezy_core::dynamics::System;
use ezy_core::linalg::Backend;
use ezy_core::model::{Scene, SceneInfo};
use ezy_core::record::find_name;
use ezy_core::report::page::Page;
use ezy_core::report::table::Table;

use super::coast::Coasting;
use super::driven::Drive;
use super::error::StudyError;
use super::growth::Growth;
use super::parts::largest;
use super::projection::Projections;
use super::steps::{REPORT_STEP_S, Steps};
use crate::ezy_roller::{Coast, Driven};

/// Everything that the other parts found.
pub struct Findings<'a> {
    pub projections: &'a Projections,
    pub coasting: &'a Coasting,
    pub drive: &'a Drive,
    pub steps: &'a Steps,
    pub growth: &'a Growth,
}

/// A length of the bar that is not the one of the report, m: it tells c and d apart.
const OTHER_D_M: f64 = 0.3;
/// The driven start that the report lists, in m and rad: (0, 0, 0, 0, 0, π).
const LISTED_START: [f64; 6] = [0.0, 0.0, 0.0, 0.0, 0.0, std::f64::consts::PI];

/// Puts the list on the page.
pub fn write(page: &mut Page, found: &Findings<'_>, driven: &Driven) -> Result<(), StudyError> {
    page.section("claims", "Where the equations say otherwise than the report");
    page.paragraph(
        "The report is \"Multibody Dynamics B, Assignment 8\" of 4 July 2019, in which this vehicle was studied first. Its equations and its \
         method hold, but for the points below; what stands on the right is measured in this run.",
    );
    let mut table = Table::new(["part", "the report", "the equations", "measured here"]);
    for row in conclusions(found).into_iter().chain(method(found)).chain(slips(found, driven)?) {
        table.push(row);
    }
    page.html(&format!("<div class=\"scroll\">{}</div>", table.html("Claims and findings")));
    Ok(())
}

/// What was concluded from the figures.
fn conclusions(found: &Findings<'_>) -> Vec<[String; 4]> {
    let Findings { drive, steps, growth, .. } = found;
    let [(from_0, to_0, exponent_0), .., (from_1, to_1, exponent_1)] = growth.exponents[..] else { return Vec::new() };
    let (first, last) = (growth.instants[0], growth.instants[growth.instants.len() - 1]);
    let row =
        |cells: [&str; 3], measured: String| [cells[0].to_owned(), cells[1].to_owned(), cells[2].to_owned(), measured];
    vec![
        row(
            [
                "(j)",
                "work and kinetic energy differ because the integration accumulates errors; they never agree",
                "they agree to rounding once work is integrated as a state; the gap is the quadrature error of the right-endpoint sum",
            ],
            format!(
                "state: gap {:.0e} J at most; sum: {:.3e} J at h = {} s, order {:.3} in h, so {:.2e} J at the report's h = {REPORT_STEP_S} s",
                drive.energy_gap,
                steps.sum_gap[steps.sum_gap.len() - 1],
                steps.steps[steps.steps.len() - 1],
                steps.sum_order(),
                steps.sum_gap_at_report_step()
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
                "d ln KE/d ln t is {exponent_0:.2} from {from_0} to {to_0} s and {exponent_1:.2} from {from_1} to {to_1} s"
            ),
        ),
        row(
            [
                "(i)",
                "the relative rate changes its frequency and is damped while a transient dies out",
                "nothing damps; it keeps the frequency of the torque, and shrinks because the speed grows",
            ],
            format!(
                "half period {:.3} s at first, {:.3} s at last; half swing of the hinge {:.4} rad at {:.3} m/s, {:.4} rad at {:.3} m/s; energy gap {:.0e} J",
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
    let row =
        |cells: [&str; 3], measured: String| [cells[0].to_owned(), cells[1].to_owned(), cells[2].to_owned(), measured];
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
                "(f)",
                "time is counted by t = t + h",
                "the rounding of every addition stays in the clock; t = n h has none",
            ],
            format!("clock at the end off by {:.1e} s with h = {REPORT_STEP_S} s", clock - drive.motion.run.last().t),
        ),
    ]
}

/// Misprints that matter.
fn slips(found: &Findings<'_>, driven: &Driven) -> Result<Vec<[String; 4]>, StudyError> {
    let coast_info = Coast::default().info();
    let mut other = Coast::default();
    let d = find_name("parameter", "d", coast_info.parameters.iter().map(|p| p.name))?;
    other.set_parameter(d, OTHER_D_M);
    let mut system = System::new(&other, Backend::Auto)?;
    let other_start = system.consistent_start(&system.scene_start())?;
    let bar_rate = find_name("velocity", "bar.omega", coast_info.coordinates.iter().map(|c| c.velocity_name))?;
    let mut system = System::new(driven, Backend::Auto)?;
    let listed = system.position_residual(0.0, &LISTED_START);
    let (wheel, centre) =
        (found.drive.motion.path("A")?, [found.drive.motion.column("seat.x")?, found.drive.motion.column("seat.y")?]);
    let offset = largest((0..wheel.0.len()).map(|i| (wheel.0[i] - centre[0][i]).hypot(wheel.1[i] - centre[1][i])));
    let assembled = found.drive.motion.run.first().get("bar.x")?;
    let row =
        |cells: [&str; 3], measured: String| [cells[0].to_owned(), cells[1].to_owned(), cells[2].to_owned(), measured];
    Ok(vec![
        row(
            ["(a)", "hinge Jacobian, row 2, column 5: 1", "the opposite sign"],
            format!("derived entry of B.y and bar.y: {}", entry(coast_info, "B.y", "bar.y")?),
        ),
        row(
            [
                "(b)",
                "second component of the velocity of A: y1' + a phi1' cos(phi1)",
                "A is behind the centre of mass: minus (the constraint after it is right)",
            ],
            format!("derived entry of rear and seat.phi: {}", entry(coast_info, "rear", "seat.phi")?),
        ),
        row(
            ["(e)", "start velocities: c phi2' in the hinge equations", "d phi2'; not seen there because c = d"],
            format!(
                "with d = {OTHER_D_M} m the bar starts at {:.4} rad/s; with c in its place it would be {:.4} rad/s",
                other_start.v[bar_rate],
                found.coasting.start_of("bar.omega")
            ),
        ),
        row(
            ["(f)", "driven start (0, 0, 0, 0, 0, 0, pi): seven numbers, x2 = 0", "six, with x2 = b - d"],
            format!("|C| of the listed start {listed:.1} m; assembled x2 = {assembled:.1} m"),
        ),
        row(
            [
                "(f)",
                "the paths labelled A and C are plotted from x1, y1 and x2, y2 (listing)",
                "those are the centres of mass",
            ],
            format!("the path of wheel A runs {offset:.1} m from that of the centre of mass"),
        ),
    ])
}

fn entry(info: &SceneInfo, row: &str, coordinate: &str) -> Result<&'static str, StudyError> {
    let i = find_name("row", row, info.rows.iter().map(|r| r.name))?;
    let j = find_name("coordinate", coordinate, info.coordinates.iter().map(|c| c.name))?;
    Ok(info.jacobian.entries().find(|e| (e.1, e.2) == (i, j)).map_or("0", |(k, _, _)| info.jacobian_entries[k].text))
}
