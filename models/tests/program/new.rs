//! `ezy new`: the crate that it writes, and what it refuses. That the crate builds is a part of `.ci/run`.

use crate::{assert_wrong_use, directory, ezy, text};
use std::fs;
use std::path::{Path, PathBuf};

fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    entries.flat_map(|path| if path.is_dir() { files(&path) } else { vec![path] }).collect()
}

#[test]
fn invariant_new_crate_has_its_name_in_all_places() {
    let folder = directory("new").join("my-own_robot2");
    let done = ezy(&["new", folder.to_str().unwrap()]);
    assert!(done.status.success(), "{}", text(&done.stderr));
    assert!(text(&done.stdout).contains("run myownrobot2/coast"), "{}", text(&done.stdout));
    let written = files(&folder);
    assert_eq!(written.len(), 9, "{written:?}");
    for file in written {
        let content = fs::read_to_string(&file).unwrap().to_lowercase();
        assert!(!content.contains("mechanism\"") && !content.contains("my_mechanism"), "{}", file.display());
        assert!(!content.contains("../../ezy-core"), "{}", file.display());
    }
    assert!(fs::read_to_string(folder.join("src/my_own_robot2.rs")).unwrap().contains("pub model MyOwnRobot2 {"));
    let manifest = fs::read_to_string(folder.join("Cargo.toml")).unwrap();
    let core = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap().join("ezy-core");
    assert!(
        manifest.contains("name = \"my-own_robot2\"") && manifest.contains(&format!("path = {core:?}")),
        "{manifest}"
    );
}

/// Figures are drawn without another build.
#[test]
fn invariant_new_crate_has_figures() {
    let folder = directory("new_figures").join("tricycle");
    assert!(ezy(&["new", folder.to_str().unwrap()]).status.success());
    let manifest = fs::read_to_string(folder.join("Cargo.toml")).unwrap();
    assert!(manifest.contains("features = [\"cli\", \"figures\"]"), "{manifest}");
}

/// Names that hold the placeholder are filled in once.
#[test]
fn invariant_new_crate_may_be_called_as_the_template_is() {
    let folder = directory("new_template").join("my_mechanism2");
    assert!(ezy(&["new", folder.to_str().unwrap()]).status.success());
    assert!(fs::read_to_string(folder.join("Cargo.toml")).unwrap().contains("name = \"my_mechanism2\""));
    assert!(fs::read_to_string(folder.join("src/main.rs")).unwrap().contains("&my_mechanism2::MODEL"));
}

#[test]
fn invariant_new_crate_takes_ezy_from_where_it_is_told() {
    let folder = directory("new_from");
    let sources =
        [("https://example.org/ezy.git", "git = \"https://example.org/ezy.git\""), ("0.3", "version = \"0.3\"")];
    for (i, (source, dependency)) in sources.into_iter().enumerate() {
        let folder = folder.join(format!("trial{i}"));
        assert!(ezy(&["new", folder.to_str().unwrap(), "--ezy", source]).status.success());
        let manifest = fs::read_to_string(folder.join("Cargo.toml")).unwrap();
        assert!(manifest.contains(&format!("ezy-core = {{ {dependency}, default-features")), "{manifest}");
    }
}

#[test]
fn invariant_new_refuses_a_bad_name_a_folder_that_exists_and_a_source_that_is_none() {
    let folder = directory("new_refused");
    let of = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    for name in ["Robot", "3d", "my robot", "röbot", "-x", "robot-2", "x-y", "a--b", "robot_"] {
        assert_wrong_use(&["new", "--", &of(name)], "is no name for a crate");
    }
    for name in ["for", "test", "ezy-core"] {
        assert_wrong_use(&["new", &of(name)], &format!("choose another, such as `my-{name}`"));
    }
    fs::create_dir(folder.join("robot")).unwrap();
    assert_wrong_use(&["new", &of("robot")], "exists; choose another name");
    assert_wrong_use(&["new", &of("other"), "--ezy", &of("nowhere")], "is not the folder of EZY");
    assert_wrong_use(&["new", &of("other"), "--ezy", "3rdparty/ezy"], "is not the folder of EZY");
    assert_wrong_use(
        &["new", &of("other"), "--ezy", "git@example.org:a/b.git"],
        "write `ssh://git@example.org/a/b.git`",
    );
    assert_wrong_use(&["new", "."], "`.` names no new folder");
    assert_eq!(files(&folder), Vec::<PathBuf>::new());
}
