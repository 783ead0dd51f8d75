//! The parts of a step, each against another way to the same numbers.

mod linear_algebra;
mod steps;

crate::model! {
    /// A puck on a spring and a damper: m x'' + c x' + k x = 0.
    pub model Free {
        param k: N/m = 7;
        param c: N*s/m = 0.5;
        body puck { mass: 4, inertia: 1 }
        effect tie { force at puck(0, 0): (-k * puck.x - c * puck.vx, 0); }
        start here { puck at (1, 0) angle 0 velocity (-0.5, 0) rate 0; }
        effect hard {
            param s: N/m^3 = 1e5;
            force at puck(0, 0): (-s * puck.x^3, 0);
        }
        scene swings { start here; until 1 s; with tie; }
        scene hits { start here; until 1 s; with hard; }
    }
}
