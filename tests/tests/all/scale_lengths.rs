//! The same mechanism from micrometres to a thousand kilometres, from micrograms to kilotons.

use ezy_core::prelude::*;
use ezy_core_tests::{simulation, system_of};
use ezy_models::mechanisms::four_bar::four_bar;
use ezy_models::mechanisms::pendulum::pendulum::Swing;
use ezy_models::registry::MODELS;

/// The four-bar with all lengths, and gravity with them, and all masses in other units: angles move alike.
fn scaled(length: f64, mass: f64) -> four_bar::Turning {
    four_bar::Turning {
        base: 1.1 * length,
        l1: length,
        l2: 1.3 * length,
        l3: 1.25 * length,
        m1: mass,
        m2: mass,
        m3: mass,
        g: 9.81 * length,
    }
}

/// Rounding of a thousand steps; errors grow little in a second.
const SAME: f64 = 1e-9;
/// What a projection leaves of a row, relative to the lengths of the bars.
const RESIDUAL: f64 = 1e-12;

#[test]
fn invariant_motion_in_any_unit_of_length_and_mass() {
    let angles = |scene: &four_bar::Turning, length: f64, method: Method| {
        let run = simulation(scene).method(method).until(1.0).run().unwrap();
        assert!(run.outcome.reached_end(), "{length} m: {}", run.outcome);
        assert!(run.last().position_residual <= RESIDUAL * length, "{length} m: {:.1e}", run.last().position_residual);
        let q = run.last().coordinates.to_vec();
        [q[2], q[5], q[8], q[0] / length, q[4] / length]
    };
    for method in [Method::rk4(1e-3), Method::taylor(1e-12)] {
        let unit = angles(&scaled(1.0, 1.0), 1.0, method);
        for (length, mass) in
            [(1e-6, 1.0), (1e-6, 1e-15), (1e-3, 1e-6), (1e3, 1e6), (1e6, 1.0), (1.0, 1e-6), (1.0, 1e6)]
        {
            let error = crate::scenes::distance(&unit, &angles(&scaled(length, mass), length, method));
            assert!(error <= SAME, "{} {length} m, {mass} kg: {error:.1e}", method.name());
        }
    }
}

#[test]
fn invariant_solver_does_not_depend_on_units() {
    for (length, mass) in [(1e-6, 1.0), (1.0, 1.0), (1e6, 1.0), (1.0, 1e-9), (1.0, 1e9)] {
        let scene = scaled(length, mass);
        assert!(system_of(&scene, Backend::Auto).unwrap().uses_elimination(), "{length} m, {mass} kg");
    }
}

/// Roots of masses may be 1e12 apart.
#[test]
fn invariant_levers_and_masses_too_far_apart_are_not_eliminated() {
    let heavy = |m3| four_bar::Turning { m3, ..scaled(1.0, 1.0) };
    assert!(system_of(&heavy(1e22), Backend::Generated).is_ok());
    for m3 in [1e26, 1e120] {
        let scene = heavy(m3);
        assert!(!system_of(&scene, Backend::Auto).unwrap().uses_elimination(), "{m3} kg");
        let Err(error) = system_of(&scene, Backend::Generated) else { panic!("{m3} kg") };
        assert!(error.to_string().contains("too far apart for the generated backend"), "{error}");
    }
}

/// Fourth powers of 1e90 are no doubles; the roots of masses are taken from 1e-50 on.
#[test]
fn invariant_masses_whose_powers_are_no_doubles_are_not_eliminated() {
    for (mass, eliminated) in [(1e-180, false), (1e-102, false), (1e-98, true), (1e180, false)] {
        let scene = scaled(1.0, mass);
        assert_eq!(system_of(&scene, Backend::Auto).unwrap().uses_elimination(), eliminated, "{mass} kg");
        assert_eq!(system_of(&scene, Backend::Generated).is_ok(), eliminated, "{mass} kg");
    }
}

/// 1e-170 m squared is zero.
#[test]
fn invariant_inertia_that_underflows_is_none() {
    let scene = Swing { l: 1e-170, ..Swing::default() };
    let system = system_of(&scene, Backend::Auto).unwrap();
    assert!(system.mass_matrix()[2] == 0.0 && !system.uses_elimination(), "{:?}", system.mass_matrix());
}

/// A start whose bars are 1e-6 apart relative to their lengths is refused in any unit.
#[test]
fn invariant_gap_counts_relative_to_the_bars() {
    for length in [1e-6, 1e-3, 1.0, 1e3] {
        let scene = scaled(length, 1.0);
        let run = |gap: f64| {
            let (x, y) = (0.5 * length * 1.0_f64.cos() + gap * length, 0.5 * length * 1.0_f64.sin());
            simulation(&scene).until(0.0).start("crank.x", x).start("crank.y", y).start("crank.phi", 1.0).run()
        };
        assert!(run(0.0).is_ok(), "{length} m: {}", run(0.0).err().map_or_else(String::new, |e| e.to_string()));
        assert!(run(1e-7).is_err(), "{length} m");
    }
}

/// Only massless trucks need the pivoted solver.
#[test]
fn invariant_shipped_scenes_with_masses_are_eliminated() {
    for entry in MODELS.iter().flat_map(|model| model.scenes) {
        let scene = (entry.new)();
        let system = system_of(&*scene, Backend::Auto).unwrap();
        let has_masses = system.mass_matrix().iter().all(|m| *m > 0.0);
        let eliminated = system.uses_elimination() || !scene.info().has_elimination();
        assert!(eliminated || !has_masses, "{} {}", scene.info().model, scene.info().name);
    }
}

#[test]
fn regress_short_levers_take_no_more_projections() {
    // angles of levers below a millimetre move a thousand times as much as points, and no constraint is nearly redundant
    let factorizations = |length: f64| {
        let scene = scaled(length, 1.0);
        let run = simulation(&scene).method(Method::rk4(1e-3)).until(0.5).run().unwrap();
        assert!(run.outcome.reached_end(), "{length} m: {}", run.outcome);
        run.cost.factorizations
    };
    let usual = factorizations(1.0);
    for length in [1e-4, 1e-6] {
        let n = factorizations(length);
        assert!(n <= usual, "{length} m: {n} factorisations, {usual} of lengths of a metre");
    }
}
