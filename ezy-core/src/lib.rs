//! Planar mechanisms with constraints: the equations are derived while the crate compiles, the motion is computed from them.
//!
//! ```
//! use ezy_core::prelude::*;
//!
//! model! {
//!     /// A rod that swings about one end.
//!     pub model Pendulum {
//!         param l: m = 0.5;
//!         param mass: kg = 2.0;
//!         body rod { mass: mass, inertia: mass*l^2/12 }
//!         hinge pivot: ground(0, 0) ~ rod(-l/2, 0);
//!         gravity (0, -9.81);
//!         start level { rod angle 0; at rest; }
//!         scene swing { start level; until 2 s; }
//!     }
//! }
//!
//! fn main() -> Result<(), Box<dyn std::error::Error>> {
//!     let scene = pendulum::Swing { l: 0.8, ..Default::default() };
//!     let run = Simulation::new(&scene).method(Method::dop853(1e-9)).every(0.01).run()?;
//!     assert!(run.outcome.reached_end());
//!     let highest = run.samples().map(|sample| sample.coordinates[1]).fold(f64::MIN, f64::max);
//!     assert!(highest < 1e-6, "it does not rise above its start");
//!     println!("at {} s: {:.4} rad", run.last().t, run.last().get("rod.phi")?);
//!     check_scene(&scene)?;
//!     Ok(())
//! }
//! ```
//!
//! # Five things to know
//!
//! | | |
//! |---|---|
//! | [`model!`] | declares bodies, constraints, forces and scenes; its page shows the language |
//! | a scene, such as `pendulum::Swing` | a struct with the parameters as fields; implements [`Scene`](model::Scene) |
//! | [`Simulation`](simulate::Simulation) | orders a run: method, end, inputs, start values, what is recorded |
//! | [`Run`](simulate::Run) | how it ended, its samples, events and monitors |
//! | [`check_scene`](testing::check_scene) | compares Jacobians, solvers and energy with independent computations, in a test |
//!
//! [`prelude`] has these and what they take: [`Method`](integrate::Method), [`CsvWriter`](record::CsvWriter),
//! [`InputTable`](simulate::InputTable). A controller is a law, `.control(|now, set| set.torque = -now.arm.phi)`
//! ([`Simulation::control`](simulate::Simulation::control)), or steps by itself ([`Simulation::stepper`](simulate::Simulation::stepper)).
//!
//! # Beyond that
//!
//! - With the crate `ezy-cli`, `ezy_cli::main(&[&pendulum::MODEL])` is a command line of your models: `list`, `show`, `run`,
//!   `animate`, `sketch`, `check`, `accuracy`.
//! - [`simulate::Ensemble`] runs many scenes at once; [`simulate::Sensitivities`] gives derivatives of a run.
//! - The crate `ezy-study` runs thousands of cases on all cores, into files that survive a kill, measures what accuracy costs, prints
//!   tables, plots and draws the mechanism.
//! - With the feature `analysis`, `dynamics::Gradients` gives exact derivatives of the equations of motion, of the rows and of the
//!   outputs by positions, velocities, first-order states, inputs and parameters.
//! - With the feature `analysis`, `analysis::SteadyMotion` finds rest and steady motions, and `analysis::Linearization` their linear
//!   equations and eigenvalues.
//! - With the feature `export`, `export::source` writes the equations of a scene in C, Python (NumPy, SymPy, CasADi), Julia or MATLAB.
//! - With the feature `optimise`, `optimise::Fit` finds parameters from measurements and `optimise::Search` the best ones.
//! - [`dynamics::System`] answers for one state: accelerations, multipliers, projections, energies.
//!
//! # Layers
//!
//! Each knows only those on its left: `scalar ← model ← linalg ← dynamics ← integrate ← simulate` and
//! `model ← record ← simulate`.

#![warn(unreachable_pub)]
// who works on this crate reads the links to what is private
#![allow(rustdoc::private_intra_doc_links)]

#[doc(hidden)]
pub mod __private;
mod access_to_numbers;
#[cfg(feature = "analysis")]
pub mod analysis;
mod archive;
pub mod dynamics;
#[cfg(feature = "export")]
pub mod export;
mod faulty;
pub mod integrate;
mod kernel;
mod language;
mod layout;
pub mod linalg;
#[allow(unsafe_code, reason = "instructions that the processor has, as was asked or is always so")]
mod machine;
mod memory;
pub mod model;
#[cfg(feature = "optimise")]
pub mod optimise;
#[allow(unsafe_code, reason = "advice to the operating system, which changes nothing that is stored")]
mod pages;
pub mod record;
pub mod scalar;
pub mod simulate;
pub mod testing;

#[doc(inline)]
pub use __model as model;

/// What a program that runs scenes needs.
pub mod prelude {
    #[doc(inline)]
    pub use crate::__model as model;
    pub use crate::dynamics::{Metric, Projection, State, System};
    pub use crate::integrate::{Method, MethodKind, Tolerance};
    pub use crate::linalg::Backend;
    pub use crate::model::{Derived, Equations, ModelInfo, Scene};
    pub use crate::record::{CsvWriter, RecordError, Recorder, Sample, coordinate_index, input_index, output_index};
    pub use crate::simulate::{
        EightSteppers, Ensemble, InputTable, Inputs, Now, Outcome, Run, Sensitivities, Simulation, Stepper, read_inputs,
    };
    pub use crate::testing::{check_model, check_scene};
}

/// The program of the README, run as a documentation test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub mod readme {}
