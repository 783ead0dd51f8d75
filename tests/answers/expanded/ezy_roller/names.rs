/// Bodies, inputs and outputs as fields.
#[allow(dead_code)]
pub mod names {
    use super::ezy;
    ///Bodies of `EzyRoller`.
    #[derive(Debug, Clone, Copy)]
    pub struct Bodies {
        ///Position and velocity of `seat`.
        pub seat: ezy::BodyState,
        ///Position and velocity of `bar`.
        pub bar: ezy::BodyState,
    }
    ///Inputs of scene `ridden`.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct RiddenInputs {
        ///torque that opens the hinge (N*m).
        pub torque: f64,
    }
    impl ezy::NamedInputs for RiddenInputs {
        fn read(values: &[f64]) -> Self {
            let values = ezy::array::<1, f64>(values);
            Self { torque: values[0] }
        }
        fn write(&self, values: &mut [f64]) {
            *ezy::array_mut::<1, f64>(values) = [self.torque];
        }
    }
    ///Outputs of scene `ridden`.
    #[derive(Debug, Clone, Copy)]
    pub struct RiddenOutputs {
        ///how far the bar is turned against the seat (deg).
        pub steering: f64,
        ///Output `speed` (m/s).
        pub speed: f64,
    }
}
/// Names of events, to compare with those of a run.
#[allow(non_upper_case_globals, dead_code)]
pub mod events {
    ///Changes of `rear_on_ice`.
    pub mod rear_on_ice {
        ///`rear_on_ice slides`
        pub const slides: &::core::primitive::str = "rear_on_ice slides";
        ///`rear_on_ice stops`
        pub const stops: &::core::primitive::str = "rear_on_ice stops";
    }
}
