//! The command `export`. That other languages compute what kernels compute is shown by the tests of `ezy-core`.

use crate::run::assert_wrong_use;
use crate::{directory, ezy, output, text};
use ezy_core::prelude::*;
use ezy_models::registry::MODELS;
use std::fs;
use std::process::Command;

/// Scenes whose rows depend on each other by design, so that no elimination solves for their accelerations.
const DEPENDENT: [&str; 0] = [];

/// All scenes of the garage are C without a warning, and those that are not say why.
#[test]
fn invariant_every_scene_is_c() {
    let folder = directory("export");
    let (mut files, mut refused) = (Vec::new(), Vec::new());
    for model in MODELS {
        for scene in model.scenes {
            let path = format!("{}/{}", model.name, scene.name);
            let file = folder.join(format!("{}_{}.c", model.name.to_lowercase(), scene.name));
            let mut arguments = vec!["export", "c", &path, "--out", file.to_str().unwrap()];
            for count in (scene.info)().counts() {
                arguments.extend(["--set", if count.name == "n" { "n=3" } else { continue }]);
            }
            let done = ezy(&arguments);
            match done.status.code() {
                Some(0) => files.push(file),
                _ => refused.push(format!("{path}: {}", text(&done.stderr))),
            }
        }
    }
    let unknown: Vec<&String> =
        refused.iter().filter(|line| !DEPENDENT.iter().any(|known| line.starts_with(known))).collect();
    assert!(unknown.is_empty() && refused.len() == DEPENDENT.len(), "{refused:#?}");
    if Command::new("cc").arg("--version").output().is_err() {
        eprintln!("skipped: there is no C compiler `cc` here");
        return;
    }
    let checked = ["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror", "-fsyntax-only"];
    let done = Command::new("cc").args(checked).args(&files).output().expect("it starts");
    assert!(done.status.success(), "{}", text(&done.stderr));
}

/// What a file is called, where it stands, and that an older one is kept when nothing can be written.
#[test]
fn invariant_files_have_the_names_that_are_told() {
    let folder = directory("export_names");
    let out = folder.join("all");
    let told = output(&["export", "matlab", "pendulum", "--out", out.to_str().unwrap()]);
    let files: Vec<&str> = told.lines().collect();
    assert!(files.len() > 1 && files.iter().all(|file| fs::metadata(file).is_ok()), "{told}");
    // MATLAB looks for a function in the file of its name
    let swing = fs::read_to_string(out.join("pendulum_swing.m")).expect("the scene `swing`");
    assert!(swing.starts_with("function scene = pendulum_swing()"), "{swing:.100}");

    let file = folder.join("roller.tex");
    output(&["export", "latex", "ezyroller/coast", "--out", file.to_str().unwrap()]);
    let document = fs::read_to_string(&file).unwrap();
    assert!(
        document.starts_with("\\documentclass") && document.trim_end().ends_with("\\end{document}"),
        "{document:.200}"
    );
}

/// Values and starts that are given stand in the file.
#[test]
fn invariant_given_values_are_those_of_the_file() {
    let file = directory("export_values").join("roller.py");
    let [path, set, start] = [file.to_str().unwrap(), "m1=50", "bar.phi=0.25"];
    output(&["export", "numpy", "ezyroller/coast", "--set", set, "--start", start, "--out", path]);
    let python = fs::read_to_string(&file).unwrap();
    for line in ["(\"m1\", \"kg\", 50.0)", "(\"bar.phi\", \"rad\", 0.25)"] {
        assert!(python.contains(line), "no {line}");
    }
}

/// A start that cannot be is refused with what lets it give way, and then moved to the nearest one that can.
#[test]
fn invariant_a_start_that_cannot_be_is_projected_where_that_is_asked_for() {
    let file = directory("export_projected").join("swing.py");
    let given = [
        "export",
        "numpy",
        "pendulum/swing",
        "--start",
        "bob.x=0.7",
        "--start",
        "bob.y=0",
        "--out",
        file.to_str().unwrap(),
    ];
    assert_wrong_use(&given, "`--project-start`");
    output(&[&given[..], &["--project-start"]].concat());
    assert!(fs::read_to_string(&file).unwrap().contains("(\"bob.x\", \"m\", 1.0)"));
}

/// The program of the guide, where SciPy is (`EZY_PYTHON` names its Python).
#[test]
fn cross_the_hinge_stays_closed_under_scipy() {
    let python = std::env::var("EZY_PYTHON").unwrap_or_else(|_| "python3".to_owned());
    if !Command::new(&python).args(["-c", "import scipy"]).output().is_ok_and(|done| done.status.success()) {
        eprintln!("skipped: there is no Python with SciPy here");
        return;
    }
    let page = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/guide/src/exports.md");
    let page = fs::read_to_string(page).expect("the page");
    let program = page.split("```python\n").nth(1).and_then(|rest| rest.split_once("```")).expect("a program").0;
    let folder = directory("export_page");
    output(&["export", "numpy", "ezyroller/ridden", "--out", folder.join("ezyroller_ridden.py").to_str().unwrap()]);
    let done = Command::new(python).args(["-c", program]).current_dir(&folder).output().expect("it starts");
    assert!(done.status.success(), "{}", text(&done.stderr));
    assert!(text(&done.stdout).starts_with("the hinge is open by"), "{}", text(&done.stdout));
}

/// By FMPy, where it is (`EZY_PYTHON` names its Python): the unit of the driven EzyRoller ends where a run does.
#[test]
fn cross_a_unit_moves_as_a_run() {
    let file = directory("export_unit").join("roller.fmu");
    let name = file.to_str().unwrap();
    for version in ["2", "3"] {
        let told = output(&["export", "fmu", "ezyroller/driven", "--fmi", version, "--out", name]);
        let bytes = fs::read(&file).unwrap();
        assert!(bytes.starts_with(b"PK") && told.starts_with(name), "{told}");
        let folder = std::env::temp_dir();
        let folder = folder.to_str().unwrap().as_bytes();
        assert!(!bytes.windows(folder.len()).any(|part| part == folder), "a path of this machine is in it");
        let python = std::env::var("EZY_PYTHON").unwrap_or_else(|_| "python3".to_owned());
        let program = "import sys, fmpy, fmpy.validation as v; assert v.validate_fmu(sys.argv[1]) == []; \
             end = fmpy.simulate_fmu(sys.argv[1], fmi_type='CoSimulation', stop_time=2, output_interval=0.5, relative_tolerance=1e-12, \
             output=['seat.x', 'seat.y', 'bar.phi', 'der(bar.omega)'])[-1]; print(*(repr(float(x)) for x in end))";
        let Ok(done) = Command::new(python).args(["-c", program, name]).output() else { return };
        if text(&done.stderr).contains("No module named 'fmpy'") || told.contains("sources alone") {
            eprintln!("skipped: there is no Python with FMPy here, or no C compiler");
            return;
        }
        assert!(done.status.success(), "{}", text(&done.stderr));
        let found: Vec<f64> = text(&done.stdout).split_whitespace().map(|x| x.parse().unwrap()).collect();
        let scene = ezy_models::ezy_roller::Driven::default();
        let run = Simulation::new(&scene).method(Method::dop853(1e-13)).until(2.0).run().unwrap();
        let last = run.last();
        let expected = ["seat.x", "seat.y", "bar.phi"].map(|name| last.get(name).unwrap());
        for (x, y) in found[1..].iter().zip(expected) {
            assert!((x - y).abs() <= 1e-9, "{x} for {y}");
        }
        if version == "2" {
            assert_libcosim_agrees(name, expected);
        }
    }
}

/// By libcosim, another importer, where `libcosimpy` is: it sets no tolerance, so that the unit takes its own.
fn assert_libcosim_agrees(unit: &str, expected: [f64; 3]) {
    const BY_DEFAULT: f64 = 1e-6;
    let program = "
import sys, zipfile, xml.etree.ElementTree as tree
from libcosimpy.CosimExecution import CosimExecution
from libcosimpy.CosimObserver import CosimObserver
from libcosimpy.CosimSlave import CosimLocalSlave
description = tree.fromstring(zipfile.ZipFile(sys.argv[1]).read('modelDescription.xml'))
references = {of.get('name'): int(of.get('valueReference')) for of in description.iter('ScalarVariable')}
execution = CosimExecution.from_step_size(10**8)
unit = execution.add_local_slave(CosimLocalSlave(sys.argv[1], 'roller'))
observer = CosimObserver.create_last_value()
execution.add_observer(observer)
assert execution.simulate_until(2 * 10**9)
print('found', *observer.last_real_values(unit, [references[name] for name in ('seat.x', 'seat.y', 'bar.phi')]))
";
    let python = std::env::var("EZY_PYTHON").unwrap_or_else(|_| "python3".to_owned());
    let done = Command::new(python).args(["-c", program, unit]).output().expect("it has started before");
    if text(&done.stderr).contains("No module named 'libcosimpy'") {
        eprintln!("skipped: there is no libcosimpy here");
        return;
    }
    assert!(done.status.success(), "{}", text(&done.stderr));
    // its log goes to the same place
    let printed = text(&done.stdout);
    let line = printed.lines().find_map(|line| line.strip_prefix("found ")).expect("what was found");
    let found: Vec<f64> = line.split(' ').map(|x| x.parse().unwrap()).collect();
    assert_eq!(found.len(), expected.len(), "{line}");
    for (x, y) in found.iter().zip(expected) {
        assert!((x - y).abs() <= BY_DEFAULT, "{x} for {y}");
    }
}

#[test]
fn invariant_what_cannot_be_exported_says_why() {
    assert_wrong_use(&["export", "fortran", "ezyroller/coast"], "possible values: c, numpy");
    assert_wrong_use(&["export", "c", "ezyroller/cost"], "did you mean `coast`");
    assert_wrong_use(&["export", "c", "chain/swing", "--set", "n=100"], "set smaller counts");
    assert_wrong_use(&["export", "fmu", "ezyroller/skid"], "holds or lets go as a run decides");
    assert_wrong_use(&["export", "c", "ezyroller/coast", "--out", "roller.py"], "such a file");
    assert_wrong_use(&["export", "c", "ezyroller", "--out", "roller.c"], "give --out a folder");
}
