//! Cases in lanes: where they end, by whom they are computed, and what their last digits depend on.

use super::*;

ezy_core::model! {
    /// A pendulum that is pushed and damped: constraints, a parameter, a force and an input.
    pub model Swing {
        param l: m = 0.5;
        input push: N*m = 0;
        body bob { mass: 1, inertia: 0.02 }
        hinge pivot: ground(0, 0) ~ bob(0, l);
        point tip = bob(0, -l);
        gravity (0, -9.81);
        torque bob: push - 0.01*bob.omega;
        output speed: cm/s = bob.vx;
        start raised { bob angle 0.5; at rest; }
        scene free { start raised; until 3 s; }
        scene timed { start raised; until 3 s; until bob.phi < -10; }
    }
}

static FREE: swing::Free = swing::Free { l: 0.5 };
static TIMED: swing::Timed = swing::Timed { l: 0.5 };

/// Names and contents.
type Files = Vec<(String, Vec<u8>)>;

fn alone(n_cases: u64, first: u64, why: &'static str) -> Option<RanAlone> {
    Some(RanAlone { n_cases, first, why })
}

/// What a sweep in lanes left to itself, and its rows.
fn in_lanes(plan: Plan, change: impl Fn(Sweep<'static>) -> Sweep<'static>) -> (Option<RanAlone>, Files) {
    let folder = folder("lanes");
    let run = |case: &Case<'_>| {
        let scene = swing::Free { l: case.get("l")? };
        let method = if case.word("method")? == "taylor" { Method::taylor(1e-10) } else { Method::dop853(1e-10) };
        let simulation = Simulation::new(&scene).method(method).start("bob.phi", case.get("bob.phi")?);
        Ok(case.run(simulation.input("push", case.get("push")?))?)
    };
    let sweep = Sweep::new(&FREE, plan, run).keep(["bob.phi", "bob.omega", "tip.y", "output.speed", "lambda.pivot.x"]);
    let written = change(sweep).write(&folder).unwrap();
    let files = files(&folder).into_iter().filter(|(name, _)| name != "sweep.json").collect();
    fs::remove_dir_all(folder).unwrap();
    (written.alone, files)
}

fn swings(methods: &'static [&'static str]) -> Plan {
    let plan = Plan::new().grid("l", [0.3, 0.5, 0.8]).grid("bob.phi", [0.1, 1.5, 3.0]);
    plan.grid("push", [0.0, 0.3]).words("method", methods.iter().copied())
}

/// The numbers of rows.
fn numbers(files: &[(String, Vec<u8>)]) -> Vec<Vec<f64>> {
    let text = files.iter().map(|(_, bytes)| String::from_utf8_lossy(bytes)).collect::<String>();
    let rows = text.lines().filter(|line| !line.starts_with("case"));
    rows.map(|row| row.split(',').skip(5).take(5).map(|x| x.parse().unwrap()).collect()).collect()
}

/// 18 cases in two groups of eight and one of two, against the same ones alone.
#[test]
fn cross_cases_in_lanes_end_where_they_end_alone() {
    let (left, lanes) = in_lanes(swings(&["dop853"]), |sweep| sweep.in_lanes(&FREE));
    let (_, singles) = in_lanes(swings(&["dop853"]), |sweep| sweep);
    assert_eq!(left, None);
    let (lanes, singles) = (numbers(&lanes), numbers(&singles));
    assert_eq!((lanes.len(), singles.len()), (18, 18));
    for (lane, single) in lanes.iter().flatten().zip(singles.iter().flatten()) {
        // centimetres and newtons, some tens of them
        assert!((lane - single).abs() <= 100.0 * NEAR, "{lane} {single}");
    }
    assert!(lanes != singles, "steps are not shared");
}

/// A group has the same bits by any number of threads, in any part, and when some of its cases were there.
#[test]
fn invariant_cases_in_lanes_depend_on_their_group_alone() {
    let of = |change: &dyn Fn(Sweep<'static>) -> Sweep<'static>| numbers(&in_lanes(swings(&["dop853"]), change).1);
    let whole = of(&|sweep| sweep.in_lanes(&FREE).threads(1));
    for n_threads in [2, 3] {
        assert!(of(&|sweep| sweep.in_lanes(&FREE).threads(n_threads)) == whole);
    }
    for n_per_part in [1, 5, 8] {
        assert!(of(&|sweep| sweep.in_lanes(&FREE).cases_per_part(n_per_part)) == whole);
    }
    let shares = [1, 2].map(|i| of(&|sweep| sweep.in_lanes(&FREE).cases_per_part(5).shard(i, 2)));
    assert!([&shares[0][..5], &shares[1][..5], &shares[0][5..], &shares[1][5..]].concat() == whole);
}

/// 640 cases go by forty, of which eights are made by the length of their steps: other ones than their neighbours, and the same by any number of threads and in any part. Parts that
/// nobody chose are whole groups.
#[test]
fn invariant_cases_of_a_large_sweep_in_lanes_depend_on_their_group_alone() {
    let many = |n_lengths: usize| {
        let lengths = (0..n_lengths).map(|i| 0.3 + 0.07 * (3 * i % 8) as f64);
        Plan::new()
            .words("method", ["dop853"])
            .grid("l", lengths)
            .grid("bob.phi", (0..80).map(|i| 0.04 * (i * 37 % 80) as f64))
            .grid("push", [0.1])
    };
    let of = |n_lengths: usize, change: &dyn Fn(Sweep<'static>) -> Sweep<'static>| {
        let rows = in_lanes(many(n_lengths), |sweep| change(sweep.in_lanes(&FREE))).1;
        (rows.len(), numbers(&rows))
    };
    let (_, whole) = of(8, &|sweep| sweep.threads(1));
    assert_eq!(whole.len(), 640);
    assert!(of(8, &|sweep| sweep.threads(3).cases_per_part(100)).1 == whole);
    let (n_parts, share) = of(8, &|sweep| sweep.shard(1, 3));
    assert_eq!((n_parts, share.len()), (3, 240));
    assert!(share[..80] == whole[..80] && share[80..160] == whole[240..320]);
    let (_, fewer) = of(7, &|sweep| sweep);
    let pairs = fewer.iter().flatten().zip(whole.iter().flatten());
    assert!(pairs.clone().all(|(x, y)| (x - y).abs() <= 100.0 * NEAR));
    assert!(pairs.filter(|(x, y)| x != y).count() > 560, "the same neighbours step together");
}

/// Cases that step by themselves are as they would be without lanes: by another method, in another scene, with an end to locate.
#[test]
fn invariant_case_that_cannot_step_in_lanes_runs_by_itself() {
    let (left, mixed) = in_lanes(swings(&["dop853", "taylor"]), |sweep| sweep.in_lanes(&FREE));
    assert_eq!(left, alone(18, 1, "only dop853 steps in lanes"));
    let (_, singles) = in_lanes(swings(&["dop853", "taylor"]), |sweep| sweep);
    let (mixed, singles) = (numbers(&mixed), numbers(&singles));
    assert!((0..36).skip(1).step_by(2).all(|i| mixed[i] == singles[i]));
    assert!((0..36).step_by(2).any(|i| mixed[i] != singles[i]));
    let (left, _) = in_lanes(swings(&["dop853"]), |sweep| sweep.in_lanes(&TIMED));
    assert_eq!(left, alone(18, 0, "it is of another scene"));
    let folder = folder("timed");
    let run = |case: &Case<'_>| Ok(case.run(Simulation::new(&swing::Timed { l: case.get("l")? }))?);
    let sweep = Sweep::new(&TIMED, Plan::new().grid("l", [0.5, -1.0]), run).keep(["bob.phi"]);
    let written = sweep.in_lanes(&TIMED).write(&folder).unwrap();
    assert_eq!(written.alone, alone(2, 0, "what ends it, or is not smooth, has to be located"));
    fs::remove_dir_all(folder).unwrap();
}

/// A case that cannot start is a row that says why; the others of its group step together all the same.
#[test]
fn invariant_refused_case_among_cases_in_lanes_is_a_row() {
    let folder = folder("refused_lane");
    let run = |case: &Case<'_>| Ok(case.run(Simulation::new(&swing::Free { l: case.get("l")?.sqrt() }))?);
    let sweep = Sweep::new(&FREE, Plan::new().grid("l", [0.5, -1.0, 0.6]), run).keep(["bob.phi"]);
    let written = sweep.in_lanes(&FREE).write(&folder).unwrap();
    assert_eq!((written.alone, written.progress.n_failed), (alone(1, 1, "it cannot start"), 1));
    assert!(written.first_failure.is_some_and(|(case, why)| case == 1 && why.contains("`l`")));
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn invariant_what_lanes_do_not_know_is_refused() {
    let run = |case: &Case<'_>| Ok(case.run(Simulation::new(&swing::Free { l: case.get("l")? }))?);
    let order = || Sweep::new(&FREE, Plan::new().grid("l", [0.5]), run).in_lanes(&FREE);
    for kept in ["max:bob.phi", "work.model", "error"] {
        let refused = order().keep(["bob.phi", kept]).check().unwrap_err().to_string();
        assert!(
            refused.contains("of cases in lanes only ends are known, and `") && refused.contains(kept),
            "{refused}"
        );
    }
    let refused = order().keep_number("mine", "m", |run| run.last().t).check().unwrap_err().to_string();
    assert!(refused.contains("`mine` needs more"), "{refused}");
    order().keep(["bob.phi", "tip.y", "kinetic"]).check().unwrap();
}
