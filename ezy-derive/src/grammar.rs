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
    /// `: expression`
    Scalar(Expected),
    /// `: expression`
    Vector(Expected),
    /// An expression without a sign before it.
    BareVector(Expected),
    /// `= expression`
    Equals(Expected),
    /// `expression = expression`, of one dimension.
    Equation,
    /// `word expression, word expression`
    Settings(&'static [Setting]),
    /// `:`
    Colon,
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
#[derive(Debug)]
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
use Part::{
    Across, Along, At, BareVector, BodyOrCouple, Choice, Colon, Couple, Equals, Equation, Pair, Scalar, Settings,
    Vector,
};

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

/// Every word, in the order of the manual.
pub static WORDS: &[Word] = &[
    Word { word: "hinge", class: PositionRow, form: &[Pair], example: "hinge B: seat(b, 0) ~ bar(-d, 0);" },
    Word {
        word: "slider",
        class: PositionRow,
        form: &[Pair, Along, Settings(&[setting("angle", "rad", Number(0.0))])],
        example: "slider rail: ground(0, 0) ~ cart(0, 0) along ground(1, 0);",
    },
    Word {
        word: "slot",
        class: PositionRow,
        form: &[Pair, Along],
        example: "slot pin: arm(0, 0) ~ block(0, 0) along arm(1, 0);",
    },
    Word {
        word: "rod",
        class: PositionRow,
        form: &[Pair, Settings(&[positive("length", "m")])],
        example: "rod link: ground(0, 0) ~ bob(0, 0) length l;",
    },
    Word {
        word: "weld",
        class: PositionRow,
        form: &[Pair, Settings(&[setting("angle", "rad", Number(0.0))])],
        example: "weld joint: a(l, 0) ~ b(0, 0) angle pi/2;",
    },
    Word {
        word: "gear",
        class: PositionRow,
        form: &[Couple, Settings(&[setting("ratio", "1", Required), setting("offset", "rad", Number(0.0))])],
        example: "gear mesh: pinion ~ wheel ratio -2;",
    },
    Word { word: "drive", class: PositionRow, form: &[Equation], example: "drive motor: B.angle = omega * t;" },
    Word { word: "constraint", class: PositionRow, form: &[Equation], example: "constraint height: A.y = h * A.x^2;" },
    Word {
        word: "skate",
        class: VelocityRow,
        form: &[At, Along, Settings(&[Setting { word: "limit", unit: "N", if_absent: Absent, positive: true }])],
        example: "skate rear: at A along seat(1, 0);",
    },
    Word {
        word: "roll",
        class: VelocityRow,
        form: &[At, Along, Equals(SPEED)],
        example: "roll left: at A along chassis(1, 0) = r * wheel.omega;",
    },
    Word {
        word: "velocity constraint",
        class: VelocityRow,
        form: &[Equation],
        example: "velocity constraint clutch: a.omega = 2 * b.omega;",
    },
    Word { word: "gravity", class: Force, form: &[BareVector(GRAVITY)], example: "gravity (0, -g);" },
    Word {
        word: "force",
        class: Force,
        form: &[At, Choice(&[&[Along, Scalar(FORCE_ALONG)], &[Across, Scalar(FORCE_ALONG)], &[Vector(FORCE)]])],
        example: "force at A: -k * A.v;",
    },
    Word {
        word: "torque",
        class: Force,
        form: &[BodyOrCouple, Scalar(TORQUE)],
        example: "torque seat ~ bar: m0 * cos(omega*t);",
    },
    Word {
        word: "spring",
        class: Force,
        form: &[
            Pair,
            Colon,
            Settings(&[
                setting("stiffness", "N/m", Required),
                setting("length", "m", Number(0.0)),
                setting("damping", "N*s/m", Absent),
            ]),
        ],
        example: "spring A ~ ground(0, 0): stiffness k, length l0;",
    },
    Word {
        word: "damper",
        class: Force,
        form: &[Pair, Colon, Settings(&[setting("damping", "N*s/m", Required)])],
        example: "damper A ~ ground(0, 0): damping c;",
    },
    Word {
        word: "torsion",
        class: Force,
        form: &[
            Couple,
            Colon,
            Settings(&[
                setting("stiffness", "N*m", Required),
                setting("angle", "rad", Number(0.0)),
                setting("damping", "N*m*s", Absent),
            ]),
        ],
        example: "torsion seat ~ bar: stiffness k, angle pi;",
    },
    Word {
        word: "drag",
        class: Force,
        form: &[
            At,
            Colon,
            Settings(&[
                setting("linear", "N*s/m", Absent),
                setting("quadratic", "N*s^2/m^2", Absent),
                setting("angular", "N*m*s", Absent),
            ]),
        ],
        example: "drag at A: linear k;",
    },
    Word {
        word: "friction",
        class: Force,
        form: &[Choice(&[
            &[
                At,
                Choice(&[
                    &[Along, Colon, Settings(&[setting("force", "N", Required), setting("speed", "m/s", Required)])],
                    &[Colon, Settings(&[setting("force", "N", Required), setting("speed", "m/s", Required)])],
                ]),
            ],
            &[Couple, Colon, Settings(&[setting("torque", "N*m", Required), setting("rate", "rad/s", Required)])],
        ])],
        example: "friction at A: force mu * n, speed 1e-3;",
    },
    Word {
        word: "tyre",
        class: Force,
        form: &[
            At,
            Along,
            Colon,
            Settings(&[
                setting("stiffness", "N", Required),
                setting("limit", "N", Absent),
                setting("speed", "m/s", Absent),
            ]),
        ],
        example: "tyre at A along seat(1, 0): stiffness c, limit mu * n;",
    },
];

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
        for word in WORDS {
            let line = manual.lines().find(|line| line.starts_with(&format!("| `{} ", word.word)));
            assert!(line.is_some(), "the manual has no line of `{}`", word.word);
            for setting in settings(word.form) {
                let lines = manual.lines().filter(|line| line.contains(word.word));
                assert!(lines.clone().any(|line| line.contains(setting)), "`{setting}` of `{}`", word.word);
            }
        }
    }
}
