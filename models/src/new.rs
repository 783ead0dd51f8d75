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
    let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
    check_name(name).map_err(Failure::wrong_use)?;
    let source = Source::of(arguments.get_one::<String>("ezy").map(String::as_str)).map_err(Failure::wrong_use)?;
    if path.exists() {
        return Err(Failure::wrong_use(format!("`{}` exists; choose another name, or move it away", path.display())));
    }
    let names = Names::of(name);
    for (file, text) in FILES {
        let text = names.fill(&text.replace(SOURCE, &source.dependency));
        write(&path.join(names.fill(file)), &text)?;
    }
    if let Some(lock) = source.lock_file {
        // the versions that EZY is tested with; without them Cargo chooses
        write(&path.join("Cargo.lock"), &lock)?;
    }
    print(&format!(
        "Wrote {0}: a small vehicle to start from, in src/{1}.rs\n\n\
         cd {0}\n\
         cargo run -- list                        # its scenes\n\
         cargo run -- run {2}/coast --out coast.csv\n\
         cargo run --example controller           # a run from Rust, steered by a law\n\
         cargo test                               # equations against finite differences, energy\n",
        path.display(),
        names.module,
        names.path,
    ))
}

fn write(path: &Path, text: &str) -> Result<(), Failure> {
    let folder = path.parent().map_or(Ok(()), fs::create_dir_all);
    let written = folder.and_then(|()| fs::write(path, text));
    written.map_err(|error| Failure::wrong_use(format!("`{}` cannot be written: {error}", path.display())))
}

/// Says what is wrong with a name, and how to mend it.
fn check_name(name: &str) -> Result<(), String> {
    let how = "write small letters, digits, `-` and `_`, and begin with a letter, such as `tricycle` or `my-robot`";
    let is_letter = |c: char| c.is_ascii_lowercase();
    if !name.starts_with(is_letter)
        || name.contains(|c: char| !(is_letter(c) || c.is_ascii_digit() || "-_".contains(c)))
    {
        return Err(format!("`{name}` is no name of a crate: {how}"));
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
        let built_in = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let pair = |key: &str, value: &str| Self { dependency: format!("{key} = {value:?}"), lock_file: None };
        match given {
            None => Ok(Self::folder(&built_in).unwrap_or_else(|_| pair("version", env!("CARGO_PKG_VERSION")))),
            Some(address) if address.contains("://") || address.starts_with("git@") => Ok(pair("git", address)),
            Some(version) if version.starts_with(|c: char| c.is_ascii_digit()) => Ok(pair("version", version)),
            Some(folder) => Self::folder(Path::new(folder)),
        }
    }

    fn folder(folder: &Path) -> Result<Self, String> {
        let core = folder.join("ezy-core");
        let core = core.join("Cargo.toml").exists().then(|| core.canonicalize()).and_then(Result::ok);
        let path = core.as_deref().and_then(Path::to_str);
        let path = path
            .ok_or_else(|| format!("`{}` is not the folder of EZY: it has no ezy-core/Cargo.toml", folder.display()))?;
        Ok(Self {
            dependency: format!("path = {path:?}"),
            lock_file: fs::read_to_string(folder.join("Cargo.lock")).ok(),
        })
    }
}

/// The names of a crate.
struct Names {
    package: String,
    module: String,
    model: String,
    /// Of the model on the command line.
    path: String,
}

impl Names {
    fn of(name: &str) -> Self {
        let capital = |part: &str| part[..1].to_uppercase() + &part[1..];
        let model: String = name.split(['-', '_']).filter(|part| !part.is_empty()).map(capital).collect();
        Self { package: name.to_owned(), module: name.replace('-', "_"), path: model.to_lowercase(), model }
    }

    fn fill(&self, text: &str) -> String {
        let Self { package, module, model, path } = self;
        let names =
            [("my-mechanism", package), ("my_mechanism", module), ("MyMechanism", model), ("mymechanism", path)];
        names.iter().fold(text.to_owned(), |text, (placeholder, name)| text.replace(placeholder, name))
    }
}
