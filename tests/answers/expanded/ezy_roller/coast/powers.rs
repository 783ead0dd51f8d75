#[automatically_derived]
impl<T: ezy::Scalar> ezy::Powers<T> for Coast {
    #[inline(always)]
    fn powers(&self, c: &[T], t: T, q: &[T], v: &[T], lambda: &[T], out: &mut [T]) {
        let c = ezy::array::<46usize, T>(c);
        let q = ezy::array::<6usize, T>(q);
        let v = ezy::array::<6usize, T>(v);
        let lambda = ezy::array::<4usize, T>(lambda);
        let out = ezy::array_mut::<0usize, T>(out);
    }
}
