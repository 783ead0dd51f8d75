//! Random motions by every method that has a tolerance, judged by two references and by their own amplification.
//!
//! `cargo run --release -p ezy-tests --example methods -- 1000 --seed 1`

use std::collections::BTreeMap;

use ezy_tests::fuzz::Scenes;
use ezy_tests::fuzz::methods::Case;

fn main() -> std::process::ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let option = |name: &str, otherwise: u64| match words.iter().position(|word| word == name) {
        Some(i) => words.get(i + 1).and_then(|text| text.parse().ok()),
        None => Some(otherwise),
    };
    let n = words.first().and_then(|text| text.parse::<u64>().ok());
    let (Some(n), Some(seed), Some(first)) = (n, option("--seed", 1), option("--first", 0)) else {
        eprintln!("usage: methods N [--seed S] [--first I]");
        return std::process::ExitCode::from(2);
    };
    let scenes = Scenes::all();
    let (mut verdicts, mut n_faults) = (BTreeMap::new(), 0);
    for i in first..first + n {
        let faults = Case::new(&scenes, seed, i)
            .judge(|method, verdict| *verdicts.entry((verdict, method.name())).or_insert(0_u64) += 1);
        for fault in faults {
            println!("case {i}: {}\n", fault.shrunk());
            n_faults += 1;
        }
    }
    for ((verdict, method), n) in verdicts {
        println!("{n:>9} {method} {verdict:?}");
    }
    std::process::ExitCode::from(u8::from(n_faults > 0))
}
