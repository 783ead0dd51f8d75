//! Every scene ends well as it is declared.

use crate::{ezy, text};
use ezy_models::registry::MODELS;

#[test]
fn invariant_every_scene_runs_without_options() {
    for (model, scene) in MODELS.iter().flat_map(|model| model.scenes.iter().map(move |scene| (model, scene))) {
        let path = format!("{}/{}", model.name, scene.name);
        let done = ezy(&["run", &path, "--json"]);
        let message = text(&done.stderr);
        assert_eq!(done.status.code(), Some(0), "{path}: {message}");
        let told: serde_json::Value = serde_json::from_slice(&done.stdout).expect("JSON");
        assert_eq!(told["method"], "dop853", "{path}");
        // stiff ones may be told so, but none is left out or distrusted
        let outcome = told["outcome"].as_str().expect("text");
        assert!(outcome.starts_with("reached"), "{path}: {outcome}");
        assert!(!outcome.contains("not to be trusted"), "{path}: {outcome}");
        let energy = &told["monitors"]["energy"];
        assert!(energy.is_object(), "{path}: {energy}");
    }
}
