//! No model at all.

ezy_derive::model! {}

ezy_derive::model! {
    pub model Empty {}
}

ezy_derive::model! {
    pub model {}
}

fn main() {}
