//! No model at all.

ezy_core::model! {}

ezy_core::model! {
    pub model Empty {}
}

ezy_core::model! {
    pub model {}
}

fn main() {}

// stands for ezy-core, without a macro of its own: rustc would point into it, as it does not where that is another crate
extern crate self as ezy_core;
pub use ezy_derive::model;
#[macro_export]
macro_rules! faulty_model {
    ($($model:tt)*) => {};
}
pub mod __private {
    pub use crate::faulty_model;
}
