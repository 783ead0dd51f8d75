//! Placeholder for a model with errors, so that uses of the model give no further errors.

/// The module of a model with faults: its scenes with their fields, and a `MODEL` without scenes. The compiler stops at
/// the faults, so nothing of this ever runs.
#[doc(hidden)]
#[macro_export]
macro_rules! __faulty_model {
    ($visibility:vis mod $module:ident { $($scene:ident { $($field:ident: $kind:ty),* })* }) => {
        #[allow(missing_docs, non_snake_case, dead_code, unused_variables, unreachable_code, unreachable_pub, clippy::all)]
        $visibility mod $module {
            pub static MODEL: $crate::__private::ModelInfo = $crate::__private::ModelInfo {
                name: ::core::stringify!($module),
                documentation: "",
                effects: &[],
                scenes: &[],
            };
            $(
                #[derive(Debug, Clone, Copy, PartialEq, Default)]
                pub struct $scene {
                    $(pub $field: $kind),*
                }

                impl $scene {
                    pub const INFO: $crate::__private::SceneInfo = ::core::panic!("this model has errors");
                }

                impl<T: $crate::__private::Scalar> $crate::__private::Equations<T> for $scene {
                    fn constants(&self, parameters: &[T], c: &mut [T]) {}
                    fn mass_matrix(&self, c: &[T], m: &mut [T]) {}
                    fn position_constraint(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {}
                    fn velocity_constraint(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {}
                    fn velocity_jacobian(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {}
                    fn convective_term(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {}
                    fn applied_force(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {}
                }

                impl $crate::__private::Derived for $scene {}

                impl $crate::__private::Scene for $scene {
                    fn info(&self) -> ::std::sync::Arc<$crate::__private::SceneInfo> {
                        ::core::unreachable!()
                    }
                    fn parameter(&self, index: usize) -> f64 {
                        f64::NAN
                    }
                    fn set_parameter(&mut self, index: usize, value: f64) {}
                    fn start(&self, c: &[f64], start: &mut $crate::__private::Start) {}
                    fn power(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], lambda: &[f64], out: &mut [f64]) {}
                    fn potential_energy(&self, c: &[f64], t: f64, q: &[f64]) -> f64 {
                        f64::NAN
                    }
                    fn points(&self, c: &[f64], t: f64, q: &[f64], out: &mut [f64]) {}
                    fn outputs(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {}
                }
            )*
        }
    };
}

#[cfg(test)]
mod tests {
    use crate::model::Scene;

    crate::__faulty_model! { mod trial { Driven { a: f64, n: usize } Coast {} } }

    #[test]
    fn analytic_faulty_model_has_the_types_that_programs_name() {
        fn as_scene(_: &impl Scene) {}
        let mut driven = trial::Driven { n: 3, ..Default::default() };
        driven.a = 2.0;
        as_scene(&driven);
        as_scene(&trial::Coast::default());
        assert!(trial::MODEL.scenes.is_empty());
    }
}
