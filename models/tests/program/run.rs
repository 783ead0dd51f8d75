//! The `ezy` program, called by tests.

use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};

pub fn ezy(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_ezy")).args(arguments).output().expect("the program starts")
}

/// The program, while it runs.
#[allow(dead_code, reason = "one of the programs that share this file does not need it")]
pub fn start(arguments: &[&str]) -> Child {
    let mut program = Command::new(env!("CARGO_BIN_EXE_ezy"));
    program.args(arguments).stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    program.spawn().expect("the program starts")
}

/// SplitMix64 (Steele, Lea, Flood, OOPSLA 2014).
#[allow(dead_code, reason = "one of the programs that share this file does not need it")]
pub fn random(state: &mut u64) -> usize {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let z = (*state ^ (*state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((z ^ (z >> 31)) >> 33) as usize
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
