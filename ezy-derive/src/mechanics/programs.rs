//! The programs of all kernels, from the expressions of a scene.

use super::elements::Element;
use super::jacobians::Jacobians;
use super::kernels::{Entries, Kernel, Kernels, Pass, Put, Quantity, Read};
use super::powers::ForceElement;
use super::quasi::QuasiVelocities;
use super::scene::{Equations, Group};
use super::series::{Series, Solution};
use super::solve::{Solutions, Solver};
use super::templates::{RowTemplate, Templates};
use crate::model::{BodyId, Coordinate, Loop};
use crate::symbolic::lower::{ConstantPool, Lowering};
use crate::symbolic::program::Program;
use crate::symbolic::{Algebra, SumId, Symbol};

/// Lowers sums to programs that share a vector of constants.
struct Lower<'a> {
    algebra: &'a Algebra,
    constants: &'a mut ConstantPool,
}

impl Lower<'_> {
    fn program(&mut self, sums: &[SumId]) -> Program {
        let mut lowering = Lowering::new(self.algebra, self.constants);
        for &sum in sums {
            let value = lowering.lower(sum);
            lowering.program.push_output(value);
        }
        let mut program = lowering.program;
        program.settle_signs();
        program
    }

    fn pass<'m>(&mut self, loops: &'m [Loop], slots: &[BodyId], sums: &[SumId], puts: Vec<Put>) -> Pass<'m> {
        Pass { loops, slots: slots.to_vec(), ..Pass::once(self.program(sums), puts, Vec::new()) }
    }

    /// A pass that fills the only vector of its kernel.
    fn stacked<'m>(&mut self, loops: &'m [Loop], slots: &[BodyId], sums: &[SumId]) -> Pass<'m> {
        self.pass(loops, slots, sums, vec![Put::Next(0); sums.len()])
    }

    /// A kernel of one pass that fills one vector.
    fn vector<'m>(&mut self, sums: &[SumId]) -> Kernel<'m> {
        self.once(sums, vec![Put::Next(0); sums.len()], Vec::new())
    }

    /// A kernel of one pass.
    fn once<'m>(&mut self, sums: &[SumId], puts: Vec<Put>, reads: Vec<(Symbol, Read)>) -> Kernel<'m> {
        Kernel::of(vec![Pass::once(self.program(sums), puts, reads)])
    }
}

/// The kernels of a scene whose bodies are known; those that solve are there already.
pub fn straight<'m>(equations: &Equations, jacobians: Option<&Jacobians>, constants: &mut ConstantPool) -> Kernels<'m> {
    let constraints = &equations.constraints;
    let jacobian: Vec<SumId> = constraints.jacobian.iter().flatten().map(|&(_, entry)| entry).collect();
    let points: Vec<SumId> = equations.points.iter().flat_map(|point| point.position).collect();
    let power: Vec<SumId> = equations.power.iter().map(|&(_, power)| power).collect();
    let outputs: Vec<SumId> = equations.outputs.iter().map(|&(_, value)| value).collect();
    let events: Vec<SumId> = equations.events.iter().map(|event| event.value).collect();
    let start: Vec<SumId> = equations.start.iter().map(|given| given.value).collect();
    let mut lower = Lower { algebra: &equations.algebra, constants };
    let mut kernels = Kernels::new();
    for (quantity, sums) in [
        (Quantity::MassMatrix, &equations.mass_entries),
        (Quantity::PositionConstraint, &constraints.position),
        (Quantity::VelocityConstraint, &constraints.velocity),
        (Quantity::VelocityJacobian, &jacobian),
        (Quantity::ConvectiveTerm, &constraints.convective),
        (Quantity::AppliedForce, &equations.force),
    ] {
        kernels.insert(quantity, lower.vector(sums));
    }
    if !equations.rates.is_empty() {
        kernels.insert(Quantity::StateRates, lower.vector(&equations.rates));
    }
    let multipliers = equations.multipliers.iter().map(|&(symbol, row)| (symbol, Read::Multiplier(row)));
    kernels.insert(Quantity::Power, lower.once(&power, vec![Put::Next(0); power.len()], multipliers.collect()));
    kernels.insert(Quantity::Points, lower.vector(&points));
    kernels.insert(Quantity::Outputs, lower.vector(&outputs));
    kernels.insert(Quantity::PotentialEnergy, lower.once(&[equations.potential], vec![Put::Total], Vec::new()));
    let gives = equations.start.iter();
    let gives = gives.map(|given| Put::Start { index: given.index, rate: given.rate, near: given.near });
    kernels.insert(Quantity::Start, lower.once(&start, gives.collect(), Vec::new()));
    if let Some(jacobians) = jacobians {
        kernels.insert(Quantity::Jacobians, lower.once(&jacobians.values(), jacobians.puts(), jacobians.reads.clone()));
        if !jacobians.by_z.is_empty() {
            kernels.insert(Quantity::StateJacobians, lower.vector(&jacobians.values_by_states()));
        }
    }
    if !equations.limited_skates.is_empty() {
        kernels.insert(Quantity::LimitedSkates, lower.vector(equations.limited_skates.as_flattened()));
    }
    if let Some(contact) = &equations.contact {
        kernels.insert(Quantity::Stop, lower.vector(&contact.values()));
    }
    if !events.is_empty() {
        kernels.insert(Quantity::Events, lower.vector(&events));
    }
    kernels
}

/// The kernels that solve.
pub fn solutions<'m>(solutions: Solutions) -> impl Iterator<Item = (Quantity, Kernel<'m>)> {
    let Solutions { accelerations, correction, residuals, projected, .. } = solutions;
    let n_q = correction.n_outputs;
    let residuals = residuals.into_iter().enumerate().map(|(row, symbol)| (symbol, Read::Residual(row))).collect();
    [
        (Quantity::Accelerations, accelerations, n_q, Vec::new()),
        (Quantity::Correction, correction, n_q, residuals),
        (Quantity::ProjectedAccelerations, projected, usize::MAX, Vec::new()),
    ]
    .into_iter()
    .map(|(quantity, Solver { program, n_outputs, pivots }, first, reads)| {
        let puts = (0..n_outputs).map(|i| Put::Next(usize::from(i >= first))).collect();
        (quantity, Kernel { passes: vec![Pass::once(program, puts, reads)], pivots: Some(pivots) })
    })
}

/// The kernels in quasi-velocities.
pub fn quasi<'m>(algebra: &Algebra, of: &QuasiVelocities, constants: &mut ConstantPool) -> [(Quantity, Kernel<'m>); 8] {
    let values = Lower { algebra, constants }.vector(&of.values);
    let quasi = of.symbols.iter().enumerate().map(|(k, &symbol)| (symbol, Read::QuasiVelocity(k)));
    let of_time = of.time_symbols.iter().enumerate().map(|(k, &symbol)| (symbol, Read::OfTime(k)));
    let sines = of.sine_symbols.iter().enumerate().map(|(k, &symbol)| (symbol, Read::Sine(k)));
    let mut reads: Vec<(Symbol, Read)> = quasi.chain(of_time).chain(sines).collect();
    reads.sort_by_key(|&(symbol, _)| symbol);
    // from each of these places on outputs fill the next vector
    let kernel = |program: &Program, places: &[usize]| {
        let vector = |i: usize| places.iter().filter(|&&place| place <= i).count();
        let puts = (0..program.outputs().len()).map(|i| Put::Next(vector(i))).collect();
        Kernel::of(vec![Pass::once(program.clone(), puts, reads.clone())])
    };
    let n_u = of.symbols.len();
    [
        (Quantity::QuasiVelocities, values),
        (Quantity::Velocities, kernel(&of.velocities, &[])),
        (Quantity::OfTime, kernel(&of.of_time, &[])),
        (Quantity::QuasiAccelerations, kernel(&of.accelerations, &[n_u, n_u + of.feedback.len()])),
        (Quantity::QuasiRates, kernel(&of.rates, &[])),
        (Quantity::QuasiAngles, kernel(&of.angles, &[])),
        (Quantity::QuasiMotion, kernel(&of.motion, &[n_u])),
        (Quantity::WholeState, kernel(&of.whole_state, &[of.velocities.outputs().len()])),
    ]
}

/// The kernels of the Taylor series of a scene, or of the items of a scene with counts.
pub fn series(items: Vec<Series<'_>>) -> [(Quantity, Kernel<'_>); 4] {
    let [mut begin, mut right_side, mut solution, mut finish] = [(); 4].map(|()| Kernel::of(Vec::new()));
    for item in items {
        begin.passes.push(item.begin);
        right_side.passes.push(item.right_side);
        finish.passes.push(item.finish);
        if let Some(Solution { pivots, pass }) = item.solution {
            begin.pivots = Some(pivots);
            solution.passes.push(pass);
        }
    }
    [
        (Quantity::SeriesBegin, begin),
        (Quantity::SeriesRightSide, right_side),
        (Quantity::SeriesSolution, solution),
        (Quantity::SeriesFinish, finish),
    ]
}

/// The kernels of a scene with counts, but for the Jacobians and the series.
pub fn counted<'m>(templates: &Templates<'m>, constants: &mut ConstantPool) -> Kernels<'m> {
    let Templates { rows, forces, groups, .. } = templates;
    let mut lower = Lower { algebra: &templates.algebra, constants };
    let mut kernels = Kernels::new();
    let masses = templates.masses.iter();
    let masses = masses.map(|(array, masses)| lower.stacked(&array.loops, &[], masses));
    kernels.insert(Quantity::MassMatrix, Kernel::of(masses.collect()));

    let position_rows = || rows.iter().filter(|row| row.is_position());
    let mut stack =
        |quantity, rows: &mut dyn Iterator<Item = &RowTemplate<'m>>, sums: fn(&RowTemplate<'m>) -> Vec<SumId>| {
            let passes = rows.map(|row| lower.stacked(&row.row.loops, &row.slots, &sums(row)));
            kernels.insert(quantity, Kernel::of(passes.collect()));
        };
    stack(Quantity::PositionConstraint, &mut position_rows(), |row| row.constraints.position.clone());
    stack(Quantity::VelocityConstraint, &mut rows.iter(), |row| row.constraints.velocity.clone());
    let entries = |row: &RowTemplate<'m>| row.constraints.jacobian.iter().flatten().map(|&(_, entry)| entry).collect();
    stack(Quantity::VelocityJacobian, &mut rows.iter(), entries);
    stack(Quantity::ConvectiveTerm, &mut rows.iter(), |row| row.constraints.convective.clone());

    let applied = forces.iter().map(|force| {
        let (places, sums): (Vec<Put>, Vec<SumId>) =
            force.entries.iter().map(|&(i, entry)| (Put::Coordinate(i), entry)).unzip();
        lower.pass(&force.force.loops, &force.slots, &sums, places)
    });
    kernels.insert(Quantity::AppliedForce, Kernel::of(applied.collect()));
    if !templates.rates.is_empty() {
        let rates = templates.rates.iter().map(|(rate, slots)| lower.stacked(&[], slots, &[*rate]));
        kernels.insert(Quantity::StateRates, Kernel::of(rates.collect()));
    }
    let points = templates.points.iter();
    let points = points.map(|of| lower.stacked(&of.point.loops, &of.slots, &of.position));
    kernels.insert(Quantity::Points, Kernel::of(points.collect()));
    let outputs = templates.outputs.iter();
    let outputs = outputs.map(|of| lower.stacked(&of.output.loops, &of.slots, &[of.value]));
    kernels.insert(Quantity::Outputs, Kernel::of(outputs.collect()));
    if !templates.events.is_empty() {
        let events = templates.events.iter();
        let events = events.map(|of| lower.stacked(&[], &of.slots, &[of.event.value]));
        kernels.insert(Quantity::Events, Kernel::of(events.collect()));
    }

    let group = |group: Group| Put::Group(groups.iter().position(|other| *other == group).unwrap_or(0));
    let working = forces.iter().filter(|force| !force.power.is_zero());
    let mut power: Vec<Pass<'m>> =
        working.map(|of| lower.pass(&of.force.loops, &of.slots, &[of.power], vec![group(of.group)])).collect();
    // rows that stand still are passed over, so that those that move find their multipliers
    let n_counted = rows.iter().rposition(|row| !row.multipliers.is_empty()).map_or(0, |last| last + 1);
    power.extend(rows[..n_counted].iter().map(|row| {
        let moves = !row.multipliers.is_empty();
        let (sums, puts) = if moves { (vec![row.power], vec![group(Group::Drives)]) } else { (vec![], vec![]) };
        let reads = row.multipliers.iter().map(|&(symbol, own)| (symbol, Read::Multiplier(own))).collect();
        let pass = lower.pass(&row.row.loops, &row.slots, &sums, puts);
        Pass { reads, lengths: vec![(Entries::Rows, row.constraints.rows.len())], ..pass }
    }));
    kernels.insert(Quantity::Power, Kernel::of(power));
    let potential = forces.iter().filter(|force| !force.potential.is_zero());
    let potential =
        potential.map(|of| lower.pass(&of.force.loops, &of.slots, &[of.potential], vec![Put::Total])).collect();
    kernels.insert(Quantity::PotentialEnergy, Kernel::of(potential));
    let start = templates.start.iter().map(|&(given, value)| {
        let put = Put::Start {
            index: Coordinate { body: given.body, component: given.component }.place(),
            rate: given.rate,
            near: given.near,
        };
        lower.pass(&given.loops, &[given.body], &[value], vec![put])
    });
    kernels.insert(Quantity::Start, Kernel::of(start.collect()));
    kernels
}

/// The Jacobians of a scene with counts, item by item.
pub fn counted_jacobians<'m>(
    templates: &Templates<'m>,
    jacobians: &[Jacobians],
    constants: &mut ConstantPool,
) -> Kernels<'m> {
    let mut lower = Lower { algebra: &templates.algebra, constants };
    let passes = templates.items().zip(jacobians).map(|(item, jacobians)| {
        let pass = lower.pass(item.loops, item.slots, &jacobians.values(), jacobians.puts());
        Pass { reads: jacobians.reads.clone(), lengths: vec![(Entries::Rows, item.n_rows())], ..pass }
    });
    let mut kernels = Kernels::from([(Quantity::Jacobians, Kernel::of(passes.collect()))]);
    let of_states = templates.items().zip(jacobians).filter(|(_, jacobians)| !jacobians.by_z.is_empty());
    let of_states: Vec<_> =
        of_states.map(|(item, of)| lower.stacked(item.loops, item.slots, &of.values_by_states())).collect();
    if !of_states.is_empty() {
        kernels.insert(Quantity::StateJacobians, Kernel::of(of_states));
    }
    kernels
}

/// The values of what a picture shows, item by item in a scene with counts.
pub fn elements<'m>(
    algebra: &Algebra,
    elements: &[Element<'m>],
    is_counted: bool,
    constants: &mut ConstantPool,
) -> Kernel<'m> {
    let mut lower = Lower { algebra, constants };
    if !is_counted {
        return lower.vector(&elements.iter().flat_map(Element::values).collect::<Vec<_>>());
    }
    let passes = elements.iter().map(|of| lower.stacked(of.loops, &of.slots, &of.values()));
    Kernel::of(passes.collect())
}

/// The power of each force element, member by member in a scene with counts; `None` without any.
pub fn element_powers<'m>(
    algebra: &Algebra,
    elements: &[ForceElement<'m>],
    is_counted: bool,
    constants: &mut ConstantPool,
) -> Option<Kernel<'m>> {
    if elements.is_empty() {
        return None;
    }
    let mut lower = Lower { algebra, constants };
    if !is_counted {
        let powers: Vec<SumId> = elements.iter().flat_map(|of| &of.terms).map(|term| term.power).collect();
        return Some(lower.vector(&powers));
    }
    let terms = elements.iter().enumerate().flat_map(|(i, of)| of.terms.iter().map(move |term| (i, term)));
    let passes = terms.map(|(i, of)| lower.pass(of.loops, &of.slots, &[of.power], vec![Put::Group(i)]));
    Some(Kernel::of(passes.collect()))
}
