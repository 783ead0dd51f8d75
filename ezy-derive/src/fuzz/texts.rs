//! The texts: models that are right, and what mistakes make of them and of random ones.

use proc_macro2::{TokenStream, TokenTree};

use super::{grammar, mutate};
use crate::random::Random;

/// What the generator of random models does not write.
pub const GOOD: [&str; 3] = [include_str!("../model/tests/ezy_roller.txt"), MORE, REPEATED];

/// Constructs that the EzyRoller does not need.
const MORE: &str = "pub model More {
    param angle: deg = 30; param k = 1.5e1; let lift = 2 * norm(A.v) ^ 2 - min(k, 3) / cross(A.v, (1, -k));
    body rear { mass: 1, inertia: 2 } body front { mass: 0, inertia: 0 }
    point A = ground(1, k); hinge pin: rear(0, k) ~ A; hinge next: pin ~ front(-k, 0);
    force at rear(0, 1) across front(1, 0): lift * pin.rate;
    start s { rear at (_, _) velocity (k, _) angle -pi / 4 * 0; front vx 1 vy 2; }
    body extra { mass: k, inertia: 1 }
    input raise: mm = 3 by acceleration; rod link: extra(1, 0) ~ front(0, 1) length 2 + k + raise; slot groove: extra(0, 0) ~ ground(0, 0) along extra(k, 1);
    gravity (0, -9.81); spring A ~ front(0, 0): stiffness 3, length 1, damping k; friction rear ~ front: torque 1, rate k;
    velocity constraint rear.omega = k * smooth_step(t, 0, 1) * extra.vx; drive crank: pin.angle = sin(k * t);
    input u: N*m = 2 * 3; output place: mm = (A.x, u / 1e3); output slip = pin.rate;
    state lag: N*m = 2 rate (u - lag) / 3; torque rear: lag; output lagged: N*cm = lag; event late: lag > 3;
    effect wind { input gust = -1; state w = 0 rate max(gust, w) - w * rear.vx + lag; output side: N = gust * rear.vx; force at rear(0, 0): (gust, 2 * u); }
    effect grip { release groove; tyre at front(0, 0) along front(1, 0): stiffness k, limit 2, tread k * extra.vx; }
    stop reach: pin.angle from -k to 2 + 0.1 * t restitution 1 / (2 + abs(pin.rate));
    effect drag { param c: N*s/m = 2; let f = -c * pin.v; force at pin: f; torque rear: c * 3; }
    scene only { start s; until 2 min; with drag, wind; }
}";

/// Counts, arrays and `for`.
const REPEATED: &str = "pub model Repeated {
    count n = 3; count m = 2; param l: m = 1; param c: N*m*s = 0.1;
    body link[n] { mass: 1, inertia: 1 } body node[n, m+1] { mass: n, inertia: 1 } body hub { mass: 1, inertia: 1 }
    hinge top: ground(0, 0) ~ link[0](-l/2, 0);
    for i in 1..n { hinge pin[i]: link[i-1](l/2, 0) ~ link[i](-l/2, 0); point P[i] = link[i](l*i/n, 0); }
    for i in 0..n { for j in 0..m { rod r[i, j]: node[i, j](0, 0) ~ node[i, j+1](0, 0) length l*(i + 1); } }
    for i in 1..n { constraint g[i]: P[i].y = 0.1 * i; output o[i]: rad = pin[i].angle; force at P[i]: (0, -2*i); }
    gravity (0, -9.81); state z: m = 0.5 rate link[n-1].vx - 2 * z / 3; force at hub(0, 0): (z * 2 (N/m), n);
    effect rub { release g; for i in 1..n { torque link[i] ~ link[i-1]: -c * pin[i].rate; } torque hub: c * P[n-1].vx / l; }
    start s { for i in 0..n { link[i] angle 0.1*i; } link[n-1] rate 1; hub at (0, 0); }
    scene all { start s; until 1 s; } scene rubbed { start s; until 1 s; with rub; }
}";

/// A source of texts that are the same on every machine.
pub struct Texts {
    /// Those of [`GOOD`] without their documentation, in which mistakes would not matter.
    good: Vec<String>,
    /// Every token of them.
    all: Vec<TokenTree>,
}

impl Texts {
    pub fn new() -> Self {
        let good = GOOD.map(without_documentation).to_vec();
        let tokens = |text: &String| text.parse::<TokenStream>().expect("good texts are tokens");
        let all = good.iter().map(tokens).flat_map(mutate::flatten).collect();
        Self { good, all }
    }

    /// Text `i` of this seed: a good text or a random model, mostly with mistakes.
    pub fn text(&self, seed: u64, i: u64) -> String {
        // far from the texts of the next seed
        let mut random = Random::new(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15).rotate_left(32) ^ i);
        let foreign = random.below(GOOD.len());
        let model = match random.below(4 * GOOD.len()) {
            i if i < GOOD.len() => self.good[i].clone(),
            _ => grammar::model("Random", &mut random),
        };
        match random.below(10) {
            0 => model,
            1..5 => mutate::letters(&model, &self.good[foreign], &mut random),
            _ => mutate::tokens(model.parse().unwrap_or_default(), &self.all, &mut random).to_string(),
        }
    }
}

fn without_documentation(text: &str) -> String {
    text.lines().filter(|line| !line.trim().starts_with("///")).fold(String::new(), |all, line| all + line + "\n")
}
