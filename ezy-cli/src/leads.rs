//! From a word of other tools, or a slip, to the word of this program.

use clap::Command;
use clap::builder::StyledStr;
use clap::error::{ContextKind, ContextValue, ErrorKind};

use super::Models;
use super::quantity;
use super::selection::{find, path};
use ezy_core::model::SceneInfo;

/// Options of other tools, and the options or commands here that do the same.
const OPTIONS: [(&str, &[&str]); 22] = [
    ("dt h timestep deltat stepsize fixed-step", &["--step"]),
    ("hmax dtmax max-step max-dt hmin dtmin min-step", &["--rtol", "--step"]),
    ("tol tolerance precision eps epsilon accuracy error", &["--rtol", "--atol"]),
    ("reltol rel relative relative-tolerance", &["--rtol"]),
    ("abstol abs absolute absolute-tolerance", &["--atol"]),
    ("t-end tf tfinal final-time end end-time duration stop stop-time tmax time length seconds t t1", &["--until"]),
    ("o output csv json-out file outfile output-file save export write dest output-dir outdir dir", &["--out"]),
    ("p param params parameter parameters define d const constant", &["--set"]),
    ("ic ics init initial initial-condition initial-conditions x0 q0 v0 y0 state start-value", &["--start"]),
    ("m solver integrator integration integrate ode scheme algorithm", &["--method"]),
    (
        "sampling sample-rate sample-time output-step output-interval dt-out print-step save-every interval fps rate resolution points",
        &["--every"],
    ),
    ("saveat times t-eval t-span", &["--at", "--every", "--until"]),
    ("u control controls signal signals input-file inputs-file", &["--input", "--inputs"]),
    ("sweep scan range study", &["--vary"]),
    ("projection stabilize stabilise stabilization stabilisation baumgarte constraint-stabilization", &["--project"]),
    ("max-iter max-iterations nsteps steps n", &["--max-steps"]),
    ("print-json format output-format fmt", &["--json", "--out"]),
    ("x xaxis versus vs abscissa phase", &["--against"]),
    ("figure graph chart", &["plot"]),
    ("eig eigen eigenvalue eigenvalues modes modal linearise linearize linearization", &["linearize"]),
    ("animation gif video movie anim render mp4 webm", &["animate"]),
    ("png svg html pdf picture image", &["plot", "sketch", "animate"]),
];

/// Values of other tools, by option, and the value here.
const VALUES: [(&str, &str, &str); 14] = [
    ("--method", "ode45 ode23 rk45 rk23 rkf45 rkck cash-karp dopri dopri5 dp5 dp45 tsit5 bs3 fehlberg", "dop853"),
    ("--method", "ode113 ode78 ode89 dop8 dp8 vern6 vern7 vern8 vern9 adams abm rk78 rkf78 dopri853 dopri8", "dop853"),
    ("--method", "lsoda lsodar lsode cvode vode default auto automatic", "dop853"),
    ("--method", "ode15s ode15i ode23s ode23t ode23tb bdf ida idas dassl daspk dae gear ndf fbdf", "radau"),
    (
        "--method",
        "radau5 radauiia5 radauiia radau2a rodas rodas4 rodas5 rosenbrock sdirk esdirk trbdf2 kencarp4",
        "radau",
    ),
    (
        "--method",
        "implicit stiff impliciteuler backwardeuler generalizedalpha hht hhti3 newmark trapezoidal cranknicolson",
        "radau",
    ),
    ("--method", "euler eulerforward forwardeuler expliciteuler rk rk1 rk3 ssprk3 ode1 ode3 ode4", "rk4"),
    ("--method", "heun rk2 ode2 ralston modifiedeuler explicitmidpoint", "midpoint"),
    ("--method", "rungekutta rungekutta4 classic fixed fixedstep", "rk4"),
    (
        "--method",
        "verlet velocityverlet stormerverlet leapfrog symplectic symplecticeuler semiimplicit semiimpliciteuler yoshida",
        "gauss",
    ),
    ("--method", "gausslegendre gl collocation implicitmidpoint lobatto irk gl6 gl8", "gauss"),
    ("--method", "heyoka tides series ad high multiprecision", "taylor"),
    ("--format", "tex katex mathjax md markdown pdf", "latex"),
    ("--format", "txt plain ascii unicode", "text"),
];

/// Commands of other tools, and the command here with what to write.
const COMMANDS: [(&str, &str, &str); 22] = [
    (
        "bifurcation bifurcations continuation continue branch branches fold folds buckle buckling snap-through hopf",
        "equilibrium",
        "equilibrium MODEL/SCENE --vary NAME=START:END:STEP",
    ),
    ("equilibria trim static statics steady steady-state rest", "equilibrium", "equilibrium MODEL/SCENE"),
    ("torque torques inverse-dynamics id actuators", "inverse", "inverse MODEL/SCENE"),
    (
        "reach reachable singular singularity singularities dead-centre dead-center change-point assembly grashof",
        "workspace",
        "workspace MODEL/SCENE --over COORDINATE=START:END:STEP",
    ),
    ("simulate sim solve integrate start exec execute go compute motion csv save", "run", "run MODEL/SCENE"),
    ("draw picture diagram drawing view viewer svg image", "sketch", "sketch MODEL/SCENE"),
    ("gif animation anim movie video render play player film", "animate", "animate MODEL/SCENE"),
    ("graph chart figure curve curves visualize visualise", "plot", "plot MODEL/SCENE COLUMN"),
    (
        "scan vary range batch parametric montecarlo ensemble doe",
        "sweep",
        "sweep MODEL/SCENE --vary NAME=START:END:STEP",
    ),
    (
        "linearise linearisation linearization linmod eig eigen eigenvalue eigenvalues modes modal stability locus root-locus rlocus",
        "linearize",
        "linearize MODEL/SCENE",
    ),
    (
        "bode bodeplot tf transfer transfer-function freqresp frequency-response response margin margins zeros pzmap",
        "linearize",
        "linearize MODEL/SCENE --response INPUT:OUTPUT",
    ),
    (
        "bench benchmark convergence precision work-precision error errors tolerance methods",
        "accuracy",
        "accuracy MODEL/SCENE",
    ),
    ("floquet monodromy limit-cycle cycle gait orbit shooting poincare", "periodic", "periodic MODEL/SCENE --period S"),
    ("loads bearing bearings joints power powers hodograph", "reactions", "reactions MODEL/SCENE"),
    ("diff cmp difference", "compare", "compare FIRST.csv SECOND.csv"),
    (
        "equations eqs equation print latex tex describe jacobian mass-matrix constraints derive symbolic",
        "show",
        "show MODEL/SCENE",
    ),
    (
        "fmu fmi codegen generate-code code lambdify to-c cpp numpy sympy casadi julia matlab octave",
        "export",
        "export LANGUAGE MODEL/SCENE",
    ),
    ("ls models model scenes scene dir info dof dofs", "list", "list"),
    ("test verify validate selftest assert", "check", "check MODEL"),
    ("init create scaffold generate template project", "new", "new NAME"),
    ("completion complete autocomplete", "completions", "completions bash"),
    ("manual manpage docs doc", "man", "man"),
];

/// What no command and no option does, and the nearest thing.
const ABSENT: [(&str, &str); 21] = [
    (
        "nyquist sensitivity sensitivities",
        "no command draws Nyquist plots or sensitivities; 'linearize --response INPUT:OUTPUT --json' prints margins, and --out writes the response",
    ),
    (
        "optimise optimize fit identify calibrate",
        "no command optimises; 'sweep' runs a scene with many values, and programs loop over scenes, whose parameters are fields",
    ),
    (
        "inverse-kinematics ik kinematic kinematics",
        "'workspace --over BODY.x=START:END:STEP --out FILE.csv' solves for positions; `drive` in a model prescribes a motion, and 'inverse' finds the forces that it takes",
    ),
    (
        "build compile make translate",
        "models are compiled with the crate that holds them: 'cargo build', or 'cargo run -- run MODEL/SCENE'",
    ),
    ("open preview display show", "no window opens: a command writes a file, prints its path, and a browser shows it"),
    (
        "config configuration settings yaml toml preset",
        "no file holds options: values stand in the model or in the line of the command",
    ),
    (
        "verbose v debug quiet q silent loglevel progress no-progress no-color color",
        "there is one level of output: results go to standard output; faults, and a progress bar on a terminal, to standard error",
    ),
    (
        "log logfile logscale logx logy loglog semilogx semilogy",
        "axes have no logarithmic scale, and messages no file of their own; write the numbers with 'run MODEL/SCENE --out FILE.csv', messages with '2> FILE'",
    ),
    (
        "title grid legend label xlabel ylabel xlim ylim xrange yrange dpi height size figsize fontsize style linewidth marker theme subplot",
        "figures choose their axes, labels and sizes; 'run MODEL/SCENE --out FILE.csv' writes the numbers for another program to draw",
    ),
    (
        "speed playback slow slowmotion realtime fast rtf loop zoom camera pause",
        "the page of 'animate' has the speed, the pause and the view beside the picture",
    ),
    (
        "seed random rng",
        "runs and checks have nothing random that changes: each repetition gives the same numbers; 'sweep' has --samples and their --seed",
    ),
    (
        "threads thread jobs j cores cpus parallel gpu",
        "one run takes one core; 'sweep' runs a scene for many values on all cores",
    ),
    (
        "t0 tstart start-time from begin",
        "every run begins at t = 0; --start gives the values there, and --until the end",
    ),
    (
        "backend linear-solver linsolve sparse lu qr klu ldl",
        "the solver of the linear equations follows from the scene; 'show' says how they are solved",
    ),
    (
        "dense interpolate interpolation",
        "--every and --at of 'run' give rows between the steps, from the interpolant of the method",
    ),
    (
        "energy energies stats statistics profile timing counters summary",
        "'run' prints energies, steps and time by itself; --json prints the same for programs",
    ),
    (
        "forces force reactions reaction multipliers events event",
        "'reactions MODEL/SCENE' prints what joints bear; 'run' prints multipliers and events, and --out writes multipliers at all times, as lambda.NAME",
    ),
    ("all everything recursive", "'list' and 'gallery' without a name take all models; the other commands need a name"),
    (
        "results result report read load replay",
        "no command reads results; 'run MODEL/SCENE --out FILE.csv' writes them, 'compare' takes two such files",
    ),
    ("overwrite yes y dry-run", "a file is replaced without a question, and only when the new one is complete"),
    (
        "version help-all usage",
        "write '--version' for the version, '--help' for the options, 'help COMMAND' for those of a command",
    ),
];

/// Words that are typed by themselves, without an option.
const BY_THEMSELVES: &str = "model scene name path column columns var variable variables file input-model";

/// Adds to an error of the parser the words that lead on.
///
/// `arguments`: what was typed, without the program.
pub(super) fn lead_on(error: &mut clap::Error, program: &Command, models: Models<'_>, arguments: &[String]) {
    let typed = |error: &clap::Error, kind| match error.get(kind) {
        Some(ContextValue::String(text)) => Some(text.clone()),
        _ => None,
    };
    let command = arguments.iter().find_map(|word| program.find_subcommand(word)).unwrap_or(program);
    let tips = match error.kind() {
        ErrorKind::UnknownArgument => typed(error, ContextKind::InvalidArg).map(|word| {
            if word.starts_with('-') {
                // the parser takes `-dt` for `-d`
                let whole = |typed: &&String| typed.starts_with(&word) && !word.starts_with("--");
                let whole = arguments.iter().find(whole).unwrap_or(&word);
                let tips = of_option(whole, program, command, models, arguments);
                // the parser has looked at the options of the command, but not at the words of other tools
                let guessed = typed(error, ContextKind::SuggestedArg);
                match nearest_option(whole, guessed.as_deref()).filter(|_| tips.is_empty()) {
                    Some(meant) => of_option(meant, program, command, models, arguments),
                    None => tips,
                }
            } else {
                of_word(&word, models, arguments)
            }
        }),
        ErrorKind::InvalidValue => {
            let option = typed(error, ContextKind::InvalidArg).unwrap_or_default();
            let option = option.split([' ', '=']).next().unwrap_or_default().to_owned();
            typed(error, ContextKind::InvalidValue)
                .and_then(|value| of_value(&option, &value, command))
                .map(|tip| vec![tip])
        }
        ErrorKind::InvalidSubcommand => {
            typed(error, ContextKind::InvalidSubcommand).map(|word| of_command(&word, program, models))
        }
        _ => None,
    };
    let Some(tips) = tips else { return };
    // a guess by letters, and "to pass it as a value", lead astray
    if !tips.is_empty() {
        for kind in [ContextKind::SuggestedArg, ContextKind::SuggestedValue, ContextKind::SuggestedSubcommand] {
            error.remove(kind);
        }
    }
    error.remove(ContextKind::Suggested);
    if !tips.is_empty() {
        let tips = tips.into_iter().map(StyledStr::from).collect();
        error.insert(ContextKind::Suggested, ContextValue::StyledStrs(tips));
    }
}

/// Letters and digits of a word, small.
fn bare(word: &str) -> String {
    word.chars().filter(|c| c.is_alphanumeric()).flat_map(char::to_lowercase).collect()
}

fn has(words: &str, word: &str) -> bool {
    words.split_whitespace().any(|known| bare(known) == bare(word))
}

/// An option that the command does not have.
fn of_option(
    word: &str,
    program: &Command,
    command: &Command,
    models: Models<'_>,
    arguments: &[String],
) -> Vec<String> {
    let name = word.split('=').next().unwrap_or(word).trim_start_matches('-');
    let scene = arguments.iter().find_map(|word| find(models, word).ok()?.scene);
    if let Some(assignment) = scene.and_then(|scene| assignment_of(name, &(scene.info)()))
        && has_option(command, assignment)
    {
        return vec![format!("`{name}` is a name of the scene: write {assignment} {name}=VALUE")];
    }
    let aims = OPTIONS.iter().find(|(words, _)| has(words, name)).map_or(&[][..], |(_, aims)| aims);
    // what the command itself does is asked of its file
    let own = if aims.contains(&command.get_name()) { &["--out"][..] } else { aims };
    let described: Vec<String> = own.iter().filter_map(|aim| described(aim, program, command)).collect();
    if !described.is_empty() {
        return described;
    }
    if let Some(tip) = of_named_value(name, command) {
        return vec![tip];
    }
    if has(BY_THEMSELVES, name) {
        return vec![format!("write the name by itself, without '--{name}'")];
    }
    // `-atol`
    let option = format!("--{name}");
    if has_option(command, &option) {
        return vec![format!("write '{option}', with two signs")];
    }
    if let Some(how) = absent(name) {
        return vec![how];
    }
    // a command that was written as an option
    if let Some((_, own, _)) = COMMANDS.iter().find(|(words, ..)| has(words, name)) {
        let by_itself = format!("'{} {own}' does so without an option", program.get_name());
        return if *own == command.get_name() {
            vec![by_itself]
        } else {
            described_command(own, program).into_iter().collect()
        };
    }
    // an option of another command, under its name here or elsewhere
    let name = aims.first().map_or(name, |aim| aim.trim_start_matches('-'));
    if let Some(tip) = described_command(name, program) {
        return vec![tip];
    }
    let option = format!("--{name}");
    let owners: Vec<&str> =
        program.get_subcommands().filter(|other| has_option(other, &option)).map(Command::get_name).collect();
    match owners[..] {
        [] => {
            let info = scene.filter(|_| has_option(command, "--set")).map(|scene| (scene.info)());
            let parameters = info.iter().flat_map(|info| info.parameters).map(|known| (known.name, known.unit));
            let lead = match quantity::alike(name, parameters) {
                Some((unit, names)) => Some(format!("write --set NAME=VALUE; in {unit}: {}", names.join(", "))),
                None => quantity::unit_of(name).map(|unit| {
                    format!("no parameter here is in {unit}; 'show MODEL/SCENE' prints the parameters, and --set NAME=VALUE changes one")
                }),
            };
            lead.into_iter().collect()
        }
        _ => vec![format!("`{option}` is an option of {}, not of {}", owners.join(", "), command.get_name())],
    }
}

/// How to do without what there is not.
fn absent(word: &str) -> Option<String> {
    ABSENT.iter().find(|(words, _)| has(words, word)).map(|(_, how)| (*how).to_owned())
}

fn has_option(command: &Command, option: &str) -> bool {
    command.get_arguments().any(|arg| arg.get_long() == option.strip_prefix("--"))
}

/// The option that gives `name` its value.
pub(super) fn assignment_of(name: &str, info: &SceneInfo) -> Option<&'static str> {
    let parameters = info.parameters.iter().map(|known| known.name);
    if parameters.chain(info.counts().iter().map(|known| known.name)).any(|known| known == name) {
        return Some("--set");
    }
    if info.inputs.iter().any(|known| known.name == name) {
        return Some("--input");
    }
    let is_state = info.states.iter().any(|known| known.name == name);
    let is_start = info.coordinates.iter().chain(&*info.velocities).any(|known| known.name == name);
    (is_start || is_state).then_some("--start")
}

/// An option or a command with what its help says first.
fn described(aim: &str, program: &Command, command: &Command) -> Option<String> {
    let Some(long) = aim.strip_prefix("--") else { return described_command(aim, program) };
    let arg = command.get_arguments().find(|arg| arg.get_long() == Some(long))?;
    let value = arg.get_value_names().filter(|_| arg.get_action().takes_values());
    let value = value.map_or(String::new(), |names| format!(" <{}>", names[0]));
    Some(format!("use '{aim}{value}': {}", arg.get_help()?))
}

fn described_command(name: &str, program: &Command) -> Option<String> {
    let command = program.get_subcommands().find(|command| command.get_name() == name)?;
    Some(format!("use the command '{} {name}': {}", program.get_name(), command.get_about()?))
}

/// A word that is no option where none is expected: `run ezyroller coast`, `--dt`'s number, `m0=3`.
fn of_word(word: &str, models: Models<'_>, arguments: &[String]) -> Vec<String> {
    let scene = arguments.iter().find_map(|word| find(models, word).ok()?.scene);
    if let Some((name, value)) = word.split_once('=') {
        let option = scene.and_then(|scene| assignment_of(name, &(scene.info)())).unwrap_or("--set");
        return vec![format!("write {option} {name}={value}")];
    }
    let place = arguments.iter().position(|argument| argument == word).filter(|place| *place > 0);
    let joined = place.map(|place| format!("{}/{word}", arguments[place - 1]));
    match joined.and_then(|joined| find(models, &joined).ok()).and_then(|found| Some((found.model, found.scene?))) {
        Some((model, scene)) => vec![format!("write '{}'", path(model, scene))],
        None => Vec::new(),
    }
}

/// A value that an option does not take, but that has a meaning elsewhere.
fn of_value(option: &str, value: &str, command: &Command) -> Option<String> {
    let arg = command.get_arguments().find(|arg| arg.get_long() == option.strip_prefix("--"))?;
    let (_, _, ours) = VALUES.iter().find(|(of, words, _)| *of == option && has(words, value))?;
    let known = arg.get_possible_values().into_iter().find(|known| known.get_name() == *ours)?;
    Some(format!("use '{option} {ours}': {}", known.get_help()?))
}

/// A value that was written as an option: `--latex`, `--radau`, `--tex`.
fn of_named_value(name: &str, command: &Command) -> Option<String> {
    command.get_arguments().find_map(|arg| {
        let option = format!("--{}", arg.get_long()?);
        let known = arg.get_possible_values().into_iter().find(|known| known.get_name() == name);
        match known.filter(|_| arg.get_action().takes_values()) {
            Some(known) => Some(format!("use '{option} {name}': {}", known.get_help()?)),
            None => of_value(&option, name, command),
        }
    })
}

/// The method here that comes nearest to one of another tool.
pub(super) fn method(name: &str) -> Option<&'static str> {
    VALUES.iter().find(|(option, words, _)| *option == "--method" && has(words, name)).map(|(_, _, ours)| *ours)
}

/// Slips in a command or an option, as edits of letters.
const MOST_SLIPS: usize = 2;

/// Letters of an option of other tools that a slip leaves readable.
const LETTERS_OF_A_SLIP: usize = 4;

/// The option of other tools that was misspelt, unless what is `guessed` is as near.
fn nearest_option(word: &str, guessed: Option<&str>) -> Option<&'static str> {
    let name = bare(word.split('=').next().unwrap_or(word));
    let slips = |known: &str| strsim::damerau_levenshtein(&bare(known), &name);
    let known = OPTIONS.iter().flat_map(|(words, _)| words.split_whitespace());
    let near = known.filter(|known| slips(known) <= MOST_SLIPS.min(known.len() / LETTERS_OF_A_SLIP));
    let nearest = near.min_by_key(|known| slips(known));
    nearest.filter(|nearest| guessed.is_none_or(|guessed| slips(nearest) < slips(guessed)))
}

/// A command that there is none of.
fn of_command(word: &str, program: &Command, models: Models<'_>) -> Vec<String> {
    let names: Vec<&str> = program.get_subcommands().map(Command::get_name).collect();
    if let Ok(found) = find(models, word) {
        let command = if found.scene.is_some() { "run" } else { "show" };
        return vec![format!("write a command before it, such as '{} {command} {word}'", program.get_name())];
    }
    let small = word.to_lowercase();
    let slips = |name: &str| strsim::damerau_levenshtein(name, &small);
    let of_table = COMMANDS.iter().find(|(words, name, _)| has(words, word) && names.contains(name));
    let nearest = names.iter().copied().min_by_key(|name| slips(name));
    // of a short word two slips leave nothing
    let nearest = nearest.filter(|name| slips(name) <= MOST_SLIPS.min(name.len() / 2));
    let lead = match (of_table, absent(word), nearest) {
        (Some((_, name, usage)), ..) => {
            let about = program.find_subcommand(name).and_then(Command::get_about).map(ToString::to_string);
            Some(format!("use '{} {usage}': {}", program.get_name(), about.unwrap_or_default()))
        }
        (None, Some(how), _) => Some(how),
        (None, None, Some(name)) => Some(format!("did you mean '{name}'?")),
        (None, None, None) => None,
    };
    lead.into_iter().chain([format!("the commands are: {}", names.join(", "))]).collect()
}

#[cfg(test)]
mod tests {
    use super::super::CommandLine;
    use super::*;
    use clap::builder::PossibleValue;

    fn program() -> Command {
        CommandLine::new(&[]).clap("ezy")
    }

    /// What the program prints of wrong arguments.
    fn answer(line: &str) -> String {
        let words: Vec<String> = line.split_whitespace().map(str::to_owned).collect();
        let program = program();
        let mut error = program.clone().try_get_matches_from(["ezy".to_owned()].iter().chain(&words)).unwrap_err();
        lead_on(&mut error, &program, &[], &words);
        error.to_string()
    }

    #[test]
    fn invariant_every_word_of_the_tables_leads_to_a_word_of_the_program() {
        let program = program();
        let names: Vec<&str> = program.get_subcommands().map(Command::get_name).collect();
        for (words, aims) in OPTIONS {
            for aim in aims {
                let known = program.get_subcommands().any(|command| has_option(command, aim));
                assert!(known || names.contains(aim), "{aim} of {words}");
            }
        }
        for (option, words, ours) in VALUES {
            let args = program.get_subcommands().flat_map(Command::get_arguments);
            let mut args = args.filter(|arg| arg.get_long() == option.strip_prefix("--"));
            let is = |known: &PossibleValue| known.get_name() == ours;
            assert!(args.any(|arg| arg.get_possible_values().iter().any(is)), "{ours} of {words}");
        }
        for (words, name, usage) in COMMANDS {
            // `new` belongs to one program
            assert!(name == "new" || names.contains(&name), "{name} of {words}");
            assert!(usage.starts_with(name), "{usage}");
        }
    }

    #[test]
    fn invariant_words_of_a_table_are_in_one_line_and_are_no_words_of_the_program() {
        let options = OPTIONS.iter().map(|(words, _)| *words).collect::<Vec<_>>();
        let commands = COMMANDS.iter().map(|(words, ..)| *words).collect::<Vec<_>>();
        let methods = VALUES.iter().filter(|(option, ..)| *option == "--method").map(|(_, words, _)| *words).collect();
        let absent = ABSENT.iter().map(|(words, _)| *words).collect::<Vec<_>>();
        let leads = [options.clone(), absent.clone()].concat();
        for table in [leads, [commands, absent].concat(), methods] {
            let words: Vec<String> = table.iter().flat_map(|words| words.split_whitespace()).map(bare).collect();
            for (i, word) in words.iter().enumerate() {
                assert!(!words[..i].contains(word), "{word} twice");
            }
        }
    }

    #[test]
    fn invariant_options_of_other_tools_lead_to_ours() {
        let cases = [
            ("run a/b --dt 1e-3", "use '--step <H>': Step in seconds"),
            ("run a/b --tol 1e-6", "use '--rtol <R>'"),
            ("run a/b --tolerance=1e-6", "use '--atol <A>'"),
            ("run a/b --tolerence 1e-6", "use '--rtol <R>'"),
            ("run a/b --duratoin=3", "use '--until <S>'"),
            ("animate a/b --t-end 3", "use '--until <S>'"),
            ("run a/b -o x.csv", "use '--out <FILE.csv>'"),
            ("run a/b --plot", "use the command 'ezy plot'"),
            (
                "sketch a/b --dt 1",
                "`--step` is an option of run, plot, compare, reactions, sweep, animate, inverse, not of sketch",
            ),
            ("run a/b m0=3", "write --set m0=3"),
            ("run a/b --method ode45", "use '--method dop853': Method of Dormand"),
            ("run a/b --method ode15s", "use '--method radau': Implicit"),
            ("show a/b --format tex", "use '--format latex'"),
            ("run a/b --radau", "use '--method radau'"),
            ("show a/b --tex", "use '--format latex'"),
            ("list --model a", "without '--model'"),
            ("run a/b --format json", "use '--json'"),
            ("list --all", "without a name take all models"),
            ("results a/b", "no command reads results"),
            ("run a/b --gravity 9.81", "no parameter here is in m/s^2"),
            ("run a/b --realtime", "has the speed"),
            ("linearise a/b", "use 'ezy linearize MODEL/SCENE': Finds a steady motion"),
            ("bode a/b", "use 'ezy linearize MODEL/SCENE --response INPUT:OUTPUT'"),
            ("singularities a/b", "use 'ezy workspace MODEL/SCENE --over COORDINATE=START:END:STEP'"),
            ("nyquist a/b", "no command draws Nyquist plots"),
            ("compile a/b", "models are compiled with the crate"),
            ("run a/b --eigenvalues", "use the command 'ezy linearize'"),
            ("run a/b --verbose", "one level of output"),
            ("run a/b --seed 1", "nothing random"),
            ("run a/b --stats", "energies, steps and time"),
            ("run a/b -atol 1e-6", "write '--atol'"),
            ("run a/b --gif", "use the command 'ezy animate'"),
            ("animate a/b --gif", "use '--out <FILE>': The page"),
            ("plot a/b x --png", "use '--out <FILE>': The file"),
            ("plot a/b x --xlim 0,1", "figures choose their axes"),
            ("plot a/b x --show", "no window opens"),
            ("show a/b --jacobian", "'ezy show' does so without an option"),
            ("run a/b --equations", "use the command 'ezy show'"),
            ("rnu a/b", "did you mean 'run'?"),
            ("Simulate a/b", "use 'ezy run MODEL/SCENE': Runs a scene"),
            ("frobnicate", "the commands are: list, show, run"),
        ];
        for (line, expected) in cases {
            let answer = answer(line);
            assert!(answer.contains(expected), "{line}: {answer}");
            assert!(!answer.contains("as a value") && !answer.contains("similar"), "{line}: {answer}");
        }
        // nothing is known of it: nothing is guessed
        assert!(!answer("run a/b --frobnicate").contains("tip:"));
    }
}
