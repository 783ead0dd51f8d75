//! All that follows from a scene, stage by stage. What is emitted is this, printed.

use super::elements::{Element, elements};
use super::jacobians::Jacobians;
use super::kernels::{Entries, Kernels, Quantity};
use super::lets::write_lets;
use super::powers::{ForceElement, force_elements};
use super::programs;
use super::quasi::QuasiVelocities;
use super::scene::Equations;
use super::series::Series;
use super::solve::Solutions;
use super::symbols::Symbols;
use super::templates::Templates;
use crate::function::Function;
use crate::model::{DeclaredSwitch, InputId, Model, ParameterId, Scene};
use crate::symbolic::Algebra;
use crate::symbolic::lower::ConstantPool;
use crate::symbolic::program::Count;

/// A scene and what follows from it.
#[derive(Debug)]
pub struct Derived<'m> {
    pub scene: Scene,
    pub form: Form<'m>,
    pub kernels: Kernels<'m>,
    /// Whether there are kernels of the Taylor series, or the function of a law that has none.
    pub series: Result<(), Function>,
    /// What kernels read of parameters; each is computed once.
    pub constants: ConstantPool,
    /// What a picture of the scene shows.
    pub elements: Vec<Element<'m>>,
    /// What gives and takes power.
    pub force_elements: Vec<ForceElement<'m>>,
}

/// The equations, and what is derived of all of them together.
#[derive(Debug)]
pub enum Form<'m> {
    Straight(Box<Straight>),
    Counted(Box<Counted<'m>>),
}

/// Of a scene whose bodies are known when it is compiled.
#[derive(Debug)]
pub struct Straight {
    pub equations: Equations,
    /// Blocks in the order of elimination, with whether the pivot is constant.
    pub elimination: Vec<(Vec<usize>, bool)>,
    /// The equations in quasi-velocities, where they take fewer operations.
    pub quasi: Option<QuasiVelocities>,
    /// `None` when they are too long to write.
    pub jacobians: Option<Jacobians>,
}

/// Of a scene whose sizes are numbers of a run; Jacobians by item.
#[derive(Debug)]
pub struct Counted<'m> {
    pub templates: Templates<'m>,
    pub jacobians: Option<Vec<Jacobians>>,
}

impl<'m> Derived<'m> {
    pub fn new(model: &'m Model, scene: &'m Scene) -> Self {
        if model.is_repeated() {
            return Self::counted(model, scene);
        }
        let mut derived = Self::straight(model, scene);
        if let Form::Straight(of) = &mut derived.form {
            let Equations { algebra, symbols, .. } = &mut of.equations;
            derived.elements = elements(model, scene, algebra, symbols);
            let kernel = programs::elements(algebra, &derived.elements, false, &mut derived.constants);
            derived.kernels.insert(Quantity::Elements, kernel);
            // last, so that what is computed of parameters for other kernels stays where it is
            derived.force_elements = force_elements(model, scene, algebra, symbols);
            let kernel = programs::element_powers(algebra, &derived.force_elements, false, &mut derived.constants);
            derived.kernels.extend(kernel.map(|kernel| (Quantity::ElementPowers, kernel)));
        }
        derived
    }

    fn straight(model: &Model, scene: &Scene) -> Derived<'m> {
        let mut equations = Equations::derive(model, scene);
        let mut constants = ConstantPool::default();
        let solutions = Solutions::derive(&mut equations, &mut constants);
        let series = Series::derive(&mut equations, &mut constants);
        let Equations { algebra, symbols, constraints, force, rates, .. } = &mut equations;
        let force = force.iter().copied().enumerate();
        let jacobians = Jacobians::derive(algebra, symbols, Some(constraints), force, rates);
        let mut kernels = programs::straight(&equations, jacobians.as_ref(), &mut constants);
        let series = series.map(|series| kernels.extend(programs::series(vec![series])));
        let elimination = solutions.as_ref().map(|solutions| solutions.order.clone()).unwrap_or_default();
        let quasi = solutions.as_ref().and_then(|of| QuasiVelocities::derive(&mut equations, of, &mut constants));
        kernels.extend(quasi.iter().flat_map(|quasi| programs::quasi(&equations.algebra, quasi, &mut constants)));
        kernels.extend(solutions.into_iter().flat_map(programs::solutions));
        write_lets(model, scene, &mut equations.algebra, &mut equations.symbols);
        let form = Form::Straight(Box::new(Straight { equations, elimination, quasi, jacobians }));
        Self {
            scene: scene.clone(),
            form,
            kernels,
            series,
            constants,
            elements: Vec::new(),
            force_elements: Vec::new(),
        }
    }

    fn counted(model: &'m Model, scene: &'m Scene) -> Self {
        let mut templates = Templates::derive(model, scene);
        let mut constants = ConstantPool::default();
        let mut kernels = programs::counted(&templates, &mut constants);
        let series = templates.series(&mut constants);
        let jacobians = templates.jacobians();
        if let Some(jacobians) = &jacobians {
            kernels.extend(programs::counted_jacobians(&templates, jacobians, &mut constants));
        }
        let series = series.map(|series| kernels.extend(programs::series(series)));
        let Templates { algebra, symbols, .. } = &mut templates;
        write_lets(model, scene, algebra, symbols);
        let elements = elements(model, scene, algebra, symbols);
        kernels.insert(Quantity::Elements, programs::elements(algebra, &elements, true, &mut constants));
        let force_elements = force_elements(model, scene, algebra, symbols);
        let kernel = programs::element_powers(algebra, &force_elements, true, &mut constants);
        kernels.extend(kernel.map(|kernel| (Quantity::ElementPowers, kernel)));
        let form = Form::Counted(Box::new(Counted { templates, jacobians }));
        Self { scene: scene.clone(), form, kernels, series, constants, elements, force_elements }
    }

    /// Products and operations of one order of the series; in a scene with counts, those of one member of each item.
    ///
    /// # Errors
    /// A function that has no Taylor series.
    pub fn series_cost(&self) -> Result<(usize, Count), Function> {
        self.series?;
        let of_order = [Quantity::SeriesRightSide, Quantity::SeriesSolution, Quantity::SeriesFinish];
        let operations = of_order.map(|quantity| self.kernels[&quantity].count()).into_iter().sum();
        Ok((self.kernels[&Quantity::SeriesBegin].n(Entries::Products), operations))
    }

    /// The coordinates that accelerations, or rates of states, depend on; none in a scene without an elimination.
    pub fn feedback(&self) -> Option<Vec<usize>> {
        let [pass] = &self.kernels.get(&Quantity::Accelerations)?.passes[..] else { return None };
        let of_rates = self.kernels.get(&Quantity::StateRates).into_iter().flat_map(|kernel| &kernel.passes);
        let inputs = std::iter::once(pass).chain(of_rates).flat_map(|pass| pass.program.inputs());
        let mut coordinates: Vec<usize> = inputs.filter_map(|symbol| self.symbols().coordinate_of(symbol)).collect();
        coordinates.sort_unstable();
        coordinates.dedup();
        Some(coordinates)
    }

    /// The equations in quasi-velocities, where they were derived.
    pub fn quasi(&self) -> Option<&QuasiVelocities> {
        match &self.form {
            Form::Straight(of) => of.quasi.as_ref(),
            Form::Counted(_) => None,
        }
    }

    pub fn algebra(&self) -> &Algebra {
        match &self.form {
            Form::Straight(of) => &of.equations.algebra,
            Form::Counted(of) => &of.templates.algebra,
        }
    }

    pub fn symbols(&self) -> &Symbols {
        match &self.form {
            Form::Straight(of) => &of.equations.symbols,
            Form::Counted(of) => &of.templates.symbols,
        }
    }

    pub fn parameters(&self) -> &[ParameterId] {
        match &self.form {
            Form::Straight(of) => &of.equations.parameters,
            Form::Counted(of) => &of.templates.parameters,
        }
    }

    /// What says how a row takes part that is switched on and off.
    pub fn switches(&self) -> &[DeclaredSwitch] {
        match &self.form {
            Form::Straight(of) => of.equations.symbols.switches(),
            Form::Counted(_) => &[],
        }
    }

    /// Inputs, then first-order states.
    pub fn inputs(&self) -> &[InputId] {
        match &self.form {
            Form::Straight(of) => &of.equations.inputs,
            Form::Counted(of) => &of.templates.inputs,
        }
    }

    /// Length of the vector that kernels read: inputs, first-order states, then constants.
    pub fn n_fixed(&self) -> usize {
        self.inputs().len() + self.constants.coefficients().len()
    }
}
