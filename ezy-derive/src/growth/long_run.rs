//! Processor time and memory of large models:
//! `cargo test -p ezy-derive --lib growth -- --ignored --nocapture` prints the table of `docs/cost.md`.

use std::process::Command;

use super::Cost;
use super::texts::Shape;

/// What a run of this test measures by itself: shape and number. Each is a process of its own, whose peak is its own.
const CASE: &str = "EZY_GROWTH";

#[test]
#[ignore = "takes a minute"]
fn growth_of_large_models() {
    if let Ok(case) = std::env::var(CASE) {
        let (shape, n) = case.split_once(' ').expect("a shape and a number");
        let shape = Shape::ALL.into_iter().find(|of| format!("{of:?}") == shape).expect("a shape");
        let n: usize = n.parse().expect("a number");
        let Cost { work, signs, temporaries } = Cost::of(shape, n);
        let (seconds, megabytes) = (processor_time_s(), peak_mb());
        println!("| {shape:?} | {n} | {seconds:.1} | {megabytes} | {work} | {temporaries} | {signs} |");
        return;
    }
    println!("| model | n | processor, s | peak, MB | steps | temporaries | length |");
    println!("|---|---:|---:|---:|---:|---:|---:|");
    let sizes = [(Shape::Chain, [25, 50, 100, 200]), (Shape::Hub, [4, 8, 16, 32]), (Shape::Casters, [8, 15, 30, 60])];
    for (shape, n) in sizes.into_iter().flat_map(|(shape, sizes)| sizes.map(|n| (shape, n))) {
        let mut again = Command::new(std::env::current_exe().expect("the test has a file"));
        again.args(["growth_of_large_models", "--ignored", "--nocapture"]).env(CASE, format!("{shape:?} {n}"));
        let output = again.output().expect("the test runs again");
        let output = String::from_utf8_lossy(&output.stdout).into_owned();
        println!("{}", output.lines().find_map(|line| line.find("| ").map(|at| &line[at..])).unwrap_or(&output));
    }
}

/// Of this process, s. Linux counts in hundredths.
fn processor_time_s() -> f64 {
    let stat = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    let fields = stat.rsplit(')').next().unwrap_or_default().split_whitespace().skip(11).take(2);
    fields.filter_map(|ticks| ticks.parse::<f64>().ok()).sum::<f64>() / 100.0
}

/// Of this process, MB.
fn peak_mb() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    line.and_then(|line| line.split_whitespace().next()?.parse::<u64>().ok()).unwrap_or_default() / 1000
}
