//! Only what a scene calls for is simulated: a scene of the EzyRoller is what a model written for it alone is.

use ezy_core::integrate::Method;
use ezy_core::model::{Operations, Scene, SceneInfo};
use ezy_core_tests::plain_rollers::{coasting, drifting, pumped};
use ezy_core_tests::simulation;
use ezy_models::ezy_roller;
use ezy_tests::page::{docs, part, write_part};
use ezy_tests::piloted::{piloted, unpiloted};

/// Scenes of the EzyRoller, each beside the model without what it leaves out: effects, parameters, releases, inputs.
fn pairs() -> [(Box<dyn Scene>, Box<dyn Scene>); 4] {
    [
        (Box::new(ezy_roller::Coast::default()), Box::new(coasting::Coast::default())),
        (Box::new(ezy_roller::Driven::default()), Box::new(pumped::Driven::default())),
        (Box::new(ezy_roller::Drift::default()), Box::new(drifting::Drift::default())),
        (Box::new(piloted::Coast::default()), Box::new(unpiloted::Coast::default())),
    ]
}

#[test]
fn invariant_scene_costs_what_the_model_without_the_rest_costs() {
    for (scene, alone) in pairs() {
        let (scene, alone) = (scene.info(), alone.info());
        assert_eq!(scene.acceleration_operations, alone.acceleration_operations, "{}", scene.name);
        assert_eq!(scene.correction_operations, alone.correction_operations, "{}", scene.name);
        assert_eq!(scene.n_constants, alone.n_constants, "{}", scene.name);
    }
}

#[test]
fn invariant_scene_has_the_parameters_of_the_model_without_the_rest() {
    for (scene, alone) in pairs() {
        let names = |info: &SceneInfo| info.parameters.iter().map(|p| (p.name, p.default)).collect::<Vec<_>>();
        assert_eq!(names(&scene.info()), names(&alone.info()));
        assert_eq!(size_of_val(&*scene), size_of_val(&*alone));
    }
    assert_eq!(size_of::<ezy_roller::Coast>(), 8 * size_of::<f64>());
}

#[test]
fn invariant_scene_moves_bit_for_bit_like_the_model_without_the_rest() {
    for (scene, alone) in pairs() {
        let bits = |scene: &dyn Scene| {
            let run = simulation(scene).method(Method::rk4(1e-3)).until(1.0).every(0.1).run().expect("the scene runs");
            let samples = run.samples().map(|s| [s.coordinates, s.velocities, s.accelerations, s.multipliers].concat());
            samples.flatten().map(f64::to_bits).collect::<Vec<_>>()
        };
        assert!(bits(&*scene) == bits(&*alone), "{}", scene.info().name);
    }
}

/// `UPDATE_GOLDEN=1 cargo test --test all regress_cost` writes the table anew.
#[test]
fn regress_cost_of_the_scenes_is_the_table_of_the_page() {
    let mut now = "| scene | effects | mul | add | div | sin and cos | other functions |\n".to_owned();
    now += "|---|---:|---:|---:|---:|---:|---:|\n";
    for entry in ezy_roller::MODEL.scenes {
        let info = (entry.info)();
        let Operations { mul, add, div, trig, calls } = info.acceleration_operations;
        now += &format!("| `{}` | {} | {mul} | {add} | {div} | {trig} | {calls} |\n", info.name, info.n_effects());
    }
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        write_part("cost.md", "operations", &now).expect("the page can be written");
    }
    let page = std::fs::read_to_string(docs("cost.md")).expect("the page is there");
    assert_eq!(part(&page, "operations"), Some(now.as_str()), "docs/cost.md is out of date; see UPDATE_GOLDEN");
}
