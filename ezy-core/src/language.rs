//! `model!` and its manual.

/// Turns a mechanism into equations of motion while the crate compiles.
///
/// A model is written as its problem statement reads: what there is, what connects it, what acts on it, and which scenes are to
/// be run. Faults of the model are compile errors on the word to change. This page is `docs/language.md` of the repository, without its
/// pictures; other pages that it names are in `docs`, too.
///
/// # What it emits
///
/// `model Cart { … }`, as below, becomes a module `cart` that holds
/// - a type for each scene, `cart::Free` and `cart::Pushed`, with its parameters and counts as fields and their declared values as
///   [`Default`]; it implements [`Scene`](crate::model::Scene), so that [`Simulation`](crate::simulate::Simulation) runs it. A
///   scene has the equations of what it calls for: `cart::Free` has no field `f` and no instruction of `push`;
/// - its names: `cart::names` has bodies, inputs and outputs as fields, for [controllers](crate::simulate::Simulation::control);
///   `cart::events` has the names of events as constants;
/// - `cart::MODEL`, the [`ModelInfo`](crate::model::ModelInfo) that command lines and
///   [`check_model`](crate::testing::check_model) take.
///
/// # The language
///
// only pages of documentation hold it; its programs are tests of `ezy-tests`
#[cfg_attr(all(doc, not(doctest)), doc = include_str!("language.md"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __model {
    ($($model:tt)*) => {
        $crate::__private::derive_model! { $crate $($model)* }
    };
}
