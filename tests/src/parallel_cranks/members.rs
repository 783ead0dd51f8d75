//! Which cranks are tried, and how they start.

use super::mechanism::{Crank, Cranks};
use super::pendulum::{Course, Pendulum, Swing};
use crate::fuzz::draw::Draw;
use std::f64::consts::FRAC_PI_2;

/// Cranks with a start and an end.
#[derive(Debug, Clone, PartialEq)]
pub struct Member {
    /// Number of cranks, and how they start.
    pub name: String,
    /// The mechanism.
    pub cranks: Cranks,
    /// Of every crank.
    pub start: Swing,
    /// s
    pub until_s: f64,
}

/// Rates in the level position, in units of √κ, of cranks that start below it: from one that hardly passes to one that hardly feels
/// gravity.
const LEVEL_RATES: [f64; 5] = [0.1, 0.3, 1.0, 3.0, 10.0];

/// Angles from the upright of cranks that are released.
const FROM_UPRIGHT: [f64; 3] = [0.05, 0.2, 0.6];

/// What the motion does in a run: about two turns at its own pace.
const TURNED: f64 = 12.0;

/// All of them.
pub fn members() -> Vec<Member> {
    let written_out = (2..=7).flat_map(|n| of(n, false));
    let counted = (3..=7).flat_map(|n| of(n, true).into_iter().skip(1).step_by(2));
    written_out.chain(counted).collect()
}

/// Uneven cranks with every start.
fn of(n: usize, counted: bool) -> Vec<Member> {
    let kind = if counted { "counted" } else { "cranks" };
    let level = LEVEL_RATES.iter().enumerate().map(|(i, &rate)| {
        let mut draw = Draw::new(n as u64 + if counted { 100 } else { 0 }, i as u64);
        let cranks = uneven(n, counted, &mut draw);
        let pendulum = Pendulum::of(&cranks);
        let level = cranks.level();
        // below the level position, on the side where it rises
        let angle = level - draw.between(0.5, 1.2);
        let rate = rate * pendulum.kappa.sqrt();
        let at_start = (rate * rate + 2.0 * pendulum.kappa * (level.sin() - angle.sin())).sqrt();
        let name = format!("{n} {kind}, level at {rate:.2} rad/s");
        member(name, cranks, Swing { angle, rate: at_start }, rate)
    });
    let released = FROM_UPRIGHT.iter().enumerate().map(|(i, &from_upright)| {
        let mut draw = Draw::new(n as u64 + if counted { 100 } else { 0 }, 10 + i as u64);
        let cranks = uneven(n, counted, &mut draw);
        let side = if draw.once_in(2) { 1.0 } else { -1.0 };
        let start = Swing { angle: FRAC_PI_2 + side * from_upright, rate: 0.0 };
        let name = format!("{n} {kind}, released {from_upright} rad from the upright");
        // a few seconds more to get away from there
        let slow = Pendulum::of(&cranks).kappa.sqrt();
        member(name, cranks, start, slow)
    });
    level.chain(released).collect()
}

fn member(name: String, cranks: Cranks, start: Swing, rate: f64) -> Member {
    let until_s = TURNED / (rate + Pendulum::of(&cranks).kappa.sqrt());
    Member { name, cranks, start, until_s }
}

fn uneven(n: usize, counted: bool, draw: &mut Draw) -> Cranks {
    let length_m = draw.between(0.4, 2.5);
    let (gap, more) = (draw.between(0.3, 1.5), draw.between(0.0, 0.4));
    let alike = one(length_m, draw);
    let mut at_m = 0.0;
    let cranks = (0..n).map(|k| {
        let next = if counted { gap + k as f64 * more } else { draw.between(0.3, 1.5) };
        let place = at_m;
        at_m += next;
        Crank { at_m: place, ..if counted { alike } else { one(length_m, draw) } }
    });
    let cranks = cranks.collect();
    Cranks {
        length_m,
        slope: draw.between(-0.4, 0.4),
        coupler_kg: draw.decades(-0.5, 1.5),
        coupler_kg_m2: draw.decades(-1.3, 0.7),
        behind_m: draw.between(-0.5, 0.5) + 0.5 * at_m,
        cranks,
        counted,
    }
}

fn one(length_m: f64, draw: &mut Draw) -> Crank {
    let mass_kg = draw.decades(-1.0, 1.0);
    let centre_m = length_m * draw.between(0.1, 0.9);
    Crank { at_m: 0.0, mass_kg, centre_m, inertia_kg_m2: mass_kg * length_m * length_m * draw.between(0.02, 0.1) }
}

impl Cranks {
    /// Angle of the cranks, rad, where they lie along the line of the feet.
    pub fn level(&self) -> f64 {
        self.slope.atan()
    }
}

impl Member {
    /// The motion, by the pendulum.
    pub fn course(&self) -> Course {
        Pendulum::of(&self.cranks).run(self.start, self.cranks.level(), self.until_s)
    }
}
