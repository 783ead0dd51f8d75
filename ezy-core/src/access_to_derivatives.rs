//! What emitted code calls to hand out its kernels on numbers with derivatives.

/// The method of a scene that hands out its kernels on numbers with derivatives, within its `impl Derived`.
#[cfg(feature = "analysis")]
#[doc(hidden)]
#[macro_export]
macro_rules! __access_to_derivatives {
    () => {
        fn with_derivatives(&self) -> ::core::option::Option<&dyn $crate::__private::EquationsWithDerivatives> {
            ::core::option::Option::Some(self)
        }
    };
}

/// Without the feature `analysis` nothing, so that no scene is compiled on these numbers.
#[cfg(not(feature = "analysis"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __access_to_derivatives {
    () => {};
}

#[cfg(all(test, not(feature = "analysis")))]
mod tests {
    struct Empty;

    impl Empty {
        crate::__access_to_derivatives! {}
    }

    /// What is called where `Empty` has no method of that name.
    trait Absent {
        fn with_derivatives(&self) -> &str {
            "absent"
        }
    }

    impl Absent for Empty {}

    #[test]
    fn invariant_without_the_feature_no_scene_hands_out_derivatives() {
        assert_eq!(Empty.with_derivatives(), "absent");
    }
}
