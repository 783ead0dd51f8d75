//! What the methods that compute are called, read and write: the same for every scene.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{ToTokens, quote};

use super::kernel::Expression;
use super::numbers::Numbers;
use crate::mechanics::kernels::{Ahead, Quantity};

/// The traits of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Trait {
    Equations,
    Derived,
    Scene,
    QuasiVelocities,
    Powers,
    Series,
}

/// A method that computes.
pub struct Signature {
    pub quantity: Quantity,
    pub of: Trait,
    name: &'static str,
    /// Besides the vector of constants.
    pub reads: &'static [&'static str],
    pub writes: Writes,
}

/// What becomes of the outputs.
#[derive(Clone, Copy)]
pub enum Writes {
    /// They fill these vectors.
    Vectors(&'static [&'static str]),
    /// The same, and the method returns what its pivots are.
    Solution(&'static [&'static str]),
    /// The method returns their sum.
    Value,
    /// They are given to a `Start`.
    Start,
    /// They go to the storage of a series.
    Store(Order),
}

impl Writes {
    /// The vectors that are filled.
    pub fn vectors(self) -> &'static [&'static str] {
        match self {
            Self::Vectors(names) | Self::Solution(names) => names,
            Self::Value | Self::Start | Self::Store(_) => &[],
        }
    }
}

/// The order that a kernel of a series is for.
#[derive(Clone, Copy)]
pub enum Order {
    /// None: at the start of a step, what is one order ahead is of order 0.
    Start,
    /// k, an argument.
    Present,
}

impl Order {
    /// The order that is so far ahead.
    pub fn ahead(self, ahead: Ahead) -> Expression {
        match self {
            Self::Start => Expression::atom(Literal::usize_unsuffixed(ahead.saturating_sub(1)).into_token_stream()),
            Self::Present => {
                let ahead = Literal::usize_unsuffixed(ahead);
                Expression::sum(quote!(k + #ahead))
            }
        }
    }
}

const OUT: Writes = Writes::Vectors(&["out"]);

/// Every method, in the order in which they are emitted.
pub const ALL: [Signature; 34] = [
    any(Quantity::MassMatrix, "mass_matrix", &[], OUT),
    any(Quantity::PositionConstraint, "position_constraint", &["t", "q"], OUT),
    any(Quantity::VelocityConstraint, "velocity_constraint", &["t", "q", "v"], OUT),
    any(Quantity::VelocityJacobian, "velocity_jacobian", &["t", "q"], OUT),
    any(Quantity::ConvectiveTerm, "convective_term", &["t", "q", "v"], OUT),
    any(Quantity::AppliedForce, "applied_force", &["t", "q", "v"], OUT),
    any(Quantity::StateRates, "state_rates", &["t", "q", "v"], OUT),
    any(Quantity::Outputs, "outputs", &["t", "q", "v"], OUT),
    any(Quantity::Events, "events", &["t", "q", "v"], OUT),
    any(Quantity::Accelerations, "accelerations", &["t", "q", "v"], Writes::Solution(&["a", "lambda"])),
    any(Quantity::Correction, "correction", &["t", "q", "residual"], Writes::Solution(&["delta"])),
    derived(Quantity::ProjectedAccelerations, "projected_accelerations", &["t", "q", "v"], Writes::Solution(&["out"])),
    scene(Quantity::Power, "power", &["t", "q", "v", "lambda"], OUT),
    scene(Quantity::Points, "points", &["t", "q"], OUT),
    derived(Quantity::LimitedSkates, "limited_skates", &["t", "q", "v"], OUT),
    derived(Quantity::Stop, "stop", &["t", "q", "v"], OUT),
    scene(Quantity::PotentialEnergy, "potential_energy", &["t", "q"], Writes::Value),
    scene(Quantity::Start, "start", &[], Writes::Start),
    derived(Quantity::Jacobians, "jacobians", &["t", "q", "v", "a", "lambda"], Writes::Vectors(&["by_q", "by_v"])),
    derived(Quantity::StateJacobians, "state_jacobians", &["t", "q", "v"], OUT),
    derived(Quantity::Elements, "element_values", &["t", "q", "v"], OUT),
    derived(Quantity::ElementPowers, "element_powers", &["t", "q", "v"], OUT),
    quasi(Quantity::QuasiVelocities, "quasi_velocities", &["q", "v"], Writes::Vectors(&["quasi"])),
    quasi(Quantity::Velocities, "velocities", &["t", "q", "quasi"], Writes::Vectors(&["v"])),
    quasi(Quantity::OfTime, "values_of_time", &["t"], Writes::Vectors(&["of_time"])),
    quasi(
        Quantity::QuasiAccelerations,
        "quasi_accelerations",
        &["t", "q", "quasi", "of_time"],
        Writes::Vectors(&["a", "q_rate", "sines"]),
    ),
    quasi(Quantity::QuasiRates, "rates", &["t", "q", "quasi", "of_time", "sines"], Writes::Vectors(&["q_rate"])),
    quasi(Quantity::QuasiAngles, "angles", &["t", "q", "of_time"], OUT),
    quasi(Quantity::QuasiMotion, "motion", &["t", "q", "quasi"], Writes::Vectors(&["a", "q_rate"])),
    quasi(Quantity::WholeState, "whole_state", &["t", "q", "quasi"], Writes::Vectors(&["out", "v"])),
    series(Quantity::SeriesBegin, "begin", &["t"], Order::Start),
    series(Quantity::SeriesRightSide, "right_side", &["k"], Order::Present),
    series(Quantity::SeriesSolution, "solve", &["k"], Order::Present),
    series(Quantity::SeriesFinish, "finish", &["k"], Order::Present),
];

/// [`Quantity::Power`] for any number, which the method of `Scene` calls: of scenes with a generated elimination, which run in lanes.
pub const POWERS: Signature = Signature {
    quantity: Quantity::Power,
    of: Trait::Powers,
    name: "powers",
    reads: &["t", "q", "v", "lambda"],
    writes: OUT,
};

const fn any(quantity: Quantity, name: &'static str, reads: &'static [&'static str], writes: Writes) -> Signature {
    Signature { quantity, of: Trait::Equations, name, reads, writes }
}

const fn derived(quantity: Quantity, name: &'static str, reads: &'static [&'static str], writes: Writes) -> Signature {
    Signature { quantity, of: Trait::Derived, name, reads, writes }
}

const fn scene(quantity: Quantity, name: &'static str, reads: &'static [&'static str], writes: Writes) -> Signature {
    Signature { quantity, of: Trait::Scene, name, reads, writes }
}

const fn quasi(quantity: Quantity, name: &'static str, reads: &'static [&'static str], writes: Writes) -> Signature {
    Signature { quantity, of: Trait::QuasiVelocities, name, reads, writes }
}

const fn series(quantity: Quantity, name: &'static str, reads: &'static [&'static str], order: Order) -> Signature {
    Signature { quantity, of: Trait::Series, name, reads, writes: Writes::Store(order) }
}

impl Signature {
    /// Equations, in quasi-velocities too, powers and series are written for any number, and so are the projected accelerations, which are made of equations.
    pub const fn numbers(&self) -> Numbers {
        match (self.of, self.quantity) {
            (Trait::Equations | Trait::QuasiVelocities | Trait::Powers | Trait::Series, _)
            | (_, Quantity::ProjectedAccelerations) => Numbers::Any,
            (Trait::Derived | Trait::Scene, _) => Numbers::F64,
        }
    }

    /// Binds `T` to `f64` in methods of `Derived` whose body is written for any number, so that each other type compiles one kernel less.
    fn any_is_f64(&self) -> Option<TokenStream> {
        let is_so = self.of == Trait::Derived && self.numbers() == Numbers::Any;
        is_so.then(|| {
            quote!(
                use ezy::Scalar as _;
                type T = f64;
            )
        })
    }

    /// The method that takes sines and cosines of the angles of all bodies, for what each step of a scene with counts computes.
    pub fn with_sines(&self) -> Option<Ident> {
        use Quantity::{AppliedForce, ConvectiveTerm, PositionConstraint, VelocityConstraint, VelocityJacobian};
        let of_steps = [PositionConstraint, VelocityConstraint, VelocityJacobian, ConvectiveTerm, AppliedForce];
        of_steps.contains(&self.quantity).then(|| argument(&format!("{}_with_sines", self.name)))
    }

    /// Both methods of a kernel that reads such sines: it takes them, or has them computed.
    pub fn methods_with_sines(&self, body: &TokenStream) -> TokenStream {
        let (name, with_sines) = (argument(self.name), self.with_sines());
        let reads = || self.reads.iter().copied().map(argument);
        let arguments = self.reads.iter().map(|&read| {
            let name = argument(read);
            if read == "t" { quote!(#name: T) } else { quote!(#name: &[T]) }
        });
        let arguments: Vec<TokenStream> = arguments.collect();
        let given = reads();
        quote! {
            fn #with_sines(&self, c: &[T], #(#arguments,)* sines: &[[T; 2]], out: &mut [T]) {
                #body
            }
            fn #name(&self, c: &[T], #(#arguments,)* out: &mut [T]) {
                self.#with_sines(c, #(#given,)* &ezy::sines(q), out);
            }
        }
    }

    /// The method around what it does. Orders of a series are computed by straight lines in one function.
    pub fn method(&self, body: TokenStream, is_straight: bool) -> TokenStream {
        let any_is_f64 = self.any_is_f64();
        let number = if any_is_f64.is_some() { Numbers::F64 } else { self.numbers() }.name();
        let name = argument(self.name);
        let reads = self.reads.iter().map(|&read| {
            let name = argument(read);
            match read {
                "t" => quote!(#name: #number),
                "k" => quote!(#name: usize),
                _ => quote!(#name: &[#number]),
            }
        });
        let written = self.writes.vectors().iter().map(|&written| {
            let name = argument(written);
            quote!(#name: &mut [#number])
        });
        let (inline, other, result) = match self.writes {
            // kernels in lanes are compiled for wide registers only where they are inlined
            Writes::Solution(_) if matches!(self.quantity, Quantity::Accelerations | Quantity::Correction) => {
                (quote!(#[inline(always)]), None, quote!(-> ezy::Pivots))
            }
            Writes::Vectors(_)
                if matches!(self.of, Trait::QuasiVelocities | Trait::Powers)
                    || matches!(
                        self.quantity,
                        Quantity::PositionConstraint | Quantity::VelocityConstraint | Quantity::StateRates
                    ) =>
            {
                (quote!(#[inline(always)]), None, quote!())
            }
            Writes::Solution(_) => (quote!(#[inline]), None, quote!(-> ezy::Pivots)),
            Writes::Value => (quote!(), None, quote!(-> #number)),
            Writes::Start => (quote!(), Some(quote!(start: &mut ezy::Start)), quote!()),
            Writes::Store(order) => {
                let (inline, result) = match order {
                    Order::Start => (quote!(), quote!(-> ezy::Pivots)),
                    Order::Present if is_straight => (quote!(#[inline(always)]), quote!()),
                    Order::Present => (quote!(), quote!()),
                };
                (inline, Some(quote!(store: &mut ezy::SeriesStore<#number>)), result)
            }
            Writes::Vectors(_) => (quote!(), None, quote!()),
        };
        let arguments = reads.chain(written).chain(other);
        quote! {
            #inline
            fn #name(&self, c: &[#number], #(#arguments),*) #result {
                #any_is_f64
                #body
            }
        }
    }
}

/// The name of an argument.
pub fn argument(name: &str) -> Ident {
    Ident::new(name, Span::call_site())
}

/// The method that takes a start value.
pub fn give(rate: bool, near: bool) -> Ident {
    argument(match (rate, near) {
        (false, false) => "give_position",
        (true, false) => "give_velocity",
        (false, true) => "near_position",
        (true, true) => "near_velocity",
    })
}
