//! `--vary NAME=A,B,…`: one run for each value.

use clap::ValueEnum;

use super::failure::Failure;
use super::leads;
use super::motion_arguments::MotionArguments;
use super::value::{Assignment, parse_number};
use ezy_core::model::SceneInfo;
use ezy_core::record::{UnknownName, find_name};
use ezy_core::scalar::rounded;

/// A name and the values that it takes, one after the other.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Variation {
    pub name: String,
    pub values: Vec<String>,
}

/// Reads `NAME=A,B,…`, where a part may be a range, START:END:STEP, of a thousand values at most.
pub(super) fn parse_variation(text: &str) -> Result<Variation, String> {
    variation(text, MOST_VALUES)
}

/// As [`parse_variation`], with ranges of a million values.
pub(super) fn parse_axis(text: &str) -> Result<Variation, String> {
    variation(text, MOST_OF_AN_AXIS)
}

fn variation(text: &str, most_values: f64) -> Result<Variation, String> {
    let example = "write NAME=A,B or NAME=START:END:STEP, such as l=0.4,0.5, l=0.4:0.6:0.05 or method=rk4,dop853";
    let (name, values) = text.split_once('=').ok_or_else(|| format!("it has no `=`; {example}"))?;
    let mut all = Vec::new();
    for value in values.split(',').map(str::trim) {
        match value.contains(':') {
            true => all.extend(range(value, most_values)?),
            false => all.push(value.to_owned()),
        }
    }
    if name.trim().is_empty() || all.iter().any(String::is_empty) {
        return Err(format!("a name or a value is missing; {example}"));
    }
    Ok(Variation { name: name.trim().to_owned(), values: all })
}

/// Values of one range at most: each is a run.
const MOST_VALUES: f64 = 1000.0;
const MOST_OF_AN_AXIS: f64 = 1e6;
/// An end that is missed by this part of a step is met: START + n STEP is rounded.
const MET: f64 = 1e-6;
/// Digits of a value: enough for what people type, too few for the rounding of START + n STEP.
const DIGITS: usize = 12;

/// Values from START on, STEP apart, with END where a step meets it.
fn range(text: &str, most_values: f64) -> Result<Vec<String>, String> {
    let parts = text.split(':').map(parse_number).collect::<Result<Vec<f64>, String>>()?;
    let [start, end, step] = parts[..] else {
        return Err(format!("`{text}` is no range; write START:END:STEP, such as 40:60:5"));
    };
    let n = (end - start) / step;
    if n.is_nan() || n < 0.0 {
        return Err(format!(
            "a step of {step} does not lead from {start} to {end}; write START:END:STEP, such as 40:60:5"
        ));
    }
    if n >= most_values {
        return Err(format!("`{text}` has more than {most_values} values, each of them a run; give a longer step"));
    }
    Ok((0..=(n + MET) as u32).map(|i| rounded(start + f64::from(i) * step, DIGITS)).collect())
}

/// What can be varied besides the names of a scene.
const SETTINGS: [&str; 7] = ["method", "step", "rtol", "atol", "angle-tol", "project", "metric"];

/// The arguments of each run, with what tells it from the others: every value of the first variation with every one of the next.
pub(super) fn varied(
    arguments: &MotionArguments,
    variations: &[Variation],
    info: &SceneInfo,
) -> Result<Vec<(String, MotionArguments)>, Failure> {
    let mut all = vec![(String::new(), arguments.clone())];
    for Variation { name, values } in variations {
        let mut next = Vec::new();
        for (label, arguments) in &all {
            for value in values {
                let mut arguments = arguments.clone();
                set(&mut arguments, name, value, info)?;
                let comma = if label.is_empty() { "" } else { ", " };
                next.push((format!("{label}{comma}{name} = {value}"), arguments));
            }
        }
        all = next;
    }
    Ok(all)
}

/// What a value that is varied belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Target {
    /// Place among the parameters.
    Parameter(usize),
    /// Place among the counts.
    Count(usize),
    Input,
    /// A coordinate, a velocity or a first-order state.
    Start,
    /// A method, a tolerance, a step.
    Setting,
}

/// What `name` belongs to.
pub(super) fn target(name: &str, info: &SceneInfo) -> Result<Target, UnknownName> {
    let parameters = || info.parameters.iter().map(|parameter| parameter.name);
    let counts = || info.counts().iter().map(|count| count.name);
    let inputs = || info.inputs.iter().map(|input| input.name);
    let states = || info.states.iter().map(|state| state.name);
    let starts = || info.coordinates.iter().chain(&*info.velocities).map(|c| &*c.name).chain(states());
    let found = parameters().position(|known| known == name).map(Target::Parameter);
    let found = found.or_else(|| counts().position(|known| known == name).map(Target::Count));
    let found = found.or_else(|| inputs().any(|known| known == name).then_some(Target::Input));
    let found = found.or_else(|| starts().any(|known| known == name).then_some(Target::Start));
    let known = || parameters().chain(counts()).chain(inputs()).chain(starts()).chain(SETTINGS);
    match found {
        Some(target) => Ok(target),
        None => find_name("value to vary", name, known()).map(|_| Target::Setting),
    }
}

/// Gives `name` its value, in place of an earlier one.
pub(super) fn set(arguments: &mut MotionArguments, name: &str, value: &str, info: &SceneInfo) -> Result<(), Failure> {
    let wrong = |message: String| Failure::wrong_use(format!("--vary {name}: {message}"));
    let number = || parse_number(value).map_err(wrong);
    let word = |known: Result<(), String>| known.map_err(|message| wrong(format!("`{value}`: {message}")));
    match name {
        "method" => {
            let known = ValueEnum::from_str(value, true).map(|method| arguments.method = Some(method));
            let lead = leads::method(value).map_or(String::new(), |ours| format!("; {ours} comes nearest to it"));
            word(known.map_err(|message| message + &lead))?;
        }
        "project" => word(ValueEnum::from_str(value, true).map(|project| arguments.project = project))?,
        "metric" => word(ValueEnum::from_str(value, true).map(|metric| arguments.metric = metric))?,
        "step" => arguments.step = Some(number()?),
        "rtol" => arguments.rtol = Some(number()?),
        "atol" => arguments.atol = Some(number()?),
        "angle-tol" => arguments.angle_tol = Some(number()?),
        _ => {
            let place = match target(name, info)? {
                Target::Parameter(_) | Target::Count(_) => &mut arguments.set,
                Target::Input => &mut arguments.input,
                Target::Start => &mut arguments.start,
                Target::Setting => return Ok(()),
            };
            place.retain(|assignment| assignment.name != name);
            place.push(Assignment { name: name.to_owned(), value: number()? });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_range_has_both_ends_and_numbers_as_people_write_them() {
        let values = |text: &str| parse_variation(text).map(|variation| variation.values.join(" "));
        let cases = [
            ("m=40:60:5", "40 45 50 55 60"),
            ("m=0:0.3:0.1", "0 0.1 0.2 0.3"),
            ("m=0:1:0.4", "0 0.4 0.8"),
            ("m=1:-1:-1,7", "1 0 -1 7"),
            ("m=2:2:1", "2"),
            ("method=rk4, dop853", "rk4 dop853"),
        ];
        for (text, expected) in cases {
            assert_eq!(values(text).as_deref(), Ok(expected), "{text}");
        }
        for text in ["m=40:60", "m=40:60:-5", "m=40:60:0", "m=40:40:0", "m=0:1:1e-9", "m=a:b:c", "m=1:2:3:4", "m=1,"] {
            assert!(values(text).is_err(), "{text}");
        }
    }
}
