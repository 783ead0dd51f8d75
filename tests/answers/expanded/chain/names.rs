/// Bodies, inputs and outputs as fields.
#[allow(dead_code)]
pub mod names {
    use super::ezy;
    ///Bodies of `Chain`.
    #[derive(Debug, Clone, Copy)]
    pub struct Bodies<'a> {
        ///Position and velocity of `link`.
        pub link: ezy::BodyArray<'a, 1>,
    }
    ///Outputs of scenes `swing`, `settle`.
    #[derive(Debug, Clone, Copy)]
    pub struct SwingOutputs {
        ///How low the tip is, as part of the whole length (1).
        pub sag: f64,
    }
}
