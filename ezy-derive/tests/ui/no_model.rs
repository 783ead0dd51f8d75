//! No model at all.

ezy_derive::model! {}

ezy_derive::model! {
    pub model Empty {}
}

ezy_derive::model! {
    pub model {}
}

fn main() {}

// stands for ezy-core, which these tests do without
extern crate self as ezy_core;
#[macro_export]
macro_rules! faulty_model {
    ($($model:tt)*) => {};
}
