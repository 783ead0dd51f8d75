//! Transfer functions against closed forms, and by second routes.

use crate::analysis::{AnalysisError, Linearization, SteadyMotion, Transfer};
use crate::dynamics::system_of;
use crate::integrate::Method;
use crate::linalg::Backend;
use crate::model::Scene;
use crate::simulate::simulation;
use nalgebra::{Complex, DMatrix};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

crate::model! {
    /// A block on a spring with a damper.
    pub model Oscillator {
        param m: kg = 2; param c: N*s/m = 0.8; param k: N/m = 18;
        input push: N = 0;
        body block { mass: m, inertia: 1 }
        slider guide: ground(0, 0) ~ block(0, 0) along ground(1, 0);
        force at block(0, 0): (push - k*block.x - c*block.vx, 0);
        output place: m = block.x;
        output net: N = push - k*block.x - c*block.vx;
        start still { at rest; }
        scene rests { start still; until 1 s; }
    }
}

crate::model! {
    /// A cart on a rail, and a rod on a pin in it.
    pub model Crane {
        param m_cart: kg = 3; param m: kg = 2; param i: kg*m^2 = 0.1; param l: m = 0.5; param g: m/s^2 = 9.81;
        param c: N*m*s = 0;
        input push: N = 0; input torque: N*m = 0;
        body cart { mass: m_cart, inertia: 1 }
        body rod { mass: m, inertia: i }
        slider rail: ground(0, 0) ~ cart(0, 0) along ground(1, 0);
        hinge pin: cart(0, 0) ~ rod(-l, 0);
        torsion cart ~ rod: stiffness 0, angle 0, damping c;
        gravity (0, -g);
        force at cart(0, 0): (push, 0);
        torque rod: torque;
        output place: m = cart.x;
        output angle: rad = rod.phi;
        start hanging { rod angle -pi/2; at rest; }
        start standing { rod angle pi/2; at rest; }
        scene hangs { start hanging; until 1 s; }
        scene stands { start standing; until 1 s; }
    }
}

crate::model! {
    /// A rod on a pin with friction.
    pub model Swing {
        param l: m = 0.5; param m: kg = 2; param i: kg*m^2 = 0.1; param g: m/s^2 = 9.81; param c: N*m*s = 3;
        input torque: N*m = 0;
        body rod { mass: m, inertia: i }
        hinge pin: ground(0, 0) ~ rod(-l, 0);
        torsion ground ~ rod: stiffness 0, angle 0, damping c;
        torque rod: torque;
        gravity (0, -g);
        output angle: rad = rod.phi;
        start hanging { rod angle -pi/2; at rest; }
        scene hangs { start hanging; until 1 s; }
    }
}

/// Of zeros and poles, as a share of the largest: rounding of the entries, of the reductions and of the QR algorithm.
const ROOTS: f64 = 1e-12;
/// Of values of G, as a share.
const VALUES: f64 = 1e-11;

fn linear(scene: &dyn Scene) -> Linearization {
    let mut system = system_of(scene, Backend::Auto).unwrap();
    let start = system.scene_start();
    let rest = SteadyMotion::near(&mut system, &start, &[]).unwrap();
    Linearization::of(&mut system, &rest).unwrap()
}

/// x' = A x + b u, y = c x + d u in place of the equations of a scene.
fn full(a: DMatrix<f64>, b: &[f64], c: &[f64], d: f64) -> Linearization {
    let mut linear = linear(&swing::Hangs::default());
    let n = a.nrows();
    linear.basis = DMatrix::identity(n, n);
    linear.b = DMatrix::from_row_slice(n, 1, b);
    linear.c = DMatrix::from_row_slice(1, n, c);
    linear.d = DMatrix::from_element(1, 1, d);
    linear.a = a;
    linear
}

fn transfer(linear: &Linearization) -> Transfer {
    linear.transfer(linear.inputs[0], &linear.info().outputs[0].name).unwrap()
}

/// (b_0 + b_1 s + …)/(a_0 + a_1 s + … + s^n) in companion form.
fn rational(numerator: &[f64], denominator: &[f64]) -> Transfer {
    let n = denominator.len();
    let at = |i: usize| numerator.get(i).copied().unwrap_or(0.0);
    let mut a = DMatrix::zeros(n, n);
    for i in 0..n {
        a[(n - 1, i)] = -denominator[i];
        if i + 1 < n {
            a[(i, i + 1)] = 1.0;
        }
    }
    let mut b = vec![0.0; n];
    b[n - 1] = 1.0;
    let c: Vec<f64> = (0..n).map(|i| at(i) - at(n) * denominator[i]).collect();
    transfer(&full(a, &b, &c, at(n)))
}

/// Numbers that are no pattern.
fn scattered(seed: usize) -> impl FnMut() -> f64 {
    let mut i = seed as f64;
    move || {
        i += 1.0;
        (i * i * 0.731 + 2.1 * i).sin()
    }
}

fn close(found: &[Complex<f64>], exact: &[Complex<f64>]) {
    assert_eq!(found.len(), exact.len(), "{found:?} for {exact:?}");
    let size = exact.iter().map(|s| s.norm()).fold(0.0, f64::max);
    for s in exact {
        let nearest = found.iter().map(|f| (f - s).norm()).fold(f64::INFINITY, f64::min);
        assert!(nearest <= ROOTS * size, "{found:?} for {exact:?}");
    }
}

/// 1/(m s² + c s + k) for the place, m s²/(m s² + c s + k) for the net force.
#[test]
fn analytic_oscillator_has_its_poles_and_zeros() {
    let oscillator::Rests { m, c, k, .. } = oscillator::Rests::default();
    let linear = linear(&oscillator::Rests::default());
    let pair = Complex::new(-0.5 * c / m, (k / m - 0.25 * c * c / m / m).sqrt());
    let [place, net] = ["place", "net"].map(|output| linear.transfer("push", output).unwrap());
    for of in [&place, &net] {
        close(&of.poles.eigenvalues, &[pair, pair.conj()]);
        assert!((of.n_unseen, of.poles.n_zero, of.zeros.eigenvalues.len()) == (0, 0, 0), "{of:?}");
    }
    assert_eq!([place.relative_degree(), net.relative_degree()], [2, 0]);
    assert_eq!((place.zeros.n_zero, net.zeros.n_zero, &net.zeros.zero_blocks[..]), (0, 2, &[2][..]));
    assert!((place.gain * m - 1.0).abs() <= VALUES && (net.gain - 1.0).abs() <= VALUES, "{place:?} {net:?}");
    assert!((place.static_gain().unwrap() * k - 1.0).abs() <= VALUES && net.static_gain() == Some(0.0));
    for omega in [0.0, 0.3, 3.0, 70.0] {
        let exact = Complex::new(k - m * omega * omega, c * omega).inv();
        let found = place.at_frequency(omega).unwrap();
        assert!((found - exact).norm() <= VALUES * exact.norm(), "{omega}: {found} for {exact}");
    }
}

/// ω₀ √(1 − 2 ζ²), 1/(2 k ζ √(1 − ζ²)), and ω₀ √(1 − 2 ζ² + √((1 − 2 ζ²)² + 1)).
#[test]
fn analytic_oscillator_has_its_resonance_and_bandwidth() {
    let oscillator::Rests { m, k, .. } = oscillator::Rests::default();
    let omega_0: f64 = (k / m).sqrt();
    for zeta in [1e-6, 0.01, 0.3, 0.7, 0.8, 3.0] {
        let c = 2.0 * zeta * m * omega_0;
        let place = linear(&oscillator::Rests { c, m, k }).transfer("push", "place").unwrap();
        let part: f64 = 1.0 - 2.0 * zeta * zeta;
        let bandwidth = omega_0 * (part + (part * part + 1.0).sqrt()).sqrt();
        assert!((place.bandwidth().unwrap() / bandwidth - 1.0).abs() <= VALUES, "ζ = {zeta}: {:?}", place.bandwidth());
        match place.resonance() {
            Some(peak) if part > 0.0 => {
                let [omega, value] = [omega_0 * part.sqrt(), 0.5 / k / zeta / (1.0 - zeta * zeta).sqrt()];
                // rounding of the damping, ε ω₀ of ζ ω₀, changes the height of the peak
                let height = VALUES.max(10.0 * f64::EPSILON / zeta);
                assert!((peak.omega / omega - 1.0).abs() <= VALUES, "ζ = {zeta}: {peak:?} for {omega}");
                assert!((peak.value / value - 1.0).abs() <= height, "ζ = {zeta}: {peak:?} for {value}");
            }
            peak => assert!(peak.is_none() && part < 0.0, "ζ = {zeta}: {peak:?}"),
        }
    }
    let without_damping = linear(&oscillator::Rests { c: 0.0, m, k }).transfer("push", "place").unwrap();
    assert!(without_damping.resonance().is_none() && without_damping.gain_margin().is_none());
}

/// The cart stands still where the rod swings as on a fixed pin: zeros ±√(∓m g l/(i + m l²)), one to the right where the rod stands.
#[test]
fn analytic_cart_has_the_zeros_of_the_rod_on_a_fixed_pin() {
    let crane::Hangs { m, i, l, g, m_cart, .. } = crane::Hangs::default();
    let rod = Complex::from(m * g * l / (i + m * l * l));
    let scenes: [(&dyn Scene, f64); 2] = [(&crane::Hangs::default(), -1.0), (&crane::Stands::default(), 1.0)];
    for (scene, side) in scenes {
        let linear = linear(scene);
        let cart = linear.transfer("push", "place").unwrap();
        let zero = (rod * side).sqrt();
        close(&cart.zeros.eigenvalues, &[zero, -zero]);
        // (m_c + m) (i + m l²) − m² l² beside the inertia of the rod alone
        let determinant = (m_cart + m) * (i + m * l * l) - m * m * l * l;
        let pole = (rod * side * (m_cart + m) * (i + m * l * l) / determinant).sqrt();
        close(&cart.poles.eigenvalues, &[pole, -pole]);
        assert_eq!((cart.poles.n_zero, cart.n_unseen, cart.relative_degree()), (2, 0, 2));
        assert!((cart.gain * determinant / (i + m * l * l) - 1.0).abs() <= VALUES, "{}", cart.gain);
        assert!(cart.static_gain().is_none() && cart.bandwidth().is_none() && cart.resonance().is_none());
        // from the torque the place of the cart does not show in the angle
        let angle = linear.transfer("torque", "angle").unwrap();
        assert_eq!((angle.n_unseen, angle.poles.n_zero, angle.zeros.eigenvalues.len()), (2, 0, 0), "{angle:?}");
        close(&angle.poles.eigenvalues, &[pole, -pole]);
    }
}

#[test]
fn invariant_unknown_names_are_told_with_those_that_there_are() {
    let linear = linear(&crane::Hangs::default());
    let told = |input, output| linear.transfer(input, output).unwrap_err().to_string();
    assert!(told("pus", "place").contains("no input `pus`; it has push, torque"), "{}", told("pus", "place"));
    assert!(told("push", "speed").contains("no output `speed`; it has place, angle"));
    let mut silent = linear.clone();
    silent.inputs.clear();
    let error = silent.transfer("push", "place").unwrap_err();
    assert!(error.to_string().contains("declare one in the model, such as `input push: N = 0;`"), "{error}");
    silent.inputs = linear.inputs.clone();
    silent.a[(0, 0)] = f64::NAN;
    let error = silent.transfer("push", "place").unwrap_err();
    assert!(matches!(error, AnalysisError::NoEigenvalues { .. }), "{error}");
}

/// Two states: the roots of d det(s − A) + c adj(s − A) b, by hand.
#[test]
fn cross_zeros_of_two_states_are_roots_by_hand() {
    let mut next = scattered(1);
    for d in [0.0, 1e-3, 0.7, -5.0] {
        let [p, q, r, s, b1, b2, c1, c2] = std::array::from_fn(|_| next());
        let found = transfer(&full(DMatrix::from_row_slice(2, 2, &[p, q, r, s]), &[b1, b2], &[c1, c2], d));
        let linear = c1 * b1 + c2 * b2 - d * (p + s);
        let constant = d * (p * s - q * r) + c1 * (q * b2 - s * b1) + c2 * (r * b1 - p * b2);
        let exact = if d == 0.0 {
            vec![Complex::from(-constant / linear)]
        } else {
            let root = Complex::from(linear * linear - 4.0 * d * constant).sqrt();
            [root, -root].map(|root| (root - linear) / (2.0 * d)).to_vec()
        };
        close(&found.zeros.eigenvalues, &exact);
        let gain = if d == 0.0 { linear } else { d };
        assert!((found.gain / gain - 1.0).abs() <= VALUES, "{found:?}");
    }
}

/// G vanishes at the zeros, and is k Π(s − z)/Π(s − p) elsewhere.
#[test]
fn cross_zeros_are_zeros_of_the_response() {
    for (n, d, degree) in [(3, 0.0, 1), (8, 0.0, 1), (8, 0.4, 0), (9, 0.0, 3), (20, 1e-6, 0)] {
        let mut next = scattered(n);
        let a = DMatrix::from_fn(n, n, |_, _| next());
        let b: Vec<f64> = (0..n).map(|_| next()).collect();
        // c b = c A b = 0 for a relative degree of three
        let mut c = nalgebra::DVector::from_fn(n, |_, _| next());
        if degree == 3 {
            let first = nalgebra::DVector::from_row_slice(&b);
            let basis = DMatrix::from_columns(&[first.clone(), &a * first]).qr().q();
            c -= &basis * basis.tr_mul(&c);
        }
        let linear = full(a, &b, c.as_slice(), d);
        let of = transfer(&linear);
        assert_eq!((of.relative_degree(), of.zeros.eigenvalues.len(), of.n_unseen), (degree, n - degree, 0));
        let at = |s: Complex<f64>| linear.response(s).unwrap()[(0, 0)];
        for z in &of.zeros.eigenvalues {
            let beside = at(z * 1.1).norm().max(at(z * 0.9).norm());
            assert!(at(*z).norm() <= 1e-9 * beside, "n = {n}, d = {d}: G({z}) = {}, {beside} beside it", at(*z));
        }
        for s in [Complex::new(0.3, 0.0), Complex::new(0.0, 2.0), Complex::new(-1.0, 40.0)] {
            let product = |of: &[Complex<f64>]| -> Complex<f64> { of.iter().map(|z| s - z).product() };
            let exact = at(s);
            let factors = product(&of.zeros.eigenvalues) / product(&of.poles.eigenvalues) * of.gain;
            assert!((of.at(s).unwrap() - exact).norm() <= VALUES * exact.norm(), "n = {n}, d = {d}, {s}");
            assert!((factors - exact).norm() <= 1e-9 * exact.norm(), "n = {n}, d = {d}, {s}: {factors} for {exact}");
        }
    }
}

/// States in mm, input in kN, output in µm: poles and zeros stay, the gain follows the units.
#[test]
fn cross_transfer_is_the_response_in_any_units() {
    let plain = linear(&oscillator::Rests::default());
    let of_plain = plain.transfer("push", "net").unwrap();
    for power in [-6, -3, 3, 6] {
        let mut scaled = plain.clone();
        let by = 10f64.powi(power);
        scaled.a.row_mut(0).scale_mut(by);
        scaled.a.column_mut(0).scale_mut(1.0 / by);
        scaled.c.column_mut(0).scale_mut(1.0 / by);
        scaled.b.row_mut(0).scale_mut(by);
        (scaled.b, scaled.d) = (scaled.b * 1e3, scaled.d * 1e3);
        let of_scaled = scaled.transfer("push", "net").unwrap();
        close(&of_scaled.poles.eigenvalues, &of_plain.poles.eigenvalues);
        assert_eq!((of_scaled.zeros.n_zero, of_scaled.n_unseen), (2, 0), "{of_scaled:?}");
        for omega in [0.1, 3.0, 1e3] {
            let [found, exact] = [&of_scaled, &of_plain].map(|of| of.at_frequency(omega).unwrap());
            assert!((found / 1e3 - exact).norm() <= VALUES * exact.norm(), "{power}, {omega}: {found} for {exact}");
        }
    }
}

/// n equal masses between two walls, pushed in the middle: modes that are at rest there are neither moved nor seen. n odd: (n − 1)/2 of n.
#[test]
fn analytic_modes_that_are_not_seen_are_counted() {
    for n in [3, 7, 25] {
        let mut a = DMatrix::zeros(2 * n, 2 * n);
        for i in 0..n {
            (a[(i, n + i)], a[(n + i, i)], a[(n + i, n + i)]) = (1.0, -2.0, -0.02);
            if i > 0 {
                (a[(n + i, i - 1)], a[(n + i - 1, i)]) = (1.0, 1.0);
            }
        }
        let middle = n / 2;
        let [mut b, mut c] = [(); 2].map(|()| vec![0.0; 2 * n]);
        (b[n + middle], c[middle]) = (1.0, 1.0);
        let of = transfer(&full(a, &b, &c, 0.0));
        assert_eq!((of.n_unseen, of.poles.eigenvalues.len(), of.relative_degree()), (n - 1, n + 1, 2), "n = {n}");
        // ω_k = 2 sin(k π/(2 (n + 1))), seen where k is odd; with a damping of 0.01 1/s
        let exact: Vec<Complex<f64>> = (1..=n)
            .step_by(2)
            .map(|k| (2.0 * (k as f64 * FRAC_PI_2 / (n + 1) as f64).sin()).powi(2))
            .flat_map(|square| [1.0, -1.0].map(|side| Complex::new(-0.01, side * (square - 1e-4f64).sqrt())))
            .collect();
        close(&of.poles.eigenvalues, &exact);
        assert!(of.resonance().is_some_and(|peak| (peak.omega - exact[0].im).abs() < 1e-3), "{:?}", of.resonance());
    }
    // what the input does not move at all
    let nothing = transfer(&full(DMatrix::identity(2, 2), &[1.0, 0.0], &[0.0, 1.0], 0.0));
    assert_eq!((nothing.n_unseen, nothing.gain, nothing.static_gain()), (2, 0.0, Some(0.0)));
    assert!(nothing.crossings(1.0).is_empty() && nothing.gain_margin().is_none() && nothing.phase_margin().is_none());
}

/// K/(s (s + 1) (s + 2)): real and negative at √2, −K/6; with K = √10 of magnitude 1 at 1 rad/s, and then 180° − 90° − 45° − atan ½.
#[test]
fn analytic_margins_of_a_third_order_loop() {
    for (k, is_stable) in [(10f64.sqrt(), true), (6.5, false)] {
        let of = rational(&[k], &[0.0, 2.0, 3.0]);
        let margin = of.gain_margin().unwrap();
        assert!(
            (margin.value * k / 6.0 - 1.0).abs() <= VALUES && (margin.omega - 2f64.sqrt()).abs() <= VALUES,
            "{margin:?}"
        );
        assert_eq!(of.closed_loop().unwrap().n_unstable() == 0, is_stable);
        let phase = of.phase_margin().unwrap();
        assert_eq!(phase.value > 0.0, is_stable, "{phase:?}");
        let exact = FRAC_PI_2 - phase.omega.atan() - (0.5 * phase.omega).atan();
        assert!((phase.value - exact).abs() <= VALUES, "{phase:?} for {exact}");
    }
    let of = rational(&[10f64.sqrt()], &[0.0, 2.0, 3.0]);
    assert!((of.phase_margin().unwrap().omega - 1.0).abs() <= VALUES, "{:?}", of.phase_margin());
    assert_eq!((of.poles.n_zero, of.static_gain(), of.resonance()), (1, None, None));
    // 4 s/((s + 1)² + …): |G| = 1 where ω⁴ − 18 ω² + 1 = 0 for 4 s/(s² + 1 + …)
    let band = rational(&[0.0, 4.0], &[1.0, 2.0]);
    let found = band.crossings(1.0);
    let exact = [-1.0, 1.0].map(|side| (7.0 + side * 48f64.sqrt()).sqrt());
    assert!(found.len() == 2 && found.iter().zip(exact).all(|(f, e)| (f / e - 1.0).abs() <= VALUES), "{found:?}");
    // at its largest magnitude, 2 at 1 rad/s, level and curve touch
    let peak = band.resonance().unwrap();
    assert!((peak.value - 2.0).abs() <= VALUES && (peak.omega - 1.0).abs() <= VALUES, "{peak:?}");
    assert!(band.crossings(2.0 * (1.0 + 1e-6)).is_empty() && band.crossings(2.0 * (1.0 - 1e-6)).len() == 2);
}

/// The phase of (1 − s)/((s + 1)² (s² + 2 ζ s 100 + 100²)) goes from 0 to −450°, in two steps as in a thousand.
#[test]
fn analytic_phase_is_followed_over_wide_steps() {
    let zeta = 1e-3;
    let [a1, a0] = [2.0 * zeta * 100.0, 1e4];
    let of = rational(&[a0, -a0], &[a0, 2.0 * a0 + a1, 1.0 * a0 + 2.0 * a1 + 1.0, a1 + 2.0]);
    assert!((of.zeros.eigenvalues[0] - 1.0).norm() <= ROOTS, "{of:?}");
    let exact = |w: f64| -3.0 * w.atan() - (2.0 * zeta * 100.0 * w).atan2(1e4 - w * w);
    let [first, last] = [1e-3, 1e6];
    for omegas in [vec![first, last], of.frequencies([first, last], 1000)] {
        for point in of.bode(&omegas) {
            assert!((point.phase - exact(point.omega)).abs() <= 1e-8, "{point:?} for {}", exact(point.omega));
            let g = of.at_frequency(point.omega).unwrap();
            assert!((point.decibels() - 10.0 * g.norm_sqr().log10()).abs() <= 1e-10, "{point:?}");
        }
    }
    let [low, high] = of.span();
    assert!((low / 0.1 - 1.0).abs() <= 1e-12 && (high / 1e3 - 1.0).abs() <= 1e-12, "{low} {high}");
    // 1/(s² (s² + 1)): −180°, and after the pole without damping −360°
    let points = rational(&[1.0], &[0.0, 0.0, 1.0, 0.0]).bode(&[0.1, 1.0, 10.0]);
    let [before, after] = [&points[0], &points[points.len() - 1]];
    assert!((before.phase + PI).abs() <= 1e-9 && (after.phase + TAU).abs() <= 1e-9, "{points:?}");
    assert!(of.frequencies([first, last], 1000).is_sorted());
}

/// Beside the pole i of 1/(s² + 1): half the width 1e-3 away, and seven times twice as far.
#[test]
fn analytic_frequencies_stand_close_beside_a_pole_without_damping() {
    let found = rational(&[1.0], &[1.0, 0.0]).frequencies([0.1, 10.0], 2);
    let away: Vec<f64> = (-1..=6).map(|i| 1e-3 * 2f64.powi(i)).collect();
    let below = away.iter().rev().map(|away| 1.0 - away);
    let exact: Vec<f64> = [0.1].into_iter().chain(below).chain([1.0]).chain(away.iter().map(|x| 1.0 + x)).collect();
    assert_eq!(found.len(), exact.len() + 1, "{found:?}");
    assert!(found.iter().zip(exact.iter().chain(&[10.0])).all(|(f, e)| (f - e).abs() <= ROOTS * e), "{found:?}");
}

/// A rod driven by a sine, after its transient: amplitude and phase are those of G(iω).
///
/// The input is held over the steps h: its first harmonic has the factor sin(ωh/2)/(ωh/2) e^(−iωh/2). Of sin φ = φ − φ³/6 the first harmonic
/// is (1 − a²/8) φ for an amplitude a, so that G changes by |m g l G| a²/8 of itself.
#[test]
fn reference_run_with_a_sine_has_the_amplitude_and_phase_of_the_response() {
    /// Step, s: RK4 and the images of the held input leave 1e-9, (ωh)⁴/120 and (ωh/2π)³.
    const STEP: f64 = 2e-3;
    /// exp(−c/(2 J) t) of the transient, with c/(2 J) = 2.5 1/s.
    const SETTLED_S: f64 = 10.0;
    const OTHERS: f64 = 1e-8;
    let scene = swing::Hangs::default();
    let swing::Hangs { m, g, l, .. } = scene;
    let of = linear(&scene).transfer("torque", "angle").unwrap();
    let omega = TAU;
    let exact = of.at_frequency(omega).unwrap();
    let half = 0.5 * omega * STEP;
    let held = Complex::from_polar(half.sin() / half, -half);
    for amplitude in [0.02, 0.2] {
        let run = simulation(&scene).method(Method::rk4(STEP)).until(SETTLED_S + 2.0).every(STEP).outputs();
        let run = run.control_by_index(move |t, _, inputs| inputs[0] = amplitude * (omega * t).sin()).run().unwrap();
        let last: Vec<_> = run.samples().filter(|s| s.t > SETTLED_S + 0.5 * STEP).collect();
        assert_eq!(last.len(), 1000);
        // over whole periods the mean drops out
        let harmonic: Complex<f64> =
            last.iter().map(|s| Complex::from_polar(s.get("output.angle").unwrap(), -omega * s.t)).sum();
        // sin = (e^(iωt) − e^(−iωt))/2i
        let found = harmonic * Complex::new(0.0, 2.0) / last.len() as f64 / amplitude;
        let angle = amplitude * exact.norm();
        let bound = m * g * l * exact.norm() * angle * angle / 8.0 * 1.1 + OTHERS;
        let error = (found / (exact * held) - 1.0).norm();
        assert!(error <= bound, "{amplitude} N·m: {found} for {exact}: {error:.2e} of it, at most {bound:.2e}");
        // and so much it is: what the linear equations leave out is seen
        assert!(amplitude < 0.1 || error >= 0.5 * bound, "{error:.2e} for {bound:.2e}");
    }
}
