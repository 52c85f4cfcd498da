//! The columns of long Jacobians, solved in a loop.

use std::collections::BTreeMap;

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::{Writer, local};
use crate::emit::rust::count;
use crate::program::{Columns, Let, Local, Term, Variable};

/// Values that are entries of right-hand sides, and where: row and column of each.
pub(super) fn stored(columns: &Columns) -> BTreeMap<Local, Vec<[Literal; 2]>> {
    let mut stored: BTreeMap<Local, Vec<[Literal; 2]>> = BTreeMap::new();
    for (n, column) in columns.given.iter().enumerate() {
        for (row, entry) in column.iter().enumerate() {
            if let Term::Local(local) = entry {
                stored.entry(*local).or_default().push([count(row), count(n)]);
            }
        }
    }
    stored
}

/// Numbers of rows and of columns. For scalars the latter is rounded up, so that compilers fill registers with columns.
pub(super) fn size(columns: &Columns) -> [usize; 2] {
    /// Number of `f64` in a register.
    const LANES: usize = 4;
    [
        columns.solution.results.len(),
        columns.given.len().next_multiple_of(LANES),
    ]
}

impl Writer<'_> {
    /// Declaration of the columns, which the statements fill; and the loop that solves them.
    pub(super) fn columns(&self, columns: &Columns) -> (TokenStream, TokenStream) {
        let (rows, number) = (columns.solution.results.len(), count(columns.given.len()));
        let (name, n) = (local("columns"), local("column"));
        let [length, padded] = size(columns).map(count);
        let before = quote!(let mut #name = [[T::default(); #padded]; #length];);
        let others = columns.given.iter().enumerate().flat_map(|(n, column)| {
            let others = column.iter().enumerate();
            let others = others.filter(|(_, entry)| !matches!(entry, Term::Local(_) | Term::Number(0.0)));
            others.map(move |(row, entry)| (count(row), count(n), entry))
        });
        let others = others.map(|(row, n, entry)| {
            let entry = self.term(entry);
            quote!(#name[#row][#n] = #entry;)
        });
        let others: TokenStream = others.collect();
        let factors = columns.factors.iter().enumerate().map(|(n, factor)| {
            let (factor, of) = (self.term(factor), self.names.variable(Variable::Factor(n)));
            quote!(let #of = #factor;)
        });
        let factors: TokenStream = factors.collect();
        let places: Vec<Literal> = (0..rows).map(count).collect();
        let given = (0..rows).map(|row| self.names.variable(Variable::Given(row)));
        let code = self
            .names
            .code(&columns.solution, |results| quote!(#(#name[#places][#n] = #results;)*));
        let solved = quote! {
            #others
            #factors
            for #n in 0..if T::LANES == 1 { #padded } else { #number } {
                let [#(#given),*] = [#(#name[#places][#n]),*];
                #code
            }
        };
        (before, solved)
    }

    /// Statements that store the values of `code` in the columns.
    pub(super) fn stores(&self, code: &Let) -> TokenStream {
        let stores = code.defines().flat_map(|of| {
            let (name, columns) = (self.local(of), local("columns"));
            let places = self.stored.get(&of).into_iter().flatten();
            places.map(move |[row, n]| quote!(T::put(&mut #columns[#row][#n], #name);))
        });
        stores.collect()
    }

    /// Entry of the solutions, which follow one another column by column.
    pub(super) fn solved(&self, n: usize) -> TokenStream {
        let columns = self.block.columns.as_ref();
        let rows = columns.map_or(1, |columns| columns.solution.results.len());
        let (name, row, column) = (local("columns"), count(n % rows), count(n / rows));
        quote!(#name[#row][#column])
    }
}
