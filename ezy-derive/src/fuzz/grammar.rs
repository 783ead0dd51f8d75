//! Random models: most are right, some nearly. Rows and forces are written by the table of keywords.

use std::fmt::Write;

use super::values::{Depends, Names, Values};
use crate::grammar::{Class, IfAbsent, Part, Setting, WORDS, Word};
use crate::random::Random;

const MOST_BODIES: usize = 3;
const MOST_FORCES: usize = 4;

/// One name in so many is another.
const SLIP: usize = 300;

/// Units of what can be recorded.
const OUTPUTS: [&str; 6] = ["m", "rad", "m/s", "rad/s", "N", "1"];

struct Writer<'a> {
    random: &'a mut Random,
    names: Names,
    items: Vec<String>,
    /// Rows of the model, for effects that release them.
    rows: Vec<String>,
    n_named: usize,
    /// `[i]` in a loop.
    index: &'static str,
}

/// What the values of a statement may depend on.
fn depends_on(word: &Word) -> Depends {
    match word.class {
        Class::PositionRow => Depends::Positions,
        Class::VelocityRow => Depends::Velocities,
        Class::Force if word.acts_on_all_bodies() => Depends::Parameters,
        Class::Force => Depends::Everything,
    }
}

/// The text of a model of this name.
pub fn model(name: &str, random: &mut Random) -> String {
    let repeated = random.once_in(4);
    let mut writer =
        Writer { random, names: Names::default(), items: Vec::new(), rows: Vec::new(), n_named: 0, index: "" };
    let mut bodies = String::new();
    if repeated {
        let n = 1 + writer.random.below(5);
        writer.names.whole.push("n".to_owned());
        let used = ["link[0]", "link[n-1]"];
        let declared = match writer.random.once_in(2) {
            true => format!("for i in 0..n {{\n{}}}\n", writer.body("link[i]", &used, " * (1 + i/n)^2")),
            false => writer.body("link[n]", &used, ""),
        };
        bodies += &format!("count n = {n};\n{declared}");
    }
    for i in 0..writer.random.below(MOST_BODIES) + usize::from(!repeated) {
        bodies += &writer.body(&format!("b{i}"), &[&format!("b{i}")], "");
    }
    if repeated {
        writer.repeated();
    }
    for i in 0..writer.random.below(3) {
        let place = writer.new_place();
        writer.items.push(format!("point P{i} = {place};"));
        writer.names.points.push(format!("P{i}"));
    }
    for _ in 0..writer.random.below(2 * MOST_BODIES) {
        let row = writer.row();
        writer.items.push(row);
    }
    writer.free_items();
    let (effects, calls) = writer.effects();
    let (starts, end) = (writer.start(), writer.end());
    let mut text = format!("pub model {name} {{\n{}{bodies}", writer.names.declarations);
    writer.items.iter().for_each(|item| text += &format!("    {item}\n"));
    writeln!(text, "{effects}{starts}    scene plain {{ start s; until 0.1 s; {end}}}").expect("a string takes text");
    if !calls.is_empty() {
        text += &format!("    scene whole {{ start s; until 2 min; with {}; }}\n", calls.join(", "));
    }
    text + "}\n"
}

impl Writer<'_> {
    fn values(&mut self) -> Values<'_> {
        Values { random: self.random, names: &mut self.names }
    }

    fn scalar(&mut self, unit: &'static str, depends: Depends) -> String {
        self.values().scalar(unit, depends)
    }

    /// The name, or rarely another.
    fn slip(&mut self, name: &str) -> String {
        if self.random.once_in(SLIP) { format!("{name}x") } else { name.to_owned() }
    }

    /// Mass and inertia are numbers or parameters, with what stands behind them.
    fn body(&mut self, declared: &str, used: &[&str], behind: &str) -> String {
        let [mass, inertia] = ["kg", "kg*m^2"].map(|unit| {
            let number = match self.random.below(8) {
                0 => *self.random.of(&["0", "1e-10", "1e10"]),
                _ => *self.random.of(&["1", "2.5", "0.3"]),
            };
            if self.random.once_in(2) {
                return number.to_owned();
            }
            let name = format!("m{}", self.names.values.len());
            self.names.declarations += &format!("param {name}: {unit} = {number};\n");
            self.names.values.push((name.clone(), unit, Depends::Parameters));
            name
        });
        self.names.bodies.extend(used.iter().map(|name| (*name).to_owned()));
        format!("    body {declared} {{ mass: {mass}{behind}, inertia: {inertia}{behind} }}\n")
    }

    /// A loop over the array, with what stands in it.
    fn repeated(&mut self) {
        let bodies = ["link[i]", "link[i-1]"].map(str::to_owned).to_vec();
        let outside = std::mem::replace(&mut self.names.bodies, bodies);
        self.names.whole.push("i".to_owned());
        self.index = "[i]";
        let mut inside = Vec::new();
        for _ in 0..=self.random.below(3) {
            inside.push(match self.random.below(4) {
                0 => self.force(),
                1 => self.output("o"),
                _ => self.row(),
            });
        }
        self.index = "";
        self.names.whole.pop();
        self.names.bodies = outside;
        for names in [&mut self.names.points, &mut self.names.hinges] {
            names.iter_mut().for_each(|name| *name = name.replace("[i]", "[1]"));
        }
        let (from, to) = (*self.random.of(&["1", "1", "1", "0", "n"]), *self.random.of(&["n", "n", "n", "n-1", "3"]));
        self.items.push(format!("for i in {from}..{to} {{ {} }}", inside.join(" ")));
    }

    /// Values, inputs, states, forces and outputs.
    fn free_items(&mut self) {
        for i in 0..self.random.below(3) {
            let (unit, name) = (*self.random.of(&OUTPUTS), format!("l{i}"));
            let value = self.scalar(unit, Depends::Velocities);
            self.items.push(format!("let {name} = {value};"));
            self.names.values.push((name, unit, Depends::Velocities));
        }
        for i in 0..self.random.below(2) {
            let name = format!("u{i}");
            self.items.push(format!("/// set from outside\n    input {name}: N = {};", self.random.of(&["0", "-1.5"])));
            self.names.values.push((name, "N", Depends::Everything));
        }
        if self.random.once_in(3) {
            let rate = self.scalar("m/s", Depends::Everything);
            self.items.push(format!("state z: mm = {} rate {rate};", self.random.of(&["0", "-1.5"])));
            self.names.values.push(("z".to_owned(), "m", Depends::Everything));
        }
        for _ in 0..self.random.below(MOST_FORCES) {
            let force = self.force();
            self.items.push(force);
        }
        if self.random.once_in(6) {
            let stop = self.stop();
            self.items.push(stop);
        }
        for i in 0..self.random.below(3) {
            let condition = self.condition();
            self.items.push(format!("event a{i}: {condition};"));
        }
        for i in 0..self.random.below(3) {
            let output = self.output(&format!("o{i}"));
            self.items.push(output);
        }
    }

    fn stop(&mut self) -> String {
        let unit = *self.random.of(&["m", "rad"]);
        let mut text = format!("stop end: {}", self.scalar(unit, Depends::Positions));
        for (word, unit) in [("from", unit), ("to", unit), ("restitution", "1")] {
            if self.random.once_in(2) {
                text += &format!(" {word} {}", self.scalar(unit, Depends::Parameters));
            }
        }
        text + ";"
    }

    fn output(&mut self, name: &str) -> String {
        let unit = *self.random.of(&OUTPUTS);
        let vector = self.random.once_in(5);
        let value = match vector {
            true => self.values().vector(unit, Depends::Everything),
            false => self.scalar(unit, Depends::Everything),
        };
        let unit = if self.random.once_in(2) || unit == "1" { String::new() } else { format!(": {unit}") };
        format!("output {name}{}{unit} = {value};", self.index)
    }

    fn effects(&mut self) -> (String, Vec<String>) {
        let (mut text, mut names) = (String::new(), Vec::new());
        for i in 0..self.random.below(3) {
            let mut items = String::new();
            if !self.rows.is_empty() && self.random.once_in(2) {
                items += &format!("release {}; ", self.random.of(&self.rows));
            }
            if self.random.once_in(2) {
                items += &format!("param e{i}: N = {}; input w{i} = 0; output z{i}: N = e{i} * w{i}; ", i + 1);
            }
            for _ in 0..=self.random.below(2) {
                items += &if self.random.once_in(4) { self.row() } else { self.force() };
            }
            text += &format!("    /// effect {i}\n    effect f{i} {{ {items} }}\n");
            names.push(format!("f{i}"));
        }
        (text, names)
    }

    fn start(&mut self) -> String {
        let (mut given, rest) = (String::new(), self.random.once_in(2));
        for body in self.names.bodies.clone() {
            let near = if self.random.once_in(4) { "near " } else { "" };
            given += &match self.random.below(6) {
                0 => format!("{body} {near}at (0.5, -1) angle pi/3; "),
                1 if !rest => format!("{body} {near}at (_, 1e-3) velocity (1, _) rate -2; "),
                2 if !rest => format!("{body} x {} vy 0.1; ", self.scalar("m", Depends::Parameters)),
                3 => format!("{body} angle {}; ", self.scalar("rad", Depends::Parameters)),
                _ => String::new(),
            };
        }
        let rest = if rest { "at rest; " } else { "" };
        format!("    start s {{ {given}{rest}}}\n")
    }

    /// What ends a scene before its time, often nothing.
    fn end(&mut self) -> String {
        match self.random.below(4) {
            0 if self.items.iter().any(|item| item.starts_with("event a0")) => "until a0; ".to_owned(),
            1 => format!("until {}; ", self.condition()),
            _ => String::new(),
        }
    }

    /// A comparison of something that moves, mostly.
    fn condition(&mut self) -> String {
        let (unit, member) = *self.random.of(&[("m", "x"), ("m/s", "vy"), ("rad/s", "omega")]);
        let moving = if self.random.once_in(8) { "1".to_owned() } else { format!("{}.{member}", self.owner(false)) };
        let [added, right] = [0; 2].map(|_| self.scalar(unit, Depends::Everything));
        format!("{moving} + ({added}) {} {right}", self.random.of(&["<", ">", "="]))
    }

    fn row(&mut self) -> String {
        let words: Vec<&Word> = WORDS.iter().filter(|word| word.is_row()).collect();
        let word = *self.random.of(&words);
        self.n_named += 1;
        let name = format!("r{}{}", self.n_named, self.index);
        let form = self.form(word.form, word);
        if self.index.is_empty() {
            self.rows.push(name.clone());
        }
        if word.is_hinge() {
            self.names.points.push(name.clone());
            self.names.hinges.push(name.clone());
        }
        let unnamed = word.may_be_unnamed() && self.random.once_in(3);
        let name = if unnamed { String::new() } else { format!(" {name}:") };
        format!("{}{name}{form};", word.word)
    }

    fn force(&mut self) -> String {
        let words: Vec<&Word> = WORDS.iter().filter(|word| !word.is_row()).collect();
        let word = *self.random.of(&words);
        format!("{}{};", word.word, self.form(word.form, word))
    }

    fn form(&mut self, form: &[Part], word: &Word) -> String {
        form.iter().map(|part| self.part(part, word)).collect()
    }

    fn part(&mut self, part: &Part, word: &Word) -> String {
        match part {
            Part::Pair => self.pair(),
            Part::At => format!(" at {}", self.place(false)),
            Part::Couple => self.couple(),
            Part::BodyOrCouple if self.random.once_in(2) => format!(" {}", self.owner(false)),
            Part::BodyOrCouple => self.couple(),
            Part::Along => format!(" along {}", self.new_place()),
            Part::Across => format!(" across {}", self.new_place()),
            Part::Scalar(asked) if word.class == Class::VelocityRow => format!(" {}", self.linear(asked.unit)),
            Part::Scalar(asked) => format!(" {}", self.scalar(asked.unit, depends_on(word))),
            Part::Vector(asked) => format!(" {}", self.values().vector(asked.unit, depends_on(word))),
            Part::Equation => self.equation(word),
            Part::Settings(settings) => self.settings(settings, word.class == Class::Force),
            Part::Colon => ":".to_owned(),
            Part::Equals => " =".to_owned(),
            Part::Choice(forms) => {
                let form = *self.random.of(forms);
                self.form(form, word)
            }
        }
    }

    fn pair(&mut self) -> String {
        let [first, second] = self.two_owners();
        let second = if self.random.once_in(4) { self.place(true) } else { self.on(&second) };
        format!(" {} ~ {second}", self.on(&first))
    }

    fn equation(&mut self, word: &Word) -> String {
        if word.class == Class::VelocityRow {
            let unit = *self.random.of(&["m/s", "rad/s"]);
            return format!(" {} = {}", self.linear(unit), self.linear(unit));
        }
        let unit = *self.random.of(&["m", "rad"]);
        let right = if word.word == "drive" { Depends::Time } else { depends_on(word) };
        format!(" {} = {}", self.scalar(unit, Depends::Positions), self.scalar(unit, right))
    }

    /// An expression that is linear in velocities, mostly.
    fn linear(&mut self, unit: &'static str) -> String {
        if self.random.once_in(8) {
            return self.scalar(unit, Depends::Velocities);
        }
        let factor = self.scalar("1", Depends::Positions);
        let member = if unit == "m/s" { *self.random.of(&["vx", "vy"]) } else { "omega" };
        format!("({factor}) * {}.{member}", self.owner(false))
    }

    fn settings(&mut self, settings: &[Setting], moves: bool) -> String {
        let depends = if moves && self.random.once_in(3) { Depends::Velocities } else { Depends::Parameters };
        let mut given = Vec::new();
        for setting in settings {
            if setting.if_absent == IfAbsent::Required || self.random.once_in(2) {
                given.push(format!(" {} {}", setting.word, self.scalar(setting.unit, depends)));
            }
        }
        given.join(",")
    }

    fn couple(&mut self) -> String {
        let [first, second] = self.two_owners();
        format!(" {first} ~ {second}")
    }

    /// Two bodies, or one and the ground; rarely one body twice.
    fn two_owners(&mut self) -> [String; 2] {
        let first = self.owner(true);
        let mut second = self.owner(first != "ground");
        for _ in 0..4 {
            if second == first {
                second = self.owner(first != "ground");
            }
        }
        if self.random.once_in(2) { [first, second] } else { [second, first] }
    }

    /// A body, or the ground.
    fn owner(&mut self, or_ground: bool) -> String {
        if self.names.bodies.is_empty() || or_ground && self.random.once_in(4) {
            return "ground".to_owned();
        }
        let body = self.random.of(&self.names.bodies).clone();
        self.slip(&body)
    }

    fn place(&mut self, or_ground: bool) -> String {
        if !self.names.points.is_empty() && self.random.once_in(4) {
            return self.random.of(&self.names.points).clone();
        }
        let owner = self.owner(or_ground);
        self.on(&owner)
    }

    /// A place that is no point.
    fn new_place(&mut self) -> String {
        let owner = self.owner(true);
        self.on(&owner)
    }

    fn on(&mut self, owner: &str) -> String {
        let [x, y] = [0; 2].map(|_| match self.random.below(3) {
            0 => self.values().parameter("m", Depends::Parameters),
            1 => (*self.random.of(&["0", "1", "-0.5", "0.25"])).to_owned(),
            _ => format!("{}/2", self.values().parameter("m", Depends::Parameters)),
        });
        format!("{owner}({x}, {y})")
    }
}
