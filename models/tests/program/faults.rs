//! Outputs when something fails on the way: a file is old or new, and what was begun is beside it.

use crate::run::{random, start};
use crate::{assert_wrong_use, directory, ezy, text};
use ezy_core::record::CsvWriter;
use ezy_core::simulate::{Outcome, SetupError, Simulation, StopReason};
use ezy_models::ezy_roller::Coast;
use ezy_study::output::OutputFile;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Takes so many bytes and no more, as a disk that becomes full.
struct Full {
    taken: Vec<u8>,
    room: usize,
}

impl Write for Full {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        match bytes.len().min(self.room - self.taken.len()) {
            0 if !bytes.is_empty() => Err(ErrorKind::StorageFull.into()),
            n => {
                self.taken.extend(&bytes[..n]);
                Ok(n)
            }
        }
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

/// The outcome of a small run into a file with so much room, and what the file took.
fn run_into(room: usize) -> (Result<Outcome, SetupError>, Vec<u8>) {
    let scene = Coast::default();
    let mut rows = CsvWriter::new(Full { taken: Vec::new(), room });
    let done = Simulation::new(&scene).until(0.006).every(0.002).work().record_to(&mut rows).run();
    (done.map(|run| run.outcome), rows.into_inner().taken)
}

#[test]
fn invariant_run_into_a_file_that_is_full_at_any_byte_stops_and_leaves_the_first_bytes() {
    let (done, whole) = run_into(usize::MAX);
    assert!(matches!(done, Ok(Outcome::ReachedEnd)), "{done:?}");
    let rows: Vec<usize> = whole.iter().enumerate().filter(|(_, byte)| **byte == b'\n').map(|(i, _)| i + 1).collect();
    assert_eq!(rows.len(), 1 + 4);
    for room in 0..whole.len() {
        let (done, taken) = run_into(room);
        assert_eq!(taken, whole[..room], "room for {room} bytes");
        match done {
            // the names are written with the first sample
            Err(SetupError::Record(error)) if room < rows[1] => assert_eq!(error.t, 0.0),
            Ok(Outcome::Stopped { reason: StopReason::Record(error), .. }) if room >= rows[1] => {
                let n_whole = rows.iter().filter(|end| **end <= room).count();
                assert!((error.t - 0.002 * (n_whole - 1) as f64).abs() < 1e-12, "room for {room} bytes: {error}");
                assert_eq!(error.cause.kind(), ErrorKind::StorageFull);
            }
            other => panic!("room for {room} bytes: {other:?}"),
        }
    }
    assert!(matches!(run_into(whole.len()).0, Ok(Outcome::ReachedEnd)));
}

/// `NAME.partial`.
fn partial(path: &Path) -> PathBuf {
    path.with_file_name(format!("{}.partial", path.file_name().unwrap().to_str().unwrap()))
}

/// A run with some thousand rows into `out`.
fn long_run(out: &Path) -> Vec<&str> {
    vec!["run", "ezyroller/driven", "--until", "2", "--every", "1e-3", "--out", out.to_str().unwrap()]
}

/// Kills runs at random moments; what is at `--out` is the older file or the new one, and `NAME.partial` begins like the
/// new one.
fn kill_runs(place: &str, n_kills: usize) {
    let out = directory(place).join("motion.csv");
    assert_eq!(ezy(&long_run(&out)).status.code(), Some(0));
    let new = std::fs::read(&out).unwrap();
    let old = b"rows of an earlier run\n".to_vec();
    let mut state = 11;
    let (mut n_old, mut n_new, mut n_partial) = (0, 0, 0);
    for i in 0..n_kills {
        std::fs::write(&out, &old).unwrap();
        let mut run = start(&long_run(&out));
        // a part of the rows, from before the program has begun to after it has ended
        let part = 1.2 * (random(&mut state) % 1000) as f64 / 1000.0 - 0.1;
        let written = || std::fs::metadata(partial(&out)).map_or(0, |file| file.len()) as f64;
        while part >= 0.0 && written() < part * new.len() as f64 && run.try_wait().unwrap().is_none() {
            std::thread::sleep(Duration::from_micros(200));
        }
        run.kill().unwrap();
        run.wait().unwrap();
        let found = std::fs::read(&out).unwrap();
        assert!(found == old || found == new, "kill {i}: {} bytes", found.len());
        n_old += usize::from(found == old);
        n_new += usize::from(found == new);
        if let Ok(begun) = std::fs::read(partial(&out)) {
            assert!(found == old && new.starts_with(&begun), "kill {i}: {} bytes beside {}", begun.len(), found.len());
            n_partial += usize::from(!begun.is_empty());
        }
    }
    println!(
        "{n_kills} runs killed: {n_old} left the older file, {n_partial} of them rows beside it, {n_new} the new file"
    );
    assert!(n_partial > 0, "no run was killed while it wrote");
}

#[test]
fn invariant_killed_run_leaves_the_older_file_or_the_new_one() {
    kill_runs("killed", 20);
}

/// `cargo test --release -p ezy-models --test program kill -- --ignored --nocapture`
#[test]
#[ignore = "a minute"]
fn invariant_killed_run_leaves_the_older_file_or_the_new_one_two_hundred_times() {
    kill_runs("killed_often", 200);
}

#[test]
fn invariant_second_run_into_one_file_is_refused_and_the_first_is_whole() {
    let out = directory("two_writers").join("motion.csv");
    let out_name = out.to_str().unwrap();
    let arguments = ["run", "ezyroller/driven", "--until", "4", "--out", out_name];
    let mut first = OutputFile::create(&out).unwrap();
    first.write_all(b"rows of the first").unwrap();
    assert_wrong_use(&arguments, "motion.csv.partial`; wait for it, or give --out another file");
    first.complete().unwrap();
    assert_eq!(std::fs::read_to_string(&out).unwrap(), "rows of the first");
    assert_eq!(ezy(&arguments).status.code(), Some(0));
    assert_eq!(std::fs::read_to_string(&out).unwrap().lines().count(), 1 + 1001);
    assert!(!partial(&out).exists());
}

#[cfg(target_os = "linux")]
#[test]
fn invariant_run_into_a_full_device_exits_with_1_and_says_so() {
    let done = ezy(&["run", "ezyroller/coast", "--json", "--out", "/dev/full"]);
    assert_eq!(done.status.code(), Some(1));
    let message = text(&done.stderr);
    assert!(message.contains("the sample at t = 0 s could not be written: No space left on device"), "{message}");
}

/// A limit on the size of files stands for a disk that becomes full.
#[cfg(target_os = "linux")]
#[test]
fn invariant_run_onto_a_disk_that_becomes_full_keeps_the_older_file_and_its_rows_beside() {
    let out = directory("full_disk").join("motion.csv");
    std::fs::write(&out, "rows of an earlier run").unwrap();
    let program = env!("CARGO_BIN_EXE_ezy");
    // blocks of 512 bytes; without its signal the limit is an error of `write`
    let limited = format!("trap '' XFSZ; ulimit -f 64; exec '{program}' \"$@\"");
    let mut shell = std::process::Command::new("sh");
    let done = shell.args(["-c", &limited, "sh"]).args(long_run(&out)).arg("--json").output().unwrap();
    let message = text(&done.stderr);
    assert_eq!(done.status.code(), Some(1), "{message}");
    assert!(message.contains("could not be written") && message.contains("motion.csv.partial`"), "{message}");
    let told: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
    assert!(told["outcome"].as_str().unwrap().starts_with("stopped at t = 0.0"), "{told}");
    assert_eq!(std::fs::read_to_string(&out).unwrap(), "rows of an earlier run");
    let rows = std::fs::read_to_string(partial(&out)).unwrap();
    assert_eq!(rows.len(), 64 * 512);
    let columns = rows.lines().next().unwrap().split(',').count();
    let whole = rows.lines().count() - 1;
    assert!(rows.lines().take(whole).all(|row| row.split(',').count() == columns), "{rows}");
}

/// The memory of a run does not grow with rows that go to a file.
#[test]
fn cross_run_that_streams_its_samples_keeps_two_and_writes_the_same_rows() {
    let scene = Coast::default();
    let order = || Simulation::new(&scene).until(0.1).every(0.003).work();
    let (mut kept, mut streamed) = (CsvWriter::new(Vec::new()), CsvWriter::new(Vec::new()));
    let [with, without] =
        [order().record_to(&mut kept).run(), order().stream_to(&mut streamed).run()].map(Result::unwrap);
    assert_eq!((with.samples().len(), without.samples().len()), (1 + 33 + 1, 2));
    assert_eq!((without.first().t, without.last().t), (0.0, 0.1));
    assert_eq!(with.last().coordinates, without.last().coordinates);
    assert_eq!(String::from_utf8(kept.into_inner()), String::from_utf8(streamed.into_inner()));
}

/// A pipe takes rows as they come; a file that is open would take them and the summary over each other.
#[cfg(target_os = "linux")]
#[test]
fn invariant_rows_to_standard_output_are_written_as_they_come() {
    let arguments = ["run", "ezyroller/coast", "--every", "0.25", "--out", "/dev/stdout"];
    let begins = |told: &str| {
        told.starts_with("t [s],") && told.lines().nth(6).is_some_and(|line| line.starts_with("EzyRoller"))
    };
    let into_pipe = text(&ezy(&arguments).stdout);
    assert!(begins(&into_pipe), "{into_pipe}");
    let file = directory("standard_output").join("told.txt");
    let stdout = std::fs::File::create(&file).unwrap();
    let mut program = std::process::Command::new(env!("CARGO_BIN_EXE_ezy"));
    let done = program.args(arguments).stdout(stdout).stderr(std::process::Stdio::piped()).output().unwrap();
    assert_eq!(done.status.code(), Some(2));
    assert!(text(&done.stderr).contains("stands for a file that is open"), "{}", text(&done.stderr));
    assert_eq!((std::fs::read(&file).unwrap().len(), partial(&file).exists()), (0, false));
    // a reader that has seen enough
    let mut reads_no_more = start(&["run", "ezyroller/driven", "--every", "1e-3", "--out", "/dev/stdout"]);
    drop(reads_no_more.stdout.take());
    let done = reads_no_more.wait_with_output().unwrap();
    assert_eq!(done.status.code(), Some(1));
    assert!(text(&done.stderr).contains("could not be written: Broken pipe"), "{}", text(&done.stderr));
}

/// Where nobody can read a message, the exit status tells.
#[cfg(target_os = "linux")]
#[test]
fn invariant_full_or_closed_standard_error_leaves_the_exit_status() {
    let full = || std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let (reader, closed) = std::io::pipe().unwrap();
    drop(reader);
    for stderr in [std::process::Stdio::from(full()), closed.into()] {
        let mut program = std::process::Command::new(env!("CARGO_BIN_EXE_ezy"));
        let done = program.args(["run", "pendulum/nope"]).stderr(stderr).output().unwrap();
        assert_eq!(done.status.code(), Some(2), "{done:?}");
    }
    // a remark beside an object
    let mut program = std::process::Command::new(env!("CARGO_BIN_EXE_ezy"));
    let done = program.args(["run", "ezyroller/driven", "--step", "0.5", "--json"]).stderr(full()).output().unwrap();
    assert_eq!(done.status.code(), Some(1));
    assert!(serde_json::from_slice::<serde_json::Value>(&done.stdout).is_ok());
}

#[cfg(target_os = "linux")]
#[test]
fn invariant_inputs_without_end_are_refused() {
    assert_wrong_use(&["run", "ezyroller/ridden", "--inputs", "/dev/zero"], "a row is longer than 16 MiB");
    assert_wrong_use(&["run", "ezyroller/ridden", "--inputs", "/dev/urandom"], "`/dev/urandom`: ");
}

#[test]
fn invariant_run_whose_energy_overflows_is_no_success() {
    let done =
        ezy(&["run", "ezyroller/coast", "--until", "0", "--set", "m1=1e300", "--start", "seat.vx=1e6", "--json"]);
    let message = text(&done.stderr);
    assert_eq!(done.status.code(), Some(1), "{message}");
    assert!(message.contains("`kinetic` is inf"), "{message}");
}
