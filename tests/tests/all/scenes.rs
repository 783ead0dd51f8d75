//! The scenes that the tests run over.

use ezy_core::model::Scene;
use ezy_core::prelude::{Backend, State};
use ezy_core::testing::{GivenSteps, StepsBy, check_scene};
use ezy_core_tests::system_of;
use ezy_models::ezy_roller;
pub use ezy_tests::garage::set;
use ezy_tests::hand_roller::HandRoller;

/// A scene under test, with the route by which its equations were made.
pub struct Case {
    pub route: &'static str,
    pub scene: Box<dyn Scene>,
}

/// The coasting EzyRoller by every route.
pub fn coast() -> Vec<Case> {
    vec![
        Case { route: "hand", scene: Box::new(HandRoller::coast()) },
        Case { route: "generated", scene: Box::new(ezy_roller::Coast::default()) },
    ]
}

/// The driven EzyRoller by every route.
pub fn driven() -> Vec<Case> {
    vec![
        Case { route: "hand", scene: Box::new(HandRoller::driven()) },
        Case { route: "generated", scene: Box::new(ezy_roller::Driven::default()) },
    ]
}

/// Both scenes by every route.
pub fn all() -> Vec<Case> {
    coast().into_iter().chain(driven()).collect()
}

/// Largest difference of two vectors.
pub fn distance(x: &[f64], y: &[f64]) -> f64 {
    assert_eq!(x.len(), y.len());
    x.iter().zip(y).map(|(x, y)| (x - y).abs()).fold(0.0, |m, d| if d > m || d.is_nan() { d } else { m })
}

/// The checks that a user runs on a scene.
pub fn assert_checks(scene: &dyn Scene) {
    if let Err(error) = check_scene(scene) {
        panic!("{error}");
    }
}

/// One step of the classical Runge–Kutta method for y' = `slope`(t, y), apart from that of EZY.
pub fn rk4<const N: usize>(slope: impl Fn(f64, &[f64; N]) -> [f64; N], t: f64, y: &[f64; N], h: f64) -> [f64; N] {
    let plus = |k: &[f64; N], h: f64| std::array::from_fn(|j| y[j] + h * k[j]);
    let k1 = slope(t, y);
    let k2 = slope(t + h / 2.0, &plus(&k1, h / 2.0));
    let k3 = slope(t + h / 2.0, &plus(&k2, h / 2.0));
    let k4 = slope(t + h, &plus(&k3, h));
    std::array::from_fn(|j| y[j] + h / 6.0 * (k1[j] + 2.0 * k2[j] + 2.0 * k3[j] + k4[j]))
}

/// The state after steps of these lengths from the start of a scene, without projection, and in the middle of the last one.
pub fn stepped(scene: &dyn Scene, by: StepsBy, lengths: impl IntoIterator<Item = f64>) -> [State; 2] {
    let mut system = system_of(scene, Backend::Auto).unwrap();
    let start = system.consistent_start(&system.scene_start()).unwrap();
    let mut steps = GivenSteps::new(system, start, by).expect("the scene has what the method needs");
    let mut end = None;
    for h in lengths {
        end = steps.step(h).unwrap().cloned();
        assert!(end.is_some(), "{by:?} does not converge with {h} s");
    }
    [end.expect("a step"), steps.middle().unwrap()]
}
