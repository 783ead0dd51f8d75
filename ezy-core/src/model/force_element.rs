//! What gives power to a mechanism, and takes it.

/// A force of a scene: a declared one, of the model or of an effect, or a skate with a limit, which rubs while it slides.
///
/// [`Derived::element_powers`](super::Derived::element_powers) has its power.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ForceElement {
    /// What it is and where, as no other force and no effect of the scene: `gravity`, `spring A ~ B`, `torque arm`, `skate rear`. Of a place on a
    /// body it is the body. What would have the same name twice has a number behind it: `spring A ~ B (2)`. In a `for` it is written with the index:
    /// `spring link[i] ~ link[i+1]`.
    pub name: &'static str,
    /// The word of the language that declares it: `spring`, `gravity`, `friction`, …
    pub kind: &'static str,
    /// The effect that declares it; `None` when the model itself does.
    pub effect: Option<&'static str>,
    /// Whether it takes part in the potential energy.
    pub has_potential: bool,
    /// Whether it takes part in the power of its effect. A spring with a damping has a potential, and does work too.
    pub does_work: bool,
}

#[cfg(test)]
mod tests {
    use crate::model::{Derived as _, Equations as _, Scene as _};

    crate::model! {
        /// A rod on a pin, with a torsion spring, dry friction, and two springs between the same bodies.
        model Rod {
            param g: m/s^2 = 9.81;
            input push: N = 1.5;
            body rod { mass: 2, inertia: 0.5 }
            hinge pin: ground(0, 0) ~ rod(-0.3, 0);
            point tip = rod(0.6, 0.1);
            gravity (0, -g);
            torsion ground ~ rod: stiffness 3, angle 0.4, damping 0.7;
            effect rub {
                friction ground ~ rod: torque 0.9, rate 0.2;
                force at tip: (push, 0);
            }
            effect gravity { spring ground(1, 1) ~ tip: stiffness 5; }
            effect left_out { torque rod: 8; }
            spring ground(0, 1) ~ tip: stiffness 4, length 0.2;
            start here { rod angle 0; at rest; }
            scene swings { start here; until 1 s; with rub, gravity; }
        }
    }

    crate::model! {
        /// Beads on springs: each to the next one, the last one to the ground.
        model Beads {
            count n = 4;
            body bead[n] { mass: 2, inertia: 1 }
            gravity (0, -10);
            for i in 0..n-1 { spring bead[i](0, 0) ~ bead[i+1](0, 0): stiffness 3; }
            damper bead[n-1](0, 0) ~ ground(0, 0): damping 0.5;
            start here { for i in 0..n { bead[i] at (1 m * i, 0) angle 0; } at rest; }
            scene fall { start here; until 1 s; }
        }
    }

    /// Some operations on powers of 100 W.
    const ROUNDING: f64 = 100.0 * 16.0 * f64::EPSILON;

    fn assert_close(found: &[f64], expected: &[f64]) {
        assert_eq!(found.len(), expected.len());
        for (x, y) in found.iter().zip(expected) {
            assert!((x - y).abs() <= ROUNDING, "{found:?} {expected:?}");
        }
    }

    /// Gravity −m g vy, torsion −(k (φ − φ₀) + c ω) ω, friction −f ω²/√(ω² + u²), force f vx, springs −k (s − l) s', at states that need not fulfil the
    /// constraint: forces know nothing of it.
    #[test]
    fn analytic_powers_of_forces_of_a_rod() {
        let scene = rod::Swings::default();
        let names: Vec<_> = scene.force_elements().iter().map(|of| (of.name, of.effect)).collect();
        let expected = [
            ("gravity (2)", None),
            ("torsion ground ~ rod", None),
            ("friction ground ~ rod", Some("rub")),
            ("force at tip", Some("rub")),
            ("spring ground ~ tip", Some("gravity")),
            ("spring ground ~ tip (2)", None),
        ];
        assert_eq!(names, expected);
        let kinds: Vec<_> = scene.force_elements().iter().map(|of| (of.has_potential, of.does_work)).collect();
        assert_eq!(kinds, [(true, false), (true, true), (false, true), (false, true), (true, false), (true, false)]);
        let info = scene.info();
        let mut c = vec![0.0; info.n_fixed()];
        scene.constants(&[scene.g], &mut c);
        c[0] = 1.5;
        for [x, y, phi, vx, vy, omega] in [[0.3, -0.2, 0.7, 0.8, -1.3, 0.9], [-0.4, 0.5, 2.9, -0.2, 0.6, -1.7]] {
            let (sin, cos) = f64::sin_cos(phi);
            let arm = [0.6 * cos - 0.1 * sin, 0.6 * sin + 0.1 * cos];
            let (tip, velocity) = ([x + arm[0], y + arm[1]], [vx - omega * arm[1], vy + omega * arm[0]]);
            let spring = |from: [f64; 2], stiffness: f64, length: f64| {
                let gap = [tip[0] - from[0], tip[1] - from[1]];
                let distance = gap[0].hypot(gap[1]);
                -stiffness * (distance - length) * (gap[0] * velocity[0] + gap[1] * velocity[1]) / distance
            };
            let expected = [
                -2.0 * 9.81 * vy,
                -(3.0 * (phi - 0.4) + 0.7 * omega) * omega,
                -0.9 * omega * omega / omega.hypot(0.2),
                1.5 * velocity[0],
                spring([1.0, 1.0], 5.0, 0.0),
                spring([0.0, 1.0], 4.0, 0.2),
            ];
            let mut found = [f64::NAN; 6];
            scene.element_powers(&c, 0.3, &[x, y, phi], &[vx, vy, omega], &mut found);
            assert_close(&found, &expected);
        }
    }

    /// All members of a force in a `for` are one element, and so is gravity.
    #[test]
    fn analytic_powers_of_members_add_up() {
        for n in [1, 4] {
            let scene = beads::Fall { n };
            let names: Vec<_> = scene.force_elements().iter().map(|of| of.name).collect();
            assert_eq!(names, ["gravity", "spring bead[i] ~ bead[i+1]", "damper bead[n-1] ~ ground"]);
            let info = scene.info();
            let mut c = vec![0.0; info.n_fixed()];
            scene.constants(&[], &mut c);
            let number = |k: usize| (1.3 * k as f64).sin();
            let q: Vec<f64> = (0..3 * n).map(number).collect();
            let v: Vec<f64> = (7..7 + 3 * n).map(number).collect();
            let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
            let of = |x: &[f64], i: usize| [x[3 * i], x[3 * i + 1]];
            let spring = |i: usize| {
                let [gap, rate] = [&q, &v].map(|x| [0, 1].map(|k| of(x, i + 1)[k] - of(x, i)[k]));
                -3.0 * dot(gap, rate)
            };
            let (last, rate) = (of(&q, n - 1), of(&v, n - 1));
            let expected = [
                (0..n).map(|i| -20.0 * v[3 * i + 1]).sum(),
                (0..n - 1).map(spring).sum(),
                -0.5 * dot(last, rate).powi(2) / dot(last, last),
            ];
            let mut found = [f64::NAN; 3];
            scene.element_powers(&c, 0.0, &q, &v, &mut found);
            assert_close(&found, &expected);
        }
    }
}
