//! Arrays whose members differ, against models in which each body is written by hand, and against closed forms.

use crate::scenes::{assert_checks, distance};
use ezy_core::dynamics::SystemError;
use ezy_core::model::Equations;
use ezy_core::prelude::*;
use ezy_core::scalar::{DoubleDouble, Dual, Scalar};
use ezy_core_tests::{simulation, system_of};
use ezy_study::report::drawing::Elements;

model! {
    /// A chain that becomes thinner: link i has the part 1 - i/(2 n) of the length and of the mass of the first one.
    model Tapered {
        count n = 5;
        param l: m = 0.5;
        param m0: kg = 2.0;
        param k: N*m = 0.7;
        param f: N = 0.3;
        param g: m/s^2 = 9.81;

        for i in 0..n {
            body link[i] { mass: m0 * (1 - i/(2*n)), inertia: m0 * (1 - i/(2*n))^3 * l^2/12 }
            point head[i] = link[i](-l*(1 - i/(2*n))/2, 0);
            point tail[i] = link[i](l*(1 - i/(2*n))/2, 0);
        }
        hinge top: ground(0, 0) ~ head[0];
        for i in 1..n {
            hinge pin[i]: tail[i-1] ~ head[i];
            torsion link[i-1] ~ link[i]: stiffness k/(1 + i)^2, damping 0.01*sqrt(i);
            output bend[i]: deg = (1 + i) * pin[i].angle;
        }
        gravity (0, -g);
        output middle: m = tail[n/2].y;
        effect wind { for i in 0..n { force at tail[i]: (f*(1 - i/n)*cos(t), 0); } }

        start swung { for i in 0..n { link[i] angle 0.1*i rate 0.2*(n - i)/n; } }
        start hung { for i in 0..n { link[i] angle -pi/2; } at rest; }
        scene swing { start swung; until 0.5 s; with wind; }
        scene free { start swung; until 0.5 s; }
        scene hang { start hung; until 0.1 s; }
    }
}

model! {
    /// The same with five bodies.
    model FiveLinks {
        param l: m = 0.5;
        param m0: kg = 2.0;
        param k: N*m = 0.7;
        param f: N = 0.3;
        param g: m/s^2 = 9.81;

        body link0 { mass: m0, inertia: m0*l^2/12 }
        body link1 { mass: 0.9*m0, inertia: 0.9^3*m0*l^2/12 }
        body link2 { mass: 0.8*m0, inertia: 0.8^3*m0*l^2/12 }
        body link3 { mass: 0.7*m0, inertia: 0.7^3*m0*l^2/12 }
        body link4 { mass: 0.6*m0, inertia: 0.6^3*m0*l^2/12 }
        hinge top: ground(0, 0) ~ link0(-l/2, 0);
        hinge pin1: link0(l/2, 0) ~ link1(-0.9*l/2, 0);
        hinge pin2: link1(0.9*l/2, 0) ~ link2(-0.8*l/2, 0);
        hinge pin3: link2(0.8*l/2, 0) ~ link3(-0.7*l/2, 0);
        hinge pin4: link3(0.7*l/2, 0) ~ link4(-0.6*l/2, 0);
        torsion link0 ~ link1: stiffness k/4, damping 0.01;
        torsion link1 ~ link2: stiffness k/9, damping 0.01*sqrt(2);
        torsion link2 ~ link3: stiffness k/16, damping 0.01*sqrt(3);
        torsion link3 ~ link4: stiffness k/25, damping 0.02;
        gravity (0, -g);
        output bend1: deg = 2*pin1.angle;
        output bend2: deg = 3*pin2.angle;
        output bend3: deg = 4*pin3.angle;
        output bend4: deg = 5*pin4.angle;
        output middle: m = link2.y + 0.4*l*sin(link2.phi);
        effect wind {
            force at link0(l/2, 0): (f*cos(t), 0);
            force at link1(0.9*l/2, 0): (0.8*f*cos(t), 0);
            force at link2(0.8*l/2, 0): (0.6*f*cos(t), 0);
            force at link3(0.7*l/2, 0): (0.4*f*cos(t), 0);
            force at link4(0.6*l/2, 0): (0.2*f*cos(t), 0);
        }
        start swung {
            link0 angle 0 rate 0.2;
            link1 angle 0.1 rate 0.16;
            link2 angle 0.2 rate 0.12;
            link3 angle 0.3 rate 0.08;
            link4 angle 0.4 rate 0.04;
        }
        scene swing { start swung; until 0.5 s; with wind; }
    }
}

model! {
    /// Trailers of unequal lengths, masses and wheels.
    model Train {
        count n = 3;
        param c: m = 0.2;
        param l: m = 0.9;
        param m: kg = 2.0;
        param i: kg*m^2 = 0.3;
        body tractor { mass: 6, inertia: 0.9 }
        for k in 0..n {
            body trailer[k] { mass: m*(1 - k/4), inertia: i*(1 - k/4)^3 }
            skate axle[k]: at trailer[k](0.05*k, 0) along trailer[k](1, 0.01*k);
            drag at trailer[k](0, 0): linear 0.1*(k + 1);
        }
        hinge hitch: tractor(-0.6, 0) ~ trailer[0](l, 0);
        for k in 1..n { hinge coupling[k]: trailer[k-1](-c*(1 - (k-1)/4), 0) ~ trailer[k](l*(1 - k/4), 0); }
        skate rear_axle: at tractor(-0.4, 0) along tractor(1, 0);
        force at tractor(0, 0) along tractor(1, 0): 3;
        torque tractor: 0.4*cos(t);
        start straight {
            tractor at (0, 0) angle 0 velocity (2, _);
            for k in 0..n { trailer[k] near angle 0.1*(k + 1); }
        }
        scene winding { start straight; until 1 s; }
    }
}

model! {
    /// The same with three trailers.
    model ThreeTrailers {
        param c: m = 0.2;
        param l: m = 0.9;
        param m: kg = 2.0;
        param i: kg*m^2 = 0.3;
        body tractor { mass: 6, inertia: 0.9 }
        body first { mass: m, inertia: i }
        body second { mass: 0.75*m, inertia: 0.75^3*i }
        body third { mass: 0.5*m, inertia: 0.5^3*i }
        skate axle0: at first(0, 0) along first(1, 0);
        skate axle1: at second(0.05, 0) along second(1, 0.01);
        skate axle2: at third(0.1, 0) along third(1, 0.02);
        drag at first(0, 0): linear 0.1;
        drag at second(0, 0): linear 0.2;
        drag at third(0, 0): linear 0.3;
        hinge hitch: tractor(-0.6, 0) ~ first(l, 0);
        hinge coupling1: first(-c, 0) ~ second(0.75*l, 0);
        hinge coupling2: second(-0.75*c, 0) ~ third(0.5*l, 0);
        skate rear_axle: at tractor(-0.4, 0) along tractor(1, 0);
        force at tractor(0, 0) along tractor(1, 0): 3;
        torque tractor: 0.4*cos(t);
        start straight {
            tractor at (0, 0) angle 0 velocity (2, _);
            first near angle 0.1;
            second near angle 0.2;
            third near angle 0.3;
        }
        scene winding { start straight; until 1 s; }
    }
}

model! {
    /// A grid without counts, with a range that depends on an index, and gravity by index.
    model Grid {
        param a = 0.1;
        body hub { mass: 1, inertia: 1 }
        for i in 0..2 { for j in 0..3 {
            body node[i, j] { mass: 1 + i + 10*j, inertia: (1 + i)/(1 + j)^2 }
            spring ground(i, j) ~ node[i, j](a*i, 0.2*sin(1 + j)): stiffness 10*(1 + i), length a*j, damping 0.1*(j + 1);
        } }
        for i in 0..2 { for j in 0..i+1 {
            hinge h[i, j]: hub(0.3*i, 0.2*(i + j)/(1 + j)) ~ node[i, j](0.01*i*j, 0.1/(1 + i));
        } }
        for i in 0..2 { for j in 1..3 { drag at node[i, j](a/j, 0): linear 0.1*i; } }
        for i in 0..2 { gravity (0, -1 - i/2); }
        start s { for i in 0..2 { for j in 0..3 { node[i, j] near at (i/3, j + 0.1); } } }
        scene run { start s; until 0.1 s; }
    }
}

model! {
    /// Masses 1, 0 and 2: the chain of `torture.json` whose middle link is massless.
    model MasslessMiddle {
        param low = 0;
        for i in 0..3 { body link[i] { mass: (i - 1)*(3*i - 2)/2 + low*i, inertia: 0.1*(i - 1)*(3*i - 2)/2 } }
        hinge A: ground(0, 0) ~ link[0](-0.5, 0);
        for i in 1..3 { hinge B[i]: link[i-1](0.25 + 0.25*(i - 2)^2, 0) ~ link[i](-0.25*i, 0); }
        gravity (0, -9.81);
        start bent { for i in 0..3 { link[i] angle 0.2 - 1.35*i + 0.75*i^2; } at rest; }
        scene swing { start bent; until 1 s; }
    }
}

/// Rounding of states of 1 over some hundred steps.
const ROUNDING: f64 = 1e-12;

fn methods() -> [Method; 5] {
    [Method::rk4(2e-3), Method::dop853(1e-13), Method::taylor(1e-13), Method::gauss(1e-13), Method::radau(1e-9)]
}

/// Both routes take the same steps, so that they differ by rounding alone; but where bodies are written by hand, `gauss` and `dop853` solve for
/// quasi-velocities, and differ by their tolerance, too.
fn assert_equal(by_index: &dyn Scene, by_hand: &dyn Scene) {
    for method in methods() {
        let [x, y] = [by_index, by_hand].map(|scene| simulation(scene).method(method).outputs().run().unwrap());
        for (x, y) in [(x.first(), y.first()), (x.last(), y.last())] {
            let error = distance(x.coordinates, y.coordinates).max(distance(x.velocities, y.velocities));
            let error = error.max(distance(x.multipliers, y.multipliers) / 20.0);
            let error = error.max(distance(x.outputs, y.outputs) / 60.0);
            let error = error.max((x.energy.balance - y.energy.balance).abs());
            assert!(error <= ROUNDING, "{}: {error:.1e} at {} s", method.name(), x.t);
        }
    }
}

#[test]
fn cross_tapered_chain_is_that_of_five_written_bodies() {
    assert_equal(&tapered::Swing::default(), &five_links::Swing::default());
}

#[test]
fn cross_unequal_trailers_are_those_written_by_hand() {
    assert_equal(&train::Winding::default(), &three_trailers::Winding::default());
}

#[test]
fn fd_members_that_differ_pass_the_checks_at_several_counts() {
    for n in [1, 2, 4] {
        assert_checks(&tapered::Swing { n, ..Default::default() });
        assert_checks(&train::Winding { n, ..Default::default() });
    }
    assert_checks(&grid::Run::default());
}

/// The mass of link i, and the centres of a chain that hangs.
fn masses(n: usize, m0: f64) -> Vec<f64> {
    (0..n).map(|i| m0 * (1.0 - i as f64 / (2 * n) as f64)).collect()
}

#[test]
fn analytic_mass_matrix_and_energies_of_a_tapered_chain() {
    for n in [1, 4, 33] {
        let scene = tapered::Free { n, m0: 3.0, ..Default::default() };
        let system = system_of(&scene, Backend::Auto).unwrap();
        let mass = system.mass_matrix();
        let expected = masses(n, 3.0);
        let part = |i: usize| expected[i] / 3.0;
        let (mut kinetic, mut potential) = (0.0, 0.0);
        let run = simulation(&scene).until(0.0).run().unwrap();
        let first = run.first();
        for (i, m) in expected.iter().enumerate() {
            let inertia = 3.0 * part(i).powi(3) * 0.25 / 12.0;
            let error = distance(&mass[3 * i..3 * i + 3], &[*m, *m, inertia]);
            assert!(error <= 2.0 * f64::EPSILON * m, "link[{i}] of {n}: {error:.1e}");
            let (q, v) = (&first.coordinates[3 * i..], &first.velocities[3 * i..]);
            kinetic += 0.5 * (m * (v[0] * v[0] + v[1] * v[1]) + inertia * v[2] * v[2]);
            potential += m * 9.81 * q[1];
            if i > 0 {
                let bend = q[2] - first.coordinates[3 * i - 1];
                potential += 0.5 * 0.7 / ((1 + i) as f64).powi(2) * bend * bend;
            }
        }
        let size = kinetic.abs().max(potential.abs());
        assert!((first.energy.kinetic - kinetic).abs() <= ROUNDING * size, "{n} links");
        assert!((first.energy.potential - potential).abs() <= ROUNDING * size, "{n} links");
    }
}

/// λ of a hinge is the force that pulls its second body: the weight of all below.
#[test]
fn analytic_hinges_of_a_hanging_chain_carry_the_weight_below() {
    for n in [2, 33] {
        let run = simulation(&tapered::Hang { n, ..Default::default() }).until(0.0).run().unwrap();
        let first = run.first();
        let weights = masses(n, 2.0).into_iter().map(|m| 9.81 * m);
        let weights: Vec<f64> = weights.collect();
        let total: f64 = weights.iter().sum();
        assert!(distance(first.accelerations, &vec![0.0; 3 * n]) <= ROUNDING * total);
        for i in 0..n {
            let below: f64 = weights[i..].iter().sum();
            let name = if i == 0 { "lambda.top.y".to_owned() } else { format!("lambda.pin[{i}].y") };
            let error = (first.get(&name).unwrap() - below).abs();
            assert!(error <= ROUNDING * total, "{name}: {error:.1e} N");
        }
    }
}

/// The mass matrix in any number.
fn mass_matrix<T: Scalar>(scene: &tapered::Swing, parameters: &[T]) -> Vec<T> {
    let info = scene.info();
    let mut c = vec![T::from_f64(0.0); info.n_fixed()];
    Equations::<T>::constants(scene, parameters, &mut c);
    let mut m = vec![T::from_f64(0.0); info.n_coordinates()];
    Equations::<T>::mass_matrix(scene, &c, &mut m);
    m
}

#[test]
fn fd_masses_by_index_have_derivatives_by_parameters() {
    let scene = tapered::Swing { n: 4, ..Default::default() };
    let place = scene.info().parameters.iter().position(|parameter| parameter.name == "m0").unwrap();
    let values = scene.parameters();
    let dual = |(i, value): (usize, &f64)| Dual::<1>::variable(*value, if i == place { 0 } else { 1 });
    let dual: Vec<Dual<1>> = values.iter().enumerate().map(dual).collect();
    let [low, high] =
        [1.5, 2.5].map(|m0| mass_matrix(&tapered::Swing { m0, ..scene }, &tapered::Swing { m0, ..scene }.parameters()));
    for (i, m) in mass_matrix(&scene, &dual).iter().enumerate() {
        // masses are linear in m0
        assert!((m.derivatives[0] - (high[i] - low[i])).abs() <= 2.0 * f64::EPSILON, "{i}: {:?}", m.derivatives);
    }
}

#[test]
fn analytic_masses_by_index_have_the_digits_of_their_numbers() {
    let scene = tapered::Swing::default();
    let parameters: Vec<DoubleDouble> = scene.parameters().into_iter().map(DoubleDouble::from).collect();
    let number = |x: usize| DoubleDouble::from(x as f64);
    for (i, m) in mass_matrix(&scene, &parameters).iter().step_by(3).enumerate() {
        let expected = number(2) * (number(1) - number(i) / number(10));
        assert!((*m - expected).magnitude() <= 1e-30, "link[{i}]");
    }
}

/// Constants of a link that are computed once: mass, inertia, their inverses, half length, and what its rows make of them.
const MOST_OF_A_LINK: usize = 40;

#[test]
fn analytic_constants_of_members_grow_with_their_number_alone() {
    let n_constants = |n| tapered::Swing { n, ..Default::default() }.info().n_constants;
    let of_a_link = n_constants(11) - n_constants(10);
    assert_eq!(n_constants(1010) - n_constants(10), 1000 * of_a_link);
    assert!(of_a_link < MOST_OF_A_LINK, "{of_a_link}");
}

#[test]
fn invariant_member_with_a_negative_mass_is_named() {
    let scene = tapered::Swing { n: 9, m0: -1.0, ..Default::default() };
    let error = system_of(&scene, Backend::Auto).err().unwrap();
    assert!(matches!(&error, SystemError::Mass { body, .. } if body == "link[0]"), "{error}");
    let error = system_of(&massless_middle::Swing { low: -1.0 }, Backend::Auto).err().unwrap();
    assert_eq!(error.to_string(), "the mass of body `link[1]` is -1; it must be finite and not negative");
}

#[test]
fn reference_chain_whose_middle_member_is_massless() {
    let scene = massless_middle::Swing::default();
    let error = system_of(&scene, Backend::Sparse).err().unwrap().to_string();
    assert!(error.starts_with("the mass of body `link[1]` is zero"), "{error}");
    // as in `massless_links`
    let angles = [-2.21710469106001, -2.2836681596165405, -1.734867634988195];
    for method in [Method::dop853(1e-11), Method::taylor(1e-12), Method::gauss(1e-12), Method::radau(1e-12)] {
        let run = simulation(&scene).method(method).run().unwrap();
        let found: Vec<f64> = run.last().coordinates.iter().skip(2).step_by(3).copied().collect();
        assert!(distance(&found, &angles) <= 1e-9, "{}: {found:?}", method.name());
    }
}

#[test]
fn analytic_equations_are_printed_with_the_index() {
    let info = tapered::Swing::default().info();
    let templates = info.repeats.as_ref().unwrap().templates;
    let text = |title: &str, name: &str| {
        let template = templates.iter().find(|template| template.title == title).unwrap();
        template.equations.iter().find(|equation| equation.name == name).unwrap().text
    };
    assert!(text("body link, i in 0..n", "mass matrix").contains("[ (1 - i/(2*n))^3*m0*l^2/12 ]   link[i].phi"));
    let potential = text("gravity, i in 0..n", "potential energy");
    assert_eq!(potential, "V = (1 - i/(2*n))*m0*g*link[i].y\n");
    let middle = info.outputs.iter().find(|output| output.name == "middle").unwrap().formula.text;
    assert_eq!(middle, "link[n/2].y + (1 - floor(n/2)/(2*n))*l*sin(link[n/2].phi)/2");
}

/// A picture draws a body without points as a disc of its radius of gyration.
#[test]
fn analytic_pictures_have_the_masses_of_each_member() {
    let scene = grid::Run::default();
    let elements = Elements::new(&scene);
    let info = scene.info();
    for (body, name) in info.bodies.iter().enumerate().skip(1) {
        let [i, j] = [(body - 1) / 3, (body - 1) % 3].map(|index| index as f64);
        assert_eq!(*name, format!("node[{i},{j}]"));
        assert_eq!(
            elements.mass()[3 * body..3 * body + 3],
            [1.0 + i + 10.0 * j, 1.0 + i + 10.0 * j, (1.0 + i) / (1.0 + j).powi(2)]
        );
    }
}

/// In a picture of a member the index has no meaning.
#[test]
fn invariant_names_of_lengths_in_pictures_have_no_index() {
    let of = |scene: &dyn Scene, name: &str| {
        let all = scene.elements();
        let element = all.iter().find(|element| element.name == name).unwrap();
        element.points[0].text
    };
    assert_eq!(of(&tapered::Swing::default(), "tail[1]"), ["", "0"]);
    assert_eq!(of(&tapered::Swing::default(), "pin[1]"), ["", "0"]);
    assert_eq!(of(&massless_middle::Swing::default(), "A"), ["0", "0"]);
    assert_eq!(of(&three_trailers::Winding::default(), "coupling1"), ["-c", "0"]);
}
