//! Parallel cranks through their level position: right, or refused with the rows and the reason that are true. All members, and
//! radau, which takes minutes without optimisation: the example `measure`.

#![allow(non_snake_case)]

use ezy_core::prelude::*;
use ezy_core_tests::system_of;
use ezy_tests::hard::models::five_cranks;
use ezy_tests::parallel_cranks::judge::{Verdict, judge};
use ezy_tests::parallel_cranks::members::{Member, members};
use ezy_tests::parallel_cranks::table::settings;

/// Every `each`-th member from `first` on: all numbers of cranks, all kinds of starts, written out and counted.
fn some(first: usize, each: usize) -> Vec<Member> {
    members().into_iter().skip(first).step_by(each).collect()
}

/// Runs them by one method with all of its settings, and lists what is wrong; a truthful refusal passes.
fn wrong(members: &[Member], name: &str) -> Vec<String> {
    let mut wrong = Vec::new();
    for member in members {
        let course = member.course();
        let of_method = settings(course.pace).into_iter().filter(|(setting, _)| setting.starts_with(name));
        for (setting, method) in of_method {
            let judged = judge(member, &course, method);
            let passes = match &judged.verdict {
                Verdict::Right | Verdict::Refused(_) => true,
                Verdict::Off | Verdict::Untrue(_) | Verdict::Stuck => false,
            };
            if !passes {
                let (name, error, allowed) = (&member.name, judged.error, judged.allowed);
                wrong.push(format!("{name}, {setting}: {:?}, {error:.1e} of {allowed:.1e} rad", judged.verdict));
            }
        }
    }
    wrong
}

fn assert_none(wrong: &[String]) {
    assert!(wrong.is_empty(), "{} runs:\n{}", wrong.len(), wrong.join("\n"));
}

#[test]
fn analytic_level_cranks_by_dop853_are_a_pendulum_or_refused() {
    assert_none(&wrong(&some(0, 11), "dop853"));
}

#[test]
fn analytic_level_cranks_by_taylor_are_a_pendulum_or_refused() {
    assert_none(&wrong(&some(1, 11), "taylor"));
}

#[test]
fn analytic_level_cranks_by_rk4_are_a_pendulum_or_refused() {
    assert_none(&wrong(&some(2, 34), "rk4"));
}

/// A crossing step as exact as possible would end so near to the position that positions cannot be projected there.
#[test]
fn analytic_three_level_cranks_by_rk4_are_a_pendulum() {
    let of_three: Vec<Member> =
        members().into_iter().filter(|member| member.name.starts_with("3 cranks, level at 0.47")).collect();
    assert_eq!(of_three.len(), 1);
    assert_none(&wrong(&of_three, "rk4"));
}

/// With 52 equations the stages of a step are still solved together where the simplified iteration does not converge.
#[test]
fn analytic_seven_level_cranks_by_radau_are_a_pendulum_in_few_steps() {
    /// What six cranks take.
    const MOST_STEPS: u64 = 60;
    let member = members().into_iter().find(|member| member.name.starts_with("7 counted, released 0.05")).unwrap();
    let judged = judge(&member, &member.course(), Method::radau(1e-6));
    assert!(judged.verdict == Verdict::Right && judged.steps <= MOST_STEPS, "{judged:?}");
}

/// Rank of G of the five cranks at one angle, by the singular values of G and as EZY reports it.
fn ranks_at(angle: f64) -> [usize; 2] {
    /// Singular values of G are 0.1 and more, or rounding.
    const ZERO: f64 = 1e-9;
    let scene = five_cranks::Fall::default();
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    let info = scene.info();
    let (sin, cos) = angle.sin_cos();
    let mut q = vec![cos + 1.3, sin, 0.0];
    (0..5).for_each(|k| q.extend([f64::from(k) + 0.5 * cos, 0.5 * sin, angle]));
    assert!(system.position_residual(0.0, &q) < 1e-15);
    let mut entries = vec![0.0; info.jacobian.n_nonzeros()];
    scene.velocity_jacobian(system.fixed(), 0.0, &q, &mut entries);
    let mut G = nalgebra::DMatrix::<f64>::zeros(info.n_rows(), info.n_coordinates());
    info.jacobian.entries().for_each(|(k, row, column)| G[(row, column)] += entries[k]);
    let by_singular_values = G.singular_values().iter().filter(|value| **value > ZERO).count();
    let loss = system.rank_loss(0.0, &q);
    [by_singular_values, info.n_rows() - loss.n_redundant.unwrap()]
}

#[test]
fn analytic_rank_of_five_cranks_is_17_and_16_where_they_lie_level() {
    for angle in [1.3, 0.4, -0.01, 2.0] {
        assert_eq!(ranks_at(angle), [17, 17], "{angle}");
    }
    assert_eq!(ranks_at(0.0), [16, 16]);
}
