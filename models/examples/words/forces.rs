//! Forces.

ezy_core::model! {
    pub model Gravity {
        body stone { mass: 2, inertia: 0.1 }
        gravity (0, -9.81);
        start high { stone at (0, 5) angle 0; at rest; }
        scene falls { start high; until 1 s; }
    }
}

ezy_core::model! {
    pub model Force {
        body rocket { mass: 5, inertia: 1 }
        force at rocket(-0.5, 0) along rocket(1, 0): 20;
        force at rocket(-0.5, 0) across rocket(1, 0): 0.2*sin(3*t);
        gravity (0, -9.81);
        start up { rocket at (0, 0) angle 1.5; at rest; }
        scene flies { start up; until 1 s; }
    }
}

ezy_core::model! {
    pub model Torque {
        body stand { mass: 5, inertia: 1 }
        body rotor { mass: 1, inertia: 0.1 }
        hinge bearing: stand(0.4, 0) ~ rotor(0, 0);
        hinge foot: ground(0, 0) ~ stand(-0.4, 0);
        torque rotor ~ stand: 0.5;
        start still { at rest; }
        scene turns { start still; until 1 s; }
    }
}

ezy_core::model! {
    pub model Spring {
        body bob { mass: 1, inertia: 0.1 }
        spring ground(0, 0) ~ bob(0, 0.2): stiffness 40, length 0.6, damping 0.5;
        gravity (0, -9.81);
        start low { bob at (0.1, -1) angle 0; at rest; }
        scene bounces { start low; until 1 s; }
    }
}

ezy_core::model! {
    pub model Damper {
        body door { mass: 10, inertia: 1 }
        hinge edge: ground(0, 0) ~ door(-0.5, 0);
        damper ground(0.2, -0.6) ~ door(0.1, 0): damping 30;
        start open { door angle 0.9 rate -2; }
        scene closes { start open; until 1 s; }
    }
}

ezy_core::model! {
    pub model Torsion {
        body wheel { mass: 1, inertia: 0.1 }
        hinge axle: ground(0, 0) ~ wheel(0, 0);
        torsion ground ~ wheel: stiffness 3, damping 0.05;
        start turned { wheel angle 0.5; at rest; }
        scene swings { start turned; until 2 s; }
    }
}

ezy_core::model! {
    pub model Drag {
        body ball { mass: 0.4, inertia: 0.01 }
        gravity (0, -9.81);
        drag at ball(0, 0): linear 0.01, quadratic 0.02, angular 0.001;
        start thrown { ball at (0, 0) angle 0 velocity (10, 10) rate 3; }
        scene flight { start thrown; until 1 s; }
    }
}

ezy_core::model! {
    pub model Friction {
        param mu = 0.3;
        param m: kg = 2;
        body puck { mass: m, inertia: 0.1 }
        friction at puck(0, 0): force mu*m*9.81 m/s^2, speed 0.01;
        start pushed { puck at (0, 0) angle 0 velocity (2, 0); }
        scene stops { start pushed; until 1 s; }
    }
}

ezy_core::model! {
    pub model Tyre {
        body car { mass: 1000, inertia: 1500 }
        tyre at car(1.2, 0) along car(cos(0.02), sin(0.02)): stiffness 6e4, limit 4e3;
        tyre at car(-1.4, 0) along car(1, 0): stiffness 6e4, limit 4e3;
        start straight { car at (0, 0) angle 0 velocity (20, 0) rate 0; }
        scene bend { start straight; until 2 s; }
    }
}
