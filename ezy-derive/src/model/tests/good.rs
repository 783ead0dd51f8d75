//! Texts without faults.

use super::{EZY_ROLLER, good};
use crate::model::constant::{at_defaults, literal};
use crate::model::{Component, Expr, InputId, Model, Operator, StartValue};
use std::f64::consts::PI;

/// A body, parameters and values, and a torque whose value is looked at.
fn with_torque(items: &str, torque: &str) -> Model {
    good(&format!(
        "pub model M {{ body seat {{ mass: 1, inertia: 1 }} point A = seat(1, 2); {items}
         torque seat: {torque}; start s {{ }} scene c {{ start s; until 1 s; }} }}"
    ))
}

fn torque(model: &Model) -> &Expr {
    &model.forces[0].arguments.scalars[0]
}

/// Declared parameters in SI units.
fn defaults(model: &Model) -> Vec<f64> {
    model.parameters.iter().map(|parameter| parameter.size.to_si(parameter.default)).collect()
}

/// The value of a torque with the declared parameters.
fn value(items: &str, torque_value: &str) -> f64 {
    let model = with_torque(items, torque_value);
    at_defaults(torque(&model), &defaults(&model)).expect("the value does not move")
}

#[test]
fn analytic_model_of_ezy_roller_has_every_item() {
    let model = good(EZY_ROLLER);
    let counts = [model.bodies.len(), model.parameters.len(), model.points.len(), model.rows.len()];
    assert_eq!(counts, [2, 11, 3, 3]);
    let counts = [model.forces.len(), model.effects.len(), model.starts.len(), model.scenes.len()];
    assert_eq!(counts, [2, 2, 2, 3]);
}

#[test]
fn analytic_parameter_keeps_unit_text_and_documentation() {
    let model = good(EZY_ROLLER);
    let a = &model.parameters[0];
    assert_eq!((a.unit.as_str(), a.default_text.as_str()), ("m", "0.2"));
    assert_eq!(a.documentation, "rear axle A, behind the seat's centre of mass");
    let omega = &model.parameters[9];
    assert_eq!((omega.unit.as_str(), omega.default_text.as_str()), ("rad/s", "pi"));
    assert_eq!(omega.effect.map(|id| id.0), Some(0));
}

#[test]
fn analytic_parameter_is_the_nearest_number() {
    let model = good(EZY_ROLLER);
    let values: Vec<f64> = model.parameters.iter().map(|parameter| parameter.default).collect();
    assert_eq!(values, [0.2, 0.6, 0.1, 0.1, 46.0, 10.0, 1.0, 0.005, 2.0, PI, 0.5]);
}

#[test]
fn analytic_hinge_is_a_point_on_its_first_body() {
    let model = good(EZY_ROLLER);
    let names: Vec<String> = model.points.iter().map(|point| point.name.to_string()).collect();
    assert_eq!(names, ["A", "C", "B"]);
    assert_eq!(model.points[2].place.body, model.rows[0].arguments.places[0].body);
}

#[test]
fn analytic_start_gives_what_it_says() {
    let model = good(EZY_ROLLER);
    let given: Vec<(usize, Component, bool)> =
        model.starts[0].values.iter().map(|value| (value.body.0, value.component, value.rate)).collect();
    let (x, y, phi) = (Component::X, Component::Y, Component::Phi);
    assert_eq!(given, [(0, x, false), (0, y, false), (0, phi, false), (1, phi, false)]);
}

#[test]
fn analytic_start_takes_vectors_from_expressions() {
    let given = |seat: &str| {
        let items = format!("param v: m/s = 2; param a: deg = 30; start more {{ seat {seat}; }}");
        let model = with_torque(&items, "0");
        let start = model.starts.iter().find(|start| start.name == "more").expect("the start");
        let defaults = defaults(&model);
        let value =
            |value: &StartValue| (value.component, value.rate, at_defaults(&value.value, &defaults).expect("a number"));
        start.values.iter().map(value).collect::<Vec<_>>()
    };
    for (vector, pair) in [
        ("velocity v * (3, -1)", "velocity (3 * v, -v)"),
        ("velocity (3, -1) * v rate 2", "velocity (3 * v, -v) rate 2"),
        ("at -(1, 2) + (0, 4 mm)", "at (-1, -1.996)"),
        ("at (1, 2) velocity -(1, 0) * v", "at (1, 2) velocity (-v, 0)"),
    ] {
        assert_eq!(given(vector), given(pair), "{vector}");
    }
}

#[test]
fn analytic_scene_selects_start_end_and_effects() {
    let model = good(EZY_ROLLER);
    let scenes: Vec<(usize, f64, usize)> =
        model.scenes.iter().map(|scene| (scene.start.0, scene.until_s, scene.effects.len())).collect();
    assert_eq!(scenes, [(1, 1.0, 0), (0, 60.0, 1), (0, 60.0, 2)]);
    assert_eq!(model.scenes[2].documentation, "Both effects together.");
}

#[test]
fn analytic_operators_bind_as_in_mathematics() {
    assert_eq!(value("", "1 - 2 - 3"), -4.0);
    assert_eq!(value("", "2 + 3 * 4 / 6"), 4.0);
    assert_eq!(value("", "-2^2"), -4.0);
    assert_eq!(value("", "2^3^2"), 512.0);
    assert_eq!(value("", "2^-1 * 8"), 4.0);
    assert_eq!(value("", "--3 * -(1 + 1)"), -6.0);
}

#[test]
fn analytic_functions_have_their_values() {
    assert_eq!(value("", "1 * atan2(1, 0) + sqrt(4) + abs(-3)"), PI / 2.0 + 2.0 + 3.0);
    assert_eq!(value("", "min(1, 2) + max(1, 2) + sign(-5)"), 2.0);
    assert_eq!(value("", "dot((1, 2), (3, 4)) + cross((1, 2), (3, 4)) + norm((3, 4))"), 11.0 - 2.0 + 5.0);
}

#[test]
fn analytic_smooth_step_is_its_polynomial_between_zero_and_one() {
    assert_eq!(value("", "smooth_step(3, 1, 2) + 10 * smooth_step(0, 1, 2)"), 1.0);
    // s = 1/4: s³ (10 − 15 s + 6 s²)
    assert_eq!(value("", "smooth_step(1.25, 1, 2) * 512"), 53.0);
}

#[test]
fn analytic_vectors_split_into_components() {
    assert_eq!(value("let u = 2 * (1, 2) - (1, 1) / 2;", "dot(u, (1, 10))"), 1.5 + 35.0);
}

#[test]
fn analytic_units_count_in_si() {
    assert_eq!(value("param l: mm = 200;", "1 * l"), 0.2);
    assert_eq!(value("param f: kN*cm = 3;", "1 * f"), 30.0);
    assert_eq!(value("param angle: deg = 90;", "1 * angle"), PI / 2.0);
    assert_eq!(value("param j: g*cm^2 = -20;", "-1 * j"), 2e-6);
    assert_eq!(value("param w: (1/min)^2 = 7200;", "1 * w"), 2.0);
}

#[test]
fn analytic_numbers_take_units() {
    for (written, si) in [
        ("200 mm / (1 m)", 0.2),
        ("90 deg", PI / 2.0),
        ("-3 kN*cm", -30.0),
        ("20 (g*cm^2) * 1e6", 2.0),
        ("36 km/h", 10.0),
        ("2 m^2 / 4 s", 0.5),
        ("7200 (1/min^2)", 2.0),
        ("5 s^-1", 5.0),
    ] {
        // a factor without unit makes it a value of any unit
        assert_eq!(value("", &format!("1 * ({written})")), si, "{written}");
    }
    // brackets end a unit where a name follows that is a value, too
    assert_eq!(value("param m: m = 3;", "2 (N) * m"), 6.0);
    assert_eq!(value("param l: m = 2;", "3 * l * 4 mm"), 0.024);
}

#[test]
fn analytic_si_units_leave_no_operation() {
    let model = with_torque("param f: kg*m^2/s^2 = 3;", "f");
    assert!(matches!(torque(&model), Expr::Parameter(_)));
}

#[test]
fn analytic_values_are_inserted_in_any_order() {
    assert_eq!(value("let b = a + 1; let a = 2 * k; param k = 3;", "b"), 7.0);
}

#[test]
fn analytic_words_of_the_language_are_names_elsewhere() {
    good(
        "pub model Words { param mass = 1; param rest = 2; param along = 3;
         body body { mass: mass, inertia: mass } body at { mass: 1, inertia: 1 }
         point point = body(along, 0); hinge hinge: point ~ at(0, 0);
         skate start: at hinge along at(1, 0); effect effect { force at point: (rest, 0); }
         start scene { at at (0, 0) angle rest; body rate 0; at rest; }
         scene until { start scene; until 1 s; with effect; } }",
    );
}

#[test]
fn analytic_members_are_coordinates_and_velocities() {
    let moving = [("seat.omega", "Velocity(BodyId(0), Phi)"), ("A.y", "PointPosition(PointId(0), Y)"), ("t", "Time")];
    for (text, expected) in moving {
        let model = with_torque("", &format!("2 * {text}"));
        assert_eq!(format!("{:?}", torque(&model)), format!("Binary(Multiply, Number(2.0), {expected})"));
    }
}

#[test]
fn analytic_bare_numbers_may_stand_for_anything() {
    for text in ["cos(3 * t)", "cos(t)", "2 * seat.omega", "sign(seat.x) * 3 + 1", "1 + 2 * A.x", "0"] {
        with_torque("", text);
    }
}

#[test]
fn analytic_known_units_agree_in_a_spring() {
    let items = "param k: N/m = 3; param l: m = 1; param c: N*s/m = 1; param m: kg = 1; param e: J = 2;";
    with_torque(items, "A.x * (k * (l - A.y) - c * A.vy) * cos(seat.phi) + norm(A.v)^2 * m - sqrt(e * e) / exp(2)");
}

#[test]
fn analytic_input_keeps_unit_text_and_effect() {
    let items = "/// what the rider does\n input u: N*cm = 3*2; effect push { input f: N = -1; }";
    let model = with_torque(items, "u");
    let [u, f] = &model.inputs[..] else { panic!("two inputs") };
    assert_eq!((u.unit.as_str(), u.default, u.default_text.as_str()), ("N*cm", 6.0, "3*2"));
    assert_eq!((u.documentation.as_str(), u.effect), ("what the rider does", None));
    assert_eq!((f.default, f.effect.map(|id| id.0)), (-1.0, Some(0)));
    let Expr::Binary(Operator::Multiply, input, conversion) = torque(&model) else { panic!("{:?}", torque(&model)) };
    assert!(matches!(**input, Expr::Input(InputId(0))) && literal(conversion) == Some(0.01));
}

#[test]
fn analytic_state_keeps_unit_start_rate_and_effect() {
    let items = "/// of the armature\n state i: mA = 3*2 rate j - 1 mA/s; let j = seat.omega * i; \
                 effect push { state f = -1 rate f; } input u = 2;";
    let model = with_torque(items, "i * 2 (N*m/A)");
    let [i, u, f] = &model.inputs[..] else { panic!("two states and an input") };
    assert_eq!((i.unit.as_str(), i.default, i.default_text.as_str()), ("mA", 6.0, "3*2"));
    assert_eq!((i.documentation.as_str(), i.effect), ("of the armature", None));
    assert_eq!((f.default, f.effect.map(|id| id.0)), (-1.0, Some(0)));
    assert!(matches!(f.rate, Some(Expr::State(InputId(2)))) && u.rate.is_none());
    let Some(Expr::Binary(Operator::Multiply, _, conversion)) = &i.rate else { panic!("{:?}", i.rate) };
    assert_eq!(literal(conversion), Some(1000.0));
}

#[test]
fn analytic_outputs_are_scalars_in_their_units() {
    let items = "output place: mm = (A.x, 2); output angle: deg = 1 * seat.phi; output any = t;
         effect watch { output speed = seat.vx; }";
    let model = with_torque(items, "1");
    let in_unit = |value: &Expr| match value {
        Expr::Binary(Operator::Multiply, value, conversion) if matches!(**conversion, Expr::Conversion(_)) => {
            format!("{value:?} times {}", literal(conversion).unwrap_or(f64::NAN))
        }
        value => format!("{value:?}"),
    };
    let outputs: Vec<String> =
        model.outputs.iter().map(|o| format!("{}{} [{}] {}", o.name, o.suffix, o.unit, in_unit(&o.value))).collect();
    assert_eq!(
        outputs,
        [
            "place.x [mm] PointPosition(PointId(0), X) times 1000",
            "place.y [mm] Number(2.0) times 1000",
            "angle [deg] Binary(Multiply, Number(1.0), Coordinate(BodyId(0), Phi)) times 57.29577951308232",
            "any [] Time",
            "speed [] Velocity(BodyId(0), X)",
        ]
    );
    assert_eq!(model.outputs[4].effect.map(|id| id.0), Some(0));
}

#[test]
fn analytic_range_of_a_for_may_begin_at_a_count() {
    good(
        "pub model M { count n = 2; count m = 5; body b[m] { mass: 1, inertia: 1 }
         for i in n..m { torque b[i]: 1; } start s { } scene c { start s; until 1 s; } }",
    );
}
