//! What is published carries what a package needs: licence texts, a README, metadata. Manifests name what is used and nothing else,
//! and the oldest compiler has one number everywhere.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Packages that are published, in the order in which that is done.
const PUBLISHED: [&str; 5] = ["ezy-derive", "ezy-core", "ezy-study", "ezy-cli", "models"];

/// Those of the workspace.
const MEMBERS: [&str; 6] = ["ezy-derive", "ezy-core", "ezy-study", "ezy-cli", "models", "tests"];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn read(path: impl AsRef<Path>) -> String {
    fs::read_to_string(root().join(&path)).unwrap_or_else(|error| panic!("{}: {error}", path.as_ref().display()))
}

/// Keys and values of a table of a manifest, as they are written.
fn table(manifest: &str, name: &str) -> Vec<(String, String)> {
    let lines = manifest.lines().skip_while(|line| line.trim() != format!("[{name}]")).skip(1);
    let lines = lines.take_while(|line| !line.starts_with('['));
    let pairs = lines.filter(|line| !line.starts_with('#')).filter_map(|line| line.split_once('='));
    pairs.map(|(key, value)| (key.trim().to_owned(), value.trim().to_owned())).collect()
}

fn value(of: &[(String, String)], key: &str) -> Option<String> {
    of.iter().find(|(name, _)| name == key).map(|(_, value)| value.clone())
}

/// Texts in double quotes.
fn quoted(text: &str) -> Vec<&str> {
    text.split('"').skip(1).step_by(2).collect()
}

#[test]
fn invariant_published_packages_hold_licences_and_a_readme() {
    for package in PUBLISHED {
        for licence in ["LICENSE-MIT", "LICENSE-APACHE"] {
            assert_eq!(
                read(licence),
                read(Path::new(package).join(licence)),
                "{package}/{licence} differs from /{licence}"
            );
        }
        let readme = read(Path::new(package).join("README.md"));
        let name = value(&table(&read(Path::new(package).join("Cargo.toml")), "package"), "name").expect("a name");
        assert!(
            readme.starts_with(&format!("# {}\n", name.trim_matches('"'))),
            "{package}/README.md has another title"
        );
        assert!(!readme.contains("](../"), "{package}/README.md leads out of the package");
    }
}

/// The limits of the registry: at most five of each, keywords of at most 20 characters that begin with a letter.
#[test]
fn invariant_published_packages_say_what_they_are() {
    for package in PUBLISHED {
        let of = table(&read(Path::new(package).join("Cargo.toml")), "package");
        for key in ["description", "readme", "keywords", "categories"] {
            assert!(value(&of, key).is_some(), "{package} has no {key}");
        }
        for key in ["version", "edition", "rust-version", "license"] {
            assert_eq!(value(&of, &format!("{key}.workspace")).as_deref(), Some("true"), "{key} of {package}");
        }
        let keywords = value(&of, "keywords").unwrap_or_default();
        let categories = value(&of, "categories").unwrap_or_default();
        assert!(
            (1..=5).contains(&quoted(&keywords).len()) && (1..=5).contains(&quoted(&categories).len()),
            "{package}"
        );
        for keyword in quoted(&keywords) {
            let rest = |letter: char| letter.is_ascii_alphanumeric() || "_-+".contains(letter);
            let is_good = keyword.starts_with(|letter: char| letter.is_ascii_alphabetic()) && keyword.chars().all(rest);
            assert!(is_good && keyword.len() <= 20, "{package}: keyword `{keyword}`");
        }
    }
}

/// Rust files below a folder.
fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).into_iter().flatten().map(|entry| entry.expect("an entry").path()) {
        if entry.is_dir() {
            sources(&entry, found);
        } else if entry.extension().is_some_and(|extension| extension == "rs") {
            found.push(entry);
        }
    }
}

fn texts(package: &str) -> Vec<(PathBuf, String)> {
    let mut files = Vec::new();
    for folder in ["src", "tests", "examples", "benches"] {
        sources(&root().join(package).join(folder), &mut files);
    }
    files.into_iter().map(|file| (file.clone(), read(&file))).collect()
}

#[test]
fn invariant_every_dependency_is_used() {
    let listed: BTreeSet<String> =
        table(&read("Cargo.toml"), "workspace.dependencies").into_iter().map(|(name, _)| name).collect();
    assert!(listed.len() >= 15, "only {} dependencies found", listed.len());
    let mut needed = BTreeSet::new();
    for package in MEMBERS {
        let manifest = read(Path::new(package).join("Cargo.toml"));
        let texts = texts(package);
        // those of all systems, of some, and of tests
        let tables = manifest.lines().filter_map(|line| line.strip_prefix('[')?.strip_suffix(']'));
        for (name, _) in tables.filter(|name| name.ends_with("dependencies")).flat_map(|name| table(&manifest, name)) {
            let word = format!("{}::", name.replace('-', "_"));
            assert!(texts.iter().any(|(_, text)| text.contains(&word)), "{package} does not use `{name}`");
            needed.insert(name);
        }
    }
    let unused: Vec<&String> = listed.difference(&needed).collect();
    assert!(unused.is_empty(), "no package needs {unused:?}");
}

/// Else the package could not be built where the repository is not.
#[test]
fn invariant_published_packages_include_files_of_their_own() {
    let mut seen = 0;
    for package in PUBLISHED {
        let own = root().join(package).canonicalize().expect("the package is there");
        for (file, text) in texts(package) {
            for named in text.split("include_str!(\"").skip(1).filter_map(|rest| rest.split('"').next()) {
                let path = file.parent().expect("a file is in a folder").join(named);
                let path = path.canonicalize().unwrap_or_else(|error| panic!("{}: {error}", path.display()));
                assert!(path.starts_with(&own), "{} includes {}", file.display(), path.display());
                seen += 1;
            }
        }
    }
    assert!(seen >= 2, "only {seen} files are included");
}

#[test]
fn invariant_oldest_compiler_has_one_number() {
    let oldest =
        value(&table(&read("Cargo.toml"), "workspace.package"), "rust-version").expect("the workspace has one");
    let oldest = oldest.trim_matches('"');
    for (page, sentence) in [
        ("README.md", format!("({oldest} or newer)")),
        ("ezy-core/README.md", format!("Rust {oldest} or newer")),
        ("models/template/manifest.toml", format!("rust-version = \"{oldest}\"")),
        (".github/workflows/ci.yml", format!("toolchain: [\"{oldest}\"]")),
        ("docs/semver.md", format!("Rust {oldest}")),
    ] {
        assert!(read(page).contains(&sentence), "{page} lacks `{sentence}`");
    }
}

/// A part that is renamed would be left out in silence.
#[test]
fn invariant_workflows_call_parts_that_exist() {
    let script = read(".ci/run");
    let is_part = |name: &str| script.contains(&format!("\npart_{}() {{\n", name.replace('-', "_")));
    let workflow = read(".github/workflows/ci.yml");
    let calls = workflow.lines().filter_map(|line| line.split_once("run: .ci/run")).map(|(_, names)| names);
    let calls: Vec<&str> = calls.flat_map(str::split_whitespace).collect();
    assert!(calls.len() >= 5, "the workflow calls {calls:?}");
    for name in &calls {
        assert!(is_part(name), "the workflow calls part `{name}`, which is not there");
    }
    let list = |start: &str| {
        let line = script.lines().find_map(|line| line.strip_prefix(start)).expect("the parts are listed");
        line.trim_end_matches(')').split_whitespace().collect::<BTreeSet<&str>>()
    };
    let [beside, tests, on_request] = ["BESIDE=(", "TESTS=(", "ON_REQUEST=("].map(list);
    for name in &on_request {
        assert!(calls.contains(name), "the workflow calls `{name}`, which nobody else does");
    }
    let defined = script.lines().filter_map(|line| line.strip_prefix("part_")?.strip_suffix("() {"));
    assert_eq!(&(&beside | &tests) | &on_request, defined.collect(), "`.ci/run` knows every part");
}
