//! Vector instructions of the machine at hand, in a build for any machine of its kind.

use pulp::{Arch, NullaryFnOnce};

/// What `f` returns, compiled for the widest vector registers of this machine. Only what is inlined into `f` is compiled so: its loops over
/// lanes, and functions that are `#[inline(always)]`.
///
/// No two operations are fused that the base build keeps apart, so that the result has the same bits on every machine.
#[inline(always)]
pub(crate) fn in_widest<F: FnOnce() -> R, R>(f: F) -> R {
    Arch::new().dispatch(Here(f))
}

/// A function that is inlined where it is called.
struct Here<F>(F);

impl<F: FnOnce() -> R, R> NullaryFnOnce for Here<F> {
    type Output = R;

    #[inline(always)]
    fn call(self) -> R {
        self.0()
    }
}
