///Rods in a row, hung from one end.
#[allow(non_snake_case, unused_variables, clippy::all, clippy::pedantic)]
pub mod chain {}
/// The model and its scenes.
pub static MODEL: ::ezy_core::model::ModelInfo = ::ezy_core::model::ModelInfo {
    name: "Chain",
    documentation: "Rods in a row, hung from one end.",
    effects: &[
        ::ezy_core::model::EffectInfo {
            name: "friction_in_hinges",
            documentation: "Every hinge resists its rate.",
        },
    ],
    scenes: &[
        ::ezy_core::model::SceneEntry {
            name: "swing",
            info: || ::ezy_core::model::Scene::info(
                &<Swing as ::core::default::Default>::default(),
            ),
            new: || ::std::boxed::Box::new(
                <Swing as ::core::default::Default>::default(),
            ),
        },
        ::ezy_core::model::SceneEntry {
            name: "settle",
            info: || ::ezy_core::model::Scene::info(
                &<Settle as ::core::default::Default>::default(),
            ),
            new: || ::std::boxed::Box::new(
                <Settle as ::core::default::Default>::default(),
            ),
        },
    ],
};
