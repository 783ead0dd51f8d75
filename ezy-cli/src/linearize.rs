//! The command `linearize`. Without the feature `analysis`, how to get it.

use super::Models;
use super::failure::Failure;
use super::steady_arguments::LinearizeArguments;

#[cfg(not(feature = "analysis"))]
pub(super) fn linearize(_: Models<'_>, _: &LinearizeArguments) -> Result<(), Failure> {
    Err(without_analysis())
}

/// How to get the commands that need the feature.
#[cfg(not(feature = "analysis"))]
pub(super) fn without_analysis() -> Failure {
    Failure::wrong_use(
        "this program was built without analysis; add \"analysis\" to the features of ezy-cli in Cargo.toml: \
         ezy-cli = { …, features = [\"analysis\"] }",
    )
}

#[cfg(feature = "analysis")]
pub(super) fn linearize(models: Models<'_>, arguments: &LinearizeArguments) -> Result<(), Failure> {
    use super::failure::print;
    use super::json::print_json;
    use super::linearize_text::{Linearized, json_of, text_of};
    use super::steady::Request;
    use super::{response, root_locus, swing};

    let request = Request::new(models, &arguments.steady)?;
    match (&arguments.vary, &arguments.response[..]) {
        (Some(_), [_, ..]) => {
            return Err(Failure::wrong_use(
                "--response is that of one steady motion, and --vary prints the eigenvalues of many; leave out one of them, \
                 and give another value by --set, --input or --start",
            ));
        }
        (Some(variation), []) => return root_locus::print_locus(&request, arguments, variation),
        (None, [_, ..]) => return response::print_responses(&request, arguments),
        (None, []) if arguments.out.is_some() || arguments.plot.is_some() => {
            return Err(Failure::wrong_use(
                "--out and --plot write what is computed over a value or over the frequency: give \
                 --vary NAME=START:END:STEP or --response INPUT:OUTPUT with them",
            ));
        }
        (None, []) => {}
    }
    swing::check(arguments)?;
    let (motion, linear) = request.linearized(None)?;
    let spectrum = linear.spectrum().map_err(Failure::stopped)?;
    let modes = linear.modes(&spectrum).map_err(Failure::stopped)?;
    let found = Linearized { motion: &motion, linear: &linear, spectrum: &spectrum, modes: &modes };
    let shown = swing::animate_mode(&request, arguments, &motion, &modes)?;
    if arguments.json {
        let mut json = json_of(&found);
        json["animation"] = shown.map_or(serde_json::Value::Null, swing::Shown::json);
        return print_json(&json);
    }
    print(&(text_of(&found) + &shown.map(|shown| shown.text()).unwrap_or_default()))
}
