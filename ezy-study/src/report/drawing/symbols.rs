//! The symbols of a technical drawing, in pixels: x along the element, y downwards. `k` is their size.

use super::number;

fn line(x1: f64, y1: f64, x2: f64, y2: f64) -> String {
    format!("M{} {}L{} {}", number(x1), number(y1), number(x2), number(y2))
}

fn path(class: &str, d: &str) -> String {
    format!("<path class=\"{class}\" d=\"{d}\"/>")
}

fn circle(class: &str, r: f64) -> String {
    format!("<circle class=\"{class}\" r=\"{}\"/>", number(r))
}

/// The mark of a centre of mass: a disc with two black quarters.
pub(super) fn centre_of_mass(k: f64) -> String {
    let r = number(5.0 * k);
    let quarters = format!("M0 0V-{r}A{r} {r} 0 0 1 {r} 0ZM0 0V{r}A{r} {r} 0 0 1 -{r} 0Z");
    circle("paper", 5.0 * k) + &path("solid", &quarters)
}

pub(super) fn hinge(k: f64) -> String {
    circle("paper", 5.5 * k)
}

pub(super) fn point(k: f64) -> String {
    circle("solid", 2.5 * k)
}

/// A hinge on the ground stands on this.
pub(super) fn support(k: f64) -> String {
    let (w, h) = (11.0 * k, 18.0 * k);
    let triangle = format!("M0 0L{} {}H{}Z", number(w), number(h), number(-w));
    path("paper", &triangle) + &path("line", &hatched(-16.0 * k, 16.0 * k, h, k))
}

/// A line with the hatching of the ground below it.
pub(super) fn hatched(from: f64, to: f64, y: f64, k: f64) -> String {
    let n = ((to - from) / (7.0 * k)).floor().max(1.0);
    let strokes = (1..=n as usize).map(|i| {
        let x = from + (to - from) * i as f64 / n;
        line(x, y, x - 7.0 * k, y + 7.0 * k)
    });
    line(from, y, to, y) + &strokes.collect::<String>()
}

/// The guide of a slider on the ground.
pub(super) fn guide([from, to]: [f64; 2], k: f64) -> String {
    path("line", &hatched(from, to, 9.0 * k, k)) + &path("thin", &line(from, -9.0 * k, to, -9.0 * k))
}

/// The guide of a slider on a body.
pub(super) fn slot([from, to]: [f64; 2], k: f64) -> String {
    let h = 9.0 * k;
    let [x, y, w, h, r] = [from, -h / 2.0, to - from, h, h / 2.0].map(number);
    format!("<rect class=\"paper\" x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\" rx=\"{r}\"/>")
}

fn rectangle(class: &str, w: f64, h: f64, r: f64) -> String {
    let (x, y) = (number(-w / 2.0), number(-h / 2.0));
    let (w, h, r) = (number(w), number(h), number(r));
    format!("<rect class=\"{class}\" x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\" rx=\"{r}\"/>")
}

/// What runs in a guide.
pub(super) fn block(k: f64) -> String {
    rectangle("paper", 26.0 * k, 14.0 * k, 2.0 * k)
}

/// A skate: a blade, or a wheel that rolls without slip to the side, from above.
pub(super) fn blade(k: f64) -> String {
    rectangle("solid", 30.0 * k, 7.0 * k, 2.5 * k)
}

/// A wheel whose rolling is driven.
pub(super) fn wheel(k: f64) -> String {
    let treads = [-9.0, -3.0, 3.0, 9.0].map(|x| line(x * k, -5.5 * k, x * k, 5.5 * k)).concat();
    rectangle("paper", 30.0 * k, 11.0 * k, 3.0 * k) + &path("thin", &treads)
}

/// A tyre that slips.
pub(super) fn tyre(k: f64) -> String {
    rectangle("rubber", 32.0 * k, 12.0 * k, 5.0 * k)
}

pub(super) fn weld(k: f64) -> String {
    rectangle("solid", 9.0 * k, 9.0 * k, 0.0)
}

/// Parts between two points are drawn this long, and stretched.
pub(super) const SPAN: f64 = 100.0;

pub(super) fn rod() -> String {
    path("rod", &line(0.0, 0.0, SPAN, 0.0))
}

/// A spring, with a dashpot beside it when it is damped.
pub(super) fn spring(is_damped: bool, k: f64) -> String {
    if !is_damped {
        return path("line", &zigzag(0.0, k));
    }
    let y = 9.0 * k;
    let ends = [20.0, 80.0].map(|x| line(x, -y, x, y)).concat();
    let joined = line(0.0, 0.0, 20.0, 0.0) + &line(80.0, 0.0, SPAN, 0.0);
    path("line", &(zigzag_between(20.0, 80.0, -y, k) + &dashpot_between(20.0, 80.0, y, k) + &ends + &joined))
}

fn zigzag(y: f64, k: f64) -> String {
    line(0.0, y, 18.0, y) + &zigzag_between(18.0, 82.0, y, k) + &line(82.0, y, SPAN, y)
}

fn zigzag_between(from: f64, to: f64, y: f64, k: f64) -> String {
    const N_TEETH: usize = 6;
    let step = (to - from) / (2 * N_TEETH) as f64;
    let teeth = (0..2 * N_TEETH).map(|i| {
        let side = if i % 2 == 0 { -6.0 * k } else { 6.0 * k };
        format!("L{} {}", number(from + (i as f64 + 0.5) * step), number(y + side))
    });
    format!("M{} {}{}L{} {}", number(from), number(y), teeth.collect::<String>(), number(to), number(y))
}

pub(super) fn damper(k: f64) -> String {
    let ends = line(0.0, 0.0, 20.0, 0.0) + &line(80.0, 0.0, SPAN, 0.0);
    path("line", &(ends + &dashpot_between(20.0, 80.0, 0.0, k)))
}

/// A piston in an open cylinder.
fn dashpot_between(from: f64, to: f64, y: f64, k: f64) -> String {
    let (h, quarter) = (6.0 * k, (to - from) / 4.0);
    let (back, open, piston) = (from + quarter, to - quarter, from + 2.0 * quarter);
    let cylinder = format!("M{} {}H{}V{}H{}", number(open), number(y - h), number(back), number(y + h), number(open));
    let rod = line(piston, y - 0.7 * h, piston, y + 0.7 * h) + &line(piston, y, to, y);
    line(from, y, back, y) + &cylinder + &rod
}

/// A spiral spring about a hinge.
pub(super) fn spiral(k: f64) -> String {
    const N: usize = 40;
    let turns = (0..=N).map(|i| {
        let part = i as f64 / N as f64;
        let (r, angle) = ((8.0 + 10.0 * part) * k, part * 2.25 * std::f64::consts::TAU);
        format!("{}{} {}", if i == 0 { 'M' } else { 'L' }, number(r * angle.cos()), number(r * angle.sin()))
    });
    path("thin", &turns.collect::<String>())
}

/// A torque: an arc with an arrowhead, counterclockwise.
pub(super) fn torque(k: f64) -> String {
    let r = 22.0 * k;
    let (x, y) = (r * 0.5, r * 0.866);
    let arc = format!("M{} {}A{} {} 0 1 0 {} {}", number(x), number(y), number(r), number(r), number(-x), number(y));
    let head = format!(
        "M{} {}L{} {}L{} {}",
        number(-x - 8.0 * k),
        number(y - 4.0 * k),
        number(-x),
        number(y),
        number(-x - 2.5 * k),
        number(y - 9.5 * k)
    );
    path("line", &(arc + &head))
}
