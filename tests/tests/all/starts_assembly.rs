//! Assembly from disturbed values: rounding is reached, and elbows stay on their side.

use ezy_core::model::Start;
use ezy_core::prelude::*;
use ezy_core_tests::system_of;
use ezy_models::mechanisms::pendulum::pendulum;
use ezy_models::mechanisms::{
    andrews::andrews, four_bar::four_bar, n_four_bar::n_four_bar, slider_crank::slider_crank,
};
use std::f64::consts::PI;

/// What an assembly of bodies of size one leaves of a hinge, m.
const GAP: f64 = 1e-13;
/// Moves of 1e-3 m and rad change nothing by more, also where they are a seventh of a crank.
const CHANGE: f64 = 5e-3;

fn assembled(scene: &dyn Scene) -> Vec<f64> {
    let mut system = system_of(scene, Backend::Auto).unwrap();
    system.consistent_start(&system.scene_start()).unwrap().q
}

/// Assembles from `q`, which gives way; returns the positions and their gap.
fn reassembled(scene: &dyn Scene, q: &[f64]) -> (Vec<f64>, f64) {
    let mut start = Start::free(q.len());
    q.iter().enumerate().for_each(|(i, x)| start.near_position(i, *x));
    let mut system = system_of(scene, Backend::Auto).unwrap();
    let state = system.consistent_start(&start).unwrap();
    let gap = system.position_residual(0.0, &state.q);
    (state.q, gap)
}

/// Moved by 1e-3 with alternating signs.
fn moved(q: &[f64]) -> Vec<f64> {
    q.iter().enumerate().map(|(i, x)| if i % 2 == 0 { x + 1e-3 } else { x - 1e-3 }).collect()
}

#[test]
fn invariant_moved_mechanisms_are_assembled_to_rounding_nearby() {
    let ten = n_four_bar::Fall { n: 10, ..Default::default() };
    let cases: [(&str, Box<dyn Scene>); 4] = [
        ("pendulum", Box::new(pendulum::Swing::default())),
        ("two loops", Box::new(n_four_bar::Fall::default())),
        ("ten loops", Box::new(ten)),
        ("andrews", Box::new(andrews::Squeeze::default())),
    ];
    for (name, scene) in cases {
        let q = moved(&assembled(&*scene));
        let (found, gap) = reassembled(&*scene, &q);
        let change = crate::scenes::distance(&found, &q);
        assert!(gap <= GAP && change <= CHANGE, "{name}: gap {gap:.1e} m, change {change:.1e}");
    }
}

/// At the flat positions, where the rows lose a rank and the search converges by halves.
#[test]
fn invariant_flat_parallelograms_are_assembled() {
    let scene = four_bar::Turning::default();
    let right = [0.5, 0.0, 0.0, 1.5, 0.0, 0.0, 1.5, 0.0, 0.0];
    let left = [-0.5, 0.0, PI, -0.5, 0.0, 0.0, 0.5, 0.0, PI];
    for flat in [right, left] {
        let (q, gap) = reassembled(&scene, &moved(&flat));
        let change = crate::scenes::distance(&q, &moved(&flat));
        assert!(gap <= GAP && change <= CHANGE, "gap {gap:.1e} m, change {change:.1e}");
    }
}

/// Numbers between −1 and 1 that look random.
struct Noise(u64);

impl Noise {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

/// Angles are guessed this far off, rad: at the narrowest elbow, of Andrews' mechanism, up to its other side.
const GUESS: f64 = 0.3;

/// Guesses angles at random and looks whether the second body of each elbow is still to the same side of the first.
fn assert_elbows_stay(scene: &impl Scene, elbows: &[(usize, usize)], n_guesses: usize) {
    let q = assembled(scene);
    let sides = |q: &[f64]| elbows.iter().map(|(a, b)| (q[3 * b + 2] - q[3 * a + 2]).sin() > 0.0).collect::<Vec<_>>();
    let mut noise = Noise(1);
    for _ in 0..n_guesses {
        let mut guess = q.clone();
        guess.iter_mut().skip(2).step_by(3).for_each(|angle| *angle += GUESS * noise.next());
        let (found, gap) = reassembled(scene, &guess);
        assert!(gap <= GAP, "{gap:.1e} m");
        assert_eq!(sides(&found), sides(&q), "{guess:?}");
    }
}

#[test]
fn invariant_elbows_of_a_four_bar_stay_on_their_side() {
    let scene = four_bar::Turning { base: 1.3, l2: 1.4, l3: 1.2, ..Default::default() };
    assert_elbows_stay(&scene, &[(0, 1), (1, 2)], 50);
}

#[test]
fn invariant_elbow_of_a_slider_crank_stays_on_its_side() {
    assert_elbows_stay(&slider_crank::Falling::default(), &[(0, 1)], 50);
}

#[test]
fn invariant_elbows_of_three_loops_stay_on_their_side() {
    assert_elbows_stay(&andrews::Squeeze::default(), &[(1, 2), (1, 3), (1, 5), (3, 4), (5, 6)], 10);
}
