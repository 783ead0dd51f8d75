//! Inputs while a scene runs: numbers, tables, files, control laws.

use crate::scenes::distance;
use ezy_core::model::SceneInfo;
use ezy_core::prelude::*;
use ezy_core::simulate::{InputFileError, TableError};
use ezy_tests::piloted::piloted;
use std::f64::consts::PI;

/// RK4 at 1 ms over 2 s, on each side; the equations differ by rounding alone.
const ALIKE: f64 = 1e-12;
/// Balance of a run at 1 ms, J: the order of the method, with jumps of the input at steps only.
const BALANCE: f64 = 1e-9;
const STEP: f64 = 1e-3;

fn bits(sample: Sample<'_>) -> Vec<u64> {
    sample.numbers().map(f64::to_bits).collect()
}

#[test]
fn invariant_number_table_and_law_of_one_value_give_the_same_bits() {
    let scene = piloted::Ridden::default();
    let order = || Simulation::new(&scene).method(Method::rk4(1e-3)).work().outputs();
    let declared = bits(order().run().unwrap().last());
    assert_eq!(bits(order().input("torque", 50.0).run().unwrap().last()), declared);
    let table = InputTable::new(vec![0.0, 1.0], vec![50.0, 50.0]).unwrap();
    assert_eq!(bits(order().input("torque", table).run().unwrap().last()), declared);
    assert_eq!(bits(order().control(|_, set| set.torque = 50.0).run().unwrap().last()), declared);
    assert_ne!(bits(order().input("torque", 51.0).run().unwrap().last()), declared);
}

#[test]
fn invariant_later_setting_of_an_input_counts() {
    let scene = piloted::Ridden::default();
    let table = || InputTable::new(vec![0.0, 1.0], vec![10.0, 20.0]).unwrap();
    let order = || Simulation::new(&scene).method(Method::rk4(1e-3)).until(0.1);
    let end = |order: Simulation<'_, &piloted::Ridden>| bits(order.run().unwrap().last());
    assert_eq!(end(order().input("torque", table()).input("torque", 3.0)), end(order().input("torque", 3.0)));
    assert_eq!(end(order().input("torque", 3.0).input("torque", table())), end(order().input("torque", table())));
}

#[test]
fn cross_input_and_parameter_of_one_value_end_alike() {
    let by_input = piloted::Ridden::default();
    let by_parameter = piloted::Driven { torque: -30.0 };
    let by_input = Simulation::new(&by_input).method(Method::rk4(1e-3)).work().input("torque", -30.0).run().unwrap();
    let by_parameter = Simulation::new(&by_parameter).method(Method::rk4(1e-3)).work().run().unwrap();
    let error = distance(by_input.last().coordinates, by_parameter.last().coordinates);
    assert!(error <= ALIKE, "{error:.1e}");
    assert!((by_input.last().energy.work - by_parameter.last().energy.work).abs() <= ALIKE);
}

#[test]
fn invariant_law_is_called_once_a_step_and_held() {
    let scene = piloted::Ridden::default();
    let mut times = Vec::new();
    let law = |now: &Now<piloted::Ridden>, set: &mut Inputs<piloted::Ridden>| {
        times.push(now.t);
        set.torque = 100.0 * now.t;
    };
    let run = Simulation::new(&scene).method(Method::rk4(1e-3)).until(0.01).every(5e-4).control(law).run().unwrap();
    let expected: Vec<f64> = (0..10).map(|n| f64::from(n) * STEP).collect();
    assert!(distance(&times, &expected) <= ALIKE, "{times:?}");
    // the input of a sample is the one that holds from there on; the last step's at the end
    let held: Vec<f64> = run.samples().map(|s| s.inputs[0]).collect();
    let expected: Vec<f64> = (0..21).map(|i| 0.1 * f64::from((i / 2).min(9))).collect();
    assert!(distance(&held, &expected) <= ALIKE, "{held:?}");
}

#[test]
fn invariant_recording_never_changes_a_controlled_motion() {
    let scene = piloted::Ridden::default();
    let end = |every: Option<f64>| {
        let mut sum = 0.0;
        let order =
            Simulation::new(&scene).method(Method::rk4(1e-3)).work().outputs().until(1.0).control(move |now, set| {
                sum += now.bar.omega;
                set.torque = 50.0 - sum;
            });
        let order = if let Some(every) = every { order.every(every) } else { order };
        bits(order.run().unwrap().last())
    };
    for every in [1e-3, 3e-4, 0.017] {
        assert_eq!(end(None), end(Some(every)), "every {every}");
    }
}

#[test]
fn invariant_motion_is_the_same_without_work_and_outputs() {
    let scene = piloted::Pushed::default();
    let law = |now: &Now<piloted::Pushed>, set: &mut Inputs<piloted::Pushed>| (set.torque, set.pull) = (now.t, now.t);
    let motion = |s: Sample<'_>| bits(s)[..25].to_vec();
    let bare = Simulation::new(&scene).method(Method::rk4(1e-3)).control(law).run().unwrap();
    let full = Simulation::new(&scene).method(Method::rk4(1e-3)).work().outputs().control(law).run().unwrap();
    assert_eq!(motion(bare.last()), motion(full.last()));
    let message = |name: &str| bare.last().get(name).unwrap_err().to_string();
    assert_eq!(message("balance"), "column `balance` was not recorded; call `.work()` on the simulation");
    assert_eq!(message("output.speed"), "column `output.speed` was not recorded; call `.outputs()` on the simulation");
    assert!(message("output.sped").starts_with("column `output.sped` is not known"));
    assert!(full.last().get("work.rider").is_ok() && full.last().get("output.speed").is_ok());
}

#[test]
fn invariant_energy_balances_under_control() {
    let scene = piloted::Pushed::default();
    let law = |now: &Now<piloted::Pushed>, set: &mut Inputs<piloted::Pushed>| {
        set.torque = 200.0 * (PI / 2.0 - (now.bar.phi - now.seat.phi));
        set.pull = if now.t < 1.0 { 10.0 } else { -10.0 };
    };
    let run = Simulation::new(&scene).method(Method::rk4(STEP)).work().every(0.1).control(law).run().unwrap();
    for s in run.samples() {
        assert!(s.energy.balance.abs() <= BALANCE, "{:.1e} J at {} s", s.energy.balance, s.t);
        assert_eq!(s.work.len(), 2);
    }
}

#[test]
fn analytic_table_of_two_rows_is_a_line() {
    let table = InputTable::new(vec![1.0, 3.0], vec![2.0, 6.0]).unwrap();
    assert_eq!([0.0, 1.0, 1.5, 2.0, 3.0, 4.0].map(|t| table.at(t)), [2.0, 2.0, 3.0, 4.0, 6.0, 6.0]);
}

#[test]
fn analytic_rows_at_one_time_are_a_jump() {
    let table = InputTable::new(vec![0.0, 1.0, 1.0, 2.0], vec![0.0, 1.0, 5.0, 7.0]).unwrap();
    assert_eq!([0.5, 1.0, 1.5, 2.0].map(|t| table.at(t)), [0.5, 5.0, 6.0, 7.0]);
    let held = InputTable::held(vec![0.0, 1.0, 2.0], vec![3.0, 4.0, 5.0]).unwrap();
    assert_eq!([-1.0, 0.0, 0.9, 1.0, 1.9, 2.0, 9.0].map(|t| held.at(t)), [3.0, 3.0, 3.0, 4.0, 4.0, 5.0, 5.0]);
}

#[test]
fn invariant_bad_tables_are_refused() {
    assert_eq!(InputTable::new(vec![], vec![]), Err(TableError::Lengths { n_times: 0, n_values: 0 }));
    assert_eq!(InputTable::new(vec![0.0, 2.0, 1.0], vec![0.0; 3]), Err(TableError::Backwards { row: 3, t: 1.0 }));
    assert!(matches!(InputTable::new(vec![0.0], vec![f64::NAN]), Err(TableError::NotFinite { row: 1, .. })));
}

/// A ramp of the input is read in the middle of each step: the error goes with the square of the step.
#[test]
fn order_ramp_of_an_input_is_two() {
    let scene = piloted::Ridden::default();
    let ramp = || InputTable::new(vec![0.0, 2.0], vec![-100.0, 100.0]).unwrap();
    let end = |h: f64| {
        let run = Simulation::new(&scene).method(Method::rk4(h)).input("torque", ramp()).run().unwrap();
        run.last().coordinates.to_vec()
    };
    let ends = [0.02, 0.01, 0.005].map(end);
    let order = (distance(&ends[0], &ends[1]) / distance(&ends[1], &ends[2])).log2();
    assert!((order - 2.0).abs() < 0.1, "{order:.3}");
}

#[test]
fn invariant_inputs_that_are_no_numbers_are_named() {
    let scene = piloted::Ridden::default();
    let error = Simulation::new(&scene).input("torque", f64::NAN).run().unwrap_err().to_string();
    assert!(error.contains("input `torque` is set to NaN at t = 0 s"), "{error}");
    let error = Simulation::new(&scene).input("torqe", 1.0).run().unwrap_err().to_string();
    assert!(error.starts_with("input `torqe` is not known (did you mean `torque`?)"), "{error}");
    let run = Simulation::new(&scene)
        .method(Method::rk4(1e-3))
        .outputs()
        .control(|now, set| set.torque = if now.t < 0.5 { 1.0 } else { f64::INFINITY })
        .run()
        .unwrap();
    assert!(run.outcome.to_string().contains("input `torque` is set to inf"), "{}", run.outcome);
    assert_eq!(run.last().inputs, [1.0]);
    let coast = piloted::Coast::default();
    let error = Simulation::new(&coast).input("torque", 1.0).run().unwrap_err().to_string();
    assert_eq!(error, "input `torque` is not known; known: none");
}

fn tables(text: &str) -> Result<Vec<(String, InputTable)>, InputFileError> {
    read_inputs(text.as_bytes(), &piloted::Pushed::INFO)
}

#[test]
fn invariant_file_of_inputs_is_read_by_its_names() {
    let read = tables("pull, t [s], torque [N*cm]\n1, 0, 10\n3, 2, 30\n").unwrap();
    assert_eq!((read[0].0.as_str(), read[0].1.at(1.0)), ("pull", 2.0));
    assert_eq!((read[1].0.as_str(), read[1].1.at(1.0)), ("torque", 20.0));
}

#[test]
fn invariant_file_of_a_run_gives_its_inputs_back() {
    let scene = piloted::Ridden::default();
    let mut file = Vec::new();
    let mut writer = CsvWriter::new(&mut file);
    let order = Simulation::new(&scene).method(Method::rk4(1e-3)).every(0.1).outputs();
    order.control(|now, set| set.torque = 100.0 * now.t.sin()).record_to(&mut writer).run().unwrap();
    drop(writer);
    let read = read_inputs(&file[..], &scene.info()).unwrap();
    assert_eq!(read.len(), 1);
    for t in [1.0, 1.0999] {
        assert!((read[0].1.at(t) - 100.0 * 1.0_f64.sin()).abs() <= ALIKE, "held from {t} s");
    }
}

#[test]
fn invariant_bad_files_of_inputs_are_explained() {
    let message = |text: &str| tables(text).unwrap_err().to_string();
    assert!(message("time,torque\n0,1\n").contains("no column `t`"));
    assert!(message("t,torqe\n0,1\n").contains("did you mean `torque`?"));
    assert!(message("t,torque [N*m]\n0,1\n").contains("is in N*m, but must be in N*cm"));
    assert!(message("t [ms],torque\n0,1\n").contains("column `t` of the file of inputs is in ms, but must be in s"));
    assert!(message("t,torque,torque [N*cm]\n0,1,2\n").contains("two columns `torque`"));
    assert!(message("t,t,torque\n0,1,2\n").contains("two columns `t`"));
    assert!(message("t [s]\n0\n1\n").contains("has no column of an input"));
    assert!(message("t,torque\n0,1\n1,x\n").contains("row 2 of the file of inputs has `x` for `torque`"));
    assert!(message("t,torque\n1,1\n0,1\n").contains("row 2 of the table is at 0 s"));
    assert!(message("t,torque\n").contains("0 times"));
}

#[test]
fn invariant_names_of_inputs_and_outputs_are_found() {
    let info: &SceneInfo = &piloted::Pushed::INFO;
    assert_eq!((input_index(info, "pull"), output_index(info, "wheel.y")), (Ok(1), Ok(2)));
    assert_eq!(output_index(info, "sped").unwrap_err().nearest.as_deref(), Some("speed"));
}
