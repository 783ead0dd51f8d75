//! The snakeboard: a board on two steerable trucks, propelled by the rider's twist.
//!
//! ```text
//!          r               r
//!  (back) ──────(board)────── (front)        drawn at angle zero; each truck is a skate
//!               (rotor)
//! ```
//!
//! Coordinates: x, y, φ of `board`, `rotor`, `front`, `back`; rows: `pivot`, `front_pin`, `back_pin` with two components
//! each, `front_wheels`, `back_wheels`; driven: `twist`, `front_steering`, `back_steering`.
//! Degrees of freedom: 6 at position level, 4 at velocity level; driven: 3 and 1. By default the trucks have no mass, only inertia.
//! With φ the steering angle of the front truck and −φ that of the back truck, forward speed U, J the sum of all moments
//! of inertia: θ̇ = U tan φ/r, and p = m U + J U tan²φ/r² + Jr ψ̇ tan φ/r is constant while the steering is locked; the
//! board then runs on a circle of radius r/tan φ. Where both trucks stand across the board their rows coincide.
//! Source: Ostrowski, Lewis, Murray, Burdick, "Nonholonomic mechanics and locomotion: the snakeboard example", ICRA 1994.
//!
#![doc = include_str!("../../sketches/snakeboard.html")]

use ezy_core::model;

model! {
    /// A board on two steerable trucks with a rider who twists.
    pub model Snakeboard {
        /// truck, from the middle of the board
        param r: m = 0.2;
        /// mass of the board
        param m_board: kg = 4.0;
        /// moment of inertia of the board
        param j_board: kg*m^2 = 0.016;
        /// mass of the rider
        param m_rotor: kg = 2.0;
        /// moment of inertia of the rider
        param j_rotor: kg*m^2 = 0.072;
        /// mass of a truck
        param m_truck: kg = 0.0;
        /// moment of inertia of a truck
        param j_truck: kg*m^2 = 0.0013;

        body board { mass: m_board, inertia: j_board }
        body rotor { mass: m_rotor, inertia: j_rotor }
        body front { mass: m_truck, inertia: j_truck }
        body back { mass: m_truck, inertia: j_truck }

        hinge pivot: board(0, 0) ~ rotor(0, 0);
        hinge front_pin: board(r, 0) ~ front(0, 0);
        hinge back_pin: board(-r, 0) ~ back(0, 0);
        skate front_wheels: at front(0, 0) along front(1, 0);
        skate back_wheels: at back(0, 0) along back(1, 0);

        /// Twist and steering are prescribed, each as offset + rate t + swing sin(ν t + phase).
        effect gait {
            param twist_offset: rad = 0.0;
            param twist_rate: rad/s = 0.0;
            param twist_swing: rad = 0.7;
            param twist_nu: rad/s = 1.0;
            param twist_phase: rad = 0.0;
            param front_offset: rad = 0.0;
            param front_rate: rad/s = 0.0;
            param front_swing: rad = 0.3;
            param front_nu: rad/s = 1.0;
            param front_phase: rad = 0.0;
            param back_offset: rad = 0.0;
            param back_rate: rad/s = 0.0;
            param back_swing: rad = -0.3;
            param back_nu: rad/s = 1.0;
            param back_phase: rad = 0.0;
            drive twist: pivot.angle = twist_offset + twist_rate*t + twist_swing*sin(twist_nu*t + twist_phase);
            drive front_steering:
                front_pin.angle = front_offset + front_rate*t + front_swing*sin(front_nu*t + front_phase);
            drive back_steering: back_pin.angle = back_offset + back_rate*t + back_swing*sin(back_nu*t + back_phase);
        }

        /// The rider twists by a torque.
        effect stroke {
            /// amplitude of the torque on the rider
            param m0: N*m = 0.08;
            /// its mean
            param mean: N*m = 0.0;
            /// angular frequency
            param omega: rad/s = 2.0;
            /// phase at t = 0
            param phase: rad = 0.5;
            torque rotor ~ board: mean + m0 * sin(omega*t + phase);
        }

        /// Springs with dampers hold the trucks along the board.
        effect bushings {
            /// stiffness
            param k: N*m = 0.05;
            /// damping
            param c: N*m*s = 0.002;
            torsion board ~ front: stiffness k, damping c;
            torsion board ~ back: stiffness k, damping c;
        }

        start standing { board at (0, 0) angle 0 velocity (0, _); }
        start steered {
            board at (0, 0) angle 0 velocity (0.5, _);
            rotor angle 0;
            front angle 0.3;
            back angle -0.2;
        }

        /// From rest: twist and steering in step, which drives the board forward.
        scene serpentine { start standing; until 20 s; with gait; }
        /// Rolling, with sprung trucks and a torque between board and rider.
        scene stroked { start steered; until 10 s; with stroke, bushings; }
    }
}
