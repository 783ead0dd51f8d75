//! Where a new crate finds EZY.

use std::fs;
use std::path::{Path, PathBuf};

/// The packages of EZY that a crate depends on: the folder of each, and what stands for its source in a manifest of the template.
pub(super) const PACKAGES: [(&str, &str); 3] = [
    ("ezy-core", "path = \"../../ezy-core\""),
    ("ezy-cli", "path = \"../../ezy-cli\""),
    ("python", "path = \"../../../python\""),
];

/// Where a crate finds the [`PACKAGES`].
pub(super) struct Source {
    /// As it stands in a manifest.
    pub(super) packages: [String; PACKAGES.len()],
    /// That of EZY, where there is one.
    folder: Option<PathBuf>,
}

impl Source {
    pub(super) fn of(given: Option<&str>) -> Result<Self, String> {
        let both = |key: &str, value: &str| {
            let dependency = format!("{key} = {}", quoted(value));
            Self { packages: PACKAGES.map(|_| dependency.clone()), folder: None }
        };
        let Some(given) = given else {
            let built_in = Path::new(env!("CARGO_MANIFEST_DIR")).parent().map(Self::folder);
            return Ok(built_in.and_then(Result::ok).unwrap_or_else(|| both("version", env!("CARGO_PKG_VERSION"))));
        };
        let is_version = given.starts_with(|c: char| c.is_ascii_digit()) && !given.contains(['/', '\\']);
        match Self::folder(Path::new(given)) {
            Ok(folder) => Ok(folder),
            Err(_) if given.contains("://") => Ok(both("git", given)),
            Err(_) if is_version => Ok(both("version", given)),
            Err(_) if given.starts_with("git@") => {
                let url = given.replacen(':', "/", 1);
                Err(format!("Cargo takes no address like `{given}`; write `ssh://{url}`"))
            }
            Err(error) => Err(error),
        }
    }

    fn folder(folder: &Path) -> Result<Self, String> {
        let missing = ["ezy-core", "ezy-cli"].into_iter().find(|name| !folder.join(name).join("Cargo.toml").exists());
        if let Some(missing) = missing {
            return Err(format!("`{}` is not the folder of EZY: it has no {missing}/Cargo.toml", folder.display()));
        }
        let root = std::path::absolute(folder).ok().and_then(|root| root.to_str().map(PathBuf::from));
        let root = root.ok_or_else(|| {
            format!("the path of `{}` cannot stand in Cargo.toml: it is no Unicode text", folder.display())
        })?;
        let packages = PACKAGES.map(|(name, _)| format!("path = {}", quoted(&root.join(name).to_string_lossy())));
        Ok(Self { packages, folder: Some(folder.to_owned()) })
    }

    /// Says where `ezy-python` is missing in a folder of EZY.
    pub(super) fn check_python(&self) -> Result<(), String> {
        match &self.folder {
            Some(folder) if !folder.join("python").join("Cargo.toml").exists() => Err(format!(
                "`{}` has no python/Cargo.toml, which a Python module takes: give the whole of EZY by `--ezy`, such as its git address",
                folder.display()
            )),
            _ => Ok(()),
        }
    }

    /// The versions that EZY is tested with, of its own workspace or of that of its Python modules.
    pub(super) fn lock_file(&self, is_python: bool) -> Option<String> {
        let folder = self.folder.as_ref()?;
        let workspace = if is_python { folder.join("python") } else { folder.clone() };
        fs::read_to_string(workspace.join("Cargo.lock")).ok()
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
