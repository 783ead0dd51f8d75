//! A chain of equal rods under gravity, hung from the origin: as many rods as one likes.
//!
//! Written by hand as `model!` writes it for a model with a count: descriptions from loops, kernels in loops, no
//! generated elimination.

use ezy_core::__private::{Known, Layout, Repeats, RowTemplate, SlotCoordinate, TemplateInfo};
use ezy_core::model::{
    CountInfo, Derived, EffectInfo, Equations, Formula, Operations, RowInfo, Scene, SceneInfo, SparsityPattern, Start,
};

const LENGTH: f64 = 1.0;
const MASS: f64 = 1.0;
const INERTIA: f64 = MASS * LENGTH * LENGTH / 12.0;
const GRAVITY: f64 = 9.81;

/// `n` rods; hinge `i` joins rod `i − 1` (the ground for the first) and rod `i`.
pub struct Chain {
    /// Number of rods.
    pub n: usize,
}

const fn f(text: &'static str) -> Formula {
    Formula { text, latex: text, mathml: text }
}

const fn on(slot: usize, component: usize) -> SlotCoordinate {
    SlotCoordinate { slot, component }
}

const fn row(name: &'static str, suffix: &'static str, entries: &'static [SlotCoordinate]) -> RowTemplate {
    let (constraint, convective_term) = (f("end - beginning"), f("centripetal"));
    RowTemplate {
        suffix,
        row: RowInfo { name, kind: "hinge", multiplier_unit: "N", constraint, convective_term },
        position: true,
        entries,
    }
}

const fn hinge(
    name: &'static str,
    title: &'static str,
    ranges: &'static [&'static str],
    rows: &'static [RowTemplate],
) -> TemplateInfo {
    TemplateInfo { name, word: "hinge", ranges, title, rows, equations: &[] }
}

static TOP: TemplateInfo = hinge(
    "top",
    "hinge top",
    &[],
    &[row("top.x", ".x", &[on(0, 0), on(0, 2)]), row("top.y", ".y", &[on(0, 1), on(0, 2)])],
);

static PIN: TemplateInfo = hinge(
    "pin",
    "hinge pin, i in 1..n",
    &["i in 1..n"],
    &[
        row("pin[i].x", ".x", &[on(0, 0), on(0, 2), on(1, 0), on(1, 2)]),
        row("pin[i].y", ".y", &[on(0, 1), on(0, 2), on(1, 1), on(1, 2)]),
    ],
);

static FIXED: SceneInfo = SceneInfo {
    model: "Chain",
    name: "swing",
    documentation: "",
    bodies: &[],
    coordinates: &[],
    points: &[],
    rows: &[],
    n_position_rows: 0,
    parameters: &[],
    inputs: &[],
    outputs: &[],
    events: &[],
    stick_slip: None,
    stop: None,
    effects: &[EffectInfo { name: "gravity", documentation: "" }],
    until_s: 1.0,
    n_constants: 0,
    jacobian: SparsityPattern { starts: &[0], columns: &[] },
    jacobian_entries: &[],
    mass_entries: &[],
    force_entries: &[],
    potential_energy: Formula { text: "0", latex: "0", mathml: "<mn>0</mn>" },
    abbreviations: &[],
    equations: &[],
    elimination: &[],
    acceleration_operations: Operations { add: 0, mul: 0, div: 0, trig: 0, calls: 0 },
    correction_operations: Operations { add: 0, mul: 0, div: 0, trig: 0, calls: 0 },
    series: ezy_core::model::SeriesInfo::Absent,
    repeats: Some(Repeats {
        counts: &[CountInfo { name: "n", default: 100, documentation: "rods" }],
        values: &[100],
        templates: &[TOP, PIN],
        fault: None,
    }),
};

impl Chain {
    /// A chain of `n` rods.
    pub fn new(n: usize) -> Self {
        Self { n }
    }

    fn describe(&self, layout: &mut Layout) {
        let lengths = [self.n];
        let rods = layout.bodies("rod", &lengths);
        let slots = [layout.member(&TOP, &[], rods, &[0])];
        layout.rows(&TOP, &[], &slots);
        for i in layout.range(1, self.n as i64) {
            let slots = [layout.member(&PIN, &[i], rods, &[i - 1]), layout.member(&PIN, &[i], rods, &[i])];
            layout.rows(&PIN, &[i], &slots);
        }
    }

    /// Rows of C at position level for angles and their first and second time derivatives: the end of rod `i − 1`
    /// less the beginning of rod `i`, of which `f` gives the half rod as a vector.
    fn rows(&self, f: impl Fn(usize) -> [f64; 2], centres: &[f64], out: &mut [f64]) {
        for i in 0..self.n {
            for axis in 0..2 {
                let end = if i == 0 { 0.0 } else { centres[3 * i - 3 + axis] + f(i - 1)[axis] };
                out[2 * i + axis] = end - (centres[3 * i + axis] - f(i)[axis]);
            }
        }
    }
}

/// Half a rod along its axis.
fn half(phi: f64) -> [f64; 2] {
    [0.5 * LENGTH * phi.cos(), 0.5 * LENGTH * phi.sin()]
}

impl Equations<f64> for Chain {
    fn constants(&self, _parameters: &[f64], _c: &mut [f64]) {}

    fn mass_matrix(&self, _c: &[f64], m: &mut [f64]) {
        m.chunks_exact_mut(3).for_each(|m| m.copy_from_slice(&[MASS, MASS, INERTIA]));
    }

    fn position_constraint(&self, _c: &[f64], _t: f64, q: &[f64], out: &mut [f64]) {
        self.rows(|i| half(q[3 * i + 2]), q, out);
    }

    fn velocity_constraint(&self, _c: &[f64], _t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        let turning = |i: usize| {
            let ([x, y], w) = (half(q[3 * i + 2]), v[3 * i + 2]);
            [-w * y, w * x]
        };
        self.rows(turning, v, out);
    }

    fn velocity_jacobian(&self, _c: &[f64], _t: f64, q: &[f64], out: &mut [f64]) {
        let mut out = out.iter_mut();
        let mut put = |value: f64| *out.next().expect("room for every entry") = value;
        for i in 0..self.n {
            let [x, y] = half(q[3 * i + 2]);
            // on the angle: the half rod, turned; the same sign on both sides of a hinge
            for (axis, turned) in [-y, x].into_iter().enumerate() {
                if i > 0 {
                    let [x, y] = half(q[3 * i - 1]);
                    put(1.0);
                    put([-y, x][axis]);
                }
                put(-1.0);
                put(turned);
            }
        }
    }

    fn convective_term(&self, _c: &[f64], _t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        let centripetal = |i: usize| half(q[3 * i + 2]).map(|x| -x * v[3 * i + 2] * v[3 * i + 2]);
        self.rows(centripetal, &vec![0.0; 3 * self.n], out);
    }

    fn applied_force(&self, _c: &[f64], _t: f64, _q: &[f64], _v: &[f64], out: &mut [f64]) {
        out.chunks_exact_mut(3).for_each(|f| f.copy_from_slice(&[0.0, -MASS * GRAVITY, 0.0]));
    }
}

impl Derived for Chain {
    fn count(&self, index: usize) -> usize {
        if index == 0 { self.n } else { 0 }
    }

    fn set_count(&mut self, index: usize, value: usize) {
        if index == 0 {
            self.n = value;
        }
    }
}

impl Scene for Chain {
    fn info(&self) -> &'static SceneInfo {
        static KNOWN: Known = Known::new();
        KNOWN.info(&FIXED, &[self.n], |layout| self.describe(layout))
    }

    fn parameter(&self, _index: usize) -> f64 {
        f64::NAN
    }

    fn set_parameter(&mut self, _index: usize, _value: f64) {}

    fn start(&self, _c: &[f64], start: &mut Start) {
        (0..self.n).for_each(|i| start.give_position(3 * i + 2, 0.1 * i as f64));
    }

    fn power(&self, _c: &[f64], _t: f64, _q: &[f64], v: &[f64], _lambda: &[f64], out: &mut [f64]) {
        out[0] = v.chunks_exact(3).map(|v| -MASS * GRAVITY * v[1]).sum();
    }

    fn potential_energy(&self, _c: &[f64], _t: f64, _q: &[f64]) -> f64 {
        0.0
    }

    fn points(&self, _c: &[f64], _t: f64, _q: &[f64], _out: &mut [f64]) {}

    fn outputs(&self, _c: &[f64], _t: f64, _q: &[f64], _v: &[f64], _out: &mut [f64]) {}
}
