//! The pendulum by which parallel cranks are judged.

use ezy_core::prelude::Method;
use ezy_tests::parallel_cranks::judge::{Verdict, judge};
use ezy_tests::parallel_cranks::members::members;
use ezy_tests::parallel_cranks::pendulum::{Pendulum, Swing};
use std::f64::consts::{FRAC_PI_2, PI};

/// What the oracle is used to: its own errors are far below what any run keeps to.
const ORACLE: f64 = 1e-13;

/// Period of a pendulum, by the arithmetic-geometric mean: 2π/(√κ agm(1, cos(a/2))), a the amplitude.
fn period(kappa: f64, amplitude: f64) -> f64 {
    let (mut a, mut g) = (1.0_f64, (0.5 * amplitude).cos());
    while (a - g).abs() > f64::EPSILON {
        (a, g) = (0.5 * (a + g), (a * g).sqrt());
    }
    2.0 * PI / (kappa.sqrt() * a)
}

#[test]
fn analytic_oracle_pendulum_returns_after_ten_periods() {
    for (kappa, amplitude) in [(9.81, 0.3), (3.7, 2.1), (14.0, 3.0)] {
        let start = Swing { angle: amplitude - FRAC_PI_2, rate: 0.0 };
        let course = Pendulum { kappa }.run(start, 0.0, 10.0 * period(kappa, amplitude));
        let off = (course.end.angle - start.angle).abs().max(course.end.rate.abs() / course.pace);
        assert!(off <= ORACLE * course.growth, "{amplitude}: {off:.1e}, growth {:.1e}", course.growth);
    }
}

#[test]
fn analytic_oracle_pendulum_turns_at_its_energy_and_knows_its_level_positions() {
    let pendulum = Pendulum { kappa: 6.0 };
    let start = Swing { angle: 0.5, rate: 8.0 };
    let course = pendulum.run(start, 0.2, 3.0);
    let drift = (pendulum.energy(course.end) / pendulum.energy(start) - 1.0).abs();
    assert!(drift <= ORACLE, "{drift:.1e}");
    assert_eq!(course.n_level, ((course.end.angle - 0.2) / PI) as u32);
    // slowest in the level position above, at 0.2 + 2π
    let there = (2.0 * (pendulum.energy(start) - 6.0 * 0.2_f64.sin())).sqrt();
    assert!((course.slowest_level - there).abs() <= ORACLE * there, "{} and {there}", course.slowest_level);
}

/// Times of an error at which its growth is looked at; between two of them it changes by a few hundredths.
const N_TIMES: u32 = 80;

#[test]
fn fd_oracle_growth_is_that_of_errors_made_on_the_way() {
    const ERROR: f64 = 1e-6;
    let (pendulum, start, duration) = (Pendulum { kappa: 6.0 }, Swing { angle: 1.4, rate: 0.0 }, 4.0);
    let course = pendulum.run(start, 0.0, duration);
    let omega = course.pace;
    let growth_from = |t: f64| {
        let at = if t > 0.0 { pendulum.run(start, 0.0, t).end } else { start };
        let end = |angle, rate| pendulum.run(Swing { angle, rate }, 0.0, duration - t).end;
        let (exact, by_angle) = (end(at.angle, at.rate), end(at.angle + ERROR, at.rate));
        let by_rate = end(at.angle, at.rate + omega * ERROR);
        let of = |change: fn(Swing) -> f64| {
            ((change(by_angle) - change(exact)).abs() + (change(by_rate) - change(exact)).abs()) / ERROR
        };
        of(|swing| swing.angle).max(of(|swing| swing.rate) / omega)
    };
    let largest = (0..N_TIMES).map(|i| growth_from(duration * f64::from(i) / f64::from(N_TIMES))).fold(0.0, f64::max);
    assert!((largest / course.growth - 1.0).abs() <= 0.05, "{largest} and {}", course.growth);
}

/// What Radau at 1e-9 leaves of the energy of five cranks: a few hundred steps. It was 1e-7 while multipliers that redundant rows share grew from
/// step to step.
const ENERGY: f64 = 1e-8;

#[test]
fn invariant_radau_with_redundant_rows_keeps_the_energy() {
    for member in members().iter().filter(|member| member.name.starts_with("5 cranks")) {
        let judged = judge(member, &member.course(), Method::radau(1e-9));
        let (name, energy) = (&member.name, judged.energy);
        assert!(judged.verdict == Verdict::Right && energy <= ENERGY, "{name}: {:?}, {energy:.1e}", judged.verdict);
    }
}
