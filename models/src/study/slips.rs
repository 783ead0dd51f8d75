//! Where the formulas and the listing of the report are misprinted: print, correction, measurement.

use ezy_core::dynamics::System;
use ezy_core::linalg::Backend;
use ezy_core::model::{Scene, SceneInfo};
use ezy_core::record::{coordinate_index, find_name};

use super::error::StudyError;
use super::findings::Findings;
use super::parts::{largest, row};
use crate::ezy_roller::{Coast, Driven};

/// A length of the bar that is not the one of the report, m: it tells c and d apart.
const OTHER_D_M: f64 = 0.3;
/// The driven start that the report lists, in m and rad: (0, 0, 0, 0, 0, π).
const LISTED_START: [f64; 6] = [0.0, 0.0, 0.0, 0.0, 0.0, std::f64::consts::PI];

/// Misprints that matter, each as part, print, correction and what was computed here.
pub fn slips(found: &Findings<'_>, driven: &Driven) -> Result<Vec<[String; 4]>, StudyError> {
    let coast_info = Coast::default().info();
    let mut other = Coast::default();
    let d = find_name("parameter", "d", coast_info.parameters.iter().map(|p| p.name))?;
    other.set_parameter(d, OTHER_D_M);
    let mut system = System::new(&other, Backend::Auto)?;
    let other_start = system.consistent_start(&system.scene_start())?;
    let bar_rate = coordinate_index(&coast_info, "bar.phi")?;
    let mut system = System::new(driven, Backend::Auto)?;
    let listed = system.position_residual(0.0, &LISTED_START);
    let (wheel, centre) =
        (found.drive.motion.path("A")?, [found.drive.motion.column("seat.x")?, found.drive.motion.column("seat.y")?]);
    let offset = largest((0..wheel.0.len()).map(|i| (wheel.0[i] - centre[0][i]).hypot(wheel.1[i] - centre[1][i])));
    let assembled = found.drive.motion.run.first().get("bar.x")?;
    let torque = found.drive.motion.force("seat.phi")?[0];
    let first = found.drive.motion.run.first();
    let (acceleration, reaction) = (first.get("bar.ax")?, largest(first.multipliers.iter().copied()));
    let path_end = wheel.1.last().copied().unwrap_or(f64::NAN);
    let n_q = coast_info.n_coordinates();
    let index = |row: &str| find_name("row", row, coast_info.rows.iter().map(|r| &*r.name));
    let cosine = |name: &str| coordinate_index(&coast_info, name).map(|i| other_start.q[i].cos());
    Ok(vec![
        row(
            ["(a)", "hinge Jacobian, row 2, column 5: 1", "the opposite sign"],
            format!("derived entry of B.y and bar.y: {}", typeset(entry(&coast_info, "B.y", "bar.y")?)),
        ),
        row(
            [
                "(b)",
                "second component of the velocity of A: y₁′ + a φ₁′ cos φ₁",
                "A is behind the centre of mass: minus (the constraint after it is right)",
            ],
            format!("derived entry of rear and seat.phi: {}", typeset(entry(&coast_info, "rear", "seat.phi")?)),
        ),
        row(
            [
                "(b)",
                "the wheels do not slip in the direction parallel to the body",
                "it is the velocity across the body that vanishes; along it the wheel rolls",
            ],
            format!("derived row rear: {} = 0", typeset(coast_info.rows[index("rear")?].constraint.text)),
        ),
        row(
            [
                "(c)",
                "matrix form: Jacobians in the upper right blocks as in the lower left; sₘ with the entries of Sₖ",
                "their transposes; sₘ with the entries of Sₘ",
            ],
            format!(
                "M has {n_q} rows, the Jacobians {} and {}: only the transposes fit beside it",
                coast_info.n_position_rows,
                coast_info.n_rows() - coast_info.n_position_rows
            ),
        ),
        row(
            [
                "(d)",
                "velocity projection: the predicted velocity stands in one place of its condition only; positions are projected onto all constraints",
                "in both places; positions onto the hinge rows, as the wheels restrict velocities alone",
            ],
            format!(
                "velocity residual {:.1e} m/s before and {:.0e} m/s after the projection, unweighted as there",
                found.projections.velocity_before, found.projections.euclidean.velocity_residual
            ),
        ),
        row(
            [
                "(e)",
                "start velocities, first equation: y₁′ cos φ₂",
                "y₁′ cos φ₁; as printed y₁′ and y₂′ stay undetermined at this start",
            ],
            format!("cos φ₂ = {:.0e} there, cos φ₁ = {:.0}", cosine("bar.phi")?, cosine("seat.phi")?),
        ),
        row(
            ["(e)", "start velocities, hinge equations: c φ₂′", "d φ₂′; not seen there because c = d"],
            format!(
                "with d = {OTHER_D_M} m the bar starts at {:.4} rad/s; with c in its place it would be {:.4} rad/s",
                other_start.v[bar_rate],
                found.coasting.start_of("bar.omega")
            ),
        ),
        row(
            ["(f)", "driven start (0, 0, 0, 0, 0, 0, π): seven numbers, x₂ = 0", "six, with x₂ = b − d"],
            format!("|C| of the listed start {listed:.1} m; assembled x₂ = {assembled:.1} m"),
        ),
        row(
            [
                "(f)",
                "torque: −M on body 1 and M on body 2 in one place of the text, the reverse in another",
                "M on body 1 and −M on body 2, as in the listing: the path described (downwards) is that one, the other is its mirror image",
            ],
            format!("torque on body 1 at the start {:+.1} N·m; wheel A ends at y = {:.1} m", torque, path_end),
        ),
        row(
            [
                "(f)",
                "listing: the right-hand side has nine rows, with the torques in rows 4 and 5; entry 4 of the solution is taken as constraint force",
                "ten rows, with the torques in rows 3 and 6; entries 7 to 10 are the multipliers, entry 4 is the acceleration x₂″",
            ],
            format!("at the start x₂″ = {acceleration:.3} m/s², the largest multiplier is {reaction:.3} N"),
        ),
        row(
            [
                "(f)",
                "the paths labelled A and C are plotted from x₁, y₁ and x₂, y₂ (listing)",
                "those are the centres of mass",
            ],
            format!("the path of wheel A runs {offset:.1} m from that of the centre of mass"),
        ),
    ])
}

/// A printed expression with the signs of typeset text.
fn typeset(text: &str) -> String {
    text.replace('-', "−").replace('*', " ").replace("phi", "φ")
}

fn entry(info: &SceneInfo, row: &str, coordinate: &str) -> Result<&'static str, StudyError> {
    let i = find_name("row", row, info.rows.iter().map(|r| &*r.name))?;
    let j = coordinate_index(info, coordinate)?;
    Ok(info.jacobian.entries().find(|e| (e.1, e.2) == (i, j)).map_or("0", |(k, _, _)| info.jacobian_entries[k].text))
}
