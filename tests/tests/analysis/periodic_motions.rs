//! Periodic motions and their multipliers, against closed forms and against differences of runs.

use ezy_core::analysis::{AnalysisError, Period, PeriodicMotion, Stability, Trivial};
use ezy_core::dynamics::{Metric, Projection, State, System};
use ezy_core::linalg::Backend;
use ezy_core::model;
use ezy_core::prelude::*;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;

/// Tolerance of the runs.
const RUN: f64 = 1e-13;
/// Of states and periods, as a share of the largest: ten times what may be left of a return, 1e-9, where Newton's steps end earlier.
const RETURN: f64 = 1e-8;
/// Of multipliers, as a share of the largest: what halved steps of the collocation may change, 1e-9, and tolerances of runs over a period.
const MULTIPLIERS: f64 = 1e-8;

/// States of a run of a scene from a state.
fn run<S: Scene>(scene: &S, state: &State, times: &[f64]) -> Result<Vec<State>, AnalysisError> {
    let info = scene.info();
    let until = times.last().copied().unwrap_or_default();
    let mut simulation =
        Simulation::new(scene).method(Method::dop853(RUN)).until(until).at(times.iter().copied()).project_start();
    let states = info.states.iter().map(|state| state.name);
    let names = info.coordinates.iter().chain(&*info.velocities).map(|c| &*c.name).chain(states);
    for (name, value) in names.zip(state.q.iter().chain(&state.v).chain(&state.z)) {
        simulation = simulation.start(name, *value);
    }
    let run = simulation.run().unwrap();
    assert!(run.outcome.reached_end(), "{}", run.outcome);
    let state = |s: ezy_core::record::Sample<'_>| State {
        t: s.t,
        q: s.coordinates.to_vec(),
        v: s.velocities.to_vec(),
        z: s.states.to_vec(),
        work: state.work.clone(),
    };
    Ok(run.samples().map(state).collect())
}

fn found<S: Scene>(scene: &S, period: Period, hold: &[&str]) -> Result<PeriodicMotion, AnalysisError> {
    let mut system = System::new(scene, Backend::Auto).unwrap();
    let start = system.scene_start();
    PeriodicMotion::near(&mut system, &start, period, hold, |state, times| run(scene, state, times))
}

model! {
    /// A point on a rod, without friction.
    pub model Pendulum {
        param m: kg = 2; param l: m = 0.7; param g: m/s^2 = 9.81;
        body rod { mass: m, inertia: 0 }
        hinge pin: ground(0, 0) ~ rod(0, l);
        force at rod(0, 0): (0, -m*g);
        start swung { rod angle 1.2; at rest; }
        scene swings { start swung; until 1 s; }
    }
}

/// T = 2 π √(l/g) / agm(1, cos(φ₀/2)).
#[test]
fn analytic_pendulum_has_its_period() {
    let scene = pendulum::Swings::default();
    for (hold, near) in [(&["rod.phi"][..], 1.9), (&["rod.phi"], 1.7), (&[], 1.9)] {
        let motion = found(&scene, Period::Near(near), hold).unwrap();
        let amplitude = {
            let (q, v) = (motion.start().q[2], motion.start().v[2]);
            // from the energy
            (q.cos() - 0.5 * scene.l * v * v / scene.g).acos()
        };
        let (mut a, mut b) = (1.0f64, (0.5 * amplitude).cos());
        for _ in 0..8 {
            (a, b) = (0.5 * (a + b), (a * b).sqrt());
        }
        let exact = TAU * (scene.l / scene.g).sqrt() / a;
        assert!((motion.period - exact).abs() <= RETURN * exact, "{} for {exact}", motion.period);
        assert_eq!((&motion.trivial[..], motion.stability()), (&[Trivial::Time][..], Stability::Neutral));
        if !hold.is_empty() {
            assert_eq!(motion.start().q[2], 1.2);
        }
    }
}

model! {
    /// A mass on a spring that is damped far away and driven near its rest: van der Pol's equation. A force swings it, if asked to.
    pub model Oscillator {
        param mu: N*s/m = 0; param c: N*s/m = 0; param k: N/m = 1; param f: N = 0; param w: rad/s = 1; param k3: N/m^3 = 0; param l: m = 1;
        body block { mass: 1, inertia: 1 }
        slider rail: ground(0, 0) ~ block(0, 0) along ground(1, 0);
        force at block(0, 0): (-k*block.x - k3*block.x*block.x*block.x + (mu*(1 - block.x*block.x/l/l) - c)*block.vx + f*cos(w*t), 0);
        start aside { block at (2, 0) angle 0; block velocity (0, _); }
        scene swings { start aside; until 1 s; }
    }
}

/// The multiplier is exp(∫ μ (1 − x²) dt), by Liouville; the period at μ = 1 is known.
#[test]
fn analytic_van_der_pol_by_liouville() {
    /// # Source
    /// Andersen, Geer, SIAM J. Appl. Math. 42 (1982) 678: 6.66328686.
    const PERIOD: f64 = 6.663_286_86;
    let scene = oscillator::Swings { mu: 1.0, ..Default::default() };
    let motion = found(&scene, Period::Near(6.0), &[]).unwrap();
    assert!((motion.period - PERIOD).abs() <= 1e-8, "{}", motion.period);
    // Simpson's rule in periodic form is the rectangle rule, of any order
    let n = 400;
    let times: Vec<f64> = (0..=n).map(|i| motion.period * f64::from(i) / f64::from(n)).collect();
    let states = run(&scene, motion.start(), &times).unwrap();
    let mean = states[..400].iter().map(|state| 1.0 - state.q[0] * state.q[0]).sum::<f64>() / f64::from(n);
    let exact = (motion.period * mean).exp();
    let [mode] = &motion.modes[..] else { panic!("{:?}", motion.modes) };
    assert!((mode.eigenvalue.re - exact).abs() <= MULTIPLIERS && mode.eigenvalue.im == 0.0, "{mode:?} for {exact}");
    assert_eq!((&motion.trivial[..], motion.stability()), (&[Trivial::Time][..], Stability::Stable));
    assert!(motion.trivial_left <= MULTIPLIERS, "{}", motion.trivial_left);
}

/// x = |G| f cos(ω t + arg G), and multipliers exp(s T), of a linear oscillator, from any start, in one step.
#[test]
fn analytic_driven_oscillator_has_one_motion() {
    for (c, k) in [(0.3, 2.0), (-0.1, 2.0), (4.0, 2.0)] {
        let (f, w) = (1.5, 1.1);
        let scene = oscillator::Swings { c, k, f, w, ..Default::default() };
        let motion = found(&scene, Period::Given(TAU / w), &[]).unwrap();
        let (re, im) = (k - w * w, c * w);
        let size = re * re + im * im;
        let [x, v] = [f * re / size, f * w * im / size];
        let off = [motion.start().q[0] - x, motion.start().v[0] - v];
        assert!(off.iter().all(|off| off.abs() <= RETURN) && motion.n_steps <= 3, "{off:?} {}", motion.n_steps);
        // 400 steps, which are enough, have three nodes each
        assert_eq!(motion.states.len(), 3 * 400 + 2, "{:e}", motion.change);
        let root = nalgebra::Complex::new(0.25 * c * c - k, 0.0).sqrt();
        for sign in [1.0, -1.0] {
            let exact = ((root * sign - 0.5 * c) * motion.period).exp();
            let near = |mode: &ezy_core::analysis::Mode| (mode.eigenvalue - exact).norm() <= MULTIPLIERS;
            assert!(motion.modes.iter().any(near), "{exact} in {:?}", motion.modes);
        }
        let expected = if c > 0.0 { Stability::Stable } else { Stability::Unstable };
        assert!(motion.trivial.is_empty() && motion.stability() == expected, "{motion:?}");
    }
}

/// Duffing's equation, weakly driven: harmonic balance with one more harmonic leaves less than its next one.
#[test]
fn analytic_weak_duffing_by_harmonic_balance() {
    let (k3, f, w) = (1e-3, 0.5, 0.5);
    let scene = oscillator::Swings { c: 0.0, k3, f, w, ..Default::default() };
    let motion = found(&scene, Period::Given(TAU / w), &[]).unwrap();
    // x = a cos ωt + b cos 3ωt: (1 − ω²) a + ¾ k3 a³ = f and (1 − 9ω²) b = −¼ k3 a³, but for k3² terms
    let mut a = f / (1.0 - w * w);
    for _ in 0..30 {
        a = (f - 0.75 * k3 * a * a * a) / (1.0 - w * w);
    }
    let b = -0.25 * k3 * a * a * a / (1.0 - 9.0 * w * w);
    let neglected = 3.0 * k3 * k3;
    assert!((motion.start().q[0] - a - b).abs() <= neglected, "{} for {}", motion.start().q[0], a + b);
    assert_eq!(motion.stability(), Stability::Neutral);
    // undamped, M keeps areas: the product of multipliers is 1
    let product = motion.modes.iter().map(|mode| mode.eigenvalue).product::<nalgebra::Complex<f64>>();
    assert!((product - 1.0).norm() <= MULTIPLIERS, "{product}");
}

/// What does not return is named; a scene that depends on time has no free period; a rest is no motion.
#[test]
fn invariant_motion_without_return_names_what_does_not() {
    // at resonance without damping the amplitude grows for ever
    let resonant = oscillator::Swings { f: 1.0, ..Default::default() };
    let error = found(&resonant, Period::Given(TAU), &[]).unwrap_err();
    assert!(
        matches!(&error, AnalysisError::NoReturn { what, unit: "m" | "m/s", .. } if what.starts_with("block.")),
        "{error}"
    );
    let error = found(&resonant, Period::Near(6.0), &[]).unwrap_err();
    assert!(matches!(error, AnalysisError::TimeDependent { .. }), "{error}");
    let error = found(&resonant, Period::Given(6.0), &[]).unwrap_err();
    assert!(error.to_string().contains("6 s later"), "{error}");
    let damped = oscillator::Swings { c: 0.5, ..Default::default() };
    let error = found(&damped, Period::Near(6.0), &[]).unwrap_err();
    assert!(matches!(error, AnalysisError::AtRest { .. } | AnalysisError::NoReturn { .. }), "{error}");
    let error = found(&damped, Period::Near(-1.0), &[]).unwrap_err();
    assert_eq!(error, AnalysisError::Period { period: -1.0 });
    let error = found(&damped, Period::Near(6.0), &["block.z"]).unwrap_err();
    assert!(matches!(&error, AnalysisError::UnknownHeld { name, .. } if name == "block.z"), "{error}");
}

model! {
    /// The driven EzyRoller with drag of its rear wheel.
    pub model Roller {
        param a: m = 0.2; param b: m = 0.6; param c: m = 0.1; param d: m = 0.1;
        param m1: kg = 46; param i1: kg*m^2 = 10; param m2: kg = 1; param i2: kg*m^2 = 0.005;
        param m0: N*m = 2; param omega: rad/s = pi; param k: N*s/m = 0.5;
        body seat { mass: m1, inertia: i1 }
        body bar { mass: m2, inertia: i2 }
        point A = seat(-a, 0);
        hinge B: seat(b, 0) ~ bar(-d, 0);
        skate rear: at A along seat(1, 0);
        skate front: at bar(c, 0) along bar(1, 0);
        torque seat ~ bar: m0*cos(omega*t);
        force at A: -k*A.v;
        start folded { seat at (0, 0) angle 0; bar angle pi; at rest; }
        scene driven { start folded; until 60 s; }
    }
}

/// From rest the gait is found whose M is that of central differences of whole runs; it goes straight on, and is stable.
#[test]
fn fd_monodromy_of_the_gait_of_a_roller() {
    let scene = roller::Driven::default();
    let motion = found(&scene, Period::Given(2.0), &[]).unwrap();
    let monodromy = &motion.monodromy;
    assert!(monodromy.gap <= RETURN && monodromy.moved[0].hypot(monodromy.moved[1]) > 1.0, "{monodromy:?}");
    assert!(monodromy.moved[2].abs() <= RETURN && motion.stability() == Stability::Stable, "{monodromy:?}");
    assert_eq!(motion.trivial, [Trivial::Place, Trivial::Place, Trivial::Heading]);
    assert!(motion.trivial_left <= MULTIPLIERS && motion.modes.len() == 3, "{motion:?}");
    let mut system = System::new(&scene, Backend::Auto).unwrap();
    let start = motion.start();
    let n = monodromy.basis.ncols();
    let mut end = |j: usize, h: f64| {
        let mut state = start.clone();
        let State { q, v, .. } = &mut state;
        q.iter_mut().chain(&mut *v).zip(&monodromy.basis.column(j)).for_each(|(x, b)| *x += h * b);
        system.project(0.0, q, v, Projection::Both, Metric::Mass).unwrap();
        let states = run(&scene, &state, &[0.0, motion.period]).unwrap();
        DVector::from_vec([&*states[1].q, &states[1].v].concat())
    };
    let mut differences = |h: f64| {
        let columns = (0..n).map(|j| monodromy.basis.tr_mul(&((end(j, h) - end(j, -h)) / (2.0 * h))));
        DMatrix::from_columns(&columns.collect::<Vec<_>>())
    };
    // errors c h² + d h⁴ and those of runs; from h to h/2 the first falls by 4, and Richardson's extrapolation leaves the others
    let h = 1e-3;
    let [coarse, fine] = [differences(h), differences(0.5 * h)];
    let [e1, e2] = [&coarse, &fine].map(|of| (of - &monodromy.matrix).amax());
    assert!((3.8..4.2).contains(&(e1 / e2)), "{e1} {e2}");
    let of_runs = 100.0 * RUN * monodromy.matrix.amax() / h;
    let extrapolated = ((&fine * 4.0 - &coarse) / 3.0 - &monodromy.matrix).amax();
    assert!(extrapolated <= e2 * e2 + of_runs, "{extrapolated} {e2} {of_runs}");
}

/// What the drag takes is what the torque gives: without drag, the roller from rest has no gait to come to.
#[test]
fn invariant_roller_without_drag_does_not_return() {
    let scene = roller::Driven { k: 0.0, ..Default::default() };
    let error = found(&scene, Period::Given(2.0), &[]).unwrap_err();
    assert!(matches!(error, AnalysisError::NoReturn { .. }), "{error}");
}
