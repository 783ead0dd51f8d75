//! The command `accuracy`.

#[path = "program/run.rs"]
mod run;

use ezy_models::ezy_roller::Coast;
use ezy_study::accuracy::{Accuracy, PointResult, WorkPrecision};
use ezy_study::report::page::escape;
use ezy_study::report::typeset::typeset;
use run::{assert_wrong_use, directory, text};
use serde_json::Value;
use std::process::Output;
use std::sync::atomic::{AtomicBool, Ordering};

fn ezy(arguments: &[&str]) -> Output {
    run::ezy(&[&["accuracy"][..], arguments].concat())
}

#[test]
fn invariant_accuracy_writes_page_figures_and_numbers_and_says_what_to_use() {
    let out = directory("accuracy");
    let done = ezy(&["ezyroller/coast", "--until", "0.2", "--budget", "8", "--out", out.to_str().unwrap(), "--json"]);
    assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));

    let found: Value = serde_json::from_str(&text(&done.stdout)).unwrap();
    assert_eq!(
        (&found["model"], &found["scene"], &found["until"]),
        (&"EzyRoller".into(), &"coast".into(), &0.2.into())
    );
    let advice = found["advice"].as_array().unwrap();
    let targets: Vec<f64> = advice.iter().map(|advice| advice["target"].as_f64().unwrap()).collect();
    assert_eq!(targets, [1e-3, 1e-6, 1e-9, 1e-12]);
    let sentence = advice[0]["sentence"].as_str().unwrap();
    let method = advice[0]["use"]["method"].as_str().unwrap();
    assert!(sentence.starts_with("Positions to 1e-3 (m, rad) throughout: use ") && sentence.contains(method));

    let read = |name: &str| std::fs::read(out.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
    for figure in ["work-precision", "work-precision-grid", "drift", "energy"] {
        assert!(text(&read(&format!("{figure}.svg"))).contains("<svg"), "{figure}");
        assert!(read(&format!("{figure}.png")).starts_with(b"\x89PNG"), "{figure}");
    }
    let csv = text(&read("accuracy.csv"));
    let head = csv.lines().next().unwrap();
    assert!(head.starts_with("method,setting [s or tolerance],projection,metric,outcome,position error at the end"));
    assert_eq!(csv.lines().count(), 1 + found["points"].as_array().unwrap().len());
    let columns = head.split(',').count();
    assert!(csv.lines().filter(|row| row.contains(",measured,")).all(|row| row.split(',').count() == columns));
    assert!(csv.lines().any(|row| row.starts_with("dop853,1e-9,both,mass,measured,")));

    let page = text(&read("index.html"));
    assert!(
        page.contains(&escape(&typeset(sentence))) && page.matches("<svg").count() == 8,
        "the page holds sentences and figures"
    );
    for elsewhere in ["http:", "https:", "<script", "<img", "<link", "NaN"] {
        assert!(!page.contains(elsewhere), "{elsewhere}");
    }
}

#[test]
fn invariant_interrupted_measurement_keeps_what_it_has_and_says_so() {
    let scene = Coast::default();
    let asked = AtomicBool::new(false);
    let order = Accuracy::new(&scene).until(0.1).budget(1e4).interrupted_by(&asked);
    let measured = order.measure(|_, part| _ = asked.fetch_or(part == "rk4", Ordering::Relaxed)).unwrap();
    assert!(measured.interrupted && measured.reservations()[0].starts_with("The measurement was interrupted after"));
    let outcomes = |wanted: fn(&PointResult) -> bool| measured.points.iter().filter(|p| wanted(&p.result)).count();
    let n_measured = outcomes(|result| matches!(result, PointResult::Measured(_)));
    let n_interrupted = outcomes(|result| matches!(result, PointResult::Interrupted));
    // taylor, dop853, gauss and radau come before rk4
    assert_eq!((n_measured, n_measured + n_interrupted), (4, measured.points.len()));
    let told = measured.advice()[0].to_string();
    assert!(told.ends_with("were not run.") && told.contains("rk4"), "{told}");
    assert!(measured.missing_text().iter().all(|line| line.contains("not run before the interruption")));
    let out = directory("accuracy_interrupted");
    let page = std::fs::read_to_string(measured.save(&out).unwrap()).unwrap();
    assert!(page.contains("The measurement was interrupted after"), "{page}");
}

/// A machine whose other programs take most of the processor.
#[test]
fn invariant_measurement_on_a_busy_machine_says_so() {
    let scene = Coast::default();
    let mut measured = Accuracy::new(&scene).until(0.1).budget(0.5).measure(|_, _| ()).unwrap();
    measured.processor_share = Some(0.045);
    assert!(measured.was_busy());
    let told = |measured: &WorkPrecision| measured.reservations().join("\n");
    let busy = "too busy for advice by time: the measurement had 4 % of a processor";
    assert!(told(&measured).contains(busy), "{}", told(&measured));
    measured.processor_share = Some(1.0);
    assert!(!told(&measured).contains("busy"), "{}", told(&measured));
}

#[test]
fn invariant_accuracy_exits_with_2_on_wrong_use() {
    let out = directory("accuracy_refused");
    let out = out.to_str().unwrap();
    let cases: [(&[&str], &str); 7] = [
        (&["ezyroller"], "names no scene; run one of: ezyroller/coast"),
        (&["ezyroller/coast", "--set", "m9=1", "--out", out], "parameter `m9` is not known"),
        (&["ezyroller/coast", "--start", "seat.z=1", "--out", out], "start value `seat.z` is not known"),
        (&["ezyroller/coast", "--until", "0", "--out", out], "give an end after the start"),
        (
            &["ezyroller/coast", "--budget", "-1", "--out", out],
            "give a positive number of seconds up to 1e9 with --budget",
        ),
        (&["ezyroller/coast", "--budget", "1e300", "--out", out], "the budget is 1e300 s"),
        (&["ezyroller/coast", "--out", "/dev/null/x"], "choose another directory with --out"),
    ];
    for (arguments, expected) in cases {
        assert_wrong_use(&[&["accuracy"][..], arguments].concat(), expected);
    }
}

#[test]
fn invariant_accuracy_exits_with_1_where_no_motion_reaches_the_end() {
    let out = directory("accuracy_stopped");
    // hinge and wheel at the centre of a seat without inertia: nothing turns it
    let undetermined = ["ezyroller/driven", "--set", "a=0", "--set", "b=0", "--set", "i1=0"];
    let done = ezy(&[&undetermined[..], &["--out", out.to_str().unwrap()]].concat());
    assert_eq!(done.status.code(), Some(1), "{}", text(&done.stderr));
    assert!(text(&done.stderr).contains("the motion cannot start"), "{}", text(&done.stderr));
}
