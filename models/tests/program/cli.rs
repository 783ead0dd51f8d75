//! The commands of every program with models.

use crate::{assert_wrong_use, directory, ezy, json, output, text};
use serde_json::Value;
use std::path::Path;
use std::process::Command;

/// The keys of an object, sorted.
fn keys(value: &Value) -> Vec<&str> {
    let mut keys: Vec<&str> = value.as_object().expect("an object").keys().map(String::as_str).collect();
    keys.sort_unstable();
    keys
}

const COORDINATES: [&str; 6] = ["bar.phi", "bar.x", "bar.y", "seat.phi", "seat.x", "seat.y"];

#[test]
fn invariant_list_names_every_scene_as_it_is_typed() {
    let list = output(&["list"]);
    for path in ["ezyroller/coast", "ezyroller/driven", "ezyroller/driven_on_tarmac"] {
        assert!(list.contains(path), "{list}");
    }
}

#[test]
fn invariant_start_that_contradicts_is_projected_when_asked() {
    let given = ["run", "fourbar/turning", "--until", "0", "--start", "crank.omega=-1", "--start", "rocker.omega=-0.5"];
    assert_wrong_use(&given, "`--project-start`");
    let rate = &json(&[&given[..], &["--project-start", "--json"]].concat())["rate"];
    let rate = |name: &str| rate[name].as_f64().expect("a number");
    assert!((rate("crank.phi") - rate("rocker.phi")).abs() < 1e-12);
}

#[test]
fn invariant_list_json_tells_effects_sizes_and_freedom() {
    let scene = &json(&["list", "--json"])["models"][0]["scenes"][1];
    assert_eq!(scene["name"], "driven");
    assert_eq!(scene["effects"], serde_json::json!(["pump"]));
    assert_eq!((&scene["coordinates"], &scene["position_rows"], &scene["freedom"]), (&6.into(), &2.into(), &2.into()));
}

#[test]
fn invariant_run_json_has_exactly_the_documented_keys() {
    check_keys(&json(&["run", "ezyroller/driven", "--until", "0.1", "--json"]));
}

/// The keys of the object that `run --json` prints.
fn check_keys(run: &Value) {
    let top = [
        "acceleration",
        "added_up",
        "attainable_tolerance",
        "cost",
        "energy",
        "method",
        "model",
        "monitors",
        "multipliers",
        "outcome",
        "rate",
        "residual",
        "scene",
        "state",
        "stiff_since",
        "t",
    ];
    assert_eq!(keys(run), top);
    for motion in ["state", "rate", "acceleration"] {
        assert_eq!(keys(&run[motion]), COORDINATES);
    }
    assert_eq!(keys(&run["multipliers"]), ["B.x", "B.y", "front", "rear"]);
    assert_eq!(keys(&run["energy"]), ["balance", "kinetic", "potential", "work"]);
    assert_eq!(keys(&run["residual"]), ["position", "velocity"]);
    let monitors = ["condition", "energy", "longest_step", "position_drift", "position_residual", "shortest_step"];
    assert_eq!(keys(&run["monitors"])[..6], monitors);
    assert_eq!(keys(&run["cost"]), ["evaluations", "factorizations", "rejected", "seconds", "steps"]);
}

/// x1 of the coasting run at 1 s, from a solution with 36 digits.
const COAST_END_X: f64 = 1.194_608_983_605_537_4;
/// RK4 at h = 1e-3 leaves 3e-12 there.
const COAST_TOLERANCE: f64 = 1e-11;

#[test]
fn reference_run_coast_ends_where_it_should() {
    let run = json(&["run", "EZY_Roller/Coast", "--step", "1e-3", "--json"]);
    let x = run["state"]["seat.x"].as_f64().unwrap();
    assert!((x - COAST_END_X).abs() < COAST_TOLERANCE, "{x}");
}

#[test]
fn invariant_run_holds_given_start_and_parameters() {
    let until = ["--until", "0", "--json"];
    let given = ["run", "ezyroller/driven", "--set", "d=0.3", "--start", "bar.phi=pi/2", "--start", "seat.vx=2"];
    let run = json(&[&given[..], &until[..]].concat());
    assert_eq!(run["state"]["bar.phi"].as_f64(), Some(std::f64::consts::FRAC_PI_2));
    assert_eq!(run["rate"]["seat.x"].as_f64(), Some(2.0));
    // hinge: y of the bar is d above the seat's axis
    assert!((run["state"]["bar.y"].as_f64().unwrap() - 0.3).abs() < 1e-12);
}

#[test]
fn invariant_run_csv_has_units_a_thousand_rows_and_the_end() {
    let file = directory("csv").join("motion.csv");
    output(&["run", "ezyroller/coast", "--out", file.to_str().unwrap()]);
    let text = std::fs::read_to_string(file).unwrap();
    assert!(text.starts_with("t [s],seat.x [m],seat.y [m],seat.phi [rad]"), "{}", &text[..80]);
    assert_eq!(text.lines().count(), 1 + 1001);
    assert!(text.lines().last().unwrap().starts_with("1.0,"));
}

#[test]
fn invariant_run_every_sets_the_rows() {
    let file = directory("every").join("motion.csv");
    output(&["run", "ezyroller/coast", "--every", "0.25", "--out", file.to_str().unwrap()]);
    assert_eq!(std::fs::read_to_string(&file).unwrap().lines().count(), 1 + 5);
    output(&["run", "ezyroller/coast", "--at", "0.125,0.75", "--out", file.to_str().unwrap()]);
    let rows = std::fs::read_to_string(&file).unwrap();
    let times: Vec<&str> = rows.lines().skip(1).filter_map(|row| row.split(',').next()).collect();
    assert_eq!(times, ["0.0", "0.125", "0.75", "1.0"], "{rows}");
}

#[test]
fn invariant_wrong_use_exits_with_2_and_says_what_to_do() {
    let cases: [(&[&str], &str); 29] = [
        (&["run", "ezyroler/coast"], "did you mean `ezyroller`?"),
        (&["run", "ezyroller/cost"], "did you mean `coast`?"),
        (&["run", "ezyroller"], "run one of: ezyroller/coast"),
        (&["run", "ezyroller/coast", "--set", "m3=1"], "known: a, b, c, d, m1"),
        (&["run", "ezyroller/coast", "--set", "m1=nan"], "is not a finite number"),
        (&["run", "ezyroller/coast", "--set", "m1=-1"], "mass of body `seat` is -1"),
        (&["run", "ezyroller/coast", "--start", "seat.z=1"], "did you mean `seat."),
        (&["run", "ezyroller/coast", "--start", "seat.vy=1"], "contradicts the constraints"),
        (&["run", "ezyroller/coast", "--step", "-1"], "give a positive step"),
        (&["run", "ezyroller/coast", "--step", "0"], "give a positive step"),
        (&["run", "ezyroller/coast", "--until", "nan"], "is not a finite number"),
        (
            &["run", "ezyroller/coast", "--method", "euler"],
            "[possible values: taylor, dop853, gauss, radau, rk4, midpoint]",
        ),
        (&["run", "ezyroller/coast", "--step", "1e-3", "--rtol", "1e-9"], "rk4 has a fixed step and no tolerance"),
        (&["run", "ezyroller/coast", "--method", "dop853", "--step", "1e-3"], "give `--rtol` in place of `--step`"),
        (&["run", "ezyroller/coast", "--method", "taylor", "--step", "1e-3"], "taylor chooses the length of its steps"),
        (&["run", "ezyroller/coast", "--method", "dop853", "--rtol", "0"], "give positive ones up to 1"),
        (&["run", "ezyroller/coast", "--frobnicate"], "unexpected argument"),
        (&["run", "ezyroller/coast", "--out", "/dev/null/x.csv"], "give --out a file that may be written"),
        (&["run", "ezyroller/coast", "--every", "0"], "give a positive interval"),
        (&["run", "ezyroller/coast", "--every", "0.1"], "add --out FILE.csv"),
        (&["run", "ezyroller/coast", "--at", "0.1"], "add --out FILE.csv"),
        (&["run", "ezyroller/coast", "--at", "0.1", "--every", "1", "--out", "x.csv"], "cannot be used with"),
        (&["run", "ezyroller/coast", "--at", "0.1,7", "--out", "/dev/null"], "the run goes from 0 s to 1 s"),
        (&["run", "ezyroller/coast", "--step", "1e-300"], "steps of 1e-300 s"),
        (&["run", "ezyroller/coast", "--set", "a=1", "--set", "b=1", "--set", "a=2"], "`--set a` is given twice"),
        (&["run", "ezyroller/coast", "--start", "seat.x=1", "--start", "seat.x=1"], "`--start seat.x` is given twice"),
        (&["run", "ezyroller/coast", "--set", "m0=1"], "`m0` belongs to effect `pump`"),
        (&["run", "ezyroller/coast", "--set", "k=1"], "run one that does: ezyroller/driven_on_tarmac"),
        (&["shwo"], "'show'"),
    ];
    for (arguments, message) in cases {
        assert_wrong_use(arguments, message);
    }
}

/// Hinge and wheel at the centre of a seat without inertia: nothing turns it.
const UNDETERMINED: [&str; 9] = ["run", "ezyroller/driven", "--set", "a=0", "--set", "b=0", "--set", "i1=0", "--json"];

#[test]
fn invariant_run_that_cannot_start_exits_with_1_and_names_the_coordinate() {
    let done = ezy(&UNDETERMINED);
    assert_eq!(done.status.code(), Some(1));
    let object: Value = serde_json::from_str(&text(&done.stdout)).unwrap();
    let outcome = object["outcome"].as_str().unwrap();
    assert!(outcome.contains("seat.phi"), "{outcome}");
    check_keys(&object);
    assert!(object["t"].is_null() && object["state"]["seat.x"].is_null() && object["cost"]["steps"].is_null());
}

#[test]
fn invariant_run_from_a_singular_position_says_which_rows_depend_on_each_other() {
    let aligned = ["run", "ezyroller/coast", "--set", "b=-0.2", "--set", "d=-0.1", "--start", "bar.phi=0"];
    let still = [&aligned[..], &["--start", "seat.vx=0", "--until", "0.01"]].concat();
    let as_text = output(&still);
    assert!(
        as_text.contains("rank 3 of 4, degrees of freedom: 3; these depend on each other: B.y, rear, front"),
        "{as_text}"
    );
    let object: Value = serde_json::from_str(&output(&[&still[..], &["--json"]].concat())).unwrap();
    assert_eq!(object["rank"][0]["rows"], serde_json::json!(["B.y", "rear", "front"]));
    assert_eq!((object["rank"][0]["from"].as_f64(), object["rank"][0]["redundant"].as_u64()), (Some(0.0), Some(1)));
}

#[test]
fn invariant_run_over_a_level_position_says_from_when_to_when_it_crossed() {
    let level = ["run", "four_bar/turning", "--until", "1", "--method", "dop853"];
    let as_text = output(&level);
    assert!(as_text.contains("crossed a singular position from t = 0."), "{as_text}");
    let object: Value = serde_json::from_str(&output(&[&level[..], &["--json"]].concat())).unwrap();
    let [from, to] = ["from", "to"].map(|key| object["crossings"][0][key].as_f64().unwrap());
    assert!(0.6 < from && from < to && to < 0.8, "{from} s to {to} s");
}

/// Rubber turns the trucks of a skateboard back at 270 per second, while the rider takes a second for a turn.
#[test]
fn invariant_run_that_stiffness_holds_says_since_when() {
    let stiff = ["run", "skateboard/ridden", "--method", "dop853"];
    let as_text = output(&stiff);
    assert!(
        as_text.contains("the steps of dop853 were limited by stiffness") && as_text.contains("--method radau"),
        "{as_text}"
    );
    let as_json = [&stiff[..], &["--json"]].concat();
    let object = json(&as_json);
    let since = object["stiff_since"].as_f64().expect("a time");
    assert!((0.0..object["t"].as_f64().unwrap()).contains(&since), "since {since} s");
    // beside an object the remark goes to standard error
    assert!(text(&ezy(&as_json).stderr).contains("limited by stiffness"));
    let implicit = ["run", "skateboard/ridden", "--method", "radau", "--json"];
    assert!(json(&implicit)["stiff_since"].is_null());
}

#[test]
fn invariant_run_of_an_explicit_method_without_end_names_the_implicit_one() {
    let stopped = |method: &str| {
        let done = ezy(&["run", "skateboard/ridden", "--method", method, "--max-steps", "3"]);
        assert_eq!(done.status.code(), Some(1));
        text(&done.stdout) + &text(&done.stderr)
    };
    for method in ["rk4", "dop853"] {
        let told = stopped(method);
        assert!(told.contains("if the scene is stiff, --method radau") && told.contains("limit of 3"), "{told}");
    }
    assert!(!stopped("radau").contains("stiff"));
}

#[test]
fn invariant_table_of_a_run_has_no_number_of_three_hundred_digits() {
    let done = ezy(&["run", "ezyroller/driven", "--set", "m0=1e200", "--until", "1e-300", "--step", "1e-3"]);
    let told = text(&done.stdout) + &text(&done.stderr);
    assert!(told.contains("t = 1e-300 s") && told.lines().all(|line| line.len() < 300), "{told}");
}

#[test]
fn invariant_run_that_stops_early_exits_with_1_and_keeps_what_it_has() {
    let file = directory("stopped").join("motion.csv");
    // a step as long as the period of the torque: the run blows up after a few steps
    let arguments =
        ["run", "ezyroller/driven", "--step", "2", "--every", "2", "--json", "--out", file.to_str().unwrap()];
    let done = ezy(&arguments);
    assert_eq!(done.status.code(), Some(1));
    let object: Value = serde_json::from_str(&text(&done.stdout)).unwrap();
    let t = object["t"].as_f64().unwrap();
    assert!(object["outcome"].as_str().unwrap().starts_with(&format!("stopped at t = {t} s")), "{object}");
    assert_eq!(keys(&object["state"]), COORDINATES);
    let csv = std::fs::read_to_string(file).unwrap();
    assert!(csv.lines().last().unwrap().starts_with(&format!("{t:?},")), "{csv}");
    assert!(text(&done.stderr).contains("smaller step"), "{}", text(&done.stderr));
}

#[test]
fn invariant_run_that_is_refused_leaves_the_file_of_out_as_it_was() {
    let place = directory("refused");
    let (old, new) = (place.join("old.csv"), place.join("new.csv"));
    std::fs::write(&old, "rows of an earlier run").unwrap();
    for file in [&old, &new] {
        let done = ezy(&["run", "ezyroller/coast", "--step", "-1", "--out", file.to_str().unwrap()]);
        assert_eq!(done.status.code(), Some(2));
    }
    assert_eq!(std::fs::read_to_string(&old).unwrap(), "rows of an earlier run");
    assert!(!new.exists(), "a file without rows");
}

#[test]
fn invariant_run_replaces_a_longer_file() {
    let file = directory("replaced").join("motion.csv");
    std::fs::write(&file, "x".repeat(100_000)).unwrap();
    output(&["run", "ezyroller/coast", "--every", "0.25", "--out", file.to_str().unwrap()]);
    let text = std::fs::read_to_string(file).unwrap();
    assert!(text.starts_with("t [s],") && text.lines().count() == 1 + 5, "{} bytes", text.len());
}

#[test]
fn invariant_run_with_too_large_a_step_says_so() {
    for (arguments, remark_in_json) in [(&["--step", "0.5"][..], false), (&["--step", "0.5", "--json"], true)] {
        let coarse = ezy(&[&["run", "ezyroller/driven"], arguments].concat());
        let (told, error) = (text(&coarse.stdout), text(&coarse.stderr));
        assert_eq!(coarse.status.code(), Some(1), "{error}");
        let remark = if remark_in_json { &error } else { &told };
        assert!(remark.contains("step of 0.5 s is too large"), "{remark}");
        assert!(told.contains("not to be trusted") && error.contains("not to be trusted"), "{told}{error}");
    }
    let fine = output(&["run", "ezyroller/coast"]);
    assert!(!fine.contains("remark"), "{fine}");
}

/// A device that is always full.
#[cfg(target_os = "linux")]
#[test]
fn invariant_run_onto_a_full_device_exits_with_1_and_says_so() {
    let full = || std::fs::OpenOptions::new().write(true).open("/dev/full").expect("the device is there");
    for arguments in [&UNDETERMINED[..], &["run", "ezyroller/coast", "--json"]] {
        let done = Command::new(env!("CARGO_BIN_EXE_ezy")).args(arguments).stdout(full()).output().unwrap();
        let stderr = text(&done.stderr);
        assert_eq!(done.status.code(), Some(1), "{stderr}");
        assert!(stderr.contains("standard output cannot be written"), "{stderr}");
    }
}

#[test]
fn invariant_check_passes_on_every_scene() {
    let check = output(&["check", "ezyroller"]);
    assert!(check.contains("EzyRoller/driven_on_tarmac") && !check.contains("FAILED"), "{check}");
}

#[test]
fn invariant_help_of_every_command_has_its_usage() {
    for command in [
        "list",
        "show",
        "run",
        "plot",
        "compare",
        "reactions",
        "sweep",
        "linearize",
        "inverse",
        "workspace",
        "animate",
        "sketch",
        "gallery",
        "check",
        "accuracy",
        "study",
    ] {
        let help = output(&[command, "--help"]);
        assert!(help.contains(&format!("Usage: ezy {command}")), "{help}");
    }
    let help = output(&["run", "--help"]);
    for part in ["Numbers may be written as", "ezy run ezyroller/coast --step 1e-4 --json", "--inputs torque.csv"] {
        assert!(help.contains(part), "{part} in {help}");
    }
    assert!(output(&["help"]).contains("Without a command, does the EzyRoller study"));
}

#[test]
fn invariant_run_json_of_a_scene_with_inputs_tells_them_and_outputs() {
    let run = json(&["run", "ezyroller/ridden", "--until", "0.1", "--input", "torque=-0.5", "--json"]);
    assert_eq!((keys(&run["inputs"]), keys(&run["outputs"])), (vec!["torque"], vec!["speed", "steering"]));
    assert_eq!(run["inputs"]["torque"].as_f64(), Some(-0.5));
    assert!(run["energy"]["work"].as_f64().unwrap() != 0.0);
    let declared = json(&["run", "ezyroller/ridden", "--until", "0.1", "--json"]);
    assert_eq!((&declared["inputs"]["torque"], &declared["energy"]["work"]), (&0.0.into(), &0.0.into()));
    assert_ne!(run["state"]["bar.phi"], declared["state"]["bar.phi"]);
}

#[test]
fn invariant_run_reads_inputs_from_its_own_csv() {
    let place = directory("inputs");
    let (table, first, second) = (place.join("table.csv"), place.join("first.csv"), place.join("second.csv"));
    std::fs::write(&table, "t [s],torque [N*m]\n0,0\n0.5,1\n0.5,-1\n1,0\n").unwrap();
    let run = |inputs: &Path, out: &Path| {
        let [inputs, out] = [inputs, out].map(|path| path.to_str().unwrap());
        let scene = ["run", "ezyroller/ridden", "--until", "1", "--step", "1e-3", "--every", "1e-3"];
        output(&[&scene[..], &["--inputs", inputs, "--out", out]].concat());
        std::fs::read_to_string(out).unwrap()
    };
    let text = run(&table, &first);
    let header = text.lines().next().unwrap();
    assert!(header.contains(",input.torque [N*m],output.steering [deg],output.speed [m/s],"), "{header}");
    let column = |text: &str, name: &str| {
        let mut lines = text.lines();
        let i = lines.next().unwrap().split(',').position(|c| c.starts_with(name)).unwrap();
        lines.map(|line| line.split(',').nth(i).unwrap().parse::<f64>().unwrap()).collect::<Vec<f64>>()
    };
    let torque = column(&text, "input.torque");
    // read in the middle of each step of 1 ms
    assert!((torque[100] - 0.201).abs() < 1e-12 && (torque[499] - 0.999).abs() < 1e-12, "{torque:?}");
    assert!((torque[500] + 0.999).abs() < 1e-12, "{torque:?}");
    let again = run(&first, &second);
    assert_eq!(text, again, "a run repeats with the inputs that it wrote");
}

#[test]
fn invariant_wrong_inputs_exit_with_2_and_say_what_to_do() {
    let table = directory("wrong_inputs").join("table.csv");
    std::fs::write(&table, "t,torqe\n0,1\n").unwrap();
    let held = table.with_file_name("held.csv");
    std::fs::write(&held, "t,torque\n0,1\n1,2\n").unwrap();
    let [table, held] = [&table, &held].map(|path| path.to_str().unwrap());
    let cases: [(&[&str], &str); 6] = [
        (&["run", "ezyroller/ridden", "--input", "torqe=1"], "did you mean `torque`?"),
        (&["run", "ezyroller/coast", "--input", "torque=1"], "run one that does: ezyroller/ridden"),
        (&["run", "ezyroller/ridden", "--input", "torque=1", "--input", "torque=2"], "is given twice"),
        (&["run", "ezyroller/ridden", "--inputs", "/no/such/file.csv"], "/no/such/file.csv"),
        (&["run", "ezyroller/ridden", "--inputs", table], "did you mean `torque`?"),
        (&["run", "ezyroller/ridden", "--inputs", held], "ask for a fixed one: `--method rk4 --step 0.001`"),
    ];
    for (arguments, message) in cases {
        assert_wrong_use(arguments, message);
    }
}

#[test]
fn invariant_count_sets_the_size_of_a_run() {
    let run = json(&["run", "chain/swing", "--set", "n=3", "--until", "0.01", "--json"]);
    assert_eq!(keys(&run["state"]).len(), 9);
    assert_eq!(keys(&run["multipliers"]), ["pin[1].x", "pin[1].y", "pin[2].x", "pin[2].y", "top.x", "top.y"]);
    let scene = &json(&["show", "chain/swing", "--format", "json"]);
    assert_eq!((&scene["counts"][0]["name"], &scene["counts"][0]["default"]), (&"n".into(), &10.into()));
    let listed = json(&["list", "--json"]);
    let chain = listed["models"].as_array().unwrap().iter().find(|model| model["name"] == "Chain").unwrap();
    assert_eq!(chain["scenes"][0]["counts"][0]["name"], "n");
}

#[test]
fn invariant_count_that_is_no_count_is_refused() {
    for (value, remedy) in
        [("n=2.5", "whole number"), ("n=0", "whole number"), ("n=-3", "whole number"), ("n=1e12", "at most 1000000")]
    {
        assert_wrong_use(&["run", "chain/swing", "--set", value], remedy);
    }
}

#[test]
fn analytic_run_until_an_event_succeeds_and_tells_where() {
    let run = json(&["run", "pendulum/quarter", "--method", "dop853", "--json"]);
    let end = run["t"].as_f64().expect("a time");
    // words have twelve digits, numbers all
    assert_eq!(run["outcome"], format!("reached `bob.x < 0` at t = {end:.12} s"));
    assert_eq!(run["events"], serde_json::json!([{ "name": "bob.x < 0", "t": run["t"] }]));
    // a quarter of a period: the complete elliptic integral K(1/√2), by gamma functions, over √(g/l)
    let quarter = 3.625609908221908f64.powi(2) / (4.0 * std::f64::consts::PI.sqrt()) / 9.81f64.sqrt();
    assert!((end - quarter).abs() <= 1e-8, "{end} for {quarter}"); // ten times the tolerance of the run
}

#[test]
fn invariant_events_are_told_by_run_and_show() {
    let text = output(&["run", "pendulum/swing"]);
    assert!(text.contains("\nevent") && text.contains("turning"), "{text}");
    let show = output(&["show", "pendulum/quarter"]);
    assert!(show.contains("ends the run") && show.contains("is recorded"), "{show}");
}

#[test]
fn invariant_stops_and_limits_are_told_by_run_and_show() {
    let run = json(&["run", "pendulum/knocking", "--until", "1", "--json"]);
    let names = |run: &Value| -> Vec<Value> {
        run["events"].as_array().into_iter().flatten().map(|event| event["name"].clone()).collect()
    };
    assert_eq!(names(&run), ["turning", "post hits"], "{run}");
    let show = output(&["show", "pendulum/knocking"]);
    assert!(show.contains("keeps from below zero") && show.contains("restitution"), "{show}");
    let stop = &json(&["show", "pendulum/knocking", "--format", "json"])["stop"];
    assert_eq!(stop["name"], "post", "{stop}");

    let run = json(&["run", "ezyroller/skid", "--json"]);
    assert_eq!(names(&run)[..2], ["rear_on_ice slides", "rear_on_ice stops"], "{run}");
    assert!(output(&["show", "ezyroller/skid"]).contains("slides beyond"));
    let show = json(&["show", "ezyroller/skid", "--format", "json"]);
    let limited = show["rows"].as_array().into_iter().flatten().filter(|row| !row["limit"].is_null());
    assert_eq!(limited.map(|row| row["name"].clone()).collect::<Vec<_>>(), ["rear_on_ice"], "{show}");

    assert_wrong_use(&["accuracy", "ezyroller/skid"], "rear_on_ice");
}

#[test]
fn invariant_estimated_error_is_told_everywhere_alike() {
    let folder = directory("estimated");
    let file = folder.join("motion.csv").display().to_string();
    let run = ["run", "ezyroller/driven", "--until", "2", "--method", "dop853", "--rtol", "1e-6", "--estimate-error"];
    let end = json(&[&run[..], &["--json", "--every", "0.01", "--out", &file]].concat());
    let told = &end["error_estimate"];
    assert_eq!(told["second"], serde_json::json!({ "method": "dop853", "setting": "--rtol 1e-9" }));
    let errors = told["errors"].as_array().expect("a list");
    let units: Vec<&str> = errors.iter().map(|error| error["unit"].as_str().expect("a unit")).collect();
    assert_eq!(units, ["m", "rad", "m/s", "rad/s", "N"]);
    let csv = std::fs::read_to_string(&file).unwrap();
    let mut lines = csv.lines();
    let line = lines.next().unwrap();
    assert!(
        line.starts_with("# estimated error at the end and at most: positions ") && line.contains("; amplification "),
        "{line}"
    );
    for error in errors {
        let figure = format!("{:.1e} {}", error["largest"].as_f64().unwrap(), error["unit"].as_str().unwrap());
        assert!(line.contains(&figure), "{figure} in {line}");
    }
    assert!(lines.next().unwrap().starts_with("t [s],seat.x [m],") && lines.count() == 201);
    // the rows are those of a run without an estimate
    let alone = folder.join("alone.csv").display().to_string();
    json(&[&run[..run.len() - 1], &["--json", "--every", "0.01", "--out", &alone]].concat());
    assert_eq!(csv.split_once('\n').unwrap().1, std::fs::read_to_string(&alone).unwrap());
    // and a summary without rows has the same table
    let text = output(&run);
    let table = text.split("estimated error").nth(1).expect("a table");
    assert!(
        table.contains("positions") && table.contains("from a second run with --method dop853 --rtol 1e-9"),
        "{table}"
    );
}

#[test]
fn invariant_error_that_is_not_known_says_why_in_the_file_too() {
    let file = directory("not_estimated").join("motion.csv").display().to_string();
    let done = ezy(&["run", "ezyroller/driven", "--max-steps", "5", "--estimate-error", "--json", "--out", &file]);
    assert_eq!(done.status.code(), Some(1));
    let end: Value = serde_json::from_slice(&done.stdout).expect("output is JSON");
    let why = "the run did not come to its end";
    assert_eq!(end["error_estimate"], serde_json::json!({ "unknown": why }));
    assert!(std::fs::read_to_string(file).unwrap().starts_with(&format!("# estimated error: not known: {why} ")));
}

#[test]
#[cfg(unix)]
fn invariant_estimated_error_ends_the_rows_of_a_pipe() {
    let run = "run pendulum/swing --until 1 --method dop853 --every 0.5 --estimate-error --out /dev/stdout";
    let text = output(&run.split(' ').collect::<Vec<_>>());
    let comment = text.lines().position(|line| line.starts_with("# estimated error at the end")).expect("a comment");
    assert!(text.lines().next().unwrap().starts_with("t [s],") && comment == 4, "{text}");
}

#[test]
fn invariant_completions_know_commands_options_and_scenes() {
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let text = output(&["completions", shell]);
        // clap_complete gives some shells no values, and fish none of an argument
        let values = match shell {
            "bash" | "zsh" => &["dop853", "ezyroller/driven_on_tarmac"][..],
            "fish" => &["dop853"],
            _ => &[],
        };
        for word in ["study", "estimate-error"].iter().chain(values) {
            assert!(text.contains(word), "{shell}: no {word}");
        }
    }
    assert_wrong_use(&["completions", "dos"], "invalid value 'dos'");
}

#[test]
fn invariant_each_command_has_a_manual_page() {
    assert!(output(&["man"]).contains("ezy\\-accuracy(1)"), "{}", output(&["man"]));
    for command in [
        "list",
        "show",
        "run",
        "reactions",
        "sweep",
        "animate",
        "sketch",
        "gallery",
        "check",
        "accuracy",
        "completions",
        "man",
        "study",
        "new",
    ] {
        let text = output(&["man", command]);
        assert!(text.starts_with(".ie") && text.contains(&format!("ezy\\-{command}")), "{text}");
    }
    assert_wrong_use(&["man", "nope"], "no command `nope`; there are list, show, run");
}

#[test]
fn invariant_tolerance_of_angles_is_used_and_told() {
    let spinning = ["run", "pendulum/swing", "--until", "0.02", "--start", "bob.omega=30000", "--json"];
    let with = |options: &[&str]| ezy(&[&spinning[..], options].concat());
    let run = with(&["--method", "dop853", "--angle-tol", "1e-8"]);
    let json: serde_json::Value = serde_json::from_slice(&run.stdout).expect("JSON");
    assert_eq!(json["angle_tolerance"], 1e-8, "{}", text(&run.stderr));
    let run = with(&["--method", "dop853"]);
    assert!(!text(&run.stdout).contains("angle_tolerance"));
    let run = with(&["--method", "dop853", "--angle-tol", "1e-13"]);
    assert!(text(&run.stderr).contains("more than the tolerance of angles, 1.0e-13 rad"), "{}", text(&run.stderr));
    let refused = [
        (&["--step", "1e-3", "--angle-tol", "1e-8"][..], "rk4 has a fixed step"),
        (&["--method", "taylor", "--angle-tol", "0"], "the tolerance of angles is 0e0 rad; give a positive one"),
    ];
    for (options, message) in refused {
        let run = with(options);
        assert!(run.status.code() == Some(2) && text(&run.stderr).contains(message), "{}", text(&run.stderr));
    }
}
