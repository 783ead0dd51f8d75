//! Part (d): both projections on a disturbed state.

use ezy_core::dynamics::{Metric, State, System};
use ezy_core::linalg::Backend;
use ezy_study::report::page::{Page, bracketed};
use ezy_study::report::table::Table;

use super::error::StudyError;
use super::parts::largest;
use crate::ezy_roller::Coast;

/// How far each coordinate (m, rad) and velocity (m/s, rad/s) is put off the constraints.
const DISTURBANCE: [f64; 6] = [1e-3, -2e-3, 3e-3, -1e-3, 2e-3, -3e-3];

/// One projection of the disturbed state.
#[derive(Debug, Clone, Copy)]
pub struct Projected {
    /// Gauss–Newton passes for the positions.
    pub passes: usize,
    /// Largest |C| after the positions, m.
    pub position_residual: f64,
    /// Largest residual at velocity level after the velocities, m/s.
    pub velocity_residual: f64,
    /// What the velocity projection did to the kinetic energy, J.
    pub energy_change: f64,
}

/// What part (d) found.
#[derive(Debug, Clone, Copy)]
pub struct Projections {
    /// Largest |C| of the disturbed state, m.
    pub position_before: f64,
    /// Largest residual at velocity level of the disturbed state, m/s.
    pub velocity_before: f64,
    /// In the metric of the masses.
    pub mass: Projected,
    /// Unweighted, as in the report.
    pub euclidean: Projected,
    /// Factor by which ten passes without re-evaluation multiply |C|.
    pub without_reevaluation: f64,
}

impl Projections {
    /// Disturbs the start of the coasting scene and projects it back.
    pub fn measure() -> Result<Self, StudyError> {
        let scene = Coast::default();
        let mut system = System::new(&scene, Backend::Auto)?;
        let mut state = system.consistent_start(&system.scene_start())?;
        for (i, disturbance) in DISTURBANCE.iter().enumerate() {
            state.q[i] += disturbance;
            state.v[i] += disturbance;
        }
        let State { t, q, v, .. } = &state;
        Ok(Self {
            position_before: system.position_residual(*t, q),
            velocity_before: system.velocity_residual(*t, q, v),
            mass: project(&mut system, &state, Metric::Mass)?,
            euclidean: project(&mut system, &state, Metric::Euclidean)?,
            without_reevaluation: ten_passes_without_reevaluation(&mut system, &state)?,
        })
    }

    /// Puts the formulas and the measured residuals on the page.
    pub fn write(&self, page: &mut Page) {
        page.section("d", "(d) Projection onto the constraints");
        page.paragraph(
            "After each step the positions are put back onto the constraints, then the velocities at the corrected positions. \
             Both corrections are the smallest ones in the metric of the masses. The positions take Gauss–Newton passes, each \
             evaluated at the corrected point, until |C| is below 10⁻¹² m, ten at most; the velocities are linear and take one solve.",
        );
        page.equation(&position_step()).equation(&velocity_step());
        page.html(&self.table().html(
            "Largest residuals after the coasting start was put off by 1 to 3 mm, mrad, mm/s and mrad/s in each coordinate and velocity, and the \
             kinetic energy that the velocity projection adds",
        ));
        page.paragraph(&format!(
            "The unweighted projection of the report (M replaced by the unit matrix, positions along the hinge rows only) meets the \
             constraints as well. But it adds metres to radians, and it may add kinetic energy: here it changes the kinetic energy by \
             {:+.2e} J, the weighted one by {:+.2e} J. The weighted velocity projection never adds kinetic energy.",
            self.euclidean.energy_change, self.mass.energy_change
        ));
    }

    fn table(&self) -> Table {
        let mut table =
            Table::new(["state", "passes", "positions |C| [m]", "velocities [m/s]", "kinetic energy added [J]"]);
        table.push([
            "disturbed",
            "",
            &format!("{:.1e}", self.position_before),
            &format!("{:.1e}", self.velocity_before),
            "",
        ]);
        for (name, p) in [("projected, mass-weighted", self.mass), ("projected, unweighted", self.euclidean)] {
            let (c, v) = (format!("{:.1e}", p.position_residual), format!("{:.1e}", p.velocity_residual));
            table.push([name, &p.passes.to_string(), &c, &v, &format!("{:+.3e}", p.energy_change)]);
        }
        table
    }
}

fn project(system: &mut System<&Coast>, state: &State, metric: Metric) -> Result<Projected, StudyError> {
    let State { t, mut q, mut v, .. } = state.clone();
    let passes = system.project_positions(t, &mut q, metric)?;
    let before = system.kinetic_energy(&v);
    system.project_velocities(t, &q, &mut v, metric)?;
    Ok(Projected {
        passes,
        position_residual: system.position_residual(t, &q),
        velocity_residual: system.velocity_residual(t, &q, &v),
        energy_change: system.kinetic_energy(&v) - before,
    })
}

/// The listing of the report computes C and its Jacobian at the uncorrected point in every pass, so that the same
/// correction is added ten times. To first order in the disturbance that correction is the whole projection.
fn ten_passes_without_reevaluation(system: &mut System<&Coast>, state: &State) -> Result<f64, StudyError> {
    let State { t, q, .. } = state;
    let mut projected = q.clone();
    system.project_positions(*t, &mut projected, Metric::Euclidean)?;
    let overshot: Vec<f64> = q.iter().zip(&projected).map(|(q, p)| q + 10.0 * (p - q)).collect();
    let residual = largest([system.position_residual(*t, &overshot)]);
    Ok(residual / system.position_residual(*t, q))
}

/// q − M⁻¹ Gᵀ (G M⁻¹ Gᵀ)⁻¹ (C, 0), and what G is.
fn position_step() -> String {
    let residual = bracketed("<mtr><mtd><mi>C</mi></mtd></mtr><mtr><mtd><mn>0</mn></mtd></mtr>");
    let jacobian = bracketed("<mtr><mtd><msub><mi>C</mi><mi>q</mi></msub></mtd></mtr><mtr><mtd><mi>S</mi></mtd></mtr>");
    format!(
        "<math display=\"block\"><mi>q</mi><mo>←</mo><mi>q</mi>{CORRECTION}{residual}<mo>,</mo><mspace width=\"1em\"/>\
         <mi>G</mi><mo>=</mo>{jacobian}</math>"
    )
}

fn velocity_step() -> String {
    format!("<math display=\"block\"><mi>v</mi><mo>←</mo><mi>v</mi>{CORRECTION}<mi>G</mi><mi>v</mi></math>")
}

/// − M⁻¹ Gᵀ (G M⁻¹ Gᵀ)⁻¹
const CORRECTION: &str = "<mo>−</mo><msup><mi>M</mi><mrow><mo>−</mo><mn>1</mn></mrow></msup><msup><mi>G</mi><mi>T</mi></msup>\
<msup><mrow><mo>(</mo><mi>G</mi><msup><mi>M</mi><mrow><mo>−</mo><mn>1</mn></mrow></msup><msup><mi>G</mi><mi>T</mi></msup><mo>)</mo></mrow>\
<mrow><mo>−</mo><mn>1</mn></mrow></msup>";
