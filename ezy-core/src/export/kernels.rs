//! The kernels of a scene as recorded operations.

use crate::model::{Equations, SceneInfo};
use crate::scalar::{Operand, Recorded, Tape, record};

/// A group of variables that a kernel reads.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Group {
    Time,
    Coordinates,
    Velocities,
    States,
    Inputs,
    Constants,
    Parameters,
}

impl Group {
    /// As an argument.
    pub(super) const fn letter(self) -> &'static str {
        match self {
            Self::Time => "t",
            Self::Coordinates => "q",
            Self::Velocities => "v",
            Self::States => "z",
            Self::Inputs => "u",
            Self::Constants => "c",
            Self::Parameters => "p",
        }
    }

    const MOTION: [Self; 6] =
        [Self::Time, Self::Coordinates, Self::Velocities, Self::States, Self::Inputs, Self::Constants];
}

/// A vector or a matrix that a kernel returns. A matrix has its rows one behind the other.
#[derive(Debug)]
pub(super) struct Returned {
    pub name: &'static str,
    /// Columns of a matrix.
    pub n_columns: Option<usize>,
    pub values: Vec<Operand>,
}

/// A function of an exported file.
#[derive(Debug)]
pub(super) struct Kernel {
    pub name: &'static str,
    pub about: &'static str,
    pub arguments: Vec<Group>,
    pub tape: Tape,
    pub returned: Vec<Returned>,
}

/// All functions, in the order in which they are printed.
#[derive(Debug)]
pub(super) struct Kernels {
    pub constants: Kernel,
    pub of_motion: Vec<Kernel>,
    /// `None` without a generated elimination: then the file solves a dense matrix.
    pub accelerations: Option<Kernel>,
    pub pivot: Option<Kernel>,
    /// Variables of each group: the first one, and how many there are.
    pub variables: Variables,
}

/// Which variable is which, and which groups a scene has.
#[derive(Debug, Clone)]
pub(super) struct Variables {
    sizes: Vec<(Group, usize)>,
}

impl Variables {
    fn new(info: &SceneInfo) -> Self {
        let sizes = [
            (Group::Time, 1),
            (Group::Coordinates, info.n_coordinates()),
            (Group::Velocities, info.n_velocities()),
            (Group::States, info.n_states()),
            (Group::Inputs, info.n_inputs()),
            (Group::Constants, info.n_constants),
            (Group::Parameters, info.parameters.len() + info.switches.len()),
        ];
        Self { sizes: sizes.to_vec() }
    }

    pub(super) fn size(&self, group: Group) -> usize {
        self.sizes.iter().find(|&&(of, _)| of == group).map_or(0, |&(_, n)| n)
    }

    fn recorded(&self, group: Group) -> Vec<Recorded> {
        let before = self.sizes.iter().take_while(|&&(of, _)| of != group);
        let first: usize = before.map(|&(_, n)| n).sum();
        (first..first + self.size(group)).map(Recorded::variable).collect()
    }

    /// Group and place of a variable.
    pub(super) fn place(&self, mut variable: usize) -> (Group, usize) {
        for &(group, n) in &self.sizes {
            if variable < n {
                return (group, variable);
            }
            variable -= n;
        }
        (Group::Time, 0)
    }

    /// What functions of the motion take: first-order states and inputs only in scenes that have some.
    pub(super) fn of_motion(&self) -> Vec<Group> {
        let is_there = |&group: &Group| !matches!(group, Group::States | Group::Inputs) || self.size(group) > 0;
        Group::MOTION.into_iter().filter(is_there).collect()
    }
}

/// The variables of the motion, recorded.
struct Motion {
    c: Vec<Recorded>,
    t: Recorded,
    q: Vec<Recorded>,
    v: Vec<Recorded>,
}

const ZERO: Recorded = Recorded::number(0.0);

impl Kernels {
    pub(super) fn of(info: &SceneInfo, equations: &dyn Equations<Recorded>, is_eliminated: bool) -> Self {
        let recorder = Recorder { info, equations, variables: Variables::new(info) };
        let of_motion = recorder.of_motion();
        Self {
            constants: recorder.constants(),
            of_motion,
            accelerations: is_eliminated.then(|| recorder.accelerations()),
            pivot: (is_eliminated && info.n_rows() > 0).then(|| recorder.pivot()),
            variables: recorder.variables,
        }
    }

    /// All of them, the accelerations last.
    pub(super) fn all(&self) -> impl Iterator<Item = &Kernel> {
        let first = std::iter::once(&self.constants).chain(&self.of_motion);
        first.chain(self.accelerations.as_ref()).chain(self.pivot.as_ref())
    }
}

struct Recorder<'k> {
    info: &'k SceneInfo,
    equations: &'k dyn Equations<Recorded>,
    variables: Variables,
}

impl Recorder<'_> {
    fn constants(&self) -> Kernel {
        let n_given = self.info.n_inputs() + self.info.n_states();
        let (values, tape) = record(|| {
            let mut c = vec![ZERO; self.info.n_fixed()];
            self.equations.constants(&self.variables.recorded(Group::Parameters), &mut c);
            c[n_given..].iter().map(|c| c.operand()).collect()
        });
        Kernel {
            name: "constants",
            about: "Everything that depends on the parameters p alone; all other functions take it.",
            arguments: vec![Group::Parameters],
            tape,
            returned: vec![Returned { name: "c", n_columns: None, values }],
        }
    }

    fn motion(&self) -> Motion {
        let [q, v, z, u, c] = [Group::Coordinates, Group::Velocities, Group::States, Group::Inputs, Group::Constants]
            .map(|group| self.variables.recorded(group));
        let t = self.variables.recorded(Group::Time)[0];
        Motion { c: [u, z, c].concat(), t, q, v }
    }

    /// A kernel that writes `n` numbers.
    fn kernel(
        &self,
        [name, returned, about]: [&'static str; 3],
        n: usize,
        compute: impl FnOnce(&dyn Equations<Recorded>, &Motion, &mut [Recorded]),
    ) -> Kernel {
        let (values, tape) = record(|| {
            let mut values = vec![ZERO; n];
            compute(self.equations, &self.motion(), &mut values);
            values.iter().map(|value| value.operand()).collect()
        });
        let returned = vec![Returned { name: returned, n_columns: None, values }];
        Kernel { name, about, arguments: self.variables.of_motion(), tape, returned }
    }

    fn of_motion(&self) -> Vec<Kernel> {
        let info = self.info;
        let (n_v, n_c) = (info.n_velocities(), info.n_rows());
        let mass = self.kernel(
            ["mass_matrix", "mass", "Diagonal of the mass matrix M, kg and kg m^2."],
            n_v,
            |scene, at, out| scene.mass_matrix(&at.c, out),
        );
        let mut all = vec![Kernel { arguments: vec![Group::Constants], ..mass }];
        if info.n_position_rows > 0 {
            all.push(self.kernel(
                [
                    "position_constraint",
                    "residual",
                    "C(q, t), which vanishes in every position that the constraints allow.",
                ],
                info.n_position_rows,
                |scene, at, out| scene.position_constraint(&at.c, at.t, &at.q, out),
            ));
        }
        if n_c > 0 {
            all.push(self.kernel(
                [
                    "velocity_constraint",
                    "residual",
                    "All rows at velocity level, G v + g_t, which vanish in every motion.",
                ],
                n_c,
                |scene, at, out| scene.velocity_constraint(&at.c, at.t, &at.q, &at.v, out),
            ));
            all.push(self.jacobian());
            all.push(self.kernel(
                [
                    "convective_term",
                    "convective",
                    "h of position constraints and s of velocity constraints: G a = -[h; s].",
                ],
                n_c,
                |scene, at, out| scene.convective_term(&at.c, at.t, &at.q, &at.v, out),
            ));
        }
        all.push(self.kernel(
            ["applied_force", "force", "Applied forces F, N and N m: M a + G' lambda = F."],
            n_v,
            |scene, at, out| scene.applied_force(&at.c, at.t, &at.q, &at.v, out),
        ));
        if info.n_states() > 0 {
            all.push(self.kernel(
                ["state_rates", "rates", "Rates of the first-order states, in their units over s."],
                info.n_states(),
                |scene, at, out| scene.state_rates(&at.c, at.t, &at.q, &at.v, out),
            ));
        }
        if info.n_outputs() > 0 {
            all.push(self.kernel(
                ["outputs", "output", "The outputs of the scene, each in its unit."],
                info.n_outputs(),
                |scene, at, out| scene.outputs(&at.c, at.t, &at.q, &at.v, out),
            ));
        }
        all
    }

    /// G as a full matrix: entries at one place add up.
    fn jacobian(&self) -> Kernel {
        let n_columns = self.info.n_velocities();
        let about = "The Jacobian G of all rows by the velocities.";
        let kernel = self.kernel(
            ["velocity_jacobian", "jacobian", about],
            self.info.n_rows() * n_columns,
            |scene, at, matrix| {
                let mut entries = vec![ZERO; self.info.jacobian.n_nonzeros()];
                scene.velocity_jacobian(&at.c, at.t, &at.q, &mut entries);
                for (k, row, column) in self.info.jacobian.entries() {
                    let at_place = &mut matrix[row * n_columns + column];
                    *at_place = if *at_place == ZERO { entries[k] } else { *at_place + entries[k] };
                }
            },
        );
        let returned = kernel.returned.into_iter().map(|of| Returned { n_columns: Some(n_columns), ..of }).collect();
        Kernel { returned, ..kernel }
    }

    fn accelerations(&self) -> Kernel {
        let (n_v, n_c) = (self.info.n_velocities(), self.info.n_rows());
        let about = "Accelerations, m/s^2 and rad/s^2, and multipliers of the rows, N and N m; they mean nothing where `pivot` is at most 1.";
        let kernel = self.kernel(["accelerations", "", about], n_v + n_c, |scene, at, out| {
            let (a, multipliers) = out.split_at_mut(n_v);
            // whether pivots vanish is not known here
            let _ = scene.accelerations(&at.c, at.t, &at.q, &at.v, a, multipliers);
        });
        let values: Vec<Operand> = kernel.returned.into_iter().flat_map(|all| all.values).collect();
        let returned = [("acceleration", &values[..n_v]), ("multiplier", &values[n_v..])].map(|(name, of)| Returned {
            name,
            n_columns: None,
            values: of.to_vec(),
        });
        Kernel { returned: returned.into(), ..kernel }
    }

    fn pivot(&self) -> Kernel {
        let about = "Pivots of the elimination, each over the least that counts. Where one is at most 1, rows depend on each other.";
        let kernel = self.kernel(["pivot", "", about], 0, |scene, at, _| {
            let (mut a, mut multipliers) = (vec![ZERO; self.info.n_velocities()], vec![ZERO; self.info.n_rows()]);
            let _ = scene.accelerations(&at.c, at.t, &at.q, &at.v, &mut a, &mut multipliers);
        });
        let mut tape = kernel.tape;
        let values = tape.ratios();
        Kernel { tape, returned: vec![Returned { name: "ratio", n_columns: None, values }], ..kernel }
    }
}
