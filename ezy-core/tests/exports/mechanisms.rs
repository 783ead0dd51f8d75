//! The mechanisms that are exported.

ezy_core::model! {
    /// Every function of the language, an input, a state and outputs; "quotes" and */ in a comment.
    pub model Laws {
        /// a spring's stiffness: 100 % \ steel
        param k: N/m = 3;
        param lambda: m = 0.7;
        param end: N = 0.3;
        body block { mass: 2, inertia: 0.5 }
        slot rail: ground(0, 0) ~ block(0, 0) along ground(1, 0);
        effect all {
            input pull: A*s/m = 0.4;
            state charge: A = 0.2 rate (pull*block.vx - charge)/0.3;
            force at block(0, 0): (end * tanh(block.x/lambda) - k*block.x, 0);
            force at block(0.1, 0): (end*sin(t) * exp(-(block.x/lambda)^2) + end*abs(block.phi)/3, end*ln(2 + (block.y/lambda)^2));
            torque block: 0.1*atan2(block.y, block.x) + 0.2*max(block.phi, 0.3) + 0.1*min(block.x/lambda, block.phi)
                + 0.05*sign(block.phi) + 0.01*sqrt(1 + block.phi^2)*(1 + block.phi^2)^1.3 + 0.01*tan(0.3*tanh(block.phi)) + charge/9;
            /// an angle
            output turn: rad = asin(tanh(block.phi)) + acos(tanh(block.x/lambda)/2);
            output place: m = block.x + 2*lambda;
        }
        start aside { block at (0.1, 0) angle 0.2; at rest; }
        scene runs { start aside; with all; until 1 s; }
    }
}

ezy_core::model! {
    /// Two bodies, a hinge and two skates.
    pub model Roller {
        param a: m = 0.2;
        param b: m = 0.6;
        param c: m = 0.1;
        param d: m = 0.1;
        body seat { mass: 4, inertia: 1 }
        body bar { mass: 1, inertia: 0.5 }
        hinge pin: seat(b, 0) ~ bar(-d, 0);
        skate rear: at seat(-a, 0) along seat(1, 0);
        effect firm { skate front: at bar(c, 0) along bar(1, 0); }
        effect loose {
            param grip: N = 5;
            skate front: at bar(c, 0) along bar(1, 0) limit grip;
        }
        start straight { seat at (0, 0) angle 0 velocity (1, 0); bar angle 0.4; }
        scene coasts { start straight; with firm; until 1 s; }
        scene skids { start straight; with loose; until 1 s; }
    }
}

ezy_core::model! {
    /// Rods in a row.
    pub model Rope {
        count n = 3;
        param l: m = 1;
        body rods[n] { mass: 1, inertia: 1/12 }
        hinge top: ground(0, 0) ~ rods[0](-l/2, 0);
        for i in 1..n {
            hinge pins[i]: rods[i-1](l/2, 0) ~ rods[i](-l/2, 0);
        }
        gravity (0, -9.81);
        start level { for i in 0..n { rods[i] at (l*(i + 0.5), 0) angle 0; } at rest; }
        scene swings { start level; until 1 s; }
    }
}

ezy_core::model! {
    /// A body that flies.
    pub model Thrown {
        body stone { mass: 2, inertia: 1 }
        gravity (0, -9.81);
        drag at stone(0, 0): linear 0.1, quadratic 0.2;
        start hand { stone at (0, 1) angle 0 velocity (3, 1) rate 0; }
        scene flies { start hand; until 1 s; }
    }
}

ezy_core::model! {
    /// A point mass on a string: it has no inertia, so that no elimination solves for it.
    pub model Plumb {
        body bob { mass: 1, inertia: 0 }
        hinge pin: ground(0, 0) ~ bob(0, 1);
        gravity (0, -9.81);
        start aside { bob angle 0.3; at rest; }
        scene swings { start aside; until 1 s; }
    }
}

ezy_core::model! {
    /// A rod that falls until it is level.
    pub model Falling {
        param l: m = 1;
        body rod { mass: 1, inertia: l^2/12 }
        hinge pin: ground(0, 0) ~ rod(-l/2, 0);
        gravity (0, -9.81);
        event half: rod.phi < 0.5;
        start raised { rod angle 1; at rest; }
        scene falls { start raised; until 5 s; until rod.phi < 0; }
    }
}

ezy_core::model! {
    /// A bar on three rods of one length, one of them too many.
    pub model Hung {
        param l: m = 1;
        body bar { mass: 1, inertia: 1 }
        rod left: ground(-0.5, 0) ~ bar(-0.5, 0) length l;
        rod middle: ground(0, 0) ~ bar(0, 0) length l;
        rod right: ground(0.5, 0) ~ bar(0.5, 0) length l;
        start below { bar at (0, -l) angle 0; at rest; }
        scene sways { start below; until 1 s; }
    }
}

ezy_core::model! {
    /// A crank that is driven on, and a rod that is too short to follow it beyond 30 degrees.
    pub model Locking {
        body crank { mass: 1, inertia: 1 }
        body rod { mass: 1, inertia: 1 }
        hinge bearing: ground(0, 0) ~ crank(0, 0);
        hinge pin: crank(1, 0) ~ rod(-0.5, 0);
        slot guide: ground(0, 0) ~ rod(0, 0) along ground(1, 0);
        param rate: rad/s = 1;
        drive turning: crank.phi = rate*t;
        start level { rod near angle 0; }
        scene turns { start level; until 1 s; }
    }
}
