//! The command `new` of `ezy`: a crate for a model of one's own.

use std::fs;
use std::path::{Path, PathBuf};

use ezy_core::cli::clap::{Arg, ArgMatches, Command, value_parser};
use ezy_core::cli::{Failure, print};

/// The files of a new crate, which is called `my-mechanism` in them.
const FILES: [(&str, &str); 8] = [
    ("Cargo.toml", include_str!("../template/manifest.toml")),
    ("README.md", include_str!("../template/README.md")),
    (".gitignore", include_str!("../template/gitignore")),
    ("src/lib.rs", include_str!("../template/src/lib.rs")),
    ("src/main.rs", include_str!("../template/src/main.rs")),
    ("src/my_mechanism.rs", include_str!("../template/src/my_mechanism.rs")),
    ("examples/controller.rs", include_str!("../template/examples/controller.rs")),
    ("tests/checks.rs", include_str!("../template/tests/checks.rs")),
];

/// What stands for the source of `ezy-core` in the manifest.
const SOURCE: &str = "path = \"../../ezy-core\"";

/// Names that Cargo or Rust keep for themselves, or that a crate which uses EZY cannot have.
const TAKEN: [&str; 14] = [
    "alloc",
    "build",
    "core",
    "deps",
    "examples",
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
    Command::new("new")
        .about("Writes a crate for a model of your own: model file, command line, controller, test")
        .long_about(
            "Writes a crate for a model of your own: model file, command line, controller, test\n\n\
             The model file holds a small vehicle with comments, to be changed or replaced. The crate depends on `ezy-core` alone, stands \
             wherever you want, and has the commands of this program for its model.",
        )
        .arg(path)
        .arg(ezy)
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
    let source = Source::of(arguments.get_one::<String>("ezy").map(String::as_str)).map_err(Failure::wrong_use)?;
    if path.exists() {
        return Err(Failure::wrong_use(format!("`{}` exists; choose another name, or move it away", path.display())));
    }
    let placeholders = placeholders(name, &source.dependency);
    for (file, text) in FILES {
        write(&path.join(filled(file, &placeholders)), &filled(text, &placeholders))?;
    }
    if let Some(lock) = source.lock_file {
        // the versions that EZY is tested with; without them Cargo chooses
        write(&path.join("Cargo.lock"), &lock)?;
    }
    print(&filled(
        &format!(
            "Wrote {}: a small vehicle to start from, in src/my_mechanism.rs. It takes ezy-core from {}.\n\n\
             cd \"{}\"\n\
             cargo run -- list                        # its scenes\n\
             cargo run -- run mymechanism/coast --out coast.csv\n\
             cargo run --example controller           # a run from Rust, steered by a law\n\
             cargo test                               # equations against finite differences, energy\n",
            path.display(),
            source.dependency,
            path.display(),
        ),
        &placeholders,
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

/// Where a crate finds `ezy-core`.
struct Source {
    /// As it stands in the manifest.
    dependency: String,
    lock_file: Option<String>,
}

impl Source {
    fn of(given: Option<&str>) -> Result<Self, String> {
        let pair = |key: &str, value: &str| Self { dependency: format!("{key} = {}", quoted(value)), lock_file: None };
        let Some(given) = given else {
            let built_in = Path::new(env!("CARGO_MANIFEST_DIR")).parent().map(Self::folder);
            return Ok(built_in.and_then(Result::ok).unwrap_or_else(|| pair("version", env!("CARGO_PKG_VERSION"))));
        };
        let is_version = given.starts_with(|c: char| c.is_ascii_digit()) && !given.contains(['/', '\\']);
        match Self::folder(Path::new(given)) {
            Ok(folder) => Ok(folder),
            Err(_) if given.contains("://") => Ok(pair("git", given)),
            Err(_) if is_version => Ok(pair("version", given)),
            Err(_) if given.starts_with("git@") => {
                let url = given.replacen(':', "/", 1);
                Err(format!("Cargo takes no address like `{given}`; write `ssh://{url}`"))
            }
            Err(error) => Err(error),
        }
    }

    fn folder(folder: &Path) -> Result<Self, String> {
        let core = folder.join("ezy-core");
        let core = core.join("Cargo.toml").exists().then(|| std::path::absolute(&core)).and_then(Result::ok);
        let path = core.as_deref().and_then(Path::to_str);
        let path = path
            .ok_or_else(|| format!("`{}` is not the folder of EZY: it has no ezy-core/Cargo.toml", folder.display()))?;
        let lock_file = fs::read_to_string(folder.join("Cargo.lock")).ok();
        Ok(Self { dependency: format!("path = {}", quoted(path)), lock_file })
    }
}

/// A string of TOML.
fn quoted(text: &str) -> String {
    let signs = text.chars().map(|c| match c {
        '"' | '\\' => format!("\\{c}"),
        c if c.is_control() => format!("\\u{:04x}", u32::from(c)),
        c => c.to_string(),
    });
    format!("\"{}\"", signs.collect::<String>())
}

/// What stands for the names of the crate in its files, and for the source of `ezy-core`, with what takes its place.
fn placeholders(name: &str, dependency: &str) -> [(&'static str, String); 5] {
    let capital = |part: &str| part[..1].to_uppercase() + &part[1..];
    let model: String = name.split(['-', '_']).map(capital).collect();
    [
        ("my-mechanism", name.to_owned()),
        ("my_mechanism", name.replace('-', "_")),
        ("mymechanism", model.to_lowercase()),
        ("MyMechanism", model),
        (SOURCE, dependency.to_owned()),
    ]
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
