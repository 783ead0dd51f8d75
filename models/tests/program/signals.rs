//! Ctrl-C and SIGTERM end a command in good order.

use crate::run::{random, start};
use crate::{directory, text};
use serde_json::Value;
use std::path::Path;
use std::process::{Child, Command, Output};
use std::time::{Duration, Instant};

/// Name and exit status of the signals.
const SIGNALS: [(&str, i32); 2] = [("INT", 130), ("TERM", 143)];

/// Sends a signal and returns what the program printed.
fn signalled(program: Child, signal: &str) -> Output {
    let id = program.id().to_string();
    let sent = Command::new("kill").args([&format!("-{signal}"), &id]).status().expect("`kill` is there");
    assert!(sent.success(), "the program has ended before");
    program.wait_with_output().expect("its output can be read")
}

/// Waits until a file is there: from then on signals are heard.
fn wait_for(path: &Path) {
    let begin = Instant::now();
    while !path.exists() {
        assert!(begin.elapsed() < Duration::from_secs(100), "{} does not come", path.display());
        std::thread::sleep(Duration::from_millis(1));
    }
}

/// Object, message and file of an interrupted run are whole and agree.
fn judge(done: &Output, out: &Path, status: i32) {
    let message = text(&done.stderr);
    assert_eq!(done.status.code(), Some(status), "{message}");
    let told: Value = serde_json::from_slice(&done.stdout).expect("output is JSON");
    let t = told["t"].as_f64().expect("a time");
    let outcome = told["outcome"].as_str().expect("an outcome");
    assert!(outcome.starts_with("was interrupted at t = "), "{outcome}");
    assert!(message.contains("error: the run was interrupted at t = "), "{message}");
    let csv = std::fs::read_to_string(out).expect("the file has its name");
    assert!(!out.with_file_name("motion.csv.partial").exists());
    let columns = csv.lines().next().unwrap().split(',').count();
    assert!(csv.ends_with('\n') && csv.lines().all(|row| row.split(',').count() == columns), "{csv}");
    let last: f64 = csv.lines().last().unwrap().split(',').next().unwrap().parse().unwrap();
    assert_eq!(last, t, "the last row is the state of the object");
}

#[test]
fn invariant_signal_at_any_moment_ends_a_run_with_all_that_it_has() {
    let mut state = 5;
    // steps, events, modes, and many rows
    let scenes = [
        ("ezyroller/driven", "1"),
        ("pendulum/swing", "1"),
        ("pendulum/knocking", "0.01"),
        ("ezyroller/skid", "1"),
        ("ezyroller/driven", "2e-3"),
    ];
    for (i, (scene, every)) in scenes.iter().cycle().take(2 * scenes.len()).enumerate() {
        let out = directory(&format!("signal_{i}")).join("motion.csv");
        let (signal, status) = SIGNALS[i % 2];
        let arguments = ["run", scene, "--until", "5e4", "--every", every, "--json", "--out", out.to_str().unwrap()];
        let program = start(&arguments);
        wait_for(&out.with_file_name("motion.csv.partial"));
        std::thread::sleep(Duration::from_micros((random(&mut state) % 200_000) as u64));
        judge(&signalled(program, signal), &out, status);
    }
}

#[test]
fn invariant_signal_during_the_start_ends_a_run_at_its_first_sample() {
    let out = directory("signal_at_start").join("motion.csv");
    // its start takes seconds
    let program = start(&["run", "chain/swing", "--set", "n=20000", "--json", "--out", out.to_str().unwrap()]);
    wait_for(&out.with_file_name("motion.csv.partial"));
    judge(&signalled(program, "INT"), &out, 130);
    let rows = std::fs::read_to_string(&out).unwrap();
    assert_eq!(rows.lines().count(), 2, "the names of the columns and the start");
    assert!(rows.lines().nth(1).unwrap().starts_with("0.0,"));
}

#[test]
fn invariant_interrupted_study_is_a_page_of_the_parts_that_are_done() {
    let out = directory("signal_study");
    let program = start(&["study", "--out", out.to_str().unwrap()]);
    wait_for(&out.join("coast_motion.csv"));
    let done = signalled(program, "INT");
    let message = text(&done.stderr);
    assert_eq!(done.status.code(), Some(130), "{message}");
    assert!(message.contains("the study was interrupted; the parts so far:"), "{message}");
    let page = std::fs::read_to_string(out.join("index.html")).unwrap();
    assert!(page.contains("(e) Coast") && page.contains("The study was interrupted here."), "{page}");
    assert!(!page.contains("Long runs") && page.trim_end().ends_with("</html>"), "{page}");
}

#[test]
fn invariant_accuracy_that_is_interrupted_before_its_reference_leaves_no_folder() {
    let out = directory("signal_accuracy").join("folder");
    // its reference takes hours
    let program = start(&["accuracy", "ezyroller/driven", "--until", "1e7", "--out", out.to_str().unwrap()]);
    wait_for(&out);
    let done = signalled(program, "TERM");
    let message = text(&done.stderr);
    assert_eq!(done.status.code(), Some(143), "{message}");
    assert!(message.contains("before it had a reference") && !out.exists(), "{message}");
}
