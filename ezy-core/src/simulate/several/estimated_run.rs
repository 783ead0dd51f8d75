//! The error that a run reaches, estimated by other runs beside it.
//!
//! A second run keeps to a thousandth of the tolerance; that of a fixed step is one with a tolerance, that of gauss one of dop853. Its own error is small beside that of the first, so
//! that the difference is the error of the first; by chance both are alike at a time, so that what the second is off by is added. Where it takes about as many steps as the first, its error is about the same: a run of another method, near rounding, follows both
//! and takes its place. A third run is like the second, from a start that is moved a little: it shows how much the
//! motion amplifies errors.

use crate::dynamics::State;
use crate::integrate::second_run::{ROUNDING, TIGHTER};
use crate::integrate::{Method, MethodKind, Tolerance};
use crate::model::{Scene, Start};
use crate::record::Sample;
use crate::scalar::GOLDEN_RATIO;
use crate::simulate::error_estimate::{ErrorEstimate, NoErrorEstimate, QuantityError};
use crate::simulate::monitor::{Caller, Limits};
use crate::simulate::recording::sample_times::Sampling;
use crate::simulate::simulation::{Hooks, Settings};
use crate::simulate::tolerances::error_estimate::{AS_MANY, FIRST_STEPS, LOOSER, MOVED, SMALLEST_MOVE};
use crate::simulate::tolerances::orders::LARGEST_TOLERANCE;
use crate::simulate::tolerances::samples::ON_STEP;
use crate::simulate::{Outcome, Run, SetupError, Simulation};
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{self, ScopedJoinHandle};

/// Runs, and estimates the error.
pub(in crate::simulate) fn run(simulation: Simulation<'_, &dyn Scene>) -> Result<Run, SetupError> {
    if simulation.hooks.law.is_some() {
        return Err(SetupError::ControlledOnce);
    }
    let Simulation { scene, settings, hooks } = simulation;
    let ended_early = AtomicBool::new(false);
    let interrupts: Vec<&AtomicBool> = hooks.caller.interrupts.iter().copied().chain([&ended_early]).collect();
    let of_others = Settings {
        sampling: Sampling { times: settings.sampling.times.clone(), ..Sampling::default() },
        limits: Limits { steps: settings.limits.steps, ..Limits::default() },
        estimated: false,
        ..settings.clone()
    };
    let first = settings.solver.method;
    let methods = seconds(first);
    let other = |method: Method, moved_by: f64| {
        let hooks = Hooks { caller: Caller::interrupted_by(interrupts.clone()), ..Hooks::default() };
        let mut settings = of_others.clone();
        (settings.solver.method, settings.start.moved_by) = (method, moved_by);
        finished(Simulation { scene, settings, hooks }.run_once())
    };
    let first_finished = |methods: &[Method], run: &dyn Fn(Method) -> Result<Run, String>| {
        let mut why = "was not made".to_owned();
        for &method in methods {
            match run(method) {
                Ok(run) => return Ok((method, run)),
                Err(cause) => why = cause,
            }
        }
        Err(why)
    };
    thread::scope(|scope| {
        let second = scope.spawn(|| first_finished(&methods, &|method| other(method, 0.0)));
        let moved = scope.spawn(|| first_finished(&methods, &|method| other(method, length_of_move(method))));
        let sampling = Sampling { streamed: false, ..settings.sampling };
        let main = Simulation { scene, settings: Settings { sampling, ..settings }, hooks }.run_once();
        let is_complete = main.as_ref().is_ok_and(|run| run.outcome.is_complete());
        ended_early.store(!is_complete, Ordering::Relaxed);
        let (second, moved) = (joined(second), joined(moved));
        let mut main = main?;
        main.error_estimate = Some(match second {
            _ if !is_complete => Err(NoErrorEstimate("the run did not come to its end".to_owned())),
            Ok((method, second)) => {
                let moved = moved.ok().filter(|(by, _)| *by == method);
                let amplification = moved.map(|(_, moved)| amplification(&second, &moved, length_of_move(method)));
                let second = if takes_the_same_steps((method, &second), (first, &main)) {
                    let are_as_many = second.cost.steps == main.cost.steps;
                    let instead = first_finished(&others(first, are_as_many), &|method| match other(method, 0.0)? {
                        run if run.cost.steps == main.cost.steps && method.kind() == first.kind() => {
                            Err("took them, too".to_owned())
                        }
                        run => Ok(run),
                    });
                    // in a decay steps of an implicit method grow as far as they may: hardly more of them may tell the error all the same
                    if first.info().is_implicit && !are_as_many { instead.or(Ok((method, second))) } else { instead }
                } else {
                    Ok((method, second))
                };
                match second {
                    Ok((second, run)) => {
                        let of_second = error_of_second((second, &run), (first, &main));
                        Ok(ErrorEstimate { errors: errors(&main, &run, of_second), amplification, second })
                    }
                    Err(why) => {
                        Err(NoErrorEstimate(format!("the second run took the same steps, and another one {why}")))
                    }
                }
            }
            Err(why) => Err(NoErrorEstimate(format!("the second run {why}"))),
        });
        Ok(main)
    })
}

/// Whether a second run has about the errors of the first: it takes as many steps, or hardly more with a smaller tolerance. Something else limits most of them
/// then: the first steps of a run hardly depend on its tolerance. Not for `taylor`, which raises its order instead.
fn takes_the_same_steps((second, of_second): (Method, &Run), (first, of_first): (Method, &Run)) -> bool {
    let [many, few] = [of_second, of_first].map(|run| run.cost.steps);
    let relative = |method: Method| method.tolerance().map(|tolerance| tolerance.relative);
    let is_tighter = relative(second) < relative(first);
    let needs_more = first.info().order.is_some();
    let are_as_many = many == few || is_tighter && needs_more && (many as f64) < AS_MANY * few as f64 + FIRST_STEPS;
    // as many steps of another method are chance
    second.kind() == first.kind() && are_as_many
}

/// What a second run is off by, over the difference of both: as their steps have it where both are of one order, otherwise as if errors went with the tolerance.
/// Zero where the second run is the coarser one: the difference is its error.
fn error_of_second((second, of_second): (Method, &Run), (first, of_first): (Method, &Run)) -> f64 {
    let order = first.info().order.filter(|_| second.kind() == first.kind());
    let longer = of_first.cost.steps as f64 / of_second.cost.steps as f64;
    let of_first = |order: u32| longer.powi(order as i32);
    order.map_or(TIGHTER, |order| if longer < 1.0 { of_first(order) / (1.0 - of_first(order)) } else { 0.0 })
}

/// What a thread returned; its panic goes on in this one.
fn joined<T>(thread: ScopedJoinHandle<'_, T>) -> T {
    thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
}

/// A run that came to its end, or why there is none.
fn finished(run: Result<Run, SetupError>) -> Result<Run, String> {
    match run {
        Ok(run) if run.outcome.is_complete() => Ok(run),
        Ok(run) => Err(run.outcome.to_string()),
        Err(error) => Err(format!("could not start: {error}")),
    }
}

/// How a second run is made, each next one where that before does not come to its end. At the level of rounding another method shows what
/// the same one would do in the same way again. A larger tolerance gives too large an error rather than none.
fn seconds(method: Method) -> Vec<Method> {
    let (kind, info) = (method.kind(), method.info());
    let Some(tolerance) = method.tolerance() else {
        // half the step may sample a fast force as seldom
        let half = method.step_s().and_then(|step_s| kind.with_step(0.5 * step_s));
        return [Method::dop853(ROUNDING)].into_iter().chain(half).collect();
    };
    let relative = tolerance.relative;
    let with = |other: f64| tolerance.with_relative(other);
    // for radau, too, below what its iteration reaches: its steps are shorter all the same
    let tighter = with(Tolerance::SMALLEST_RELATIVE.max(info.tighter * relative));
    let looser = with(LARGEST_TOLERANCE.min(LOOSER * relative));
    let other = if kind == MethodKind::Dop853 { MethodKind::Taylor } else { MethodKind::Dop853 };
    let first = if relative < info.rounding { other } else { kind };
    [first.with_tolerance(tighter), kind.with_tolerance(looser)].into_iter().flatten().collect()
}

/// How a second run is made where the same method takes the same steps, as over a very short time. Their errors may be far below the tolerance: another method
/// goes near rounding. For an implicit one, whose scene may be stiff, it is the same, and explicit ones where the steps are `as_many` exactly.
fn others(method: Method, as_many: bool) -> Vec<Method> {
    let Some(tolerance) = method.tolerance() else { return Vec::new() };
    let relative = (TIGHTER * TIGHTER * tolerance.relative).min(LOOSER * ROUNDING);
    let tighter = tolerance.with_relative(relative.max(Tolerance::SMALLEST_RELATIVE));
    // one far below the relative tolerance is not made smaller than rounding
    let absolute = tighter.absolute.max(tolerance.absolute.min(Tolerance::SMALLEST_RELATIVE));
    let tighter = Tolerance { absolute, ..tighter };
    let (info, mut all) = (method.info(), Vec::new());
    if info.is_implicit {
        let same = method.kind().with_tolerance(tolerance.with_relative(info.rounding));
        all.extend(same.filter(|_| info.rounding < TIGHTER * tolerance.relative));
    }
    if as_many || !info.is_implicit {
        let explicit = [MethodKind::Dop853, MethodKind::Taylor, MethodKind::Gauss].into_iter();
        let explicit = explicit.filter(|other| *other != method.kind());
        all.extend(explicit.filter_map(|other| other.with_tolerance(tighter)));
    }
    all
}

/// What the start of a third run is moved by, of the sizes of its numbers: large beside the errors of that run, small enough for changes
/// to add up.
fn length_of_move(method: Method) -> f64 {
    let tolerance = method.tolerance().map_or(0.0, |tolerance| tolerance.relative);
    (MOVED * tolerance).max(SMALLEST_MOVE)
}

/// A start beside `state`: each number moved by up to `by` of its size, by an amount of its own to one side or the other.
pub(in crate::simulate) fn beside(state: &State, by: f64) -> Start {
    let mut start = Start { t: state.t, ..Start::of(state.q.len(), state.v.len()) };
    let amounts = (1..).map(|i: u32| 2.0 * (f64::from(i) * GOLDEN_RATIO).fract() - 1.0);
    start.z.clone_from(&state.z);
    let numbers =
        start.q.iter_mut().chain(&mut start.v).chain(&mut start.z).zip(state.q.iter().chain(&state.v).chain(&state.z));
    numbers.zip(amounts).for_each(|((moved, x), amount)| *moved = x + by * amount * (1.0 + x.abs()));
    start
}

/// Pairs of samples at one time, the ends of both runs last.
fn pairs<'r>(one: &'r Run, other: &'r Run) -> impl Iterator<Item = (Sample<'r>, Sample<'r>)> {
    let near = ON_STEP * (one.last().t - one.first().t);
    let n = one.samples().len().min(other.samples().len());
    let grid = one.samples().zip(other.samples()).take(n - 1);
    grid.take_while(move |(a, b)| (a.t - b.t).abs() <= near).chain([(one.last(), other.last())])
}

/// Positions or velocities or multipliers of a sample.
type Numbers = for<'r> fn(&Sample<'r>) -> &'r [f64];

/// Differences of two runs, by unit, and at each time what the other run may be off by: so much of the largest.
fn errors(one: &Run, other: &Run, of_other: f64) -> Vec<QuantityError> {
    let info = one.info();
    let of_rate = |unit: &str| format!("{unit}/s");
    let positions = info.coordinates.iter().map(|c| c.unit.to_owned()).collect();
    let velocities = info.coordinates.iter().map(|c| of_rate(c.unit)).collect();
    let multipliers = info.rows.iter().map(|row| row.multiplier_unit.to_owned()).collect();
    let states = info.states.iter().map(|state| state.unit.to_owned()).collect();
    let quantities: [(_, Numbers, Vec<String>); 4] = [
        ("positions", |sample| sample.coordinates, positions),
        ("velocities", |sample| sample.velocities, velocities),
        ("multipliers", |sample| sample.multipliers, multipliers),
        ("states", |sample| sample.states, states),
    ];
    let mut errors = Vec::new();
    for (quantity, numbers, units) in quantities {
        let mut distinct: Vec<&String> = units.iter().collect();
        distinct.sort();
        distinct.dedup();
        for unit in distinct {
            let mut error = QuantityError { quantity, unit: unit.clone(), at_end: 0.0, largest: 0.0, t: one.first().t };
            for (a, b) in pairs(one, other) {
                let with_unit = numbers(&a).iter().zip(numbers(&b)).zip(&units).filter(|(_, theirs)| *theirs == unit);
                error.at_end = with_unit.fold(0.0, |most: f64, ((a, b), _)| most.max((a - b).abs()));
                if error.at_end > error.largest {
                    (error.largest, error.t) = (error.at_end, a.t);
                }
            }
            errors.push(error);
        }
    }
    if let Outcome::ReachedEvent { t, .. } = one.outcome {
        let late = (t - other.last().t).abs();
        errors.push(QuantityError { quantity: "end", unit: "s".to_owned(), at_end: late, largest: late, t });
    }
    for QuantityError { at_end, largest, .. } in &mut errors {
        *at_end += of_other * *largest;
        *largest += of_other * *largest;
    }
    errors
}

/// How far apart two runs are at most, over how far apart they start, or `by` where they start nearer.
fn amplification(one: &Run, moved: &Run, by: f64) -> f64 {
    let of = |sample: &Sample<'_>| [sample.coordinates, sample.velocities, sample.states].concat();
    let mut sizes = of(&one.first());
    one.samples().for_each(|sample| sizes.iter_mut().zip(of(&sample)).for_each(|(size, x)| *size = size.max(x.abs())));
    let apart = |(a, b): (Sample<'_>, Sample<'_>)| {
        let numbers = of(&a).into_iter().zip(of(&b)).zip(&sizes);
        numbers.fold(0.0, |most: f64, ((a, b), size)| most.max((a - b).abs() / (1.0 + size)))
    };
    let at_start = apart((one.first(), moved.first())).max(by);
    pairs(one, moved).map(apart).fold(1.0, |most: f64, apart| most.max(apart / at_start))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Scene;
    use crate::simulate::simulation;

    /// The second run has a thousandth of the tolerance, and where that is rounding another method; a third choice has ten times the tolerance.
    #[test]
    fn analytic_tolerances_of_second_runs() {
        assert_eq!(seconds(Method::rk4(0.01)), [Method::dop853(ROUNDING), Method::rk4(0.005)]);
        let relative_of = |method: Method| {
            let of_seconds = seconds(method).into_iter().map(|method| {
                let Tolerance { relative, absolute, .. } = method.tolerance().unwrap();
                // the ratio of both is kept
                assert!((absolute / relative - 1.0).abs() <= 1e-15);
                (method.name(), relative)
            });
            of_seconds.collect::<Vec<_>>()
        };
        let expected = [("dop853", 1e-8 * 1e-3), ("dop853", 1e-8 * 10.0)];
        assert_eq!(relative_of(Method::dop853(1e-8)), expected);
        assert_eq!(relative_of(Method::dop853(2e-13))[0].0, "dop853");
        assert_eq!(relative_of(Method::dop853(0.5e-13)), [("taylor", 1e-15), ("dop853", 0.5e-13 * 10.0)]);
        assert_eq!(relative_of(Method::taylor(0.5e-13))[0], ("dop853", 1e-15));
        assert_eq!(relative_of(Method::radau(2e-11))[0], ("radau", 2e-11 * 1e-3));
        assert_eq!(relative_of(Method::radau(0.5e-11))[0].0, "dop853");
        assert_eq!(relative_of(Method::radau(0.5))[1], ("radau", 1.0));
        let with = Method::default().with_tolerance(Tolerance::new(1e-6, 1e-3));
        let Tolerance { absolute, .. } = seconds(with)[0].tolerance().unwrap();
        assert!((absolute / 1e-6 - 1.0).abs() <= 1e-15, "{absolute:e}");
    }

    /// An implicit method is asked again before explicit ones, which are not asked at all where steps are only nearly as many.
    #[test]
    fn analytic_other_methods_of_a_stiff_scene() {
        let names = |method, as_many| others(method, as_many).into_iter().map(|m| m.name()).collect::<Vec<_>>();
        assert_eq!(names(Method::radau(1e-5), false), ["radau"]);
        assert_eq!(names(Method::radau(1e-5), true), ["radau", "dop853", "taylor", "gauss"]);
        assert_eq!(names(Method::dop853(1e-5), false), ["taylor", "gauss"]);
        let relative = |method| others(method, false).first().and_then(|m| m.tolerance()).map(|t| t.relative);
        assert_eq!(relative(Method::radau(1e-5)), Some(Method::radau(1e-5).iteration_floor()));
        assert_eq!(relative(Method::radau(0.9e-8)), None, "a thousandth is there already");
    }

    /// A thousand tolerances, and 1e-9 at least.
    #[test]
    fn analytic_starts_are_moved_by_more_than_errors() {
        for (method, expected) in
            [(Method::dop853(1e-8), 1e-5), (Method::dop853(1e-14), 1e-9), (Method::rk4(1.0), 1e-9)]
        {
            assert!((length_of_move(method) / expected - 1.0).abs() <= 1e-14, "{method:?}");
        }
        let state = State { t: 2.0, q: vec![0.0, 9.0, -1.0], v: vec![0.0, 3.0, 99.0], z: Vec::new(), work: vec![] };
        let moved = beside(&state, 0.01);
        assert_eq!(moved.t, 2.0);
        let parts: Vec<f64> = moved
            .q
            .iter()
            .chain(&moved.v)
            .zip(state.q.iter().chain(&state.v))
            .map(|(moved, x)| (moved - x) / (0.01 * (1.0 + x.abs())))
            .collect();
        // numbers fill the interval from -1 to 1 evenly: the golden ratio, twice, …, without whole parts
        for (i, part) in parts.iter().enumerate() {
            let whole = (i + 1) as f64 * 0.5 * (1.0 + 5.0_f64.sqrt());
            assert!((part - (2.0 * (whole - whole.floor()) - 1.0)).abs() <= 1e-12, "{parts:?}");
        }
    }

    crate::model! {
        /// A puck that nothing holds.
        pub model Puck {
            param v: m/s = 2;
            param far: m = 5;
            body puck { mass: 1, inertia: 1 }
            event far_away: puck.x = far;
            start here { puck at (0, 0) angle 0 velocity (v, 0) rate 0; }
            scene glides { start here; until 2 s; }
            scene leaves { start here; until 9 s; until far_away; }
        }
    }

    crate::model! {
        /// A pendulum that hangs at rest.
        pub model Hung {
            body rod { mass: 2, inertia: 1 }
            hinge pivot: ground(0, 0) ~ rod(0, 0.5);
            gravity (0, -8);
            start down { rod at (0, -0.5) angle 0; at rest; }
            scene hangs { start down; until 1 s; }
        }
    }

    /// A limit that the run keeps ends no run beside it: the one whose start is moved swings, and leaves rounding in the hinge.
    #[test]
    fn invariant_limits_of_a_run_are_not_those_of_the_runs_beside_it() {
        let scene = hung::Hangs::default();
        let order = || simulation(&scene).method(Method::rk4(0.25)).max_drift(0.0);
        let run = order().estimate_error().run().unwrap();
        assert!(run.outcome.is_complete(), "{:?}", run.outcome);
        let estimate = run.error_estimate.unwrap().unwrap();
        assert!(estimate.amplification.is_some(), "{estimate:?}");
        let mut moved = order();
        moved.settings.start.moved_by = SMALLEST_MOVE;
        let moved = moved.run_once().unwrap();
        assert!(!moved.outcome.is_complete(), "it would not keep that limit: {:?}", moved.outcome);
    }

    fn run<S: Scene>(scene: &S) -> Run {
        simulation(scene).method(Method::rk4(0.25)).every(0.5).run().unwrap()
    }

    /// A run of fixed steps is judged by another method, whose steps may be as many by chance.
    #[test]
    fn invariant_as_many_steps_of_another_method_are_not_the_same() {
        let run = run(&puck::Glides::default());
        let is_same = |second: Method| takes_the_same_steps((second, &run), (Method::rk4(0.25), &run));
        assert_eq!([Method::rk4(0.125), Method::dop853(1e-12)].map(is_same), [true, false]);
    }

    /// With half the step RK4 makes a sixteenth of the error, a fifteenth of the difference; of twice the step that is its error; another method makes a thousandth.
    #[test]
    fn analytic_errors_of_second_runs() {
        let scene = puck::Glides::default();
        let of = |method| (method, simulation(&scene).method(method).run().unwrap());
        let [long, short] = [Method::rk4(0.25), Method::rk4(0.125)].map(of);
        let of_second = |(second, of_second): &(Method, Run), (first, of_first): &(Method, Run)| {
            error_of_second((*second, of_second), (*first, of_first))
        };
        assert!((of_second(&short, &long) * 15.0 - 1.0).abs() <= 1e-15);
        assert_eq!(of_second(&long, &short), 0.0);
        assert_eq!(of_second(&of(Method::dop853(1e-9)), &long), TIGHTER);
    }

    /// Two pucks at 2 m/s and 2.25 m/s: 0.25 m/s apart at once, and 0.5 m after 2 s.
    #[test]
    fn analytic_errors_of_runs_are_how_far_they_part() {
        let (one, other) = (run(&puck::Glides::default()), run(&puck::Glides { v: 2.25, ..Default::default() }));
        let found = errors(&one, &other, 0.0);
        let of = |quantity: &str, unit: &str| {
            let error = found.iter().find(|error| error.quantity == quantity && error.unit == unit).unwrap();
            [error.at_end, error.largest, error.t]
        };
        assert_eq!((of("positions", "m"), of("velocities", "m/s")), ([0.5, 0.5, 2.0], [0.25, 0.25, 0.0]));
        assert_eq!((of("positions", "rad"), of("velocities", "rad/s")), ([0.0; 3], [0.0; 3]));
        assert_eq!(found.len(), 4);
        assert_eq!(pairs(&one, &other).count(), 5);
        // where the other one is off by a quarter of that itself
        let found = errors(&one, &other, 0.25);
        assert_eq!([found[0].at_end, found[0].largest], [0.625; 2]);
        // a run that ends at an event: 5 m are reached after 2.5 s and 2 s
        let [one, other] = [2.0, 2.5].map(|v| run(&puck::Leaves { v, ..Default::default() }));
        let found = errors(&one, &other, 0.0);
        let end = &found[found.len() - 1];
        assert_eq!((end.quantity, &*end.unit), ("end", "s"));
        assert!([end.at_end - 0.5, end.largest - 0.5, end.t - 2.5].iter().all(|x| x.abs() <= 1e-12), "{end:?}");
    }

    /// Over their sizes in the run, 1 + 4 m and 1 + 2 m/s, they part by 0.1 and 0.25/3 from 0.25/3 on. A start moved by more counts.
    #[test]
    fn analytic_amplification_is_how_much_farther_runs_part_than_they_start() {
        let (one, other) = (run(&puck::Glides::default()), run(&puck::Glides { v: 2.25, ..Default::default() }));
        for (by, at_start) in [(1e-3, 0.25 / 3.0), (0.09, 0.09), (0.2, 0.1)] {
            let found = amplification(&one, &other, by);
            assert!((found - 0.1 / at_start).abs() <= 1e-12, "{found}");
        }
    }
}
