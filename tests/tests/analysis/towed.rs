//! What is towed: shimmy of a caster, trailers behind a tractor, against closed forms.

use crate::linear::check_sets;
use ezy_core::model;

model! {
    /// A carriage that is drawn at a speed, and a fork with a wheel that trails behind its pivot.
    pub model Caster {
        param m0: kg = 20; param m: kg = 8; param i: kg*m^2 = 0.4; param g: m = 0.1; param e: m = 0.25;
        param kt: N*m = 20; param ct: N*m*s = 1; param v: m/s = 1;
        body carriage { mass: m0, inertia: 1 }
        body fork { mass: m, inertia: i }
        hinge pivot: carriage(0, 0) ~ fork(g, 0);
        drive tow: carriage.x = v*t;
        constraint level: carriage.phi = 0;
        torsion carriage ~ fork: stiffness kt, angle 0, damping ct;
        output fork_angle: rad = fork.phi;
        effect railed {
            input turn: N*m = 0;
            constraint rail: carriage.y = 0;
            torque fork: turn;
        }
        effect sprung {
            param ky: N/m = 60000; param cy: N*s/m = 60;
            input push: N = 0;
            force at carriage(0, 0): (0, -ky*carriage.y - cy*carriage.vy + push);
            output side: m = carriage.y;
        }
        effect rigid { skate wheel: at fork(g - e, 0) along fork(1, 0); }
        effect soft {
            param c: N/rad = 15000;
            tyre at fork(g - e, 0) along fork(1, 0): stiffness c;
        }
        start straight { carriage at (0, 0) angle 0; carriage velocity (v, 0) rate 0; fork angle 0; }
        scene skate_rail { start straight; until 1 s; with railed, rigid; }
        scene skate_sprung { start straight; until 1 s; with sprung, rigid; }
        scene tyre_rail { start straight; until 1 s; with railed, soft; }
        scene tyre_sprung { start straight; until 1 s; with sprung, soft; }
    }
}

model! {
    /// A tractor with one trailer.
    pub model Single {
        param l0: m = 2.5; param delta: rad = 0.3; param g0: m = 1; param m0: kg = 1200; param i0: kg*m^2 = 1500;
        param c1: m = 0; param l1: m = 3; param g1: m = 0.2; param m1: kg = 800; param i1: kg*m^2 = 900; param v: m/s = 2;
        body tractor { mass: m0, inertia: i0 }
        body trailer1 { mass: m1, inertia: i1 }
        hinge hitch1: tractor(-g0 - c1, 0) ~ trailer1(l1 - g1, 0);
        skate rear: at tractor(-g0, 0) along tractor(1, 0);
        skate front: at tractor(l0 - g0, 0) along tractor(cos(delta), sin(delta));
        skate axle1: at trailer1(-g1, 0) along trailer1(1, 0);
        effect paced { roll pace: at tractor(-g0, 0) along tractor(1, 0) = v; }
        start still { tractor at (0, 0) angle 0; trailer1 angle 0; at rest; }
        scene free { start still; until 1 s; }
        scene held { start still; until 1 s; with paced; }
    }
}

model! {
    /// A tractor with two trailers.
    pub model Double {
        param l0: m = 2.8; param delta: rad = 0.25; param g0: m = 1.1; param m0: kg = 3000; param i0: kg*m^2 = 4000;
        param c1: m = 0.8; param l1: m = 3.5; param g1: m = 0.5; param m1: kg = 1500; param i1: kg*m^2 = 2000;
        param c2: m = 0.6; param l2: m = 2.9; param g2: m = -0.1; param m2: kg = 900; param i2: kg*m^2 = 1100; param v: m/s = 3;
        body tractor { mass: m0, inertia: i0 }
        body trailer1 { mass: m1, inertia: i1 }
        body trailer2 { mass: m2, inertia: i2 }
        hinge hitch1: tractor(-g0 - c1, 0) ~ trailer1(l1 - g1, 0);
        hinge hitch2: trailer1(-g1 - c2, 0) ~ trailer2(l2 - g2, 0);
        skate rear: at tractor(-g0, 0) along tractor(1, 0);
        skate front: at tractor(l0 - g0, 0) along tractor(cos(delta), sin(delta));
        skate axle1: at trailer1(-g1, 0) along trailer1(1, 0);
        skate axle2: at trailer2(-g2, 0) along trailer2(1, 0);
        effect paced { roll pace: at tractor(-g0, 0) along tractor(1, 0) = v; }
        start still { tractor at (0, 0) angle 0; trailer1 angle 0; trailer2 angle 0; at rest; }
        scene free { start still; until 1 s; }
        scene held { start still; until 1 s; with paced; }
    }
}

const CASTER: &str = include_str!("../../answers/linear/caster.json");
const TRACTOR: &str = include_str!("../../answers/linear/tractor_circle.json");

#[test]
fn analytic_caster_shimmies() {
    let n = [
        check_sets::<caster::SkateRail>(CASTER, |name| name == "skate_rail", |_| vec![]),
        check_sets::<caster::SkateSprung>(CASTER, |name| name.starts_with("skate_sprung"), |_| vec![]),
        check_sets::<caster::TyreRail>(CASTER, |name| name == "tyre_rail", |_| vec![]),
        check_sets::<caster::TyreSprung>(CASTER, |name| name == "tyre_sprung", |_| vec![]),
    ];
    assert_eq!(n, [2, 11, 2, 5]);
}

#[test]
fn analytic_trailers_follow_a_circle_and_jackknife_backwards() {
    let is_paced = |name: &str| name.ends_with("paced");
    let n = [
        check_sets::<single::Free>(TRACTOR, |name| name.starts_with("one") && !is_paced(name), |_| vec![]),
        check_sets::<single::Held>(TRACTOR, |name| name.starts_with("one") && is_paced(name), |_| vec![]),
        check_sets::<double::Free>(TRACTOR, |name| name.starts_with("two") && !is_paced(name), |_| vec![]),
        check_sets::<double::Held>(TRACTOR, |name| name.starts_with("two") && is_paced(name), |_| vec![]),
    ];
    assert_eq!(n, [3, 1, 3, 1]);
}
