//! The body of an exported function: names for what occurs more than once, then what it returns.

use crate::model::SceneInfo;
use crate::scalar::{Function, Operand, Operation};

use super::expression::{Expression, Syntax};
use super::identifiers::Identifiers;
use super::kernels::{Group, Kernel, Kernels};

/// Names and numbers in an expression from which on it gets a name of its own: what fits into a line.
const LARGEST_SIZE: usize = 8;

/// A function as statements, texts of a language.
#[derive(Debug)]
pub(super) struct Body {
    /// Names with their expressions, each before its use.
    pub named: Vec<(String, String)>,
    /// For each vector or matrix that is returned: places of its entries, as rows and columns, and their expressions. Entries that are zero
    /// are left out.
    pub returned: Vec<Vec<(Place, String)>>,
    /// The arguments that are read.
    pub read: Vec<Group>,
}

/// Row of a vector; row and column of a matrix. From zero.
pub(super) type Place = (usize, Option<usize>);

/// The statements of `kernel`.
pub(super) fn body(syntax: &dyn Syntax, info: &SceneInfo, kernels: &Kernels, kernel: &Kernel) -> Body {
    let n_uses = uses(kernel);
    let names = VariableNames { info, kernels };
    let mut identifiers = Identifiers::new();
    let mut named = Vec::new();
    let mut expressions: Vec<Option<Expression>> = vec![None; kernel.tape.operations.len()];
    for (place, &operation) in kernel.tape.operations.iter().enumerate().filter(|&(place, _)| n_uses[place] > 0) {
        let (expression, wanted) = match operation {
            Operation::Variable(i) => {
                let (group, member) = kernels.variables.place(i);
                let element = match group {
                    Group::Time => group.letter().to_owned(),
                    _ => syntax.element(group.letter(), member),
                };
                let wanted = (group != Group::Time).then(|| names.name(group, member));
                (Expression::name(element), wanted)
            }
            _ => {
                let operand = |of| written(syntax, &expressions, of);
                let expression = Expression::of(syntax, operation, operand);
                let needs_name = n_uses[place] > 1 && !matches!(operation, Operation::Negative(_));
                let wanted = (needs_name || expression.size >= LARGEST_SIZE).then(|| {
                    VariableNames::of_operation(operation, operand).unwrap_or_else(|| format!("w{}", named.len() + 1))
                });
                (expression, wanted)
            }
        };
        expressions[place] = Some(match wanted {
            Some(wanted) => {
                let name = identifiers.give(&wanted);
                named.push((name.clone(), expression.text()));
                Expression::name(name)
            }
            None => expression,
        });
    }
    let is_zero = |of: Operand| of == Operand::Number(0_f64.to_bits());
    let returned = kernel.returned.iter().map(|returned| {
        let entries = returned.values.iter().enumerate().filter(|&(_, &value)| !is_zero(value));
        let place = |i: usize| returned.n_columns.map_or((i, None), |n| (i / n, Some(i % n)));
        entries.map(|(i, &value)| (place(i), written(syntax, &expressions, value).text())).collect()
    });
    Body { returned: returned.collect(), read: read(kernels, kernel, &n_uses), named }
}

/// The arguments that variables in use belong to.
fn read(kernels: &Kernels, kernel: &Kernel, n_uses: &[usize]) -> Vec<Group> {
    let used = kernel.tape.operations.iter().zip(n_uses).filter(|&(_, &n)| n > 0);
    used.filter_map(|(&operation, _)| match operation {
        Operation::Variable(i) => Some(kernels.variables.place(i).0),
        _ => None,
    })
    .collect()
}

/// How often each operation is used by those that lead to what is returned.
fn uses(kernel: &Kernel) -> Vec<usize> {
    let operations = &kernel.tape.operations;
    let mut n_uses = vec![0; operations.len()];
    let note = |n_uses: &mut [usize], of: Operand, n: usize| {
        if let Operand::Result(place) = of {
            n_uses[place] += n;
        }
    };
    kernel.returned.iter().flat_map(|returned| &returned.values).for_each(|&value| note(&mut n_uses, value, 1));
    for place in (0..operations.len()).rev() {
        if n_uses[place] > 0 {
            // a sign is written wherever it is used, and with it what it stands before
            let n = if matches!(operations[place], Operation::Negative(_)) { n_uses[place] } else { 1 };
            operations[place].operands().for_each(|of| note(&mut n_uses, of, n));
        }
    }
    n_uses
}

/// The expression of an operand that was met before.
fn written(syntax: &dyn Syntax, expressions: &[Option<Expression>], of: Operand) -> Expression {
    match of {
        Operand::Number(bits) => Expression::number(syntax, f64::from_bits(bits)),
        Operand::Pi => Expression::name(syntax.pi()),
        Operand::Result(place) => expressions[place].clone().unwrap_or_else(|| Expression::name(String::new())),
    }
}

/// What variables are called.
struct VariableNames<'n> {
    info: &'n SceneInfo,
    kernels: &'n Kernels,
}

impl VariableNames<'_> {
    fn name(&self, group: Group, i: usize) -> String {
        let info = self.info;
        let name = match group {
            Group::Coordinates => info.coordinates.get(i).map(|of| of.name.to_string()),
            Group::Velocities => info.velocities.get(i).map(|of| of.name.to_string()),
            Group::States => info.states.get(i).map(|of| of.name.to_owned()),
            Group::Inputs => info.inputs.get(i).map(|of| of.name.to_owned()),
            Group::Parameters => super::head::parameter_names(info).nth(i),
            Group::Constants => Some(self.constant(i)),
            Group::SeedsOfCoordinates | Group::SeedsOfVelocities | Group::SeedsOfStates | Group::SeedsOfInputs => None,
            Group::Time => None,
        };
        name.unwrap_or_else(|| format!("{}{i}", group.letter()))
    }

    /// The parameter that a constant is; else its number.
    fn constant(&self, i: usize) -> String {
        let constants = &self.kernels.constants;
        let operations = &constants.tape.operations;
        let parameter = |of: Operand| match of {
            Operand::Result(place) => match operations[place] {
                Operation::Variable(i) => Some(self.kernels.variables.place(i)),
                _ => None,
            },
            Operand::Number(_) | Operand::Pi => None,
        };
        let value = constants.returned[0].values[i];
        let name = parameter(value).map(|(group, i)| self.name(group, i));
        name.unwrap_or_else(|| format!("k{i}"))
    }

    /// Sine and cosine of a name are called so: `sin_seat_phi`.
    fn of_operation(operation: Operation, operand: impl Fn(Operand) -> Expression) -> Option<String> {
        let (function, angle) = match operation {
            Operation::Unary(Function::Sin, angle) => ("sin", operand(angle)),
            Operation::Unary(Function::Cos, angle) => ("cos", operand(angle)),
            _ => return None,
        };
        angle.is_name().then(|| format!("{function}_{}", angle.text()))
    }
}
