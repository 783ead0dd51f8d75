//! The recurrences of a scene's Taylor series as an implementation of `Series`.

use std::collections::BTreeMap;

use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

use super::kernel::{self, Body, Vocabulary};
use super::numbers::Numbers;
use super::parts::sequence;
use crate::mechanics::Equations;
use crate::mechanics::series::{Ahead, Kernel, Series, Slot};
use crate::symbolic::Symbol;

/// Products come in groups of so many; `ezy_core::__private::PRODUCT_GROUP`.
const PRODUCT_GROUP: usize = 8;

/// The implementation for the type of a scene.
pub fn implementation(
    type_name: &Ident,
    equations: &Equations,
    series: &Series,
    n_fixed: usize,
    vocabulary: Vocabulary<'_>,
) -> TokenStream {
    let sizes = Sizes::new(equations, series);
    let Sizes { n_coordinates, n_rows, n_products, n_base, n_kept } = sizes;
    let writer = Writer { vocabulary, series, sizes, n_fixed };
    let begin = writer.begin();
    let right_side = writer.method(&series.recurrences.right_side);
    let solve = series.solution.as_ref().map(|solution| writer.method(&solution.kernel));
    let finish = writer.method(&series.recurrences.finish);
    quote! {
        #[automatically_derived]
        impl<T: ezy::Scalar> ezy::Series<T> for #type_name {
            fn series_size(&self) -> ezy::SeriesSize {
                ezy::SeriesSize {
                    n_coordinates: #n_coordinates,
                    n_rows: #n_rows,
                    n_products: #n_products,
                    n_base: #n_base,
                    n_kept: #n_kept,
                }
            }
            fn begin(
                &self,
                c: &[T],
                t: T,
                store: &mut ezy::SeriesStore<T>,
            ) -> ezy::Pivots {
                #begin
            }
            #[inline(always)]
            fn right_side(&self, c: &[T], k: usize, store: &mut ezy::SeriesStore<T>) {
                #right_side
            }
            #[inline(always)]
            fn solve(&self, c: &[T], k: usize, store: &mut ezy::SeriesStore<T>) {
                #solve
            }
            #[inline(always)]
            fn finish(&self, c: &[T], k: usize, store: &mut ezy::SeriesStore<T>) {
                #finish
            }
        }
    }
}

#[derive(Clone, Copy)]
struct Sizes {
    n_coordinates: usize,
    n_rows: usize,
    n_products: usize,
    n_base: usize,
    n_kept: usize,
}

impl Sizes {
    fn new(equations: &Equations, series: &Series) -> Self {
        Self {
            n_coordinates: equations.mass.len(),
            n_rows: equations.constraints.rows.len(),
            n_products: series.recurrences.n_products.next_multiple_of(PRODUCT_GROUP),
            n_base: series.recurrences.n_base,
            n_kept: series.recurrences.n_kept,
        }
    }
}

/// An array of the store, of one order where it holds several.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Array {
    name: &'static str,
    ahead: Option<Ahead>,
}

impl Array {
    /// What it is called in a kernel.
    fn ident(self) -> Ident {
        match self.ahead {
            None => Ident::new(self.name, Span::call_site()),
            Some(ahead) => format_ident!("{}_{}", self.name, ahead),
        }
    }
}

struct Writer<'a> {
    vocabulary: Vocabulary<'a>,
    series: &'a Series,
    sizes: Sizes,
    n_fixed: usize,
}

impl Writer<'_> {
    /// Array, index and length; `None` for orders, which are numbers.
    fn place(&self, slot: Slot) -> Option<(Array, usize, usize)> {
        let Sizes { n_coordinates, n_rows, n_products, n_base, n_kept } = self.sizes;
        let of_step = |name, i, n| Some((Array { name, ahead: None }, i, n));
        let of_order = |name, ahead, i, n| Some((Array { name, ahead: Some(ahead) }, i, n));
        match slot {
            Slot::Base(i) => of_step("base", i, n_base),
            Slot::Sum(i) => of_step("sums", i, n_products),
            Slot::Force(i) => of_step("force", i, n_coordinates),
            Slot::Row(i) => of_step("row", i, n_rows),
            Slot::Acceleration(i) => of_step("a", i, n_coordinates),
            Slot::Multiplier(i) => of_order("lambda", 0, i, n_rows),
            Slot::Kept(ahead, i) => of_order("kept", ahead, i, n_kept),
            Slot::Coordinate(ahead, i) => of_order("q", ahead, i, n_coordinates),
            Slot::Left(ahead, i) => of_order("left", ahead, i, n_products),
            Slot::Right(ahead, i) => of_order("right", ahead, i, n_products),
            Slot::Order(_) | Slot::InverseOrder(_) => None,
        }
    }

    /// What a program reads.
    fn read(&self, symbol: Symbol) -> TokenStream {
        let Some(slot) = self.series.recurrences.slots.slot(symbol) else { return quote!(T::from_f64(f64::NAN)) };
        match (slot, self.place(slot)) {
            (_, Some((array, i, _))) => {
                let array = array.ident();
                quote!(#array[#i])
            }
            (Slot::InverseOrder(ahead), _) => quote!(T::from_f64(1f64) / T::from_f64((k + #ahead) as f64)),
            (Slot::Order(ahead), _) => quote!(T::from_f64((k + #ahead) as f64)),
            _ => quote!(T::from_f64(f64::NAN)),
        }
    }

    /// Present order k ≥ 0.
    fn method(&self, kernel: &Kernel) -> TokenStream {
        let order = |ahead: Ahead| quote!(k + #ahead);
        let Body { statements, outputs } =
            kernel::body(Numbers::Any, &kernel.program, self.vocabulary, &|symbol| self.read(symbol));
        let read = self.arrays_read(kernel, &order);
        let written = self.written(&kernel.targets, &outputs, &order);
        let c = self.constants(kernel);
        quote!(#c #read #statements #written)
    }

    /// The start of a step: what is one order ahead is of order 0.
    fn begin(&self) -> TokenStream {
        let kernel = &self.series.recurrences.begin;
        let n_q = self.sizes.n_coordinates;
        let order = |ahead: Ahead| {
            let order = ahead.saturating_sub(1);
            quote!(#order)
        };
        let Body { statements, outputs } =
            kernel::body(Numbers::Any, &kernel.program, self.vocabulary, &|symbol| self.read(symbol));
        let (written, pivots) = outputs.split_at(kernel.targets.len());
        let written = self.written(&kernel.targets, written, &order);
        let seen = match &self.series.solution {
            Some(solution) => kernel::pivots(&solution.pivots, pivots),
            None => quote!(ezy::Pivots::ALL_VANISHED),
        };
        let c = self.constants(kernel);
        quote! {
            #c
            let q = ezy::row::<#n_q, T>(&store.q, 0);
            let v = ezy::row::<#n_q, T>(&store.q, 1);
            #statements
            #written
            #seen
        }
    }

    fn constants(&self, kernel: &Kernel) -> TokenStream {
        let n = self.n_fixed;
        if kernel.program.reads_constants() { quote!(let c = ezy::array::<#n, T>(c);) } else { quote!() }
    }

    /// The arrays that a program reads, opened once.
    fn arrays_read(&self, kernel: &Kernel, order: &dyn Fn(Ahead) -> TokenStream) -> TokenStream {
        let slots = kernel.program.inputs().into_iter().filter_map(|symbol| self.series.recurrences.slots.slot(symbol));
        let arrays: BTreeMap<Array, usize> =
            slots.filter_map(|slot| self.place(slot)).map(|(array, _, n)| (array, n)).collect();
        arrays
            .into_iter()
            .map(|(array, n)| {
                let (ident, field) = (array.ident(), Ident::new(array.name, Span::call_site()));
                match array.ahead.map(order) {
                    None => quote!(let #ident = ezy::array::<#n, T>(&store.#field);),
                    Some(order) => quote!(let #ident = ezy::row::<#n, T>(&store.#field, #order);),
                }
            })
            .collect()
    }

    /// Writes of all outputs, array by array.
    fn written(
        &self,
        targets: &[Slot],
        outputs: &[kernel::Expression],
        order: &dyn Fn(Ahead) -> TokenStream,
    ) -> TokenStream {
        let mut arrays: BTreeMap<Array, (usize, Vec<TokenStream>)> = BTreeMap::new();
        for (&target, output) in targets.iter().zip(outputs) {
            let Some((array, i, n)) = self.place(target) else { continue };
            let (_, writes) = arrays.entry(array).or_insert_with(|| (n, Vec::new()));
            writes.push(quote!(target[#i] = #output;));
        }
        arrays
            .into_iter()
            .map(|(array, (n, writes))| {
                let field = Ident::new(array.name, Span::call_site());
                let writes = sequence(writes);
                match array.ahead.map(order) {
                    None => quote! {
                        let target = ezy::array_mut::<#n, T>(&mut store.#field);
                        #writes
                    },
                    Some(order) => quote! {
                        let target = ezy::row_mut::<#n, T>(&mut store.#field, #order);
                        #writes
                    },
                }
            })
            .collect()
    }
}
