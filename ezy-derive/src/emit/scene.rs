//! The type of a scene: its parameters as fields, its equations as methods.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::abbreviations::Abbreviations;
use super::constants::Constants;
use super::kernel::Vocabulary;
use super::passes::Method;
use super::places::Lengths;
use super::signature::{self, Trait};
use super::type_names::scene_type;
use super::{elements, info, jacobians, page, repeated, series};
use crate::mechanics::Derived;
use crate::mechanics::derived::{Form, Straight};
use crate::mechanics::kernels::{Kernel, Quantity};
use crate::mechanics::quasi::QuasiVelocities;
use crate::model::{Model, Parameter, Scene};

/// The struct, its defaults and its equations.
pub fn items(model: &Model, derived: &Derived<'_>) -> TokenStream {
    let type_name = scene_type(&derived.scene);
    let constants = Constants::new(model, derived);
    let Described { inherent, access, page } = describe(model, derived, &constants, &type_name);
    let places_of_members = constants.places_of_members();
    let access_to_counts = model.is_repeated().then(|| repeated::access_to_counts(model));
    let structure = structure(model, derived, &type_name, &page);
    let vocabulary = Vocabulary { symbols: derived.symbols(), constants: &constants, outputs_early: false };
    let methods = |vocabulary, of| methods(model, derived, vocabulary, of);
    let [equations, of_derived, of_scene] =
        [Trait::Equations, Trait::Derived, Trait::Scene].map(|of| methods(vocabulary, of));
    let powers = derived.kernels.get(&Quantity::Power).zip(straight_with_elimination(derived)).map(|(kernel, of)| {
        let method = Method { model, vocabulary, signature: &signature::POWERS, kernel };
        let of_powers = signature::POWERS.method(method.straight(&Lengths::new(derived, of)), true);
        quote! {
            #[automatically_derived]
            impl<T: ezy::Scalar> ezy::Powers<T> for #type_name {
                #of_powers
            }
        }
    });
    let of_quasi = methods(vocabulary, Trait::QuasiVelocities);
    let quasi = derived.quasi().map(|of| {
        let lengths = quasi_lengths(of);
        quote! {
            #[automatically_derived]
            impl ezy::QuasiShape for #type_name {
                #lengths
            }

            #[automatically_derived]
            impl<T: ezy::Scalar> ezy::QuasiVelocities<T> for #type_name {
                #of_quasi
            }
        }
    });
    let access_to_quasi = quasi.is_some().then(access_to_quasi);
    let of_series = methods(Vocabulary { outputs_early: true, ..vocabulary }, Trait::Series);
    let series = series::implementation(&type_name, model, derived, &of_series);
    let constants = constants.method();
    let parameters: Vec<&Ident> = derived.parameters().iter().map(|id| &model.parameters[id.0].name).collect();
    let (parameter, set_parameter) = parameter_access(&parameters);
    let elements = (!derived.elements.is_empty()).then(|| elements::method(model, derived));
    let force_elements = (!derived.force_elements.is_empty()).then(|| elements::force_elements(model, derived));
    let in_lanes = straight_with_elimination(derived).map(|_| access_in_lanes());
    let access_to_series = series.is_some().then(access_to_series);
    quote! {
        #structure

        impl #type_name {
            #inherent
            #places_of_members
        }

        #[automatically_derived]
        impl<T: ezy::Scalar> ezy::Equations<T> for self::#type_name {
            #constants
            #equations
        }

        #[automatically_derived]
        impl ezy::Derived for #type_name {
            #access_to_counts
            #of_derived
            #elements
            #force_elements
            #in_lanes
            #access_to_quasi
            ezy::access_to_numbers! {}
            #access_to_series
        }

        #[automatically_derived]
        impl ezy::Scene for #type_name {
            #access
            fn parameter(&self, index: usize) -> f64 {
                #parameter
            }
            fn set_parameter(&mut self, index: usize, value: f64) {
                #set_parameter
            }
            #of_scene
        }

        #powers
        #quasi
        #series
    }
}

/// What a scene says of itself.
struct Described {
    /// Constants and functions of its type.
    inherent: TokenStream,
    /// The methods that hand them out.
    access: TokenStream,
    page: TokenStream,
}

fn describe(model: &Model, derived: &Derived<'_>, constants: &Constants<'_>, type_name: &Ident) -> Described {
    match &derived.form {
        Form::Straight(of) => {
            let names = &Abbreviations::new(&of.equations);
            let info = info::scene(model, derived, of, names);
            Described {
                inherent: quote! {
                    /// What is known of the scene when it is compiled.
                    pub const INFO: ezy::SceneInfo = #info;
                },
                access: quote! {
                    fn info(&self) -> ::std::sync::Arc<ezy::SceneInfo> {
                        static INFO: ::std::sync::LazyLock<::std::sync::Arc<ezy::SceneInfo>> =
                            ::std::sync::LazyLock::new(|| ::std::sync::Arc::new(#type_name::INFO));
                        ::std::sync::Arc::clone(&INFO)
                    }
                },
                page: page::scene(model, derived, of, names),
            }
        }
        Form::Counted(of) => Described {
            inherent: repeated::description(model, derived, of, constants),
            access: repeated::access(model),
            page: page::repeated(model, &of.templates),
        },
    }
}

/// Of a scene whose kernels run in lanes.
fn straight_with_elimination<'d>(derived: &'d Derived<'_>) -> Option<&'d Straight> {
    match &derived.form {
        Form::Straight(of) if derived.kernels.contains_key(&Quantity::Accelerations) => Some(of),
        _ => None,
    }
}

/// The methods of a trait that compute.
fn methods(model: &Model, derived: &Derived<'_>, vocabulary: Vocabulary<'_>, of: Trait) -> TokenStream {
    let of_trait = signature::ALL.iter().filter(|signature| signature.of == of);
    let kernels = of_trait.filter_map(|signature| Some((signature, derived.kernels.get(&signature.quantity)?)));
    let mut takes_sines = false;
    let methods: TokenStream = kernels
        .map(|(signature, kernel)| {
            let method = Method { model, vocabulary, signature, kernel };
            let body = match &derived.form {
                Form::Straight(_)
                    if signature.quantity == Quantity::Power && straight_with_elimination(derived).is_some() =>
                {
                    quote!(ezy::Powers::powers(self, c, t, q, v, lambda, out);)
                }
                Form::Straight(of) => method.straight(&Lengths::new(derived, of)),
                Form::Counted(_) if method.reads_sines() => {
                    takes_sines = true;
                    return signature.methods_with_sines(&method.looped());
                }
                Form::Counted(_) => method.looped(),
            };
            let places = match signature.quantity {
                Quantity::Jacobians => Some(jacobian_places(model, derived)),
                Quantity::StateJacobians => Some(state_jacobian_places(model, derived)),
                _ => None,
            };
            let method = signature.method(body, matches!(derived.form, Form::Straight(_)));
            quote!(#places #method)
        })
        .collect();
    let takes_sines = takes_sines.then(|| {
        quote!(
            fn takes_sines(&self) -> bool {
                true
            }
        )
    });
    quote!(#methods #takes_sines)
}

/// The method that says which Jacobians there are.
fn jacobian_places(model: &Model, derived: &Derived<'_>) -> TokenStream {
    let places = match &derived.form {
        Form::Straight(of) => of.jacobians.as_ref().map(jacobians::places),
        Form::Counted(of) => {
            let items = of.jacobians.as_ref();
            items.map(|items| jacobians::places_of_items(model, &of.templates, items))
        }
    };
    quote! {
        fn jacobian_places(&self) -> ::core::option::Option<ezy::JacobianPlaces> {
            #places
        }
    }
}

/// The method that says where those by first-order states are.
fn state_jacobian_places(model: &Model, derived: &Derived<'_>) -> TokenStream {
    let places = match &derived.form {
        Form::Straight(of) => of.jacobians.as_ref().map(jacobians::places_by_states),
        Form::Counted(of) => {
            let items = of.jacobians.as_ref();
            items.map(|items| jacobians::places_by_states_of_items(model, &of.templates, items))
        }
    };
    quote! {
        fn state_jacobian_places(&self) -> ::std::vec::Vec<(usize, usize)> {
            #places
        }
    }
}

/// The method that hands out the kernels at several states at once.
fn access_in_lanes() -> TokenStream {
    quote! {
        fn in_lanes(&self) -> ::core::option::Option<&dyn ezy::EquationsInLanes> {
            ::core::option::Option::Some(self)
        }
    }
}

/// How many quasi-velocities there are, and the coordinates that they depend on.
fn quasi_lengths(of: &QuasiVelocities) -> TokenStream {
    let (n, feedback, integrated, n_read) = (of.symbols.len(), &of.feedback, &of.integrated, of.n_read);
    let integrals = of.integrals.iter().map(|(i, k)| quote!((#i, #k)));
    let n_angles = of.angles.outputs().len();
    quote! {
        const N_QUASI: usize = #n;
        const FEEDBACK: &'static [usize] = &[#(#feedback),*];
        const INTEGRALS: &'static [(usize, usize)] = &[#(#integrals),*];
        const INTEGRATED: &'static [usize] = &[#(#integrated),*];
        const N_READ: usize = #n_read;
        const N_ANGLES: usize = #n_angles;
    }
}

/// The method that hands out the equations in quasi-velocities.
fn access_to_quasi() -> TokenStream {
    quote! {
        fn in_quasi_velocities(&self) -> ::core::option::Option<&dyn ezy::EquationsInQuasiVelocities> {
            ::core::option::Option::Some(self)
        }
    }
}

/// The methods that hand out the series.
fn access_to_series() -> TokenStream {
    quote! {
        fn series(&self) -> ::core::option::Option<&dyn ezy::Series<f64>> {
            ::core::option::Option::Some(self)
        }

        fn precise(&self) -> ::core::option::Option<&dyn ezy::PreciseScene> {
            ::core::option::Option::Some(self)
        }
    }
}

fn structure(model: &Model, derived: &Derived<'_>, type_name: &Ident, page: &TokenStream) -> TokenStream {
    let title = title(model, &derived.scene);
    let cost = matches!(derived.form, Form::Straight(_)).then(|| {
        let count = derived.kernels.get(&Quantity::Accelerations).map(Kernel::count);
        let cost = count.map_or(page::SOLVED_SPARSE.to_owned(), |count| {
            format!(
                "Cost of the accelerations and multipliers: {} mul, {} add, {} div, {} sin–cos.",
                count.mul, count.add, count.div, count.trig
            )
        });
        quote!(#[doc = #cost])
    });
    let parameters: Vec<_> = derived.parameters().iter().map(|id| &model.parameters[id.0]).collect();
    let counts = model.counts.iter().map(|count| {
        let name = &count.name;
        let documentation = match count.documentation.trim() {
            "" => format!("Count `{name}`; default {}.", count.default),
            text => format!("{text}; default {}.", count.default),
        };
        quote!(#[doc = #documentation] pub #name: usize)
    });
    let fields = counts.chain(parameters.iter().map(|parameter| field(parameter)));
    let count_defaults = model.counts.iter().map(|count| {
        let (name, value) = (&count.name, Literal::usize_unsuffixed(usize::try_from(count.default).unwrap_or(1)));
        quote!(#name: #value)
    });
    let defaults = parameters.iter().map(|parameter| {
        let (name, value) = (&parameter.name, parameter.default);
        quote!(#name: #value)
    });
    let defaults = count_defaults.chain(defaults);
    quote! {
        #[doc = #title]
        #[doc = ""]
        #cost
        #page
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub struct #type_name {
            #(#fields),*
        }

        impl ::core::default::Default for #type_name {
            fn default() -> Self {
                Self { #(#defaults),* }
            }
        }
    }
}

/// The first line of the documentation of a scene.
fn title(model: &Model, scene: &Scene) -> String {
    if scene.documentation.trim().is_empty() {
        format!("Scene `{}` of `{}`.", scene.name, model.name)
    } else {
        scene.documentation.clone()
    }
}

/// The field of a parameter.
fn field(parameter: &Parameter) -> TokenStream {
    let name = &parameter.name;
    let unit = if parameter.unit.is_empty() { "1" } else { &parameter.unit };
    let title = match parameter.documentation.trim() {
        "" => format!("Parameter `{name}`"),
        text => text.to_owned(),
    };
    let documentation = format!("{title} ({unit}); default `{}`.", parameter.default_text);
    quote!(#[doc = #documentation] pub #name: f64)
}

/// Bodies of `parameter` and `set_parameter`.
fn parameter_access(names: &[&Ident]) -> (TokenStream, TokenStream) {
    let indices: Vec<usize> = (0..names.len()).collect();
    (
        quote!(match index { #(#indices => self.#names,)* _ => f64::NAN }),
        quote!(match index { #(#indices => self.#names = value,)* _ => {} }),
    )
}
