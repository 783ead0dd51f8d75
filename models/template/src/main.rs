//! The command line of the model: `list`, `show`, `run`, `sketch`, `animate`, `gallery`, `plot`, `compare`, `check`, `accuracy`, `completions`,
//! `man`, `help`.

fn main() -> std::process::ExitCode {
    ezy_cli::main(&[&my_mechanism::MODEL])
}
