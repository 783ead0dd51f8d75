//! Models that compile and cannot run, or run and are wrong: those of the guide's chapter on wrong models.
//!
//! `cargo run --example mistakes -- run fourbar/turns`

use std::process::ExitCode;

ezy_core::model! {
    /// A four-bar linkage whose bars are too short.
    pub model FourBar {
        param base: m = 2;
        body crank { mass: 1, inertia: 0.1 }
        body coupler { mass: 1, inertia: 0.1 }
        body rocker { mass: 1, inertia: 0.1 }
        hinge A: ground(0, 0) ~ crank(-0.2, 0);
        hinge B: crank(0.2, 0) ~ coupler(-0.4, 0);
        hinge C: coupler(0.4, 0) ~ rocker(-0.3, 0);
        hinge D: rocker(0.3, 0) ~ ground(base, 0);
        start loose { rocker near angle -1; }
        scene turns { start loose; until 1 s; }
    }
}

ezy_core::model! {
    /// Two bars between two points, exactly as far apart as the bars are long together.
    pub model Toggle {
        body left { mass: 1, inertia: 0.1 }
        body right { mass: 1, inertia: 0.1 }
        hinge A: ground(0, 0) ~ left(-0.5, 0);
        hinge B: left(0.5, 0) ~ right(-0.5, 0);
        hinge C: right(0.5, 0) ~ ground(2, 0);
        gravity (0, -9.81);
        start straight { left angle 0; right angle 0; at rest; }
        scene falls { start straight; until 1 s; }
    }
}

ezy_core::model! {
    /// A pendulum whose bar has neither mass nor inertia.
    pub model Massless {
        body bar { mass: 0, inertia: 0 }
        hinge pin: ground(0, 0) ~ bar(-0.5, 0);
        gravity (0, -9.81);
        start aside { bar angle 0.5; at rest; }
        scene swing { start aside; until 1 s; }
    }
}

ezy_core::model! {
    /// A sled whose friction is written by the sign of its speed.
    pub model Sign {
        param f: N = 5;
        body sled { mass: 5, inertia: 1 }
        slider rail: ground(0, 0) ~ sled(0, 0) along ground(1, 0);
        force at sled(0, 0): (2 - f*sign(sled.vx), 0);
        start pushed { sled at (0, 0) velocity (1, 0); }
        scene slides { start pushed; until 5 s; }
    }
}

ezy_core::model! {
    /// A spring that pushes apart, because its stiffness has the wrong sign.
    pub model Sprung {
        body cart { mass: 1, inertia: 1 }
        slider rail: ground(0, 0) ~ cart(0, 0) along ground(1, 0);
        force at cart(0, 0): (40 N/m * cart.x, 0);
        start aside { cart at (0.1, 0); at rest; }
        scene swing { start aside; until 3 s; }
    }
}

fn main() -> ExitCode {
    ezy_cli::main(&[&four_bar::MODEL, &toggle::MODEL, &massless::MODEL, &sign::MODEL, &sprung::MODEL])
}
