//! Equations in other languages compute what kernels compute. Each language is run where its tool is at hand: a C compiler, Python with NumPy,
//! SymPy or CasADi (`EZY_PYTHON` names it), GNU Octave, Julia.

mod drivers;
mod mechanisms;
mod refusals;
mod units;

use drivers::{Driver, TOOLS};
use ezy_core::export::{Start, source};
use ezy_core::prelude::*;
use std::path::{Path, PathBuf};

/// States at which results are compared.
const N_STATES: usize = 1000;

/// Results of the same operations in another order of rounding, times what the solution of the equations amplifies: the largest condition of the
/// matrices here, some 1e2. The unit roundoff is 1.1e-16.
const AGREEMENT: f64 = 1e-13;

/// A scene with what its kernels have computed at random states.
struct Computed {
    scene: Box<dyn Scene>,
    /// t, q, v, z, u of each state.
    states: Vec<Vec<f64>>,
    /// Each vector that a driver prints, at each state.
    results: Vec<Vec<Vec<f64>>>,
}

/// Numbers in −1 … 1 that look random.
fn random(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}

impl Computed {
    fn new(scene: Box<dyn Scene>) -> Self {
        let info = scene.info();
        let run = Simulation::new(&*scene).until(0.0).run().expect("it starts");
        let start = run.last();
        let given: Vec<f64> = info.states.iter().chain(info.inputs).map(|of| of.default).collect();
        let mut seed = 7;
        let mut states = Vec::new();
        for _ in 0..N_STATES {
            let about = |x: &f64| x + random(&mut seed);
            let all = std::iter::once(&start.t).chain(start.coordinates).chain(start.velocities).chain(&given);
            states.push(all.map(about).collect::<Vec<f64>>());
        }
        let results = states.iter().map(|state| results(&*scene, state)).collect();
        Self { scene, states, results }
    }

    fn start(&self) -> (f64, Vec<f64>, Vec<f64>) {
        let run = Simulation::new(&*self.scene).until(0.0).run().expect("it starts");
        (run.last().t, run.last().coordinates.to_vec(), run.last().velocities.to_vec())
    }
}

/// What the kernels compute, in the order of [`drivers::results`].
fn results(scene: &dyn Scene, state: &[f64]) -> Vec<Vec<f64>> {
    let info = scene.info();
    let (n_q, n_v, n_c) = (info.n_coordinates(), info.n_velocities(), info.n_rows());
    let (t, rest) = (state[0], &state[1..]);
    let (q, rest) = rest.split_at(n_q);
    let (v, rest) = rest.split_at(n_v);
    let (z, u) = rest.split_at(info.n_states());
    let mut c = vec![0.0; info.n_fixed()];
    c[..u.len()].copy_from_slice(u);
    c[u.len()..u.len() + z.len()].copy_from_slice(z);
    scene.constants(&scene.parameters(), &mut c);
    let of = |n: usize, compute: &dyn Fn(&mut [f64])| {
        let mut out = vec![0.0; n];
        compute(&mut out);
        out
    };
    let jacobian = of(n_c * n_v, &|full| {
        let mut entries = vec![0.0; info.jacobian.n_nonzeros()];
        scene.velocity_jacobian(&c, t, q, &mut entries);
        info.jacobian.entries().for_each(|(k, row, column)| full[row * n_v + column] += entries[k]);
    });
    let mut system = System::new(scene, Backend::Dense).expect("a sound scene");
    system.inputs_mut().copy_from_slice(u);
    system.place_states(z);
    let (mut a, mut multipliers) = (vec![0.0; n_v], vec![0.0; n_c]);
    system.accelerations(t, q, v, &mut a, &mut multipliers).expect("rows are independent");
    let mut all = vec![
        c[u.len() + z.len()..].to_vec(),
        of(n_v, &|out| scene.mass_matrix(&c, out)),
        of(info.n_position_rows, &|out| scene.position_constraint(&c, t, q, out)),
        of(n_c, &|out| scene.velocity_constraint(&c, t, q, v, out)),
        jacobian,
        of(n_c, &|out| scene.convective_term(&c, t, q, v, out)),
        of(n_v, &|out| scene.applied_force(&c, t, q, v, out)),
        of(info.n_states(), &|out| scene.state_rates(&c, t, q, v, out)),
        of(info.n_outputs(), &|out| scene.outputs(&c, t, q, v, out)),
        a,
        multipliers,
    ];
    all.retain(|vector| !vector.is_empty());
    all
}

/// An empty folder of this test.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("exports").join(name);
    std::fs::remove_dir_all(&folder).ok();
    std::fs::create_dir_all(&folder).expect("a folder");
    folder
}

/// What a driver printed differs by at most [`AGREEMENT`] of the largest number that the vector has at any state.
fn assert_agreement(tool: &Driver, of: &Computed) {
    let info = of.scene.info();
    let name = format!("{}_{}_{}", info.model, info.name, tool.language.name());
    let folder = folder(&name);
    let (t, q, v) = of.start();
    let text = source(&*of.scene, tool.language, Start { t, q: &q, v: &v }).expect("it can be exported");
    let states: String = of.states.iter().map(|state| numbers(state) + "\n").collect();
    std::fs::write(folder.join("states.txt"), states).expect("a file");
    let printed = tool.run(&folder, &info, &text);
    let lines: Vec<&str> = printed.lines().filter(|line| !line.trim().is_empty()).collect();
    assert_eq!(lines.len(), N_STATES, "{name}: {printed:.500}");
    let largest: Vec<f64> = (0..of.results[0].len())
        .map(|place| {
            of.results
                .iter()
                .flat_map(|at| &at[place])
                .filter(|x| x.is_finite())
                .fold(0.0, |largest, x| x.abs().max(largest))
        })
        .collect();
    for (line, expected) in lines.iter().zip(&of.results) {
        let mut found = line.split_whitespace().map(|word| word.parse::<f64>().expect("a number"));
        for (place, vector) in expected.iter().enumerate() {
            let largest = largest[place];
            for (i, x) in vector.iter().enumerate() {
                let y = found.next().expect("as many numbers");
                assert!(
                    *x == y || (x - y).abs() <= AGREEMENT * largest,
                    "{name}: element {i} of vector {place} is {y:e}, and {x:e} by the kernel, of up to {largest:e}"
                );
            }
        }
        assert_eq!(found.next(), None, "{name} prints more");
    }
}

fn numbers(of: &[f64]) -> String {
    of.iter().map(|x| format!("{x:?}")).collect::<Vec<_>>().join(" ")
}

/// All languages that have a tool here, and how many there are.
fn assert_agreement_of_all(scene: Box<dyn Scene>) {
    let computed = Computed::new(scene);
    for tool in &TOOLS {
        match tool.is_at_hand() {
            true => assert_agreement(tool, &computed),
            false => eprintln!("skipped: there is no {} here", tool.needs),
        }
    }
}

#[test]
fn cross_every_function_is_the_same_in_all_languages() {
    assert_agreement_of_all(Box::new(mechanisms::laws::Runs::default()));
}

#[test]
fn cross_elimination_is_the_same_in_all_languages() {
    assert_agreement_of_all(Box::new(mechanisms::roller::Coasts::default()));
}

#[test]
fn cross_a_switched_row_is_the_same_in_all_languages() {
    assert_agreement_of_all(Box::new(mechanisms::roller::Skids::default()));
}

#[test]
fn cross_a_scene_with_counts_is_solved_in_all_languages() {
    assert_agreement_of_all(Box::new(mechanisms::rope::Swings::default()));
}

#[test]
fn cross_a_scene_without_rows_is_the_same_in_all_languages() {
    assert_agreement_of_all(Box::new(mechanisms::thrown::Flies::default()));
}

#[test]
fn cross_a_body_without_inertia_is_solved_in_all_languages() {
    assert_agreement_of_all(Box::new(mechanisms::plumb::Swings::default()));
}
