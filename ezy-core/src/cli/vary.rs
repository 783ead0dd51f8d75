//! `--vary NAME=A,B,…`: one run for each value.

use clap::ValueEnum;

use super::failure::Failure;
use super::motion_arguments::MotionArguments;
use super::value::{Assignment, parse_number};
use crate::model::SceneInfo;
use crate::record::find_name;

/// A name and the values that it takes, one after the other.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Variation {
    pub name: String,
    pub values: Vec<String>,
}

/// Reads `NAME=A,B,…`.
pub(super) fn parse_variation(text: &str) -> Result<Variation, String> {
    let example = "write NAME=A,B, such as l=0.4,0.5 or method=rk4,dop853";
    let (name, values) = text.split_once('=').ok_or_else(|| format!("it has no `=`; {example}"))?;
    let values: Vec<String> = values.split(',').map(|value| value.trim().to_owned()).collect();
    if name.trim().is_empty() || values.iter().any(String::is_empty) {
        return Err(format!("a name or a value is missing; {example}"));
    }
    Ok(Variation { name: name.trim().to_owned(), values })
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

/// Gives `name` its value, in place of an earlier one.
fn set(arguments: &mut MotionArguments, name: &str, value: &str, info: &SceneInfo) -> Result<(), Failure> {
    let wrong = |message: String| Failure::wrong_use(format!("--vary {name}: {message}"));
    let number = || parse_number(value).map_err(wrong);
    let word = |known: Result<(), String>| known.map_err(|message| wrong(format!("`{value}`: {message}")));
    match name {
        "method" => word(ValueEnum::from_str(value, true).map(|method| arguments.method = Some(method)))?,
        "project" => word(ValueEnum::from_str(value, true).map(|project| arguments.project = project))?,
        "metric" => word(ValueEnum::from_str(value, true).map(|metric| arguments.metric = metric))?,
        "step" => arguments.step = Some(number()?),
        "rtol" => arguments.rtol = Some(number()?),
        "atol" => arguments.atol = Some(number()?),
        "angle-tol" => arguments.angle_tol = Some(number()?),
        _ => {
            let parameters = info.parameters.iter().map(|parameter| parameter.name);
            let parameters: Vec<&str> = parameters.chain(info.counts().iter().map(|count| count.name)).collect();
            let inputs: Vec<&str> = info.inputs.iter().map(|input| input.name).collect();
            let starts = info.coordinates.iter().flat_map(|c| [&*c.name, &*c.velocity_name]);
            let starts: Vec<&str> = starts.collect();
            let place = match name {
                name if parameters.contains(&name) => &mut arguments.set,
                name if inputs.contains(&name) => &mut arguments.input,
                name if starts.contains(&name) => &mut arguments.start,
                _ => {
                    let known = parameters.iter().chain(&inputs).chain(&starts).chain(&SETTINGS);
                    find_name("value to vary", name, known.copied())?;
                    return Ok(());
                }
            };
            place.retain(|assignment| assignment.name != name);
            place.push(Assignment { name: name.to_owned(), value: number()? });
        }
    }
    Ok(())
}
