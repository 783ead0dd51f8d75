//! The script of a job array.

use std::ffi::OsStr;
use std::path::Path;

use super::failure::Failure;
use ezy_study::output;

/// Name of the file.
const FILE: &str = "sweep.sbatch";

/// Writes the script that computes the sweep of these arguments in `n` shares, and returns how it is submitted.
///
/// # Errors
/// The error of the system.
pub(super) fn write(folder: &Path, name: &str, n: u64) -> Result<String, Failure> {
    let failed = |what: &Path, cause: std::io::Error| Failure::stopped(format!("`{}`: {cause}", what.display()));
    let program = std::env::current_exe().map_err(|cause| failed(Path::new("the program"), cause))?;
    let here = std::env::current_dir().map_err(|cause| failed(Path::new("the working directory"), cause))?;
    let words: Vec<String> = without_slurm(std::env::args_os().skip(1).map(|word| word.to_string_lossy().into_owned()));
    let script = script(&program, &here, &here.join(folder), name, &words, n);
    std::fs::create_dir_all(folder).map_err(|cause| failed(folder, cause))?;
    let file = folder.join(FILE);
    output::write(&file, script).map_err(|cause| failed(&file, cause))?;
    Ok(format!("sbatch {}", quoted(&file.to_string_lossy())))
}

/// The words of the command without those that ask for the script.
fn without_slurm(mut words: impl Iterator<Item = String>) -> Vec<String> {
    let mut kept = Vec::new();
    while let Some(word) = words.next() {
        match word.as_str() {
            "--slurm" => _ = words.next(),
            "--resume" => {}
            _ if word.starts_with("--slurm=") => {}
            _ => kept.push(word),
        }
    }
    kept
}

fn script(program: &Path, here: &Path, folder: &Path, name: &str, words: &[String], n: u64) -> String {
    let of = |path: &Path| quoted(&path.to_string_lossy());
    let command: Vec<String> = std::iter::once(program.as_os_str())
        .chain(words.iter().map(OsStr::new))
        .map(|word| quoted(&word.to_string_lossy()))
        .collect();
    format!(
        "#!/bin/sh\n\
         # A sweep in {n} shares, one task each. A task that is killed and queued again goes on where it ended; so does this\n\
         # script when it is submitted again. When all is done, `ezy merge` says whether each case is there.\n\
         #SBATCH --job-name={name}\n\
         #SBATCH --array=1-{n}\n\
         #SBATCH --cpus-per-task=1\n\
         #SBATCH --requeue\n\
         #SBATCH --open-mode=append\n\
         #SBATCH --output={}\n\
         cd {} || exit 1\n\
         exec {} --shard \"$SLURM_ARRAY_TASK_ID/{n}\" --threads \"${{SLURM_CPUS_PER_TASK:-1}}\"\n",
        of(&folder.join("task-%a.log")),
        of(here),
        command.join(" ")
    )
}

/// A word as a shell reads it back.
fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_./=,:+%".contains(c);
    if !word.is_empty() && word.chars().all(is_plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', "'\\''"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_script_has_the_command_with_its_share() {
        let words =
            ["sweep", "a/b", "--vary", "n=1,2", "--slurm", "8", "--resume", "--slurm=9", "--list", "my cases.csv"];
        let words = without_slurm(words.map(str::to_owned).into_iter());
        let script =
            script(Path::new("/bin/ezy"), Path::new("/home/o'neil"), Path::new("/home/o'neil/out"), "b", &words, 8);
        assert!(
            script.contains("#SBATCH --array=1-8\n") && script.contains("cd '/home/o'\\''neil' || exit 1\n"),
            "{script}"
        );
        let command = "exec /bin/ezy sweep a/b --vary n=1,2 --list 'my cases.csv' --shard \"$SLURM_ARRAY_TASK_ID/8\"";
        assert!(script.contains(command), "{script}");
    }
}
