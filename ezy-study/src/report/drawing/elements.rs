//! The elements of a scene with their numbers at a state.

use ezy_core::model::coordinate::of_body;
use ezy_core::model::{ElementInfo, List, Scene};
use ezy_core::record::Sample;

/// x and y.
pub type Vector = [f64; 2];

/// The elements of a scene, and where their numbers begin.
#[derive(Debug, Clone)]
pub struct Elements {
    infos: List<ElementInfo>,
    /// Index of the first number of each element.
    first: Vec<usize>,
    n_values: usize,
    /// Inputs as declared, then the constants of the scene.
    c: Vec<f64>,
    /// Diagonal of M.
    mass: Vec<f64>,
}

/// A point or direction of an element: its body, and where x and y stand among the numbers of the elements.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Anchor {
    /// `None` is the ground.
    pub body: Option<usize>,
    /// Index of x; y follows.
    pub index: usize,
}

/// A state and the numbers of the elements there.
#[derive(Debug, Clone)]
pub struct Placed {
    /// Time, s.
    pub t: f64,
    /// `n_q` coordinates.
    pub q: Vec<f64>,
    /// What [`Derived::element_values`](ezy_core::model::Derived::element_values) writes.
    pub values: Vec<f64>,
}

impl Elements {
    /// Those of a scene.
    pub fn new(scene: &dyn Scene) -> Self {
        let infos = scene.elements();
        let mut n_values = 0;
        let first = infos.iter().map(|info| {
            let first = n_values;
            n_values += info.n_values();
            first
        });
        let first = first.collect();
        let description = scene.info();
        let mut c = description.declared_values();
        scene.constants(&scene.parameters(), &mut c);
        let mut mass = vec![0.0; description.n_velocities()];
        scene.mass_matrix(&c, &mut mass);
        Self { infos, first, n_values, c, mass }
    }

    /// At a state, with the inputs as declared.
    pub fn at(&self, scene: &dyn Scene, t: f64, q: &[f64], v: &[f64]) -> Placed {
        self.placed(scene, &self.c, t, q, v)
    }

    /// At a sample of a run.
    pub fn at_sample(&self, scene: &dyn Scene, sample: &Sample<'_>) -> Placed {
        let mut c = self.c.clone();
        let present = sample.inputs.iter().chain(sample.states);
        c.iter_mut().zip(present).for_each(|(value, present)| *value = *present);
        self.placed(scene, &c, sample.t, sample.coordinates, sample.velocities)
    }

    fn placed(&self, scene: &dyn Scene, c: &[f64], t: f64, q: &[f64], v: &[f64]) -> Placed {
        let mut values = vec![0.0; self.n_values];
        scene.element_values(c, t, q, v, &mut values);
        let is_drawn = q.len() == v.len();
        Placed { t, q: if is_drawn { q.to_vec() } else { Vec::new() }, values }
    }

    /// Inputs as declared, then the constants of the scene: what its kernels read as `c`.
    pub fn constants(&self) -> &[f64] {
        &self.c
    }

    /// Diagonal of M.
    pub fn mass(&self) -> &[f64] {
        &self.mass
    }

    /// The hinge between the bodies of a couple.
    pub fn joint_of(&self, couple: &ElementInfo) -> Option<Anchor> {
        let joins = |element: &ElementInfo| {
            element.kind == "hinge"
                && couple.bodies.len() == 2
                && couple.bodies.iter().all(|body| element.points.iter().any(|point| point.body == *body))
        };
        let (i, _) = self.iter().find(|(_, element)| joins(element))?;
        Some(self.point(i, 0))
    }

    /// Each with its index.
    pub fn iter(&self) -> impl Iterator<Item = (usize, &ElementInfo)> {
        self.infos.iter().enumerate()
    }

    /// Point `k` of element `i`.
    pub fn point(&self, i: usize, k: usize) -> Anchor {
        Anchor { body: self.infos[i].points[k].body, index: self.first[i] + 2 * k }
    }

    /// Direction `k` of element `i`.
    pub fn direction(&self, i: usize, k: usize) -> Anchor {
        let info = &self.infos[i];
        Anchor { body: info.directions[k].body, index: self.first[i] + 2 * (info.points.len() + k) }
    }

    /// Index of the first number of the load of element `i`.
    pub fn load(&self, i: usize) -> usize {
        let info = &self.infos[i];
        self.first[i] + 2 * (info.points.len() + info.directions.len())
    }

    /// All points.
    pub fn points(&self) -> impl Iterator<Item = Anchor> + '_ {
        self.iter().flat_map(move |(i, info)| (0..info.points.len()).map(move |k| self.point(i, k)))
    }
}

impl Placed {
    /// In the axes of its body.
    pub fn local(&self, of: Anchor) -> Vector {
        [self.values[of.index], self.values[of.index + 1]]
    }

    /// A point along the axes of the ground, m.
    pub fn position(&self, of: Anchor) -> Vector {
        let [x, y] = self.direction(of);
        let Some(body) = of.body else { return [x, y] };
        let [cx, cy] = self.centre(body);
        [cx + x, cy + y]
    }

    /// A direction along the axes of the ground.
    pub fn direction(&self, of: Anchor) -> Vector {
        let [x, y] = self.local(of);
        let (sin, cos) = of.body.map_or((0.0, 1.0), |body| self.angle(body).sin_cos());
        [x * cos - y * sin, x * sin + y * cos]
    }

    /// The centre of mass of a body, m.
    pub fn centre(&self, body: usize) -> Vector {
        let [x, y, _] = of_body(&self.q, body);
        [x, y]
    }

    /// The angle of a body, rad.
    pub fn angle(&self, body: usize) -> f64 {
        let [.., phi] = of_body(&self.q, body);
        phi
    }
}
