//! The program: its commands, those of its caller, and what it does without one.

use std::ffi::OsString;
use std::path::Path;
use std::process::ExitCode;

use clap::{ArgMatches, FromArgMatches as _, Subcommand as _};

use super::arguments::Command;
use super::examples::Examples;
use super::failure::Failure;
use super::interruption::Interruption;
use super::leads::lead_on;
use super::{
    Models, accuracy, animate, check, compare, equilibrium, export, gallery, inverse, linearize, list, merge, periodic,
    plot, reactions, run, shell, show, sketch, sweep, workspace,
};
use ezy_core::model::ModelInfo;

/// What a command of the caller does with its arguments.
type Action = fn(&ArgMatches) -> Result<(), Failure>;

/// A command line over some models.
///
/// ```no_run
/// # static MODELS: &[&ezy_core::model::ModelInfo] = &[];
/// use ezy_cli::{CommandLine, Failure, clap, print};
///
/// fn study(_: &clap::ArgMatches) -> Result<(), Failure> {
///     print("studied\n")
/// }
///
/// fn main() -> std::process::ExitCode {
///     CommandLine::new(MODELS)
///         .version(env!("CARGO_PKG_VERSION"))
///         .command(clap::Command::new("study").about("Studies the models"), study)
///         .main()
/// }
/// ```
#[derive(Debug)]
pub struct CommandLine<'m> {
    models: Models<'m>,
    about: &'static str,
    version: &'static str,
    commands: Vec<(clap::Command, Action)>,
    default: Option<&'static str>,
}

/// The first line of help, unless the caller has another.
const ABOUT: &str = "Simulates planar mechanisms from equations that are derived when the program is compiled";

/// What `--version` prints after the program's name, unless the caller has a version.
const VERSION: &str = concat!("with ezy-core ", env!("CARGO_PKG_VERSION"));

const EXIT_STATUS: &str = "Exit status: 0 done; 1 stopped before the end, 130 by Ctrl-C, 143 by SIGTERM (what was computed is kept); 2 wrong use.";

impl<'m> CommandLine<'m> {
    /// The commands `list`, `show`, `run`, `plot`, `compare`, `reactions`, `sweep`, `merge`, `equilibrium`, `linearize`, `inverse`, `periodic`, `workspace`, `export`, `animate`, `sketch`,
    /// `gallery`, `check`, `accuracy`, `completions`, `man` and `help` for `models`.
    pub fn new(models: &'m [&'static ModelInfo]) -> Self {
        Self { models, about: ABOUT, version: VERSION, commands: Vec::new(), default: None }
    }

    /// What help says first; of several lines `-h` shows the first.
    #[must_use]
    pub fn about(mut self, text: &'static str) -> Self {
        self.about = text;
        self
    }

    /// What `--version` prints after the program's name: `env!("CARGO_PKG_VERSION")`.
    #[must_use]
    pub fn version(mut self, version: &'static str) -> Self {
        self.version = version;
        self
    }

    /// Adds a command.
    #[must_use]
    pub fn command(mut self, command: clap::Command, action: fn(&ArgMatches) -> Result<(), Failure>) -> Self {
        self.commands.push((command, action));
        self
    }

    /// The added command that is done when none is given; without it the program prints its help.
    #[must_use]
    pub fn default_command(mut self, name: &'static str) -> Self {
        self.default = Some(name);
        self
    }

    /// Reads the arguments of the program, does what they ask, and turns a failure into a message and an exit status.
    pub fn main(self) -> ExitCode {
        Interruption::outlive_full_files();
        let mut arguments: Vec<OsString> = std::env::args_os().collect();
        if let (Some(default), 0 | 1) = (self.default, arguments.len()) {
            arguments.resize(1, OsString::new());
            arguments.push(default.into());
        }
        let program = program_name(arguments.first());
        let typed: Vec<String> = arguments.iter().skip(1).map(|word| word.to_string_lossy().into_owned()).collect();
        let commands = self.clap(&program);
        let matches = commands.clone().try_get_matches_from(arguments).unwrap_or_else(|mut error| {
            lead_on(&mut error, &commands, self.models, &typed);
            error.exit()
        });
        match self.act(&program, &matches) {
            Ok(()) => ExitCode::SUCCESS,
            Err(failure) => failure.report(),
        }
    }

    fn act(&self, program: &str, matches: &ArgMatches) -> Result<(), Failure> {
        if let Some((name, arguments)) = matches.subcommand()
            && let Some((_, action)) = self.commands.iter().find(|(command, _)| command.get_name() == name)
        {
            return action(arguments);
        }
        match Command::from_arg_matches(matches).unwrap_or_else(|error| error.exit()) {
            Command::List(arguments) => list::list(self.models, &arguments),
            Command::Show(arguments) => show::show(self.models, &arguments),
            Command::Run(arguments) => run::run(self.models, &arguments),
            Command::Plot(arguments) => plot::plot(self.models, &arguments),
            Command::Compare(arguments) => compare::compare(self.models, &arguments),
            Command::Reactions(arguments) => reactions::reactions(self.models, &arguments),
            Command::Merge(arguments) => merge::merge(&arguments),
            Command::Sweep(arguments) => sweep::sweep(self.models, &arguments),
            Command::Linearize(arguments) => linearize::linearize(self.models, &arguments),
            Command::Animate(arguments) => animate::animate(self.models, &arguments),
            Command::Sketch(arguments) => sketch::sketch(self.models, &arguments),
            Command::Gallery(arguments) => gallery::gallery(self.models, &arguments),
            Command::Check(arguments) => check::check(self.models, &arguments),
            Command::Accuracy(arguments) => accuracy::accuracy(self.models, &arguments),
            Command::Equilibrium(arguments) => equilibrium::equilibrium(self.models, &arguments),
            Command::Inverse(arguments) => inverse::inverse(self.models, &arguments),
            Command::Periodic(arguments) => periodic::periodic(self.models, &arguments),
            Command::Export(arguments) => export::export(self.models, &arguments),
            Command::Workspace(arguments) => workspace::workspace(self.models, &arguments),
            Command::Completions(arguments) => shell::completions(self.models, self.clap(program), &arguments),
            Command::Man(arguments) => shell::man(self.clap(program), &arguments),
        }
    }

    pub(super) fn clap(&self, program: &str) -> clap::Command {
        let examples = Examples::new(program, self.models);
        let first_line = self.about.lines().next().unwrap_or_default();
        let commands = Command::augment_subcommands(clap::Command::new(program.to_owned()))
            .about(first_line)
            .long_about(self.about)
            .version(self.version)
            .after_help(format!("{}\n\n{EXIT_STATUS}", examples.of_program()))
            .subcommand_required(self.default.is_none())
            .arg_required_else_help(self.default.is_none())
            .mut_subcommands(|command| match command.get_name() {
                "show" => command.after_help(examples.of_show()),
                "run" => command.after_help(examples.of_run()),
                "plot" => command.after_help(examples.of_plot()),
                "compare" => command.after_help(examples.of_compare()),
                "reactions" => command.after_help(examples.of_reactions()),
                "sweep" => command.after_help(examples.of_sweep()),
                "linearize" => command.after_help(examples.of_linearize()),
                "animate" => command.after_help(examples.of_animate()),
                "sketch" => command.after_help(examples.of_sketch()),
                "check" => command.after_help(examples.of_check()),
                "accuracy" => command.after_help(examples.of_accuracy()),
                "equilibrium" => command.after_help(examples.of_equilibrium()),
                "periodic" => command.after_help(examples.of_periodic()),
                "inverse" => command.after_help(examples.of_inverse()),
                "export" => command.after_help(examples.of_export()),
                "workspace" => command.after_help(examples.of_workspace()),
                _ => command,
            });
        commands.subcommands(self.commands.iter().map(|(command, _)| command.clone()))
    }
}

/// The program as it was called, without its folder.
fn program_name(argument: Option<&OsString>) -> String {
    let stem = argument.and_then(|path| Path::new(path).file_stem()).map(|stem| stem.to_string_lossy().into_owned());
    stem.filter(|stem| !stem.is_empty()).unwrap_or_else(|| "ezy".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn study(_: &ArgMatches) -> Result<(), Failure> {
        Err(Failure::stopped("studied"))
    }

    fn command_line() -> CommandLine<'static> {
        CommandLine::new(&[]).command(clap::Command::new("study"), study)
    }

    #[test]
    fn invariant_commands_are_sound_for_the_parser() {
        command_line().clap("trial").debug_assert();
    }

    #[test]
    fn invariant_added_command_is_done() {
        let command_line = command_line();
        let matches = command_line.clap("trial").try_get_matches_from(["trial", "study"]).unwrap();
        assert!(matches!(command_line.act("trial", &matches), Err(Failure::Stopped(message)) if message == "studied"));
    }

    #[test]
    fn invariant_program_is_named_as_it_was_called() {
        let name = |path: &str| program_name(Some(&OsString::from(path)));
        assert_eq!([name("/a/b/pendulum"), name("./ezy"), name("")], ["pendulum", "ezy", "ezy"]);
        let help = command_line().clap("pendulum").render_help().to_string();
        assert!(help.contains("Usage: pendulum") && help.contains("pendulum list"), "{help}");
    }
}
