//! How names of a model file look in equations.

use super::print::Printed;

const GREEK: [(&str, &str); 23] = [
    ("alpha", "α"),
    ("beta", "β"),
    ("gamma", "γ"),
    ("delta", "δ"),
    ("epsilon", "ε"),
    ("zeta", "ζ"),
    ("eta", "η"),
    ("theta", "θ"),
    ("iota", "ι"),
    ("kappa", "κ"),
    ("lambda", "λ"),
    ("mu", "μ"),
    ("nu", "ν"),
    ("xi", "ξ"),
    ("pi", "π"),
    ("rho", "ρ"),
    ("sigma", "σ"),
    ("tau", "τ"),
    ("upsilon", "υ"),
    ("phi", "φ"),
    ("chi", "χ"),
    ("psi", "ψ"),
    ("omega", "ω"),
];

/// A name such as `m0`, `omega` or `wheel_base`: trailing digits and whatever follows an underscore become an index.
pub fn name(name: &str) -> Printed {
    let (stem, index) = match name.split_once('_') {
        Some((stem, index)) if !stem.is_empty() && !index.is_empty() => (stem, index.replace('_', " ")),
        _ => {
            let stem = name.trim_end_matches(|c: char| c.is_ascii_digit());
            (stem, name[stem.len()..].to_owned())
        }
    };
    let (latex, mathml) = letter(stem);
    if index.is_empty() || stem.is_empty() {
        return Printed::atom(name, latex, mathml);
    }
    let digits = index.chars().all(|c| c.is_ascii_digit());
    let latex_index = if digits { index.clone() } else { format!("\\mathrm{{{index}}}") };
    Printed::atom(name, format!("{latex}_{{{latex_index}}}"), format!("<msub>{mathml}<mtext>{index}</mtext></msub>"))
}

/// The derivative by time of what has this name.
pub fn time_derivative(of: &Printed) -> Printed {
    Printed::atom(
        format!("d/dt {}", of.text),
        format!("\\frac{{d}}{{dt}} {}", of.latex),
        format!("<mfrac><mi>d</mi><mrow><mi>d</mi><mi>t</mi></mrow></mfrac>{}", of.mathml),
    )
}

/// `letter` with the name of a body as index and a dot when it is a velocity.
pub fn of_body(text: &str, stem: &str, body: &str, dotted: bool) -> Printed {
    let (latex, mathml) = match stem {
        "phi" => ("\\varphi".to_owned(), "<mi>φ</mi>".to_owned()),
        _ => letter(stem),
    };
    let (latex, mathml) = if dotted {
        (format!("\\dot{{{latex}}}"), format!("<mover>{mathml}<mo>.</mo></mover>"))
    } else {
        (latex, mathml)
    };
    let body_latex = body.replace('_', "\\_");
    Printed::atom(
        text,
        format!("{latex}_{{\\mathrm{{{body_latex}}}}}"),
        format!("<msub>{mathml}<mtext>{body}</mtext></msub>"),
    )
}

fn letter(stem: &str) -> (String, String) {
    if let Some((_, greek)) = GREEK.iter().find(|(spelled, _)| *spelled == stem) {
        return (format!("\\{stem}"), format!("<mi>{greek}</mi>"));
    }
    if stem.chars().count() == 1 {
        return (stem.to_owned(), format!("<mi>{stem}</mi>"));
    }
    (format!("\\mathrm{{{}}}", stem.replace('_', "\\_")), format!("<mi>{stem}</mi>"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_names_get_indices_and_greek_letters() {
        assert_eq!(name("m0").latex, "m_{0}");
        assert_eq!(name("omega").latex, "\\omega");
        assert_eq!(name("wheel_base").mathml, "<msub><mi>wheel</mi><mtext>base</mtext></msub>");
        assert_eq!(of_body("seat.vx", "x", "seat", true).latex, "\\dot{x}_{\\mathrm{seat}}");
    }

    #[test]
    fn analytic_indices_follow_an_underscore_or_are_digits() {
        for (written, latex) in [
            ("a_2", "a_{2}"),
            ("a12", "a_{12}"),
            ("wheel_base", "\\mathrm{wheel}_{\\mathrm{base}}"),
            ("k_left_x", "k_{\\mathrm{left x}}"),
            ("theta_0", "\\theta_{0}"),
            ("wheel", "\\mathrm{wheel}"),
            ("_a", "\\mathrm{\\_a}"),
            ("a_", "\\mathrm{a\\_}"),
        ] {
            assert_eq!((name(written).latex, name(written).text), (latex.to_owned(), written.to_owned()));
        }
        assert_eq!(name("x").mathml, "<mi>x</mi>");
        let angle = of_body("left_arm.phi", "phi", "left_arm", false);
        assert_eq!(angle.latex, "\\varphi_{\\mathrm{left\\_arm}}");
        assert_eq!(angle.mathml, "<msub><mi>φ</mi><mtext>left_arm</mtext></msub>");
        let rate = of_body("left_arm.omega", "phi", "left_arm", true);
        assert_eq!(rate.mathml, "<msub><mover><mi>φ</mi><mo>.</mo></mover><mtext>left_arm</mtext></msub>");
    }
}
