//! Models with inputs and outputs, and the same models with a parameter in the place of an input.

use ezy_core::model;

model! {
    /// The EzyRoller, its hinge in the hands of a rider.
    pub model Piloted {
        body seat { mass: 46, inertia: 10 }
        body bar { mass: 1, inertia: 0.005 }
        point A = seat(-0.2, 0);
        hinge B: seat(0.6, 0) ~ bar(-0.1, 0);
        skate rear: at A along seat(1, 0);
        skate front: at bar(0.1, 0) along bar(1, 0);

        /// path speed of the seat
        output speed: km/h = norm(seat.v);
        output wheel: mm = (A.x, A.y);
        output steering: deg = B.angle;
        output turning = B.rate;

        /// What the rider does with his arms.
        effect rider {
            /// torque between seat and bar
            input torque: N*cm = 50;
            torque bar ~ seat: torque;
            output power: W = torque * B.rate;
        }
        /// The same torque, as a parameter.
        effect machine { param torque: N*cm = 50; torque bar ~ seat: torque; }
        effect push { input pull: N = 0; force at A: (pull * cos(t), 0); }

        start cross { seat at (0.2, 0) angle 0; bar angle pi/2; seat velocity (1, _) rate 0; }
        scene coast { start cross; until 1 s; }
        scene ridden { start cross; until 2 s; with rider; }
        scene driven { start cross; until 2 s; with machine; }
        scene pushed { start cross; until 2 s; with push, rider; }
    }
}

model! {
    /// The same without any effect.
    pub model Unpiloted {
        body seat { mass: 46, inertia: 10 }
        body bar { mass: 1, inertia: 0.005 }
        point A = seat(-0.2, 0);
        hinge B: seat(0.6, 0) ~ bar(-0.1, 0);
        skate rear: at A along seat(1, 0);
        skate front: at bar(0.1, 0) along bar(1, 0);
        output speed: km/h = norm(seat.v);
        output wheel: mm = (A.x, A.y);
        output steering: deg = B.angle;
        output turning = B.rate;
        start cross { seat at (0.2, 0) angle 0; bar angle pi/2; seat velocity (1, _) rate 0; }
        scene coast { start cross; until 1 s; }
    }
}
