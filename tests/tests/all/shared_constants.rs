//! The macro does not depend on the crate that it writes for, so some constants stand in both.

use std::fs;
use std::path::Path;

/// What a pivot counts as vanished below, in how large groups sums of products are padded, and which matrices are listed
/// by rows.
const SHARED: [&str; 3] = ["PIVOT_TOLERANCE", "PRODUCT_GROUP", "WIDEST_MATRIX"];

/// What a crate says of a constant: type and value, each time it is defined.
fn definitions(folder: &Path, name: &str) -> Vec<String> {
    let begin = format!("const {name}: ");
    let mut found = Vec::new();
    for path in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        if path.is_dir() {
            found.extend(definitions(&path, name));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            let text = fs::read_to_string(&path).unwrap();
            found.extend(text.lines().filter_map(|line| Some(line.split_once(&begin)?.1.to_owned())));
        }
    }
    found
}

#[test]
fn cross_constants_of_macro_and_core_agree() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    for name in SHARED {
        let [derive, core] = ["ezy-derive/src", "ezy-core/src"].map(|source| definitions(&root.join(source), name));
        assert_eq!((derive.len(), &derive), (1, &core), "{name} is defined once in each crate, and alike");
    }
}
