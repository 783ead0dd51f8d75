//! What the code calls that `model!` emits. No part of the interface: it changes with the macro.

pub use crate::__faulty_model as faulty_model;
pub use crate::kernel::{array, array_mut, row, row_mut, sign};
pub use crate::layout::{Bodies, Known, Layout, member};
pub use crate::model::equations::PreciseScene;
pub use crate::model::pivots::{PIVOT_TOLERANCE, Pivots};
pub use crate::model::repeats::{Repeats, RowTemplate, SlotCoordinate, TemplateInfo};
pub use crate::model::series::{PRODUCT_GROUP, Series, SeriesSize, SeriesStore};
pub use crate::model::{
    Abbreviation, CoordinateInfo, CountInfo, Derived, Direction, EffectInfo, ElementInfo, EliminationStep, Equation,
    Equations, EventInfo, EventKind, Formula, InputInfo, JacobianPlaces, List, LoadKind, LocalVector, ModelInfo, Name,
    Operations, OutputInfo, ParameterInfo, PointInfo, RowInfo, Scene, SceneEntry, SceneInfo, SeriesInfo,
    SparsityPattern, Start, StickSlipInfo, StopInfo,
};
pub use crate::scalar::Scalar;
pub use ezy_derive::model as derive_model;
