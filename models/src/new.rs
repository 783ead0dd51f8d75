//! The command `new` of `ezy`: a crate for a model of one's own.

mod python;
mod source;

use std::fs;
use std::path::{Path, PathBuf};

use ezy_cli::clap::{Arg, ArgAction, ArgMatches, Command, value_parser};
use ezy_cli::{Failure, print};
use source::Source;

/// The model that a new crate starts from.
const MODEL: (&str, &str) = ("src/my_mechanism.rs", include_str!("../template/src/my_mechanism.rs"));

/// The files of a new crate, which is called `my-mechanism` in them.
const FILES: [(&str, &str); 8] = [
    ("Cargo.toml", include_str!("../template/manifest.toml")),
    ("README.md", include_str!("../template/README.md")),
    (".gitignore", include_str!("../template/gitignore")),
    ("src/lib.rs", include_str!("../template/src/lib.rs")),
    ("src/main.rs", include_str!("../template/src/main.rs")),
    MODEL,
    ("examples/controller.rs", include_str!("../template/examples/controller.rs")),
    ("tests/checks.rs", include_str!("../template/tests/checks.rs")),
];

/// What follows the name of a new crate's folder when it is written.
const NEXT: &str = "\
cargo run -- list                        # its scenes
cargo run -- run mymechanism/coast --out coast.csv
cargo run --example controller           # a run from Rust, steered by a law
cargo test                               # equations against finite differences, energy
";

/// Names that Cargo or Rust keep for themselves, or that a crate which uses EZY cannot have.
const TAKEN: [&str; 15] = [
    "alloc",
    "build",
    "core",
    "deps",
    "examples",
    "ezy_cli",
    "ezy_core",
    "ezy_derive",
    "ezy_models",
    "incremental",
    "main",
    "proc_macro",
    "std",
    "test",
    "tests",
];

/// The keywords of Rust that are made of small letters.
const KEYWORDS: &str = "abstract as async await become box break const continue crate do dyn else enum extern false final fn for gen if impl in \
    let loop macro match mod move mut override priv pub ref return self static struct super trait true try type typeof unsafe unsized \
    use virtual where while yield";

/// The command and its help.
pub fn command() -> Command {
    let path = Arg::new("path")
        .required(true)
        .value_name("NAME")
        .value_parser(value_parser!(PathBuf))
        .help("Name of the crate, or a path that ends with it; the folder is made and must not exist");
    let ezy = Arg::new("ezy").long("ezy").value_name("SOURCE").help(
        "Where the crate finds EZY: its folder, a git address, or a version [default: the folder that this program was built in]",
    );
    let python = Arg::new("python")
        .long("python")
        .action(ArgAction::SetTrue)
        .help("Writes a Python module with the model and its command line, to be built by maturin or pip");
    Command::new("new")
        .about("Writes a crate for a model of your own: model file, command line, controller, test")
        .long_about(
            "Writes a crate for a model of your own: model file, command line, controller, test\n\n\
             The model file holds a small vehicle with comments, to be changed or replaced. The crate depends on `ezy-core` and `ezy-cli` alone, stands \
             wherever you want, and has the commands of this program for its model.\n\n\
             With --python it is a Python module as well: `pip install .` builds it, and its scenes, runs and steppers are classes in \
             Python. A test in Python stands in place of the controller and the test in Rust.",
        )
        .arg(path)
        .arg(ezy)
        .arg(python)
}

/// Writes the crate and says what to do with it.
///
/// # Errors
/// [`Failure::Use`] when the name is none, the folder exists, or a file cannot be written.
pub fn run(arguments: &ArgMatches) -> Result<(), Failure> {
    let path: &PathBuf = arguments.get_one("path").ok_or_else(|| Failure::wrong_use("give the crate a name"))?;
    let Some(name) = path.file_name().and_then(|name| name.to_str()) else {
        let message = format!("`{}` names no new folder; write its name, such as `tricycle`", path.display());
        return Err(Failure::wrong_use(message));
    };
    check_name(name).map_err(Failure::wrong_use)?;
    let is_python = arguments.get_flag("python");
    if is_python {
        python::check_name(name).map_err(Failure::wrong_use)?;
    }
    let source = Source::of(arguments.get_one::<String>("ezy").map(String::as_str)).map_err(Failure::wrong_use)?;
    if is_python {
        source.check_python().map_err(Failure::wrong_use)?;
    }
    if path.exists() {
        return Err(Failure::wrong_use(format!("`{}` exists; choose another name, or move it away", path.display())));
    }
    let (files, next) = if is_python { (&python::FILES[..], python::NEXT) } else { (&FILES[..], NEXT) };
    let placeholders = placeholders(name, &source);
    for (file, text) in files {
        write(&path.join(filled(file, &placeholders)), &filled(text, &placeholders))?;
    }
    if let Some(lock) = source.lock_file(is_python) {
        // the versions that EZY is tested with; without them Cargo chooses
        write(&path.join("Cargo.lock"), &lock)?;
    }
    print(&format!(
        "Wrote {}: a small vehicle to start from, in src/{}.rs. It takes EZY from {}.\n\ncd \"{}\"\n{}",
        path.display(),
        name.replace('-', "_"),
        source.packages[0],
        path.display(),
        filled(next, &placeholders),
    ))
}

fn write(path: &Path, text: &str) -> Result<(), Failure> {
    let folder = path.parent().map_or(Ok(()), fs::create_dir_all);
    let written = folder.and_then(|()| fs::write(path, text));
    written.map_err(|error| Failure::wrong_use(format!("`{}` cannot be written: {error}", path.display())))
}

/// Says what is wrong with a name, and how to mend it.
fn check_name(name: &str) -> Result<(), String> {
    let is_letter = |c: char| c.is_ascii_lowercase();
    // the macro makes the name of a module of that of the model, which must be that of the file again
    let is_part = |part: &str| {
        let of_signs = part.chars().all(|c| is_letter(c) || c.is_ascii_digit());
        of_signs && part.starts_with(is_letter) && part.len() > 1
    };
    if !name.split(['-', '_']).all(is_part) {
        return Err(format!(
            "`{name}` is no name for a crate with a model: write words of small letters and digits, each with a letter first and of two \
             signs at least, and `-` or `_` between them, such as `tricycle` or `my-robot2`"
        ));
    }
    let module = name.replace('-', "_");
    if TAKEN.contains(&&*module) || KEYWORDS.split_whitespace().any(|keyword| keyword == module) {
        return Err(format!(
            "`{name}` is a name that Rust, Cargo or EZY keep for themselves; choose another, such as `my-{name}`"
        ));
    }
    Ok(())
}

/// What stands for the names of the crate in its files, and for the sources of EZY, with what takes their place.
fn placeholders(name: &str, source: &Source) -> Vec<(&'static str, String)> {
    let capital = |part: &str| part[..1].to_uppercase() + &part[1..];
    let model: String = name.split(['-', '_']).map(capital).collect();
    let mut all = vec![
        ("my-mechanism", name.to_owned()),
        ("my_mechanism", name.replace('-', "_")),
        ("mymechanism", model.to_lowercase()),
        ("MyMechanism", model),
    ];
    all.extend(source::PACKAGES.iter().zip(&source.packages).map(|((_, stands), value)| (*stands, value.clone())));
    all
}

/// Fills in the placeholders from the left to the right, so that nothing is replaced in what was filled in.
fn filled(mut text: &str, placeholders: &[(&str, String)]) -> String {
    let mut filled = String::new();
    loop {
        let found =
            placeholders.iter().filter_map(|(placeholder, value)| Some((text.find(placeholder)?, placeholder, value)));
        let Some((at, placeholder, value)) = found.min_by_key(|(at, ..)| *at) else { return filled + text };
        filled += &text[..at];
        filled += value;
        text = &text[at + placeholder.len()..];
    }
}
