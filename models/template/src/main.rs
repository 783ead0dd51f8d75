//! The command line of the model: `list`, `show`, `run`, `animate`, `sketch`, `gallery`, `check`, `accuracy`, `completions`, `man`, `help`.

fn main() -> std::process::ExitCode {
    ezy_core::cli::main(&[&my_mechanism::MODEL])
}
