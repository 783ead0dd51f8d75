//! A mass on a spring so stiff that it is nearly a rod.

use ezy_core::model;

model! {
    /// A pendulum whose rod is a spring, with or without a damper.
    pub model SpringPendulum {
        param m: kg = 1.0;
        param i: kg*m^2 = 1.0;
        param k: N/m = 1e9;
        param l: m = 1.0;
        param c: N*s/m = 0.0;
        body bob { mass: m, inertia: i }
        spring ground(0, 0) ~ bob(0, 0): stiffness k, length l, damping c;
        gravity (0, -9.81);
        start level { bob at (l, 0) angle 0; at rest; }
        scene swing { start level; until 1 s; }
    }
}
