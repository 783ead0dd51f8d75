//! Every member by every method.

use super::judge::{Judged, Verdict, judge};
use super::members::Member;
use ezy_core::prelude::Method;
use std::collections::BTreeMap;
use std::fmt::Write as _;

/// From coarse to fine.
pub const TOLERANCES: [f64; 8] = [1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13];

/// Steps of RK4, in parts of 1/Ω.
pub const STEPS: [f64; 3] = [0.1, 0.03, 0.01];

/// Every method with every setting; `pace` is Ω of the motion, rad/s.
pub fn settings(pace: f64) -> Vec<(String, Method)> {
    let fixed = STEPS.iter().map(|part| (format!("rk4 {part}"), Method::rk4(part / pace)));
    let by = |name: &'static str, method: fn(f64) -> Method| {
        TOLERANCES.iter().map(move |&tolerance| (format!("{name} {tolerance:.0e}"), method(tolerance)))
    };
    let chosen = by("dop853", Method::dop853).chain(by("taylor", Method::taylor)).chain(by("radau", Method::radau));
    fixed.chain(chosen).collect()
}

/// What came of one setting over many members.
#[derive(Debug, Clone, Default)]
pub struct Tally {
    n: usize,
    right: usize,
    off: usize,
    refused: usize,
    untrue: usize,
    stuck: usize,
    /// Largest error over what is allowed, of runs that reached their end.
    worst: f64,
    /// Error of that run, rad.
    worst_rad: f64,
    largest_energy: f64,
    steps: u64,
}

impl Tally {
    fn add(&mut self, judged: &Judged) {
        self.n += 1;
        match judged.verdict {
            Verdict::Right => self.right += 1,
            Verdict::Off => self.off += 1,
            Verdict::Refused(_) => self.refused += 1,
            Verdict::Untrue(_) => self.untrue += 1,
            Verdict::Stuck => self.stuck += 1,
        }
        let over = judged.error / judged.allowed;
        if over > self.worst {
            (self.worst, self.worst_rad) = (over, judged.error);
        }
        if !judged.error.is_nan() {
            self.largest_energy = self.largest_energy.max(judged.energy);
        }
        self.steps += judged.steps;
    }
}

/// Runs all of them, calling `tell` with every run that is not right.
pub fn run_all(members: &[Member], only: Option<&str>, mut tell: impl FnMut(&str, &str, &Judged)) -> String {
    let (mut of_settings, mut order) = (BTreeMap::<String, Tally>::new(), Vec::new());
    for member in members {
        let course = member.course();
        for (setting, method) in settings(course.pace) {
            if only.is_some_and(|only| !setting.contains(only)) {
                continue;
            }
            let judged = judge(member, &course, method);
            if judged.verdict != Verdict::Right {
                tell(&member.name, &setting, &judged);
            }
            if !order.contains(&setting) {
                order.push(setting.clone());
            }
            of_settings.entry(setting).or_default().add(&judged);
        }
    }
    written(&of_settings, &order)
}

fn written(of_settings: &BTreeMap<String, Tally>, order: &[String]) -> String {
    let mut text = "| method | runs | right | off | refused | untrue | stuck | worst error over bound | its error, rad | worst energy | steps |\n\
                    |---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n"
        .to_owned();
    for setting in order {
        let Tally { n, right, off, refused, untrue, stuck, worst, worst_rad, largest_energy, steps } =
            of_settings[setting];
        let _ = writeln!(
            text,
            "| {setting} | {n} | {right} | {off} | {refused} | {untrue} | {stuck} | {worst:.1e} | {worst_rad:.1e} | {largest_energy:.1e} | {steps} |"
        );
    }
    text
}
