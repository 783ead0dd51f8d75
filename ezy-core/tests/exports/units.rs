//! Functional mock-up units, compiled by `cc` and run by FMPy where these are at hand (`EZY_PYTHON` names its Python).

use crate::mechanisms::{falling, laws, locking, plumb, roller, rope, thrown};
use crate::{drivers, folder};
use ezy_core::export::fmu::{Version, unit};
use ezy_core::export::{ExportError, Start};
use ezy_core::prelude::*;
use std::path::PathBuf;
use std::process::Command;

/// Of the largest state, by a method of order 5 at a tolerance of 1e-10, and by CVODE, which keeps its tolerance a step.
const BY_OWN_STEPS: f64 = 1e-8;
const BY_CVODE: f64 = 1e-6;

const UNTIL_S: f64 = 1.0;

/// The unpacked unit of a scene, compiled; `None` without a C compiler.
fn unpacked(scene: &dyn Scene, version: Version) -> Option<PathBuf> {
    let run = Simulation::new(scene).until(0.0).run().expect("it starts");
    let start = run.last();
    let start = Start { t: start.t, q: start.coordinates, v: start.velocities };
    let unit = unit(scene, version, start).expect("a unit");
    let folder = folder(&format!("{}_{}", unit.identifier, version.number()));
    for (path, text) in &unit.files {
        let path = folder.join(path);
        std::fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        std::fs::write(path, text).expect("a file");
    }
    // FMPy looks for the library of its system there
    let (os, arch) = (std::env::consts::OS, std::env::consts::ARCH);
    let system = if version == Version::Two { format!("{os}64") } else { format!("{arch}-{os}") };
    let library = format!("binaries/{system}/{}{}", unit.identifier, std::env::consts::DLL_SUFFIX);
    std::fs::create_dir_all(folder.join(&library).parent().expect("a folder")).expect("a folder");
    let flags = ["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Wno-unused-parameter", "-Werror", "-O1"];
    let to = ["-shared", "-fPIC", "-fvisibility=hidden", "-Isources", "sources/fmu.c", "-lm", "-o", &library];
    let Ok(done) = Command::new("cc").args(flags).args(to).current_dir(&folder).output() else {
        eprintln!("skipped: there is no C compiler `cc` here");
        return None;
    };
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    Some(folder)
}

/// The unit ends where a run does, in both versions of the standard and both ways of use.
fn assert_unit(scene: &dyn Scene, until_s: f64) {
    for version in [Version::Two, Version::Three] {
        let Some(folder) = unpacked(scene, version) else { return };
        if !drivers::python(&["-c", "import fmpy"]).output().is_ok_and(|done| done.status.success()) {
            eprintln!("skipped: there is no Python with FMPy here");
            return;
        }
        let script = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/exports/check_unit.py");
        let done = drivers::python(&[script, folder.to_str().expect("UTF-8"), &until_s.to_string()]).output();
        let done = done.expect("it starts");
        let told = String::from_utf8_lossy(&done.stderr);
        assert!(done.status.success(), "{}: {told}", folder.display());
        let run = Simulation::new(scene).method(Method::dop853(1e-12)).until(until_s).run().expect("it runs");
        let last = run.last();
        let expected = [&[last.t], last.coordinates, last.velocities, last.states].concat();
        let largest = expected.iter().fold(1.0, |largest: f64, x| largest.max(x.abs()));
        let printed = String::from_utf8_lossy(&done.stdout);
        assert!(printed.contains("or no finite number, was set"), "the importer is told what was wrong: {printed}");
        let lines: Vec<&str> = printed.lines().filter(|line| !line.starts_with('[')).collect();
        assert_eq!(lines.len(), 2, "{printed}");
        for (line, tolerance) in lines.iter().zip([BY_OWN_STEPS, BY_CVODE]) {
            // FMPy does not ask a unit of FMI 3.0 how far its last step has come
            let is_time_known = version == Version::Two || tolerance == BY_CVODE;
            let found: Vec<f64> = line.split(' ').map(|x| x.parse().expect("a number")).collect();
            assert_eq!(found.len(), expected.len());
            for (x, y) in found.iter().zip(&expected).skip(usize::from(!is_time_known)) {
                assert!((x - y).abs() <= tolerance * largest, "{}: {x} for {y}", folder.display());
            }
        }
    }
}

#[test]
fn cross_a_unit_with_a_state_and_an_input_moves_as_a_run() {
    assert_unit(&laws::Runs::default(), UNTIL_S);
}

#[test]
fn cross_a_unit_with_skates_moves_as_a_run() {
    assert_unit(&roller::Coasts::default(), UNTIL_S);
}

#[test]
fn cross_a_unit_with_counts_moves_as_a_run() {
    assert_unit(&rope::Swings::default(), UNTIL_S);
}

#[test]
fn cross_a_unit_without_inertia_moves_as_a_run() {
    assert_unit(&plumb::Swings::default(), UNTIL_S);
}

#[test]
fn cross_a_unit_without_rows_moves_as_a_run() {
    assert_unit(&thrown::Flies::default(), UNTIL_S);
}

/// A unit ends where a run does: `until` names the angle.
#[test]
fn cross_a_unit_ends_where_a_run_does() {
    assert_unit(&falling::Falls::default(), 2.0);
}

/// Where a mechanism locks, t = π/6 s, the importer is told when and why a step fails.
#[test]
fn invariant_a_singular_position_reaches_the_log() {
    let scene = locking::Turns::default();
    for version in [Version::Two, Version::Three] {
        let Some(folder) = unpacked(&scene, version) else { return };
        if !drivers::python(&["-c", "import fmpy"]).output().is_ok_and(|done| done.status.success()) {
            eprintln!("skipped: there is no Python with FMPy here");
            return;
        }
        let script = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/exports/check_failing.py");
        let done = drivers::python(&[script, folder.to_str().expect("UTF-8")]).output().expect("it starts");
        let told = String::from_utf8_lossy(&done.stdout);
        assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
        assert!(told.contains("0.523"), "{told}");
    }
}

#[test]
fn invariant_rows_that_a_run_switches_are_refused() {
    let scene = roller::Skids::default();
    let run = Simulation::new(&scene).until(0.0).run().expect("it starts");
    let start = Start { t: 0.0, q: run.last().coordinates, v: run.last().velocities };
    let refused = unit(&scene, Version::Two, start).expect_err("a limit");
    assert_eq!(refused, ExportError::Switched { scene: "skids", row: "front".to_owned() });
}
