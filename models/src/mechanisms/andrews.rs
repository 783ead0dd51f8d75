//! Andrews' squeezing mechanism: seven bodies, ten hinges, three closed loops.
//!
//! ```text
//!              C (spring to D on K3)
//!         B
//!      K3 ╱ ╲
//!        ╱    E ───K2─── F ─K1─ O (motor)          E joins K2, K3, K4 and K6
//!   K4 ╱ │ K6              A joins K5, K7 and the ground, G joins K4 and K5, H joins K6 and K7
//!   G ╱  │ H
//!     ╲  │
//!   K5 ╲ │ K7
//!        A
//! ```
//!
//! Coordinates: x, y, φ of `K1` … `K7`; rows: `O F E3 E4 E6 B G A5 H A7` with two components each.
//! Degrees of freedom: 1 at position level, 1 at velocity level. Kinetic and potential energy less the work of the motor are constant.
//! The angles of the literature are K1: β, K2: β + Θ, K3: γ, K4: Φ + δ, K5: δ, K6: Ω + ε, K7: ε. The first pair of
//! multipliers there is that of `E3`, the second of `E4`, the third of `E6`: the force of K2 on the other body.
//! Source: Schiehlen (ed.), "Multibody Systems Handbook" (1990); Hairer and Wanner, "Solving Ordinary Differential
//! Equations II" (1996), section VII.7; problem `andrews` of the IVP test set (CWI, Bari).
//!
#![doc = include_str!("../../sketches/andrews.html")]

use ezy_core::model;

model! {
    /// Seven bodies in three loops, driven by a steady torque.
    pub model Andrews {
        /// point A on the ground
        param xa: m = -0.06934;
        param ya: m = -0.00227;
        /// point B on the ground
        param xb: m = -0.03635;
        param yb: m = 0.03273;
        /// point C on the ground, end of the spring
        param xc: m = 0.014;
        param yc: m = 0.072;
        /// K2, F to E
        param d: m = 0.028;
        /// K2, F to its centre of mass
        param da: m = 0.0115;
        /// K4, E to G
        param e: m = 0.02;
        /// K4, E to its centre of mass
        param ea: m = 0.01421;
        /// K1, O to F
        param rr: m = 0.007;
        /// K1, O to its centre of mass
        param ra: m = 0.00092;
        /// K3, B to E, across
        param ss: m = 0.035;
        /// K3, B to its centre of mass, across
        param sa: m = 0.01874;
        /// K3, B to its centre of mass, along
        param sb: m = 0.01043;
        /// K3, B to D, across
        param sc: m = 0.018;
        /// K3, B to D, along
        param sd: m = 0.02;
        /// K5, A to its centre of mass, along
        param ta: m = 0.02308;
        /// K5, A to its centre of mass, across
        param tb: m = 0.00916;
        /// K7, A to H
        param u: m = 0.04;
        /// K7, A to its centre of mass, along the line to H
        param ua: m = 0.01228;
        /// K7, A to its centre of mass, beside that line
        param ub: m = 0.00449;
        /// K6, E to H
        param zf: m = 0.02;
        /// K5, A to G
        param zt: m = 0.04;
        /// K6, E to its centre of mass
        param fa: m = 0.01421;
        /// stiffness of the spring
        param c0: N/m = 4530.0;
        /// length of the spring without force
        param l0: m = 0.07785;
        /// torque of the motor
        param mom: N*m = 0.033;
        param m1: kg = 0.04325;
        param m2: kg = 0.00365;
        param m3: kg = 0.02373;
        param m4: kg = 0.00706;
        param m5: kg = 0.07050;
        param m6: kg = 0.00706;
        param m7: kg = 0.05498;
        param i1: kg*m^2 = 2.194e-6;
        param i2: kg*m^2 = 4.410e-7;
        param i3: kg*m^2 = 5.255e-6;
        param i4: kg*m^2 = 5.667e-7;
        param i5: kg*m^2 = 1.169e-5;
        param i6: kg*m^2 = 5.667e-7;
        param i7: kg*m^2 = 1.912e-5;

        body K1 { mass: m1, inertia: i1 }
        body K2 { mass: m2, inertia: i2 }
        body K3 { mass: m3, inertia: i3 }
        body K4 { mass: m4, inertia: i4 }
        body K5 { mass: m5, inertia: i5 }
        body K6 { mass: m6, inertia: i6 }
        body K7 { mass: m7, inertia: i7 }

        point E = K2(da - d, 0);
        point D = K3(sd - sb, sa - sc);

        hinge O: ground(0, 0) ~ K1(-ra, 0);
        hinge F: K1(rr - ra, 0) ~ K2(da, 0);
        hinge E3: E ~ K3(-sb, sa - ss);
        hinge E4: E ~ K4(0, -ea);
        hinge E6: E ~ K6(fa, 0);
        hinge B: ground(xb, yb) ~ K3(-sb, sa);
        hinge G: K4(0, e - ea) ~ K5(zt - ta, -tb);
        hinge A5: ground(xa, ya) ~ K5(-ta, -tb);
        hinge H: K6(fa - zf, 0) ~ K7(ub, ua - u);
        hinge A7: ground(xa, ya) ~ K7(ub, ua);

        spring ground(xc, yc) ~ D: stiffness c0, length l0;
        torque K1: mom;

        start assembled {
            K1 angle -0.0617138900142764496358948458001;
            K2 near angle -0.0617138900142764496358948458001;
            K3 near angle 0.455279819163070380255912382449;
            K4 near angle 0.710033369709727538;
            K5 near angle 0.487364979543842550225598953530;
            K6 near angle 1.007879054383935414;
            K7 near angle 1.23054744454982119249735015568;
            at rest;
        }

        /// From rest; the crank turns two and a half times.
        scene squeeze { start assembled; until 0.03 s; }
    }
}
