//! Model texts of any size.

use std::fmt::Write;

/// What is repeated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// Rods, each hinged to the one before.
    Chain,
    /// Loops through a hub: two rods each, from the hub to the ground.
    Hub,
    /// Casters under a cart, each with a skate.
    Casters,
}

impl Shape {
    pub const ALL: [Self; 3] = [Self::Chain, Self::Hub, Self::Casters];

    /// The model with n of them, each written out.
    pub fn text(self, n: usize) -> String {
        let mut text = "model Large { param l: m = 1.0; param r: m = 0.5; gravity (0, -9.81);".to_owned();
        match self {
            Self::Chain => {}
            Self::Hub => text += "body hub { mass: 10, inertia: 5 } torque hub: 1;",
            Self::Casters => text += "body cart { mass: 10, inertia: 5 } torque cart: 1;",
        }
        for i in 0..n {
            text += &self.item(i);
        }
        text + "start rest { at rest; } scene run { start rest; until 1 s; } }"
    }

    fn item(self, i: usize) -> String {
        let mut text = String::new();
        let mut body = |name: &str| {
            let _ = write!(text, "body {name}{i} {{ mass: 1, inertia: 0.1 }} ");
        };
        let rows = match self {
            Self::Chain => {
                body("a");
                let place = if i == 0 { "ground(0, 0)".to_owned() } else { format!("a{}(l/2, 0)", i - 1) };
                format!("hinge p{i}: {place} ~ a{i}(-l/2, 0); ")
            }
            Self::Hub => {
                body("a");
                body("b");
                format!(
                    "hinge p{i}: hub(r*cos({i}), r*sin({i})) ~ a{i}(-l/2, 0); hinge q{i}: a{i}(l/2, 0) ~ b{i}(l/2, 0); \
                     hinge s{i}: ground(r*cos({i}), 2) ~ b{i}(-l/2, 0); "
                )
            }
            Self::Casters => {
                body("a");
                format!("hinge p{i}: cart(0.1*{i}, r) ~ a{i}(l, 0); skate s{i}: at a{i}(-l, 0) along a{i}(1, 0); ")
            }
        };
        text + &rows
    }
}
