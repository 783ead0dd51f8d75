#[automatically_derived]
impl ezy::QuasiShape for Coast {
    const N_QUASI: usize = 2usize;
    const FEEDBACK: &'static [usize] = &[5usize];
    const INTEGRALS: &'static [(usize, usize)] = &[(2usize, 1usize)];
    const INTEGRATED: &'static [usize] = &[2usize, 5usize, 0usize, 1usize];
    const N_READ: usize = 2usize;
    const N_ANGLES: usize = 1usize;
}
