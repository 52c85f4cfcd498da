//! Blocks as Rust code.

mod columns;

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{ToTokens, format_ident, quote};

use super::count;
use super::lanes::inlined_into_lanes;
use crate::expr::{Binary, Precedence, Unary};
use crate::program::{Block, Coefficient, Let, Local, MultiplyAdd, Program, Signs, SinCos, Term, Variable};
use columns::{size, stored};

/// Maximum number of statements in one Rust block. Every `let` opens a scope inside the one before, and compilers that
/// walk scopes by recursion (as LLVM does for debug information) overflow the stack at some thousand nested scopes.
const MOST_STATEMENTS: usize = 256;

/// Number of statements above which a block is compiled in parts. The time and the memory of compilers grow faster than
/// the length of a function.
pub(super) const LONG: usize = 8192;

/// Maximum number of statements in one part.
const MOST_IN_PART: usize = 4096;

/// Local name that cannot clash with a declaration. The mark of a raw identifier is dropped, since it may not follow a
/// prefix.
pub(super) fn local(name: &str) -> Ident {
    Ident::new(&name.replace("r#", ""), Span::mixed_site())
}

/// Names of the variables in generated code.
#[derive(Clone, Copy)]
pub(super) struct Names<'p>(pub(super) &'p Program);

impl Names<'_> {
    /// Name of a variable.
    pub(super) fn variable(self, variable: Variable) -> Ident {
        let Self(program) = self;
        let [positions, rates] = program.layout.components();
        // no declared name starts like a component of the state: `q_theta` and `qx_p`
        let of_state = |prefix: &str, name: &str| match name.rsplit_once('.') {
            Some((name, axis)) => local(&format!("{prefix}{axis}_{name}")),
            None => local(&format!("{prefix}_{name}")),
        };
        match variable {
            Variable::State(n) => match positions.get(n) {
                Some(name) => of_state("q", name),
                None => match rates.get(n - positions.len()) {
                    Some(name) => of_state("qd", name),
                    None => of_state("s", &program.layout.states[n - positions.len() - rates.len()].name),
                },
            },
            Variable::Acceleration(n) => of_state("qdd", &rates[n]),
            Variable::Weight(n) => local(&format!("w{n}")),
            Variable::Direction(n) => local(&format!("d{n}")),
            Variable::Time => format_ident!("t"),
            Variable::Input(n) => local(&format!("u_{}", program.inputs[n].name)),
            Variable::Force(n) => local(&format!("f{n}")),
            Variable::Constant(n) => local(&format!("k{n}")),
            Variable::Parameter(n) => local(&format!("p_{}", program.parameters[n].name)),
            Variable::Series(coefficient) => match coefficient {
                Coefficient::Order => local("order"),
                Coefficient::OverOrder => local("over_order"),
                Coefficient::Time => local("time"),
                Coefficient::State(n) => local(&format!("x{n}")),
                Coefficient::Sum(n) => local(&format!("s{n}")),
                Coefficient::Kept(n) => local(&format!("h{n}")),
                Coefficient::Force(n) => local(&format!("force{n}")),
                Coefficient::Side(n) => local(&format!("f{n}")),
            },
            Variable::Given(n) => local(&format!("r{n}")),
            Variable::Factor(n) => local(&format!("l{n}")),
            Variable::Solved(_) => local("columns"),
        }
    }

    /// Statements of a block, followed by the tokens that `result` makes of its results.
    pub(super) fn code(self, block: &Block, result: impl FnOnce(&[Piece]) -> TokenStream) -> TokenStream {
        let writer = Writer {
            names: self,
            block,
            stored: block.columns.as_deref().map(stored).unwrap_or_default(),
        };
        let results: Vec<Piece> = block.results.iter().map(|term| writer.term(term)).collect();
        let (statements, result) = (writer.statements(), result(&results));
        match block.columns.as_deref() {
            Some(columns) => {
                let (before, solved) = writer.columns(columns);
                quote!(#before #statements #solved #result)
            }
            None => quote!(#statements #result),
        }
    }
}

/// Rust expression and its precedence.
pub(super) struct Piece(TokenStream, Precedence);

impl Piece {
    /// Returns the expression, in parentheses if its precedence is below `least`.
    pub(super) fn within(&self, least: Precedence) -> TokenStream {
        let Self(tokens, precedence) = self;
        if *precedence < least {
            quote!((#tokens))
        } else {
            quote!(#tokens)
        }
    }
}

impl ToTokens for Piece {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        self.0.to_tokens(tokens);
    }
}

/// Literal of the generic type that parses back to exactly the same value.
pub(super) fn number(value: f64) -> TokenStream {
    let size = value.abs();
    let shortest: Result<Literal, _> = format!("{size:?}").parse();
    let literal = shortest.unwrap_or_else(|_| Literal::f64_unsuffixed(size));
    if value.is_sign_negative() && value != 0.0 {
        quote!(T::from_f64(-#literal))
    } else {
        quote!(T::from_f64(#literal))
    }
}

/// True for the order of a coefficient of a series and its reciprocal.
fn is_order(term: &Term) -> bool {
    matches!(
        term,
        Term::Read(Variable::Series(Coefficient::Order | Coefficient::OverOrder))
    )
}

struct Writer<'p> {
    names: Names<'p>,
    block: &'p Block,
    /// Values stored in the columns at once, so that they need not stay in registers.
    stored: BTreeMap<Local, Vec<[Literal; 2]>>,
}

impl Writer<'_> {
    fn local(&self, of: Local) -> Ident {
        local(self.block.name(of))
    }

    fn statements(&self) -> TokenStream {
        let lets = &self.block.lets;
        let factors = self.block.columns.iter().flat_map(|columns| &columns.factors);
        let results: BTreeSet<Local> = self
            .block
            .results
            .iter()
            .chain(factors)
            .flat_map(Term::locals)
            .collect();
        if lets.len() > LONG {
            return self.parts(&results);
        }
        self.scopes(lets, results, |lets| {
            lets.iter().map(|code| self.statement(code)).collect()
        })
    }

    /// Statements in scopes of at most [`MOST_STATEMENTS`], each of which returns the values needed after it.
    fn scopes(&self, lets: &[Let], mut needed: BTreeSet<Local>, code: impl Fn(&[Let]) -> TokenStream) -> TokenStream {
        if lets.len() <= MOST_STATEMENTS {
            return code(lets);
        }
        let scopes = lets.chunks(MOST_STATEMENTS).rev().map(|scope| {
            let defined = scope.iter().flat_map(Let::defines);
            let out = defined.filter(|local| needed.contains(local)).map(|of| self.local(of));
            let out: Vec<Ident> = out.collect();
            needed.extend(scope.iter().flat_map(Let::needs));
            let inside = code(scope);
            quote!(let (#(#out,)*) = { #inside (#(#out,)*) };)
        });
        let scopes: Vec<TokenStream> = scopes.collect();
        scopes.into_iter().rev().collect()
    }

    /// Statements in parts that are compiled as functions of their own. Values that one part passes to others are in an
    /// array: arguments would be copied for each part. They are read at their first use and written at once, so that
    /// few of them are alive at a time.
    fn parts(&self, results: &BTreeSet<Local>) -> TokenStream {
        let length = self.part_length();
        let (passed, array) = (self.passed(results, length), local("passed"));
        let load = |of: &Local| {
            let (name, place) = (self.local(*of), passed.get(of)?);
            Some(quote!(let #name = #array[#place];))
        };
        let parts = self.block.lets.chunks(length).map(|part| {
            let own: BTreeSet<Local> = part.iter().flat_map(Let::defines).collect();
            let inside = self.scopes(part, BTreeSet::new(), |scope| {
                let mut known = own.clone();
                let statements = scope.iter().map(|code| {
                    let needs = code.needs();
                    let loads: TokenStream = needs.difference(&known).filter_map(load).collect();
                    known.extend(needs);
                    let stores = code.defines().filter_map(|of| {
                        let (name, place) = (self.local(of), passed.get(&of)?);
                        Some(quote!(#array[#place] = #name;))
                    });
                    let (statement, stores) = (self.statement(code), stores.collect::<TokenStream>());
                    quote!(#loads #statement #stores)
                });
                statements.collect()
            });
            self.part(passed.len(), &inside)
        });
        let (places, reads) = (count(passed.len()), self.reads());
        let (parts, loads) = (parts.collect::<TokenStream>(), results.iter().filter_map(load));
        quote! {
            let mut #array = [T::default(); #places];
            let reads = [#(#reads),*];
            #parts
            #(#loads)*
        }
    }

    /// Part of the statements: it changes the array of `passed` values, and the columns if there are any.
    fn part(&self, passed: usize, inside: &TokenStream) -> TokenStream {
        let (reads, inline) = (self.reads(), inlined_into_lanes());
        let [passed, number] = [passed, reads.len()].map(count);
        let columns = self.block.columns.as_deref().map(|columns| {
            let [length, padded] = size(columns).map(count);
            (local("columns"), quote!([[T; #padded]; #length]))
        });
        let changed = [(local("passed"), quote!([T; #passed]))].into_iter().chain(columns);
        let (names, types): (Vec<Ident>, Vec<TokenStream>) = changed.unzip();
        quote! {
            {
                struct __Part;
                impl<T: ::pendulum_core::real::Real>
                    ::pendulum_core::real::lanes::Routine<(#(&mut #types,)*), [T; #number]> for __Part
                {
                    type Output = ();
                    #inline
                    fn run(self, (#(#names,)*): &mut (#(&mut #types,)*), reads: &[T; #number]) {
                        let [#(#reads),*] = *reads;
                        #inside
                    }
                }
                T::apart(__Part, &mut (#(&mut #names,)*), &reads);
            }
        }
    }

    /// Names of the variables that the statements read.
    fn reads(&self) -> Vec<Ident> {
        let reads = self.block.read_by_statements().into_iter();
        reads.map(|variable| self.names.variable(variable)).collect()
    }

    /// Number of statements in each of as many equal parts as needed.
    fn part_length(&self) -> usize {
        let all = self.block.lets.len();
        all.div_ceil(all.div_ceil(MOST_IN_PART))
    }

    /// Places in the array for the values that are read outside the part that defines them, as `results` are.
    fn passed(&self, results: &BTreeSet<Local>, length: usize) -> BTreeMap<Local, Literal> {
        let mut passed = results.clone();
        let mut defined: BTreeMap<Local, usize> = BTreeMap::new();
        for (n, code) in self.block.lets.iter().enumerate() {
            let from_others = code.needs().into_iter().filter(|of| defined[of] / length != n / length);
            passed.extend(from_others);
            defined.extend(code.defines().map(|of| (of, n)));
        }
        passed.into_iter().zip((0..).map(count)).collect()
    }

    fn statement(&self, code: &Let) -> TokenStream {
        let (values, stores) = (self.values(code), self.stores(code));
        quote!(#values #stores)
    }

    /// Statement without what it stores.
    fn values(&self, code: &Let) -> TokenStream {
        match code {
            Let::Value(of, term) => {
                let (name, value) = (self.local(*of), self.term(term));
                quote!(let #name = #value;)
            }
            Let::SinCos(pairs) => {
                let name = |of: &Option<Local>| match of.map(|of| self.local(of)) {
                    Some(name) => quote!(#name),
                    None => quote!(_),
                };
                let patterns = pairs.iter().map(|SinCos { sine, cosine, .. }| {
                    let (sine, cosine) = (name(sine), name(cosine));
                    quote!((#sine, #cosine))
                });
                match pairs.as_slice() {
                    [one, other] => {
                        let (receiver, other) = (self.within(&one.angle, Precedence::Atom), self.term(&other.angle));
                        quote!(let [#(#patterns),*] = #receiver.sin_cos_pair(#other);)
                    }
                    angles => {
                        let receivers = angles.iter().map(|pair| self.within(&pair.angle, Precedence::Atom));
                        quote!(#(let #patterns = #receivers.sin_cos();)*)
                    }
                }
            }
        }
    }

    fn within(&self, term: &Term, least: Precedence) -> TokenStream {
        self.term(term).within(least)
    }

    fn term(&self, term: &Term) -> Piece {
        use Precedence::{Atom, Product, Sum};
        if let Some(fused) = term.multiply_add() {
            return self.multiply_add(&fused);
        }
        let (tokens, precedence) = match term {
            Term::Number(value) => (number(*value), Atom),
            Term::Local(of) => {
                let name = self.local(*of);
                (quote!(#name), Atom)
            }
            Term::Read(Variable::Solved(n)) => (self.solved(*n), Atom),
            Term::Read(variable) => {
                let name = self.names.variable(*variable);
                (quote!(#name), Atom)
            }
            Term::Unary(Unary::Neg, a) => {
                let a = self.within(a, Precedence::Unary);
                (quote!(-#a), Precedence::Unary)
            }
            Term::Unary(op, a) => {
                let (a, function) = (self.within(a, Atom), format_ident!("{}", op.spelling()));
                (quote!(#a.#function()), Atom)
            }
            Term::Binary(Binary::Mul, order, a) | Term::Binary(Binary::Mul, a, order) if is_order(order) => {
                // numbers with derivatives then multiply none of the order
                let (a, order) = (self.within(a, Atom), self.term(order));
                (quote!(#a.scaled(#order)), Atom)
            }
            Term::Binary(op, a, b) => {
                let (left, right, own) = match op {
                    Binary::Add | Binary::Sub => (Sum, Product, Sum),
                    Binary::Mul | Binary::Div => (Product, Precedence::Unary, Product),
                    Binary::Atan2 | Binary::Max | Binary::Min => (Atom, Sum, Atom),
                };
                let (a, b) = (self.within(a, left), self.within(b, right));
                let tokens = match op {
                    Binary::Add => quote!(#a + #b),
                    Binary::Sub => quote!(#a - #b),
                    Binary::Mul => quote!(#a * #b),
                    Binary::Div => quote!(#a / #b),
                    Binary::Atan2 => quote!(#a.atan2(#b)),
                    Binary::Max => quote!(#a.at_least(#b)),
                    Binary::Min => quote!(#a.at_most(#b)),
                };
                (tokens, own)
            }
            Term::Sqrt(a) => {
                let a = self.within(a, Atom);
                (quote!(#a.sqrt()), Atom)
            }
            Term::Power(a, exponent) => {
                let (a, exponent) = (self.within(a, Atom), number(*exponent));
                (quote!(#a.powf(#exponent)), Atom)
            }
        };
        Piece(tokens, precedence)
    }

    /// A product and a sum in one call, so that fused number types round once.
    fn multiply_add(&self, fused: &MultiplyAdd<'_>) -> Piece {
        let [a, b] = fused.factors;
        let (a, b, other) = (self.within(a, Precedence::Atom), self.term(b), self.term(fused.other));
        let tokens = match fused.signs {
            Signs::Add => quote!(#a.mul_add(#b, #other)),
            Signs::Subtract => quote!(#a.mul_sub(#b, #other)),
            Signs::SubtractProduct => quote!(#a.mul_neg_add(#b, #other)),
        };
        Piece(tokens, Precedence::Atom)
    }
}
