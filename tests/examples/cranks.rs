//! Parallel cranks through their level position, by every method.
//!
//! `cargo run --release -p ezy-tests --example cranks` runs the whole family and prints what came of it: runs within their bound, beyond
//! it, and refused, with the message. A word runs the settings whose name holds it (`taylor`, `radau 1e-9`), a second one
//! the members whose name does (`"5 cranks"`).

use ezy_tests::parallel_cranks::judge::Verdict;
use ezy_tests::parallel_cranks::members::members;
use ezy_tests::parallel_cranks::table::run_all;

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (setting, name) = (arguments.first(), arguments.get(1));
    let mut members = members();
    members.retain(|member| name.is_none_or(|name| member.name.contains(name.as_str())));
    let table = run_all(&members, setting.map(String::as_str), |member, setting, judged| {
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
