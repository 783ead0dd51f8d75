//! Effects, starts, scenes, events and stops.

ezy_core::model! {
    pub model Effect {
        body ball { mass: 0.4, inertia: 0.01 }
        gravity (0, -9.81);
        effect wind { force at ball(0, 0): (-2, 0); }
        start thrown { ball at (0, 0) angle 0 velocity (5, 5); }
        scene calm { start thrown; until 1 s; }
        scene windy { start thrown; until 1 s; with wind; }
    }
}

ezy_core::model! {
    pub model Release {
        body bob { mass: 1, inertia: 0.01 }
        hinge string: ground(0, 0) ~ bob(0, 1);
        gravity (0, -9.81);
        effect cut {
            release string;
        }
        start aside { bob angle 1; at rest; }
        scene swing { start aside; until 1 s; }
        scene falls { start aside; until 1 s; with cut; }
    }
}

ezy_core::model! {
    pub model Start {
        body crank { mass: 1, inertia: 0.1 }
        body link { mass: 1, inertia: 0.1 }
        hinge O: ground(0, 0) ~ crank(-0.5, 0);
        hinge A: crank(0.5, 0) ~ link(-0.8, 0);
        slot guide: ground(0, 0) ~ link(0.8, 0) along ground(1, 0);
        start up { crank angle 1 rate 2; link near angle -0.5; }
        scene turns { start up; until 1 s; }
    }
}

ezy_core::model! {
    pub model Scene {
        body ball { mass: 1, inertia: 1 }
        gravity (0, -9.81);
        start high { ball at (0, 3) angle 0; at rest; }
        scene falls { start high; until 2 s; until ball.y < 0; }
    }
}

ezy_core::model! {
    pub model Event {
        body ball { mass: 1, inertia: 1 }
        gravity (0, -9.81);
        event top: ball.vy = 0;
        event landing: ball.y < 0;
        start up { ball at (0, 0) angle 0 velocity (3, 5); }
        scene flight { start up; until 5 s; until landing; }
    }
}

ezy_core::model! {
    pub model Stop {
        body ball { mass: 1, inertia: 1 }
        gravity (0, -9.81);
        stop floor: ball.y from 0 restitution 0.6;
        start high { ball at (0, 2) angle 0; at rest; }
        scene bounces { start high; until 3 s; }
    }
}
