//! Parallel cranks through their level position, by every method.

use clap::Args;
use ezy_tests::parallel_cranks::judge::Verdict;
use ezy_tests::parallel_cranks::members::members;
use ezy_tests::parallel_cranks::table::run_all;

/// Runs parallel cranks through their level position by every method
///
/// Prints what came of it: runs within their bound, beyond it, and refused, with the message.
#[derive(Debug, Args)]
pub(crate) struct Asked {
    /// Only settings whose name holds this, as `taylor` or `radau 1e-9`
    setting: Option<String>,
    /// Only members whose name holds this, as `5 cranks`
    member: Option<String>,
}

pub(crate) fn run(asked: &Asked) {
    let mut members = members();
    members.retain(|member| asked.member.as_ref().is_none_or(|name| member.name.contains(name)));
    let table = run_all(&members, asked.setting.as_deref(), |member, setting, judged| {
        let said = match &judged.verdict {
            Verdict::Refused(message) => format!("refused: {message}"),
            Verdict::Untrue(message) => format!("UNTRUE: {message}"),
            Verdict::Stuck => "stuck: its steps became too short".to_owned(),
            _ => format!("off by {:.1e} rad, allowed {:.1e}", judged.error, judged.allowed),
        };
        println!("{member}; {setting}; {} steps; energy {:.1e}; {said}", judged.steps, judged.energy);
    });
    println!("\n{table}");
}
