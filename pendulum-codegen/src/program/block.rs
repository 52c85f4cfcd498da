//! Straight-line code of a routine, statement by statement, independent of the output language.

use std::borrow::Cow;
use std::collections::BTreeSet;

use crate::expr::{Binary, Unary};

/// Statements in the order of evaluation, and the results they lead to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Block {
    /// Names of the values defined by statements; a [`Local`] is an index into this list.
    pub names: Vec<String>,
    /// Statements. Each reads only values defined by earlier ones.
    pub lets: Vec<Let>,
    /// Linear systems solved after the statements, if any.
    pub columns: Option<Box<Columns>>,
    /// Results of the block.
    pub results: Vec<Term>,
}

/// Linear systems with the same matrix: the code of one solution, run for each column of the right-hand sides.
#[derive(Clone, Debug, PartialEq)]
pub struct Columns {
    /// Right-hand sides, column by column, as numbers, locals or variables of the block.
    pub given: Vec<Vec<Term>>,
    /// Entries of the factored matrix.
    pub factors: Vec<Term>,
    /// Code of one solution. It reads the entries of its column, as [`Variable::Given`], and the factors.
    pub solution: Block,
}

/// Value defined by a statement.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Local(pub(super) usize);

impl Local {
    /// Index into [`Block::names`].
    pub fn index(self) -> usize {
        self.0
    }
}

/// Statement.
#[derive(Clone, Debug, PartialEq)]
pub enum Let {
    /// A single value.
    Value(Local, Term),
    /// Sines and cosines of one angle, or of two: a pair takes hardly longer than one alone.
    SinCos(Vec<SinCos>),
}

/// Sine and cosine of an angle. An unused one has no name.
#[derive(Clone, Debug, PartialEq)]
pub struct SinCos {
    /// Angle in radians.
    pub angle: Term,
    /// Sine of the angle.
    pub sine: Option<Local>,
    /// Cosine of the angle.
    pub cosine: Option<Local>,
}

/// Expression within a statement. A printer must keep the order of operations and the parentheses, so that the value is
/// computed exactly as written.
#[derive(Clone, Debug, PartialEq)]
pub enum Term {
    /// Finite number.
    Number(f64),
    /// Value of another statement.
    Local(Local),
    /// Value of a variable.
    Read(Variable),
    /// Unary operation other than a sine or a cosine.
    Unary(Unary, Box<Term>),
    /// Binary operation.
    Binary(Binary, Box<Term>, Box<Term>),
    /// Square root.
    Sqrt(Box<Term>),
    /// Constant power whose exponent is neither an integer nor one half.
    Power(Box<Term>, f64),
}

/// Variable that code reads but does not compute. Numbers are indices into the lists of the
/// [`Program`](super::Program).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Variable {
    /// Component of the state.
    State(usize),
    /// Given acceleration: second time derivative of a coordinate.
    Acceleration(usize),
    /// Given weight of a component of the right-hand side.
    Weight(usize),
    /// Component of a given direction of the state and the inputs.
    Direction(usize),
    /// Time.
    Time,
    /// Input.
    Input(usize),
    /// Force along a constraint.
    Force(usize),
    /// Constant of the model.
    Constant(usize),
    /// Parameter, in the blocks evaluated once when the model is built.
    Parameter(usize),
    /// Quantity of the current order of a power series.
    Series(Coefficient),
    /// Entry of the current column of [`Columns`], in the code of its solution.
    Given(usize),
    /// Entry of the factored matrix of [`Columns`], in the code of a solution.
    Factor(usize),
    /// Entry of the solutions of [`Columns`], column by column, in the results of the block.
    Solved(usize),
}

/// Quantity available when the coefficients of order `k` of a motion are computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Coefficient {
    /// The order `k`.
    Order,
    /// The reciprocal `1 / k`.
    OverOrder,
    /// Coefficient of the time: 1 for `k = 1`, 0 otherwise.
    Time,
    /// Coefficient of a component of the state.
    State(usize),
    /// Interior sum of a product of series.
    Sum(usize),
    /// Value of order 0 that every order reuses.
    Kept(usize),
    /// Coefficient of a force along a constraint.
    Force(usize),
    /// Coefficient of a factor in a product of the motion, for the series of its derivatives: of the left factors, then
    /// of the right ones.
    Side(usize),
}

/// Sum or difference with a product, which fused arithmetic rounds once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MultiplyAdd<'t> {
    /// Signs of the product and of the other term.
    pub signs: Signs,
    /// Factors of the product.
    pub factors: [&'t Term; 2],
    /// Other term.
    pub other: &'t Term,
}

/// Signs of a product and of another term.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Signs {
    /// `a*b + c`.
    Add,
    /// `a*b - c`.
    Subtract,
    /// `c - a*b`.
    SubtractProduct,
}

impl Block {
    /// Name of a value defined by a statement.
    pub fn name(&self, local: Local) -> &str {
        &self.names[local.0]
    }

    /// Block whose results are `count` zeros.
    pub(super) fn zeros(count: usize) -> Self {
        Self {
            results: vec![Term::Number(0.0); count],
            ..Self::default()
        }
    }

    /// Splits the block in two. The first part holds the statements that need no late variable, and ends in the last
    /// `count` results followed by the values that the second part reads. The second part holds the rest.
    pub(super) fn split(mut self, count: usize, is_late: impl Fn(Variable) -> bool) -> [Self; 2] {
        let mut late: BTreeSet<Local> = BTreeSet::new();
        let mut parts = [(); 2].map(|()| Self {
            names: self.names.clone(),
            ..Self::default()
        });
        for code in self.lets {
            let mut waits = code.needs().iter().any(|local| late.contains(local));
            for term in code.terms() {
                term.leaves(&mut |leaf| waits |= matches!(leaf, Term::Read(variable) if is_late(*variable)));
            }
            late.extend(code.defines().filter(|_| waits));
            parts[usize::from(waits)].lets.push(code);
        }
        let first = self.results.split_off(self.results.len() - count);
        let read = parts[1].lets.iter().flat_map(Let::needs);
        let read: BTreeSet<Local> = read.chain(self.results.iter().flat_map(Term::locals)).collect();
        let read = read.difference(&late).map(|&local| Term::Local(local));
        parts[0].results = first.into_iter().chain(read).collect();
        parts[1].results = self.results;
        parts
    }

    /// Variables read by the block.
    pub fn reads(&self) -> BTreeSet<Variable> {
        let of_columns = self.columns.iter().flat_map(|columns| columns.terms());
        let mut reads = read_by(of_columns.chain(&self.results));
        reads.append(&mut self.read_by_statements());
        reads
    }

    /// Variables that the statements read.
    pub(crate) fn read_by_statements(&self) -> BTreeSet<Variable> {
        read_by(self.lets.iter().flat_map(Let::terms))
    }

    /// True if a statement reads a solution of [`columns`](Self::columns), which are solved after all statements.
    pub(super) fn statements_read_solutions(&self) -> bool {
        let mut reads = self.read_by_statements().into_iter();
        reads.any(|variable| matches!(variable, Variable::Solved(_)))
    }

    /// The block with its linear systems solved one after another by statements, for code without loops.
    pub(crate) fn unrolled(&self) -> Cow<'_, Self> {
        let Some(columns) = &self.columns else {
            return Cow::Borrowed(self);
        };
        let mut block = Self {
            columns: None,
            ..self.clone()
        };
        let mut solved = Vec::new();
        for (n, given) in columns.given.iter().enumerate() {
            let (own, first) = (&columns.solution, block.names.len());
            let results = (0..given.len()).map(|row| format!("x{row}"));
            block.names.extend(
                own.names
                    .iter()
                    .cloned()
                    .chain(results)
                    .map(|name| format!("{name}_{n}")),
            );
            let replaced = |leaf: &Term| match *leaf {
                Term::Local(Local(local)) => Term::Local(Local(first + local)),
                Term::Read(Variable::Given(row)) => given[row].clone(),
                Term::Read(Variable::Factor(n)) => columns.factors[n].clone(),
                _ => leaf.clone(),
            };
            block.lets.extend(own.lets.iter().map(|code| match code {
                Let::Value(Local(local), term) => Let::Value(Local(first + local), term.with_leaves(&replaced)),
                Let::SinCos(_) => unreachable!("a linear system has no sines"),
            }));
            for (local, term) in (first + own.names.len()..).zip(&own.results) {
                block.lets.push(Let::Value(Local(local), term.with_leaves(&replaced)));
                solved.push(Term::Local(Local(local)));
            }
        }
        for result in &mut block.results {
            *result = result.with_leaves(&|leaf| match *leaf {
                Term::Read(Variable::Solved(n)) => solved[n].clone(),
                _ => leaf.clone(),
            });
        }
        Cow::Owned(block)
    }
}

/// Variables that terms read.
fn read_by<'a>(terms: impl Iterator<Item = &'a Term>) -> BTreeSet<Variable> {
    let mut reads = BTreeSet::new();
    terms.for_each(|term| {
        term.leaves(&mut |leaf| {
            if let Term::Read(variable) = leaf {
                reads.insert(*variable);
            }
        });
    });
    reads
}

impl Columns {
    /// Right-hand sides and factors.
    pub fn terms(&self) -> impl Iterator<Item = &Term> {
        self.given.iter().flatten().chain(&self.factors)
    }
}

impl Let {
    /// Expressions evaluated by the statement.
    pub fn terms(&self) -> impl Iterator<Item = &Term> {
        let (value, angles) = match self {
            Self::Value(_, term) => (Some(term), &[][..]),
            Self::SinCos(pairs) => (None, &pairs[..]),
        };
        value.into_iter().chain(angles.iter().map(|pair| &pair.angle))
    }

    /// Values defined by the statement.
    pub fn defines(&self) -> impl Iterator<Item = Local> {
        let (value, pairs) = match self {
            Self::Value(local, _) => (Some(*local), &[][..]),
            Self::SinCos(pairs) => (None, &pairs[..]),
        };
        let of_pairs = pairs.iter().flat_map(|pair| [pair.sine, pair.cosine]).flatten();
        value.into_iter().chain(of_pairs)
    }

    /// Values of other statements read by this one.
    pub fn needs(&self) -> BTreeSet<Local> {
        self.terms().flat_map(Term::locals).collect()
    }
}

impl Term {
    /// The term as a sum or difference with a product, if it is one. Of two products it is the second, since the value
    /// of a long sum is known last on its left.
    pub fn multiply_add(&self) -> Option<MultiplyAdd<'_>> {
        let Self::Binary(op @ (Binary::Add | Binary::Sub), left, right) = self else {
            return None;
        };
        let (signs, product, other) = match (op, &**left, &**right) {
            (Binary::Add, _, Self::Binary(Binary::Mul, ..)) => (Signs::Add, right, left),
            (Binary::Sub, _, Self::Binary(Binary::Mul, ..)) => (Signs::SubtractProduct, right, left),
            (Binary::Add, ..) => (Signs::Add, left, right),
            _ => (Signs::Subtract, left, right),
        };
        match &**product {
            Self::Binary(Binary::Mul, a, b) => Some(MultiplyAdd {
                signs,
                factors: [a, b],
                other,
            }),
            _ => None,
        }
    }

    /// Calls `see` for every number, local and variable.
    fn leaves(&self, see: &mut impl FnMut(&Self)) {
        match self {
            Self::Number(_) | Self::Local(_) | Self::Read(_) => see(self),
            Self::Unary(_, a) | Self::Sqrt(a) | Self::Power(a, _) => a.leaves(see),
            Self::Binary(_, a, b) => {
                a.leaves(see);
                b.leaves(see);
            }
        }
    }

    /// The term with each number, local and variable replaced.
    fn with_leaves(&self, replaced: &impl Fn(&Self) -> Self) -> Self {
        let of = |a: &Self| Box::new(a.with_leaves(replaced));
        match self {
            Self::Number(_) | Self::Local(_) | Self::Read(_) => replaced(self),
            Self::Unary(op, a) => Self::Unary(*op, of(a)),
            Self::Sqrt(a) => Self::Sqrt(of(a)),
            Self::Power(a, exponent) => Self::Power(of(a), *exponent),
            Self::Binary(op, a, b) => Self::Binary(*op, of(a), of(b)),
        }
    }

    /// Values of statements read by the term.
    pub fn locals(&self) -> BTreeSet<Local> {
        let mut locals = BTreeSet::new();
        self.leaves(&mut |leaf| {
            if let Self::Local(local) = leaf {
                locals.insert(*local);
            }
        });
        locals
    }
}
