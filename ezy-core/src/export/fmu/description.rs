//! `modelDescription.xml`.

use std::fmt::Write as _;

use super::super::Source;
use super::super::head::title;
use super::units::{NAMES, base};
use super::{Version, value_names};
use crate::model::SceneInfo;

/// What an importer may do with a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Role {
    Time,
    Parameter,
    Input,
    /// A state of the motion, which other units may read.
    State,
    /// The derivative of the state whose reference is that much lower.
    Derivative,
    Multiplier,
    Output,
    Event,
}

/// A value of the unit. Its reference is its place.
struct Value {
    name: String,
    role: Role,
    unit: String,
    start: Option<f64>,
    about: String,
}

/// All values, by their references.
fn values(source: &Source<'_>) -> Vec<Value> {
    let info = &source.info;
    let rate = |unit: &str| match (unit, unit.strip_suffix("/s")) {
        ("" | "1", _) => "1/s".to_owned(),
        (_, Some(of)) => format!("{of}/s^2"),
        (unit, None) => format!("{unit}/s"),
    };
    let parameters =
        info.parameters.iter().zip(&source.parameters).map(|(of, &x)| (Role::Parameter, of.unit, x, of.documentation));
    let inputs = info.inputs.iter().map(|of| (Role::Input, of.unit, of.default, of.documentation));
    let of_motion = info.coordinates.iter().zip(source.start.q).chain(info.velocities.iter().zip(source.start.v));
    let states = of_motion.map(|(of, &x)| (Role::State, of.unit, x, ""));
    let states: Vec<_> =
        states.chain(info.states.iter().map(|of| (Role::State, of.unit, of.default, of.documentation))).collect();
    let mut all = vec![(Role::Time, "s".to_owned(), None, "")];
    let with_start = parameters.chain(inputs).chain(states.iter().copied());
    all.extend(with_start.map(|(role, unit, x, about)| (role, unit.to_owned(), Some(x), about)));
    all.extend(states.iter().map(|(_, unit, ..)| (Role::Derivative, rate(unit), None, "")));
    all.extend(info.rows.iter().map(|row| (Role::Multiplier, row.multiplier_unit.to_owned(), None, row.kind)));
    all.extend(info.outputs.iter().map(|of| (Role::Output, of.unit.to_owned(), None, of.documentation)));
    all.extend(info.events.iter().map(|event| (Role::Event, String::new(), None, event.name)));
    let named = value_names(info).into_iter().zip(all);
    let about = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    named.map(|(name, (role, unit, start, text))| Value { name, role, unit, start, about: about(text) }).collect()
}

/// Text within an attribute.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// Attributes with their values, each behind a space.
fn attributes(all: &[(&str, String)]) -> String {
    all.iter().map(|(name, value)| format!(" {name}=\"{}\"", escaped(value))).collect()
}

const LICENCE: &str = "The equations are of whoever wrote the model. All else is of EZY: MIT OR Apache-2.0.";

pub(super) fn description(source: &Source<'_>, version: Version, identifier: &str, token: &str) -> String {
    let info = &source.info;
    let is_two = version == Version::Two;
    let values = values(source);
    let name = format!("{}/{}", info.model, info.name);
    let about: Vec<String> = title(source).into_iter().skip(1).take_while(|line| !line.is_empty()).collect();
    let mut root = vec![
        ("fmiVersion", if is_two { "2.0" } else { "3.0" }.to_owned()),
        ("modelName", name),
        (if is_two { "guid" } else { "instantiationToken" }, token.to_owned()),
        ("description", about.join(" ")),
        ("license", LICENCE.to_owned()),
        ("generationTool", format!("EZY {}", env!("CARGO_PKG_VERSION"))),
        ("variableNamingConvention", "structured".to_owned()),
    ];
    if is_two {
        root.push(("numberOfEventIndicators", info.events.len().to_string()));
    }
    let mut text = format!("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<fmiModelDescription{}>\n", attributes(&root));
    text += &interfaces(version, identifier, source.kernels.derivatives.is_some());
    text += &units(&values, version);
    text += "  <LogCategories>\n    <Category name=\"logStatusError\"/>\n    <Category name=\"logStatusWarning\"/>\n  </LogCategories>\n";
    let _ = writeln!(
        text,
        "  <DefaultExperiment startTime=\"{:?}\" stopTime=\"{:?}\" tolerance=\"1e-8\"/>",
        source.start.t, info.until_s
    );
    text += "  <ModelVariables>\n";
    text += &values.iter().enumerate().map(|(i, value)| variable(info, value, i, version)).collect::<String>();
    text += "  </ModelVariables>\n";
    text += &structure(&values, version);
    text + "</fmiModelDescription>\n"
}

/// Model exchange and co-simulation.
fn interfaces(version: Version, identifier: &str, has_derivatives: bool) -> String {
    let derivatives = has_derivatives.to_string();
    let yes = || "true".to_owned();
    let both = match version {
        Version::Two => [
            ("canGetAndSetFMUstate", yes()),
            ("canSerializeFMUstate", yes()),
            ("providesDirectionalDerivative", derivatives),
        ],
        Version::Three => [
            ("canGetAndSetFMUState", yes()),
            ("canSerializeFMUState", yes()),
            ("providesDirectionalDerivatives", derivatives),
        ],
    };
    let of = |own: (&'static str, String)| {
        let named = ("modelIdentifier", identifier.to_owned());
        attributes(&[&[named, own][..], &both].concat())
    };
    let own_steps = match version {
        Version::Two => ("completedIntegratorStepNotNeeded", "false".to_owned()),
        Version::Three => ("needsCompletedIntegratorStep", yes()),
    };
    let inner = match version {
        Version::Two => "><SourceFiles><File name=\"fmu.c\"/></SourceFiles></",
        Version::Three => "></",
    };
    format!(
        "  <ModelExchange{}{inner}ModelExchange>\n  <CoSimulation{}{inner}CoSimulation>\n",
        of(own_steps),
        of(("canHandleVariableCommunicationStepSize", yes()))
    )
}

/// The units that values have, as far as their names are known with base units.
fn units(values: &[Value], version: Version) -> String {
    let mut names: Vec<&str> = values.iter().map(|value| &*value.unit).filter(|unit| !unit.is_empty()).collect();
    names.sort_unstable();
    names.dedup();
    let unit = |name: &&str| {
        let base = base(name).map(|base| {
            let powers = NAMES.iter().zip(base.powers).filter(|&(_, power)| power != 0);
            let mut all: Vec<(&str, String)> = powers.map(|(name, power)| (*name, power.to_string())).collect();
            if base.factor != 1.0 {
                all.push(("factor", format!("{:?}", base.factor)));
            }
            format!("<BaseUnit{}/>", attributes(&all))
        });
        format!("    <Unit name=\"{}\">{}</Unit>\n", escaped(name), base.unwrap_or_default())
    };
    // the time of FMI 2.0 is no variable
    let all: String = names
        .iter()
        .filter(|&&name| name != "s" || version == Version::Three || values[1..].iter().any(|of| of.unit == name))
        .map(unit)
        .collect();
    format!("  <UnitDefinitions>\n{all}  </UnitDefinitions>\n")
}

fn variable(info: &SceneInfo, value: &Value, reference: usize, version: Version) -> String {
    let (causality, variability, initial) = match value.role {
        Role::Time => ("independent", "continuous", None),
        Role::Parameter => ("parameter", "fixed", Some("exact")),
        Role::Input => ("input", "continuous", None),
        Role::State => ("output", "continuous", Some("exact")),
        Role::Output => ("output", "continuous", Some("calculated")),
        Role::Derivative | Role::Multiplier | Role::Event => ("local", "continuous", Some("calculated")),
    };
    let mut all = vec![
        ("name", value.name.clone()),
        ("valueReference", reference.to_string()),
        ("causality", causality.to_owned()),
        ("variability", variability.to_owned()),
    ];
    all.extend(initial.map(|initial| ("initial", initial.to_owned())));
    if !value.about.is_empty() {
        all.push(("description", value.about.clone()));
    }
    let n_states = info.n_coordinates() + info.n_velocities() + info.n_states();
    let derivative = (value.role == Role::Derivative).then(|| reference - n_states);
    let mut of_type: Vec<(&str, String)> = Vec::new();
    if !value.unit.is_empty() {
        of_type.push(("unit", value.unit.clone()));
    }
    of_type.extend(value.start.map(|start| ("start", format!("{start:?}"))));
    // FMI 2.0 counts variables from one, and the time is none
    of_type.extend(derivative.map(|of| ("derivative", of.to_string())));
    match (version, value.role) {
        (Version::Two, Role::Time) => String::new(),
        (Version::Two, _) => {
            format!("    <ScalarVariable{}><Real{}/></ScalarVariable>\n", attributes(&all), attributes(&of_type))
        }
        (Version::Three, _) => format!("    <Float64{}/>\n", attributes(&[all, of_type].concat())),
    }
}

/// Which values follow from others.
fn structure(values: &[Value], version: Version) -> String {
    let of = |roles: &[Role]| -> Vec<usize> {
        values.iter().enumerate().filter(|(_, value)| roles.contains(&value.role)).map(|(i, _)| i).collect()
    };
    let outputs = of(&[Role::State, Role::Output]);
    let derivatives = of(&[Role::Derivative]);
    let unknown = of(&[Role::Derivative, Role::Output]);
    let list = |element: &str, attribute: &str, all: &[usize]| -> String {
        all.iter().map(|i| format!("    <{element} {attribute}=\"{i}\"/>\n")).collect()
    };
    let inner = match version {
        Version::Two => {
            let group = |name: &str, all: &[usize]| match all {
                [] => String::new(),
                _ => format!("    <{name}>\n{}    </{name}>\n", list("Unknown", "index", all)),
            };
            group("Outputs", &outputs) + &group("Derivatives", &derivatives) + &group("InitialUnknowns", &unknown)
        }
        Version::Three => [
            ("Output", outputs),
            ("ContinuousStateDerivative", derivatives),
            ("InitialUnknown", unknown),
            ("EventIndicator", of(&[Role::Event])),
        ]
        .iter()
        .map(|(element, all)| list(element, "valueReference", all))
        .collect(),
    };
    format!("  <ModelStructure>\n{inner}  </ModelStructure>\n")
}

/// `buildDescription.xml` of FMI 3.0.
pub(super) fn build(identifier: &str) -> String {
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<fmiBuildDescription fmiVersion=\"3.0\">\n  <BuildConfiguration modelIdentifier=\"{}\">\n    \
         <SourceFileSet language=\"C99\"><SourceFile name=\"fmu.c\"/></SourceFileSet>\n  </BuildConfiguration>\n</fmiBuildDescription>\n",
        escaped(identifier)
    )
}
