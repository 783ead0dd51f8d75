//! Times as ratios within one run: the solvers of the equations of motion against each other, and a whole run.
//!
//! `cargo bench -p ezy-tests`. The candidates take turns, and the best of many rounds counts, so that what else the
//! machine does falls on all of them.

use ezy_core::linalg::SparseKkt;
use ezy_core::prelude::*;
use ezy_models::{chain, ezy_roller};
use nalgebra::{SMatrix, SVector};
use std::hint::black_box;
use std::time::Instant;

const N_ROUNDS: usize = 60;
const N_CALLS: usize = 20_000;
const N_STATES: usize = 64;
const N_RUNS: usize = 7;

/// Accelerations with assembly: the backends, and besides them the least that a dense solution can cost.
const BACKENDS: [(&str, Backend); 3] = [
    ("accelerations/generated", Backend::Generated),
    ("accelerations/dense (scaled LU, watched pivots)", Backend::Dense),
    ("accelerations/sparse (faer LDLt)", Backend::Sparse),
];
const PLAIN_LU: &str = "accelerations/plain LU of a 10 x 10 (nalgebra)";

fn main() {
    accelerations();
    driven_run();
    lanes();
    chains();
}

fn accelerations() {
    let scene = ezy_roller::Driven::default();
    let run =
        Simulation::new(&scene).method(Method::rk4(1e-3)).until(6.4).every(0.1).run().expect("the driven scene runs");
    let states: Vec<_> =
        run.samples().take(N_STATES).map(|s| (s.t, s.coordinates.to_vec(), s.velocities.to_vec())).collect();
    let mut systems =
        BACKENDS.map(|(_, backend)| System::new(&scene, backend).expect("the declared parameters are fine"));
    let constants = systems[0].fixed().to_vec();
    let mut best = [f64::INFINITY; BACKENDS.len() + 1];
    let (mut a, mut lambda) = ([0.0; 6], [0.0; 4]);
    for _ in 0..N_ROUNDS {
        for (system, best) in systems.iter_mut().zip(&mut best) {
            *best = best.min(seconds_a_call(|i| {
                let (t, q, v) = &states[i % N_STATES];
                let solved = system.accelerations(*t, black_box(q), black_box(v), &mut a, &mut lambda);
                black_box((&a, &lambda, solved.is_ok()));
            }));
        }
        let plain = &mut best[BACKENDS.len()];
        *plain = plain.min(seconds_a_call(|i| {
            let (t, q, v) = &states[i % N_STATES];
            black_box(plain_lu(&scene, &constants, *t, black_box(q), black_box(v)));
        }));
    }
    for (name, time) in BACKENDS.iter().map(|(name, _)| *name).chain([PLAIN_LU]).zip(best) {
        println!("{name:50} {:8.1} ns  {:6.2} x generated", 1e9 * time, time / best[0]);
    }
}

fn seconds_a_call(mut call: impl FnMut(usize)) -> f64 {
    let began = Instant::now();
    (0..N_CALLS).for_each(&mut call);
    began.elapsed().as_secs_f64() / N_CALLS as f64
}

/// K assembled and solved on the stack, its size known to the compiler, without scaling or a look at the pivots.
fn plain_lu(scene: &ezy_roller::Driven, c: &[f64], t: f64, q: &[f64], v: &[f64]) -> Option<SVector<f64, 10>> {
    let (mut m, mut g) = ([0.0; 6], [0.0; 14]);
    let mut right_side = SVector::<f64, 10>::zeros();
    scene.mass_matrix(c, &mut m);
    scene.velocity_jacobian(c, t, q, &mut g);
    let (force, convective) = right_side.as_mut_slice().split_at_mut(6);
    scene.applied_force(c, t, q, v, force);
    scene.convective_term(c, t, q, v, convective);
    convective.iter_mut().for_each(|h| *h = -*h);
    let mut kkt = SMatrix::<f64, 10, 10>::zeros();
    (0..6).for_each(|i| kkt[(i, i)] = m[i]);
    for (k, row, column) in scene.info().jacobian.entries() {
        kkt[(6 + row, column)] = g[k];
        kkt[(column, 6 + row)] = g[k];
    }
    kkt.lu().solve(&right_side)
}

fn driven_run() {
    let scene = ezy_roller::Driven::default();
    for (name, method) in [
        ("rk4 1 ms", Method::rk4(1e-3)),
        ("dop853 1e-12", Method::dop853(1e-12)),
        ("taylor 1e-12", Method::taylor(1e-12)),
    ] {
        let order = || Simulation::new(&scene).method(method).until(60.0);
        let costs = (0..N_RUNS).map(|_| order().run().expect("the driven scene runs").cost);
        let cost = costs.min_by(|a, b| a.seconds.total_cmp(&b.seconds)).expect("more than one run");
        println!(
            "run/driven 60 s/{name:35}{:8.2} ms  {} steps, {} evaluations, {} factorisations",
            1e3 * cost.seconds,
            cost.steps,
            cost.evaluations,
            cost.factorizations
        );
    }
}

/// Runs of the driven roller with other torques, one after the other and together in lanes.
fn lanes() {
    const L: usize = 8;
    let scenes: [ezy_roller::Driven; L] =
        std::array::from_fn(|i| ezy_roller::Driven { m0: 2.0 + 0.01 * i as f64, ..Default::default() });
    let starts = scenes.each_ref().map(|scene| {
        let mut system = System::new(scene, Backend::Auto).expect("the parameters are fine");
        system.consistent_start(&system.scene_start()).expect("the driven scene starts")
    });
    for (name, method, until_s) in
        [("rk4 1 ms, 10 s ", Method::rk4(1e-3), 10.0), ("dop853 1e-9, 60 s", Method::dop853(1e-9), 60.0)]
    {
        let (mut alone, mut together) = (f64::INFINITY, f64::INFINITY);
        for _ in 0..N_RUNS {
            let runs = scenes.iter().map(|scene| Simulation::new(scene).method(method).until(until_s).run());
            alone = alone.min(runs.map(|run| run.expect("the driven scene runs").cost.seconds).sum());
            let mut ensemble =
                Ensemble::new(&scenes, starts.each_ref(), method).expect("the driven scene runs in lanes");
            let began = Instant::now();
            ensemble.advance(until_s).expect("the driven scene runs in lanes");
            together = together.min(began.elapsed().as_secs_f64());
        }
        println!(
            "run/driven/{name}/{L} in lanes             {:8.1} ms  {:.1} x faster than {L} one by one",
            1e3 * together,
            alone / together
        );
    }
}

/// Rods of the chains, and steps of their runs.
const CHAINS: [(usize, u32); 4] = [(10, 1000), (100, 300), (1_000, 30), (10_000, 5)];

/// The time of a step for each rod, which should not depend on how many there are.
fn chains() {
    for (n, n_steps) in CHAINS {
        let scene = chain::Swing { n, l: 1.0 / n as f64, m: 1.0 / n as f64, ..Default::default() };
        let info = scene.info();
        let entries = SparseKkt::new(&vec![1.0; info.n_coordinates()], &info.jacobian, info.n_rows())
            .expect("the pattern of a chain can be analysed")
            .n_factor_entries();
        let order = || Simulation::new(&scene).method(Method::rk4(1e-6)).until(1e-6 * f64::from(n_steps));
        let runs = (0..N_RUNS).map(|_| order().run().expect("the chain runs").cost.seconds);
        let step = runs.fold(f64::INFINITY, f64::min) / f64::from(n_steps);
        println!(
            "step/chain of {n:5} rods/rk4 with both projections   {:8.2} us a rod  {:.1} entries of L a rod",
            1e6 * step / n as f64,
            entries as f64 / n as f64
        );
    }
}
