//! Starts that are given in part.

use crate::scenes::{Case, all, coast, driven};
use ezy_core::dynamics::StartError;
use ezy_core::model::Start;
use ezy_core::prelude::*;
use ezy_core::simulate::SetupError;
use ezy_core_tests::{simulation, system_of};
use ezy_models::mechanisms::{chain::chain, slider_crank::slider_crank};
use ezy_models::registry::MODELS;
use ezy_tests::shapes::{circling, four_bar, tethered};

/// What the assembly promises.
const RESIDUAL: f64 = 1e-12;
/// Rounding of a mass-weighted product of velocities of order one.
const ORTHOGONAL: f64 = 1e-12;

/// What a scene declares is what its system begins with, for every scene.
#[test]
fn cross_declared_starts_are_those_of_systems() {
    let entries: Vec<_> = MODELS.iter().flat_map(|model| model.scenes).collect();
    assert!(entries.len() > 40, "{}", entries.len());
    for entry in entries {
        let scene = (entry.new)();
        let system = system_of(&*scene, Backend::Auto).unwrap();
        assert_eq!(Start::declared(&*scene).unwrap(), system.scene_start(), "{}", entry.name);
    }
}

#[test]
fn invariant_start_holds_given_values_to_the_bit() {
    for Case { route, scene } in coast() {
        let given = [("seat.x", 0.123456789), ("seat.phi", 0.77), ("bar.phi", -2.1), ("seat.omega", 0.3)];
        let mut order = simulation(&*scene).until(0.0);
        for (name, value) in given {
            order = order.start(name, value);
        }
        // the scene's own velocity along x would slip the rear wheel sideways at this heading
        let (s, c) = 0.77_f64.sin_cos();
        let run = order.start("seat.vx", c - 0.06 * s).start("seat.vy", s + 0.06 * c).run().unwrap();
        for (name, value) in given {
            assert_eq!(run.first().get(name), Ok(value), "{route}: {name}");
        }
        assert!(run.first().position_residual <= RESIDUAL, "{route}");
        assert!(run.first().velocity_residual <= RESIDUAL, "{route}");
    }
}

#[test]
fn invariant_consistent_start_is_not_touched() {
    for Case { route, scene } in all() {
        let mut system = system_of(&*scene, Backend::Auto).unwrap();
        let state = system.consistent_start(&system.scene_start()).unwrap();
        let mut free = Start::free(state.q.len());
        free.q.copy_from_slice(&state.q);
        free.v.copy_from_slice(&state.v);
        let again = system.consistent_start(&free).unwrap();
        assert_eq!((&again.q, &again.v), (&state.q, &state.v), "{route}");
    }
}

#[test]
fn invariant_start_assembles_angles_from_a_far_guess() {
    for Case { route, scene } in driven() {
        let mut system = system_of(&*scene, Backend::Auto).unwrap();
        let mut start = Start::free(6);
        for (i, value) in [(0, 0.0), (1, 0.0), (3, -0.3), (4, 0.55)] {
            start.give_position(i, value);
        }
        let state = system.consistent_start(&start).unwrap();
        assert!(system.position_residual(state.t, &state.q) <= RESIDUAL, "{route}");
        assert_eq!([state.q[0], state.q[1], state.q[3], state.q[4]], [0.0, 0.0, -0.3, 0.55], "{route}");
    }
}

/// The assembled velocity is the one of least kinetic energy: orthogonal in M to every free motion, in particular to
/// its own difference from another consistent velocity with the same given values.
#[test]
fn analytic_assembled_velocities_have_least_energy() {
    for Case { route, scene } in driven() {
        let mut system = system_of(&*scene, Backend::Auto).unwrap();
        let mut start = system.scene_start();
        start.give_velocity(5, 1.0);
        let least = system.consistent_start(&start).unwrap();
        start.v[0] = 0.4;
        let other = system.consistent_start(&start).unwrap();
        assert_ne!(least.v, other.v, "{route}: another guess, another motion");
        let product: f64 = (0..6).map(|i| system.mass_matrix()[i] * least.v[i] * (other.v[i] - least.v[i])).sum();
        assert!(product.abs() <= ORTHOGONAL, "{route}: {product:.1e}");
    }
}

#[test]
fn invariant_start_assembles_massless_bodies() {
    for Case { route, mut scene } in coast() {
        crate::scenes::set(&mut *scene, &[("m2", 0.0), ("i2", 0.0)]);
        let run = simulation(&*scene).until(0.0).run().unwrap();
        let error = (run.first().velocities[5] - 5.0).abs();
        assert!(error <= RESIDUAL, "{route}: {error:.1e}");
    }
}

#[test]
fn invariant_contradicting_positions_are_named() {
    for Case { route, scene } in coast() {
        // the hinge is at 0.8 m, the bar's centre cannot be a metre away
        let error = simulation(&*scene).start("bar.x", 1.8).run().unwrap_err();
        let SetupError::Start(StartError::Contradiction { level, rows, residual, held, .. }) = error else {
            panic!("{route}: {error}")
        };
        assert_eq!(level, "position", "{route}");
        assert_eq!(rows, ["B.x"], "{route}");
        assert!((residual - 1.0).abs() <= RESIDUAL, "{route}: {residual}");
        assert_eq!(held, ["seat.x", "seat.y", "seat.phi", "bar.x", "bar.phi"], "{route}");
    }
}

#[test]
fn invariant_contradicting_velocities_are_named() {
    for Case { route, scene } in coast() {
        // the rear wheel cannot slide sideways
        let error = simulation(&*scene).start("seat.vy", 0.5).run().unwrap_err();
        let SetupError::Start(StartError::Contradiction { level, rows, .. }) = error else {
            panic!("{route}: {error}")
        };
        assert_eq!((level, &*rows[0]), ("velocity", "rear"), "{route}");
    }
}

#[test]
fn invariant_start_value_that_is_not_finite_is_named() {
    for Case { route, scene } in coast() {
        let error = simulation(&*scene).start("bar.vx", f64::NAN).run().unwrap_err().to_string();
        assert!(error.contains("`bar.vx` is NaN"), "{route}: {error}");
    }
}

/// From 1e9 on rounding is 1e-7, of metres and of radians.
#[test]
fn invariant_start_value_beyond_a_billion_is_refused_by_name() {
    let start =
        |x: f64| simulation(&ezy_models::knife_edge::Cycloid::default()).until(0.0).start("blade.omega", x).run();
    assert!(start(5e8).is_ok());
    let error = start(5e9).unwrap_err();
    assert!(matches!(&error, SetupError::Start(StartError::TooLarge { name, .. }) if name == "blade.omega"), "{error}");
}

/// Assembles all coordinates from zero, except for those given by index.
fn from_zero(mut scene: impl Scene, parameters: &[(&str, f64)], given: &[(usize, f64)]) -> State {
    crate::scenes::set(&mut scene, parameters);
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    let mut start = Start::free(scene.info().n_coordinates());
    given.iter().for_each(|(i, value)| start.give_position(*i, *value));
    let state = system.consistent_start(&start).unwrap_or_else(|error| panic!("{error}"));
    assert!(system.position_residual(state.t, &state.q) <= RESIDUAL, "{:?}", state.q);
    given.iter().for_each(|(i, value)| assert_eq!(state.q[*i], *value));
    state
}

#[test]
fn invariant_start_leaves_the_symmetry_of_a_rod() {
    let state = from_zero(tethered::Circle::default(), &[], &[(0, 0.5)]);
    assert!((state.q[1].abs() - 0.75_f64.sqrt()).abs() <= 2.0 * RESIDUAL, "{:?}", state.q);
    from_zero(tethered::Circle::default(), &[], &[]);
    from_zero(circling::Round::default(), &[], &[]);
}

#[test]
fn invariant_start_leaves_the_symmetry_of_flat_loops() {
    let bars = [("base", 2.0), ("crank_length", 1.0), ("coupler_length", 2.0), ("rocker_length", 1.5)];
    from_zero(four_bar::Coast::default(), &bars, &[(2, 0.0)]);
    let bars = [("r", 1.0), ("l", 2.0), ("l_centre", 2.0)];
    from_zero(slider_crank::Falling::default(), &bars, &[(3, 2.0)]);
}

/// Of a hundred hinges, each within 8 ε of 333 km.
const FAR: f64 = 1e-7;

/// The guess has all rods at zero; the last one ends up where rounding is larger than 1e-12 m.
#[test]
fn invariant_start_far_from_the_guess_counts_rounding_there() {
    let mut scene = chain::Swing::default();
    scene.set_count(0, 100);
    crate::scenes::set(&mut scene, &[("l", 3333.1)]);
    let run = simulation(&scene).until(0.0).run().unwrap();
    let error = run.last().coordinates[3 * 99] - 99.5 * 3333.1;
    assert!(error.abs() <= FAR, "{error:.1e}");
}

#[test]
fn invariant_row_without_a_value_is_named() {
    let mut scene = tethered::Circle::default();
    crate::scenes::set(&mut scene, &[("l", 0.0)]);
    let error = simulation(&scene).start("bob.x", 0.0).start("bob.y", 0.0).run().unwrap_err().to_string();
    assert!(
        error.starts_with("constraint `R` is not a number at the start: a length or a direction in it is zero"),
        "{error}"
    );
    let error = simulation(&scene).run().unwrap_err().to_string();
    assert!(error.starts_with("constraint `R` is not a number at the start"), "{error}");
}

#[test]
fn invariant_near_values_that_fit_are_kept_to_the_last_bit() {
    let run = simulation(&ezy_models::slider_crank::Pushed::default()).until(0.0).run().unwrap();
    assert_eq!(run.last().get("rod.phi").unwrap(), -std::f64::consts::PI / 6.0);
}

#[test]
fn analytic_near_values_choose_the_assembly_and_give_way() {
    // a crank upright of 1 m, a coupler of 1 m to the right, and the base longer than it was
    let scene = ezy_models::four_bar::Turning { base: 1.2, ..Default::default() };
    let run = simulation(&scene).until(0.0).run().unwrap();
    let get = |name: &str| run.last().get(name).unwrap();
    assert_eq!(get("crank.phi"), std::f64::consts::FRAC_PI_2);
    // the open loop: coupler and rocker meet at the same height above the base, on the right of the crank
    let (reach, height) = (2.0 * (get("coupler.x")), 2.0 * (get("coupler.y") - 1.0) + 1.0);
    assert!((reach - 1.2).hypot(height) - 1.0 <= 1e-12 && height > 0.5 && reach > 0.9, "({reach}, {height})");
}

#[test]
fn analytic_near_values_give_way_to_what_is_given() {
    let scene = ezy_models::pendulum::Swing::default();
    let run = simulation(&scene).start("bob.x", 0.5).until(0.0).run().unwrap();
    let angle = run.last().get("bob.phi").unwrap();
    assert!((angle.cos() - 0.5).abs() <= 1e-12, "{angle} rad");
}
