//! Where a run ends, as JSON and as text.

use serde_json::{Value, json};

use ezy_core::dynamics::{MotionError, MovedValue};
use ezy_core::integrate::{Method, Tolerance};
use ezy_core::model::{List, Name, SceneInfo};
use ezy_core::record::Sample;
use ezy_core::scalar::{legible, legible_time, rounded};
use ezy_core::simulate::{
    EnergyError, ExceededLimit, Outcome, RankDeficientInterval, Run, SingularityCrossed, SoftestImpact, StopReason,
};
use ezy_study::report::table::{Table, fixed};

use super::run_error::{error_json, error_remark, error_text};
use super::run_monitors::{monitors_json, monitors_text};

/// The end as JSON. A run that could not start has the same keys with `null`. `free`: start values that were free.
pub(super) fn run_json(info: &SceneInfo, method: Method, run: Option<&Run>, free: &[Name], outcome: &str) -> Value {
    let last = run.map(Run::last);
    let named = |names: &mut dyn Iterator<Item = &str>, pick: fn(&Sample<'_>, usize) -> f64| -> Value {
        names.enumerate().map(|(i, name)| (name, json!(last.map(|last| pick(&last, i))))).collect()
    };
    let by_coordinate = |pick| named(&mut info.coordinates.iter().map(|c| &*c.name), pick);
    // rates of the coordinates, unless bodies have more positions than velocities
    let rated = if info.is_planar() { &info.coordinates } else { &info.velocities };
    let by_rate = |pick| named(&mut rated.iter().map(|c| &*c.name), pick);
    let mut end = json!({
        "model": info.model,
        "scene": info.name,
        "method": method.name(),
        "t": last.map(|last| last.t),
        "state": by_coordinate(|last, i| last.coordinates[i]),
        "rate": by_rate(|last, i| last.velocities[i]),
        "acceleration": by_rate(|last, i| last.accelerations[i]),
        "multipliers": named(&mut info.rows.iter().map(|row| &*row.name), |last, i| last.multipliers[i]),
    });
    if let Some(angle) = method.tolerance().and_then(|tolerance| tolerance.angle) {
        end["angle_tolerance"] = json!(angle);
    }
    if let Some([_, kept]) = lifted(method) {
        end["relative_tolerance"] = json!(kept);
    }
    if info.n_inputs() > 0 {
        end["inputs"] = named(&mut info.inputs.iter().map(|input| input.name), |last, i| last.inputs[i]);
    }
    if info.n_states() > 0 {
        end["states"] = named(&mut info.states.iter().map(|state| state.name), |last, i| last.states[i]);
    }
    if info.n_outputs() > 0 {
        end["outputs"] = named(&mut info.outputs.iter().map(|output| &*output.name), |last, i| last.outputs[i]);
    }
    if !info.events.is_empty() || !info.switches.is_empty() {
        let events = run.map_or(&[][..], Run::events).iter();
        end["events"] = events.map(|occurred| json!({ "name": occurred.event.name, "t": occurred.state.t })).collect();
    }
    let energy = last.map(|last| last.energy);
    end["energy"] = json!({
        "kinetic": energy.map(|energy| energy.kinetic),
        "potential": energy.map(|energy| energy.potential),
        "work": energy.map(|energy| energy.work),
        "balance": energy.map(|energy| energy.balance),
    });
    end["residual"] = json!({
        "position": last.map(|last| last.position_residual),
        "velocity": last.map(|last| last.velocity_residual),
    });
    end["monitors"] = monitors_json(run.map(|run| &run.monitors));
    end["added_up"] = json!(run.and_then(|run| added_up(run, method)));
    end["attainable_tolerance"] = json!(run.and_then(|run| attainable(run, method)));
    end["stiff_since"] = json!(run.and_then(|run| run.stiff_since_s));
    let cost = run.map(|run| run.cost);
    end["cost"] = json!({
        "steps": cost.map(|cost| cost.steps),
        "rejected": cost.map(|cost| cost.rejected),
        "evaluations": cost.map(|cost| cost.evaluations),
        "factorizations": cost.map(|cost| cost.factorizations),
        "seconds": cost.map(|cost| cost.seconds),
    });
    end["outcome"] = json!(outcome);
    if let Some(estimate) = run.and_then(|run| run.error_estimate.as_ref()) {
        end["error_estimate"] = error_json(estimate);
    }
    if let Some(rank) = run.map(|run| &run.rank).filter(|rank| !rank.intervals.is_empty()) {
        end["rank"] = rank.intervals.iter().map(interval_json).collect();
    }
    if let Some(rank) = run.map(|run| &run.rank).filter(|rank| !rank.crossings.is_empty()) {
        let of = |crossed: &SingularityCrossed| json!({ "from": crossed.from_s, "to": crossed.to_s, "nearest": crossed.nearest });
        end["crossings"] = rank.crossings.iter().map(of).collect();
    }
    if let Some(moved) = run.map(|run| &run.moved).filter(|moved| !moved.is_empty()) {
        let of = |MovedValue { name, unit, given, got }: &MovedValue| json!({ "name": name, "unit": unit, "given": given, "got": got });
        end["gave_way"] = moved.iter().map(of).collect();
    }
    if !free.is_empty() {
        end["free_at_start"] = json!(free);
    }
    end
}

/// An interval in which constraints were redundant.
fn interval_json(RankDeficientInterval { from_s, to_s, loss }: &RankDeficientInterval) -> Value {
    json!({
        "from": from_s, "to": to_s, "redundant": loss.n_redundant, "freedom": loss.freedom(), "rows": loss.rows,
    })
}

/// The end as text. `free`: start values that were free.
pub(super) fn run_text(run: &Run, free: &[Name], method: Method, radau_runs: bool) -> String {
    let (info, last, cost) = (run.info(), run.last(), run.cost);
    let mut text =
        format!("{}/{}: {} at t = {} s\n\n", info.model, info.name, outcome_words(&run.outcome), legible_time(last.t));
    text += &moved_text(&run.moved);
    text += &free_text(free);
    text += &motion_table(&last).to_string();
    text += &left_out(info.n_coordinates(), "coordinates");
    if info.n_rows() > 0 {
        let mut table = Table::new(["row", "multiplier", "unit"]);
        for (row, lambda) in first(&info.rows).iter().zip(last.multipliers) {
            table.push([row.name.to_string(), fixed(*lambda, 12), row.multiplier_unit.to_owned()]);
        }
        text += &format!("\n{table}{}", left_out(info.n_rows(), "rows"));
    }
    let inputs = info.inputs.iter().zip(last.inputs).map(|(input, value)| (input.name, value, input.unit));
    let states = info.states.iter().zip(last.states).map(|(state, value)| (state.name, value, state.unit));
    let outputs = info.outputs.iter().zip(last.outputs).map(|(output, value)| (&*output.name, value, output.unit));
    for (title, values) in
        [("input", inputs.collect::<Vec<_>>()), ("state", states.collect()), ("output", outputs.collect())]
    {
        if !values.is_empty() {
            let mut table = Table::new([title, "value", "unit"]);
            values.iter().for_each(|(name, value, unit)| table.push([*name, &fixed(**value, 12), *unit]));
            text += &format!("\n{table}");
        }
    }
    if !run.events().is_empty() {
        let mut table = Table::new(["event", "t", "unit"]);
        for occurred in run.events().iter().take(MAX_LINES) {
            table.push([occurred.event.name, &fixed(occurred.state.t, 12), "s"]);
        }
        text += &format!("\n{table}{}", left_out(run.events().len(), "events"));
    }
    let energy = last.energy;
    text += &format!(
        "\nkinetic energy {} J, potential energy {} J, work {} J, balance {:.1e} J\n\
         constraint residual: positions {:.1e}, velocities {:.1e}\n{}\
         {} steps, {} evaluations of the accelerations, {:.3} s\n",
        fixed(energy.kinetic, 12),
        fixed(energy.potential, 12),
        fixed(energy.work, 12),
        energy.balance,
        last.position_residual,
        last.velocity_residual,
        monitors_text(run),
        cost.steps,
        cost.evaluations,
        cost.seconds
    );
    text += &added_up_text(run, method);
    text += &error_text(run);
    text += &run.rank.to_string();
    text + &remarks(run, method, radau_runs)
}

/// The start values that gave way; nothing where none did.
fn moved_text(moved: &[MovedValue]) -> String {
    if moved.is_empty() {
        return String::new();
    }
    let mut table = Table::new(["gave way at the start", "given", "got", "unit"]);
    for MovedValue { name, unit, given, got } in moved.iter().take(MAX_LINES) {
        table.push([&**name, &fixed(*given, 12), &fixed(*got, 12), *unit]);
    }
    format!("{table}{}\n", left_out(moved.len(), "start values"))
}

/// The start values that nobody gave and no constraint determined; nothing where there are none.
fn free_text(free: &[Name]) -> String {
    if free.is_empty() {
        return String::new();
    }
    let more = if free.len() > MAX_NAMES { format!(" and {} more", free.len() - MAX_NAMES) } else { String::new() };
    let names = &free[..free.len().min(MAX_NAMES)];
    format!("free at the start, so assembled from 0: {}{more}\n\n", names.join(", "))
}

/// Remarks on a run. `radau_runs`: whether radau can run the scene.
pub(super) fn remarks(run: &Run, method: Method, radau_runs: bool) -> String {
    let is_explicit = !method.info().is_implicit;
    let stiff = match run.stiff_since_s {
        Some(t) => format!(
            "remark: from t = {} s on, or before, the steps of {} were limited by stiffness, not by the tolerance; try --method radau\n",
            rounded(t, 4),
            method.name()
        ),
        None if is_explicit && radau_runs && may_be_stiff(&run.outcome) => {
            format!("remark: if the scene is stiff, {IMPLICIT}\n")
        }
        None => String::new(),
    };
    let names_radau = !stiff.is_empty();
    lifted_remark(method)
        + &stiff
        + &attainable_remark(run, method)
        + &impacts_remark(run, method)
        + &beside_remark(run)
        + &remark(run, method, radau_runs && !names_radau)
        + &error_remark(run)
}

/// A relative tolerance below rounding, and the one that the run kept to.
fn lifted(method: Method) -> Option<[f64; 2]> {
    let [asked, kept] = [method, method.lifted()].map(|method| method.tolerance().map(|tolerance| tolerance.relative));
    asked.zip(kept).filter(|(asked, kept)| asked < kept).map(|(asked, kept)| [asked, kept])
}

/// What errors of steps add up to where they have one sign, of one more than each number.
fn added_up(run: &Run, method: Method) -> Option<f64> {
    method.lifted().tolerance().map(|tolerance| run.cost.steps as f64 * largest(tolerance))
}

fn added_up_text(run: &Run, method: Method) -> String {
    added_up(run, method).map_or(String::new(), |sum| {
        format!("errors of these steps may add up to {sum:.1e} of one more than each number, before the motion amplifies them\n")
    })
}

/// What a step may change a number of one, or an angle, by.
fn largest(tolerance: Tolerance) -> f64 {
    let Tolerance { relative, absolute, angle } = tolerance;
    relative.max(absolute).max(angle.unwrap_or_default())
}

/// Rounding of ten numbers or less is told by no remark.
const SMALLEST_TOLD: f64 = 10.0 * Tolerance::SMALLEST_RELATIVE;

/// The tolerance that a run can keep, where it is larger than the one that is asked for: by rounding, and by the iteration of the method.
fn attainable(run: &Run, method: Method) -> Option<f64> {
    let of_equations = run.monitors.condition.as_ref().map_or(0.0, |condition| condition.rounding);
    let attainable = of_equations.max(method.iteration_floor());
    let asked = method.lifted().tolerance()?;
    (attainable > asked.relative.max(asked.absolute).max(SMALLEST_TOLD)).then_some(attainable)
}

fn attainable_remark(run: &Run, method: Method) -> String {
    attainable(run, method).map_or(String::new(), |attainable| {
        let floor = method.iteration_floor();
        let why = match floor < attainable {
            true => "rounding limits accelerations and multipliers",
            false => "the iteration of the method stops",
        };
        format!("remark: the tolerance is not reached: {why} at {attainable:.0e} of one more than each number\n")
    })
}

/// Impacts softer than so many tolerances may be errors of the motion.
const SOFT: f64 = 100.0;

fn impacts_remark(run: &Run, method: Method) -> String {
    match (run.monitors.softest_impact, method.tolerance()) {
        (Some(SoftestImpact { speed, .. }), Some(tolerance)) if speed < SOFT * tolerance.absolute => {
            format!(
                "remark: the softest impact has {speed:.0e} m/s or rad/s, less than {SOFT} tolerances: number and times of such impacts are not \
                 reliable\n"
            )
        }
        _ => String::new(),
    }
}

fn beside_remark(run: &Run) -> String {
    let beside = run.rank.crossings.iter().find(|crossed| crossed.is_beside());
    beside.map_or(String::new(), |SingularityCrossed { from_s, nearest, .. }| {
        format!(
            "remark: from t = {} s on the run passes beside a singular position, at {nearest:.0e} of its distance before; small errors decide \
             there, and a run with a smaller tolerance may go another way: compare with one\n",
            rounded(*from_s, 6)
        )
    })
}

fn lifted_remark(method: Method) -> String {
    lifted(method).map_or(String::new(), |[asked, kept]| {
        format!("remark: the relative tolerance {asked:e} is below rounding; the run kept to {kept:e}\n")
    })
}

/// Advice when stiffness limits the steps of an explicit method.
const IMPLICIT: &str = "--method radau takes longer steps";

/// Whether an explicit method may have stopped for stiffness.
fn may_be_stiff(outcome: &Outcome) -> bool {
    use MotionError::{NotFinite, ProjectionStalled, StepCollapsed};
    match outcome {
        Outcome::Stopped { reason: StopReason::Limit(limit), .. } => {
            matches!(limit, ExceededLimit::Steps { .. } | ExceededLimit::Pace { .. })
        }
        Outcome::Stopped { reason: StopReason::Motion(error), .. } => {
            matches!(error, NotFinite { .. } | ProjectionStalled { .. } | StepCollapsed { .. })
        }
        _ => false,
    }
}

/// What energy and work may differ by, in tolerances of the energy turned over; in runs of more steps as many tolerances as steps, since errors may add up.
const ALLOWED: f64 = 100.0;

/// The remark on a run whose energy and work differ by more than its steps explain, or than three digits: the figure of the monitors.
fn remark(run: &Run, method: Method, radau_runs: bool) -> String {
    run.monitors.energy.map_or(String::new(), |energy| energy_remark(energy, run.cost.steps, method, radau_runs))
}

fn energy_remark(energy: EnergyError, steps: u64, method: Method, radau_runs: bool) -> String {
    let EnergyError { relative: share, t, .. } = energy;
    let explained = match method.tolerance() {
        Some(tolerance) => ALLOWED.max(steps as f64) * largest(tolerance),
        None => f64::INFINITY,
    };
    if share <= explained.min(EnergyError::LARGEST_OF_FIXED_STEPS) {
        return String::new();
    }
    let difference = if share.is_finite() {
        format!("differ by {share:.1e} of the energy turned over at t = {} s", rounded(t, 4))
    } else {
        "are not finite".to_owned()
    };
    if share > explained {
        return format!(
            "remark: energy and work {difference}, more than the tolerance explains: step control does not look at works, so take a smaller \
             tolerance for them; compare with another method, and look at positions where constraints nearly depend on each other\n"
        );
    }
    let (what, better) = match method.step_s() {
        Some(step_s) => {
            let or = if radau_runs { format!("; if the scene is stiff, {IMPLICIT}") } else { String::new() };
            (format!("the step of {} s", legible(step_s)), format!("--step {:.0e}{or}", step_s / 10.0))
        }
        None => {
            let relative = method.setting();
            if relative <= Tolerance::SMALLEST_RELATIVE {
                return format!(
                    "remark: energy and work {difference} at the smallest tolerance; compare with --method rk4\n"
                );
            }
            let better = (relative / 10.0).max(Tolerance::SMALLEST_RELATIVE);
            ("the tolerance".to_owned(), format!("--rtol {better:.0e}"))
        }
    };
    format!("remark: energy and work {difference}: {what} is too large for this motion; try {better}\n")
}

fn outcome_words(outcome: &Outcome) -> String {
    match outcome {
        Outcome::ReachedEnd => "reached the end".to_owned(),
        Outcome::ReachedEvent { name, .. } => format!("reached `{name}`"),
        Outcome::Untrusted { .. } => "reached the end, but is not to be trusted,".to_owned(),
        Outcome::Interrupted { .. } => "interrupted".to_owned(),
        _ => "stopped".to_owned(),
    }
}

/// Coordinates and constraints that the text lists; further ones are counted.
const MAX_LINES: usize = 60;

/// Names in a line that lists them; further ones are counted.
const MAX_NAMES: usize = 12;

/// The line that counts what a table leaves out.
fn left_out(n: usize, what: &str) -> String {
    if n <= MAX_LINES {
        return String::new();
    }
    format!("and {} more {what}; --json or --out FILE.csv has all\n", n - MAX_LINES)
}

/// What a table lists: a long one is not made as a whole.
fn first<T: Clone>(list: &List<T>) -> Vec<T> {
    list.range(0..MAX_LINES.min(list.len()))
}

fn motion_table(last: &Sample<'_>) -> Table {
    let mut table = Table::new(["coordinate", "value", "velocity", "acceleration", "unit"]);
    for (i, coordinate) in first(&last.info.coordinates).iter().enumerate() {
        let [q, v, a] = [last.coordinates[i], last.velocities[i], last.accelerations[i]].map(|x| fixed(x, 12));
        table.push([&*coordinate.name, &q, &v, &a, coordinate.unit]);
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An energy balance of this share.
    fn off_by(relative: f64) -> EnergyError {
        EnergyError { joules: relative, relative, t: 1.0 }
    }

    #[test]
    fn invariant_remark_proposes_tolerances_that_a_run_accepts() {
        // as many steps as explain all
        let remarks =
            [1e-3, 2e-15, 1e-15].map(|tolerance| energy_remark(off_by(1.0), u64::MAX, Method::taylor(tolerance), true));
        let ends =
            ["try --rtol 1e-4\n", "try --rtol 1e-15\n", "at the smallest tolerance; compare with --method rk4\n"];
        for (remark, end) in remarks.iter().zip(ends) {
            assert!(remark.ends_with(end), "{remark}");
        }
    }

    #[test]
    fn invariant_smaller_step_is_not_all_that_rk4_is_told_where_radau_runs() {
        let [with, without] =
            [true, false].map(|radau_runs| energy_remark(off_by(1.0), 10, Method::rk4(1e-7), radau_runs));
        assert!(
            with.ends_with("try --step 1e-8; if the scene is stiff, --method radau takes longer steps\n"),
            "{with}"
        );
        assert!(without.contains("the step of 1e-7 s") && without.ends_with("try --step 1e-8\n"), "{without}");
    }

    #[test]
    fn invariant_energy_that_is_not_finite_is_remarked_on() {
        for share in [f64::NAN, f64::INFINITY] {
            let remark = energy_remark(off_by(share), 10, Method::rk4(0.001), false);
            assert!(remark.contains("energy and work are not finite"), "{remark}");
        }
        assert_eq!(energy_remark(off_by(0.0), 10, Method::rk4(0.001), true), "");
    }

    #[test]
    fn invariant_what_the_tolerance_does_not_explain_is_remarked_on() {
        let remark = |share, steps, tolerance| energy_remark(off_by(share), steps, Method::dop853(tolerance), true);
        // 100 tolerances, and 1,000 in 1,000 steps
        for (share, steps) in [(1e-9, 100), (1e-8, 1000)] {
            assert_eq!(remark(0.9 * share, steps, 1e-11), "");
            let beyond = remark(1.1 * share, steps, 1e-11);
            assert!(beyond.contains("of the energy turned over at t = 1 s, more than the tolerance"), "{beyond}");
        }
        assert!(remark(2e-3, 100, 1e-4).ends_with("try --rtol 1e-5\n"));
    }
}
