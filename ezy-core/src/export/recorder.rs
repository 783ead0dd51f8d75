//! The kernels of a scene as recorded operations.

use crate::model::{Equations, SceneInfo};
use crate::scalar::{Operand, Recorded, record, tangents};

use super::kernels::{Group, Kernel, Kernels, Returned, Variables};

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
        let recorder = Recorder::new(info, equations);
        let of_motion = recorder.of_motion();
        Self {
            constants: recorder.constants(),
            of_motion,
            accelerations: (is_eliminated || info.n_rows() == 0).then(|| recorder.accelerations()),
            derivatives: None,
            pivot: (is_eliminated && info.n_rows() > 0).then(|| recorder.pivot()),
            variables: recorder.into_variables(),
        }
    }

    /// The same with derivatives, where an elimination solves for accelerations.
    pub(super) fn with_derivatives(mut self, info: &SceneInfo, equations: &dyn Equations<Recorded>) -> Self {
        let recorder = Recorder::new(info, equations);
        self.derivatives = self.accelerations.as_ref().map(|_| recorder.derivatives());
        self
    }
}

/// Runs the kernels of a scene on numbers that record.
struct Recorder<'k> {
    info: &'k SceneInfo,
    equations: &'k dyn Equations<Recorded>,
    variables: Variables,
}

impl<'k> Recorder<'k> {
    fn new(info: &'k SceneInfo, equations: &'k dyn Equations<Recorded>) -> Self {
        Self { info, equations, variables: Variables::new(info) }
    }

    fn into_variables(self) -> Variables {
        self.variables
    }

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
        if !info.events.is_empty() {
            all.push(self.kernel(
                ["events", "event", "Functions that pass zero where an event takes place, in SI units."],
                info.events.len(),
                |scene, at, out| scene.events(&at.c, at.t, &at.q, &at.v, out),
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
            accelerations(self.info, scene, at, a, multipliers);
        });
        let values: Vec<Operand> = kernel.returned.into_iter().flat_map(|all| all.values).collect();
        let returned = [("acceleration", &values[..n_v]), ("multiplier", &values[n_v..])].map(|(name, of)| Returned {
            name,
            n_columns: None,
            values: of.to_vec(),
        });
        Kernel { returned: returned.into(), ..kernel }
    }

    fn derivatives(&self) -> Kernel {
        let info = self.info;
        let (n_v, n_c) = (info.n_velocities(), info.n_rows());
        let sizes = [n_v, n_c, info.n_states(), info.n_outputs()];
        let varied = [
            (Group::Coordinates, Group::SeedsOfCoordinates),
            (Group::Velocities, Group::SeedsOfVelocities),
            (Group::States, Group::SeedsOfStates),
            (Group::Inputs, Group::SeedsOfInputs),
        ];
        let about = "Changes of accelerations, multipliers, rates of first-order states and outputs for changes dq, dv, dz, du.";
        let n = sizes.iter().sum();
        let kernel = self.kernel(["derivatives", "", about], n, |scene, at, out| {
            let (a, rest) = out.split_at_mut(n_v);
            let (multipliers, rest) = rest.split_at_mut(n_c);
            let (rates, outputs) = rest.split_at_mut(info.n_states());
            accelerations(info, scene, at, a, multipliers);
            scene.state_rates(&at.c, at.t, &at.q, &at.v, rates);
            scene.outputs(&at.c, at.t, &at.q, &at.v, outputs);
            let all = tangents(|variable| {
                let (group, i) = self.variables.place(variable);
                let seeds = varied.iter().find(|(of, _)| *of == group)?.1;
                Some(self.variables.recorded(seeds)[i])
            });
            for value in out {
                *value = match value.operand() {
                    Operand::Result(place) => all[place].unwrap_or(ZERO),
                    Operand::Number(_) | Operand::Pi => ZERO,
                };
            }
        });
        let mut values = kernel.returned.into_iter().flat_map(|all| all.values);
        let names = ["change_of_acceleration", "change_of_multiplier", "change_of_rates", "change_of_output"];
        let returned = names.into_iter().zip(sizes).map(|(name, n)| Returned {
            name,
            n_columns: None,
            values: values.by_ref().take(n).collect(),
        });
        let returned = returned.collect();
        let mut arguments = kernel.arguments;
        arguments.extend(self.variables.seeds());
        Kernel { arguments, returned, ..kernel }
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

/// Accelerations and multipliers, where they are eliminated for or there are no rows.
fn accelerations(
    info: &SceneInfo,
    scene: &dyn Equations<Recorded>,
    at: &Motion,
    a: &mut [Recorded],
    multipliers: &mut [Recorded],
) {
    if info.n_rows() > 0 {
        // whether pivots vanish is not known here
        let _ = scene.accelerations(&at.c, at.t, &at.q, &at.v, a, multipliers);
        return;
    }
    let mut mass = vec![ZERO; a.len()];
    scene.mass_matrix(&at.c, &mut mass);
    scene.applied_force(&at.c, at.t, &at.q, &at.v, a);
    a.iter_mut().zip(mass).for_each(|(a, m)| *a = *a / m);
}
