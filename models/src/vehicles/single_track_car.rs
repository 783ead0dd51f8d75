//! The single-track car: both wheels of an axle in one, with tyres that slip.
//!
//! ```text
//!       lr            lf
//!  R ─────────(car)───────── F ╱ δ        drawn at car.phi = 0
//! ```
//!
//! Coordinates: `car.x car.y car.phi`; row: `cruise`, where the speed is held.
//! Degrees of freedom: 3 at position level, 3 at velocity level; at held speed 2.
//! Steady cornering at small slip: rate ω = v δ/(L + K v²) with L = lf + lr and K = (m/L)(lr/cf − lf/cr); K > 0 is
//! understeer, and for K < 0 the car is unstable beyond the speed √(−L/K).
//! Source: Riekert and Schunck, Ingenieur-Archiv 11 (1940); Pacejka, "Tyre and Vehicle Dynamics", chapter 1.
//!
#![doc = include_str!("../../sketches/singletrackcar.html")]

use ezy_core::model;

model! {
    /// A car on two tyres, one behind the other.
    pub model SingleTrackCar {
        /// front axle, ahead of the centre of mass
        param lf: m = 1.2;
        /// rear axle, behind the centre of mass
        param lr: m = 1.4;
        /// mass
        param m: kg = 1500.0;
        /// moment of inertia
        param j: kg*m^2 = 2500.0;
        /// steering angle
        param delta: rad = 0.02;

        body car { mass: m, inertia: j }
        point F = car(lf, 0);
        point R = car(-lr, 0);

        /// The speed along the car is held.
        effect cruise {
            /// speed
            param u: m/s = 20.0;
            roll cruise: at car(0, 0) along car(1, 0) = u;
        }

        /// Side forces in proportion to the slip angles.
        effect linear_tyres {
            /// cornering stiffness of the front axle
            param cf: N = 8e4;
            /// cornering stiffness of the rear axle
            param cr: N = 9e4;
            tyre at F along car(cos(delta), sin(delta)): stiffness cf;
            tyre at R along car(1, 0): stiffness cr;
        }

        /// Side forces that level off.
        effect limited_tyres {
            /// cornering stiffness of the front axle
            param cf: N = 8e4;
            /// cornering stiffness of the rear axle
            param cr: N = 9e4;
            /// largest side force of the front axle
            param ff: N = 6e3;
            /// largest side force of the rear axle
            param fr: N = 5.2e3;
            tyre at F along car(cos(delta), sin(delta)): stiffness cf, limit ff;
            tyre at R along car(1, 0): stiffness cr, limit fr;
        }

        /// Side forces that follow the slip angles over a rolled length, in proportion to them.
        effect relaxing_tyres {
            /// cornering stiffness of the front axle
            param cf: N = 8e4;
            /// cornering stiffness of the rear axle
            param cr: N = 9e4;
            /// relaxation length
            param sigma: m = 0.6;
            let front_along = dot(F.v, (cos(car.phi + delta), sin(car.phi + delta)));
            let front_across = dot(F.v, (-sin(car.phi + delta), cos(car.phi + delta)));
            let rear_along = dot(R.v, (cos(car.phi), sin(car.phi)));
            let rear_across = dot(R.v, (-sin(car.phi), cos(car.phi)));
            /// slip angle that the front tyre has followed
            state front_slip: rad = 0 rate (atan2(front_across, front_along) - front_slip)*front_along/sigma;
            /// slip angle that the rear tyre has followed
            state rear_slip: rad = 0 rate (atan2(rear_across, rear_along) - rear_slip)*rear_along/sigma;
            force at F along car(-sin(delta), cos(delta)): -cf*front_slip;
            force at R along car(0, 1): -cr*rear_slip;
        }

        /// A steady thrust on the rear axle against the drag of the air.
        effect thrust {
            /// thrust
            param f: N = 400.0;
            /// drag per square of the speed
            param drag: N*s^2/m^2 = 0.5;
            force at R along car(1, 0): f;
            drag at car(0, 0): quadratic drag;
        }

        start straight { car at (0, 0) angle 0 velocity (20, 0) rate 0; }
        start held { car at (0, 0) angle 0 velocity (_, 0) rate 0; }

        /// Enters a steady corner at held speed.
        scene cornering { start held; until 5 s; with linear_tyres, cruise; }
        /// The same on tyres with a relaxation length.
        scene relaxing { start held; until 5 s; with relaxing_tyres, cruise; }
        /// The same on tyres that level off.
        scene limit { start held; until 5 s; with limited_tyres, cruise; }
        /// Rolls round a corner under a steady thrust.
        scene thrust { start straight; until 20 s; with limited_tyres, thrust; }
    }
}
