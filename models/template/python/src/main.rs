//! The command line of the model: `list`, `show`, `run`, `sketch`, `animate`, `gallery`, `plot`, `compare`, `check`, `accuracy`, `completions`,
//! `man`, `help`.

mod my_mechanism;

fn main() -> std::process::ExitCode {
    ezy_cli::main(&[&my_mechanism::my_mechanism::MODEL])
}
