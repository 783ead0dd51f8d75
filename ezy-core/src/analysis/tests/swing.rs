//! Modes as motions that are shown: what holds for every one of them, and closed forms.

use crate::analysis::{Linearization, Mode, SteadyMotion, Swing};
use crate::dynamics::system_of;
use crate::linalg::Backend;
use crate::model::Scene;
use std::f64::consts::TAU;

crate::model! {
    /// A rod on a pin on a cart with a spring and a damper, and a current that nothing feels.
    pub model Crane {
        param m_cart: kg = 3; param m: kg = 2; param i: kg*m^2 = 0.1; param l: m = 0.5; param g: m/s^2 = 9.81;
        param k: N/m = 40; param c: N*s/m = 2;
        state current: A = 0 rate -5/(1 s)*current;
        body cart { mass: m_cart, inertia: 1 }
        body rod { mass: m, inertia: i }
        slider rail: ground(0, 0) ~ cart(0, 0) along ground(1, 0);
        hinge pin: cart(0.1, 0.2) ~ rod(-l, 0);
        gravity (0, -g);
        force at cart(0, 0): (-k*cart.x - c*cart.vx, 0);
        start hanging { rod angle -pi/2; at rest; }
        start standing { rod angle pi/2; at rest; }
        scene hangs { start hanging; until 1 s; }
        scene stands { start standing; until 1 s; }
    }
}

/// Coordinates of the rod and the cart: x, y, φ of each.
const N: usize = 6;
/// Of values that are computed in a few operations.
const ROUNDING: f64 = 1e-14;
/// Ratio of gaps at an amplitude and at half of it is four; the third order of the amplitude leaves its own share of that, on both sides.
const THIRD_ORDER: f64 = 8.0;

fn modes(scene: &dyn Scene) -> (SteadyMotion, Vec<Mode>) {
    let mut system = system_of(scene, Backend::Auto).unwrap();
    let start = system.scene_start();
    let rest = SteadyMotion::near(&mut system, &start, &[]).unwrap();
    let linear = Linearization::of(&mut system, &rest).unwrap();
    let modes = linear.modes(&linear.spectrum().unwrap()).unwrap();
    assert_eq!(modes.len(), 5);
    (rest, modes)
}

/// Between the points of cart and rod that the pin holds together, m.
fn gap(q: &[f64], l: f64) -> f64 {
    let point = |q: &[f64], x: f64, y: f64| {
        let (sin, cos) = q[2].sin_cos();
        [q[0] + x * cos - y * sin, q[1] + x * sin + y * cos]
    };
    let [a, b] = [point(&q[..N / 2], 0.1, 0.2), point(&q[N / 2..], -l, 0.0)];
    f64::hypot(a[0] - b[0], a[1] - b[1])
}

/// The hinge stays together up to l a²/2 of the angle: the gap falls by four with half the amplitude, at every time.
#[test]
fn order_swing_keeps_hinges_together_to_second_order() {
    let crane::Hangs { l, .. } = crane::Hangs::default();
    let scenes: [&dyn Scene; 2] = [&crane::Hangs::default(), &crane::Stands::default()];
    for (motion, modes) in scenes.map(modes) {
        for mode in &modes {
            let swing = Swing::new(&motion, mode);
            let Some(whole) = swing.visible_amplitude(l) else { continue };
            for step in 0..8 {
                let t = swing.period_s() * f64::from(step) / 8.0 + 0.01 * swing.period_s();
                let at = |share: f64| swing.at(share * whole, t);
                let angle = (at(1.0).q[5] - motion.state.q[5]).abs();
                let [full, half] = [1.0, 0.5].map(|share| gap(&at(share).q, l));
                // ½ l φ² where the pin turns, and no more
                assert!(full <= 0.5 * l * angle * angle + ROUNDING, "{full}, {angle}");
                assert!(full >= (0.5 - angle * angle) * l * angle * angle - ROUNDING, "{full}, {angle}");
                let off = THIRD_ORDER * angle * full;
                assert!((full - 4.0 * half).abs() <= off + ROUNDING, "{full}, {half}, {angle}");
            }
        }
    }
}

/// Closed over its period, a quarter of it later the imaginary part, and what moves most begins at its amplitude.
#[test]
fn invariant_swing_is_its_mode_and_comes_back() {
    let (motion, modes) = modes(&crane::Hangs::default());
    let [oscillating, real] = [true, false].map(|of| {
        let found = modes.iter().find(|mode| Swing::new(&motion, mode).oscillates() == of);
        found.expect("a pair and the current")
    });
    let swing = Swing::new(&motion, oscillating);
    assert!((swing.period_s() * oscillating.frequency_hz() - 1.0).abs() <= ROUNDING);
    let a = 0.03;
    let deviation = |state: &crate::dynamics::State| -> Vec<f64> {
        let now = state.q.iter().chain(&state.v).chain(&state.z);
        let then = motion.state.q.iter().chain(&motion.state.v).chain(&motion.state.z);
        now.zip(then).map(|(x, x_0)| x - x_0).collect()
    };
    // velocities are larger than coordinates by the frequency
    let size = 1.0 + oscillating.eigenvalue.norm();
    // Re(d exp(i ω t)) by the product of complex numbers, on both members of the pair
    for mode in modes.iter().filter(|mode| Swing::new(&motion, mode).oscillates()) {
        let swing = Swing::new(&motion, mode);
        for t in [0.0, 0.1, 0.7] {
            let turn = nalgebra::Complex::new(0.0, mode.eigenvalue.im * t).exp();
            for (found, exact) in deviation(&swing.at(a, t)).iter().zip(&mode.deviation) {
                assert!((found - a * (exact * turn).re).abs() <= 10.0 * ROUNDING * size, "{found} for {exact}, {t}");
            }
        }
    }
    let [first, last] = [0.0, swing.period_s()].map(|t| deviation(&swing.at(a, t)));
    assert!(first.iter().zip(&last).all(|(first, last)| (first - last).abs() <= ROUNDING * size));
    assert!((first[oscillating.largest[0]] - a).abs() <= ROUNDING);
    let swing = Swing::new(&motion, real);
    assert!((swing.period_s() * real.eigenvalue.norm() / TAU - 1.0).abs() <= ROUNDING);
    let [first, half, last] = [0.0, 0.5, 1.0].map(|share| deviation(&swing.at(a, share * swing.period_s())));
    assert!(first.iter().chain(&last).all(|x| x.abs() <= ROUNDING) && (half[real.largest[0]] - a).abs() <= ROUNDING);
}

/// 0.2 rad where the mechanism is large, a tenth of it where it is small.
#[test]
fn analytic_swing_is_as_large_as_is_seen() {
    let (motion, modes) = modes(&crane::Hangs::default());
    let mode = modes.iter().find(|mode| Swing::new(&motion, mode).oscillates()).unwrap();
    let swing = Swing::new(&motion, mode);
    let largest = |of: &[usize]| of.iter().map(|place| mode.deviation[*place].norm()).fold(0.0, f64::max);
    let [angle, length] = [largest(&[2, 5]), largest(&[0, 1, 3, 4])];
    let seen = |size_m: f64| swing.visible_amplitude(size_m).unwrap();
    assert!((seen(1e3) * angle / 0.2 - 1.0).abs() <= ROUNDING && (seen(1e-3) * length / 1e-4 - 1.0).abs() <= ROUNDING);
}

/// The eigenvalue −5/s of the current.
#[test]
fn invariant_mode_of_a_state_alone_moves_no_body() {
    let (motion, modes) = modes(&crane::Hangs::default());
    let mode = modes.iter().find(|mode| (mode.eigenvalue + 5.0).norm() <= 1e-9).unwrap();
    assert!(Swing::new(&motion, mode).visible_amplitude(1.0).is_none(), "{mode:?}");
}
