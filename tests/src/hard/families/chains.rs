//! Chains of rods, up to a hundred thousand.

use super::*;
use ezy_core::prelude::Method;
use ezy_core_tests::simulation;
use ezy_models::chain;

/// Of the reference, over the amplification of errors that it states.
const STATE: f64 = 1e-9;
/// Of the reference, of m g L.
const ENERGY: f64 = 1e-8;
/// Of the reference.
const STATE_TOLERANCE: f64 = 1e-12;
/// Keeps the bound on the energy of long chains: the longer the chain, the less a rod matters.
const LOOSE: f64 = 1e-3;
/// Of the reference, s.
const FALL_S: f64 = 0.3;
/// No method with a fixed step runs.
const NO_STEP: f64 = f64::NAN;
/// Of the reference: time of a step with ten times the rods.
const TIME_RATIO: f64 = 12.0;

pub fn cases() -> Vec<Case> {
    let chains = [("double_1m", 2, true), ("triple_1m", 3, true), ("chain10", 10, false), ("chain100", 100, false)];
    let mut cases: Vec<Case> = chains
        .into_iter()
        .map(|(name, n, is_quick)| {
            let pace = if is_quick { Pace::Quick } else { Pace::Slow };
            let why = "errors of the start grow, by the factor that the reference states";
            case(name, why, STATE_TOLERANCE, pace, move |how| compare(name, n, how))
        })
        .collect();
    let why = "elimination of n³ operations, gaps that add up along the chain";
    cases.push(case("long_chain_energy, 100 rods", why, UNSTATED, Pace::Slow, |how| falling(100, FALL_S, 2e-4, how)));
    let why = "the same; too long for dense elimination";
    cases
        .push(case("long_chain_energy, 1,000 rods", why, UNSTATED, Pace::Slow, |how| falling(1000, FALL_S, 5e-5, how)));
    cases.push(alone(
        "long_chain_energy, 10,000 rods",
        "steps as short as a wave takes from rod to rod: 5,000",
        |how| falling(10_000, FALL_S, NO_STEP, how),
    ));
    cases.push(alone(
        "long_chain_energy, 100,000 rods to 0.01 s",
        "a wave passes ten times as many rods in a time: to 0.3 s it is 50,000 steps, some hours",
        |how| falling(100_000, FALL_S / 30.0, NO_STEP, how),
    ));
    let why = "time of a step must grow as the length";
    let of_step = case("long_chain_energy, 10,000 and 100,000 rods", why, UNSTATED, Pace::Slow, |_| times());
    cases.push(Case { by: By::Nothing, ..of_step });
    cases
}

/// By one method, as loosely as the bound on the energy allows.
fn alone(name: &str, why: &'static str, examine: impl Fn(How) -> Findings + 'static) -> Case {
    Case { by: By::Only("dop853"), ..case(name, why, LOOSE, Pace::Long, examine) }
}

/// `n` rods; of total length and mass one where there are many.
fn rods(n: usize) -> chain::Swing {
    let size = if n > 3 { 1.0 / n as f64 } else { 1.0 };
    chain::Swing { n, l: size, m: size, ..Default::default() }
}

fn compare(name: &'static str, n: usize, how: How) -> Findings {
    let file = crate::garage::load("chain_pendulum");
    let states = crate::garage::case(&file, name)["states"].clone();
    let scene = rods(n);
    let error = Question::at_times("angles and rates over the amplification, rad, rad/s", STATE, |i, seen| {
        let state = &states[i];
        let of = |k: usize| {
            let angle = seen.q[3 * k + 2] - number(&state["angles"][k]);
            worse(angle.abs(), seen.v[3 * k + 2] - number(&state["rates"][k]))
        };
        (0..n).map(of).fold(0.0, worse) / number(&state["error_amplification"])
    });
    let questions =
        vec![error, Question::gaps(GAP), Question::energy(1e-9, 9.81 * scene.m * scene.l * (n * n) as f64 / 2.0)];
    let trial = Trial { scene: &scene, given: Vec::new(), times: times_of(&states), questions };
    trial.examine(how.by(1e-3))
}

fn falling(n: usize, until_s: f64, step_s: f64, how: How) -> Findings {
    let scene = rods(n);
    let by = how.by(step_s).without_naive();
    // the longest take as many steps as they need
    let by = if step_s.is_nan() { Program { most: None, ..by } } else { by };
    let questions = vec![Question::gaps(GAP), Question::energy(ENERGY, 9.81)];
    Trial { scene: &scene, given: Vec::new(), times: vec![until_s], questions }.examine(by)
}

/// Times of steps, and the gaps that they leave; of several runs the shortest time counts.
fn times() -> Findings {
    const STEPS: u64 = 4;
    const STEP_S: f64 = 1e-6;
    const RUNS: usize = 3;
    let (mut gap, mut seconds) = (0.0, [f64::INFINITY; 2]);
    for _ in 0..RUNS {
        for (time, n) in seconds.iter_mut().zip([10_000, 100_000]) {
            let scene = rods(n);
            let order = simulation(&scene).method(Method::rk4(STEP_S)).until(STEPS as f64 * STEP_S);
            let Ok(run) = order.run() else {
                gap = f64::NAN;
                continue;
            };
            gap = worse(gap, run.last().position_residual);
            *time = time.min(run.cost.seconds);
        }
    }
    let checks = vec![
        Check::new("gaps, m", GAP, gap),
        Check::of_times("time of a step of 100,000 over 10,000 rods", TIME_RATIO, seconds[1] / seconds[0]),
    ];
    Findings { checks, ..Findings::default() }
}
