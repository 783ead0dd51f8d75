//! The parts of a drawing, and where each is at a state.

use super::elements::{Anchor, Elements, Placed, Vector};
use super::outline::rounded_hull;
use super::{number, symbols};
use crate::report::page::escape;
use ezy_core::model::coordinate::of_body;
use ezy_core::model::{ElementInfo, Scene};

/// What moves as one.
#[derive(Debug, Clone)]
pub struct Part {
    /// Classes for the style: what it is.
    pub class: String,
    /// What it is, for a reader of the picture: `skate rear`.
    pub title: String,
    /// Where it is.
    pub motion: Motion,
    /// SVG in pixels about its own origin, y downwards.
    pub svg: String,
    /// From where to where a guide reaches along its direction, pixels.
    pub(super) reach: [f64; 2],
}

/// Where a part is at a state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Motion {
    /// With a body.
    Body(usize),
    /// At a point, along a direction where there is one.
    At {
        /// The point.
        point: Anchor,
        /// The direction of x.
        along: Option<Anchor>,
    },
    /// From one point to another: x is stretched.
    Span {
        /// Where x is 0.
        from: Anchor,
        /// Where x is 100.
        to: Anchor,
    },
}

/// A scene as parts.
#[derive(Debug, Clone)]
pub struct Drawing {
    /// Pixels for a metre.
    pub scale: f64,
    /// Size of symbols: 1 where there is room.
    pub symbols: f64,
    /// The elements that it shows.
    pub elements: Elements,
    /// From the back to the front.
    pub parts: Vec<Part>,
    /// Left, right, bottom and top of the start, m.
    box_m: [f64; 4],
}

/// Largest disc of a body with one point, over the size of the mechanism.
const LARGEST_DISC: f64 = 0.25;
/// Length of a usual body in an animation, pixels.
const BODY: f64 = 100.0;
/// Symbols have their full size on a body of this length, pixels.
const FULL_SIZE: f64 = 90.0;
const SMALLEST_SYMBOLS: f64 = 0.25;
/// Bodies up to here have marks of their centres of mass.
const MOST_CENTRES: usize = 40;
/// Bodies up to here have symbols of their hinges and points.
const MOST_HINGED: usize = 200;
/// Hues of bodies, by the classes `hue0`, `hue1`, …
const N_HUES: usize = 6;

impl Drawing {
    /// The scene at `start`, which sets sizes, and in later `frames`, to which guides reach. `width` is that of the picture in
    /// pixels; without it a usual body is 100 pixels long.
    pub fn new(scene: &dyn Scene, elements: Elements, start: &Placed, frames: &[Placed], width: Option<f64>) -> Self {
        let info = scene.info();
        let bodies = info.drawn_bodies();
        let centres = (0..bodies.len()).map(|i| start.centre(i));
        let reach = side(bounds(elements.points().map(|point| start.position(point)).chain(centres)));
        let spans: Vec<Body> = (0..bodies.len()).map(|i| Body::new(i, &elements, start, reach)).collect();
        let usual = usual_length(&spans);
        let box_m = extent(&elements, &spans, start);
        let scale = match width {
            // a body of one point fills no sheet
            Some(width) if reach <= 0.0 => 0.3 * width / usual,
            Some(width) => width / side(box_m).max(usual),
            None => BODY / usual,
        };
        let k = (usual * scale / FULL_SIZE).clamp(SMALLEST_SYMBOLS, 1.0);
        let mut writer = Writer { scale, k, elements: &elements, start, frames, parts: Vec::new() };
        for (i, element) in elements.iter() {
            writer.ground(i, element);
        }
        let mut order: Vec<usize> = (0..spans.len()).collect();
        order.sort_by(|&a, &b| spans[b].length.total_cmp(&spans[a].length));
        for i in order {
            writer.body(i, &bodies[i], &spans[i]);
        }
        for (i, element) in elements.iter() {
            writer.between(i, element);
        }
        // among so many bodies a hinge is a dot, and a browser draws all of them
        let is_seen = |kind: &str| spans.len() <= MOST_HINGED || !matches!(kind, "hinge" | "point");
        for (i, element) in elements.iter().filter(|(_, element)| is_seen(element.kind)) {
            writer.symbol(i, element);
        }
        if spans.len() <= MOST_CENTRES {
            for (i, body) in bodies.iter().enumerate() {
                writer.push("centre", format!("centre of mass of {body}"), Motion::Body(i), symbols::centre_of_mass(k));
            }
        }
        let parts = writer.parts;
        Self { scale, symbols: k, box_m, elements, parts }
    }

    /// The box around points and bodies at the start, in pixels: left, top, width, height.
    pub fn outline(&self) -> [f64; 4] {
        let [left, right, bottom, top] = self.box_m.map(|x| x * self.scale);
        [left, -top, right - left, top - bottom]
    }

    /// A point on the sheet, y downwards.
    pub fn pixels(&self, [x, y]: Vector) -> Vector {
        [x * self.scale, -y * self.scale]
    }

    /// Points and directions that parts stand at; some more than once.
    pub fn anchors(&self) -> impl Iterator<Item = Anchor> + '_ {
        let of_parts = self.parts.iter().flat_map(|part| match part.motion {
            Motion::Body(_) => [None, None],
            Motion::At { point, along } => [Some(point), along],
            Motion::Span { from, to } => [Some(from), Some(to)],
        });
        of_parts.flatten().chain(self.elements.points())
    }

    /// The attribute `transform` of a part at a state.
    pub fn transform(&self, of: &Part, at: &Placed) -> String {
        let Pose { x, y, turn, stretch } = self.pose(of, at);
        let stretch = stretch.map(|stretch| format!("scale({} 1)", (stretch * 1e4).round() / 1e4));
        let turn = turn.map(|turn| format!("rotate({})", number(turn)));
        format!("translate({} {}){}{}", number(x), number(y), turn.unwrap_or_default(), stretch.unwrap_or_default())
    }

    /// Where a part is on the sheet.
    pub(super) fn pose(&self, of: &Part, at: &Placed) -> Pose {
        let turned = |[x, y]: Vector| -y.atan2(x).to_degrees();
        let (place, turn, stretch) = match of.motion {
            Motion::Body(i) => (at.centre(i), Some(-at.angle(i).to_degrees()), None),
            Motion::At { point, along } => (at.position(point), along.map(|along| turned(at.direction(along))), None),
            Motion::Span { from, to } => {
                let (a, b) = (at.position(from), at.position(to));
                let gap = [b[0] - a[0], b[1] - a[1]];
                let stretch = gap[0].hypot(gap[1]) * self.scale / symbols::SPAN;
                (a, Some(turned(gap)), Some(stretch))
            }
        };
        let [x, y] = self.pixels(place);
        Pose { x, y, turn, stretch }
    }
}

/// Where a part is on the sheet.
pub(super) struct Pose {
    pub x: f64,
    pub y: f64,
    /// Degrees, clockwise.
    pub turn: Option<f64>,
    /// Of a part between two points.
    pub stretch: Option<f64>,
}

/// The points of a body.
struct Body {
    /// In its axes, m; the centre of mass is the first.
    points: Vec<Vector>,
    /// Largest distance of two of them; of a body with one point, twice its radius of gyration.
    length: f64,
    is_single: bool,
}

impl Body {
    fn new(i: usize, elements: &Elements, start: &Placed, reach: f64) -> Self {
        let own = elements.points().filter(|point| point.body == Some(i)).map(|point| start.local(point));
        let points: Vec<Vector> = std::iter::once([0.0; 2]).chain(own).collect();
        let distance = |a: &Vector, b: &Vector| (a[0] - b[0]).hypot(a[1] - b[1]);
        let far = points.iter().flat_map(|a| points.iter().map(move |b| distance(a, b))).fold(0.0, f64::max);
        let [mass, _, inertia] = of_body(elements.mass(), i);
        let gyration = (inertia / mass).sqrt();
        let gyration = if gyration.is_finite() { 2.0 * gyration } else { 0.0 };
        let gyration = if reach > 0.0 { gyration.min(LARGEST_DISC * reach) } else { gyration };
        let is_single = far <= 0.0;
        Self { points, length: if is_single { gyration } else { far }, is_single }
    }
}

/// Geometric mean of the lengths of bodies, m.
fn usual_length(bodies: &[Body]) -> f64 {
    let logarithms: Vec<f64> =
        bodies.iter().map(|body| body.length.ln()).filter(|logarithm| logarithm.is_finite()).collect();
    if logarithms.is_empty() { 1.0 } else { (logarithms.iter().sum::<f64>() / logarithms.len() as f64).exp() }
}

/// Left, right, bottom and top of all points and bodies, m.
fn extent(elements: &Elements, bodies: &[Body], start: &Placed) -> [f64; 4] {
    let points = elements.points().map(|point| start.position(point));
    let ends = bodies.iter().enumerate().flat_map(|(i, body)| {
        let half = if body.is_single { body.length / 2.0 } else { 0.0 };
        let [x, y] = start.centre(i);
        [[x - half, y - half], [x + half, y + half]]
    });
    bounds(points.chain(ends))
}

/// Left, right, bottom and top of some points.
fn bounds(points: impl Iterator<Item = Vector>) -> [f64; 4] {
    let none = [f64::INFINITY, f64::NEG_INFINITY, f64::INFINITY, f64::NEG_INFINITY];
    points.fold(none, |[left, right, bottom, top], [x, y]| [left.min(x), right.max(x), bottom.min(y), top.max(y)])
}

/// The larger side of a box.
fn side([left, right, bottom, top]: [f64; 4]) -> f64 {
    (right - left).max(top - bottom)
}

struct Writer<'a> {
    scale: f64,
    /// Size of symbols.
    k: f64,
    elements: &'a Elements,
    start: &'a Placed,
    frames: &'a [Placed],
    parts: Vec<Part>,
}

impl Writer<'_> {
    fn push(&mut self, class: &str, title: String, motion: Motion, svg: String) {
        self.parts.push(Part { class: class.to_owned(), title, motion, svg, reach: [0.0; 2] });
    }

    /// Guides and supports: behind the bodies.
    fn ground(&mut self, i: usize, element: &ElementInfo) {
        let title = title(element);
        match element.kind {
            "hinge" | "weld" | "rod" | "spring" | "damper" => {
                let ground = (0..2).find(|&k| element.points[k].body.is_none());
                if let Some(k) = ground {
                    let motion = Motion::At { point: self.elements.point(i, k), along: None };
                    self.push("ground", title, motion, symbols::support(self.k));
                }
            }
            "slider" | "slot" => {
                let (p, q) = (self.elements.point(i, 0), self.elements.point(i, 1));
                let direction = self.elements.direction(i, 0);
                let along = |at: &Placed| {
                    let (a, b, [dx, dy]) = (at.position(p), at.position(q), at.direction(direction));
                    ((b[0] - a[0]) * dx + (b[1] - a[1]) * dy) / dx.hypot(dy) * self.scale
                };
                let [from, to] = std::iter::once(self.start)
                    .chain(self.frames)
                    .map(along)
                    .fold([0.0_f64; 2], |[from, to], x| [from.min(x), to.max(x)]);
                let reach = [from - 45.0 * self.k, to + 45.0 * self.k];
                let svg = if p.body.is_none() { symbols::guide(reach, self.k) } else { symbols::slot(reach, self.k) };
                let motion = Motion::At { point: p, along: Some(direction) };
                self.parts.push(Part { class: "ground".to_owned(), title, motion, svg, reach });
            }
            _ => {}
        }
    }

    fn body(&mut self, i: usize, name: &str, body: &Body) {
        let pixels = body.points.iter().map(|[x, y]| [x * self.scale, -y * self.scale]);
        let pixels: Vec<Vector> = pixels.collect();
        let length = body.length * self.scale;
        let r = if body.is_single { (length / 2.0).max(9.0 * self.k) } else { (9.0 * self.k).min(0.2 * length) };
        let outline = rounded_hull(&pixels, r);
        let class = format!("hue{}", i % N_HUES);
        self.push(&class, name.to_owned(), Motion::Body(i), format!("<path class=\"body\" d=\"{outline}\"/>"));
    }

    /// What joins two points.
    fn between(&mut self, i: usize, element: &ElementInfo) {
        let svg = match element.kind {
            "rod" => symbols::rod(),
            "spring" => symbols::spring(element.settings.iter().any(|(word, _)| *word == "damping"), self.k),
            "damper" => symbols::damper(self.k),
            _ => return,
        };
        let (from, to) = (self.elements.point(i, 0), self.elements.point(i, 1));
        self.push(element.kind, title(element), Motion::Span { from, to }, svg);
    }

    /// What stands at a point.
    fn symbol(&mut self, i: usize, element: &ElementInfo) {
        let k = self.k;
        let svg = match element.kind {
            "hinge" => symbols::hinge(k),
            "weld" => symbols::weld(k),
            "skate" => symbols::blade(k),
            "roll" => symbols::wheel(k),
            "tyre" => symbols::tyre(k),
            "slider" | "slot" => symbols::block(k),
            "point" => symbols::point(k),
            "rod" => {
                for end in 0..2 {
                    let motion = Motion::At { point: self.elements.point(i, end), along: None };
                    self.push("rod", title(element), motion, symbols::point(1.4 * k));
                }
                return;
            }
            "torsion" => symbols::spiral(k),
            "torque" => symbols::torque(k),
            _ => return,
        };
        let point = match element.points.len() {
            0 => self.elements.joint_of(element),
            n => Some(self.elements.point(i, if element.kind == "hinge" { 0 } else { n - 1 })),
        };
        let motion = match point {
            Some(point) => {
                let along = (!element.directions.is_empty()).then(|| self.elements.direction(i, 0));
                Motion::At { point, along }
            }
            None => match element.bodies.iter().flatten().next() {
                Some(&body) => Motion::Body(body),
                None => return,
            },
        };
        self.push(element.kind, title(element), motion, svg);
    }
}

/// `skate rear`
fn title(element: &ElementInfo) -> String {
    let settings = element.settings.iter().map(|(word, value)| format!(", {word} {value}"));
    escape(&format!("{} {}{}", element.kind, element.name, settings.collect::<String>())).replace(" ,", ",")
}
