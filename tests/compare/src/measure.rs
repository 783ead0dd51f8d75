//! Errors once, times in turns: in each round every candidate runs once, so that what else the machine does falls on all.
//! A time is that of the processor, since a run that is longer than a slice of the machine's time would never be alone.

use crate::integrators::Arrival;
use crate::right_side::N_Q;
use cpu_time::ThreadTime;
use std::time::{Duration, Instant};

/// Rounds of a scene go on for this long.
const BUDGET: Duration = Duration::from_secs(10);
const LEAST_ROUNDS: usize = 7;
const MOST_ROUNDS: usize = 201;

/// A run slower than this is the last one of its ladder.
const SLOWEST: Duration = Duration::from_millis(120);

/// An integrator on one form of the equations.
pub struct Candidate<'r> {
    pub integrator: &'static str,
    pub equations: &'static str,
    /// Tolerances, or steps in s, from coarse to fine.
    pub settings: Vec<f64>,
    pub run: Box<dyn Fn(f64) -> Result<Arrival, String> + 'r>,
    /// Evaluations of the accelerations in a run that is not timed.
    pub evaluations: Box<dyn Fn(f64) -> u64 + 'r>,
}

/// One run of the ladder of a candidate.
pub struct Point {
    pub scene: &'static str,
    pub integrator: &'static str,
    pub equations: &'static str,
    pub setting: f64,
    pub evaluations: u64,
    pub outcome: Result<Reached, String>,
}

pub struct Reached {
    /// Largest difference of a coordinate at the end from the reference, m or rad.
    pub error: f64,
    pub steps: u64,
    pub rejected: Option<u64>,
    /// Of the processor, of all rounds, s.
    pub fastest_s: f64,
    pub median_s: f64,
}

pub fn measure(scene: &'static str, end: &[f64; N_Q], candidates: &[Candidate<'_>]) -> Vec<Point> {
    let mut points = Vec::new();
    let mut repeats: Vec<(usize, &dyn Fn(f64) -> Result<Arrival, String>, Vec<f64>)> = Vec::new();
    for candidate in candidates {
        for &setting in &candidate.settings {
            let began = Instant::now();
            let outcome = (candidate.run)(setting).map(|arrival| Reached {
                error: arrival.q.iter().zip(end).map(|(q, end)| (q - end).abs()).fold(0.0, worse),
                steps: arrival.steps,
                rejected: arrival.rejected,
                fastest_s: f64::INFINITY,
                median_s: f64::INFINITY,
            });
            let took = began.elapsed();
            if outcome.is_ok() {
                repeats.push((points.len(), &*candidate.run, Vec::new()));
            }
            let (integrator, equations) = (candidate.integrator, candidate.equations);
            let evaluations = (candidate.evaluations)(setting);
            points.push(Point { scene, integrator, equations, setting, evaluations, outcome });
            if took > SLOWEST {
                break;
            }
        }
    }
    let began = Instant::now();
    for round in 0..MOST_ROUNDS {
        if round >= LEAST_ROUNDS && began.elapsed() > BUDGET {
            break;
        }
        for (i, run, times) in &mut repeats {
            let setting = std::hint::black_box(points[*i].setting);
            let began = ThreadTime::now();
            let arrival = run(setting);
            times.push(began.elapsed().as_secs_f64());
            std::hint::black_box(arrival.is_ok());
        }
    }
    for (i, _, mut times) in repeats {
        times.sort_by(f64::total_cmp);
        if let Ok(reached) = &mut points[i].outcome {
            reached.fastest_s = times[0];
            reached.median_s = times[times.len() / 2];
        }
    }
    points
}

/// The larger of an error and another one; a NaN stays.
fn worse(worst: f64, error: f64) -> f64 {
    if error > worst || error.is_nan() { error } else { worst }
}
