//! What the methods that compute are called, read and write: the same for every scene.

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use super::numbers::Numbers;
use crate::mechanics::kernels::Quantity;

/// The traits of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Trait {
    Equations,
    Derived,
    Scene,
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
}

impl Writes {
    /// The vectors that are filled.
    pub fn vectors(self) -> &'static [&'static str] {
        match self {
            Self::Vectors(names) | Self::Solution(names) => names,
            Self::Value | Self::Start => &[],
        }
    }
}

const OUT: Writes = Writes::Vectors(&["out"]);

/// Every method, in the order in which they are emitted.
pub const ALL: [Signature; 18] = [
    any(Quantity::MassMatrix, "mass_matrix", &[], OUT),
    any(Quantity::PositionConstraint, "position_constraint", &["t", "q"], OUT),
    any(Quantity::VelocityConstraint, "velocity_constraint", &["t", "q", "v"], OUT),
    any(Quantity::VelocityJacobian, "velocity_jacobian", &["t", "q"], OUT),
    any(Quantity::ConvectiveTerm, "convective_term", &["t", "q", "v"], OUT),
    any(Quantity::AppliedForce, "applied_force", &["t", "q", "v"], OUT),
    any(Quantity::Accelerations, "accelerations", &["t", "q", "v"], Writes::Solution(&["a", "lambda"])),
    any(Quantity::Correction, "correction", &["t", "q", "residual"], Writes::Solution(&["delta"])),
    any(Quantity::ProjectedAccelerations, "projected_accelerations", &["t", "q", "v"], Writes::Solution(&["out"])),
    scene(Quantity::Power, "power", &["t", "q", "v", "lambda"], OUT),
    scene(Quantity::Points, "points", &["t", "q"], OUT),
    scene(Quantity::Outputs, "outputs", &["t", "q", "v"], OUT),
    derived(Quantity::Events, "events", &["t", "q", "v"], OUT),
    derived(Quantity::StickSlip, "stick_slip", &["t", "q", "v"], OUT),
    derived(Quantity::Stop, "stop", &["t", "q", "v"], OUT),
    scene(Quantity::PotentialEnergy, "potential_energy", &["t", "q"], Writes::Value),
    scene(Quantity::Start, "start", &[], Writes::Start),
    derived(Quantity::Jacobians, "jacobians", &["t", "q", "v", "a", "lambda"], Writes::Vectors(&["by_q", "by_v"])),
];

const fn any(quantity: Quantity, name: &'static str, reads: &'static [&'static str], writes: Writes) -> Signature {
    Signature { quantity, of: Trait::Equations, name, reads, writes }
}

const fn derived(quantity: Quantity, name: &'static str, reads: &'static [&'static str], writes: Writes) -> Signature {
    Signature { quantity, of: Trait::Derived, name, reads, writes }
}

const fn scene(quantity: Quantity, name: &'static str, reads: &'static [&'static str], writes: Writes) -> Signature {
    Signature { quantity, of: Trait::Scene, name, reads, writes }
}

impl Signature {
    /// Equations are written for any number.
    pub const fn numbers(&self) -> Numbers {
        match self.of {
            Trait::Equations => Numbers::Any,
            Trait::Derived | Trait::Scene => Numbers::F64,
        }
    }

    /// The method around what it does.
    pub fn method(&self, body: TokenStream) -> TokenStream {
        let (name, number) = (argument(self.name), self.numbers().name());
        let reads = self.reads.iter().map(|&read| {
            let name = argument(read);
            if read == "t" { quote!(#name: #number) } else { quote!(#name: &[#number]) }
        });
        let written = self.writes.vectors().iter().map(|&written| {
            let name = argument(written);
            quote!(#name: &mut [#number])
        });
        let start = matches!(self.writes, Writes::Start).then(|| quote!(start: &mut ezy::Start));
        let arguments = reads.chain(written).chain(start);
        let (inline, result) = match self.writes {
            Writes::Solution(_) => (quote!(#[inline]), quote!(-> ezy::Pivots)),
            Writes::Value => (quote!(), quote!(-> #number)),
            _ => (quote!(), quote!()),
        };
        quote! {
            #inline
            fn #name(&self, c: &[#number], #(#arguments),*) #result {
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
