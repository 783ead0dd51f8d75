//! The commands `completions` and `man`: what a shell and `man` read.

use clap::builder::PossibleValuesParser;

use super::Models;
use super::arguments::{CompletionsArguments, ManArguments};
use super::failure::{Failure, print};
use super::selection::typed;

/// Prints completions; where a command takes a model or a scene, they are among them.
pub(super) fn completions(
    models: Models<'_>,
    command: clap::Command,
    arguments: &CompletionsArguments,
) -> Result<(), Failure> {
    let scenes = models.iter().flat_map(|model| {
        let model_name = typed(model.name);
        model.scenes.iter().map(move |scene| format!("{model_name}/{}", scene.name))
    });
    let scenes: Vec<String> = scenes.collect();
    let with_models: Vec<String> = models.iter().map(|model| typed(model.name)).chain(scenes.clone()).collect();
    let mut command = command.mut_subcommands(|command| {
        let (argument, paths) = match command.get_name() {
            "run" | "accuracy" | "equilibrium" | "inverse" | "linearize" => ("path", &scenes),
            "plot" => ("what", &scenes),
            "show" | "check" => ("path", &with_models),
            _ => return command,
        };
        let paths = PossibleValuesParser::new(paths);
        command.mut_arg(argument, |path| path.value_parser(paths))
    });
    let (mut text, program) = (Vec::new(), command.get_name().to_owned());
    clap_complete::generate(arguments.shell, &mut command, program, &mut text);
    print(&String::from_utf8_lossy(&text))
}

/// Prints a manual page.
pub(super) fn man(mut command: clap::Command, arguments: &ManArguments) -> Result<(), Failure> {
    // names of subcommands as they are called
    command.build();
    let page = match &arguments.command {
        None => command,
        Some(name) => match command.find_subcommand(name) {
            Some(found) => found.clone(),
            None => {
                let known: Vec<&str> = command.get_subcommands().map(clap::Command::get_name).collect();
                return Err(Failure::wrong_use(format!("no command `{name}`; there are {}", known.join(", "))));
            }
        },
    };
    let mut text = Vec::new();
    let written = clap_mangen::Man::new(page).render(&mut text);
    written.map_err(Failure::stopped)?;
    print(&String::from_utf8_lossy(&text))
}
