//! No step of a run allocates: a run of ten times the steps allocates as often. What a run holds grows as its bodies.

use ezy_core::prelude::*;
use ezy_models::{chain, ezy_roller, n_four_bar, road_train};
use ezy_tests::hand_roller::HandRoller;
use ezy_tests::page::{docs, part, write_part};
use ezy_tests::piloted::piloted;
use std::sync::Arc;

model! {
    /// Two chains side by side, joined by springs; with what else a description has for each member.
    pub model Ladder {
        count n = 10;
        body left[n] { mass: 1, inertia: 1 }
        body right[n] { mass: 1, inertia: 1 }
        hinge top: ground(0, 0) ~ left[0](-0.5, 0);
        for i in 1..n { hinge pin[i]: left[i-1](0.5, 0) ~ left[i](-0.5, 0); }
        for i in 0..n { skate blade[i]: at right[i](0, 0) along right[i](1, 0); }
        for i in 0..n { spring left[i](0, 0) ~ right[i](0, 0): stiffness 10, length 1; }
        for i in 0..n { point tip[i] = right[i](0.5, 0); }
        for i in 0..n { output bend[i] = left[i].phi - right[i].phi; }
        start level { at rest; }
        scene swing { start level; until 1 s; }
        scene slide { start level; until 1 s; }
        scene sway { start level; until 1 s; }
    }
}

fn allocations(scene: &dyn Scene, backend: Backend, metric: Metric, n_steps: u32) -> u64 {
    let mut n_done = 0;
    let info = allocation_counter::measure(|| {
        let order = Simulation::new(scene).backend(backend).metric(metric).method(Method::rk4(1e-3));
        n_done = order.until(f64::from(n_steps) * 1e-3).run().unwrap().cost.steps;
    });
    assert_eq!(n_done, u64::from(n_steps));
    info.count_total
}

#[test]
fn invariant_steps_do_not_allocate() {
    let scenes: [(&str, &dyn Scene); 3] = [
        ("hand", &HandRoller::driven()),
        ("generated", &ezy_roller::Driven::default()),
        ("generated coast", &ezy_roller::Coast::default()),
    ];
    for (route, scene) in scenes {
        // described at the first use
        scene.info();
        for backend in [Backend::Generated, Backend::Dense, Backend::Sparse] {
            for metric in [Metric::Mass, Metric::Euclidean] {
                let [few, many] = [100, 1000].map(|n| allocations(scene, backend, metric, n));
                assert_eq!(few, many, "{route} {backend:?} {metric:?}");
            }
        }
    }
}

#[test]
fn invariant_taylor_steps_do_not_allocate() {
    let scene = HandRoller::driven();
    for backend in [Backend::Generated, Backend::Dense, Backend::Sparse] {
        let allocations = |until_s: f64| {
            let order = Simulation::new(&scene).method(Method::taylor(1e-12)).backend(backend).work().until(until_s);
            allocation_counter::measure(|| assert!(order.run().unwrap().cost.steps >= 2)).count_total
        };
        assert_eq!(allocations(1.0), allocations(10.0), "{backend:?}");
    }
}

#[test]
fn invariant_steps_of_a_scene_with_counts_do_not_allocate() {
    let scene = chain::Swing { n: 5, ..Default::default() };
    // held, so that every run shares it
    let _info = scene.info();
    let [few, many] = [100, 1000].map(|n| allocations(&scene, Backend::Auto, Metric::Mass, n));
    assert_eq!(few, many);
}

#[test]
fn invariant_stepper_does_not_allocate() {
    let scene = piloted::Pushed::default();
    for backend in [Backend::Generated, Backend::Dense, Backend::Sparse] {
        let mut stepper = Simulation::new(&scene).method(Method::rk4(1e-3)).backend(backend).work().stepper().unwrap();
        let mut episode = |given: &[(&str, f64)], n: u64| {
            stepper.reset_with(given).unwrap();
            for _ in 0..n {
                let now = stepper.now();
                let seen = now.outputs().speed + now.seat.phi;
                let seen = seen + stepper.outputs()[0] + stepper.energy().kinetic;
                let reaction = stepper.multipliers().unwrap()[0] + stepper.accelerations().unwrap()[0];
                stepper.inputs_mut().fill((seen + reaction).sin());
                stepper.set().pull += 1.0;
                stepper.step(2).unwrap();
            }
            stepper.reset();
            stepper.step(1).unwrap();
        };
        // the first reset to a start assembles it
        episode(&[("bar.phi", 1.2)], 10);
        let info = allocation_counter::measure(|| episode(&[("bar.phi", 1.2)], 100));
        assert_eq!(info.count_total, 0, "{backend:?}");
    }
}

#[test]
fn invariant_controlled_steps_do_not_allocate() {
    let scene = piloted::Pushed::default();
    let allocations = |n_steps: u32| {
        let table = InputTable::new(vec![0.0, 1.0], vec![0.0, 5.0]).unwrap();
        let law = |now: &Now<piloted::Pushed>, set: &mut Inputs<piloted::Pushed>| {
            set.torque = now.t - now.bar.omega + now.outputs().wheel.x * 1e-6;
        };
        let order = Simulation::new(&scene)
            .method(Method::rk4(1e-3))
            .work()
            .input("pull", table)
            .control(law)
            .until(f64::from(n_steps) * 1e-3);
        allocation_counter::measure(|| assert!(order.run().unwrap().outcome.reached_end())).count_total
    };
    assert_eq!(allocations(100), allocations(1000));
}

#[test]
fn invariant_names_of_arrays_do_not_allocate() {
    // a scene of its own: a description is shared by all that use a scene
    let scene = ladder::Sway { n: 5 };
    let _info = scene.info();
    let allocations = |n_steps: u32| {
        let mut sum = 0.0;
        let law = |now: &Now<ladder::Sway>, _: &mut Inputs<ladder::Sway>| {
            sum += now.left.at(3).phi + now.outputs().bend.at(2);
        };
        let order = Simulation::new(&scene).method(Method::rk4(1e-3)).control(law).until(f64::from(n_steps) * 1e-3);
        allocation_counter::measure(|| assert!(order.run().unwrap().outcome.reached_end())).count_total
    };
    assert_eq!(allocations(100), allocations(1000));
}

#[test]
fn invariant_radau_steps_do_not_allocate() {
    let scene = ezy_roller::Driven::default();
    let allocations = |until_s: f64| {
        let order = Simulation::new(&scene).method(Method::radau(1e-9)).work().until(until_s);
        allocation_counter::measure(|| assert!(order.run().unwrap().cost.steps >= 20)).count_total
    };
    assert_eq!(allocations(1.0), allocations(10.0));
}

/// Descriptions and systems that live at once: one that is held, the one that was asked for last, and what it takes to make one.
const LIVE_AT_ONCE: f64 = 3.0;

#[test]
fn invariant_descriptions_are_freed_when_nobody_holds_them() {
    let describe = |n: usize| ladder::Swing { n }.info();
    describe(1);
    let used = |n: usize| drop(System::new(&ladder::Swing { n }, Backend::Auto).unwrap());
    let largest = allocation_counter::measure(|| used(1000)).bytes_max as f64;
    describe(1);
    let held = Arc::downgrade(&describe(1));
    let all = allocation_counter::measure(|| {
        for n in 2..=1000 {
            let info = describe(n);
            assert_eq!(info.bodies.len(), 2 * n);
            if n % 200 == 0 {
                used(n);
            }
        }
        assert!(held.upgrade().is_none());
        drop(held);
        describe(1);
    });
    assert_eq!((all.bytes_current, all.count_current), (0, 0));
    println!("largest description, used, {largest} bytes, at most {} at once", all.bytes_max);
    assert!(all.bytes_max as f64 <= LIVE_AT_ONCE * largest, "{all:?}, one description, used, {largest}");
}

/// Share by which bytes of a member grow when indices get a digit more.
const LONGER_NAMES: f64 = 0.02;

#[test]
fn order_description_is_one_in_the_count() {
    let cost = |n: usize| {
        ladder::Slide { n: 1 }.info();
        let cost = allocation_counter::measure(|| {
            let info = ladder::Slide { n }.info();
            // made when it is read
            let names = [info.coordinates.iter(), info.velocities.iter()].into_iter().flatten().map(|c| &c.name);
            let names = names.chain(info.rows.iter().map(|row| &row.name)).chain(&info.bodies);
            let names = names.chain(info.points.iter().map(|point| &point.name));
            let names = names.chain(info.outputs.iter().map(|output| &output.name));
            // bodies, two positions and three velocities of each, two rows of a hinge and one of a skate, points with the hinges, outputs
            assert_eq!(names.count(), n * (2 + 6 + 6 + 2 + 1 + 2 + 1));
        });
        [cost.bytes_total as f64, cost.bytes_max as f64, cost.count_total as f64]
    };
    let [small, large] = [1000, 2000].map(cost);
    println!("n = 1000: {small:?}, n = 2000: {large:?} (bytes, bytes at once, allocations)");
    for (small, large) in small.iter().zip(large) {
        assert!(*small > 1000.0 && large <= (2.0 + LONGER_NAMES) * small, "{small}, then {large}");
    }
}

/// Bytes that a run of two steps holds at once, of a scene with `n` members.
fn bytes_of_a_run(scene: &dyn Scene) -> f64 {
    let order = Simulation::new(scene).method(Method::rk4(1e-3)).until(2e-3);
    let all = allocation_counter::measure(|| assert!(order.run().unwrap().outcome.reached_end()));
    all.bytes_max as f64
}

/// A scene, what one member of it is, and the bytes of a run with so many.
type Measured<'a> = (&'a str, &'a str, &'a dyn Fn(usize) -> f64);

/// Share by which another compiler may pack structs.
const PACKED: f64 = 0.01;

/// `UPDATE_GOLDEN=1 cargo test -p ezy-tests --test allocations bytes` writes the table anew.
#[test]
fn regress_bytes_of_a_member_are_those_of_the_page() {
    let chain = |n| bytes_of_a_run(&chain::Swing { n, ..Default::default() });
    let train = |n| bytes_of_a_run(&road_train::Circling { n, ..Default::default() });
    let loops = |n| bytes_of_a_run(&n_four_bar::Fall { n, ..Default::default() });
    let runs: [Measured<'_>; 3] = [
        ("`chain/swing`", "rod, with a hinge", &chain),
        ("`roadtrain/circling`", "trailer, with a hinge and a skate", &train),
        ("`nfourbar/fall`", "four-bar, of two bars and three hinges", &loops),
    ];
    let bytes = runs.map(|(.., run)| (run(2000) - run(1000)) / 1000.0);
    let rows = runs.iter().zip(bytes).map(|((scene, what, _), bytes)| format!("| {scene} | {what} | {bytes:.0} |\n"));
    let now = format!("| scene | a member | bytes |\n|---|---|---:|\n{}", rows.collect::<String>());
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        write_part("cost.md", "bytes", &now).unwrap();
    }
    let page = std::fs::read_to_string(docs("cost.md")).unwrap();
    let told = part(&page, "bytes").unwrap().lines().skip(2).map(|line| {
        let cell = line.trim_end_matches([' ', '|']).rsplit(' ').next().unwrap();
        cell.parse::<f64>().unwrap()
    });
    assert!(
        told.clone().count() == bytes.len() && told.zip(bytes).all(|(told, now)| (told - now).abs() <= PACKED * now),
        "{now}"
    );
}
