//! The archive of a functional mock-up unit: texts, and the library that a C compiler makes of them.

use std::io::{Cursor, Write as _};
use std::path::{Path, PathBuf};
use std::process::Command;

use zip::ZipWriter;
use zip::write::SimpleFileOptions;

use super::failure::Failure;
use ezy_core::export::fmu::{Unit, Version};

/// The archive, and for which system it has a library; without a C compiler for none.
pub(super) fn archive(unit: &Unit, version: Version) -> Result<(Vec<u8>, Option<String>), Failure> {
    let system = system(version);
    let library = library(unit)?;
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    let mut add = |path: &str, bytes: &[u8]| {
        archive.start_file(path, SimpleFileOptions::default()).map_err(Failure::stopped)?;
        archive.write_all(bytes).map_err(Failure::stopped)
    };
    for (path, text) in &unit.files {
        add(path, text.as_bytes())?;
    }
    if let Some(bytes) = &library {
        let path = format!("binaries/{system}/{}{}", unit.identifier, std::env::consts::DLL_SUFFIX);
        add(&path, bytes)?;
    }
    let bytes = archive.finish().map_err(Failure::stopped)?.into_inner();
    Ok((bytes, library.map(|_| system)))
}

/// The name of this system in an archive.
fn system(version: Version) -> String {
    use std::env::consts::{ARCH, OS};
    let os = if OS == "macos" { "darwin" } else { OS };
    match version {
        Version::Two if OS == "windows" => "win64".to_owned(),
        Version::Two => format!("{os}64"),
        Version::Three => format!("{ARCH}-{os}"),
    }
}

/// A folder that is removed with what is in it.
struct Scratch(PathBuf);

impl Drop for Scratch {
    fn drop(&mut self) {
        // what cannot be removed lies in the folder of the system for such files
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// The library; `None` where there is no C compiler. Paths are relative, so that none of this machine gets into it.
fn library(unit: &Unit) -> Result<Option<Vec<u8>>, Failure> {
    let folder = Scratch(std::env::temp_dir().join(format!("ezy-fmu-{}-{}", std::process::id(), unit.identifier)));
    let written = |cause| Failure::stopped(format!("`{}` cannot be written: {cause}", folder.0.display()));
    for (path, text) in &unit.files {
        let path = folder.0.join(path);
        std::fs::create_dir_all(path.parent().unwrap_or(Path::new("."))).map_err(written)?;
        std::fs::write(path, text).map_err(written)?;
    }
    let compiler = std::env::var("CC").ok().filter(|name| !name.is_empty()).unwrap_or_else(|| "cc".to_owned());
    let flags = ["-std=c99", "-O2", "-ffp-contract=off", "-shared", "-fPIC", "-fvisibility=hidden", "-Isources"];
    let files = ["sources/fmu.c", "-lm", "-o", "library"];
    let done = match Command::new(&compiler).args(flags).args(files).current_dir(&folder.0).output() {
        Ok(done) => done,
        Err(cause) if cause.kind() == std::io::ErrorKind::NotFound => return Ok(None),
        Err(cause) => {
            return Err(Failure::stopped(format!("`{compiler}` does not start: {cause}; set CC to a C compiler")));
        }
    };
    if !done.status.success() {
        let told = String::from_utf8_lossy(&done.stderr);
        return Err(Failure::stopped(format!(
            "`{compiler}` did not compile the unit; set CC to a C99 compiler\n{told}"
        )));
    }
    std::fs::read(folder.0.join("library")).map(Some).map_err(written)
}
