///A seat on a rear wheel, steered and driven by swinging a front bar on its own wheel.
#[allow(non_snake_case, unused_variables, clippy::all, clippy::pedantic)]
pub mod ezy_roller {}
use ::ezy_core::__private as ezy;
/// The model and its scenes.
pub static MODEL: ezy::ModelInfo = ezy::ModelInfo {
    name: "EzyRoller",
    documentation: "A seat on a rear wheel, steered and driven by swinging a front bar on its own wheel.",
    effects: &[
        ezy::EffectInfo {
            name: "pump",
            documentation: "The rider swings the bar: a torque between seat and bar.",
        },
        ezy::EffectInfo {
            name: "rolling_resistance",
            documentation: "Drag of the rear wheel, proportional to its speed.",
        },
        ezy::EffectInfo {
            name: "slip",
            documentation: "The rear wheel lets go: a side force against its slip replaces the skate.",
        },
        ezy::EffectInfo {
            name: "ice",
            documentation: "The rear wheel on ice: it holds sideways up to a force and slides beyond it, with that force as friction.",
        },
        ezy::EffectInfo {
            name: "rider",
            documentation: "The rider's arms, moved by whoever runs the scene.",
        },
    ],
    scenes: &[
        ezy::SceneEntry {
            name: "coast",
            info: || ezy::Scene::info(&<Coast as ::core::default::Default>::default()),
            new: || ::std::boxed::Box::new(
                <Coast as ::core::default::Default>::default(),
            ),
        },
        ezy::SceneEntry {
            name: "driven",
            info: || ezy::Scene::info(&<Driven as ::core::default::Default>::default()),
            new: || ::std::boxed::Box::new(
                <Driven as ::core::default::Default>::default(),
            ),
        },
        ezy::SceneEntry {
            name: "driven_on_tarmac",
            info: || ezy::Scene::info(
                &<DrivenOnTarmac as ::core::default::Default>::default(),
            ),
            new: || ::std::boxed::Box::new(
                <DrivenOnTarmac as ::core::default::Default>::default(),
            ),
        },
        ezy::SceneEntry {
            name: "drift",
            info: || ezy::Scene::info(&<Drift as ::core::default::Default>::default()),
            new: || ::std::boxed::Box::new(
                <Drift as ::core::default::Default>::default(),
            ),
        },
        ezy::SceneEntry {
            name: "skid",
            info: || ezy::Scene::info(&<Skid as ::core::default::Default>::default()),
            new: || ::std::boxed::Box::new(<Skid as ::core::default::Default>::default()),
        },
        ezy::SceneEntry {
            name: "ridden",
            info: || ezy::Scene::info(&<Ridden as ::core::default::Default>::default()),
            new: || ::std::boxed::Box::new(
                <Ridden as ::core::default::Default>::default(),
            ),
        },
    ],
};
