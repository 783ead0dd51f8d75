//! From the resolved model to the equations of one scene.
//!
//! Each kind of row and each kind of force states its expression once (`rows/`, `forces/`). Everything else is
//! derived from those by the symbolic engine: Jacobians, convective terms, generalised forces, power, and the
//! elimination. Only what the scene calls for is ever written down.

mod block;
pub mod check;
mod constraints;
pub mod derived;
pub mod elements;
mod elimination;
mod event;
mod expression;
mod forces;
pub mod jacobians;
pub mod kernels;
mod kinematics;
mod lets;
pub mod powers;
mod programs;
pub mod quasi;
mod rows;
pub mod scene;
pub mod series;
pub mod solve;
mod stop;
pub mod symbols;
mod templates;
#[cfg(test)]
mod tests;

pub use derived::Derived;
pub use event::{EventKind, SceneEvent};
pub use rows::ScalarRow;
pub use scene::{Equations, Group};
pub use templates::{EventTemplate, ForceTemplate, Item, OutputTemplate, PointTemplate, RowTemplate, Templates};
