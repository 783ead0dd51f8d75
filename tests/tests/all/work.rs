//! Work as a state of the integration.

use crate::scenes::{Case, coast, driven};
use ezy_core::prelude::*;

/// RK4 at 10 ms over 60 s: 7.4e-8 J by the order of the method.
const COARSE_BALANCE: f64 = 2e-7;
/// Halving the step divides an error of order four by sixteen; higher terms take or give a tenth.
const RATIO: std::ops::RangeInclusive<f64> = 14.5..=17.5;

#[test]
fn order_work_equals_kinetic_energy_to_fourth_order() {
    for Case { route, scene } in driven() {
        let gap = |h: f64| {
            let run = Simulation::new(&*scene).work().method(Method::rk4(h)).run().unwrap();
            run.last().energy.balance.abs()
        };
        let (coarse, fine) = (gap(0.02), gap(0.01));
        assert!(fine <= COARSE_BALANCE, "{route}: {fine:.1e}");
        assert!(RATIO.contains(&(coarse / fine)), "{route}: {coarse:.2e} / {fine:.2e} = {:.2}", coarse / fine);
    }
}

#[test]
fn invariant_work_of_effects_adds_up() {
    for Case { route, scene } in driven() {
        let run = Simulation::new(&*scene).work().until(5.0).every(1.0).run().unwrap();
        assert_eq!(run.first().energy.work, 0.0, "{route}");
        for s in run.samples() {
            assert_eq!(s.work.iter().sum::<f64>(), s.energy.work, "{route}");
            assert_eq!(s.get("work.pump"), Ok(s.energy.work), "{route}");
        }
    }
}

#[test]
fn invariant_coast_has_no_effects_and_no_work() {
    for Case { route, scene } in coast() {
        let run = Simulation::new(&*scene).work().run().unwrap();
        assert!(run.last().work.is_empty(), "{route}");
        assert_eq!(run.last().energy.work, 0.0, "{route}");
    }
}
