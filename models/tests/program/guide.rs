//! The guide tells the truth: its commands run, in the order of the page, and print what the page shows.

use crate::{directory, text};
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// What the page leaves out of what is printed.
const LEFT_OUT: char = '…';

/// A line of the page that begins with `$ `, and the lines below it.
struct Step<'p> {
    line: usize,
    command: &'p str,
    shown: String,
}

fn pages() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/guide/src")
}

/// The steps of the blocks that are fenced as `console`.
fn steps(page: &str) -> Vec<Step<'_>> {
    let mut steps: Vec<Step> = Vec::new();
    let mut within = false;
    for (i, line) in page.lines().enumerate() {
        match line.strip_prefix("$ ") {
            _ if line.starts_with("```") => within = line == "```console",
            Some(command) if within => steps.push(Step { line: i + 1, command, shown: String::new() }),
            None if within => {
                writeln!(steps.last_mut().expect("a command before what it prints").shown, "{line}").unwrap()
            }
            _ => {}
        }
    }
    steps
}

/// The words of a command; what is between single quotes is one word.
fn words(command: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    for (i, part) in command.split('\'').enumerate() {
        if i % 2 == 1 {
            words.last_mut().expect("never empty").push_str(part);
            continue;
        }
        let mut pieces = part.split(' ');
        words.last_mut().expect("never empty").push_str(pieces.next().unwrap_or_default());
        words.extend(pieces.map(str::to_owned));
    }
    words.retain(|word| !word.is_empty());
    words
}

/// `printed` is `shown` but for what is left out.
fn agrees(shown: &str, printed: &str) -> bool {
    let Some((first, rest)) = shown.split_once(LEFT_OUT) else { return shown == printed };
    let Some(mut left) = printed.strip_prefix(first) else { return false };
    let mut pieces: Vec<&str> = rest.split(LEFT_OUT).collect();
    let last = pieces.pop().expect("split gives one piece at least");
    for piece in pieces {
        let Some((_, after)) = left.split_once(piece) else { return false };
        left = after;
    }
    left.ends_with(last)
}

/// Numbers smaller than this are rounding, and other machines have others.
const ROUNDING: f64 = 1e-9;
/// Decimals that all machines have in common.
const DECIMALS: usize = 8;

/// A word as it is compared.
fn canonical(word: &str) -> String {
    let number = word.trim_end_matches([',', ')']);
    match number.parse::<f64>() {
        Ok(value) if number.contains('.') && value.abs() < ROUNDING => format!("0{}", &word[number.len()..]),
        Ok(value) if number.split_once('.').is_some_and(|(_, decimals)| decimals.len() > DECIMALS) => {
            format!("{value:.DECIMALS$}{}", &word[number.len()..])
        }
        _ => word.to_owned(),
    }
}

/// Words with single blanks between them, and numbers without what differs between machines. The page may break long lines.
fn comparable(printed: &str) -> String {
    printed.split_whitespace().map(canonical).collect::<Vec<_>>().join(" ")
}

/// The programs of the guide: `ezy`, the crate of the second chapter, and examples.
fn program(words: &[String]) -> Option<Command> {
    let ezy = Path::new(env!("CARGO_BIN_EXE_ezy"));
    let example =
        |name: &str| ezy.with_file_name("examples").join(name).with_extension(std::env::consts::EXE_EXTENSION);
    let (path, arguments) = match words.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["ezy", ..] => (ezy.to_owned(), &words[1..]),
        ["cargo", "run", "--", ..] => (example("tricycle"), &words[3..]),
        ["cargo", "run", "--example", name] => (example(name), &words[4..]),
        ["cargo", "run", "--example", name, "--", ..] => (example(name), &words[5..]),
        ["cargo", "run", "--features", _, "--example", name] => (example(name), &words[6..]),
        ["cargo", "run", "--features", _, "--example", name, "--", ..] => (example(name), &words[7..]),
        _ => return None,
    };
    assert!(path.exists(), "{} is not built: cargo build -p ezy-models --examples", path.display());
    let mut command = Command::new(path);
    command.args(arguments);
    Some(command)
}

/// Whether the features that a command asks for are on: examples that need others are not built.
fn is_built(words: &[String]) -> bool {
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    match words[..] {
        ["ezy", "equilibrium" | "inverse" | "linearize" | "periodic" | "workspace", ..]
        | ["cargo", "run", "--features", "analysis", ..] => {
            cfg!(feature = "analysis")
        }
        ["ezy", "export", ..] => cfg!(feature = "export"),
        ["cargo", "run", "--features", "optimise", ..] => cfg!(feature = "optimise"),
        _ => !words.contains(&"--features"),
    }
}

/// The first lines of a file, as `head -n N FILE` prints them.
fn head(words: &[String], folder: &Path) -> String {
    let [_, _, lines, file] = words else { panic!("`head -n N FILE`, not {words:?}") };
    let content = fs::read_to_string(folder.join(file)).unwrap();
    content.lines().take(lines.parse().unwrap()).map(|line| format!("{line}\n")).collect()
}

/// Runs the commands of a page in a folder of its own, and tells what is not as shown.
fn faults(name: &str, page: &str) -> Vec<String> {
    let folder = directory(&format!("guide_{name}"));
    fs::create_dir(folder.join("pictures")).unwrap();
    let steps = steps(page);
    let mut faults = Vec::new();
    let mut status = 0;
    // of a program that is not built there are no files
    let mut has_all = true;
    for (i, step) in steps.iter().enumerate() {
        let words = words(step.command);
        let is_there = words[0] != "head" || has_all || folder.join(words.last().unwrap()).exists();
        if !is_built(&words) || !is_there {
            has_all = false;
            continue;
        }
        let printed = match words[0].as_str() {
            "echo" => format!("{status}\n"),
            "head" => head(&words, &folder),
            // what the page shows is what its reader is to write
            "cat" => {
                fs::write(folder.join(&words[1]), &step.shown).unwrap();
                step.shown.clone()
            }
            _ => {
                let mut program = program(&words).unwrap_or_else(|| panic!("{name}: cannot run `{}`", step.command));
                let done = program.current_dir(&folder).output().unwrap();
                status = done.status.code().unwrap_or(-1);
                let asked = steps.get(i + 1).is_some_and(|next| next.command == "echo $?");
                let fails = step.shown.lines().any(|line| line.starts_with("error: "));
                if (status != 0) != fails && !asked {
                    faults.push(format!("{name}:{}: `{}` exits with {status}", step.line, step.command));
                }
                text(&done.stdout) + &text(&done.stderr)
            }
        };
        if !step.shown.is_empty() && !agrees(&comparable(&step.shown), &comparable(&printed)) {
            faults.push(format!("{name}:{}: `{}` prints\n{printed}", step.line, step.command));
        }
    }
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        for picture in fs::read_dir(folder.join("pictures")).unwrap().map(|entry| entry.unwrap().path()) {
            fs::copy(&picture, pages().join("pictures").join(picture.file_name().unwrap())).unwrap();
        }
    }
    // a picture is written by a command of its page, or drawn by hand
    for picture in page.split("](pictures/").skip(1).filter_map(|rest| rest.split_once(')')).map(|(file, _)| file) {
        let by_hand = picture.starts_with("drawn-");
        if has_all && !by_hand && !folder.join("pictures").join(picture).exists() {
            faults.push(format!("{name}: no command of the page writes pictures/{picture}"));
        }
    }
    faults
}

#[test]
fn regress_commands_of_the_guide_print_what_it_shows() {
    let mut names: Vec<PathBuf> = fs::read_dir(pages()).unwrap().map(|entry| entry.unwrap().path()).collect();
    names.retain(|path| path.extension().is_some_and(|extension| extension == "md"));
    names.sort();
    let checked = names.iter().map(|path| {
        let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
        let page = fs::read_to_string(path).unwrap();
        std::thread::spawn(move || faults(&name, &page))
    });
    let checked: Vec<_> = checked.collect();
    let faults: Vec<String> = checked.into_iter().flat_map(|page| page.join().unwrap()).collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn invariant_what_a_page_leaves_out_matches_any_text() {
    assert!(agrees("a\n…\nd\n", "a\nb\nc\nd\n") && agrees("in … s\n", "in 0.1 s\n") && agrees("a\n", "a\n"));
    assert!(!agrees("a\n…\nd\n", "a\nb\nc\ne\n") && !agrees("a\n", "a\nb\n") && !agrees("b…\n", "a b c\n"));
    assert_eq!(comparable("x:  0.250000000004,\n-1.2e-12 2\n"), "x: 0.25000000, 0 2");
    assert_eq!(words("plot m/s '*.phi' --set a=1"), ["plot", "m/s", "*.phi", "--set", "a=1"]);
}

/// The chapter on fits shows lines of programs that only build with their feature: it has no documentation tests.
#[test]
fn cross_programs_of_the_chapter_on_fits_are_those_of_the_examples() {
    let page = fs::read_to_string(pages().join("fits.md")).unwrap();
    let sources = [include_str!("../../examples/fit_pendulum.rs"), include_str!("../../examples/farthest_gait.rs")];
    let known: Vec<&str> = sources.iter().flat_map(|source| source.lines()).map(str::trim).collect();
    let shown = page.split("```rust\n").skip(1).filter_map(|rest| rest.split_once("```")).map(|(block, _)| block);
    for line in shown.flat_map(str::lines).map(str::trim) {
        assert!(known.contains(&line), "`{line}` of the page is in no example");
    }
}

/// The program that stands for the crate of the reader.
#[test]
fn cross_tricycle_has_the_model_of_the_page_and_of_a_new_crate() {
    let page = fs::read_to_string(pages().join("tricycle.md")).unwrap();
    let source = include_str!("../../examples/tricycle.rs");
    let lines = |text: &str| text.lines().map(|line| line.trim().to_owned()).collect::<Vec<_>>();
    let own = lines(source);
    let template = lines(include_str!("../../template/src/my_mechanism.rs"));
    let model = template.iter().skip_while(|line| !line.contains("pub model")).skip(1);
    for line in model.filter(|line| !line.starts_with("//")) {
        assert!(own.contains(line), "`{line}` of the template is not in examples/tricycle.rs");
    }
    let shown = page.split("```rust").skip(1).filter_map(|rest| rest.split_once("```")).map(|(block, _)| block);
    for block in shown.filter(|block| block.contains("\n    pub model Tricycle")) {
        let of_model = block.lines().skip_while(|line| !line.contains("pub model")).take_while(|line| *line != "}");
        for line in of_model.map(str::trim).filter(|line| !line.is_empty()) {
            assert!(own.iter().any(|own| own == line), "`{line}` of the page is not in examples/tricycle.rs");
        }
    }
}
