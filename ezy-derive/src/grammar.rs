//! The words that declare constraints and forces, and how each is written. The parser reads by this table, and the resolver
//! checks names, shapes and units by it. The equation of each word is one file of `mechanics/rows` or `mechanics/forces`.

/// A word that declares a constraint or a force.
#[derive(Debug)]
pub struct Word {
    pub word: &'static str,
    pub class: Class,
    /// What follows the word and the name, up to the `;`.
    pub form: &'static [Part],
    pub example: &'static str,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Class {
    /// C(q, t) = 0; its values may depend on positions and the time.
    PositionRow,
    /// S(q, t) v + s_t = 0; its values may depend on velocities, too.
    VelocityRow,
    /// Its values may depend on everything.
    Force,
}

/// A part of a statement.
#[derive(Debug)]
pub enum Part {
    /// `point ~ point`, on different bodies; one may be on the ground.
    Pair,
    /// `at point`, on a body.
    At,
    /// `body ~ body`; one may be the ground.
    Couple,
    /// `body`, or `body ~ body`.
    BodyOrCouple,
    /// `along body(x, y)`
    Along,
    /// `across body(x, y)`
    Across,
    /// `expression`
    Scalar(Expected),
    /// `expression`
    Vector(Expected),
    /// `expression = expression`, of one dimension.
    Equation,
    /// `word expression, word expression`
    Settings(&'static [Setting]),
    /// `:`
    Colon,
    /// `=`
    Equals,
    /// The first of these whose beginning fits.
    Choice(&'static [&'static [Part]]),
}

/// The quantity that an expression gives.
#[derive(Debug, Clone, Copy)]
pub struct Expected {
    /// In a sentence: "a torque".
    pub what: &'static str,
    /// In the units of the language.
    pub unit: &'static str,
}

/// A value with a word of its own.
#[derive(Debug, Clone, Copy)]
pub struct Setting {
    pub word: &'static str,
    pub unit: &'static str,
    pub if_absent: IfAbsent,
    /// Whether it must be positive.
    pub positive: bool,
}

/// The value when none is given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum IfAbsent {
    /// It must be given.
    Required,
    /// This number.
    Number(f64),
    /// The law has no such part.
    Absent,
}

use Class::{Force, PositionRow, VelocityRow};
use IfAbsent::{Absent, Number, Required};
use Part::{Across, Along, At, BodyOrCouple, Choice, Colon, Couple, Equals, Equation, Pair, Scalar, Settings, Vector};

const fn setting(word: &'static str, unit: &'static str, if_absent: IfAbsent) -> Setting {
    Setting { word, unit, if_absent, positive: false }
}

/// A setting that must be given and positive.
const fn positive(word: &'static str, unit: &'static str) -> Setting {
    Setting { word, unit, if_absent: Required, positive: true }
}

const FORCE: Expected = Expected { what: "a force", unit: "N" };
const FORCE_ALONG: Expected = Expected { what: "a force along a direction", unit: "N" };
const TORQUE: Expected = Expected { what: "a torque", unit: "N*m" };
const SPEED: Expected = Expected { what: "a rolling speed", unit: "m/s" };
const GRAVITY: Expected = Expected { what: "gravity", unit: "m/s^2" };

/// The settings of friction at a point.
const FRICTION: &[Setting] = &[setting("force", "N", Required), setting("speed", "m/s", Required)];
/// The same along a direction, on a surface that may move.
const FRICTION_ALONG: &[Setting] = &[FRICTION[0], FRICTION[1], TREAD];
/// The velocity along a direction at which nothing slips.
const TREAD: Setting = setting("tread", "m/s", Absent);

const fn position(word: &'static str, form: &'static [Part], example: &'static str) -> Word {
    Word { word, class: PositionRow, form, example }
}

const fn velocity(word: &'static str, form: &'static [Part], example: &'static str) -> Word {
    Word { word, class: VelocityRow, form, example }
}

const fn force(word: &'static str, form: &'static [Part], example: &'static str) -> Word {
    Word { word, class: Force, form, example }
}

/// Every word, in the order of the manual.
pub static WORDS: &[Word] = &[
    position("hinge", &[Pair], "hinge B: seat(b, 0) ~ bar(-d, 0);"),
    position(
        "slider",
        &[Pair, Along, Settings(&[setting("angle", "rad", Number(0.0))])],
        "slider rail: ground(0, 0) ~ cart(0, 0) along ground(1, 0);",
    ),
    position("slot", &[Pair, Along], "slot pin: arm(0, 0) ~ block(0, 0) along arm(1, 0);"),
    position("rod", &[Pair, Settings(&[positive("length", "m")])], "rod link: ground(0, 0) ~ bob(0, 0) length l;"),
    position(
        "weld",
        &[Pair, Settings(&[setting("angle", "rad", Number(0.0))])],
        "weld joint: a(l, 0) ~ b(0, 0) angle pi/2;",
    ),
    position(
        "gear",
        &[Couple, Settings(&[setting("ratio", "1", Required), setting("offset", "rad", Number(0.0))])],
        "gear mesh: pinion ~ wheel ratio -2;",
    ),
    position("drive", &[Equation], "drive motor: B.angle = omega * t;"),
    position("constraint", &[Equation], "constraint height: A.y = h * A.x^2;"),
    velocity(
        "skate",
        &[At, Along, Settings(&[Setting { word: "limit", unit: "N", if_absent: Absent, positive: true }])],
        "skate rear: at A along seat(1, 0);",
    ),
    velocity("roll", &[At, Along, Equals, Scalar(SPEED)], "roll left: at A along chassis(1, 0) = r * wheel.omega;"),
    velocity("velocity constraint", &[Equation], "velocity constraint clutch: a.omega = 2 * b.omega;"),
    force("gravity", &[Vector(GRAVITY)], "gravity (0, -g);"),
    force(
        "force",
        &[
            At,
            Choice(&[
                &[Along, Colon, Scalar(FORCE_ALONG)],
                &[Across, Colon, Scalar(FORCE_ALONG)],
                &[Colon, Vector(FORCE)],
            ]),
        ],
        "force at A: -k * A.v;",
    ),
    force("torque", &[BodyOrCouple, Colon, Scalar(TORQUE)], "torque seat ~ bar: m0 * cos(omega*t);"),
    force(
        "spring",
        &[
            Pair,
            Colon,
            Settings(&[
                setting("stiffness", "N/m", Required),
                setting("length", "m", Number(0.0)),
                setting("damping", "N*s/m", Absent),
            ]),
        ],
        "spring A ~ ground(0, 0): stiffness k, length l0;",
    ),
    force(
        "damper",
        &[Pair, Colon, Settings(&[setting("damping", "N*s/m", Required)])],
        "damper A ~ ground(0, 0): damping c;",
    ),
    force(
        "torsion",
        &[
            Couple,
            Colon,
            Settings(&[
                setting("stiffness", "N*m", Required),
                setting("angle", "rad", Number(0.0)),
                setting("damping", "N*m*s", Absent),
            ]),
        ],
        "torsion seat ~ bar: stiffness k, angle pi;",
    ),
    force(
        "drag",
        &[
            At,
            Colon,
            Settings(&[
                setting("linear", "N*s/m", Absent),
                setting("quadratic", "N*s^2/m^2", Absent),
                setting("angular", "N*m*s", Absent),
            ]),
        ],
        "drag at A: linear k;",
    ),
    force(
        "friction",
        &[Choice(&[
            &[At, Choice(&[&[Along, Colon, Settings(FRICTION_ALONG)], &[Colon, Settings(FRICTION)]])],
            &[Couple, Colon, Settings(&[setting("torque", "N*m", Required), setting("rate", "rad/s", Required)])],
        ])],
        "friction at A: force mu * n, speed 1e-3;",
    ),
    force(
        "tyre",
        &[
            At,
            Along,
            Colon,
            Settings(&[
                setting("stiffness", "N", Required),
                setting("limit", "N", Absent),
                setting("speed", "m/s", Absent),
                TREAD,
            ]),
        ],
        "tyre at A along seat(1, 0): stiffness c, limit mu * n;",
    ),
];

/// How a part begins.
#[derive(Debug, Clone, Copy)]
pub enum Beginning {
    Word(&'static str),
    Sign(char),
    /// The name of a body or of a point.
    Name,
}

impl Part {
    pub const fn beginning(&self) -> Beginning {
        match self {
            At => Beginning::Word("at"),
            Along => Beginning::Word("along"),
            Across => Beginning::Word("across"),
            Colon => Beginning::Sign(':'),
            Equals => Beginning::Sign('='),
            _ => Beginning::Name,
        }
    }
}

impl Word {
    /// Whether its declarations have names: rows have, forces do not.
    pub fn is_row(&self) -> bool {
        self.class != Force
    }

    /// Whether the name can be left out.
    pub fn may_be_unnamed(&self) -> bool {
        matches!(self.form, [Equation])
    }

    /// Whether it acts on every body without naming one.
    pub fn acts_on_all_bodies(&self) -> bool {
        self.word == "gravity"
    }

    /// Whether its name is also a point, with an angle and a rate.
    pub fn is_hinge(&self) -> bool {
        self.word == "hinge"
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The settings of a form, also inside of choices.
    fn settings(form: &[Part]) -> Vec<&'static str> {
        let of = |part: &Part| match part {
            Settings(settings) => settings.iter().map(|setting| setting.word).collect(),
            Choice(forms) => forms.iter().flat_map(|form| self::settings(form)).collect(),
            _ => Vec::new(),
        };
        form.iter().flat_map(of).collect()
    }

    #[test]
    fn reference_manual_has_every_word_and_setting() {
        let manual = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/language.md");
        let manual = std::fs::read_to_string(manual).expect("the manual is there");
        for Word { word, form, .. } in WORDS {
            let row = format!("| [`{word}`](#{}) | `{word} ", word.replace(' ', "-"));
            let row = manual.lines().find(|line| line.starts_with(&row));
            let row = row.unwrap_or_else(|| panic!("the manual has no line of `{word}`"));
            for setting in settings(form) {
                assert!(row.contains(&format!(" {setting} ")), "`{setting}` of `{word}`");
            }
        }
    }
}
