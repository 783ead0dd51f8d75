//! The solvers of K against each other.

use super::probe::{Probe, RandomState, Worst};
use super::{Check, CheckError};
use crate::dynamics::{Metric, State, System, max_abs};
use crate::linalg::{Backend, HAS_SPARSE, LARGEST_DENSE};
use crate::model::{Equations as _, Scene, SceneRef};

/// ε times the condition of K, which is the square of that of the rows, 1e4, with a margin of a
/// hundred for elimination without pivoting.
const TOLERANCE: f64 = f64::EPSILON * 1e4 * 100.0;
const REASON: &str = "rounding times the condition of K";

/// States whose solution changes more than this times as much as the coordinates are near rank loss and not compared.
const CONDITION_OF_ROWS: f64 = 100.0;

/// Accelerations and multipliers beyond this times the speeds and forces show a K near rank loss, too.
const REGULAR: f64 = 1e4;

/// Change of a coordinate that shows the condition: far above rounding, far below the size of a state.
const PERTURBATION: f64 = 1e-9;

/// Multiplications of the dense oracle; a large scene is compared at fewer states. A second, without optimisation.
const DENSE_WORK: usize = 40_000_000;

/// The start must determine the motion: rows that depend on each other have to agree.
pub(super) fn agreement_at_start<P: SceneRef>(system: &mut System<P>, start: &State) -> Check {
    let info = system.info();
    let (mut a, mut lambda) = (vec![0.0; info.n_velocities()], vec![0.0; info.n_rows()]);
    let solved = system.accelerations(start.t, &start.q, &start.v, &mut a, &mut lambda);
    let agree = solved.and_then(|solved| system.diagnosis().check_accelerations(start.t, &start.q, solved));
    Check {
        name: "agreement of the constraints at the start",
        n_compared: 1,
        n_left_out: 0,
        largest_error: f64::from(u8::from(agree.is_err())),
        tolerance: 0.0,
        reason: "zero when accelerations satisfy all constraints, one when not",
    }
}

/// Generated, where there is an elimination, and sparse against dense; nothing to compare with massless bodies, which
/// only the dense one solves, in systems that are too large for it, and where rows are redundant at all states.
pub(super) fn backends<'s, S: Scene + ?Sized>(probe: &Probe<'s, S>) -> Result<Vec<Check>, CheckError> {
    if probe.info.n_unknowns() > LARGEST_DENSE {
        return Ok(Vec::new());
    }
    let mut dense = probe.system(Backend::Dense)?;
    if dense.mass_matrix().contains(&0.0) {
        return Ok(Vec::new());
    }
    let n_states = DENSE_WORK / probe.info.n_unknowns().pow(3).max(1);
    let states: Vec<_> = probe.states.iter().take(n_states).filter(|state| is_regular(&mut dense, state)).collect();
    if states.is_empty() && is_redundant_anywhere(&mut dense, &probe.states) {
        // redundant rows: at random states, which do not meet them, they contradict each other
        return Ok(Vec::new());
    }
    let mut checks = Vec::new();
    let mut against_dense = |name, system: &mut System<&'s S>, solve| {
        checks.push(check(name, &states, system, &mut dense, solve));
    };
    if probe.info.has_elimination() {
        let mut generated = probe.system(Backend::Generated)?;
        against_dense("accelerations, generated against dense", &mut generated, solve_motion);
        against_dense("corrections, generated against dense", &mut generated, solve_correction);
    }
    if HAS_SPARSE {
        let mut sparse = probe.system(Backend::Sparse)?;
        against_dense("accelerations, sparse against dense", &mut sparse, solve_motion);
    }
    Ok(checks)
}

/// Whether constraints depend on each other even at states that do not meet them.
pub(super) fn is_redundant_anywhere<P: SceneRef>(system: &mut System<P>, states: &[RandomState]) -> bool {
    states.last().is_some_and(|state| system.rank_loss(state.t, &state.q).is_lost())
}

/// Whether K is far enough from rank loss at a state. A correction would not tell: its multipliers do not show.
pub(super) fn is_regular<P: SceneRef>(dense: &mut System<P>, state: &RandomState) -> bool {
    let q =
        state.q.iter().enumerate().map(|(i, q)| if i % 2 == 0 { q + PERTURBATION } else { q - PERTURBATION }).collect();
    let perturbed = RandomState { t: state.t, q, v: state.v.clone() };
    let (Some(x), Some(y)) = (solve_motion(dense, state), solve_motion(dense, &perturbed)) else { return false };
    let change = x.iter().zip(&y).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
    let size = max_abs(&x);
    change <= CONDITION_OF_ROWS * PERTURBATION * size && size <= REGULAR * scale(dense, state)
}

/// Size of forces and convective terms at a state, at least one.
fn scale<P: SceneRef>(system: &System<P>, state: &RandomState) -> f64 {
    let mut F = vec![0.0; system.info().n_velocities()];
    let mut h = vec![0.0; system.info().n_rows()];
    let RandomState { t, q, v } = state;
    system.scene().applied_force(system.fixed(), *t, q, v, &mut F);
    system.scene().convective_term(system.fixed(), *t, q, v, &mut h);
    max_abs(&F).max(max_abs(&h)).max(1.0)
}

/// A solution vector at a state; `None` where constraints depend on each other.
type Solve<P> = fn(&mut System<P>, &RandomState) -> Option<Vec<f64>>;

fn check<P: SceneRef>(
    name: &'static str,
    states: &[&RandomState],
    system: &mut System<P>,
    oracle: &mut System<P>,
    solve: Solve<P>,
) -> Check {
    let mut worst = Worst::default();
    for state in states {
        let (Some(x), Some(y)) = (solve(system, state), solve(oracle, state)) else { continue };
        let size = max_abs(&y);
        x.iter().zip(&y).for_each(|(x, y)| worst.compare(*x, *y, size));
    }
    worst.check_of_some(name, TOLERANCE, REASON)
}

/// Accelerations, then multipliers.
pub(super) fn solve_motion<P: SceneRef>(system: &mut System<P>, state: &RandomState) -> Option<Vec<f64>> {
    let (n_v, n_c) = (system.info().n_velocities(), system.info().n_rows());
    let mut x = vec![0.0; n_v + n_c];
    let (a, lambda) = x.split_at_mut(n_v);
    let solved = system.accelerations(state.t, &state.q, &state.v, a, lambda).ok()?;
    (!solved.is_rank_deficient).then_some(x)
}

/// Correction for the residual that the velocity constraints happen to have.
fn solve_correction<P: SceneRef>(system: &mut System<P>, state: &RandomState) -> Option<Vec<f64>> {
    let (n_v, n_c) = (system.info().n_velocities(), system.info().n_rows());
    let (mut residual, mut delta) = (vec![0.0; n_c], vec![0.0; n_v]);
    system.scene().velocity_constraint(system.fixed(), state.t, &state.q, &state.v, &mut residual);
    let solved = system.correction(state.t, &state.q, &residual, Metric::Mass, &mut delta).ok()?;
    (!solved.is_rank_deficient).then_some(delta)
}
