//! The layers of `ezy-core` import only what is below them.

use std::path::{Path, PathBuf};

/// Each layer and what it may import.
const LAYERS: [(&str, &[&str]); 7] = [
    ("model.rs", &[]),
    ("linalg", &["model"]),
    ("dynamics", &["model", "linalg"]),
    ("integrate", &["model", "linalg", "dynamics"]),
    ("record", &["model"]),
    ("simulate", &["model", "linalg", "dynamics", "integrate", "record"]),
    ("report", &["model", "record"]),
];

/// All files of a layer.
fn files(path: &Path) -> Vec<PathBuf> {
    if path.is_file() {
        return vec![path.to_owned()];
    }
    let entries = std::fs::read_dir(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    entries.flat_map(|entry| files(&entry.expect("an entry of the folder").path())).collect()
}

#[test]
fn invariant_layers_import_only_what_is_below_them() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("../ezy-core/src");
    for (layer, allowed) in LAYERS {
        for file in files(&source.join(layer)) {
            let text = std::fs::read_to_string(&file).expect("a source file");
            let code = text.lines().filter(|line| !line.trim_start().starts_with("//"));
            for import in code.filter_map(|line| line.split_once("crate::").map(|(_, path)| path)) {
                let module: String = import.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
                let own = module == layer.trim_end_matches(".rs");
                assert!(own || allowed.contains(&module.as_str()), "{} imports {module}", file.display());
            }
        }
    }
}
