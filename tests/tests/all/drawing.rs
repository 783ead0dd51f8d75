//! What a picture shows of a scene is where its equations have it: every scene of every model, at a moved state.

use ezy_core::integrate::Method;
use ezy_core::model::{Scene, SceneInfo};
use ezy_core_tests::simulation;
use ezy_models::registry::MODELS;
use ezy_study::report::drawing::{Drawing, Elements, Placed, sketch, sketch_within};

/// Rounding of positions of some metres.
const ROUNDING: f64 = 1e-9;

/// Every scene with its state after some steps.
fn each(mut check: impl FnMut(&str, &dyn Scene, &SceneInfo, f64, &[f64], &[f64])) {
    for model in MODELS {
        for entry in model.scenes {
            let scene = (entry.new)();
            let info = scene.info();
            let run = simulation(scene.as_ref())
                .method(Method::rk4(1e-3))
                .until(0.01 * info.until_s)
                .max_steps(200)
                .run()
                .unwrap();
            let last = run.last();
            check(
                &format!("{}/{}", model.name, entry.name),
                scene.as_ref(),
                &info,
                last.t,
                last.coordinates,
                last.velocities,
            );
        }
    }
}

fn placed(scene: &dyn Scene, t: f64, q: &[f64], v: &[f64]) -> (Elements, Placed) {
    let elements = Elements::new(scene);
    let at = elements.at(scene, t, q, v);
    (elements, at)
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

#[test]
fn cross_points_of_a_picture_are_the_named_points_of_the_scene() {
    each(|path, scene, info, t, q, v| {
        let (elements, at) = placed(scene, t, q, v);
        let mut points = vec![0.0; 2 * info.points.len()];
        scene.points(elements.constants(), t, q, &mut points);
        for (k, point) in info.points.iter().enumerate() {
            let is_named = |kind: &str, name: &str| matches!(kind, "point" | "hinge") && name == point.name;
            let (i, _) = elements.iter().find(|(_, element)| is_named(element.kind, &element.name)).unwrap();
            let error = distance(at.position(elements.point(i, 0)), [points[2 * k], points[2 * k + 1]]);
            assert!(error < ROUNDING, "{path}: {} is off by {error:e} m", point.name);
        }
    });
}

#[test]
fn invariant_hinges_and_welds_of_a_picture_join_both_bodies() {
    let mut seen = 0;
    each(|path, scene, info, t, q, v| {
        let (elements, at) = placed(scene, t, q, v);
        for (i, element) in elements.iter().filter(|(_, element)| matches!(element.kind, "hinge" | "weld")) {
            let gap = distance(at.position(elements.point(i, 0)), at.position(elements.point(i, 1)));
            assert!(gap < ROUNDING, "{path}: {} is open by {gap:e} m", element.name);
            seen += 1;
        }
        assert!(
            elements.iter().all(|(_, element)| element.points.iter().all(|point| point.body < Some(info.bodies.len())))
        );
    });
    assert!(seen > 100, "{seen}");
}

/// A skate states n · ṙ = 0: the entries of its row at x and y of the body are n.
#[test]
fn cross_skates_of_a_picture_point_along_their_rows() {
    let mut seen = 0;
    each(|path, scene, info, t, q, v| {
        let (elements, at) = placed(scene, t, q, v);
        let mut jacobian = vec![0.0; info.jacobian.n_nonzeros()];
        scene.velocity_jacobian(elements.constants(), t, q, &mut jacobian);
        for (i, element) in elements.iter().filter(|(_, element)| element.kind == "skate") {
            let row = info.rows.iter().position(|row| row.name == element.name).unwrap();
            let body = element.points[0].body.unwrap();
            let mut normal = [0.0; 2];
            let entries =
                info.jacobian.entries().filter(|&(_, r, column)| r == row && column / 3 == body && column % 3 < 2);
            entries.for_each(|(k, _, column)| normal[column % 3] += jacobian[k]);
            let along = at.direction(elements.direction(i, 0));
            let length = along[0].hypot(along[1]);
            let error = (along[0] * normal[0] + along[1] * normal[1]).abs() / length;
            assert!(
                error < ROUNDING && (normal[0].hypot(normal[1]) - 1.0).abs() < ROUNDING,
                "{path}: {} {error:e}",
                element.name
            );
            seen += 1;
        }
    });
    assert!(seen > 30, "{seen}");
}

/// The applied force on a body is the sum of its elements where all of them are drawn.
#[test]
fn cross_force_of_a_tyre_is_the_applied_force() {
    let scene = ezy_models::single_track_car::MODEL.scenes[0];
    let scene = (scene.new)();
    let run = simulation(scene.as_ref()).method(Method::rk4(1e-3)).until(0.5).run().unwrap();
    let last = run.last();
    let (elements, at) = placed(scene.as_ref(), last.t, last.coordinates, last.velocities);
    let mut force = vec![0.0; last.coordinates.len()];
    scene.applied_force(elements.constants(), last.t, last.coordinates, last.velocities, &mut force);
    let mut sum = [0.0; 2];
    for (i, element) in elements.iter().filter(|(_, element)| element.load.is_some()) {
        assert_eq!(element.kind, "tyre");
        let first = elements.load(i);
        sum = [sum[0] + at.values[first], sum[1] + at.values[first + 1]];
    }
    assert!(distance(sum, [force[0], force[1]]) < 1e-9 * force[0].hypot(force[1]), "{sum:?} {force:?}");
}

#[test]
fn invariant_every_scene_has_a_sketch_with_a_part_for_each_body() {
    each(|path, scene, info, t, q, v| {
        let (elements, at) = placed(scene, t, q, v);
        let drawing = Drawing::new(scene, elements, &at, &[], None);
        for body in info.bodies.iter() {
            assert!(drawing.parts.iter().any(|part| part.title == *body), "{path}: no {body}");
        }
        let run = simulation(scene).until(0.0).run().unwrap();
        let svg = sketch(scene, &run.last());
        assert!(svg.starts_with("<svg") && svg.ends_with("</svg>\n"), "{path}");
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{path}: {svg}");
        assert_eq!(svg.matches("<g ").count(), svg.matches("</g>").count(), "{path}");
    });
}

/// Of the gallery.
const SMALL: [f64; 2] = [450.0, 500.0];

#[test]
fn invariant_small_sketches_keep_their_letters_and_fit() {
    each(|path, scene, _, _, _, _| {
        let run = simulation(scene).until(0.0).run().unwrap();
        let svg = sketch_within(scene, &run.last(), SMALL);
        let side = |name: &str| -> f64 {
            let rest = svg.split_once(&format!(" {name}=\"")).unwrap().1;
            rest.split('"').next().unwrap().parse().unwrap()
        };
        assert!(
            side("width") <= SMALL[0] && side("height") <= SMALL[1],
            "{path}: {} x {}",
            side("width"),
            side("height")
        );
        assert!(svg.contains(".ezy { font: 15px/1") && svg.contains("<text "), "{path}");
    });
}

#[test]
fn invariant_script_of_the_page_names_elements_that_the_page_has() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../ezy-cli/src/animate");
    let read = |name: &str| std::fs::read_to_string(folder.join(name)).unwrap();
    let (page, script) = (read("page.html"), read("page.js"));
    let names = script.split("$(\"").skip(1).filter_map(|rest| rest.split('"').next());
    let missing: Vec<&str> = names.filter(|name| !page.contains(&format!("id=\"{name}\""))).collect();
    assert!(missing.is_empty(), "{missing:?}");
}
