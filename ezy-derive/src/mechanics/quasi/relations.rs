//! Velocities along the axes of the bodies, and how rows give some of them from the others.

use std::collections::{BTreeMap, BTreeSet};

use super::places::{self, Given};
use crate::mechanics::scene::Equations;
use crate::mechanics::symbols::Meaning;
use crate::model::{BodyId, Component, Coordinate};
use crate::symbolic::coefficient::Coefficient;
use crate::symbolic::sum::Atom;
use crate::symbolic::{Algebra, SumId, Symbol};

/// Velocities of a body along and across its axis, and its angular velocity: numbered as coordinates are.
pub const N_OF_BODY: usize = Component::ALL.len();

/// The bodies in an order in which each is held by those before it.
pub struct Relations {
    pub bodies: Vec<Placed>,
    /// The body along whose axes the velocity of each one is: itself, or for one that is held at its centre of mass alone that of the body that holds it,
    /// so that its angle does not matter.
    pub frames: Vec<usize>,
}

/// A body in that order.
pub struct Placed {
    pub body: usize,
    /// What stands for its angle from the axes of the body that it is hinged to, and the body whose axes these are.
    pub hinged: Option<(Symbol, usize)>,
    /// Its velocities that rows give, each from those of bodies before it and from its own that are free.
    pub dependent: Vec<Relation>,
    /// Its velocities that no row gives.
    pub free: Vec<usize>,
    /// Its coordinates that position constraints give.
    pub places: Vec<Given>,
}

impl Placed {
    /// Whether it may go along both of its axes, however it turns.
    pub fn is_free(&self) -> bool {
        let goes = [0, 1].map(|axis| N_OF_BODY * self.body + axis);
        let reads = |relation: &Relation| relation.terms.iter().any(|(i, _)| goes.contains(i));
        goes.iter().all(|i| self.free.contains(i)) && !self.dependent.iter().any(reads)
    }
}

/// `w_i = Σ factor w_j + drift`
pub struct Relation {
    pub velocity: usize,
    pub terms: Vec<(usize, SumId)>,
    pub drift: SumId,
}

/// A row on velocities along axes: `Σ entry w_j + drift = 0`.
#[derive(Clone)]
struct Row {
    entries: BTreeMap<usize, SumId>,
    drift: SumId,
}

impl Relations {
    /// `None` where a row has no pivot that depends on parameters alone, or where factors of velocities depend on places or on velocities.
    pub fn derive(equations: &mut Equations) -> Option<Self> {
        let n_bodies = equations.mass.len() / N_OF_BODY;
        let order = order(equations, n_bodies);
        let mut place = vec![0; n_bodies];
        order.iter().enumerate().for_each(|(i, &body)| place[body] = i);
        let mut rows_of_body: Vec<Vec<usize>> = vec![Vec::new(); n_bodies];
        for row in 0..equations.constraints.rows.len() {
            let last = bodies_of(equations, row).into_iter().max_by_key(|&body| place[body])?;
            rows_of_body[last].push(row);
        }
        let (mut bodies, mut frames) = (Vec::new(), (0..n_bodies).collect::<Vec<_>>());
        for body in order {
            let rows = &rows_of_body[body];
            if let Some(holder) = holder_at_centre(equations, body, rows) {
                frames[body] = frames[holder];
            }
            bodies.push(Placed::derive(equations, body, rows, &frames)?);
        }
        Some(Self { bodies, frames })
    }
}

impl Placed {
    fn derive(equations: &mut Equations, body: usize, rows: &[usize], frames: &[usize]) -> Option<Self> {
        let mut along: Vec<Row> = rows.iter().map(|&row| along_axes(equations, row, frames)).collect();
        let mut hinged = None;
        for (i, pair) in rows.windows(2).enumerate() {
            if !is_hinge(equations, pair[0], pair[1]) {
                continue;
            }
            turn_pair(equations, frames[body], &mut along[i..i + 2]);
            let other = bodies_of(equations, pair[0]).into_iter().find(|&other| other != body);
            let Some(other) = other.map(|other| frames[other]).filter(|_| hinged.is_none()) else { continue };
            if frames[body] != body {
                continue;
            }
            let name = equations.symbols.code_name(angle(equations, body));
            hinged = Some((equations.symbols.new_named(format!("relative_{name}")), other));
        }
        if let Some((relative, other)) = hinged {
            along.iter_mut().for_each(|row| row.in_relative_angle(equations, body, relative, other));
        }
        let dependent = eliminate(equations, along, body)?;
        let own = N_OF_BODY * body..N_OF_BODY * (body + 1);
        let places = places::given(equations, own.clone(), rows)?;
        let given: BTreeSet<usize> = dependent.iter().map(|relation| relation.velocity).collect();
        let placed = Self { body, hinged, dependent, free: own.filter(|i| !given.contains(i)).collect(), places };
        placed.dependent.iter().all(|relation| relation.changes_with_angles(equations)).then_some(placed)
    }
}

impl Relation {
    fn changes_with_angles(&self, equations: &mut Equations) -> bool {
        let Equations { algebra, symbols, .. } = equations;
        let mut sums = self.terms.iter().map(|&(_, factor)| factor).chain([self.drift]);
        sums.all(|sum| {
            algebra.symbols_of(sum).into_iter().all(|symbol| match symbols.meaning(symbol) {
                Meaning::Coordinate(i) => Coordinate::at(i).component.is_angle(),
                Meaning::Velocity(_) => false,
                Meaning::Time | Meaning::Input(_) | Meaning::Named(_) => true,
            })
        })
    }
}

/// The bodies of a row.
fn bodies_of(equations: &Equations, row: usize) -> BTreeSet<usize> {
    equations.constraints.jacobian[row].iter().map(|&(column, _)| Coordinate::at(column).body.0).collect()
}

pub fn angle(equations: &Equations, body: usize) -> Symbol {
    equations.symbols.coordinate(BodyId(body), Component::Phi)
}

/// Whether two rows say that two points coincide.
fn is_hinge(equations: &Equations, x: usize, y: usize) -> bool {
    let [x, y] = [x, y].map(|row| &equations.constraints.rows[row]);
    x.family == y.family && x.name.ends_with(".x") && y.name.ends_with(".y") && matches!(x.kind, "hinge" | "weld")
}

/// The body whose hinge holds another one at its centre of mass, where no other row says where that is.
fn holder_at_centre(equations: &Equations, body: usize, rows: &[usize]) -> Option<usize> {
    let own = |row: usize, component: Component| {
        let column = Coordinate { body: BodyId(body), component }.place();
        equations.constraints.jacobian[row].iter().any(|&(other, _)| other == column)
    };
    let mut places = rows.iter().copied().filter(|&row| own(row, Component::X) || own(row, Component::Y));
    let (x, y) = (places.next()?, places.next()?);
    let is_at_centre = is_hinge(equations, x, y) && ![x, y].iter().any(|&row| own(row, Component::Phi));
    let holder = bodies_of(equations, x).into_iter().find(|&other| other != body)?;
    (is_at_centre && places.next().is_none()).then_some(holder)
}

/// Bodies from those that the ground holds outwards, then from those on skates, then from the others.
fn order(equations: &Equations, n_bodies: usize) -> Vec<usize> {
    let mut others: Vec<Vec<usize>> = vec![Vec::new(); n_bodies];
    let (mut held, mut skates) = (Vec::new(), Vec::new());
    for row in 0..equations.constraints.rows.len() {
        let bodies: Vec<usize> = bodies_of(equations, row).into_iter().collect();
        match bodies[..] {
            [body] if row < equations.constraints.n_position_rows => held.push(body),
            [body] => skates.push(body),
            _ => {
                for &body in &bodies {
                    others[body].extend(bodies.iter().filter(|&&other| other != body));
                }
            }
        }
    }
    let (mut order, mut seen) = (Vec::new(), vec![false; n_bodies]);
    for first in held.into_iter().chain(skates).chain(0..n_bodies) {
        let mut next = order.len();
        if !std::mem::replace(&mut seen[first], true) {
            order.push(first);
        }
        while next < order.len() {
            for &body in &others[order[next]] {
                if !std::mem::replace(&mut seen[body], true) {
                    order.push(body);
                }
            }
            next += 1;
        }
    }
    order
}

/// A row on velocities along the axes of its bodies.
fn along_axes(equations: &mut Equations, row: usize, frames: &[usize]) -> Row {
    let mut entries: BTreeMap<usize, SumId> = BTreeMap::new();
    for (column, g) in equations.constraints.jacobian[row].clone() {
        let Coordinate { body, component } = Coordinate::at(column);
        let first = N_OF_BODY * body.0;
        let [sin, cos] = sines(equations, frames[body.0]);
        let algebra = &mut equations.algebra;
        let parts = match component {
            Component::Phi => vec![(column, g)],
            Component::X => {
                let product = algebra.mul(g, sin);
                vec![(first, algebra.mul(g, cos)), (first + 1, algebra.neg(product))]
            }
            Component::Y => vec![(first, algebra.mul(g, sin)), (first + 1, algebra.mul(g, cos))],
        };
        for (i, part) in parts {
            let before = entries.get(&i).copied().unwrap_or(SumId::ZERO);
            entries.insert(i, algebra.add(before, part));
        }
    }
    Row { entries, drift: equations.constraints.drift[row] }
}

/// Sine and cosine of the angle of a body.
pub fn sines(equations: &mut Equations, body: usize) -> [SumId; 2] {
    let symbol = angle(equations, body);
    let angle = equations.algebra.symbol(symbol);
    let (sin, cos) = equations.algebra.sin_cos(angle);
    [sin, cos]
}

/// `[cos b + sin d, cos d − sin b]` of two sums: what two components are along the axes of a body.
pub fn turned(algebra: &mut Algebra, [sin, cos]: [SumId; 2], [x, y]: [SumId; 2]) -> [SumId; 2] {
    let (xc, ys) = (algebra.mul(x, cos), algebra.mul(y, sin));
    let (yc, xs) = (algebra.mul(y, cos), algebra.mul(x, sin));
    [algebra.add(xc, ys), algebra.sub(yc, xs)]
}

/// Rows along x and y as rows along the axes of a body.
fn turn_pair(equations: &mut Equations, body: usize, pair: &mut [Row]) {
    let sines = sines(equations, body);
    let algebra = &mut equations.algebra;
    let columns: BTreeSet<usize> = pair.iter().flat_map(|row| row.entries.keys().copied()).collect();
    for column in columns {
        let entry = |row: &Row| row.entries.get(&column).copied().unwrap_or(SumId::ZERO);
        let turned = turned(algebra, sines, [entry(&pair[0]), entry(&pair[1])]);
        pair.iter_mut().zip(turned).for_each(|(row, entry)| {
            row.entries.insert(column, entry);
        });
    }
    let drifts = turned(algebra, sines, [pair[0].drift, pair[1].drift]);
    pair.iter_mut().zip(drifts).for_each(|(row, drift)| row.drift = drift);
}

impl Row {
    /// With φ of the body as that of the other one and the angle between them: what depends on the latter alone loses the former.
    fn in_relative_angle(&mut self, equations: &mut Equations, body: usize, relative: Symbol, other: usize) {
        let [own, of_other] = [body, other].map(|body| angle(equations, body));
        let algebra = &mut equations.algebra;
        let [relative, of_other] = [relative, of_other].map(|symbol| {
            let angle = algebra.symbol(symbol);
            algebra.sin_cos(angle)
        });
        let turned = |algebra: &mut Algebra, atom: &Atom| {
            let (Atom::Sin(angle) | Atom::Cos(angle)) = atom else { return None };
            if algebra.as_symbol(*angle) != Some(own) {
                return None;
            }
            let ((sin, cos), (other_sin, other_cos)) = (relative, of_other);
            let [first, second] = match atom {
                Atom::Sin(_) => [algebra.mul(other_sin, cos), algebra.mul(other_cos, sin)],
                _ => {
                    let product = algebra.mul(other_sin, sin);
                    [algebra.mul(other_cos, cos), algebra.neg(product)]
                }
            };
            Some(algebra.add(first, second))
        };
        for sum in self.entries.values_mut().chain([&mut self.drift]) {
            *sum = algebra.substitute(*sum, &mut { turned });
        }
    }

    fn entry(&self, column: usize) -> SumId {
        self.entries.get(&column).copied().unwrap_or(SumId::ZERO)
    }

    /// Adds a multiple of another row.
    fn add(&mut self, algebra: &mut Algebra, factor: SumId, other: &Self) {
        for (&column, &entry) in &other.entries {
            let product = algebra.mul(factor, entry);
            let sum = algebra.add(self.entry(column), product);
            self.entries.insert(column, sum);
        }
        let product = algebra.mul(factor, other.drift);
        self.drift = algebra.add(self.drift, product);
    }
}

/// Solves rows for velocities of a body. Pivots depend on parameters alone: 1 before others.
fn eliminate(equations: &mut Equations, mut rows: Vec<Row>, body: usize) -> Option<Vec<Relation>> {
    let algebra = &mut equations.algebra;
    let mut solved: Vec<(usize, Row)> = Vec::new();
    while !rows.is_empty() {
        let columns = || N_OF_BODY * body..N_OF_BODY * (body + 1);
        let candidates = (0..rows.len()).flat_map(|i| columns().map(move |column| (i, column)));
        let candidates = candidates.filter_map(|(i, column)| {
            let pivot = algebra.as_coefficient(rows[i].entry(column)).filter(|k| !k.is_zero())?;
            Some((!pivot.is_unit(), i, column, pivot))
        });
        let (_, i, column, pivot) = candidates.min_by_key(|&(is_other, i, column, _)| (is_other, i, column))?;
        let mut row = rows.remove(i);
        let inverse = algebra.coefficients.div(Coefficient::ONE, pivot);
        row.entries.values_mut().chain([&mut row.drift]).for_each(|sum| *sum = algebra.scale(*sum, inverse));
        for other in rows.iter_mut().chain(solved.iter_mut().map(|(_, row)| row)) {
            let factor = algebra.neg(other.entry(column));
            if !factor.is_zero() {
                other.add(algebra, factor, &row);
            }
        }
        solved.push((column, row));
    }
    let relations = solved.into_iter().map(|(velocity, row)| {
        let others = row.entries.into_iter().filter(|&(column, entry)| column != velocity && !entry.is_zero());
        let terms = others.map(|(column, entry)| (column, algebra.neg(entry))).collect();
        Relation { velocity, terms, drift: algebra.neg(row.drift) }
    });
    Some(relations.collect())
}
