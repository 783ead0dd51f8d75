//! Parallel cranks through their level position: right, or refused with the rows and the reason that are true. All members, and
//! radau, which takes minutes without optimisation: the example `cranks`.

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
