//! Arguments and files that nobody means: the program does what it is asked with sound numbers, or says why not.

use crate::directory;
use crate::run::random;
use std::ffi::OsString;
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

use serde_json::Value;

/// What is given in place of a number.
const VALUES: [&str; 26] = [
    "",
    " ",
    "nan",
    "NaN",
    "inf",
    "-inf",
    "infinity",
    "1e300",
    "-1e300",
    "1e-300",
    "5e-324",
    "1e308*10",
    "1e999",
    "0",
    "-0",
    "-1",
    "1e",
    "0x10",
    "--",
    "1/0",
    "pi/0",
    "1,5",
    "é",
    "=",
    "1e-17",
    "123456789012345678901234567890",
];

/// Far more than any of these commands takes.
const HANG: Duration = Duration::from_secs(200);

/// A scene with parameters, inputs and outputs, for a hundredth of a second.
const RUN: [&str; 5] = ["run", "ezyroller/ridden", "--json", "--until", "0.01"];

/// What a run that came to its end has to tell in numbers.
const PARTS: [&str; 7] = ["t", "state", "rate", "acceleration", "multipliers", "energy", "residual"];

/// Runs the program to its end, unless it hangs.
fn ezy(arguments: &[OsString]) -> Output {
    let child = Command::new(env!("CARGO_BIN_EXE_ezy"))
        .args(arguments)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let child = watched(child);
    assert!(child.is_some(), "hangs: {arguments:?}");
    child.expect("it is there").wait_with_output().expect("its output can be read")
}

/// The process when it has ended; what it prints fits into a pipe.
fn watched(mut child: Child) -> Option<Child> {
    let begin = Instant::now();
    while child.try_wait().expect("it can be asked").is_none() {
        if begin.elapsed() > HANG {
            _ = child.kill();
            return None;
        }
        std::thread::sleep(Duration::from_millis(2));
    }
    Some(child)
}

/// Exit status 0 and finite numbers, or 1 or 2 and a message.
fn judge(arguments: &[OsString]) -> i32 {
    let done = ezy(arguments);
    let message = String::from_utf8_lossy(&done.stderr).into_owned();
    let status = done.status.code().unwrap_or_else(|| panic!("killed: {arguments:?}"));
    match status {
        0 if arguments.iter().any(|argument| argument == "--json") => {
            let told: Value = serde_json::from_slice(&done.stdout).expect("output is JSON");
            for part in PARTS {
                assert!(!has_null(&told[part]), "a number of `{part}` is none: {arguments:?}: {told}");
            }
        }
        0 => {}
        1 | 2 => assert!(message.contains("error: "), "no message: {arguments:?}: {message}"),
        _ => panic!("exit status {status}: {arguments:?}: {message}"),
    }
    status
}

/// What is not finite is printed as `null`.
fn has_null(value: &Value) -> bool {
    match value {
        Value::Null => true,
        Value::Array(values) => values.iter().any(has_null),
        Value::Object(members) => members.values().any(has_null),
        _ => false,
    }
}

fn of(words: &[&str]) -> Vec<OsString> {
    words.iter().map(OsString::from).collect()
}

#[test]
fn invariant_hostile_numbers_of_a_run_are_refused_or_give_numbers() {
    for value in VALUES {
        for option in [
            "--until",
            "--step",
            "--rtol",
            "--atol",
            "--angle-tol",
            "--every",
            "--max-drift",
            "--max-energy-error",
            "--max-steps",
        ] {
            let method = if matches!(option, "--rtol" | "--atol" | "--angle-tol") { "dop853" } else { "rk4" };
            judge(&of(&["run", "ezyroller/ridden", "--json", "--method", method, &format!("{option}={value}")]
                .into_iter()
                .chain(["--until", "0.01"].into_iter().filter(|_| option != "--until"))
                .chain(["--out", "/dev/null"].into_iter().filter(|_| option == "--every"))
                .collect::<Vec<_>>()));
        }
    }
}

#[test]
fn invariant_hostile_assignments_are_refused_or_give_numbers() {
    for value in VALUES {
        for assignment in ["--set=m1", "--set=i2", "--set=a", "--start=seat.x", "--start=bar.phi", "--start=seat.omega"]
            .into_iter()
            .chain(["--input=torque", "--input=", "--set=", "--start=seat"])
        {
            judge(&of(&[&RUN[..], &[&format!("{assignment}={value}")]].concat()));
        }
    }
}

#[test]
fn invariant_hostile_paths_are_wrong_use() {
    let long = "x".repeat(10_000);
    for path in ["", "/", "//", "ezyroller/", "/driven", "ezyroller/driven/x", "é", "ezyroller/nan", " ", &long] {
        for command in ["run", "show", "check", "accuracy"] {
            assert_eq!(judge(&of(&[command, path])), 2, "{command} {path:?}");
        }
    }
}

#[test]
fn invariant_hostile_budgets_and_directories_are_wrong_use_or_stop() {
    for value in VALUES.into_iter().filter(|value| value.parse::<f64>().is_err() || value.starts_with('-')) {
        let status = judge(&of(&["accuracy", "ezyroller/coast", &format!("--budget={value}")]));
        assert_eq!(status, 2, "{value}");
    }
    for out in ["", "/dev/null/x"] {
        let run = judge(&of(&[&RUN[..], &[&format!("--out={out}")]].concat()));
        let study = judge(&of(&["study", &format!("--out={out}")]));
        assert!(run != 0 && study != 0, "{out:?}");
    }
}

#[cfg(unix)]
#[test]
fn invariant_arguments_that_are_no_text_are_wrong_use() {
    use std::os::unix::ffi::OsStringExt;
    let with = |prefix: &str| OsString::from_vec([prefix.as_bytes(), &[0xff, 0xfe, 0x80]].concat());
    for option in ["", "--set=m1=", "--set=", "--start=seat.x=", "--input=torque=", "--until=", "--step=", "--method="]
    {
        let arguments = [of(&RUN), vec![with(option)]].concat();
        assert_ne!(judge(&arguments), 0, "{option}");
    }
    for command in ["run", "show", "check", "accuracy"] {
        assert_eq!(judge(&[OsString::from(command), with("")]), 2, "{command}");
    }
    assert_ne!(judge(&[of(&RUN), of(&["--step", "1e-3"]), vec![with("--inputs=")]].concat()), 0);
}

#[test]
fn invariant_hostile_tables_of_inputs_are_refused_or_give_numbers() {
    const N_FILES: usize = 80;
    const GOOD: &[u8] = b"t,torque [N*m]\n0,0\n0.005,1\n0.005,-1\n0.02,3.5e-1\n";
    const PIECES: [&[u8]; 14] = [
        b"nan",
        b"inf",
        b"1e300",
        b"-1e999",
        b",",
        b"\n",
        b"\r\n",
        b"\"",
        b"\0",
        b"\xff\xfe",
        b"t",
        b"torque",
        b"",
        b";",
    ];
    let file = directory("hostile_inputs").join("inputs.csv");
    let mut state = 7;
    let mut refused = 0;
    for i in 0..N_FILES {
        let bytes = if i % 4 == 0 {
            (0..random(&mut state) % 300).map(|_| random(&mut state) as u8).collect()
        } else {
            let mut bytes = GOOD.to_vec();
            for _ in 0..1 + random(&mut state) % 3 {
                let at = random(&mut state) % (bytes.len() + 1);
                let end = (at + random(&mut state) % 6).min(bytes.len());
                bytes.splice(at..end, PIECES[random(&mut state) % PIECES.len()].iter().copied());
            }
            bytes
        };
        std::fs::write(&file, bytes).expect("the file can be written");
        let arguments = [of(&RUN), of(&["--step", "1e-3"]), vec!["--inputs".into(), file.clone().into()]].concat();
        refused += usize::from(judge(&arguments) == 2);
    }
    assert!(refused > N_FILES / 4, "most of these are no tables: {refused}");
}
