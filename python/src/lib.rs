//! Models of EZY as Python modules.
//!
//! A crate of type `cdylib` with a model calls [`add_models`] in its `#[pymodule]`. In Python each scene is then a class whose arguments are its
//! parameters:
//!
//! ```python
//! import ezy
//! run = ezy.ezyroller.driven(m0=3).run(rtol=1e-10, every=0.01)
//! run["bar.phi"]          # a NumPy array
//! ```

mod analysis;
mod batch;
mod environment;
mod error;
mod inputs;
mod model;
mod motion;
mod notebook;
mod run;
mod scene;
mod sensitivities;
mod signals;
mod stepper;
mod stub;
mod sweep;

pub use error::{EzyError, StoppedError};

use ezy_core::model::ModelInfo;
use model::Model;
use pyo3::prelude::*;
use pyo3::types::{PyCFunction, PyDict, PyTuple};

/// Adds models to a module: of one model its scenes, of several the models by their names in lower case; beside them the classes and exceptions.
///
/// # Errors
/// Those of Python.
pub fn add_models(module: &Bound<'_, PyModule>, models: &[&'static ModelInfo]) -> PyResult<()> {
    let py = module.py();
    for model in models {
        let model = Model::new(model);
        match models {
            [_] => {
                for name in model.names() {
                    module.add(name, model.scene(name)?)?;
                }
            }
            _ => module.add(model.module_name().as_str(), model)?,
        }
    }
    module.add_class::<Model>()?;
    module.add_class::<model::SceneType>()?;
    module.add_class::<scene::PyScene>()?;
    module.add_class::<run::PyRun>()?;
    module.add_class::<sensitivities::PySensitivities>()?;
    module.add_class::<stepper::PyStepper>()?;
    module.add_class::<stepper::PyCheckpoint>()?;
    module.add_class::<batch::PyBatch>()?;
    module.add_class::<analysis::PyEquilibrium>()?;
    module.add_class::<analysis::PyLinearization>()?;
    module.add_class::<notebook::PySketch>()?;
    module.add_class::<notebook::PyAnimation>()?;
    module.add("EzyError", py.get_type::<EzyError>())?;
    module.add("StoppedError", py.get_type::<StoppedError>())?;
    add_functions(module, models)
}

/// What a module does besides its classes: `type_stub`, and names that are made, or missed, when they are asked for.
fn add_functions(module: &Bound<'_, PyModule>, models: &[&'static ModelInfo]) -> PyResult<()> {
    let py = module.py();
    let known = models.to_vec();
    let type_stub = move |_: &Bound<'_, PyTuple>, _: Option<&Bound<'_, PyDict>>| stub::text(&known);
    let doc = c"The types of this module as the text of its `.pyi` file.";
    module.add("type_stub", PyCFunction::new_closure(py, Some(c"type_stub"), Some(doc), type_stub)?)?;

    let package = module.name()?.to_string();
    let package = package.split('.').next().unwrap_or_default().to_owned();
    let names: Vec<String> = module.index()?.extract()?;
    let missing = move |arguments: &Bound<'_, PyTuple>, _: Option<&Bound<'_, PyDict>>| {
        let name: String = arguments.get_item(0)?.extract()?;
        environment::attribute(arguments.py(), &package, &name, &names)
    };
    let doc = c"Makes `Environment` and `VectorEnvironment` when they are asked for: they need Gymnasium.";
    module.add("__getattr__", PyCFunction::new_closure(py, Some(c"__getattr__"), Some(doc), missing)?)
}
