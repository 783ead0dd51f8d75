//! `model!` and its manual.

/// Turns a mechanism into equations of motion while the crate compiles.
///
/// A model is written as its problem statement reads: what there is, what connects it, what acts on it, and which scenes are to
/// be run. Faults of the model are compile errors on the word to change. This page shows each kind of item; the manual is
/// `docs/language.md`, the compile errors are in `docs/compile-errors.md`, signs and symbols in `docs/notation.md`.
///
/// ```
/// use ezy_core::prelude::*;
///
/// model! {
///     /// A cart on a rail, held by a spring and pushed.
///     pub model Cart {
///         /// stiffness
///         param k: N/m = 40.0;
///         param m: kg = 2.0;
///
///         body cart { mass: m, inertia: m * (0.1)^2 }
///         slider rail: ground(0, 0) ~ cart(0, 0) along ground(1, 0);
///         spring ground(0, 0) ~ cart(0, 0): stiffness k, damping 0.5;
///
///         /// A force that swells and fades.
///         effect push {
///             param f: N = 3.0;
///             force at cart(0, 0): (f * sin(2 * t), 0);
///         }
///
///         start aside { cart x 0.2; at rest; }
///         scene free { start aside; until 5 s; }
///         scene pushed { start aside; until 5 s; with push; }
///     }
/// }
///
/// let scene = cart::Pushed { f: 5.0, ..Default::default() };
/// let run = Simulation::new(&scene).run()?;
/// assert_eq!(run.last().t, 5.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # What it emits
///
/// `model Cart { … }` becomes a module `cart` that holds
/// - a type for each scene, `cart::Free` and `cart::Pushed`, with its parameters and counts as fields and their declared values as
///   [`Default`]; it implements [`Scene`](crate::model::Scene), so that [`Simulation`](crate::simulate::Simulation) runs it. A
///   scene has the equations of what it calls for: `cart::Free` has no field `f` and no instruction of `push`;
/// - its names: `cart::names` has bodies, inputs and outputs as fields, for [controllers](crate::simulate::Simulation::control);
///   `cart::events` has the names of events as constants;
/// - `cart::MODEL`, the [`ModelInfo`](crate::model::ModelInfo) that command lines and
///   [`check_model`](crate::testing::check_model) take.
///
/// Items may stand in any order; coordinates and rows keep the order in which they are declared. A doc comment before an item
/// goes into the generated documentation.
///
/// # Parameters, values, inputs, outputs
///
/// ```
/// # use ezy_core::model;
/// # model! { model M {
/// /// a number that a run can change; the unit may be left out
/// param l: mm = 300;
/// let half = l / 2;                  // a name for an expression, scalar or vector
/// input torque: N*m = 0;             // set from step to step: `.control(|now, set| set.torque = -now.arm.phi)`
/// output angle: deg = arm.phi;       // recorded when a run asks for outputs
/// # body arm { mass: 1, inertia: 1 } hinge o: ground(0, 0) ~ arm(-half, 0); torque arm: torque;
/// # start s { at rest; } scene run { start s; until 1 s; } } }
/// ```
///
/// # Bodies and points
///
/// ```
/// # use ezy_core::model;
/// # model! { model M {
/// body bar { mass: 2.0, inertia: 0.05 }       // inertia about the centre of mass
/// point tip = bar(0.4, 0);                    // in the axes of the body, from its centre of mass
/// rod string: ground(0, 1) ~ tip length 0.8;  // `ground` is a body that does not move
/// # start s { bar near at (0, 0.2) angle 0; at rest; } scene run { start s; until 1 s; } } }
/// ```
///
/// # Joints and other constraints
///
/// A constraint has a name; its multiplier is the force that it needs. Position constraints are `hinge`, `slider`, `slot`, `rod`,
/// `weld`, `gear`, `drive` and `constraint`; velocity constraints are `skate`, `roll` and `velocity constraint`.
///
/// ```
/// # use ezy_core::model;
/// # model! { model M {
/// # body crank { mass: 1, inertia: 0.1 } body coupler { mass: 1, inertia: 0.1 } body piston { mass: 1, inertia: 0.1 }
/// hinge shaft: ground(0, 0) ~ crank(0, 0);
/// hinge pin: crank(0.2, 0) ~ coupler(-0.3, 0);
/// hinge wrist: coupler(0.3, 0) ~ piston(0, 0);
/// slider guide: ground(0, 0) ~ piston(0, 0) along ground(1, 0);
/// drive motor: shaft.angle = 3 * t;                  // an angle, a distance or a coordinate as a function of time
/// # start s { crank angle 0; coupler near at (0.5, 0) angle 0; } scene run { start s; until 1 s; } } }
/// # model! { model N {
/// # body seat { mass: 1, inertia: 0.1 }
/// skate wheel: at seat(-0.2, 0) along seat(1, 0);    // a wheel that does not slip sideways
/// # start s { seat at (0, 0) angle 0 velocity (1, 0); } scene run { start s; until 1 s; } } }
/// ```
///
/// # Forces
///
/// ```
/// # use ezy_core::model;
/// # model! { model M {
/// # body a { mass: 1, inertia: 0.1 } body b { mass: 1, inertia: 0.1 } hinge o: ground(0, 0) ~ a(0, 0); hinge p: a(1, 0) ~ b(0, 0);
/// gravity (0, -9.81);
/// torque a ~ b: 2 * sin(3 * t);                      // on `a`, with the reaction on `b`
/// force at b(1, 0) along b(0, 1): -0.4;
/// spring ground(2, 0) ~ b(1, 0): stiffness 30, length 1, damping 0.2;
/// drag at b(0, 0): quadratic 0.3;
/// friction ground ~ a: torque 0.1, rate 0.01;
/// # start s { a angle 0; b angle 0; at rest; } scene run { start s; until 1 s; } } }
/// ```
///
/// Also `damper`, `torsion` and `tyre`. An expression knows `+ - * / ^`, `pi`, `t`, the parameters, the inputs, and of a body
/// `.x .y .phi .vx .vy .omega` and the vectors `.r .v`; of a hinge also `.angle .rate`; functions are `sin`, `sqrt`, `atan2`,
/// `norm`, `smooth_step` and others. Units are compared wherever both sides have one.
///
/// # Effects
///
/// An effect holds parameters, constraints and forces that only some scenes have; `release` leaves a constraint out.
///
/// ```
/// # use ezy_core::model;
/// # model! { model M {
/// # body seat { mass: 1, inertia: 0.1 } skate rear: at seat(-0.2, 0) along seat(1, 0);
/// effect ice {
///     param mu: N = 4;
///     release rear;
///     friction at seat(-0.2, 0) along seat(0, 1): force mu, speed 0.01;
/// }
/// # start s { seat at (0, 0) angle 0 velocity (1, 0) rate 0; }
/// scene grips { start s; until 1 s; }
/// scene slides { start s; until 1 s; with ice; }
/// # } }
/// ```
///
/// # Starts and scenes
///
/// What a start does not give is assembled from the constraints. `near` gives a value that may give way.
///
/// ```
/// # use ezy_core::model;
/// # model! { model M {
/// # body bar { mass: 1, inertia: 0.1 } body arm { mass: 1, inertia: 0.1 } hinge o: bar(1, 0) ~ arm(-1, 0);
/// start thrown { bar at (0, 0) angle 0 velocity (2, 3) rate 1; arm near angle 0.5; }
/// scene flight { start thrown; until 2 s; until bar.y < 0; }   // 2 s at most
/// # } }
/// ```
///
/// # Events and stops
///
/// ```
/// # use ezy_core::model;
/// # model! { model M {
/// # body ball { mass: 1, inertia: 0.1 }
/// event top: ball.vy = 0;                     // located to 1e-12 s and recorded
/// stop floor: ball.y from 0 restitution 0.8;  // an impact there
/// # gravity (0, -9.81); start s { ball at (0, 1) angle 0; at rest; } scene run { start s; until 1 s; } } }
/// ```
///
/// A skate with `limit f` slides where it would need more than f.
///
/// # Repeating
///
/// ```
/// # use ezy_core::model;
/// # model! { model M {
/// count n = 10;                               // a number of the run, and a field of the scene
/// body link[n] { mass: 1, inertia: 1/12 }
/// hinge top: ground(0, 0) ~ link[0](-0.5, 0);
/// for i in 1..n { hinge pin[i]: link[i-1](0.5, 0) ~ link[i](-0.5, 0); }
/// # start s { for i in 0..n { link[i] angle 0; } at rest; } scene run { start s; until 1 s; } } }
/// ```
#[doc(hidden)]
#[macro_export]
macro_rules! __model {
    ($($model:tt)*) => {
        $crate::__private::derive_model! { $crate $($model)* }
    };
}
