//! Whole runs against the reference trajectories.

use crate::scenes::{Case, coast, distance, driven, set};
use ezy_core::prelude::*;
use ezy_core_tests::simulation;
use ezy_tests::reference::{ReferenceSample, load};

/// RK4 at 0.1 ms over 1 s: the method leaves 1e-16, rounding of 1e4 steps less than 1e-12.
const COAST_POSITION: f64 = 1e-12;
/// RK4 at 1 ms over 60 s: 5.5e-12 by the fourth order of the method with projections, 5.5e-11 without.
const DRIVEN_POSITION: f64 = 2e-10;
/// The same for velocities: 1.7e-13 and 1.7e-12.
const DRIVEN_VELOCITY: f64 = 1e-11;
/// Multipliers follow velocities and angles, times stiffnesses of about 1e2.
const DRIVEN_MULTIPLIER: f64 = 1e-9;
/// Kinetic energy less work: the method's own, and rounding of 6e4 steps.
const DRIVEN_ENERGY: f64 = 1e-10;
/// RK4 at 0.05 ms with a time constant of 10 ms: (h/τ)⁴/120 over the transient is 5e-12 of the size of the motion.
const NEAR_SINGULAR: f64 = 1e-10;

/// RK4 at 5 ms over 600 s: 1.1e-7, by the fourth order of the method and a sensitivity that grows with t².
const LONG_POSITION: f64 = 2e-7;
/// The same for the kinetic energy: 4.1e-8 J.
const LONG_ENERGY: f64 = 1e-7;

/// The reference at the time of a sample.
fn reference_at(reference: &[ReferenceSample], t: f64) -> &ReferenceSample {
    reference.iter().find(|r| (r.t - t).abs() < 1e-9).expect("a reference at the time of the sample")
}

#[test]
fn reference_coast_at_one_second() {
    let reference = load("ezyroller_coast");
    for Case { route, scene } in coast() {
        let run = simulation(&*scene).method(Method::rk4(1e-4)).every(0.1).run().unwrap();
        assert_eq!(run.samples().len(), reference.len(), "{route}");
        for (s, r) in run.samples().zip(&reference) {
            let error = distance(s.coordinates, &r.q);
            assert!(error <= COAST_POSITION, "{route}: |dq| = {error:.2e} at {} s", r.t);
        }
        assert_eq!(run.last().t, 1.0);
    }
}

#[test]
fn reference_driven_at_all_samples() {
    let reference = load("ezyroller_driven");
    for Case { route, scene } in driven() {
        let run = simulation(&*scene).work().method(Method::rk4(1e-3)).every(5.0).run().unwrap();
        for s in run.samples() {
            let r = reference_at(&reference, s.t);
            for (what, error, bar) in [
                ("|dq|", distance(s.coordinates, &r.q), DRIVEN_POSITION),
                ("|dv|", distance(s.velocities, &r.v), DRIVEN_VELOCITY),
                ("|dlambda|", distance(s.multipliers, &r.lambda), DRIVEN_MULTIPLIER),
                ("|dKE|", (s.energy.kinetic - r.kinetic).abs(), DRIVEN_ENERGY),
                ("|KE - W|", (s.energy.kinetic - s.energy.work).abs(), DRIVEN_ENERGY),
            ] {
                assert!(error <= bar, "{route}: {what} = {error:.2e} at {} s", s.t);
            }
        }
        assert_eq!(run.last().t, 60.0);
    }
}

#[test]
fn reference_near_singular_at_all_samples() {
    let reference = load("ezyroller_near_singular");
    for Case { route, mut scene } in coast() {
        set(&mut *scene, &[("b", -0.19), ("d", -0.09)]);
        // wheel A rolls at -1 m/s while the seat turns at 0.02 rad/s
        let run = simulation(&*scene)
            .method(Method::rk4(5e-5))
            .until(0.5)
            .every(0.05)
            .start("seat.x", 0.0)
            .start("bar.phi", 0.05)
            .start("seat.vx", -1.0)
            .start("seat.vy", 0.2 * 0.02)
            .start("seat.omega", 0.02)
            .run()
            .unwrap();
        assert_eq!(run.samples().len(), reference.len());
        for (s, r) in run.samples().zip(&reference) {
            let error = distance(s.coordinates, &r.q);
            assert!(error <= NEAR_SINGULAR, "{route}: |dq| = {error:.2e} at {} s", r.t);
        }
    }
}

#[test]
fn reference_driven_keeps_gaining_speed_for_ten_minutes() {
    let reference = load("ezyroller_driven_long");
    for Case { route, scene } in driven() {
        let run = simulation(&*scene).method(Method::rk4(5e-3)).until(600.0).every(60.0).run().unwrap();
        assert_eq!(run.samples().len(), reference.len(), "{route}");
        for (s, r) in run.samples().zip(&reference) {
            let (position, energy) = (distance(s.coordinates, &r.q), (s.energy.kinetic - r.kinetic).abs());
            assert!(position <= LONG_POSITION, "{route}: |dq| = {position:.2e} at {} s", s.t);
            assert!(energy <= LONG_ENERGY, "{route}: |dKE| = {energy:.2e} at {} s", s.t);
        }
    }
}
