//! A crate that is a Python module: what `ezy new --python` writes.

/// The files, with the model that every new crate starts from.
pub(super) const FILES: [(&str, &str); 9] = [
    ("Cargo.toml", include_str!("../../template/python/manifest.toml")),
    ("pyproject.toml", include_str!("../../template/python/pyproject.toml")),
    ("README.md", include_str!("../../template/python/README.md")),
    (".gitignore", include_str!("../../template/python/gitignore")),
    ("src/lib.rs", include_str!("../../template/python/src/lib.rs")),
    ("src/main.rs", include_str!("../../template/python/src/main.rs")),
    super::MODEL,
    ("my_mechanism.pyi", include_str!("../../template/python/my_mechanism.pyi")),
    ("tests/test_my_mechanism.py", include_str!("../../template/python/tests/test_my_mechanism.py")),
];

/// What to do with them.
pub(super) const NEXT: &str = "\
pip install -v \".[test]\"                 # builds the module; -v shows how far it is
python -c \"import my_mechanism; print(my_mechanism.coast().run())\"
python -m pytest                         # equations against finite differences, names, types
cargo run -- list                        # its scenes, on the command line
";

/// Modules of Python's library from 3.10 on, its keywords, and what a Python module of EZY uses: a test in Python compares.
const TAKEN: &str = include_str!("taken_by_python.txt");

/// Says why Python cannot import a module of this name, and how to mend it.
pub(super) fn check_name(name: &str) -> Result<(), String> {
    let module = name.replace('-', "_");
    if TAKEN.split_whitespace().any(|taken| taken == module) {
        return Err(format!(
            "Python cannot import a module `{module}` of yours: the name is a word or module of Python's own, or one that EZY's modules \
             use; choose another, such as `my-{name}`"
        ));
    }
    Ok(())
}
