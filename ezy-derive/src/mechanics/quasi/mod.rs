//! Equations of motion in quasi-velocities.
//!
//! Rows with pivots that depend on parameters alone give some velocities from the others, the quasi-velocities u: v = R(q) u + v_t. With these the
//! multipliers drop out: `Rᵀ M R u̇ = Rᵀ (F − M (Ṙ u + v̇_t))`. Velocities are taken along the axes of the bodies, where M is as it was, so that
//! trees need the angles between bodies alone.
//!
//! # Source
//! Kane, Levinson, Dynamics (1985), ch. 2 and 6; Hamel (1949), ch. VIII.

mod places;
mod relations;

use std::collections::BTreeSet;

use super::block::System;
use super::scene::Equations;
use super::solve::Solutions;
use super::symbols::Meaning;
use crate::model::Coordinate;
use crate::symbolic::lower::{ConstantPool, Lowering};
use crate::symbolic::program::{Count, Node, Program, Split, Value};
use crate::symbolic::sum::{Atom, SumId};
use crate::symbolic::{Algebra, Symbol};
use relations::{N_OF_BODY, Placed, Relations, angle, sines, turned};

/// Most quasi-velocities for which the equations are derived. Their matrix is full, while rows are sparse; and eight lanes hold a column of R each,
/// v_t and v (`QuasiSweeps` of `ezy-core`).
const MOST: usize = 6;

/// A factor with more terms gets a symbol.
const LONGEST_FACTOR: usize = 2;

/// The equations of motion of a scene in quasi-velocities.
#[derive(Debug)]
pub struct QuasiVelocities {
    /// Symbols that stand for u.
    pub symbols: Vec<Symbol>,
    /// u from q and v.
    pub values: Vec<SumId>,
    /// v from t, q and u.
    pub velocities: Program,
    /// What accelerations read that depends on time and inputs alone, and symbols for it.
    pub of_time: Program,
    pub time_symbols: Vec<Symbol>,
    /// u̇ from t, q, u and that, then the rates of the coordinates of `feedback`, then sine and cosine of each of the angles that these rates read.
    pub accelerations: Program,
    /// These rates alone, from t, u and these sines and cosines, for which there are symbols.
    pub rates: Program,
    pub sine_symbols: Vec<Symbol>,
    /// These angles.
    pub angles: Program,
    /// The coordinates that anything here depends on whose rates are no quasi-velocities, ascending.
    pub feedback: Vec<usize>,
    /// Those whose rates are, each with the number of its rate.
    pub integrals: Vec<(usize, usize)>,
    /// u̇ from t, q and u, then the rates of the coordinates of `integrated`.
    pub motion: Program,
    /// The coordinates that are integrated: `n_read` that the motion depends on, then others that no position constraint gives.
    pub integrated: Vec<usize>,
    pub n_read: usize,
    /// Whether no row holds the place of some body.
    pub has_free_body: bool,
    /// Coordinates from t and q, with those that position constraints give from the others, then v there, from u.
    pub whole_state: Program,
}

impl QuasiVelocities {
    /// `None` where rows do not give velocities so, or where these equations have more operations than the elimination of the rows.
    pub fn derive(equations: &mut Equations, solutions: &Solutions, constants: &mut ConstantPool) -> Option<Self> {
        // constants that only a rejected form reads are not kept
        let mut more = constants.clone();
        let derived = Self::of_rows(equations, solutions, &mut more)?;
        let of_rows = solutions.accelerations.program.count();
        let of_these: Count = [&derived.of_time, &derived.accelerations].map(Program::count).into_iter().sum();
        let is_less = of_these.arithmetic() < of_rows.arithmetic()
            && of_these.trig <= of_rows.trig
            && of_these.calls <= of_rows.calls;
        is_less.then(|| {
            *constants = more;
            derived
        })
    }

    /// `None` where rows do not give velocities so.
    pub(super) fn of_rows(
        equations: &mut Equations,
        solutions: &Solutions,
        constants: &mut ConstantPool,
    ) -> Option<Self> {
        let constraints = &equations.constraints;
        let n_free = equations.mass.len().checked_sub(constraints.rows.len())?;
        let is_switched = constraints.rows.iter().any(|row| row.holds.is_some());
        if constraints.rows.is_empty() || n_free == 0 || n_free > MOST || is_switched {
            return None;
        }
        let relations = Relations::derive(equations)?;
        let form = Form::derive(equations, &relations);
        Some(form.write(equations, &relations, &solutions.accelerations.program, constants))
    }
}

/// The equations as expressions.
struct Form {
    /// What stands for each velocity along an axis: u, or a symbol of `velocities`.
    along: Vec<Symbol>,
    free: Vec<usize>,
    /// The velocities that rows give, in an order in which each reads those before it.
    velocities: Vec<(Symbol, SumId)>,
    /// Factors and forces, in the same way.
    named: Vec<(Symbol, SumId)>,
    /// Rᵀ M R, the lower half by rows, and Rᵀ (F − M (Ṙ u + v̇_t)).
    matrix: Vec<Vec<SumId>>,
    right_side: Vec<SumId>,
}

impl Form {
    fn derive(equations: &mut Equations, relations: &Relations) -> Self {
        let n = equations.mass.len();
        let along: Vec<Symbol> = (0..n).map(|i| name_along(equations, i)).collect();
        let free: Vec<usize> = relations.bodies.iter().flat_map(|placed| placed.free.iter().copied()).collect();
        let mut form =
            Self { along, free, velocities: Vec::new(), named: Vec::new(), matrix: Vec::new(), right_side: Vec::new() };
        let w: Vec<SumId> = form.along.iter().map(|&symbol| equations.algebra.symbol(symbol)).collect();
        let rates = form.rates_of_angles(equations, relations);
        // R by rows, and Ṙ u + v̇_t
        let mut factors = vec![vec![SumId::ZERO; form.free.len()]; n];
        let mut drifts = vec![SumId::ZERO; n];
        for (k, &i) in form.free.iter().enumerate() {
            factors[i][k] = SumId::ONE;
        }
        for relation in relations.bodies.iter().flat_map(|placed| &placed.dependent) {
            let (i, algebra) = (relation.velocity, &mut equations.algebra);
            let mut value = vec![relation.drift];
            let mut drift = vec![rate(algebra, relation.drift, &rates)];
            let mut parts = vec![Vec::new(); form.free.len()];
            for &(j, factor) in &relation.terms {
                value.push(algebra.mul(factor, w[j]));
                let change = rate(algebra, factor, &rates);
                drift.push(algebra.mul(change, w[j]));
                drift.push(algebra.mul(factor, drifts[j]));
                for (parts, &of_other) in parts.iter_mut().zip(&factors[j]) {
                    parts.push(algebra.mul(factor, of_other));
                }
            }
            let value = algebra.total(&value);
            form.velocities.push((form.along[i], value));
            for (k, parts) in parts.iter().enumerate() {
                let factor = equations.algebra.total(parts);
                factors[i][k] =
                    form.named(equations, factor, LONGEST_FACTOR, &|name, of| format!("{name}_by_{of}"), i, Some(k));
            }
            let drift = equations.algebra.total(&drift);
            drifts[i] = form.named(equations, drift, 1, &|name, _| format!("drift_{name}"), i, None);
        }
        let forces = form.forces(equations, &relations.frames, &w, &drifts);
        form.assemble(equations, &factors, &forces);
        form
    }

    /// Angles that relations read, each with its rate.
    fn rates_of_angles(&mut self, equations: &mut Equations, relations: &Relations) -> Vec<(Symbol, SumId)> {
        let mut rates = Vec::new();
        for placed in &relations.bodies {
            let turning = |body: usize| self.along[N_OF_BODY * body + N_OF_BODY - 1];
            let own = turning(placed.body);
            rates.push((angle(equations, placed.body), equations.algebra.symbol(own)));
            if let Some((relative, other)) = placed.hinged {
                let [own, other] = [own, turning(other)].map(|symbol| equations.algebra.symbol(symbol));
                let difference = equations.algebra.sub(own, other);
                let symbol = equations.symbols.new_named(format!("rate_of_{}", equations.symbols.code_name(relative)));
                self.named.push((symbol, difference));
                rates.push((relative, equations.algebra.symbol(symbol)));
            }
        }
        rates
    }

    /// The sum, or a symbol for it when it has more terms than that.
    fn named(
        &mut self,
        equations: &mut Equations,
        sum: SumId,
        longest: usize,
        name: &dyn Fn(&str, &str) -> String,
        i: usize,
        of: Option<usize>,
    ) -> SumId {
        if equations.algebra.terms(sum).len() <= longest {
            return sum;
        }
        let name_of = |i: usize| equations.symbols.code_name(self.along[i]);
        let name = name(&name_of(i), &of.map_or_else(String::new, |k| name_of(self.free[k])));
        let symbol = equations.symbols.new_named(name);
        self.named.push((symbol, sum));
        equations.algebra.symbol(symbol)
    }

    /// F − M (Ṙ u + v̇_t), along the axes of the bodies, which turn.
    fn forces(&mut self, equations: &mut Equations, frames: &[usize], w: &[SumId], drifts: &[SumId]) -> Vec<SumId> {
        let world = world_velocities(equations, frames, w);
        let mut forces = Vec::new();
        for (body, &frame) in frames.iter().enumerate() {
            let first = N_OF_BODY * body;
            let sines = sines(equations, frame);
            let [x, y, torque] = std::array::from_fn(|i| {
                let force = equations.force[first + i];
                in_velocities_along(equations, force, &world)
            });
            let algebra = &mut equations.algebra;
            let [along, across] = turned(algebra, sines, [x, y]);
            let omega = w[N_OF_BODY * frame + N_OF_BODY - 1];
            let minus_omega = algebra.neg(omega);
            let turning = [algebra.mul(minus_omega, w[first + 1]), algebra.mul(omega, w[first]), SumId::ZERO];
            for (i, (force, turning)) in [along, across, torque].into_iter().zip(turning).enumerate() {
                let algebra = &mut equations.algebra;
                let acceleration = algebra.add(drifts[first + i], turning);
                let inertial = algebra.scale(acceleration, equations.mass[first + i]);
                let force = algebra.sub(force, inertial);
                forces.push(self.named(equations, force, 1, &|name, _| format!("force_{name}"), first + i, None));
            }
        }
        forces
    }

    fn assemble(&mut self, equations: &mut Equations, factors: &[Vec<SumId>], forces: &[SumId]) {
        let algebra = &mut equations.algebra;
        for k in 0..self.free.len() {
            let row = (0..=k).map(|l| {
                let products = factors.iter().zip(&equations.mass).map(|(factors, &mass)| {
                    let product = algebra.mul(factors[k], factors[l]);
                    algebra.scale(product, mass)
                });
                let products: Vec<SumId> = products.collect();
                algebra.total(&products)
            });
            self.matrix.push(row.collect());
            let products = factors.iter().zip(forces).map(|(factors, &force)| algebra.mul(factors[k], force));
            let products: Vec<SumId> = products.collect();
            self.right_side.push(algebra.total(&products));
        }
    }

    fn write(
        &self,
        equations: &mut Equations,
        relations: &Relations,
        of_rows: &Program,
        constants: &mut ConstantPool,
    ) -> QuasiVelocities {
        let w: Vec<SumId> = self.along.iter().map(|&symbol| equations.algebra.symbol(symbol)).collect();
        let world = world_velocities(equations, &relations.frames, &w);
        let coordinates: Vec<SumId> =
            (0..world.len()).map(|i| equations.algebra.symbol(equations.symbols.coordinate_at(i))).collect();
        let values = self.free.iter().map(|&i| along_axis(equations, &relations.frames, i)).collect();

        let mut lowering = Lowering::new(&equations.algebra, constants);
        let all = relations.frames.iter().map(|&frame| angle(equations, frame)).collect();
        self.begin(&mut lowering, equations, relations, &all);
        for &velocity in &world {
            let velocity = lowering.lower(velocity);
            lowering.program.push_output(velocity);
        }
        let mut velocities = lowering.program;
        velocities.settle_signs();

        let mut lowering = Lowering::new(&equations.algebra, constants);
        for &(i, value) in relations.bodies.iter().flat_map(|placed| &placed.places) {
            let value = lowering.lower(value);
            lowering.bind(equations.symbols.coordinate_at(i), value);
        }
        self.begin(&mut lowering, equations, relations, &all);
        for &number in coordinates.iter().chain(&world) {
            let number = lowering.lower(number);
            lowering.program.push_output(number);
        }
        let mut whole_state = lowering.program;
        whole_state.settle_signs();
        let given: BTreeSet<usize> =
            relations.bodies.iter().flat_map(|placed| &placed.places).map(|&(i, _)| i).collect();
        let (motion, integrated, n_read) = self.motion(equations, relations, &given, &world, constants);

        let read: BTreeSet<usize> = self.coordinates(equations);
        let absolute = self.angles_of_axes(equations, relations, read.iter().copied());
        let mut lowering = Lowering::new(&equations.algebra, constants);
        self.begin(&mut lowering, equations, relations, &absolute);
        self.accelerations(&mut lowering, equations);
        // what velocities and the equations of the rows read is known at the same nodes
        let coordinate = |symbol| equations.symbols.coordinate_of(symbol);
        let read = lowering.program.inputs().into_iter().chain(velocities.inputs()).chain(of_rows.inputs());
        let read: BTreeSet<usize> = read.filter_map(coordinate).collect();
        let symbols: Vec<Symbol> = self.free.iter().map(|&i| self.along[i]).collect();
        let (mut feedback, mut integrals) = (Vec::new(), Vec::new());
        for i in read {
            let rate = equations.algebra.as_symbol(world[i]);
            match symbols.iter().position(|&symbol| Some(symbol) == rate) {
                Some(k) => integrals.push((i, k)),
                None => {
                    let rate = lowering.lower(world[i]);
                    lowering.program.push_output(rate);
                    feedback.push(i);
                }
            }
        }
        let mut accelerations = lowering.program;
        accelerations.settle_signs();
        // nodes stay where they are in time: what depends on time alone is computed once for all sweeps
        let does_not_move =
            |symbol: &Symbol| matches!(equations.symbols.meaning(*symbol), Meaning::Time | Meaning::Input(_));
        let held: BTreeSet<Symbol> = accelerations.inputs().into_iter().filter(does_not_move).collect();
        let mut n = 0;
        let Split { first: of_time, symbols: time_symbols, rest: accelerations } =
            accelerations.split(&|symbol| held.contains(&symbol), &mut || {
                n += 1;
                equations.symbols.new_named(format!("of_time_{n}"))
            });
        let Rates { accelerations, rates, sine_symbols, angles } =
            Rates::of(accelerations, symbols.len(), &mut |name| equations.symbols.new_named(name));
        QuasiVelocities {
            symbols,
            values,
            velocities,
            of_time,
            time_symbols,
            accelerations,
            rates,
            sine_symbols,
            angles,
            feedback,
            integrals,
            motion,
            integrated,
            n_read,
            has_free_body: relations.bodies.iter().any(Placed::is_free),
            whole_state,
        }
    }

    /// u̇ and the rates of coordinates, with these: those that anything here depends on, then others that are not given.
    fn motion(
        &self,
        equations: &mut Equations,
        relations: &Relations,
        given: &BTreeSet<usize>,
        world: &[SumId],
        constants: &mut ConstantPool,
    ) -> (Program, Vec<usize>, usize) {
        let mut integrated: Vec<usize> = (0..world.len()).filter(|i| !given.contains(i)).collect();
        loop {
            let absolute = self.angles_of_axes(equations, relations, integrated.iter().copied());
            let mut lowering = Lowering::new(&equations.algebra, constants);
            self.begin(&mut lowering, equations, relations, &absolute);
            self.accelerations(&mut lowering, equations);
            for &i in &integrated {
                let rate = lowering.lower(world[i]);
                lowering.program.push_output(rate);
            }
            let mut program = lowering.program;
            let read = program.inputs().into_iter().filter_map(|symbol| equations.symbols.coordinate_of(symbol));
            let read: BTreeSet<usize> = read.collect();
            let others = || integrated.iter().filter(|i| !read.contains(i));
            let ordered: Vec<usize> = read.iter().chain(others()).copied().collect();
            if ordered == integrated {
                program.settle_signs();
                return (program, integrated, read.len());
            }
            integrated = ordered;
        }
    }

    /// Angles whose sines are read: those by which velocities are turned, and those of the axes along which places move.
    fn angles_of_axes(
        &self,
        equations: &Equations,
        relations: &Relations,
        moved: impl Iterator<Item = usize>,
    ) -> BTreeSet<Symbol> {
        let mut angles = BTreeSet::new();
        for &(_, sum) in self.velocities.iter().chain(&self.named) {
            angles_turned_by(&equations.algebra, sum, &mut angles);
        }
        let places = moved.map(Coordinate::at).filter(|at| !at.component.is_angle());
        angles.extend(places.map(|at| angle(equations, relations.frames[at.body.0])));
        angles
    }

    /// u̇, as outputs.
    fn accelerations(&self, lowering: &mut Lowering<'_>, equations: &Equations) {
        for &(symbol, sum) in &self.named {
            let value = lowering.lower(sum);
            lowering.program.set_name(value, &equations.symbols.code_name(symbol));
            lowering.bind(symbol, value);
        }
        for value in self.solve(lowering) {
            lowering.program.push_output(value);
        }
    }

    /// The coordinates that forces and relations read.
    fn coordinates(&self, equations: &mut Equations) -> BTreeSet<usize> {
        let Equations { algebra, symbols, .. } = equations;
        let sums = self.velocities.iter().chain(&self.named).map(|&(_, sum)| sum);
        let read = sums.flat_map(|sum| algebra.symbols_of(sum));
        read.filter_map(|symbol| symbols.coordinate_of(symbol)).collect()
    }

    /// Angles between bodies and the velocities that rows give. The sine of an angle between two whose own are at hand is made of these.
    fn begin(
        &self,
        lowering: &mut Lowering<'_>,
        equations: &Equations,
        relations: &Relations,
        absolute: &BTreeSet<Symbol>,
    ) {
        for placed in &relations.bodies {
            let Some((relative, other)) = placed.hinged else { continue };
            let angles = [other, placed.body].map(|body| angle(equations, body));
            let [of_other, own] = angles.map(|symbol| lowering.symbol(symbol));
            if angles.iter().all(|&angle| absolute.contains(&angle) && !lowering.is_bound(angle)) {
                let program = &mut lowering.program;
                let [[sin_a, cos_a], [sin_b, cos_b]] = [of_other, own]
                    .map(|angle| [Node::Sin(angle.node), Node::Cos(angle.node)].map(|node| program.leaf(node)));
                let [sc, cs] = [program.mul(sin_b, cos_a), program.mul(cos_b, sin_a)];
                let [cc, ss] = [program.mul(cos_b, cos_a), program.mul(sin_b, sin_a)];
                let sines = [program.sub(sc, cs), program.add(cc, ss)];
                lowering.bind_sines(relative, sines);
            }
            let difference = lowering.program.sub(own, of_other);
            lowering.program.set_name(difference, &equations.symbols.code_name(relative));
            lowering.bind(relative, difference);
        }
        for &(symbol, sum) in &self.velocities {
            let value = lowering.lower(sum);
            lowering.program.set_name(value, &equations.symbols.code_name(symbol));
            lowering.bind(symbol, value);
        }
    }

    /// u̇
    fn solve(&self, lowering: &mut Lowering<'_>) -> Vec<Value> {
        let mut matrix: Vec<Vec<(usize, Value)>> = vec![Vec::new(); self.matrix.len()];
        for (k, row) in self.matrix.iter().enumerate() {
            for (l, &entry) in row.iter().enumerate().filter(|(_, entry)| !entry.is_zero()) {
                let value = lowering.lower(entry);
                matrix[k].push((l, value));
                if l < k {
                    matrix[l].push((k, value));
                }
            }
        }
        let right_side = self.right_side.iter().map(|&sum| lowering.lower(sum)).collect();
        let rows: Vec<Vec<usize>> = (0..self.matrix.len()).map(|k| vec![k]).collect();
        System::new(&mut lowering.program, matrix, right_side).solve(&rows).solution
    }
}

/// The rates of coordinates by themselves.
struct Rates {
    accelerations: Program,
    rates: Program,
    sine_symbols: Vec<Symbol>,
    angles: Program,
}

impl Rates {
    /// Of a program that gives them behind accelerations, to which sines and cosines of their angles are added.
    fn of(mut accelerations: Program, n_accelerations: usize, new_symbol: &mut dyn FnMut(String) -> Symbol) -> Self {
        let outputs = accelerations.outputs()[n_accelerations..].to_vec();
        let rates = accelerations.reading(&outputs, &[]);
        let found = rates.angles();
        let (mut given, mut angles) = (Vec::new(), Vec::new());
        for (k, angle) in found.into_iter().enumerate() {
            angles.push(Value { node: angle, negative: false });
            for (name, node) in [("sine", Node::Sin(angle)), ("cosine", Node::Cos(angle))] {
                let value = accelerations.leaf(node);
                accelerations.push_output(value);
                given.push((value.node, new_symbol(format!("{name}_{}", k + 1))));
            }
        }
        Self {
            rates: accelerations.reading(&outputs, &given),
            sine_symbols: given.iter().map(|&(_, symbol)| symbol).collect(),
            angles: accelerations.reading(&angles, &[]),
            accelerations,
        }
    }
}

/// d/dt of what depends on angles and time.
fn rate(algebra: &mut Algebra, sum: SumId, rates: &[(Symbol, SumId)]) -> SumId {
    let mut parts = vec![algebra.diff(sum, Symbol::TIME)];
    for &(angle, rate) in rates {
        let slope = algebra.diff(sum, angle);
        parts.push(algebra.mul(slope, rate));
    }
    algebra.total(&parts)
}

/// What stands for the velocity of a body along its axis, across it, or for its angular velocity.
fn name_along(equations: &mut Equations, i: usize) -> Symbol {
    let name = equations.symbols.code_name(equations.symbols.velocity_at(i));
    let name = match name
        .strip_suffix("_vx")
        .map(|of| (of, "along"))
        .or_else(|| Some((name.strip_suffix("_vy")?, "across")))
    {
        Some((body, direction)) => format!("{body}_{direction}"),
        None => name,
    };
    equations.symbols.new_named(name)
}

/// The same from the velocities of coordinates.
fn along_axis(equations: &mut Equations, frames: &[usize], i: usize) -> SumId {
    let Coordinate { body, component } = Coordinate::at(i);
    let first = N_OF_BODY * body.0;
    if component.is_angle() {
        let symbol = equations.symbols.velocity_at(i);
        return equations.algebra.symbol(symbol);
    }
    let sines = sines(equations, frames[body.0]);
    let v = [first, first + 1].map(|j| equations.algebra.symbol(equations.symbols.velocity_at(j)));
    turned(&mut equations.algebra, sines, v)[i - first]
}

/// v from velocities along axes.
fn world_velocities(equations: &mut Equations, frames: &[usize], w: &[SumId]) -> Vec<SumId> {
    let mut v = Vec::new();
    for (&frame, of_body) in frames.iter().zip(w.chunks(N_OF_BODY)) {
        let [sin, cos] = sines(equations, frame);
        let algebra = &mut equations.algebra;
        let back = [algebra.neg(sin), cos];
        v.extend(turned(algebra, back, [of_body[0], of_body[1]]));
        v.push(of_body[2]);
    }
    v
}

/// A force with velocities along axes in place of those of coordinates.
fn in_velocities_along(equations: &mut Equations, force: SumId, world: &[SumId]) -> SumId {
    let Equations { algebra, symbols, .. } = equations;
    algebra.substitute(force, &mut |_, atom| match atom {
        Atom::Symbol(symbol) => symbols.velocity_of(*symbol).map(|i| world[i]),
        _ => None,
    })
}

/// Adds the angles of bodies whose sine or cosine a sum reads.
fn angles_turned_by(algebra: &Algebra, sum: SumId, found: &mut BTreeSet<Symbol>) {
    for &(monomial, _) in algebra.terms(sum) {
        for &(atom, _) in algebra.monomial(monomial) {
            match algebra.atom(atom) {
                Atom::Symbol(_) => {}
                Atom::Sin(angle) | Atom::Cos(angle) => found.extend(algebra.as_symbol(*angle)),
                Atom::Group(inner) => angles_turned_by(algebra, *inner, found),
                Atom::Call(_, arguments) => arguments.iter().for_each(|&of| angles_turned_by(algebra, of, found)),
            }
        }
    }
}
