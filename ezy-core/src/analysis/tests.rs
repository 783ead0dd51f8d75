//! Against closed forms.

mod edges;
mod one_sided;
mod row_space;
mod swing;
mod transfer;

use super::{AnalysisError, Course, Instability, Linearization, Locus, Monodromy, Rests, Spectrum, SteadyMotion};
use crate::dynamics::State;
use crate::dynamics::system_of;
use crate::linalg::Backend;
use nalgebra::DMatrix;

crate::model! {
    /// A rod on a pin, with friction in it.
    pub model Rod {
        param l: m = 0.5; param m: kg = 2; param i: kg*m^2 = 0.1; param g: m/s^2 = 9.81; param c: N*m*s = 0.3;
        input torque: N*m = 0;
        body rod { mass: m, inertia: i }
        hinge pin: ground(0, 0) ~ rod(-l, 0);
        torsion ground ~ rod: stiffness 0, angle 0, damping c;
        torque rod: torque;
        gravity (0, -g);
        output angle: rad = rod.phi;
        start hanging { rod angle -1.2; at rest; }
        start standing { rod angle 1.3; at rest; }
        scene hangs { start hanging; until 1 s; }
        scene stands { start standing; until 1 s; }
    }
}

/// φ'' = −(c φ' ± m g l sin φ)/(i + m l²) from the lower position, and from the upper one.
#[test]
fn analytic_rod_hangs_and_stands() {
    let (l, m, i, g, c) = (0.5, 2.0, 0.1, 9.81, 0.3);
    let inertia: f64 = i + m * l * l;
    let (delta, omega2) = (c / (2.0 * inertia), m * g * l / inertia);
    let scenes: [(&dyn crate::model::Scene, f64); 2] = [(&rod::Hangs::default(), -1.0), (&rod::Stands::default(), 1.0)];
    for (scene, side) in scenes {
        let mut system = system_of(scene, Backend::Auto).unwrap();
        let start = system.scene_start();
        let rest = SteadyMotion::near(&mut system, &start, &[]).unwrap();
        assert!((rest.state.q[2] - side * std::f64::consts::FRAC_PI_2).abs() <= 1e-13, "{rest:?}");
        assert!(rest.free.is_empty(), "{:?}", rest.free);
        assert!((rest.multipliers[1].abs() - m * g).abs() <= 1e-12, "{rest:?}");
        let linear = Linearization::of(&mut system, &rest).unwrap();
        let spectrum = linear.spectrum().unwrap();
        let root = nalgebra::Complex::new(delta * delta + side * omega2, 0.0).sqrt();
        for (found, exact) in spectrum.eigenvalues.iter().zip([root - delta, -root - delta]) {
            assert!((found - exact).norm() <= 1e-12 * omega2, "{found} for {exact}");
        }
        assert_eq!((spectrum.n_zero, spectrum.n_unstable()), (0, usize::from(side > 0.0)));
        // a constant torque turns it by 1/stiffness
        assert_eq!(linear.inputs, ["torque"]);
        let gain = linear.response(nalgebra::Complex::new(0.0, 0.0)).unwrap()[(0, 0)];
        assert!((gain.re + side / (m * g * l)).abs() <= 1e-12 && gain.im == 0.0, "{gain}");
    }
}

/// Without friction the eigenvalues of the hanging rod are on the axis, and rounding is no instability.
#[test]
fn analytic_rod_without_friction_is_neutral() {
    let scene = rod::Hangs { c: 0.0, ..rod::Hangs::default() };
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    let start = system.scene_start();
    let rest = SteadyMotion::near(&mut system, &start, &[]).unwrap();
    let spectrum = Linearization::of(&mut system, &rest).unwrap().spectrum().unwrap();
    assert_eq!((spectrum.eigenvalues.len(), spectrum.n_unstable()), (2, 0), "{spectrum:?}");
    assert_eq!(spectrum.n_neutral(), 2);
}

crate::model! {
    /// A block that a constant force pulls along a rail.
    pub model Pulled {
        param f: N = 3;
        body block { mass: 2, inertia: 1 }
        slider rail: ground(0, 0) ~ block(0, 0) along ground(1, 0);
        force at block(0, 0): (f, 0);
        start still { at rest; }
        start moving { block velocity (1, 0); }
        scene rests { start still; until 1 s; }
        scene runs { start moving; until 1 s; }
    }
}

/// Nothing balances the force: it is named, with its size.
#[test]
fn invariant_motion_that_is_not_steady_names_what_is_left() {
    let scenes: [&dyn crate::model::Scene; 2] = [&pulled::Rests::default(), &pulled::Runs::default()];
    for scene in scenes {
        let mut system = system_of(scene, Backend::Auto).unwrap();
        let start = system.scene_start();
        let error = SteadyMotion::near(&mut system, &start, &[]).unwrap_err();
        let AnalysisError::NotFound { what, left, unit, .. } = &error else { panic!("{error}") };
        assert!(what == "block.x" && (left - 3.0).abs() <= 1e-9 && *unit == "N", "{error}");
    }
    let scene = pulled::Rests { f: 0.0 };
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    let start = system.scene_start();
    assert_eq!(SteadyMotion::near(&mut system, &start, &[]).unwrap().free, ["block.x"]);
    let error = SteadyMotion::near(&mut system, &start, &["block.vx"]).unwrap_err();
    assert!(matches!(&error, AnalysisError::UnknownHeld { name, .. } if name == "block.vx"), "{error}");
}

crate::model! {
    /// A cart that a servo places, and a block on a spring to it.
    pub model Placed {
        input place: m = 0 by acceleration;
        input push: N = 0;
        body cart { mass: 1, inertia: 1 }
        body block { mass: 2, inertia: 1 }
        slider rail: ground(0, 0) ~ cart(0, 0) along ground(1, 0);
        slider guide: ground(0, 0) ~ block(0, 0) along ground(1, 0);
        constraint servo: cart.x = place;
        force at block(0, 0): (push - 8 N/m * (block.x - cart.x), 0);
        start still { at rest; }
        scene rests { start still; until 1 s; }
    }
}

/// The place moves the cart whatever forces are: B has no column for it, and one for the push.
#[test]
fn analytic_input_by_acceleration_is_no_input_of_the_linear_equations() {
    let scene = placed::Rests::default();
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    let start = system.scene_start();
    let rest = SteadyMotion::near(&mut system, &start, &[]).unwrap();
    let linear = Linearization::of(&mut system, &rest).unwrap();
    assert_eq!((&linear.inputs[..], linear.b.ncols(), linear.d.ncols()), (&["push"][..], 1, 1));
    let spectrum = linear.spectrum().unwrap();
    assert!((spectrum.eigenvalues[0].im - 2.0).abs() <= 1e-14, "{spectrum:?}");
}

crate::model! {
    /// A disk on a pin that turns evenly, with a weight on its edge that a spring to the ground pulls.
    pub model Turning {
        param k: N/m = 0;
        body disk { mass: 1, inertia: 1 }
        hinge pin: ground(0, 0) ~ disk(-1, 0);
        spring ground(5, 0) ~ disk(0, 0): stiffness k, length 1;
        start turns { disk angle 0 rate 2; }
        scene turns { start turns; until 1 s; }
    }
}

/// Seen from the turning frame the pin is at rest; a spring to a point of the ground is not.
#[test]
fn invariant_motion_that_turns_with_the_ground_is_not_steady() {
    let free = turning::Turns::default();
    let mut system = system_of(&free, Backend::Auto).unwrap();
    let start = system.scene_start();
    let motion = SteadyMotion::near(&mut system, &start, &[]).unwrap();
    assert!((motion.frame.omega - 2.0).abs() <= 1e-14 && motion.free.len() == 2, "{motion:?}");
    let spectrum = Linearization::of(&mut system, &motion).unwrap().spectrum().unwrap();
    assert_eq!((spectrum.n_zero, spectrum.zero_blocks), (2, vec![2]));
    // at this instant the spring points to the pin, and everything balances
    let scene = turning::Turns { k: 10.0 };
    let mut pulled = system_of(&scene, Backend::Auto).unwrap();
    let motion = SteadyMotion::near(&mut pulled, &start, &["disk.phi", "disk.omega"]).unwrap();
    let error = Linearization::of(&mut pulled, &motion).unwrap_err();
    assert!(matches!(error, AnalysisError::NotSteady { .. }), "{error}");
}

crate::model! {
    /// A wheel that rows stop at every half turn, with a spiral spring.
    pub model Wound {
        param k: N*m = 0.5;
        body wheel { mass: 1, inertia: 1 }
        hinge pin: ground(0, 0) ~ wheel(0, 0);
        constraint stop: sin(wheel.phi) = 0;
        torsion ground ~ wheel: stiffness k, angle 0, damping 0;
        start still { at rest; }
        scene rests { start still; until 1 s; }
    }
}

/// Half a turn to the left and to the right are the same place; the spring tells them apart.
#[test]
fn analytic_wound_spring_is_another_rest() {
    let pi = std::f64::consts::PI;
    for (k, expected) in [(0.5, &[-pi, 0.0, pi][..]), (0.0, &[0.0, pi])] {
        let scene = wound::Rests { k };
        let mut system = system_of(&scene, Backend::Auto).unwrap();
        let start = system.scene_start();
        let rests = Rests::of(&mut system, &start, &[], 40).unwrap();
        let angles: Vec<f64> = rests.found.iter().map(|rest| rest.motion.state.q[2]).collect();
        assert_eq!(angles.len(), expected.len(), "{angles:?}");
        for (found, exact) in angles.iter().zip(expected) {
            let left = if k == 0.0 { found.abs() - exact } else { found - exact };
            assert!(left.abs() <= 1e-12, "{angles:?}");
        }
        assert_eq!(rests.found.iter().map(|rest| rest.n_starts).sum::<usize>() + rests.n_lost, 40, "{rests:?}");
    }
}

/// Of a rod that rests anywhere on a table, one rest is told, at its start; what is held stays.
#[test]
fn invariant_rests_that_are_free_are_one() {
    let scene = pulled::Rests { f: 0.0 };
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    let mut start = system.scene_start();
    start.give_position(0, 0.7);
    for hold in [&[][..], &["block.x"]] {
        let rests = Rests::of(&mut system, &start, hold, 20).unwrap();
        let [rest] = &rests.found[..] else { panic!("{rests:?}") };
        assert_eq!((rest.n_starts, rest.motion.state.q[0], rest.motion.free.is_empty()), (20, 0.7, !hold.is_empty()));
    }
    let error = Rests::of(&mut system, &start, &["block.vx"], 20).unwrap_err();
    assert!(matches!(&error, AnalysisError::UnknownHeld { name, .. } if name == "block.vx"), "{error}");
}

#[test]
fn analytic_straight_motion_has_a_speed_and_a_circle_a_radius() {
    let [still, straight, turning]: [&dyn crate::model::Scene; 3] =
        [&pulled::Rests { f: 0.0 }, &pulled::Runs { f: 0.0 }, &turning::Turns::default()];
    let course = |scene| {
        let mut system = system_of(scene, Backend::Auto).unwrap();
        let start = system.scene_start();
        SteadyMotion::near(&mut system, &start, &[]).unwrap().course()
    };
    assert_eq!(course(still), Course::Rest);
    let Course::Straight { speed } = course(straight) else { panic!("{:?}", course(straight)) };
    assert!((speed - 1.0).abs() <= 1e-14);
    let Course::Circle { centre, turn_rate, speed, radius } = course(turning) else { panic!("{:?}", course(turning)) };
    let left = [centre[0], centre[1], turn_rate - 2.0, speed - 2.0, radius - 1.0];
    assert!(left.iter().all(|left| left.abs() <= 1e-14), "{left:?}");
}

/// n equal integrators are one block of n, whatever basis they are told in; the eigenvalues beside them stay sharp.
#[test]
fn analytic_chain_of_zeros_is_one_block() {
    let mut chain = DMatrix::zeros(6, 6);
    for i in 0..4 {
        chain[(i, i + 1)] = 1.0;
    }
    (chain[(4, 4)], chain[(5, 5)], chain[(5, 0)]) = (-3.0, 2.0, 1.0);
    let basis = DMatrix::from_fn(6, 6, |i, j| ((i * 7 + j * 3) as f64).sin() + if i == j { 3.0 } else { 0.0 });
    let inverse = basis.clone().try_inverse().unwrap();
    let spectrum = Spectrum::of(&(&basis * chain * inverse)).unwrap();
    assert_eq!((spectrum.n_zero, &spectrum.zero_blocks[..]), (4, &[4][..]), "{spectrum:?}");
    for (found, exact) in spectrum.eigenvalues.iter().zip([2.0, -3.0]) {
        assert!((found.re - exact).abs() <= 1e-11 && found.im == 0.0, "{spectrum:?}");
    }
    assert!(Spectrum::of(&DMatrix::from_element(1, 1, f64::NAN)).is_none());
}

/// A v = s v for every mode: of a damped rod, and of two equal oscillators, whose double eigenvalues have two eigenvectors each.
#[test]
fn invariant_modes_are_eigenvectors() {
    /// Of the norm of A: rounding of a solve.
    const RESIDUAL: f64 = 1e-14;
    let scene = rod::Hangs::default();
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    let start = system.scene_start();
    let rest = SteadyMotion::near(&mut system, &start, &[]).unwrap();
    let rod = Linearization::of(&mut system, &rest).unwrap();
    let mut twins = rod.clone();
    let mut a = DMatrix::zeros(4, 4);
    a.view_mut((0, 0), (2, 2)).copy_from(&rod.a);
    a.view_mut((2, 2), (2, 2)).copy_from(&rod.a);
    twins.basis = DMatrix::identity(6, 4);
    twins.a = a;
    for linear in [&rod, &twins] {
        let modes = linear.modes(&linear.spectrum().unwrap()).unwrap();
        assert_eq!(modes.len(), linear.a.nrows());
        for mode in &modes {
            let complex = linear.a.map(|x| nalgebra::Complex::new(x, 0.0));
            let left = complex * &mode.vector - &mode.vector * mode.eigenvalue;
            assert!(left.norm() <= RESIDUAL * linear.a.norm() * mode.vector.norm(), "{mode:?}");
            assert!((mode.deviation[mode.largest[0]] - 1.0).norm() <= 1e-15, "{mode:?}");
        }
        for pair in modes.chunks(2).filter(|_| modes.len() > 2) {
            let alike = pair[0].vector.dotc(&pair[1].vector).norm() / (pair[0].vector.norm() * pair[1].vector.norm());
            assert!(alike < 0.99, "one eigenvector in place of two: {modes:?}");
        }
    }
    // it turns about the pin, its centre half a metre above, of which it moves by half as many metres as it turns by radians
    let modes = rod.modes(&rod.spectrum().unwrap()).unwrap();
    assert_eq!(modes[0].largest, [2, 0], "{modes:?}");
    let (s, mode) = (modes[0].eigenvalue, &modes[0]);
    assert!((mode.damping_ratio() - (-s.re / s.norm())).abs() <= 1e-15 && mode.damping_ratio() > 0.0);
    assert!((s.re * -mode.doubling_time_s() + 2f64.ln()).abs() <= 1e-15, "{mode:?}");
    assert!((mode.frequency_hz() * std::f64::consts::TAU - s.im).abs() <= 1e-14, "{mode:?}");
}

/// x'' = −k x − c x' and a second one beside it.
fn oscillators(of: [[f64; 2]; 2]) -> Result<Spectrum, ()> {
    let mut a = DMatrix::zeros(4, 4);
    for (i, [k, c]) in of.into_iter().enumerate() {
        (a[(2 * i, 2 * i + 1)], a[(2 * i + 1, 2 * i)], a[(2 * i + 1, 2 * i + 1)]) = (1.0, -k, -c);
    }
    Spectrum::of(&a).ok_or(())
}

/// What crosses the axis where, by its kind, from both sides, at a value between and at a given one.
#[test]
fn analytic_locus_finds_critical_values() {
    /// Singular values below 1e-11 of the largest entry, 5, are those of zero: so far from the critical value 0.7 − x is no more seen; twice that.
    const CRITICAL: f64 = 1e-10;
    let omega = 2f64.sqrt();
    let oscillation = Instability::Oscillation { omega };
    let divergence = Instability::Divergence;
    type Critical = (f64, Instability, [usize; 2]);
    type Case<'a> = (&'a str, &'a [f64], fn(f64) -> [[f64; 2]; 2], &'a [Critical]);
    let cases: [Case<'_>; 6] = [
        ("flutter", &[3.0, 0.0, 1.0, 2.0], |x| [[2.0, 1.3 - x], [5.0, 1.0]], &[(1.3, oscillation, [0, 2])]),
        ("flutter that ends", &[0.0, 3.0], |x| [[2.0, x - 1.3], [5.0, 1.0]], &[(1.3, oscillation, [2, 0])]),
        ("at a value", &[0.0, 1.0, 2.0], |x| [[2.0, 1.0 - x], [5.0, 1.0]], &[(1.0, oscillation, [0, 2])]),
        ("divergence", &[0.0, 4.0], |x| [[0.7 - x, 1.0], [5.0, 1.0]], &[(0.7, divergence, [0, 1])]),
        ("without damping", &[0.0, 4.0], |x| [[0.7 - x, 0.0], [5.0, 0.0]], &[(0.7, divergence, [0, 1])]),
        (
            "two between neighbours",
            &[0.0, 4.0],
            |x| [[2.0, 1.3 - x], [2.1 - x, 1.0]],
            &[(1.3, oscillation, [0, 2]), (2.1, divergence, [2, 3])],
        ),
    ];
    for (name, values, of, expected) in cases {
        let locus = Locus::of(values, |x| oscillators(of(x))).unwrap();
        assert!(locus.points.is_sorted_by(|a, b| a.0 < b.0) && locus.points.len() == values.len(), "{name}");
        assert_eq!(locus.critical.len(), expected.len(), "{name}: {:?}", locus.critical);
        for (found, (value, kind, n_unstable)) in locus.critical.iter().zip(expected) {
            assert!((found.value - value).abs() <= CRITICAL && found.n_unstable == *n_unstable, "{name}: {found:?}");
            match (found.kind, kind) {
                (Instability::Oscillation { omega }, Instability::Oscillation { omega: exact }) => {
                    assert!((omega - exact).abs() <= CRITICAL * exact, "{name}: {found:?}");
                }
                (found, kind) => assert_eq!(found, *kind, "{name}"),
            }
        }
    }
    assert_eq!(Locus::of(&[1.0], |_| Err("no motion")).unwrap_err(), "no motion");
}

crate::model! {
    /// A rod on a spring whose stiffness swings, with friction in its pin: Mathieu's equation.
    pub model Swung {
        param k: N*m = 1.3; param d: N*m = 0.7; param w: rad/s = 2.1; param c: N*m*s = 0.2;
        body rod { mass: 1, inertia: 0.75 }
        hinge pin: ground(0, 0) ~ rod(-0.5, 0);
        torque rod: -(k + d*cos(w*t))*rod.phi - c*rod.omega;
        start level { rod angle 0; at rest; }
        scene swings { start level; until 1 s; }
    }
}

/// Over a period the determinant is exp(−c T/J), by Liouville, and the trace is that of Mathieu's equation by many steps of RK4.
#[test]
fn analytic_multipliers_of_a_swung_spring() {
    let scene = swung::Swings::default();
    let swung::Swings { k, d, w, c, .. } = scene;
    let period = std::f64::consts::TAU / w;
    // J = 0.75 + 1 · 0.5² = 1
    let rate = |t: f64, [x, v]: [f64; 2]| [v, -(k + d * (w * t).cos()) * x - c * v];
    let n = 4000;
    let h = period / f64::from(n);
    let along = |mut y: [f64; 2]| {
        for i in 0..n {
            let t = h * f64::from(i);
            let shifted = |k: [f64; 2], by: f64| [y[0] + by * k[0], y[1] + by * k[1]];
            let k1 = rate(t, y);
            let k2 = rate(t + 0.5 * h, shifted(k1, 0.5 * h));
            let k3 = rate(t + 0.5 * h, shifted(k2, 0.5 * h));
            let k4 = rate(t + h, shifted(k3, h));
            y = [0, 1].map(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
        }
        y
    };
    let trace = along([1.0, 0.0])[0] + along([0.0, 1.0])[1];
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    let still = system.consistent_start(&system.scene_start()).unwrap();
    for n_states in [0, 1, 2, 4, 6] {
        let error = Monodromy::of(&mut system, &vec![still.clone(); n_states]).unwrap_err();
        assert!(matches!(error, AnalysisError::NoPeriod { n_states: n, .. } if n == n_states), "{error}");
    }
    let mut errors = Vec::new();
    for n_steps in [20, 40, 80] {
        let times = Monodromy::times(0.0, period, n_steps);
        let states: Vec<State> = times.into_iter().map(|t| State { t, ..still.clone() }).collect();
        let monodromy = Monodromy::of(&mut system, &states).unwrap();
        assert_eq!((monodromy.gap, monodromy.moved), (0.0, [0.0; 3]));
        let [a, b] = monodromy.multipliers().unwrap()[..] else { panic!("two states are free") };
        let (sum, product) = (a + b, a * b);
        errors.push([(product.re - (-c * period).exp()).abs(), (sum.re - trace).abs()]);
    }
    // 2⁶ = 64 from step to step, down to the error of RK4, h⁴ of some 1e-11
    for i in 0..2 {
        assert!(errors[1][i] <= errors[0][i] / 50.0 && errors[2][i] <= 1e-10, "{errors:?}");
    }
}
