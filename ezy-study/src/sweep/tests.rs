//! Sweeps as a whole: values, order, failures, and folders that were left in every state.

mod lanes;

use super::*;
use ezy_core::integrate::Method;
use ezy_core::simulate::Simulation;
use std::cell::Cell as Counter;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

ezy_core::model! {
    /// A ball that is thrown and lands.
    pub model Throw {
        param speed: m/s = 10;
        param angle: rad = 0.5;
        param drag: kg/s = 0;
        body ball { mass: 1, inertia: 1 }
        point P = ball(0, 2);
        gravity (0, -10);
        force at ball(0, 0): -drag * ball.v;
        event lands: ball.y < 0;
        output height: cm = ball.y;
        start up { ball at (0, 0) angle 0 velocity (speed*cos(angle), speed*sin(angle)) rate 0; }
        scene flight { start up; until 5 s; until lands; }
    }
}

const SPEEDS: [f64; 3] = [5.0, 10.0, 20.0];
const ANGLES: [f64; 4] = [0.2, 0.4, 0.6, 0.8];

fn plan() -> Plan {
    Plan::new().grid("speed", SPEEDS).grid("angle", ANGLES)
}

fn flight(case: &Case<'_>) -> Result<Finished, Refused> {
    let scene = throw::Flight { speed: case.get("speed")?, angle: case.get("angle")?, ..Default::default() };
    Ok(case.run(Simulation::new(&scene).method(Method::dop853(1e-10)))?)
}

fn sweep(plan: Plan) -> Sweep<'static> {
    Sweep::new(&throw::Flight::default(), plan, flight).keep(["ball.x", "P.y", "event:lands"]).cases_per_part(5)
}

/// Tolerance of the runs, on numbers up to 40.
const NEAR: f64 = 1e-8;

#[test]
fn analytic_numbers_are_those_of_the_motion() {
    let kept = [
        "ball.x",
        "P.y",
        "max:ball.y",
        "min:ball.vy",
        "event:lands",
        "count:lands",
        "kinetic",
        "work.model",
        "output.height",
    ];
    let sweep = Sweep::new(&throw::Flight::default(), plan(), flight).keep(kept).every(0.01);
    let table = sweep
        .keep_number("speed", "m/s", |run| run.last().velocities[0].hypot(run.last().velocities[1]))
        .run()
        .unwrap();
    for (i, row) in table.rows.iter().enumerate() {
        let (speed, angle) = (SPEEDS[i / 4], ANGLES[i % 4]);
        let t = 2.0 * speed * angle.sin() / 10.0;
        let number = |name: &str| table.numbers(name).unwrap()[i];
        let expected = [
            ("case", i as f64),
            ("speed", speed),
            ("angle", angle),
            ("ball.x", speed * angle.cos() * t),
            ("P.y", 2.0),
            ("min:ball.vy", -speed * angle.sin()),
            ("event:lands", t),
            ("count:lands", 1.0),
            ("kinetic", 0.5 * speed * speed),
            ("work.model", 0.0),
            ("output.height", 0.0),
            ("speed", speed),
            ("end", t),
        ];
        for (name, expected) in expected {
            assert!(
                (number(name) - expected).abs() <= 1e3 * NEAR.max(NEAR * expected.abs()),
                "{name}: {} {expected}",
                number(name)
            );
        }
        // samples lie 0.01 s apart: the highest one is below the top by ½ g (5 ms)² at most
        let below = (speed * angle.sin()).powi(2) / 20.0 - number("max:ball.y");
        assert!((-NEAR..=0.5 * 10.0 * 0.005 * 0.005 + NEAR).contains(&below), "{below}");
        assert_eq!(row.cells[row.cells.len() - 2..], [Cell::Text("event:lands".into()), Cell::Text(String::new())]);
    }
    let units: Vec<&str> = table.columns.iter().map(|column| column.unit.as_str()).collect();
    assert_eq!(units, ["", "m/s", "rad", "m", "m", "m", "m/s", "s", "", "J", "J", "cm", "m/s", "s", "", "", ""]);
}

#[test]
fn analytic_error_of_a_run_is_kept() {
    let run = |case: &Case<'_>| {
        let scene = throw::Flight { drag: case.get("drag")?, ..Default::default() };
        Ok(case.run(Simulation::new(&scene).method(Method::rk4(0.01)).until(1.0).without_events())?)
    };
    let plan = Plan::new().grid("drag", [1.0, 5.0]);
    let table = Sweep::new(&throw::Flight::default(), plan, run).keep(["ball.x", "error"]).run().unwrap();
    let (x, errors) = (table.numbers("ball.x").unwrap(), table.numbers("error:m").unwrap());
    for ((x, error), drag) in x.iter().zip(errors).zip([1.0_f64, 5.0]) {
        let exact = 10.0 * 0.5_f64.cos() * (1.0 - f64::exp(-drag)) / drag;
        // y has another part, of the same order: the largest of both is told
        assert!(error >= 0.99 * (x - exact).abs() && error <= 1e-6, "{error:e} {:e}", x - exact);
    }
    assert!(table.numbers("error:amplification").unwrap().iter().all(|x| *x >= 1.0));
    assert!(table.numbers("error:rad/s").unwrap().iter().all(|x| *x == 0.0));
}

#[test]
fn invariant_table_is_the_same_by_any_number_of_threads() {
    let plan = || {
        let samples = Samples::new(Design::LatinHypercube, 40, 3).over("speed", 1.0, 30.0).over("angle", 0.1, 1.5);
        Plan::new().samples(samples)
    };
    let one = sweep(plan()).threads(1).run().unwrap();
    for n in [2, 7] {
        assert_eq!(sweep(plan()).threads(n).run().unwrap(), one);
    }
    assert_eq!(one.rows.len(), 40);
}

/// A step that no method takes refuses a case, a limit of steps stops one; the others run.
#[test]
fn invariant_case_that_fails_is_a_row() {
    let run = |case: &Case<'_>| {
        let scene = throw::Flight::default();
        Ok(case.run(Simulation::new(&scene).method(Method::rk4(case.get("step")?)).max_steps(50))?)
    };
    let plan = Plan::new().grid("step", [0.1, -1.0, 1e-3]).grid("of another name", [1.0]);
    let table = Sweep::new(&throw::Flight::default(), plan.clone(), run).keep(["ball.x"]).run().unwrap();
    let outcomes: Vec<String> = table.rows.iter().map(|row| format!("{:?}", row.cells[row.cells.len() - 2])).collect();
    assert_eq!(outcomes, ["Text(\"event:lands\")", "Text(\"refused\")", "Text(\"stopped\")"]);
    let x = table.numbers("ball.x").unwrap();
    // stopped after 50 ms
    assert!(x[1].is_nan() && (x[2] - 10.0 * 0.5_f64.cos() * 0.05).abs() <= NEAR, "{x:?}");
    let named = |name: &'static str| {
        Sweep::new(&throw::Flight::default(), plan.clone(), run).keep([name]).run().unwrap_err().to_string()
    };
    assert!(named("ball.z").contains("did you mean `ball.") && named("event:land").contains("did you mean `lands`"));
    let unknown = |case: &Case<'_>| case.get("stp").map(|_| unreachable!()).map_err(Refused::from);
    let table = Sweep::new(&throw::Flight::default(), plan, unknown).run().unwrap();
    assert!(
        matches!(&table.rows[0].cells[5], Cell::Text(why) if why.contains("did you mean `step`")),
        "{:?}",
        table.rows[0]
    );
}

/// A fresh folder for one test.
/// One of its own for each call, since tests run beside each other.
fn folder(name: &str) -> PathBuf {
    static N_CALLS: AtomicU64 = AtomicU64::new(0);
    let n = N_CALLS.fetch_add(1, Ordering::Relaxed);
    let path = std::env::temp_dir().join(format!("ezy-sweep-{name}-{}-{n}", std::process::id()));
    _ = fs::remove_dir_all(&path);
    path
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

#[test]
fn invariant_files_have_the_table_and_the_next_program_finds_them() {
    let folder = folder("files");
    let written = sweep(plan()).write(&folder).unwrap();
    assert_eq!(written.n_parts, [3, 3]);
    assert_eq!(written.progress, Progress { n_done: 12, n_cases: 12, n_failed: 0 });
    let names: Vec<String> = files(&folder).into_iter().map(|(name, _)| name).collect();
    assert_eq!(names, ["part-000000.csv", "part-000001.csv", "part-000002.csv", "sweep.json"]);
    let text = fs::read_to_string(folder.join(&names[0])).unwrap();
    assert!(text.starts_with(
        "case,speed [m/s],angle [rad],ball.x [m],P.y [m],event:lands [s],end [s],steps,outcome,message\n0,5.0,0.2,"
    ));
    let table = sweep(plan()).run().unwrap();
    let mut lines = row::heading(&table.columns);
    table.rows[..5].iter().for_each(|row| row.write_line(&mut lines));
    assert_eq!(text, lines);
    // again: not without a word
    let refused = sweep(plan()).write(&folder).unwrap_err();
    assert!(matches!(refused, SweepError::Exists { n_parts: [3, 3], .. }), "{refused}");
    let again = sweep(plan()).resume().write(&folder).unwrap();
    assert_eq!((again.progress.n_done, again.n_found, again.n_parts), (0, 12, [3, 3]));
    fs::remove_dir_all(folder).unwrap();
}

/// Whatever a killed program left of the second part: the sweep goes on behind the last whole row, and the files are the same.
#[test]
fn invariant_each_case_is_computed_once_whenever_a_program_is_killed() {
    let folder = folder("killed");
    sweep(plan()).write(&folder).unwrap();
    let whole = files(&folder);
    let second = fs::read(folder.join("part-000001.csv")).unwrap();
    let n_rows = |bytes: &[u8]| bytes.iter().filter(|byte| **byte == b'\n').count().saturating_sub(1) as u64;
    for cut in (0..=second.len()).step_by(7).chain([second.len()]) {
        fs::remove_file(folder.join("part-000001.csv")).unwrap();
        fs::write(folder.join("part-000001.csv.partial"), &second[..cut]).unwrap();
        let written = sweep(plan()).resume().write(&folder).unwrap();
        assert_eq!(written.progress.n_done, 5 - n_rows(&second[..cut]), "{cut} bytes");
        assert_eq!(written.n_found, 7 + n_rows(&second[..cut]));
        assert!(files(&folder) == whole, "{cut} bytes");
    }
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn invariant_interrupted_sweep_goes_on_where_it_ended() {
    let folder = folder("interrupted");
    let flag = AtomicBool::new(false);
    let n_runs = AtomicU64::new(0);
    let run = |case: &Case<'_>| {
        n_runs.fetch_add(1, Ordering::Relaxed);
        flight(case)
    };
    let order = || Sweep::new(&throw::Flight::default(), plan(), run).keep(["ball.x"]).cases_per_part(5).threads(1);
    let last = Counter::new(0);
    let stops = |of: Progress| {
        last.set(of.n_done);
        flag.store(of.n_done >= 7, Ordering::Relaxed);
    };
    let written = order().interrupted_by(&flag).on_progress(stops).write(&folder).unwrap();
    let n_done = written.progress.n_done;
    // results may be on their way
    assert!((7..=10).contains(&n_done) && n_done < 12, "{written:?}");
    assert_eq!(written.n_parts, [n_done / 5, 3]);
    let rest = order().resume().write(&folder).unwrap();
    assert_eq!((rest.n_found, rest.progress.n_done, rest.n_parts), (n_done, 12 - n_done, [3, 3]));
    assert!(n_runs.load(Ordering::Relaxed) <= 14);
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn invariant_shares_of_a_sweep_make_the_same_files() {
    let (whole, shared) = (folder("whole"), folder("shared"));
    sweep(plan()).write(&whole).unwrap();
    let written: Vec<Written> = [2, 1].map(|i| sweep(plan()).shard(i, 2).write(&shared).unwrap()).into();
    assert_eq!(written.iter().map(|written| written.progress.n_done).collect::<Vec<_>>(), [5, 7]);
    assert!(files(&shared) == files(&whole));
    // a share that is computed again finds its rows; one that is not there has none
    assert_eq!(sweep(plan()).shard(1, 2).write(&shared).unwrap().progress.n_done, 0);
    let rows = |i| sweep(plan()).shard(i, 2).run().unwrap().rows.iter().map(|row| row.index).collect::<Vec<_>>();
    assert_eq!((rows(1), rows(2)), (vec![0, 1, 2, 3, 4, 10, 11], vec![5, 6, 7, 8, 9]));
    let wrong = sweep(plan()).shard(3, 2).run().unwrap_err().to_string();
    assert!(wrong.contains("no share 3 of 2"), "{wrong}");
    [whole, shared].into_iter().for_each(|folder| fs::remove_dir_all(folder).unwrap());
}

#[test]
fn invariant_results_of_another_sweep_are_refused_with_what_changed() {
    let folder = folder("changed");
    sweep(plan()).setting("method", "dop853").write(&folder).unwrap();
    let refused = |other: Sweep<'_>| other.resume().write(&folder).unwrap_err().to_string();
    let found = refused(sweep(plan()).setting("method", "taylor"));
    assert!(found.contains("of another sweep (method: dop853 → taylor); give another folder"), "{found}");
    let found = refused(
        sweep(Plan::new().grid("speed", SPEEDS).grid("angle", [0.2, 0.4, 0.6, 0.9])).setting("method", "dop853"),
    );
    assert!(found.contains("(grid angle: [0.2,0.4,0.6,0.8] → [0.2,0.4,0.6,0.9])"), "{found}");
    let found = refused(sweep(plan()).keep(["ball.y"]));
    assert!(found.contains("method: dop853 → nothing; kept: ") && found.contains("columns: "), "{found}");
    let many = |last: f64| Plan::new().grid("speed", (0..20).map(f64::from).chain([last])).grid("angle", [0.1]);
    assert_ne!(
        manifest::digest(&[&[0.0; 20][..], &[1.0, 2.0]].concat()),
        manifest::digest(&[&[0.0; 19][..], &[1.0, 0.0, 2.0]].concat())
    );
    assert!(refused(sweep(many(30.0))).contains("→ 21 values from 0 to 30 ("));
    fs::write(folder.join("sweep.json"), "{").unwrap();
    assert!(refused(sweep(plan())).contains("`sweep.json` is not that of a sweep"));
    fs::remove_dir_all(folder).unwrap();
}

/// The second part cannot be written; the first one is kept, and the sweep goes on when it can.
#[test]
fn invariant_rows_before_a_file_that_cannot_be_written_are_kept() {
    let folder = folder("full");
    fs::create_dir_all(folder.join("part-000001.csv.partial")).unwrap();
    let failed = sweep(plan()).write(&folder).unwrap_err();
    assert!(matches!(&failed, SweepError::File { path, .. } if path.ends_with("part-000001.csv")), "{failed}");
    fs::remove_dir(folder.join("part-000001.csv.partial")).unwrap();
    let written = sweep(plan()).resume().write(&folder).unwrap();
    assert_eq!((written.n_found, written.n_parts), (5, [3, 3]));
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn analytic_parts_are_small_and_not_too_many() {
    let of = |n: u64, shares: u64| {
        let plan = Plan::new().samples(Samples::new(Design::Random, n, 0).over("speed", 1.0, 2.0)).grid("angle", [0.5]);
        let sweep = Sweep::new(&throw::Flight::default(), plan, flight);
        let sweep = if shares > 0 { sweep.shard(1, shares) } else { sweep };
        sweep.cases_of_a_part(n, None)
    };
    assert_eq!([of(10, 0), of(1_000_000, 0), of(10_000_000, 0), of(1_000_000_000, 0)], [1000, 1000, 10_000, 100_000]);
    assert_eq!([of(100, 1), of(100, 10), of(100, 1000), of(1_000_000, 100)], [1000, 2, 1, 1000]);
}

/// Shares in folders of their own, one part in both: joined they are the table.
#[test]
fn invariant_results_of_shares_are_joined_and_checked() {
    let (one, two, whole) = (folder("share_one"), folder("share_two"), folder("share_whole"));
    let n = |i: u64, folder: &Path| sweep(plan()).shard(i, 2).write(folder).unwrap().n_parts;
    assert_eq!((n(1, &one), n(2, &two)), ([2, 2], [1, 1]));
    let missing = Results::open(&[&one]).unwrap().check_complete().unwrap_err().to_string();
    assert_eq!(missing, "1 of 3 parts are missing: 1; the command of the sweep with --resume computes them");
    fs::copy(one.join("part-000002.csv"), two.join("part-000002.csv")).unwrap();
    let both = Results::open(&[&one, &two]).unwrap();
    both.check_complete().unwrap();
    let table = sweep(plan()).run().unwrap();
    let rows: Vec<Row> = both.parts().collect::<Result<Vec<_>, _>>().unwrap().concat();
    assert!(rows == table.rows && both.columns() == table.columns);
    fs::create_dir_all(&whole).unwrap();
    assert_eq!(both.write(&whole.join("all.csv"), Format::Csv).unwrap(), 12);
    let mut lines = row::heading(&table.columns);
    table.rows.iter().for_each(|row| row.write_line(&mut lines));
    assert!(fs::read_to_string(whole.join("all.csv")).unwrap() == lines);
    // a part twice, but not the same; a part with a case too few; a folder of another sweep; none
    let text = fs::read_to_string(two.join("part-000002.csv")).unwrap();
    fs::write(two.join("part-000002.csv"), text.replace("20.0", "21.0")).unwrap();
    assert!(matches!(Results::open(&[&one, &two]), Err(ResultsError::Contradiction { .. })));
    fs::write(two.join("part-000002.csv"), text.lines().next().unwrap()).unwrap();
    let short = Results::open(&[&two]).unwrap().parts().last().unwrap().unwrap_err().to_string();
    assert!(short.contains("it does not have the cases from 10 to 11, each once"), "{short}");
    let nothing = Results::open(&[&whole]).unwrap_err().to_string();
    assert!(nothing.contains("has no results of a sweep"), "{nothing}");
    sweep(plan()).keep(["ball.y"]).write(&whole).unwrap();
    let other = Results::open(&[&one, &whole]).unwrap_err().to_string();
    assert!(other.contains("are of different sweeps (kept: "), "{other}");
    [one, two, whole].into_iter().for_each(|folder| fs::remove_dir_all(folder).unwrap());
}

#[cfg(not(feature = "parquet"))]
#[test]
fn invariant_parquet_that_was_not_built_in_is_refused_and_rows_are_kept() {
    let folder = folder("no_parquet");
    let refused = sweep(plan()).format(Format::Parquet).write(&folder).unwrap_err().to_string();
    assert!(refused.contains("built without Parquet; add \"parquet\""), "{refused}");
    assert!(fs::read_to_string(folder.join("part-000000.csv.partial")).unwrap().lines().count() == 6);
    fs::remove_dir_all(folder).unwrap();
}

/// Rows with numbers, counts, words and nothing are the same after Parquet; a killed sweep of Parquet goes on from its rows.
#[cfg(feature = "parquet")]
#[test]
fn invariant_rows_are_the_same_in_parquet() {
    let folder = folder("parquet");
    let run = |case: &Case<'_>| {
        let scene = throw::Flight { speed: case.get("speed")?, ..Default::default() };
        let method = if case.word("method")? == "taylor" { Method::taylor(1e-9) } else { Method::rk4(-1.0) };
        Ok(case.run(Simulation::new(&scene).method(method))?)
    };
    let plan = || Plan::new().grid("speed", SPEEDS).words("method", ["taylor", "none"]);
    let order = || Sweep::new(&throw::Flight::default(), plan(), run).keep(["ball.x"]).cases_per_part(4);
    let table = order().run().unwrap();
    let written = order().format(Format::Parquet).write(&folder).unwrap();
    assert_eq!((written.n_parts, written.progress.n_failed), ([2, 2], 3));
    let read =
        |folder: &Path| Results::open(&[folder]).unwrap().parts().collect::<Result<Vec<_>, _>>().unwrap().concat();
    // NaN is no number, so that rows are compared as text
    let text = |rows: &[Row]| format!("{rows:?}");
    assert_eq!(text(&read(&folder)), text(&table.rows));
    assert!(files(&folder).iter().all(|(name, _)| !name.ends_with("partial")));
    // killed with all rows of a part, and with some
    let whole = files(&folder);
    for n_rows in [4, 1] {
        let mut lines = row::heading(&table.columns);
        table.rows[..n_rows].iter().for_each(|row| row.write_line(&mut lines));
        fs::write(folder.join("part-000000.csv.partial"), lines).unwrap();
        fs::remove_file(folder.join("part-000000.parquet")).unwrap();
        let written = order().format(Format::Parquet).resume().write(&folder).unwrap();
        assert_eq!(written.progress.n_done, 4 - n_rows as u64);
        assert!(files(&folder) == whole);
    }
    fs::remove_dir_all(folder).unwrap();
}

/// Samples are beside the rows, the same after a kill, and a row whose samples cannot be written is none.
#[test]
fn invariant_trajectories_are_whole_files_beside_the_rows() {
    let folder = folder("trajectories");
    let order = || sweep(plan()).keep(["samples"]).every(0.25);
    assert!(matches!(order().run(), Err(SweepError::NoFolder)));
    let written = order().write(&folder).unwrap();
    assert_eq!(written.n_parts, [3, 3]);
    let path = |case: u64| folder.join(format!("runs/part-{:06}/case-{case:06}.csv", case / 5));
    let texts = || (0..12).map(|case| fs::read_to_string(path(case)).unwrap()).collect::<Vec<_>>();
    let whole = texts();
    for (case, text) in whole.iter().enumerate() {
        let (speed, angle) = (SPEEDS[case / 4], ANGLES[case % 4]);
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        let place = |name: &str, all: &csv::StringRecord| all.iter().position(|found| found == name).unwrap();
        let names = reader.headers().unwrap().clone();
        let [number, t, x, vy] = ["case", "t [s]", "ball.x [m]", "ball.vy [m/s]"].map(|name| place(name, &names));
        let rows: Vec<Vec<f64>> =
            reader.records().map(|row| row.unwrap().iter().map(|x| x.parse().unwrap()).collect()).collect();
        let lands = 2.0 * speed * angle.sin() / 10.0;
        assert_eq!(rows.len(), (lands / 0.25).ceil() as usize + 1);
        for row in rows {
            assert_eq!(row[number], case as f64);
            assert!((row[x] - speed * angle.cos() * row[t]).abs() <= NEAR, "{row:?}");
            assert!((row[vy] - speed * angle.sin() + 10.0 * row[t]).abs() <= NEAR, "{row:?}");
        }
    }
    let joined = |folder: &Path| Results::open(&[folder]).unwrap().parts().collect::<Result<Vec<_>, _>>();
    assert_eq!(joined(&folder).unwrap().concat().len(), 12);
    // killed between the samples of the last case and its row; then a case without its samples
    let part = fs::read_to_string(folder.join("part-000002.csv")).unwrap();
    let rows = part.rsplit_once("11,").unwrap().0;
    fs::remove_file(folder.join("part-000002.csv")).unwrap();
    fs::write(folder.join("part-000002.csv.partial"), rows).unwrap();
    let resumed = order().resume().write(&folder).unwrap();
    assert_eq!((resumed.progress.n_done, resumed.n_parts), (1, [3, 3]));
    assert!(texts() == whole);
    fs::remove_file(path(7)).unwrap();
    let lacking = joined(&folder).unwrap_err().to_string();
    assert!(lacking.contains("part-000001.csv`: the samples of case 7 are missing; remove this file"), "{lacking}");
    // a folder where the file should be
    fs::remove_file(folder.join("part-000001.csv")).unwrap();
    fs::create_dir(path(7)).unwrap();
    let failed = order().resume().write(&folder).unwrap_err();
    assert!(matches!(&failed, SweepError::File { path: failed, .. } if *failed == path(7)), "{failed}");
    fs::remove_dir(path(7)).unwrap();
    let rest = order().resume().write(&folder).unwrap();
    assert_eq!((rest.n_found, rest.progress.n_done, rest.n_parts), (9, 3, [3, 3]));
    assert!(texts() == whole);
    fs::remove_dir_all(folder).unwrap();
}
