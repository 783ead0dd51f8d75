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
        "this program was built without analysis; add \"analysis\" to the features of ezy-core in Cargo.toml: \
         ezy-core = { …, features = [\"cli\", \"analysis\"] }",
    )
}

#[cfg(feature = "analysis")]
pub(super) fn linearize(models: Models<'_>, arguments: &LinearizeArguments) -> Result<(), Failure> {
    use super::failure::print;
    use super::json::print_json;
    use super::linearize_text::{Linearized, json_of, text_of};
    use super::root_locus;
    use super::steady::Request;

    let request = Request::new(models, &arguments.steady)?;
    if let Some(variation) = &arguments.vary {
        return root_locus::print_locus(&request, arguments, variation);
    }
    let (motion, linear) = request.linearized(None)?;
    let spectrum = linear.spectrum().map_err(Failure::stopped)?;
    let modes = linear.modes(&spectrum).map_err(Failure::stopped)?;
    let found = Linearized { motion: &motion, linear: &linear, spectrum: &spectrum, modes: &modes };
    if arguments.json { print_json(&json_of(&found)) } else { print(&text_of(&found)) }
}
