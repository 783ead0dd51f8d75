//! Points as a table and as CSV, and what each target error costs.

use crate::measure::{Point, Reached};
use std::fmt::Write;

/// Errors of which the price is told.
const TARGETS: [f64; 5] = [1e-4, 1e-6, 1e-9, 1e-11, 1e-12];

const CSV_HEADER: &str =
    "scene,integrator,equations,tolerance_or_step,error,steps,rejected,evaluations,fastest_s,median_s,note";

pub fn print_points(points: &[Point]) {
    for (i, point) in points.iter().enumerate() {
        if i == 0 || point.scene != points[i - 1].scene {
            println!("\n{}", point.scene);
            println!(
                "{:32}{:10}{:>11}{:>10}{:>8}{:>9}{:>12}{:>12}{:>12}",
                "integrator",
                "equations",
                "tolerance",
                "error",
                "steps",
                "rejected",
                "evaluations",
                "fastest ms",
                "median ms"
            );
        }
        print!("{:32}{:10}{:11.1e}", point.integrator, point.equations, point.setting);
        match &point.outcome {
            Ok(Reached { error, steps, rejected, fastest_s, median_s }) => println!(
                "{error:10.1e}{steps:8}{:>9}{:12}{:12.3}{:12.3}",
                count(*rejected),
                point.evaluations,
                1e3 * fastest_s,
                1e3 * median_s
            ),
            Err(note) => println!("  {note}"),
        }
    }
}

fn count(count: Option<u64>) -> String {
    count.map_or_else(|| "-".to_owned(), |count| count.to_string())
}

/// The fastest run of each candidate that meets each target, ms.
pub fn print_targets(points: &[Point]) {
    for scene in different(points.iter().map(|point| point.scene)) {
        println!("\n{scene}: ms until the end with an error of at most");
        print!("{:32}{:10}", "integrator", "equations");
        TARGETS.iter().for_each(|target| print!("{target:>10.0e}"));
        println!("{:>16}", "least error");
        let of_scene: Vec<&Point> = points.iter().filter(|point| point.scene == scene).collect();
        for (integrator, equations) in different(of_scene.iter().map(|point| (point.integrator, point.equations))) {
            let reached: Vec<&Reached> = of_scene
                .iter()
                .filter(|point| (point.integrator, point.equations) == (integrator, equations))
                .filter_map(|point| point.outcome.as_ref().ok())
                .collect();
            print!("{integrator:32}{equations:10}");
            for target in TARGETS {
                let good = reached.iter().filter(|reached| reached.error <= target);
                let fastest = good.map(|reached| reached.fastest_s).fold(f64::INFINITY, f64::min);
                let text = if fastest.is_finite() { format!("{:.3}", 1e3 * fastest) } else { "-".to_owned() };
                print!("{text:>10}");
            }
            println!("{:16.1e}", reached.iter().map(|reached| reached.error).fold(f64::INFINITY, f64::min));
        }
    }
}

fn different<T: PartialEq>(items: impl Iterator<Item = T>) -> Vec<T> {
    items.fold(Vec::new(), |mut found, item| {
        if !found.contains(&item) {
            found.push(item);
        }
        found
    })
}

pub fn csv(points: &[Point]) -> String {
    let mut text = format!("{CSV_HEADER}\n");
    for point in points {
        let Point { scene, integrator, equations, setting, evaluations, outcome } = point;
        let columns = match outcome {
            Ok(Reached { error, steps, rejected, fastest_s, median_s }) => {
                let rejected = rejected.map(|n| n.to_string()).unwrap_or_default();
                format!("{error:e},{steps},{rejected},{evaluations},{fastest_s:e},{median_s:e},")
            }
            Err(note) => format!(",,,{evaluations},,,\"{}\"", note.replace('"', "'")),
        };
        writeln!(text, "{scene},{integrator},{equations},{setting:e},{columns}").expect("text has room");
    }
    text
}
