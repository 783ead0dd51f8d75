//! The vehicle, and parts (a) to (c): the derived equations, and the parameters in them.

use ezy_core::model::{Equation, Scene, SceneInfo};
use ezy_core::simulate::Simulation;
use ezy_study::report::drawing;
use ezy_study::report::page::{Page, Picture, escape};
use ezy_study::report::table::Table;

use super::error::StudyError;
use super::output::Output;
use super::parts::typeset_unit;
use crate::ezy_roller::Driven;

/// Angle of the bar in the sketch, rad: its lengths are then beside those of the seat.
const SKETCHED_ANGLE: f64 = 0.5;
/// Largest sketch on a telephone, pixels: its letters are not made smaller there.
const TELEPHONE: [f64; 2] = [358.0, 500.0];

/// Puts the sketch of the vehicle, parameters and equations on the page.
///
/// # Errors
/// [`StudyError`] when the sketch cannot be written.
pub fn write(page: &mut Page, output: &Output, scene: &Driven) -> Result<(), StudyError> {
    let info = scene.info();
    page.section("model", "The vehicle and its parameters");
    sketch(page, output, scene)?;
    page.paragraph(
        "Two rigid bodies in the plane: body 1, the seat, rolls on the rear wheel A; body 2, the bar, on the front wheel C; the hinge B joins \
         them. A wheel moves along its body only, like a skate. Coordinates are the centres of mass and the absolute angles of both bodies.",
    );
    page.html(&parameters(&info).html("Parameters"));
    let put = |page: &mut Page, names: &[&str]| {
        for equation in info.equations.iter().filter(|equation| names.contains(&equation.name)) {
            one(page, equation);
        }
    };
    put(page, &["coordinates", "velocities"]);
    page.section("a", "(a) Hinge: constraint, Jacobian, convective term");
    put(
        page,
        &["position constraint", "Jacobian of the position constraint", "convective term of the position constraint"],
    );
    page.section("b", "(b) Wheels: constraint, Jacobian, convective term");
    put(
        page,
        &["velocity constraint", "Jacobian of the velocity constraint", "convective term of the velocity constraint"],
    );
    page.section("c", "(c) Equations of motion");
    page.html(
        "<p>Differentiating the constraints until accelerations appear, <i>C<sub>q</sub>a</i> + <i>h</i> = 0 and <i>Sa</i> + <i>s</i> = 0, and adding \
         their reactions −<i>C<sub>q</sub></i><sup>T</sup><i>λ<sub>C</sub></i> − <i>S</i><sup>T</sup><i>λ<sub>S</sub></i> to the applied force <i>F</i> gives \
         one linear system for accelerations and multipliers.</p>",
    );
    put(page, &["equations of motion", "mass matrix", "applied force"]);
    page.paragraph(&format!(
        "The program solves it by an elimination that is written out when it is compiled. One evaluation takes {} multiplications, {} additions, \
         {} division and {} sines and cosines. All of these equations are printed from the expressions that are compiled.",
        info.acceleration_operations.mul,
        info.acceleration_operations.add,
        info.acceleration_operations.div,
        info.acceleration_operations.trig
    ));
    Ok(())
}

fn sketch(page: &mut Page, output: &Output, scene: &dyn Scene) -> Result<(), StudyError> {
    let run = Simulation::new(scene).start("bar.phi", SKETCHED_ANGLE).until(0.0).run()?;
    let wide = drawing::sketch(scene, &run.last());
    output.write("vehicle.svg", &wide)?;
    let narrow = drawing::sketch_within(scene, &run.last(), TELEPHONE);
    page.figure(
        Picture { wide, narrow },
        "The vehicle from above: a, b, c and d are distances along the bodies from their centres of mass.",
        "The seat from the rear wheel A to the hinge B, with its centre of mass at the distance a from A and b from B; the bar from B to the front \
         wheel C, with its centre of mass at the distance d from B and c from C.",
        &["vehicle.svg"],
    );
    Ok(())
}

fn one(page: &mut Page, equation: &Equation) {
    page.paragraph(&format!("{}{}:", equation.name[..1].to_uppercase(), &equation.name[1..]))
        .equation(&capitals(equation.mathml));
    let (text, latex) = (escape(equation.text), escape(equation.latex));
    page.html(&format!("<details><summary>as text and LaTeX</summary><pre>{text}\n{latex}</pre></details>"));
}

/// Moments of inertia and the torque with the letters of textbooks, I₁, I₂ and M₀; parameters of a model file have small ones.
fn capitals(mathml: &str) -> String {
    let index = |letter: &str, index: &str| format!("<mi>{letter}</mi><mtext>{index}</mtext>");
    CAPITALS.into_iter().fold(mathml.to_owned(), |mathml, (letter, of)| {
        mathml.replace(&index(letter, of), &index(&letter.to_uppercase(), of))
    })
}

const CAPITALS: [(&str, &str); 3] = [("i", "1"), ("i", "2"), ("m", "0")];

/// A parameter as the equations show it: `i1` as I₁.
fn symbol(name: &str) -> String {
    let letter = name.trim_end_matches(|c: char| c.is_ascii_digit());
    let index = &name[letter.len()..];
    let letter = match letter {
        "omega" => "ω".to_owned(),
        letter if CAPITALS.contains(&(letter, index)) => letter.to_uppercase(),
        letter => letter.to_owned(),
    };
    letter + &index.replace('0', "₀").replace('1', "₁").replace('2', "₂")
}

fn parameters(info: &SceneInfo) -> Table {
    let mut table = Table::new(["symbol", "name", "value", "unit", "belongs to", "what it is"]);
    for p in info.parameters {
        let (value, unit) = (p.default_text.replace("pi", "π"), typeset_unit(p.unit));
        table.push([&symbol(p.name), p.name, &value, &unit, p.effect.unwrap_or("model"), p.documentation.trim()]);
    }
    table
}
