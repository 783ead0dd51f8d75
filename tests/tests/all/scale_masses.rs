//! Chains of rods whose masses differ by ten decades and more: the problem is well conditioned, only the numbers differ. Their
//! motion is in the hard cases `mass_ratio_…`.

use ezy_core::prelude::*;
use ezy_core_tests::system_of;

ezy_core::model! {
    /// Two uniform rods of 1 m under a bearing.
    model Rods {
        param upper_mass: kg = 1;
        param lower_mass: kg = 1;
        body upper { mass: upper_mass, inertia: upper_mass/12 }
        body lower { mass: lower_mass, inertia: lower_mass/12 }
        hinge bearing: ground(0, 0) ~ upper(-0.5, 0);
        hinge pin: upper(0.5, 0) ~ lower(-0.5, 0);
        gravity (0, -9.81);
        start bent { upper angle 0.3; lower angle -0.5; at rest; }
        scene swing { start bent; until 2 s; }
    }
}

ezy_core::model! {
    /// A load on a rope of light rods, as many as one likes.
    model Rope {
        count n = 2;
        param light: kg = 1e-7;
        body link[n] { mass: light, inertia: light/12 }
        body load { mass: 1, inertia: 1/12 }
        hinge top: ground(0, 0) ~ link[0](-0.5, 0);
        for i in 1..n { hinge pin[i]: link[i-1](0.5, 0) ~ link[i](-0.5, 0); }
        hinge hook: link[n-1](0.5, 0) ~ load(-0.5, 0);
        gravity (0, -9.81);
        start bent { for i in 0..n { link[i] angle 0.3 - 0.7*i; } load angle 0.9; at rest; }
        scene swing { start bent; until 1 s; }
    }
}

fn rods(upper_mass: f64, lower_mass: f64) -> rods::Swing {
    rods::Swing { upper_mass, lower_mass }
}

/// Angular accelerations of the rods at the start, by Lagrange's equations: two rows, as well conditioned as the problem.
fn reduced([m1, m2]: [f64; 2]) -> [f64; 2] {
    let (f1, f2, g) = (0.3_f64, -0.5_f64, 9.81);
    let (a, b, c) = (m1 / 3.0 + m2, m2 / 2.0 * (f1 - f2).cos(), m2 / 3.0);
    let (r1, r2) = (-g * (m1 / 2.0 + m2) * f1.cos(), -g * m2 / 2.0 * f2.cos());
    let determinant = a * c - b * b;
    [(r1 * c - r2 * b) / determinant, (a * r2 - b * r1) / determinant]
}

/// Up to a ratio of 1e4 the generated elimination divides by masses and loses as many digits; beyond it nothing is lost.
const ACCELERATIONS: f64 = 1e-12;

#[test]
fn analytic_accelerations_of_any_ratio_of_masses() {
    for exponent in 0..=16 {
        let heavy = 10_f64.powi(exponent);
        for masses in [[1.0, heavy], [heavy, 1.0], [1.0 / heavy, 1.0], [1.0, 1.0 / heavy]] {
            let scene = rods(masses[0], masses[1]);
            let mut system = system_of(&scene, Backend::Auto).unwrap();
            let State { t, q, v, .. } = system.consistent_start(&system.scene_start()).unwrap();
            let (mut a, mut lambda) = ([0.0; 6], [0.0; 4]);
            system.accelerations(t, &q, &v, &mut a, &mut lambda).unwrap();
            let exact = reduced(masses);
            let error = crate::scenes::distance(&[a[2], a[5]], &exact) / exact[0].abs().max(exact[1].abs());
            assert!(error <= ACCELERATIONS, "{masses:?} kg: {error:.1e}");
        }
    }
}

#[test]
fn cross_accelerations_of_a_rope_of_light_rods_are_the_dense_ones() {
    // the sparse solver, which divides by masses, leaves 1e-9 of a load that hangs on one light rod
    let accelerations = |n, backend| {
        let scene = rope::Swing { n, ..Default::default() };
        let mut system = system_of(&scene, backend).unwrap();
        let State { t, q, v, .. } = system.consistent_start(&system.scene_start()).unwrap();
        let (mut a, mut lambda) = (vec![0.0; q.len()], vec![0.0; system.info().n_rows()]);
        system.accelerations(t, &q, &v, &mut a, &mut lambda).unwrap();
        a
    };
    for n in [1, 2, 10] {
        let (found, exact) = (accelerations(n, Backend::Auto), accelerations(n, Backend::Dense));
        let largest = exact.iter().fold(0.0_f64, |largest, a| largest.max(a.abs()));
        let error = crate::scenes::distance(&found, &exact) / largest;
        assert!(error <= ACCELERATIONS, "{n} rods: {error:.1e}");
    }
}
