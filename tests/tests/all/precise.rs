//! The motion in double-double: against digits that are known, and by both ways of solving.

use ezy_core::dynamics::MotionError;
use ezy_core::integrate::{PreciseError, PreciseMotion};
use ezy_core::prelude::*;
use ezy_core::scalar::{DoubleDouble, Scalar};
use ezy_core_tests::system_of;
use ezy_models::ezy_roller;
use ezy_tests::crank::Crank;
use ezy_tests::reference::{decimal, load_precise};

ezy_core::model! {
    /// No row stops numbers that overflow.
    model Thrown {
        body stone { mass: 1, inertia: 1 }
        effect push { force at stone(0, 0): (1e308 * exp(t), 0); }
        start home { stone at (0, 0) angle 0; at rest; }
        scene flight { start home; until 1 s; with push; }
    }
}

/// Rounding of 1e-32 a step in numbers of 1, made larger by 10 in 5 s; reactions of 50 N have fifty times as much.
const DRIVEN: f64 = 1e-29;
const REACTIONS: f64 = 1e-27;
/// Over a minute errors grow two thousand times.
const A_MINUTE: f64 = 1e-27;
/// Rounding of an energy of 23 J over a second.
const ENERGY: f64 = 1e-28;

/// The driven roller with exact decimals and all digits of π.
fn driven(scene: &ezy_roller::Driven) -> PreciseMotion<'_> {
    let parameters = ["0.2", "0.6", "0.1", "0.1", "46", "10", "1", "0.005", "2"].map(decimal);
    let parameters: Vec<DoubleDouble> = parameters.into_iter().chain([DoubleDouble::PI]).collect();
    let zero = DoubleDouble::from(0.0);
    let q = [zero, zero, zero, decimal("0.5"), zero, DoubleDouble::PI];
    PreciseMotion::with_parameters(scene, &parameters, 0.0, &q, &[zero; 6]).expect("a motion")
}

fn distance(x: &[DoubleDouble], y: &[DoubleDouble]) -> f64 {
    x.iter().zip(y).map(|(x, y)| (*x - *y).magnitude()).fold(0.0, f64::max)
}

#[test]
fn reference_double_double_driven_to_29_digits() {
    let scene = ezy_roller::Driven::default();
    let mut motion = driven(&scene);
    for r in load_precise("ezyroller_driven").iter().filter(|r| r.t <= 5.0) {
        motion.advance_to(r.t).unwrap();
        let error = distance(motion.q(), &r.q).max(distance(motion.v(), &r.v));
        assert!(error <= DRIVEN, "{error:.1e} at {} s", r.t);
        let error = distance(motion.lambda(), &r.lambda);
        assert!(error <= REACTIONS, "reactions: {error:.1e} at {} s", r.t);
    }
}

#[test]
fn reference_double_double_driven_over_a_minute() {
    let end = load_precise("ezyroller_driven").pop().expect("a reference at the end");
    let scene = ezy_roller::Driven::default();
    let mut motion = driven(&scene);
    motion.advance_to(end.t).unwrap();
    let error = distance(motion.q(), &end.q);
    assert!(error <= A_MINUTE, "{error:.1e}");
}

/// A bar this light is left to factors in f64, of which refinement makes the missing digits.
#[test]
fn invariant_energy_by_refined_factors() {
    let scene = ezy_roller::Coast { i2: 1e-6, ..Default::default() };
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    assert!(!system.uses_elimination());
    let start = system.consistent_start(&system.scene_start()).unwrap();
    let mut motion = PreciseMotion::new(&scene, &start).unwrap();
    let masses = system.mass_matrix().to_vec();
    let energy = |v: &[DoubleDouble]| {
        let terms = v.iter().zip(&masses).map(|(v, m)| *v * *v * DoubleDouble::from(0.5 * m));
        terms.fold(DoubleDouble::from(0.0), |sum, term| sum + term)
    };
    let before = energy(motion.v());
    motion.advance_to(1.0).unwrap();
    let change = (energy(motion.v()) - before).magnitude();
    assert!(change <= ENERGY, "{change:.1e} J");
}

#[test]
fn invariant_motion_that_overflows_is_an_error() {
    let scene = thrown::Flight::default();
    let start = ezy_core::dynamics::State::zero(3, 0);
    let outcome = PreciseMotion::new(&scene, &start).map(|mut motion| motion.advance_to(1.0));
    assert!(matches!(outcome, Ok(Err(MotionError::NotFinite { .. }))));
}

#[test]
fn analytic_scene_without_a_series_has_no_precise_motion() {
    let scene = Crank::default();
    let start = ezy_core::dynamics::State::zero(3, 1);
    assert_eq!(PreciseMotion::new(&scene, &start).err(), Some(PreciseError::NoSeries { scene: "turn" }));
}
