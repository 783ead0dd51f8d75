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
        assert!(!content.contains("../../ezy-"), "{}", file.display());
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
    assert!(manifest.contains("ezy-cli\", features = [\"figures\"]"), "{manifest}");
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
        for package in ["ezy-core = ", "ezy-cli = "] {
            assert!(manifest.contains(&format!("{package}{{ {dependency}, ")), "{manifest}");
        }
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

#[test]
fn invariant_new_python_module_has_its_name_in_all_places() {
    let folder = directory("new_python").join("my-own_robot2");
    let done = ezy(&["new", "--python", folder.to_str().unwrap()]);
    assert!(done.status.success(), "{}", text(&done.stderr));
    assert!(text(&done.stdout).contains("my_own_robot2.coast().run()"), "{}", text(&done.stdout));
    let written = files(&folder);
    assert_eq!(written.len(), 10, "{written:?}");
    for file in &written {
        let content = fs::read_to_string(file).unwrap().to_lowercase();
        for placeholder in ["my_mechanism", "my-mechanism", "mymechanism", "\"../"] {
            assert!(!content.contains(placeholder), "{placeholder} in {}", file.display());
        }
    }
    let of = |file: &str| fs::read_to_string(folder.join(file)).unwrap();
    let manifest = of("Cargo.toml");
    let ezy = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
    for (name, path) in
        [("ezy-core", ezy.join("ezy-core")), ("ezy-cli", ezy.join("ezy-cli")), ("ezy-python", ezy.join("python"))]
    {
        assert!(manifest.contains(&format!("{name} = {{ path = {path:?}")), "{manifest}");
    }
    for part in ["name = \"my_own_robot2\"", "crate-type = [\"cdylib\"]", "abi3-py310"] {
        assert!(manifest.contains(part), "{manifest}");
    }
    assert!(
        of("pyproject.toml").contains("build-backend = \"maturin\"") && of("pyproject.toml").contains("my-own_robot2")
    );
    assert!(of("src/lib.rs").contains("#[pymodule(name = \"my_own_robot2\")]"));
    assert!(of("tests/test_my_own_robot2.py").contains("import my_own_robot2\n"));
}

/// What is written with and without Python starts from one model, and all modules have the classes of one file.
#[test]
fn cross_new_python_module_has_the_model_and_the_types_of_the_others() {
    let folder = directory("new_python_same");
    let of = |name: &str| folder.join(name).join("tricycle");
    for (name, option) in [("rust", None), ("python", Some("--python"))] {
        let arguments: Vec<&str> = ["new"].into_iter().chain(option).collect();
        assert!(ezy(&[&arguments[..], &[of(name).to_str().unwrap()]].concat()).status.success());
    }
    let model = |name: &str| fs::read_to_string(of(name).join("src/tricycle.rs")).unwrap();
    assert_eq!(model("rust"), model("python"));
    let classes = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap().join("python/src/classes.pyi");
    let types = fs::read_to_string(of("python").join("tricycle.pyi")).unwrap();
    let first = "# Written by `type_stub()` of this module.\n";
    let classes = fs::read_to_string(classes).unwrap();
    assert!(types.starts_with(&(first.to_owned() + &classes)), "copy python/src/classes.pyi to the template");
}

#[test]
fn invariant_new_python_module_finds_ezy_where_it_is_told() {
    let folder = directory("new_python_from");
    let (from_git, without) = (folder.join("robot"), folder.join("ezy"));
    let url = "https://example.org/ezy.git";
    assert!(ezy(&["new", "--python", from_git.to_str().unwrap(), "--ezy", url]).status.success());
    let manifest = fs::read_to_string(from_git.join("Cargo.toml")).unwrap();
    assert!(manifest.contains(&format!("ezy-python = {{ git = \"{url}\" }}")), "{manifest}");

    for package in ["ezy-core", "ezy-cli"] {
        fs::create_dir_all(without.join(package)).unwrap();
        fs::write(without.join(package).join("Cargo.toml"), "").unwrap();
    }
    let other = folder.join("other");
    let arguments = ["new", "--python", other.to_str().unwrap(), "--ezy", without.to_str().unwrap()];
    assert_wrong_use(&arguments, "has no python/Cargo.toml");
    assert!(!other.exists());
}

/// Python's own words and modules; a crate without Python may have them.
#[test]
fn invariant_new_refuses_what_python_cannot_import() {
    let folder = directory("new_python_refused");
    let of = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    for name in ["lambda", "random", "numpy", "ezy"] {
        assert_wrong_use(&["new", "--python", &of(name)], &format!("choose another, such as `my-{name}`"));
    }
    assert_eq!(files(&folder), Vec::<PathBuf>::new());
    assert!(ezy(&["new", &of("lambda")]).status.success());
}
