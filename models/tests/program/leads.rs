//! Wrong words lead to the right ones; what would be written without sense is refused.

use super::output;
use crate::run::{assert_wrong_use, directory, ezy, text};

/// Words of a line that is wrong, and what its answer names.
fn leads(line: &str, word: &str) {
    assert_wrong_use(&line.split_whitespace().collect::<Vec<_>>(), word);
}

#[test]
fn invariant_words_of_other_tools_lead_to_words_of_ezy() {
    leads("run ezyroller/coast --dt 1e-3", "use '--step <H>'");
    leads("run ezyroller/coast -dt 1e-3", "use '--step <H>'");
    leads("run ezyroller/coast --m1 3", "write --set m1=VALUE");
    leads("run ezyroller/ridden --torque 3", "write --input torque=VALUE");
    leads("run ezyroller/coast --seat.vx 3", "write --start seat.vx=VALUE");
    leads("run ezyroller/coast --method ode15s", "use '--method radau'");
    leads("plot ezyroller/coast seat.x --vary method=rk4,ode45", "dop853 comes nearest to it");
    leads("simulate ezyroller/coast", "use 'ezy run MODEL/SCENE'");
    leads("rnu ezyroller/coast", "did you mean 'run'?");
    leads("init car", "use 'ezy new NAME'");
    leads("ezyroller/coast", "'ezy run ezyroller/coast'");
}

#[test]
fn invariant_scene_without_its_model_leads_to_the_models_that_have_it() {
    leads("run rolling_out", "did you mean `rollerracer/rolling_out`?");
    leads("run Rolling-Out", "did you mean `rollerracer/rolling_out`?");
    leads("run coast", "did you mean `ezyroller/coast`?); known: ezyroller/coast, ");
    leads("run ezyroller.coast", "did you mean `ezyroller/coast`?");
    leads("run ezyroller coast", "write 'ezyroller/coast'");
    leads("plot rolling_out", "did you mean `rollerracer/rolling_out`?");
    leads("plot ezyroller seat.x", "run one of: ezyroller/coast");
    leads("gallery ezyrolle", "did you mean `ezyroller`?");
}

#[test]
fn invariant_methods_in_any_case_are_known() {
    output(&["run", "ezyroller/coast", "--until", "0.01", "--method", "DOP853"]);
}

#[test]
fn invariant_ending_of_out_that_says_another_format_is_refused() {
    leads("run ezyroller/coast --out x.json", "`x.json`: motions are written as .csv");
    leads("sketch ezyroller/coast --out x.png", "sketches are written as .svg");
    leads("gallery --out x.html", "give --out a folder, such as `x`");
    leads("accuracy ezyroller/coast --out x.csv", "give --out a folder, such as `x`");
}

#[test]
fn invariant_folders_that_are_missing_are_made_by_every_command() {
    let folder = directory("leads_folders");
    let out = |name: &str| folder.join("new").join(name).display().to_string();
    output(&["run", "ezyroller/coast", "--until", "0.01", "--out", &out("run/a.csv")]);
    output(&["plot", "ezyroller/coast", "seat.x", "--until", "0.01", "--out", &out("plot/a.svg")]);
    output(&["sketch", "ezyroller/coast", "--out", &out("sketch/a.svg")]);
    output(&["animate", "ezyroller/coast", "--until", "0.01", "--out", &out("animate/a.html")]);
    assert_eq!(std::fs::read_dir(folder.join("new")).unwrap().count(), 4);
}

#[test]
fn invariant_list_and_gallery_take_one_model() {
    let listed = output(&["list", "pendulum"]);
    assert!(listed.starts_with("Pendulum: ") && !listed.contains("ezyroller"), "{listed}");
    let one = output(&["list", "pendulum/swing"]);
    assert!(one.contains("pendulum/swing") && !one.contains("pendulum/quarter"), "{one}");
    let folder = directory("leads_gallery");
    output(&["gallery", "pendulum/quarter", "--out", folder.to_str().unwrap()]);
    let mut files: Vec<_> = std::fs::read_dir(folder).unwrap().map(|file| file.unwrap().file_name()).collect();
    files.sort();
    assert_eq!(files, ["index.html", "pendulum-quarter.html", "pendulum.svg"]);
}

#[test]
fn invariant_times_are_printed_without_the_rounding_of_their_sum() {
    let printed = output(&["run", "ezyroller/coast", "--until", "0.30000000000000004"]);
    assert!(printed.contains("at t = 0.3 s\n"), "{printed}");
}

#[test]
fn invariant_range_of_values_makes_a_run_of_each() {
    let out = directory("leads_range").join("a.svg");
    output(&["plot", "pendulum/swing", "bob.phi", "--vary", "l=0.4:0.6:0.1", "--out", out.to_str().unwrap()]);
    let svg = std::fs::read_to_string(out).unwrap();
    let of = |l: &str| svg.matches(&format!("aria-label=\"l = {l}\"")).count();
    assert_eq!(["0.4", "0.5", "0.6", "0.7"].map(of), [1, 1, 1, 0]);
    leads("plot pendulum/swing bob.phi --vary l=0.4:0.6", "write START:END:STEP");
}

#[test]
fn invariant_inputs_that_leave_the_start_open_or_have_three_rows_at_a_time_are_refused() {
    let folder = directory("leads_inputs");
    let refuse = |rows: &str, message: &str| {
        let file = folder.join("inputs.csv");
        std::fs::write(&file, format!("t,torque\n{rows}")).unwrap();
        assert_wrong_use(&["run", "ezyroller/ridden", "--inputs", file.to_str().unwrap()], message);
    };
    refuse("0.5,1\n1,2\n", "the first value of `torque` is at t = 0.5 s, after the start of the run at 0 s");
    refuse("0,1\n1,2\n1,3\n1,4\n", "row 4 of the table is the third one at 1 s");
}

#[test]
fn invariant_rows_that_would_fill_a_disk_are_refused_with_their_number() {
    leads("run ezyroller/coast --out x.csv --every 1e-9", "--every 1e-9 makes 1.0e9 rows");
}

/// A limit on the size of files, which would end the program by a signal.
#[cfg(unix)]
#[test]
fn invariant_file_that_grows_beyond_a_limit_ends_with_words_and_keeps_its_rows() {
    let folder = directory("leads_limit");
    let script = "ulimit -f 64; exec \"$0\" run ezyroller/driven --every 1e-4 --out limited.csv";
    let done = std::process::Command::new("sh")
        .args(["-c", script, env!("CARGO_BIN_EXE_ezy")])
        .current_dir(&folder)
        .output()
        .unwrap();
    let stderr = text(&done.stderr);
    assert_eq!(done.status.code(), Some(1), "{stderr}");
    assert!(stderr.contains("could not be written") && stderr.contains("limited.csv.partial"), "{stderr}");
    assert!(std::fs::metadata(folder.join("limited.csv.partial")).unwrap().len() > 10_000);
}

#[test]
fn invariant_commands_help_to_write_a_range() {
    let help = text(&ezy(&["plot", "--help"]).stdout);
    assert!(help.contains("START:END:STEP"), "{help}");
}
