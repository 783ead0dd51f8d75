//! Sweeps of the program: killed at any moment, continued, refused.

use ezy_core::prelude::*;
use ezy_models::registry::MODELS;
use ezy_study::sweep::{Case, Cell, Kept, Plan, Sweep};

use crate::run::{assert_wrong_use, directory, ezy, random, start, text};
use crate::{json, output};
use std::fs;
use std::path::Path;
use std::time::Duration;

/// A sweep of 400 short runs in parts of 50.
fn arguments(folder: &Path) -> Vec<String> {
    let words = "sweep ezyroller/driven --until 2 --vary m0=1:4.8:0.2 --vary omega=1:4.8:0.2 --keep C.x,max:seat.vx --part 50 --out";
    words.split(' ').map(str::to_owned).chain([folder.display().to_string()]).collect()
}

fn with<'a>(arguments: &'a [String], more: &[&'a str]) -> Vec<&'a str> {
    arguments.iter().map(String::as_str).chain(more.iter().copied()).collect()
}

/// Files with their content, in order.
fn files(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let mut all: Vec<_> = entries
        .map(|path| (path.file_name().unwrap().to_string_lossy().into_owned(), fs::read(&path).unwrap()))
        .collect();
    all.sort();
    all
}

/// Rows in all files of a folder that are whole lines, without the headings.
fn n_rows(folder: &Path) -> usize {
    let of = |bytes: &[u8]| bytes.iter().filter(|byte| **byte == b'\n').count().saturating_sub(1);
    files(folder).iter().filter(|(name, _)| name.starts_with("part-")).map(|(_, bytes)| of(bytes)).sum()
}

/// How often the sweep is killed; `EZY_KILLS=100` for the long test.
const N_KILLS: usize = 8;

/// Killed at random moments, by signals that a program hears and by one that it does not, again and again until it is done: no row is lost
/// between two goes, and the files are those of a sweep that nobody touched.
#[test]
fn invariant_killed_sweep_loses_no_row_and_computes_none_twice() {
    let n_kills = std::env::var("EZY_KILLS").ok().and_then(|n| n.parse().ok()).unwrap_or(N_KILLS);
    let whole = directory("sweep_whole");
    fs::remove_dir(&whole).unwrap();
    output(&with(&arguments(&whole), &[]));
    let whole = files(&whole);
    assert_eq!(whole.len(), 9);
    let mut state = 11;
    let (mut n_killed, mut n_sweeps) = (0, 0);
    while n_killed < n_kills {
        let folder = directory("sweep_killed");
        n_sweeps += 1;
        let mut n_before = 0;
        loop {
            let arguments = arguments(&folder);
            let mut program =
                start(&with(&arguments, &["--resume", "--json", "--threads", ["1", "2", "3"][random(&mut state) % 3]]));
            std::thread::sleep(Duration::from_micros(20_000 + (random(&mut state) % 150_000) as u64));
            let signal = ["-KILL", "-KILL", "-INT", "-TERM"][random(&mut state) % 4];
            let is_running = program.try_wait().unwrap().is_none();
            if is_running {
                let sent = std::process::Command::new("kill").args([signal, &program.id().to_string()]).status();
                n_killed += usize::from(sent.expect("`kill` is there").success());
            }
            let done = program.wait_with_output().unwrap();
            let n_after = n_rows(&folder);
            assert!(n_after >= n_before, "{n_before} rows were there, {n_after} are left");
            if done.status.success() {
                let told: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
                assert_eq!(told["computed"].as_u64(), Some((400 - n_before) as u64), "{told}");
                assert_eq!(told["found"].as_u64(), Some(n_before as u64));
                break;
            }
            n_before = n_after;
        }
        assert!(files(&folder) == whole, "sweep {n_sweeps}");
    }
    println!("{n_killed} kills in {n_sweeps} sweeps");
}

#[test]
fn invariant_shares_of_machines_make_the_same_files() {
    let [whole, shared] = ["sweep_of_one", "sweep_of_three"].map(directory);
    fs::remove_dir(&whole).unwrap();
    output(&with(&arguments(&whole), &["--threads", "1"]));
    let words = arguments(&shared);
    let programs: Vec<_> = ["1/3", "2/3", "3/3"].map(|share| start(&with(&words, &["--shard", share]))).into();
    for program in programs {
        let done = program.wait_with_output().unwrap();
        assert!(done.status.success(), "{}", text(&done.stderr));
    }
    assert!(files(&shared) == files(&whole));
}

#[test]
fn invariant_sweep_that_cannot_be_done_says_why() {
    let folder = directory("sweep_refused");
    let out = folder.join("of").display().to_string();
    let with_out =
        |words: &str| words.split(' ').map(str::to_owned).chain(["--out".to_owned(), out.clone()]).collect::<Vec<_>>();
    for (words, expected) in [
        ("sweep ezyroller/driven", "nothing is varied; give --vary a=START:END:STEP"),
        ("sweep ezyroller/driven --vary mo=1,2", "value to vary `mo` is not known; known: a, b"),
        ("sweep ezyroller/driven --vary m0=1,2 --vary m0=3", "`m0` is varied twice"),
        ("sweep ezyroller/driven --vary m0=1,x", "--vary m0: `x` is not a finite number"),
        ("sweep ezyroller/driven --vary method=rk4,ode45", "dop853 comes nearest to it"),
        ("sweep ezyroller/driven --vary method=rk4 --rtol 1e-6", "rk4 has a fixed step and no tolerance"),
        ("sweep ezyroller/driven --sample m0=1:2", "--samples"),
        ("sweep ezyroller/driven --sample m0=1 --samples 3", "write NAME=LOW:HIGH"),
        ("sweep ezyroller/driven --vary m0=1,2 --keep seat.v", "did you mean `seat.v"),
        ("sweep ezyroller/driven --vary m0=1,2 --keep event:crash", "event `crash` is not known"),
        ("sweep ezyroller/driven --vary m0=1,2 --shard 4/3", "is no share; write I/N"),
        ("sweep ezyroller/driven --list nowhere.csv", "`nowhere.csv`: "),
        ("sweep ezyroller --vary m0=1,2", "names no scene"),
        ("sweep ezyroller/driven --vary m0=1,2 --start seat.z=1", "`seat.z` is not known (did you mean `seat."),
        ("sweep ezyroller/driven --vary m0=1,2 --threads 0", "--threads"),
        ("sweep ezyroller/driven --vary m0=1,2 --part 0", "--part"),
        ("sweep ezyroller/driven --vary m0=1,2 --plot --shard 1/2", "cannot be used with"),
        ("sweep ezyroller/driven --vary m0=1,2 --plot --slurm 2", "cannot be used with"),
        ("sweep ezyroller/driven --vary m0=1,2 --keep seat.v --slurm 2", "did you mean `seat.v"),
    ] {
        let words = with_out(words);
        assert_wrong_use(&with(&words, &[]), expected);
        assert!(!Path::new(&out).exists(), "{words:?} made a folder");
    }
    // a list in words, a folder with results of something else
    let list = folder.join("list.csv");
    fs::write(&list, "m0 [N*m],omega\n1,pi\n2,fast\n").unwrap();
    let wrong = ["sweep", "ezyroller/driven", "--list", list.to_str().unwrap(), "--out", &out];
    assert_wrong_use(&wrong, "row 2, column `omega`: `fast` is not a finite number");
    fs::write(&list, "m0 [N*m],omega\n1,pi\n2,1\n").unwrap();
    output(&[&wrong[..], &["--until", "1"]].concat());
    assert_wrong_use(
        &[&wrong[..], &["--until", "1"]].concat(),
        "1 of 1 parts are complete; add --resume, or give --out another folder",
    );
    assert_wrong_use(
        &[&wrong[..], &["--until", "2", "--resume"]].concat(),
        "results of another sweep (until: 1.0 → 2.0)",
    );
}

#[test]
fn invariant_run_that_fails_is_a_row_and_all_that_fail_are_an_error() {
    let folder = directory("sweep_failures");
    let out = |name: &str| folder.join(name).display().to_string();
    let some = out("some");
    // a bar of no mass cannot be run; a count must be whole
    let told = json(&["sweep", "ezyroller/coast", "--vary", "m1=46,-1e3", "--until", "0.1", "--json", "--out", &some]);
    assert_eq!(
        (told["computed"].as_u64(), told["failed"].as_u64(), told["first_failure"]["case"].as_u64()),
        (Some(2), Some(1), Some(1))
    );
    let rows = fs::read_to_string(Path::new(&some).join("part-000000.csv")).unwrap();
    assert!(
        rows.lines().nth(1).unwrap().ends_with(",end,") && rows.lines().nth(2).unwrap().contains(",refused,"),
        "{rows}"
    );
    let all = out("all");
    let done = ezy(&["sweep", "chain/swing", "--vary", "n=2.5", "--until", "0.1", "--out", &all]);
    let why = text(&done.stderr);
    assert!(
        done.status.code() == Some(1) && why.contains("every run failed; case 0: `n` is a count, but was given 2.5"),
        "{why}"
    );
}

/// Of every scene of the garage that steps in lanes, three neighbours end where they end alone: each step adds the tolerance at most, and the
/// motion amplifies that as it does in the estimate of the error.
#[test]
fn cross_scenes_of_the_garage_end_in_lanes_where_they_end_alone() {
    const TOLERANCE: f64 = 1e-9;
    let mut n_in_lanes = 0;
    for entry in MODELS.iter().flat_map(|model| model.scenes) {
        let info = (entry.info)();
        if info.parameters.is_empty() || info.n_coordinates() > 60 {
            continue;
        }
        let names = || info.coordinates.iter().chain(&*info.velocities).map(|c| c.name.to_string());
        let scene = (entry.new)();
        let plan = || Plan::new().grid("lengthened", [1.0, 1.001, 1.002]);
        let run = |case: &Case<'_>| {
            let mut scene = (entry.new)();
            let value = scene.parameters()[0] * case.get("lengthened")?;
            scene.set_parameter(0, value);
            Ok(case.run(Simulation::new(&*scene).method(Method::dop853(TOLERANCE)).until(info.until_s.min(1.0)))?)
        };
        let sweep = || Sweep::new(&*scene, plan(), run).keep(names().map(Kept::End));
        let lanes = sweep().in_lanes(&*scene).run().unwrap();
        let alone = sweep().keep(["error"]).run().unwrap();
        let amplification = alone.numbers("error:amplification").unwrap();
        for (k, (lane, single)) in lanes.rows.iter().zip(&alone.rows).enumerate() {
            let numbers = |cells: &[Cell]| -> Vec<f64> {
                let number = |cell: &Cell| if let Cell::Number(x) = cell { *x } else { f64::NAN };
                cells[1..=2 * info.n_coordinates()].iter().map(number).collect()
            };
            let (lane_numbers, single_numbers) = (numbers(&lane.cells), numbers(&single.cells));
            n_in_lanes += usize::from(lane_numbers != single_numbers);
            let size = single_numbers.iter().fold(1.0, |size: f64, x| size.max(x.abs()));
            let n_steps = alone.numbers("steps").unwrap()[k];
            let tolerated = n_steps * TOLERANCE * size * amplification[k].max(1.0);
            let off = lane_numbers.iter().zip(&single_numbers).fold(0.0, |off: f64, (a, b)| off.max((a - b).abs()));
            println!("{}/{} {k}: {off:.1e} of {tolerated:.1e}", info.model, info.name);
            assert!(
                off <= tolerated || lane == single,
                "{}/{}, case {k}: {off:e} > {tolerated:e}",
                info.model,
                info.name
            );
        }
    }
    // of some 24 scenes that can
    assert!(n_in_lanes >= 60, "{n_in_lanes}");
}
