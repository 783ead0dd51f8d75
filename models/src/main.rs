//! The `ezy` command line: the commands of every crate with models, and the study.

use ezy_cli::CommandLine;
use ezy_models::{new, registry::MODELS, study::command};

const ABOUT: &str = "\
Simulates planar mechanisms with wheels from equations that are derived when the program is compiled

Without a command, does the EzyRoller study: figures, tables and a page in out/ezyroller/.";

fn main() -> std::process::ExitCode {
    CommandLine::new(MODELS)
        .about(ABOUT)
        .version(env!("CARGO_PKG_VERSION"))
        .command(command::command(), command::run)
        .command(new::command(), new::run)
        .default_command("study")
        .main()
}
