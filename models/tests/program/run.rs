//! The `ezy` program, called by tests.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

pub fn ezy(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_ezy")).args(arguments).output().expect("the program starts")
}

pub fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("output is UTF-8")
}

/// A fresh place for the files of one test.
pub fn directory(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).expect("a directory for the test");
    path
}

/// Exit status 2 with a message that says this, and nothing on standard output.
pub fn assert_wrong_use(arguments: &[&str], message: &str) {
    let done = ezy(arguments);
    let stderr = text(&done.stderr);
    assert_eq!(done.status.code(), Some(2), "{arguments:?}: {stderr}");
    assert!(stderr.contains(message), "{arguments:?}: {stderr}");
    assert!(done.stdout.is_empty(), "{arguments:?}");
}
