//! The skateboard in the plane: a deck on two trucks that lean steers against each other.
//!
//! ```text
//!          r               r
//!  (rear) ──────(deck)────── (front)        drawn straight; each truck is a skate
//!               (rider)
//! ```
//!
//! Coordinates: x, y, φ of `deck`, `rider`, `front`, `rear`; rows: `feet`, `front_pin`, `rear_pin` with two components each,
//! `lean`, `front_wheels`, `rear_wheels`; steered: `steering`.
//! Degrees of freedom: 5 at position level, 3 at velocity level; steered: 4 and 2. Lean turns the trucks by equal and opposite angles,
//! δ and −δ, so the middle of the deck never moves sideways: θ̇ = U tan δ/r, and at a steady δ it runs on a circle of radius
//! r/tan δ. While the rider stands still on the deck, U² (m + J tan²δ/r²) is constant, however the steering moves, with
//! m the mass and J the moment of inertia of everything, the trucks' masses at ±r.
//! Source: our own, as the snakeboard with coupled trucks; carving trucks as in Hubbard, J. Applied Mechanics 46 (1979).
//!
#![doc = include_str!("../../sketches/skateboard.html")]

use ezy_core::model;

model! {
    /// A deck with a rider on two trucks that steer against each other.
    pub model Skateboard {
        /// truck, from the middle of the deck
        param r: m = 0.4;
        /// mass of the deck
        param m_deck: kg = 3.0;
        /// moment of inertia of the deck
        param j_deck: kg*m^2 = 0.15;
        /// mass of the rider
        param m_rider: kg = 60.0;
        /// moment of inertia of the rider
        param j_rider: kg*m^2 = 1.5;
        /// mass of a truck with its wheels
        param m_truck: kg = 0.8;
        /// moment of inertia of a truck with its wheels
        param j_truck: kg*m^2 = 0.003;

        body deck { mass: m_deck, inertia: j_deck }
        body rider { mass: m_rider, inertia: j_rider }
        body front { mass: m_truck, inertia: j_truck }
        body rear { mass: m_truck, inertia: j_truck }

        hinge feet: deck(0, 0) ~ rider(0, 0);
        hinge front_pin: deck(r, 0) ~ front(0, 0);
        hinge rear_pin: deck(-r, 0) ~ rear(0, 0);
        constraint lean: front_pin.angle + rear_pin.angle = 0;
        skate front_wheels: at front(0, 0) along front(1, 0);
        skate rear_wheels: at rear(0, 0) along rear(1, 0);

        /// The rider leans to and fro.
        effect carving {
            /// mean steering angle of the front truck
            param delta: rad = 0.0;
            /// amplitude of the swing about the mean
            param swing: rad = 0.3;
            /// angular frequency of the swing
            param nu: rad/s = 3.0;
            drive steering: front_pin.angle = delta + swing*sin(nu*t);
        }

        /// The rider does not turn on the deck.
        effect stance {
            constraint stance: feet.angle = 0;
        }

        /// The rider turns to and fro on the deck.
        effect twist {
            /// largest torque on the rider
            param m0: N*m = 4.0;
            /// angular frequency
            param omega: rad/s = 3.0;
            torque rider ~ deck: m0 * cos(omega*t);
        }

        /// Rubber between deck and trucks, and the rider's stiffness.
        effect bushings {
            /// stiffness of a truck
            param k: N*m = 20.0;
            /// damping of a truck
            param c: N*m*s = 0.8;
            /// stiffness of the rider
            param k_rider: N*m = 15.0;
            torsion deck ~ front: stiffness k, damping c;
            torsion deck ~ rear: stiffness k, damping c;
            torsion deck ~ rider: stiffness k_rider;
        }

        /// A foot that pushes off in strokes.
        effect push {
            /// largest force along the deck
            param f: N = 80.0;
            /// strokes per time
            param nu_push: rad/s = 4.0;
            force at deck(0, 0.15) along deck(1, 0): f * max(sin(nu_push*t), 0)^2;
        }

        start rolling { deck at (0, 0) angle 0 velocity (2, _); rider angle 0; }
        start leaning { deck at (0, 0) angle 0 velocity (2, _); rider angle 0 rate 0; front angle 0.2; }

        /// Carves with prescribed steering, the rider still.
        scene carved { start rolling; until 10 s; with carving, stance; }
        /// Twists and pushes on sprung trucks.
        scene ridden { start leaning; until 10 s; with twist, push, bushings; }
    }
}
