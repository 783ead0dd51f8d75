//! First-order states: where they stand, their rates and Jacobians, and what scenes with states lack.

use crate::diag::Diagnostics;
use crate::function::Function;
use crate::mechanics::derived::Form;
use crate::mechanics::jacobians::JacobianEntry;
use crate::mechanics::kernels::Quantity;
use crate::mechanics::symbols::{Meaning, Symbols};
use crate::mechanics::{Derived, Equations, EventKind};
use crate::model::{self, Model};
use crate::parse;
use crate::symbolic::Symbol;
use crate::symbolic::evaluate::Point;

/// Some operations on numbers of one to a thousand.
const ROUNDING: f64 = 1e-12;

fn resolved(items: &str) -> Model {
    let text = format!(
        "model M {{ body wheel {{ mass: 1, inertia: 2 }} {items} start s {{ at rest; }} \
         scene plain {{ start s; until 1 s; }} }}"
    );
    let mut diag = Diagnostics::default();
    let syntax = parse::parse(text.parse().expect("the text has tokens"), &mut diag);
    let model = model::resolve(syntax, &mut diag);
    assert!(diag.is_empty(), "{}", diag.into_compile_errors());
    model.expect("a text without faults is a model")
}

/// A motion in which each kind of number has a value of its own.
struct Motion<'a> {
    symbols: &'a Symbols,
    parameters: Vec<f64>,
    inputs: &'a [f64],
    omega: f64,
}

impl Point for Motion<'_> {
    fn symbol(&self, symbol: Symbol) -> f64 {
        match self.symbols.meaning(symbol) {
            Meaning::Input(i) => self.inputs[i],
            Meaning::Velocity(2) => self.omega,
            _ => 0.0,
        }
    }

    fn parameter(&self, index: usize) -> f64 {
        self.parameters[index]
    }
}

#[test]
fn analytic_rates_are_in_the_units_of_states_which_stand_behind_inputs() {
    let model = resolved(
        "param R: ohm = 0.5; param L: mH = 2; param k: N*m/A = 0.05; state current: mA = 0 rate (u - R*current - k*wheel.omega)/L; \
         input u: V = 12; state way: m = 0 rate 3 m/s; torque wheel: k*current;",
    );
    let equations = Equations::derive(&model, &model.scenes[0]);
    let names: Vec<_> = equations.inputs.iter().map(|id| model.inputs[id.0].name.to_string()).collect();
    assert_eq!(names, ["u", "current", "way"]);
    let [inputs, states] = model.split_states(&equations.inputs);
    assert_eq!((inputs.len(), states.len()), (1, 2));
    let (u, milliamperes, omega) = (11.0, 300.0, 7.0);
    let motion = Motion {
        symbols: &equations.symbols,
        parameters: vec![0.5, 2e-3, 0.05],
        inputs: &[u, milliamperes, 0.0],
        omega,
    };
    let value = |sum| equations.algebra.evaluate(sum, &motion);
    let expected = 1000.0 * (u - 0.5 * 0.3 - 0.05 * omega) / 2e-3;
    let rate = value(equations.rates[0]);
    assert!((rate - expected).abs() < ROUNDING * expected, "{rate} in place of {expected}");
    assert_eq!(value(equations.rates[1]), 3.0);
    assert!((value(equations.force[2]) - 0.05 * 0.3).abs() < ROUNDING);
}

#[test]
fn analytic_discontinuities_of_rates_are_found() {
    let model = resolved("state z: m = 1 rate max(wheel.vx, 0) - z / (3 s); force at wheel(0, 0): (0, z * 2 (N/m));");
    let equations = Equations::derive(&model, &model.scenes[0]);
    let kinds: Vec<_> = equations.events.iter().map(|event| matches!(event.kind, EventKind::Discontinuity)).collect();
    assert_eq!(kinds, [true]);
}

#[test]
fn analytic_feedback_is_that_of_rates_too() {
    let feedback = |items: &str| {
        let model = resolved(items);
        Derived::new(&model, &model.scenes[0]).feedback()
    };
    assert_eq!(feedback("force at wheel(0, 0): (1, 2);"), Some(vec![]));
    assert_eq!(feedback("state z: m = 0 rate wheel.y / (1 s); force at wheel(0, 0): (z * 2 (N/m), 2);"), Some(vec![1]));
}

#[test]
fn invariant_scenes_with_states_have_rates_series_and_jacobians() {
    for counts in ["", "count n = 3; body link[n] { mass: 1, inertia: 1 } for i in 0..n { torque link[i]: 2; }"] {
        let last = if counts.is_empty() { "wheel" } else { "link[n-1]" };
        let state = format!("state z: m = 0 rate {last}.vx; force at {last}(0, 0): (z * 2 (N/m), 0);");
        for (items, has_states) in [(state, true), (String::new(), false)] {
            let model = resolved(&format!("{counts} {items}"));
            let derived = Derived::new(&model, &model.scenes[0]);
            let has = |quantity| derived.kernels.contains_key(&quantity);
            assert_eq!(has(Quantity::StateRates), has_states, "{counts}");
            assert_eq!((has(Quantity::SeriesBegin), has(Quantity::Jacobians)), (true, true), "{counts}");
            assert_eq!(has(Quantity::StateJacobians), has_states, "{counts}");
            assert_eq!(derived.series, Ok(()), "{counts}");
        }
    }
}

/// Of a scene with one body and one row, rows of rates stand behind those of the body and of the row.
#[test]
fn analytic_jacobians_by_states_are_those_of_forces_and_rates() {
    let model = resolved(
        "constraint upright: wheel.phi = 0; param f: 1/s = 3; state still: m = 0 rate 1 m/s; \
         state z: m = 0 rate wheel.vx - f*z + f*sin(wheel.y/(1 m))*still; force at wheel(0, 0): (0, z * 2 (N/m));",
    );
    let derived = Derived::new(&model, &model.scenes[0]);
    let Form::Straight(of) = &derived.form else { panic!("its bodies are known") };
    let jacobians = of.jacobians.as_ref().expect("they are short");
    let places = |entries: &[JacobianEntry]| entries.iter().map(|of| (of.row, of.column)).collect::<Vec<_>>();
    let of_rates =
        |entries: &[JacobianEntry]| places(entries).into_iter().filter(|(row, _)| *row >= 4).collect::<Vec<_>>();
    assert_eq!(places(&jacobians.by_z), [(1, 1), (5, 0), (5, 1)]);
    assert_eq!((of_rates(&jacobians.by_q), of_rates(&jacobians.by_v)), (vec![(5, 1)], vec![(5, 0)]));
    let motion = Motion { symbols: &of.equations.symbols, parameters: vec![3.0], inputs: &[0.5, 0.7], omega: 0.0 };
    let values: Vec<f64> =
        jacobians.by_z.iter().map(|of_z| of.equations.algebra.evaluate(of_z.value, &motion)).collect();
    assert_eq!(values, [2.0, 0.0, -3.0]);
}

/// Those of forces, of rates, and of what forces make of states, which vary within a step.
#[test]
fn analytic_functions_without_series_are_named() {
    let series = |items: &str| {
        let model = resolved(items);
        Derived::new(&model, &model.scenes[0]).series.err()
    };
    assert_eq!(series("torque wheel: abs(wheel.phi) * 2 (N*m);"), Some(Function::Abs));
    assert_eq!(series("state z = 0 rate 1 (1/s); torque wheel: abs(z) * 2 (N*m);"), Some(Function::Abs));
    assert_eq!(series("state z: m = 0 rate max(wheel.vx, 0);"), Some(Function::Max));
    assert_eq!(series("input u: m/s = 0; state z: m = 0 rate max(u, 0);"), None);
}
