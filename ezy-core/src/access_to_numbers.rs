//! What emitted code calls to hand out its kernels on other numbers than those of a run.

/// The methods of a scene that hand out its kernels on other numbers, within its `impl Derived`.
#[doc(hidden)]
#[macro_export]
macro_rules! __access_to_numbers {
    () => {
        $crate::__private::access_to_derivatives! {}
        $crate::__private::access_to_recorded! {}
    };
}

/// Numbers with derivatives.
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

/// Numbers that record what is computed.
#[cfg(feature = "export")]
#[doc(hidden)]
#[macro_export]
macro_rules! __access_to_recorded {
    () => {
        fn recorded(&self) -> ::core::option::Option<&dyn $crate::__private::Equations<$crate::__private::Recorded>> {
            ::core::option::Option::Some(self)
        }
    };
}

/// Without the feature `export` nothing.
#[cfg(not(feature = "export"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __access_to_recorded {
    () => {};
}

#[cfg(all(test, not(any(feature = "analysis", feature = "export"))))]
mod tests {
    struct Empty;

    impl Empty {
        crate::__access_to_numbers! {}
    }

    /// What is called where `Empty` has no method of that name.
    trait Absent {
        fn with_derivatives(&self) -> &str {
            "absent"
        }

        fn recorded(&self) -> &str {
            "absent"
        }
    }

    impl Absent for Empty {}

    #[test]
    fn invariant_without_the_features_no_scene_hands_out_other_numbers() {
        assert_eq!([Empty.with_derivatives(), Empty.recorded()], ["absent"; 2]);
    }
}
