//! What the code calls that `model!` emits. No part of the interface: it changes with the macro.

pub use crate::__access_to_derivatives as access_to_derivatives;
pub use crate::__access_to_numbers as access_to_numbers;
pub use crate::__access_to_recorded as access_to_recorded;
pub use crate::__faulty_model as faulty_model;
pub use crate::kernel::{array, array_mut, row, row_mut, sign};
pub use crate::layout::{Bodies, Known, Layout, member};
pub use crate::model::coordinate::sines;
pub use crate::model::equations::{Powers, PreciseScene};
pub use crate::model::in_lanes::EquationsInLanes;
pub use crate::model::named_bodies::BodyReader;
pub use crate::model::named_outputs::OutputReader;
pub use crate::model::pivots::{PIVOT_TOLERANCE, Pivots};
pub use crate::model::quasi_in_lanes::EquationsInQuasiVelocities;
pub use crate::model::quasi_velocities::QuasiShape;
pub use crate::model::repeats::{Repeats, RowTemplate, SlotCoordinate, TemplateInfo};
pub use crate::model::series::{PRODUCT_GROUP, Series, SeriesSize, SeriesStore};
#[cfg(feature = "analysis")]
pub use crate::model::with_derivatives::EquationsWithDerivatives;
pub use crate::model::{
    Abbreviation, BodyArray, BodyState, CoordinateInfo, CountInfo, Derived, Direction, EffectInfo, ElementInfo,
    EliminationStep, Equation, Equations, EventInfo, EventKind, ForceElement, Formula, InputInfo, JacobianPlaces, List,
    LoadKind, LocalVector, ModelInfo, Name, NamedInputs, NamedScene, NoInputs, NoOutputs, Operations, OutputArray,
    OutputInfo, ParameterInfo, PointInfo, QuasiVelocities, QuasiVelocitiesInfo, RowInfo, Scene, SceneEntry, SceneInfo,
    SeriesInfo, SparsityPattern, Start, StateInfo, StickSlipInfo, StopInfo, SwitchInfo, Vector,
};
#[cfg(feature = "export")]
pub use crate::scalar::Recorded;
pub use crate::scalar::Scalar;
pub use ezy_derive::model as derive_model;
