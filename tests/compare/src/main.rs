//! The same scenes through EZY and through other integrators of Rust, in one process: error and time of each.
//!
//! `cargo run --release --manifest-path tests/compare/Cargo.toml [-- points.csv]`. The other integrators get the
//! equations as they are written without EZY and, once more, as EZY derives them. Read `docs/compared.md`.

mod integrators;
mod measure;
mod right_side;
mod scenes;
mod table;

use ezy_core::integrate::Method;
use ezy_core::model;
use integrators::{Arrival, Task};
use measure::{Candidate, Point, measure};
use right_side::{Counted, Generated, RightSide};
use std::error::Error;

/// Tolerances: 10^(−4 − m/2).
const N_TOLERANCES: i32 = 23;
/// Steps of the method with fixed ones: 0.2 s / 2^m.
const N_STEPS: i32 = 10;

fn main() -> Result<(), Box<dyn Error>> {
    let mut points = compare(&scenes::driven()?, &scenes::Driven::default())?;
    points.extend(compare(&scenes::coast()?, &scenes::Coast::default())?);
    points.extend(compare(&scenes::double_pendulum()?, &scenes::Swing::default())?);
    points.extend(compare(&scenes::slider_crank()?, &scenes::Pushed::default())?);
    table::print_points(&points);
    table::print_targets(&points);
    if let Some(path) = std::env::args().nth(1) {
        std::fs::write(&path, table::csv(&points)).map_err(|error| format!("{path}: {error}"))?;
    }
    Ok(())
}

/// All points of a scene.
fn compare<S: model::Scene, const C: usize>(by_hand: &scenes::Scene<C>, scene: &S) -> Result<Vec<Point>, Box<dyn Error>>
where
    right_side::ByHand<C>: RightSide,
{
    eprintln!("{} …", by_hand.name);
    let task = Task { start: by_hand.start, until_s: by_hand.until_s };
    let generated = Generated::new(scene);
    let mut candidates = with_every_crate("by hand", &by_hand.right_side, task);
    candidates.extend(with_every_crate("of EZY", &generated, task));
    let until_s = task.until_s;
    let mut of_ezy = |name, settings: Vec<f64>, method: fn(f64) -> Method| {
        candidates.push(Candidate {
            integrator: name,
            equations: "of EZY",
            settings,
            run: Box::new(move |setting| integrators::ezy(scene, method(setting), until_s).map(|(arrival, _)| arrival)),
            evaluations: Box::new(move |setting| {
                integrators::ezy(scene, method(setting), until_s).map_or(0, |(_, evaluations)| evaluations)
            }),
        });
    };
    of_ezy("EZY rk4", (0..N_STEPS).map(|m| 0.2 / 2.0_f64.powi(m)).collect(), Method::rk4);
    of_ezy("EZY dop853", tolerances(), Method::dop853);
    of_ezy("EZY taylor", tolerances(), Method::taylor);
    of_ezy("EZY gauss", tolerances(), Method::gauss);
    Ok(measure(by_hand.name, &by_hand.end, &candidates))
}

fn tolerances() -> Vec<f64> {
    (0..N_TOLERANCES).map(|m| 10.0_f64.powf(-4.0 - 0.5 * f64::from(m))).collect()
}

/// The other integrators on a right side.
fn with_every_crate<'r, R: RightSide>(equations: &'static str, right_side: &'r R, task: Task) -> Vec<Candidate<'r>> {
    macro_rules! candidate {
        ($name:literal, $integrate:path) => {
            Candidate {
                integrator: $name,
                equations,
                settings: tolerances(),
                run: Box::new(move |tolerance| $integrate(right_side, task, tolerance)),
                evaluations: Box::new(move |tolerance| {
                    let counted = Counted::new(right_side);
                    // what it could do before it failed counts, too
                    let _: Result<Arrival, String> = $integrate(&counted, task, tolerance);
                    counted.n()
                }),
            }
        };
    }
    vec![
        candidate!("differential-equations dop853", integrators::differential_equations_dop853),
        candidate!("differential-equations rkv988e", integrators::differential_equations_rkv98),
        candidate!("ode_solvers dop853", integrators::ode_solvers_dop853),
        candidate!("russell_ode dopri8", integrators::russell_ode_dopri8),
        candidate!("diffsol tsit45", integrators::diffsol_tsit45),
    ]
}
