//! Equations hold between quantities: what is printed has the names of the model file, without conversions of units.

use ezy_core::model::Formula;
use ezy_core::prelude::*;
use ezy_study::report::drawing;

/// Roundings of the conversions and of other orders of multiplication, over the run, relative to metres and radians.
const ROUNDED: f64 = 1e-12;

model! {
    /// A slider-crank in workshop units, whose crank is offset, with names for what its equations repeat.
    pub model Workshop {
        /// Crank.
        param r: mm = 120;
        /// Connecting rod.
        param l: cm = 35;
        /// Offset of the rail.
        param e: mm = 20;
        /// Incline of the rail.
        param tilt: deg = 15;
        param m: g = 800;
        param k: kN/m = 0.4;
        input push: kN = 0.01;
        let reach = sqrt((l + r)^2 - e^2);
        let half = -l/2;
        let ratio = r/(l + r);
        let u = (cos(tilt), sin(tilt));
        body crank { mass: 2*m, inertia: m*r^2/6 }
        body rod { mass: m, inertia: m*l^2/12 }
        body block { mass: m, inertia: m*r^2 }
        hinge shaft: ground(0, 0) ~ crank(-r/2, 0);
        hinge pin: crank(r/2, 0) ~ rod(half, 0);
        hinge wrist: rod(-half, 0) ~ block(0, 0);
        slider rail: ground(0, -e) ~ block(0, 0) along ground(cos(tilt), sin(tilt));
        spring ground(reach*cos(tilt), reach*sin(tilt)) ~ block(0, 0): stiffness k*ratio, length reach;
        force at block(0, 0): push*u;
        output stroke: mm = reach - block.x;
        output angle: deg = crank.phi - tilt;
        start turned { crank angle 30 deg; rod near angle -10 deg; crank rate 2; }
        scene run { start turned; until 0.1 s; }
    }
}

model! {
    /// The same in SI units and without names.
    pub model Plain {
        param r: m = 0.12;
        param l: m = 0.35;
        param e: m = 0.02;
        param tilt: rad = pi/12;
        param m: kg = 0.8;
        param k: N/m = 400;
        input push: N = 10;
        body crank { mass: 2*m, inertia: m*r^2/6 }
        body rod { mass: m, inertia: m*l^2/12 }
        body block { mass: m, inertia: m*r^2 }
        hinge shaft: ground(0, 0) ~ crank(-r/2, 0);
        hinge pin: crank(r/2, 0) ~ rod(-l/2, 0);
        hinge wrist: rod(l/2, 0) ~ block(0, 0);
        slider rail: ground(0, -e) ~ block(0, 0) along ground(cos(tilt), sin(tilt));
        spring ground(sqrt((l + r)^2 - e^2)*cos(tilt), sqrt((l + r)^2 - e^2)*sin(tilt)) ~ block(0, 0):
            stiffness k*r/(l + r), length sqrt((l + r)^2 - e^2);
        force at block(0, 0): push*(cos(tilt), sin(tilt));
        output stroke: m = sqrt((l + r)^2 - e^2) - block.x;
        output angle: rad = crank.phi - tilt;
        start turned { crank angle pi/6; rod near angle -pi/18; crank rate 2; }
        scene run { start turned; until 0.1 s; }
    }
}

fn formulas(scene: &dyn Scene) -> Vec<Formula> {
    let info = scene.info();
    let rows = info.rows.iter().flat_map(|row| [&row.constraint, &row.convective_term]);
    let outputs = info.outputs.iter().map(|output| &output.formula);
    let entries = info.jacobian_entries.iter().chain(info.mass_entries).chain(info.force_entries);
    let all = rows.chain(outputs).chain(entries).chain([&info.potential_energy]);
    all.chain(info.abbreviations.iter().map(|of| &of.formula)).copied().collect()
}

#[test]
fn invariant_no_formula_shows_a_conversion_of_units() {
    let all = formulas(&workshop::Run::default());
    assert!(all.len() > 60, "{}", all.len());
    for formula in all {
        for factor in ["1000", "0.001", "100", "180", "pi"] {
            assert!(!formula.text.contains(factor) && !formula.latex.contains(factor), "{}", formula.text);
        }
    }
}

#[test]
fn reference_names_of_the_model_file_stand_in_formulas_and_are_defined_once() {
    let info = workshop::Run::default().info();
    let texts = |of: &[Formula]| of.iter().map(|formula| formula.text).collect::<Vec<_>>();
    let row = |name: &str| info.rows.iter().find(|row| row.name == name).unwrap().constraint;
    let outputs: Vec<Formula> = info.outputs.iter().map(|output| output.formula).collect();
    assert_eq!(
        texts(&[row("shaft.x"), row("wrist.x")]),
        ["-crank.x + r*cos(crank.phi)/2", "rod.x - half*cos(rod.phi) - block.x",]
    );
    assert_eq!(
        row("wrist.x").latex,
        "x_{\\mathrm{rod}} - \\mathrm{half} \\, \\cos{\\varphi_{\\mathrm{rod}}} - x_{\\mathrm{block}}"
    );
    assert_eq!(texts(&outputs), ["reach - block.x", "-tilt + crank.phi"]);
    assert_eq!(info.potential_energy.text, "0.5*k*ratio*(reach - sqrt(w1))^2");
    let definitions: Vec<String> =
        info.abbreviations.iter().map(|of| format!("{} = {}", of.symbol.text, of.formula.text)).collect();
    assert_eq!(
        definitions,
        [
            "half = -l/2",
            "u.x = cos(tilt)",
            "u.y = sin(tilt)",
            "reach = sqrt((l + r)^2 - e^2)",
            "ratio = r/(l + r)",
            "w1 = (reach*u.x - block.x)^2 + (reach*u.y - block.y)^2",
        ]
    );
}

#[test]
fn reference_labels_of_the_sketch_are_names() {
    let scene = workshop::Run::default();
    let run = Simulation::new(&scene).until(0.0).run().unwrap();
    let svg = drawing::sketch(&scene, &run.last());
    for label in [">half<", ">r/2<", ">k\u{2009}ratio, reach<"] {
        assert!(svg.contains(label), "{label} in {svg}");
    }
}

#[test]
fn cross_units_and_names_leave_the_motion_as_it_is() {
    let (workshop, plain) = (workshop::Run::default(), plain::Run::default());
    let method = Method::rk4(1e-3);
    let [a, b] =
        [&workshop as &dyn Scene, &plain].map(|scene| Simulation::new(scene).method(method).outputs().run().unwrap());
    let (a, b) = (a.last(), b.last());
    assert!((a.get("crank.phi").unwrap() - b.get("crank.phi").unwrap()).abs() < ROUNDED);
    assert!((a.get("output.stroke").unwrap() / 1e3 - b.get("output.stroke").unwrap()).abs() < ROUNDED);
    assert!((a.get("output.angle").unwrap().to_radians() - b.get("output.angle").unwrap()).abs() < ROUNDED);
    assert!((b.get("crank.phi").unwrap() - std::f64::consts::PI / 6.0).abs() > 0.1, "it moves");
}

model! {
    /// A rod whose lengths have no names of their own, beside others in an array.
    pub model Lengths {
        count n = 3;
        param span: mm = 200;
        param overhang: cm = 4;
        param rise: mm = 30;
        param m: kg = 1;
        let reach = sqrt((span + overhang)^2 - rise^2)/2;
        for i in 0..n { body rod[i] { mass: m, inertia: m*reach^2/3 } }
        hinge first: ground(0, 0) ~ rod[0](-reach, 0);
        for i in 1..n { hinge pin[i]: rod[i-1](reach, 0) ~ rod[i](-reach, 0); }
        gravity (0, -9.81);
        start level { for i in 0..n { rod[i] angle 0; } at rest; }
        scene swing { start level; until 0.1 s; }
    }
}

model! {
    /// The same rod alone, its lengths written out.
    pub model WrittenOut {
        param span: mm = 200;
        param overhang: cm = 4;
        param rise: mm = 30;
        body rod { mass: 1, inertia: 0.01 }
        hinge first: ground(0, 0) ~ rod(-sqrt((span + overhang + rise)^2 - overhang^2 - rise^2 + span*overhang)/2, 0);
        spring ground(0.2, 0.1) ~ rod(sqrt((span + overhang + rise)^2 - overhang^2 - rise^2 + span*overhang)/2, 0):
            stiffness 1000*sqrt((span + overhang + rise)^2 - overhang^2 - rise^2 + span*overhang)/(span + overhang);
        gravity (0, -9.81);
        start level { rod angle 0; at rest; }
        scene swing { start level; until 0.1 s; }
    }
}

#[test]
fn reference_names_are_kept_in_scenes_with_counts() {
    let info = lengths::Swing::default().info();
    let equations =
        info.equations.iter().chain(info.repeats.iter().flat_map(|of| of.templates).flat_map(|of| of.equations));
    let text: String = equations.map(|equation| equation.text).collect();
    assert_eq!(text.matches("reach = sqrt((span + overhang)^2 - rise^2)/2").count(), 1, "{text}");
    assert_eq!(text.matches("sqrt").count(), 1, "{text}");
    for part in ["rod[i-1].x + reach*cos(rod[i-1].phi)", "m*reach^2/3"] {
        assert!(text.contains(part), "{part} in {text}");
    }
}

#[test]
fn invariant_long_labels_leave_the_mechanism_most_of_the_sheet() {
    let scene = written_out::Swing::default();
    let run = Simulation::new(&scene).until(0.0).run().unwrap();
    let svg = drawing::sketch(&scene, &run.last());
    let width: f64 = svg.split_once(" width=\"").unwrap().1.split_once('"').unwrap().0.parse().unwrap();
    assert!(560.0 / width > 0.7, "560 of {width}");
}
