//! Models whose equations have other shapes than the EzyRoller's: no rows, many hinges on one body, closed loops, chains
//! of blocks, several skates on a body, forces with roots and arcs, rows that have no direction at one point.

use ezy_core::model;
use ezy_core::model::ModelInfo;

/// Every model of this module.
pub static MODELS: [&ModelInfo; 10] = [
    &free_body::MODEL,
    &double_pendulum::MODEL,
    &four_bar::MODEL,
    &hub::MODEL,
    &train::MODEL,
    &spring_and_drag::MODEL,
    &no_parameters::MODEL,
    &tethered::MODEL,
    &circling::MODEL,
    &cornered::MODEL,
];

model! {
    /// Nothing holds it.
    pub model FreeBody {
        param m: kg = 2.0;
        param i: kg*m^2 = 0.3;
        body disc { mass: m, inertia: i }
        effect push { param f: N = 1.5; force at disc(0.1, 0.2) along disc(3, 4): f * sin(2*t); }
        start moving { disc at (1, 2) angle 0.3 velocity (0.5, -0.25) rate 2; }
        scene drift { start moving; until 1 s; }
        scene pushed { start moving; until 1 s; with push; }
    }
}

model! {
    /// Two rods from the ground: blocks of hinges in a chain.
    pub model DoublePendulum {
        param l: m = 1.0;
        param m: kg = 1.0;
        param g: m/s^2 = 9.81;
        body upper { mass: m, inertia: m*l^2/12 }
        body lower { mass: 2*m, inertia: m*l^2/6 }
        hinge top: ground(0, 0) ~ upper(-l/2, 0);
        hinge elbow: upper(l/2, 0) ~ lower(-l/2, 0);
        force at upper(0, 0): (0, -m*g);
        force at lower(0, 0): (0, -2*m*g);
        start bent { upper angle 0.4; lower angle -0.7; at rest; }
        scene swing { start bent; until 1 s; }
    }
}

model! {
    /// A closed loop.
    pub model FourBar {
        param crank_length: m = 0.3;
        param coupler_length: m = 0.8;
        param rocker_length: m = 0.6;
        param base: m = 0.7;
        param m: kg = 1.0;
        body crank { mass: m, inertia: m*crank_length^2/12 }
        body coupler { mass: m, inertia: m*coupler_length^2/12 }
        body rocker { mass: m, inertia: m*rocker_length^2/12 }
        hinge A: ground(0, 0) ~ crank(-crank_length/2, 0);
        hinge B: crank(crank_length/2, 0) ~ coupler(-coupler_length/2, 0);
        hinge C: coupler(coupler_length/2, 0) ~ rocker(rocker_length/2, 0);
        hinge D: rocker(-rocker_length/2, 0) ~ ground(base, 0);
        effect motor { param torque: N*m = 0.5; torque crank: torque * cos(t); }
        start turning { crank angle 0.5 rate 1; }
        scene coast { start turning; until 1 s; }
        scene driven { start turning; until 1 s; with motor; }
    }
}

model! {
    /// Four arms on one hub, one of them on a wheel.
    pub model Hub {
        param r: m = 0.2;
        param l: m = 0.5;
        body hub { mass: 3.0, inertia: 0.1 }
        body east { mass: 1.0, inertia: 0.02 }
        body north { mass: 1.1, inertia: 0.021 }
        body west { mass: 1.2, inertia: 0.022 }
        body south { mass: 1.3, inertia: 0.023 }
        hinge E: hub(r, 0) ~ east(-l/2, 0);
        hinge N: hub(0, r) ~ north(-l/2, 0.01);
        hinge W: hub(-r, 0) ~ west(-l/2, 0);
        hinge S: hub(0, -r) ~ south(-l/2, 0);
        skate wheel: at south(l/2, 0) along south(1, 2);
        torque hub ~ east: 0.3 * sin(3*t);
        start spread { hub at (0, 0) angle 0 rate 1; east angle 0; north angle pi/2; west angle pi; south angle -pi/2; }
        scene spin { start spread; until 1 s; }
    }
}

model! {
    /// A tractor with two wheels and two trailers: skates and hinges in turn, two skates on the first body.
    pub model Train {
        param l: m = 1.0;
        param track: m = 0.3;
        param pull: N = 4.0;
        param k: N*s/m = 0.5;
        body tractor { mass: 5.0, inertia: 0.5 }
        body first { mass: 2.0, inertia: 0.2 }
        body second { mass: 2.0, inertia: 0.2 }
        hinge hook: tractor(-l/2, 0) ~ first(l/2, 0);
        hinge bar: first(-l/2, 0) ~ second(l/2, 0);
        skate axle: at tractor(0, 0) along tractor(1, 0);
        skate steered: at tractor(l/2, 0) along tractor(cos(0.3), sin(0.3));
        skate front: at first(-l/4, track) along first(1, 0);
        skate rear: at second(-l/4, -track) along second(1, 0);
        force at tractor(0, 0) along tractor(1, 0): pull - k * tractor.vx;
        start straight { tractor at (0, 0) angle 0; first angle 0.1; second angle -0.1; tractor vx 0.2; }
        scene pull { start straight; until 1 s; }
    }
}

model! {
    /// Forces with roots, arcs and products of lengths.
    pub model SpringAndDrag {
        param k: N/m = 30.0;
        param rest: m = 0.4;
        param drag: N*s^2/m^2 = 0.2;
        body weight { mass: 1.0, inertia: 0.05 }
        body arm { mass: 0.5, inertia: 0.02 }
        point P = weight(0.1, 0.05);
        point Q = arm(0.3, 0);
        hinge pin: ground(0, 1) ~ arm(-0.3, 0);
        let length = sqrt((P.x - Q.x)^2 + (P.y - Q.y)^2);
        let pull = k * (length - rest) / length;
        force at P: (-pull * (P.x - Q.x), -pull * (P.y - Q.y));
        force at Q: (pull * (P.x - Q.x), pull * (P.y - Q.y));
        force at P: -drag * norm(P.v) * P.v;
        torque arm: -0.1 * atan2(pin.rate, 1) + 0.05 * tanh(sin(pin.angle));
        start apart { weight at (0.5, 0.2) angle 0.3 velocity (1, -0.5); arm angle 0.2; }
        scene bounce { start apart; until 1 s; }
    }
}

model! {
    /// Not a single parameter.
    pub model NoParameters {
        body rod { mass: 1, inertia: 0.1 }
        hinge pin: ground(1, 2) ~ rod(0.3, 0.4);
        start held { rod angle 1 rate 3; }
        scene turn { start held; until 1 s; }
    }
}

model! {
    /// On a rod: at its other end the row has no direction.
    pub model Tethered {
        param l: m = 1.0;
        body bob { mass: 1.0, inertia: 0.1 }
        rod R: ground(0, 0) ~ bob(0, 0) length l;
        start aside { bob at (0.6, 0.8) velocity (0.8, -0.6); }
        scene circle { start aside; until 1 s; }
    }
}

model! {
    /// At a distance that is driven: its derivatives grow beyond bounds where it is zero.
    pub model Circling {
        body bob { mass: 1.0, inertia: 0.1 }
        drive D: norm(bob.r) = 1 + 0.1*sin(t);
        start aside { bob at (1, 0); }
        scene round { start aside; until 1 s; }
    }
}

model! {
    /// Rows with corners that are rounded by a millimetre.
    pub model Cornered {
        param radius: m = 1e-3;
        body bob { mass: 1.0, inertia: 0.1 }
        drive X: sqrt(bob.x^2 + radius^2) = 1 + 0.1*sin(t);
        drive Y: sqrt(bob.y^2 + radius^2) = 1 + 0.1*cos(t);
        start aside { bob angle 0; }
        scene shake { start aside; until 1 s; }
    }
}
