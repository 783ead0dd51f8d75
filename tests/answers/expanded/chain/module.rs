///Rods in a row, hung from one end.
#[allow(non_snake_case, unused_variables, clippy::all, clippy::pedantic)]
pub mod chain {}
use ::ezy_core::__private as ezy;
/// The model and its scenes.
pub static MODEL: ezy::ModelInfo = ezy::ModelInfo {
    name: "Chain",
    documentation: "Rods in a row, hung from one end.",
    effects: &[
        ezy::EffectInfo {
            name: "friction_in_hinges",
            documentation: "Every hinge resists its rate.",
        },
    ],
    scenes: &[
        ezy::SceneEntry {
            name: "swing",
            info: || ezy::Scene::info(&<Swing as ::core::default::Default>::default()),
            new: || ::std::boxed::Box::new(
                <Swing as ::core::default::Default>::default(),
            ),
        },
        ezy::SceneEntry {
            name: "settle",
            info: || ezy::Scene::info(&<Settle as ::core::default::Default>::default()),
            new: || ::std::boxed::Box::new(
                <Settle as ::core::default::Default>::default(),
            ),
        },
    ],
};
