//! Samples: when they are taken, what they say, where they go; and that taking them changes nothing.

use crate::scenes::{Case, all, distance, driven};
use ezy_core::prelude::*;
use ezy_core::record::columns;
use ezy_core::simulate::SetupError;
use ezy_core_tests::simulation;
use ezy_tests::reference::load;
use std::io::Write;

/// The method at 20 ms has 2e-8 by 1 s; interpolation of the sixth (fifth for velocities) order adds less.
const BETWEEN_STEPS: f64 = 2e-7;

#[test]
fn invariant_recording_never_changes_the_motion() {
    for Case { route, scene } in all() {
        let run = |method: Method, every: Option<f64>| {
            let order = simulation(&*scene).work().until(1.0).method(method);
            let order = if let Some(every) = every { order.every(every) } else { order };
            order.run().unwrap().last().numbers().map(f64::to_bits).collect::<Vec<_>>()
        };
        let rk4 = Method::rk4(3e-3);
        for every in [0.003, 0.01, 1e-4, 0.7, 5.0] {
            assert_eq!(run(rk4, None), run(rk4, Some(every)), "{route}: every {every}");
        }
        // a scene written by hand has no Jacobians
        let radau = scene.jacobian_places().map(|_| Method::radau(1e-6));
        for method in [Method::dop853(1e-6)].into_iter().chain(radau) {
            assert_eq!(run(method, None), run(method, Some(0.01)), "{route}: {method:?}");
        }
    }
}

#[test]
fn invariant_run_prints_itself_on_one_screen() {
    for Case { route, scene } in all() {
        let run = simulation(&*scene).method(Method::rk4(1e-3)).until(1.0).every(1e-3).run().unwrap();
        let (line, lines) = (format!("{run:?}"), format!("{run:#?}"));
        assert!(line.contains("ReachedEnd") && line.contains("n_samples: 1001"), "{route}: {line}");
        assert!(lines.lines().count() <= 24, "{route}: {lines}");
    }
}

#[test]
fn invariant_samples_fall_on_the_grid_and_the_end() {
    for Case { route, scene } in driven() {
        for (step, every, until, expected) in [
            (1e-3, 0.25, 1.0, vec![0.0, 0.25, 0.5, 0.75, 1.0]),
            (0.3, 0.5, 1.1, vec![0.0, 0.5, 1.0, 1.1]),
            (0.1, 0.3, 0.6, vec![0.0, 0.3, 0.6]),
            (0.5, 2.0, 0.75, vec![0.0, 0.75]),
        ] {
            let run = simulation(&*scene).method(Method::rk4(step)).every(every).until(until).run().unwrap();
            let times: Vec<f64> = run.samples().map(|s| s.t).collect();
            assert!(times.len() == expected.len() && distance(&times, &expected) < 1e-12, "{route}: {times:?}");
            assert_eq!(run.last().t, until, "{route}: the end to the bit");
        }
    }
}

#[test]
fn invariant_without_interval_only_start_and_end_are_kept() {
    for Case { route, scene } in all() {
        let run = simulation(&*scene).method(Method::rk4(1e-3)).until(0.5).run().unwrap();
        let times: Vec<f64> = run.samples().map(|s| s.t).collect();
        assert_eq!(times, [0.0, 0.5], "{route}");
    }
}

#[test]
fn reference_samples_between_steps() {
    let reference = load("ezyroller_driven");
    for Case { route, scene } in driven() {
        let run = simulation(&*scene).method(Method::rk4(0.03)).until(1.0).every(0.5).work().run().unwrap();
        let (s, r) = (run.samples().nth(1).unwrap(), &reference[1]);
        assert_eq!(s.t, r.t);
        for (what, error) in [
            ("q", distance(s.coordinates, &r.q)),
            ("v", distance(s.velocities, &r.v)),
            ("a", distance(s.accelerations, &r.a)),
            ("W", (s.energy.work - r.work).abs()),
        ] {
            assert!(error <= BETWEEN_STEPS, "{route}: {what} off by {error:.1e}");
        }
    }
}

#[test]
fn invariant_sample_names_cover_all_numbers() {
    for Case { route, scene } in all() {
        let run = simulation(&*scene).method(Method::rk4(1e-3)).work().until(0.1).run().unwrap();
        let s = run.last();
        for (column, number) in columns(s.info, s.wanted).iter().zip(s.numbers()) {
            assert_eq!(s.get(&column.name), Ok(number), "{route}: {}", column.name);
            assert_eq!(run.column(&column.name).unwrap()[1], number, "{route}: {}", column.name);
        }
        assert_eq!(s.get("seat.omega"), Ok(s.velocities[2]), "{route}");
        assert_eq!(s.get("lambda.front"), Ok(s.multipliers[3]), "{route}");
        let error = s.get("kinetik").unwrap_err();
        assert_eq!(error.nearest.as_deref(), Some("kinetic"), "{route}");
    }
}

#[test]
fn invariant_csv_gives_back_the_same_bits() {
    for Case { route, scene } in driven() {
        let mut file = Vec::new();
        let mut writer = CsvWriter::new(&mut file);
        let run = simulation(&*scene)
            .method(Method::rk4(1e-3))
            .until(1.0)
            .every(0.1)
            .work()
            .record_to(&mut writer)
            .run()
            .unwrap();
        drop(writer);
        let text = String::from_utf8(file).unwrap();
        let mut lines = text.lines();
        let header = lines.next().unwrap();
        assert!(header.starts_with("t [s],seat.x [m],seat.y [m],seat.phi [rad]"), "{route}: {header}");
        assert!(header.contains(",lambda.B.x [N],") && header.contains(",work.pump [J],"), "{route}: {header}");
        assert_eq!(lines.clone().count(), run.samples().len(), "{route}");
        for (line, s) in lines.zip(run.samples()) {
            let read: Vec<u64> = line.split(',').map(|x| x.parse::<f64>().unwrap().to_bits()).collect();
            assert_eq!(read, s.numbers().map(f64::to_bits).collect::<Vec<_>>(), "{route}");
        }
    }
}

/// A disk that is full after some bytes.
struct FullDisk(usize);

impl Write for FullDisk {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.0 = self.0.checked_sub(bytes.len()).ok_or(std::io::ErrorKind::StorageFull)?;
        Ok(bytes.len())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

#[test]
fn invariant_full_disk_stops_the_run_and_keeps_the_samples() {
    for Case { route, scene } in driven() {
        let mut writer = CsvWriter::new(FullDisk(5000));
        let run = simulation(&*scene).method(Method::rk4(1e-3)).every(0.1).record_to(&mut writer).run().unwrap();
        assert!(!run.outcome.reached_end(), "{route}");
        assert!(run.outcome.to_string().contains("could not be written"), "{route}: {}", run.outcome);
        assert!(run.samples().len() > 5, "{route}");
    }
}

/// A recorder sees each sample when it is made.
#[derive(Default)]
struct Times(Vec<f64>);

impl Recorder for Times {
    fn record(&mut self, sample: &Sample<'_>) -> Result<(), RecordError> {
        self.0.push(sample.t);
        Ok(())
    }
}

#[test]
fn invariant_recorder_gets_every_sample_once() {
    for Case { route, scene } in driven() {
        let mut times = Times::default();
        let run =
            simulation(&*scene).method(Method::rk4(1e-3)).until(1.0).every(0.07).record_to(&mut times).run().unwrap();
        assert_eq!(times.0, run.samples().map(|s| s.t).collect::<Vec<_>>(), "{route}");
    }
}

/// Times in any order, and those of start and end again, give each sample once; it is that of a run with these times at equal intervals.
#[test]
fn cross_samples_at_given_times_are_those_at_equal_intervals() {
    for Case { route, scene } in driven() {
        for method in [Method::rk4(3e-3), Method::dop853(1e-8)] {
            let order = || simulation(&*scene).method(method).until(1.0);
            let (grid, given) = (order().every(0.25), order().at([0.75, 1.0, 0.25, 0.0, 0.25]));
            let (grid, given) = (grid.run().unwrap(), given.run().unwrap());
            let bits = |sample: Sample<'_>| sample.numbers().map(f64::to_bits).collect::<Vec<_>>();
            let expected: Vec<_> = [0, 1, 3, 4].into_iter().filter_map(|i| grid.samples().nth(i)).map(bits).collect();
            assert_eq!(given.samples().map(bits).collect::<Vec<_>>(), expected, "{route}: {method:?}");
        }
    }
}

#[test]
fn analytic_sample_times_outside_of_the_run_are_refused() {
    for Case { scene, .. } in driven() {
        for t in [-0.1, 1.5, f64::NAN] {
            let error = simulation(&*scene).until(1.0).at([0.5, t]).run().unwrap_err();
            assert!(matches!(error, SetupError::SampleTime { .. }), "{error}");
        }
    }
}
