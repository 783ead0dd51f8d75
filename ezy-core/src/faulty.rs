//! Placeholder for a model with errors, so that uses of the model give no further errors.

/// The module of a model with faults: its scenes with their fields, and a `MODEL` without scenes. The compiler stops at
/// the faults, so nothing of this ever runs.
#[doc(hidden)]
#[macro_export]
macro_rules! __faulty_model {
    (
        $visibility:vis mod $module:ident { $($scene:ident { $($field:ident: $kind:ty),* })* }
        names
        { $($body:ident: $of_body:ty),* }
        { $($input:ident: $of_input:ty),* }
        { $($output:ident: $of_output:ty),* }
        events { $($event:ident;)* } { $($stop:ident { $($change:ident;)* })* }
    ) => {
        #[allow(missing_docs, non_snake_case, non_upper_case_globals, dead_code, unused_variables, unreachable_code, unreachable_pub, clippy::all)]
        $visibility mod $module {
            pub mod names {
                use $crate::__private as ezy;

                pub struct Bodies { $(pub $body: $of_body),* }
                pub struct Inputs { $(pub $input: $of_input),* }
                pub struct Outputs { $(pub $output: $of_output),* }

                impl ezy::NamedInputs for Inputs {
                    fn read(values: &[f64]) -> Self {
                        ::core::unreachable!()
                    }
                    fn write(&self, values: &mut [f64]) {}
                }
            }
            pub mod events {
                $(pub const $event: &::core::primitive::str = ::core::stringify!($event);)*
                $(pub mod $stop {
                    $(pub const $change: &::core::primitive::str = ::core::stringify!($stop $change);)*
                })*
            }
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
                }

                impl $crate::__private::NamedScene for $scene {
                    type Bodies<'a> = names::Bodies;
                    type Inputs = names::Inputs;
                    type Outputs<'a> = names::Outputs;
                    fn bodies_by_name<'a>(&self, q: &'a [f64], v: &'a [f64]) -> names::Bodies {
                        ::core::unreachable!()
                    }
                    fn outputs_by_name<'a>(&self, values: &'a [f64]) -> names::Outputs {
                        ::core::unreachable!()
                    }
                }
            )*
        }
    };
}

#[cfg(test)]
mod tests {
    use crate::model::Scene;
    use crate::simulate::Simulation;

    crate::__faulty_model! {
        mod trial { Driven { a: f64, n: usize } Coast {} }
        names { seat: ezy::BodyState } { torque: f64 } { wheel: ezy::Vector<f64>, speed: f64 }
        events { landing; } { floor { hits; } }
    }

    #[test]
    fn analytic_faulty_model_has_the_types_that_programs_name() {
        fn as_scene(_: &impl Scene) {}
        let mut driven = trial::Driven { n: 3, ..Default::default() };
        driven.a = 2.0;
        as_scene(&driven);
        as_scene(&trial::Coast::default());
        assert!(trial::MODEL.scenes.is_empty());
        let _program = |scene: &trial::Driven| {
            let _ = Simulation::new(scene).control(|now, set| set.torque = now.seat.phi + now.outputs().wheel.x);
        };
        assert_eq!((trial::events::landing, trial::events::floor::hits), ("landing", "floor hits"));
    }
}
