//! What generated kernels call.

/// A slice as an array of `N` numbers, so that a kernel checks the length once.
///
/// # Panics
/// When the slice has another length.
#[inline(always)]
pub fn array<const N: usize, T>(x: &[T]) -> &[T; N] {
    match x.try_into() {
        Ok(array) => array,
        Err(_) => wrong_length(N, x.len()),
    }
}

/// A mutable slice as an array of `N` numbers.
///
/// # Panics
/// When the slice has another length.
#[inline(always)]
pub fn array_mut<const N: usize, T>(x: &mut [T]) -> &mut [T; N] {
    let length = x.len();
    match x.try_into() {
        Ok(array) => array,
        Err(_) => wrong_length(N, length),
    }
}

/// Sign of a number: −1, 0 or 1; not a number stays so.
#[inline]
pub fn sign(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { x.signum() }
}

/// Row `i` of an array whose rows have `N` numbers.
///
/// # Panics
/// When there is no such row.
#[inline(always)]
pub fn row<const N: usize, T>(x: &[T], i: usize) -> &[T; N] {
    array(&x[i * N..(i + 1) * N])
}

/// Row `i` of an array whose rows have `N` numbers, to be written.
///
/// # Panics
/// When there is no such row.
#[inline(always)]
pub fn row_mut<const N: usize, T>(x: &mut [T], i: usize) -> &mut [T; N] {
    array_mut(&mut x[i * N..(i + 1) * N])
}

#[cold]
#[inline(never)]
fn wrong_length(expected: usize, found: usize) -> ! {
    panic!("a kernel was given {found} numbers where the scene has {expected}; see ezy_core::model for the shapes")
}
