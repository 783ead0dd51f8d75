//! Constraints of positions, constraints of velocities.

ezy_core::model! {
    pub model Hinge {
        body thigh { mass: 7, inertia: 0.1 }
        body shin { mass: 4, inertia: 0.06 }
        hinge hip: ground(0, 0) ~ thigh(-0.2, 0);
        hinge knee: thigh(0.2, 0) ~ shin(-0.2, 0);
        gravity (0, -9.81);
        start bent { thigh angle -1; shin angle -2; at rest; }
        scene swing { start bent; until 1 s; }
    }
}

ezy_core::model! {
    pub model Weld {
        body post { mass: 2, inertia: 0.2 }
        body arm { mass: 1, inertia: 0.1 }
        hinge foot: ground(0, 0) ~ post(-0.5, 0);
        weld corner: post(0.5, 0) ~ arm(-0.4, 0) angle -pi/2;
        gravity (0, -9.81);
        start upright { post angle pi/2; at rest; }
        scene falls { start upright; until 0.5 s; }
    }
}

ezy_core::model! {
    pub model Slider {
        body block { mass: 2, inertia: 0.01 }
        slider rail: ground(0, 0) ~ block(0, 0) along ground(2, 1);
        gravity (0, -9.81);
        start high { block at (1, 0.5); at rest; }
        scene slides { start high; until 1 s; }
    }
}

ezy_core::model! {
    pub model Slot {
        body arm { mass: 1, inertia: 0.1 }
        body block { mass: 1, inertia: 0.003 }
        hinge foot: ground(0, 0) ~ arm(-0.5, 0);
        slot groove: arm(0, 0) ~ block(0, 0) along arm(1, 0);
        gravity (0, -9.81);
        start slanted { arm angle 0.6; block near at (0.6, 0.4); block angle 0; at rest; }
        scene slides { start slanted; until 0.5 s; }
    }
}

ezy_core::model! {
    pub model Rod {
        param l: m = 0.8;
        body bob { mass: 1, inertia: 0.01 }
        rod string: ground(0, 0) ~ bob(0, 0.1) length l;
        gravity (0, -9.81);
        start aside { bob near at (0.5, -0.7); bob angle 0; at rest; }
        scene swing { start aside; until 1 s; }
    }
}

ezy_core::model! {
    pub model Gear {
        body pinion { mass: 1, inertia: 0.01 }
        body wheel { mass: 4, inertia: 0.2 }
        hinge left: ground(-0.3, 0) ~ pinion(0, 0);
        hinge right: ground(0, 0) ~ wheel(0, 0);
        gear mesh: pinion ~ wheel ratio -2;
        torque pinion: 0.1;
        start still { at rest; }
        scene turns { start still; until 1 s; }
    }
}

ezy_core::model! {
    pub model Drive {
        body crank { mass: 1, inertia: 0.1 }
        hinge shaft: ground(0, 0) ~ crank(-0.3, 0);
        drive motor: shaft.angle = 3 rad/s * t;
        gravity (0, -9.81);
        start level { crank angle 0; }
        scene turns { start level; until 2 s; }
    }
}

ezy_core::model! {
    pub model Constraint {
        param k: 1/m = 0.5;
        body bead { mass: 0.1, inertia: 1e-4 }
        constraint wire: bead.y = k*bead.x^2;
        gravity (0, -9.81);
        start aside { bead x 1; bead angle 0; at rest; }
        scene slides { start aside; until 1 s; }
    }
}

ezy_core::model! {
    pub model Skate {
        body sleigh { mass: 5, inertia: 0.4 }
        skate blade: at sleigh(-0.3, 0) along sleigh(1, 0);
        start pushed { sleigh at (0, 0) angle 0 velocity (1, _) rate 2; }
        scene glides { start pushed; until 2 s; }
    }
}

ezy_core::model! {
    pub model Roll {
        param r: m = 0.05;
        body cart { mass: 5, inertia: 0.4 }
        body wheel { mass: 0.5, inertia: 0.0006 }
        hinge axle: cart(-0.3, 0) ~ wheel(0, 0);
        skate side: at cart(-0.3, 0) along cart(1, 0);
        roll tread: at cart(-0.3, 0) along cart(1, 0) = r*wheel.omega;
        torque wheel: 0.1;
        start still { cart at (0, 0) angle 0; at rest; }
        scene rolls { start still; until 2 s; }
    }
}

ezy_core::model! {
    pub model VelocityConstraint {
        body puck { mass: 1, inertia: 0.1 }
        velocity constraint twist: puck.vx = puck.y * puck.omega;
        start off { puck at (0, 1) angle 0 velocity (1, 0.5); }
        scene moves { start off; until 1 s; }
    }
}
