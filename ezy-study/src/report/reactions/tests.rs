//! Reactions and powers against closed forms, and powers by a second route.

use super::*;
use ezy_core::integrate::Method;
use ezy_core::model::Scene;
use ezy_core::simulate::{Run, Simulation};
use std::f64::consts::PI;

ezy_core::model! {
    /// A point mass of 2 kg on an arm of 0.5 m, let go from 90° beside the lowest point.
    model Swing {
        param g: m/s^2 = 10;
        body bob { mass: 2, inertia: 0 }
        hinge pin: ground(0, 0) ~ bob(-0.5, 0);
        gravity (0, -g);
        start level { bob angle 0; at rest; }
        scene swings { start level; until 2 s; }
    }
}

ezy_core::model! {
    /// A crank that is turned with a rate that pulsates, against a damper and its weight.
    model Crank {
        param c: N*m*s/rad = 0.7;
        body arm { mass: 2, inertia: 0.4 }
        hinge pin: arm(-0.3, 0) ~ ground(0, 0);
        drive motor: arm.phi = 2*t + 0.3*sin(3*t);
        effect friction { torque arm: -c * arm.omega; }
        gravity (0, -9.81);
        start here { arm angle 0; }
        scene turns { start here; until 2 s; with friction; }
    }
}

ezy_core::model! {
    /// A puck between rails: a slider, a weld and a skate are rows of one and of several.
    model Rows {
        body cart { mass: 1, inertia: 1 }
        body plate { mass: 1, inertia: 1 }
        slider rail: ground(0, 0) ~ cart(0, 0) along ground(1, 0);
        weld glue: cart(0, 0.2) ~ plate(0, 0);
        start here { cart at (0, 0) angle 0; }
        scene rests { start here; until 1 s; }
    }
}

ezy_core::model! {
    /// A pendulum with a torsion spring and dry friction.
    model Spring {
        body bob { mass: 2, inertia: 0.1 }
        hinge pin: ground(0, 0) ~ bob(-0.5, 0);
        gravity (0, -10);
        torsion ground ~ bob: stiffness 6, angle -0.2;
        effect rub { friction ground ~ bob: torque 0.8, rate 0.5; }
        start level { bob angle 0; at rest; }
        scene swings { start level; until 2 s; with rub; }
    }
}

ezy_core::model! {
    /// A puck on a skate that slides across when a force that grows passes its limit.
    model Puck {
        param growth: N/s = 2;
        body puck { mass: 1, inertia: 1 }
        constraint level: puck.phi = 0;
        skate edge: at puck(0, 0) along puck(1, 0) limit 1;
        force at puck(0, 0): (0, growth*t);
        start here { puck at (0, 0) angle 0; at rest; }
        scene slips { start here; until 2 s; }
    }
}

/// Relative tolerance of the runs.
const RTOL: f64 = 1e-11;
/// Errors of steps add up, and reactions are second derivatives: a hundred tolerances.
const RUN: f64 = 100.0 * RTOL;

/// The first run with samples, its reactions, and their refinement.
fn found(scene: &dyn Scene, every_s: f64) -> (Run, Reactions, Reactions) {
    let simulation = || Simulation::new(scene).method(Method::dop853(RTOL)).work().power();
    let run = simulation().every(every_s).run().unwrap();
    let sampled = Reactions::of(&run.samples().collect::<Vec<_>>());
    let near = simulation().at(sampled.times_near_largest().iter().copied()).run().unwrap();
    let mut refined = sampled.clone();
    refined.refine(&near.samples().collect::<Vec<_>>());
    (run, sampled, refined)
}

/// A quarter of the period of a pendulum that is let go level: √(l/g) K(1/√2), with K = π / (2 agm(1, cos 45°)).
fn quarter(length_over_gravity: f64) -> f64 {
    let (mut a, mut b) = (1.0_f64, 0.5_f64.sqrt());
    for _ in 0..6 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    length_over_gravity.sqrt() * PI / (2.0 * a)
}

/// Energy gives l ω² = 2 g cos θ, so that the pin bears m g cos θ + m l ω² = 3 m g cos θ, along the arm: 60 N at the lowest point.
#[test]
fn analytic_pin_bears_three_weights_at_the_lowest_point() {
    let (run, sampled, refined) = found(&swing::Swings::default(), 1e-3);
    let [of] = &refined.joints[..] else { panic!("{:?}", refined.joints) };
    assert_eq!((&*of.joint.name, of.joint.kind, of.joint.unit), ("pin", "hinge", "N"));
    let t = quarter(0.5 / 10.0);
    // parabolas: the fourth derivative of 60 cos θ(t) is some 60 (2 g/l)², which is small beside the tolerance over (1 ms / 16)⁴
    assert!((of.largest.value / 60.0 - 1.0).abs() <= RUN, "{:?}", of.largest);
    // the vertex is flat: half of the digits, and better by symmetry
    assert!((of.largest.t - t).abs() <= 1e-7, "{:?} {t}", of.largest);
    // parabolas through samples 1 ms apart have an error of h⁴ f''''/384, relative: (40 s⁻² · 1e-6 s²)² / 384
    let error = (sampled.joints[0].largest.value / 60.0 - 1.0).abs();
    assert!(error <= 1e-11 + RUN, "{error:e}");
    // docs/notation.md: the pin acts on the ground, the body of p, with −λ; it is pulled down, so that λ points up
    let direction = of.direction.unwrap();
    assert!((direction - 0.5 * PI).abs() <= 1e-5, "{direction}");
    // by the samples: the norm is 3 m g cos θ at each of them
    for sample in run.samples() {
        let expected = 60.0 * sample.get("bob.phi").unwrap().sin().abs();
        assert!((of.joint.reaction(sample.multipliers) - expected).abs() <= 60.0 * RUN);
    }
}

/// The mean of 3 m g cos θ from side to side, which takes 2 t₁: ω² = 2 (g/l) cos θ, so that ∫ cos θ dt = l/(2 g) ∫ ω dθ; and ∫ ω dθ · ∫ dθ/ω = 4 π
/// from side to side, since the integrals of √cos and of 1/√cos over a quarter of a turn have the product π. The reaction is even about both ends, so that
/// trapezoids have all digits.
#[test]
fn analytic_mean_of_the_pin_is_that_of_the_swing() {
    let t = quarter(0.5 / 10.0);
    let scene = swing::Swings::default();
    let simulation = Simulation::new(&scene).method(Method::dop853(RTOL)).until(2.0 * t).every(2.0 * t / 200.0);
    let of = &Reactions::of(&simulation.run().unwrap().samples().collect::<Vec<_>>()).joints[0];
    let expected = 60.0 * 0.025 * (4.0 * PI / (2.0 * t)) / (2.0 * t);
    assert!((of.mean / expected - 1.0).abs() <= RUN, "{} {expected}", of.mean);
    assert!(of.mean < of.rms && of.rms < of.largest.value, "{of:?}");
}

/// The motor gives the rate of the kinetic and potential energy and what the damper takes.
#[test]
fn analytic_motor_of_a_crank_gives_what_the_damper_takes_and_the_energy_gains() {
    let (run, _, refined) = found(&crank::Turns::default(), 1e-3);
    let names: Vec<&str> = refined.powers.iter().map(|flow| flow.name).collect();
    assert_eq!(names, ["friction", "drives", "potential"]);
    let inertia = 0.4 + 2.0 * 0.3 * 0.3;
    let motion = |t: f64| [2.0 * t + 0.3 * (3.0 * t).sin(), 2.0 + 0.9 * (3.0 * t).cos(), -2.7 * (3.0 * t).sin()];
    let powers = |t: f64| {
        let [phi, omega, alpha] = motion(t);
        let weight = -2.0 * 9.81 * 0.3 * phi.cos() * omega;
        let damper = -0.7 * omega * omega;
        [damper, inertia * omega * alpha - weight - damper, weight]
    };
    let most = |i: usize, sign: f64| {
        let n = 2_000_000;
        (0..=n).map(|k| sign * powers(2.0 * f64::from(k) / f64::from(n))[i]).fold(0.0_f64, f64::max)
    };
    for (i, flow) in refined.powers.iter().enumerate() {
        for sample in run.samples() {
            let (power, expected) = (sample.power[i], powers(sample.t)[i]);
            assert!((power - expected).abs() <= 30.0 * RUN, "{} at {} s: {power} {expected}", flow.name, sample.t);
        }
        for (largest, sign) in [(flow.delivered, 1.0), (flow.absorbed, -1.0)] {
            // the closed form is looked at every microsecond: an error of 1e-12 s²/8 times second derivatives of some 1,000 W/s²
            let (value, expected) = (largest.map_or(0.0, |largest| largest.value), most(i, sign));
            assert!((value - expected).abs() <= 1e-9 + 30.0 * RUN, "{}: {value} {expected}", flow.name);
            if let Some(Largest { value, t }) = largest {
                assert!((sign * powers(t)[i] - value).abs() <= 1e-9 + 30.0 * RUN, "{}: {value} at {t} s", flow.name);
            }
        }
    }
    assert_eq!(refined.powers[0].delivered, None);
    let last = run.last().energy.kinetic - run.first().energy.kinetic;
    assert_eq!(refined.balance.kinetic, last);
    assert!(refined.balance.difference().abs() <= 30.0 * RUN, "{:?}", refined.balance);
}

/// By Simpson's rule over samples the powers add up to the works that the run integrates, and to the change of the potential energy.
#[test]
fn cross_powers_integrate_to_the_works() {
    for scene in [&crank::Turns::default() as &dyn Scene, &swing::Swings::default()] {
        let (run, _, refined) = found(scene, 1e-3);
        let samples: Vec<_> = run.samples().collect();
        assert_eq!(samples.len() % 2, 1);
        for (i, flow) in refined.powers.iter().enumerate() {
            let thirds = samples
                .windows(3)
                .step_by(2)
                .map(|s| (s[2].t - s[0].t) / 6.0 * (s[0].power[i] + 4.0 * s[1].power[i] + s[2].power[i]));
            let work: f64 = thirds.sum();
            // h⁴/180 of the fourth derivative over 2 s, of powers of 100 W at 10 rad/s
            assert!((work - flow.work).abs() <= 1e-8, "{}: {work} {}", flow.name, flow.work);
        }
    }
}

#[test]
fn invariant_joints_are_rows_of_one_vector() {
    let of = |scene: &dyn Scene| -> Vec<(String, &'static str, usize)> {
        let joints = Joint::all(&scene.info());
        joints.into_iter().map(|joint| (joint.name.clone(), joint.unit, joint.rows.len())).collect()
    };
    let expected = [("rail.across", "N", 1), ("rail.angle", "N*m", 1), ("glue", "N", 2), ("glue.angle", "N*m", 1)];
    assert_eq!(of(&rows::Rests::default()), expected.map(|(name, unit, n)| (name.to_owned(), unit, n)));
}

/// A row for each sample has a number for each column; without powers there are none.
#[test]
fn invariant_table_has_a_number_for_each_column() {
    let (run, _, refined) = found(&crank::Turns::default(), 0.1);
    let names: Vec<String> =
        refined.columns().into_iter().map(|column| format!("{} [{}]", column.name, column.unit)).collect();
    let expected = ["t [s]", "lambda.pin.x [N]", "lambda.pin.y [N]", "norm.pin [N]", "lambda.motor [N*m]"];
    assert_eq!(names[..5], expected);
    assert_eq!(names[5..], ["power.friction [W]", "power.drives [W]", "power.potential [W]"]);
    for sample in run.samples() {
        let row = refined.row(&sample);
        assert_eq!((row.len(), row[3]), (names.len(), row[1].hypot(row[2])));
        assert_eq!(row[5], sample.get("power.friction").unwrap());
    }
    let without = Simulation::new(&crank::Turns::default()).every(0.1).run().unwrap();
    assert_eq!(without.last().get("power.drives").unwrap_err().remedy, Some("power"));
    assert!(Reactions::of(&without.samples().collect::<Vec<_>>()).powers.is_empty());
}

/// By the state of each sample: gravity −m g y', torsion −k (φ − φ₀) ω, friction −f ω²/√(ω² + u²). Works are what each potential lost; friction is alone
/// in its effect, so that its work is the one that the run integrated.
#[test]
fn analytic_forces_of_a_pendulum_with_spring_and_friction() {
    let scene = spring::Swings::default();
    let (run, _, _) = found(&scene, 1e-3);
    let samples: Vec<_> = run.samples().collect();
    let flows = ElementFlows::of(&scene, &samples);
    let names: Vec<_> =
        flows.columns().into_iter().map(|column| format!("{} [{}]", column.name, column.unit)).collect();
    let expected = ["power.gravity [W]", "power.torsion ground ~ bob [W]", "power.friction ground ~ bob [W]"];
    assert_eq!(names, expected);
    let state = |sample: &Sample<'_>| ["bob.y", "bob.phi", "bob.vy", "bob.omega"].map(|name| sample.get(name).unwrap());
    for (i, sample) in samples.iter().enumerate() {
        let [_, phi, vy, omega] = state(sample);
        let expected = [-20.0 * vy, -6.0 * (phi + 0.2) * omega, -0.8 * omega * omega / omega.hypot(0.5)];
        for (power, expected) in flows.powers(i).iter().zip(expected) {
            assert!((power - expected).abs() <= 1e-12, "{power} {expected} at {} s", sample.t);
        }
    }
    let [[y, phi, ..], [y_end, phi_end, ..]] = [&samples[0], &samples[samples.len() - 1]].map(state);
    let stored = |phi: f64| 3.0 * (phi + 0.2) * (phi + 0.2);
    let friction = samples[samples.len() - 1].get("work.rub").unwrap();
    let works = [-20.0 * (y_end - y), stored(phi) - stored(phi_end), friction];
    for (flow, expected) in flows.all.iter().zip(works) {
        // h⁴/6 of the third derivative, some 50 W at 10 rad/s, over 2 s
        let bound = 1e-12 / 6.0 * 2.0 * 50.0 * 1e3 + 30.0 * RUN;
        assert!((flow.work - expected).abs() <= bound, "{}: {} {expected}", flow.element.name, flow.work);
    }
    let friction = &flows.all[2];
    assert_eq!((friction.element.effect, friction.delivered), (Some("rub"), None));
    let sum: f64 = flows.all.iter().map(|flow| flow.work).sum();
    let kinetic = samples[samples.len() - 1].energy.kinetic - samples[0].energy.kinetic;
    assert!((sum - kinetic).abs() <= 1e-7, "{sum} {kinetic}");
}

/// Forces and drives together are vᵀ M a at each sample, and of forces that are alone the flow is that of their effect.
#[test]
fn cross_forces_and_drives_are_what_the_kinetic_energy_gains() {
    let scene = crank::Turns::default();
    let (run, reactions, refined) = found(&scene, 1e-3);
    let samples: Vec<_> = run.samples().collect();
    let mut flows = ElementFlows::of(&scene, &samples);
    let drives = 1;
    for (i, sample) in samples.iter().enumerate() {
        let gain: f64 = [2.0, 2.0, 0.4]
            .iter()
            .zip(sample.velocities)
            .zip(sample.accelerations)
            .map(|((mass, v), a)| mass * v * a)
            .sum();
        let sum = flows.powers(i).iter().sum::<f64>() + sample.power[drives];
        assert!((sum - gain).abs() <= 30.0 * RUN, "{sum} {gain} at {} s", sample.t);
    }
    // `friction` and `potential` have one force each
    for (flow, of_effect) in flows.all.iter().zip([&reactions.powers[0], &reactions.powers[2]]) {
        assert_eq!(flow.work, of_effect.work, "{}", flow.element.name);
    }
    assert_eq!(flows.besides(&reactions.powers).len(), 2);
    let times = flows.times_near_largest().to_vec();
    let near = Simulation::new(&scene).method(Method::dop853(RTOL)).work().power().at(times).run().unwrap();
    flows.refine(&scene, &near.samples().collect::<Vec<_>>());
    for (flow, of_effect) in flows.all.iter().zip([&refined.powers[0], &refined.powers[2]]) {
        for (own, of_effect) in [(flow.delivered, of_effect.delivered), (flow.absorbed, of_effect.absorbed)] {
            let [own, of_effect] = [own, of_effect].map(|largest| largest.map_or(0.0, |largest| largest.value));
            assert!((own - of_effect).abs() <= 30.0 * RUN, "{}: {own} {of_effect}", flow.element.name);
        }
    }
    assert_eq!(flows.powers(0).len(), 2);
}

/// The force 2 t passes the limit of 1 N at 0.5 s; from there on v = (t − 0.5)², and the skate takes v, the force gives 2 t v. While it holds nothing moves.
#[test]
fn analytic_skate_takes_power_while_it_slides() {
    let scene = puck::Slips::default();
    let (run, _, _) = found(&scene, 1e-2);
    let samples: Vec<_> = run.samples().collect();
    let flows = ElementFlows::of(&scene, &samples);
    let names: Vec<_> = flows.all.iter().map(|flow| flow.element.name).collect();
    assert_eq!(names, ["force at puck", "skate edge"]);
    for (i, sample) in samples.iter().enumerate() {
        let v = (sample.t - 0.5).max(0.0).powi(2);
        for (power, expected) in flows.powers(i).iter().zip([2.0 * sample.t * v, -v]) {
            assert!((power - expected).abs() <= 10.0 * RUN, "{power} {expected} at {} s", sample.t);
        }
    }
    // one of two in the forces of the model: integrals over samples, of which (2 − 0.5)³/3 is one, to h³/12 of f'' = 2 at the time where it begins to slide
    let skate = flows.all[1].work;
    assert!((skate + 1.5_f64.powi(3) / 3.0).abs() <= 1e-6 / 6.0 + 10.0 * RUN, "{skate}");
}

/// Without works all of them are integrals over the samples, by another route the same.
#[test]
fn cross_works_by_samples_are_the_integrated_ones() {
    let scene = spring::Swings::default();
    let flows = |works: bool| {
        let simulation = Simulation::new(&scene).method(Method::dop853(RTOL)).every(1e-3);
        let run = if works { simulation.work() } else { simulation }.run().unwrap();
        ElementFlows::of(&scene, &run.samples().collect::<Vec<_>>())
    };
    let (with, without) = (flows(true), flows(false));
    for (a, b) in with.all.iter().zip(&without.all) {
        assert!((a.work - b.work).abs() <= 1e-7, "{}: {} {}", a.element.name, a.work, b.work);
    }
    assert!(with.all[2].work < 0.0);
}
