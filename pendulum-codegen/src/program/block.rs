//! Straight-line code, in no language: what a routine computes, statement by statement.

use std::collections::BTreeSet;

use crate::expr::{Binary, Unary};

/// Statements in the order in which they are computed, and the values that they are for.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Block {
    /// The names of the values that statements define; a [`Local`] is a position in this list.
    pub names: Vec<String>,
    /// The statements. Each reads only what stands before it.
    pub lets: Vec<Let>,
    /// The values that the block is for.
    pub results: Vec<Term>,
}

/// A value that a statement defines.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Local(pub(super) usize);

impl Local {
    /// The position in [`Block::names`].
    pub fn index(self) -> usize {
        self.0
    }
}

/// A statement.
#[derive(Clone, Debug, PartialEq)]
pub enum Let {
    /// One value.
    Value(Local, Term),
    /// The sines and cosines of one angle, or of two, which take hardly longer together than one alone.
    SinCos(Vec<SinCos>),
}

/// The sine and the cosine of an angle; what is not used has no name.
#[derive(Clone, Debug, PartialEq)]
pub struct SinCos {
    /// The angle, in radians.
    pub angle: Term,
    /// Its sine.
    pub sine: Option<Local>,
    /// Its cosine.
    pub cosine: Option<Local>,
}

/// An expression within a statement. Operations are computed as they stand: a printer keeps their order and their
/// brackets.
#[derive(Clone, Debug, PartialEq)]
pub enum Term {
    /// A finite number.
    Number(f64),
    /// The value of another statement.
    Local(Local),
    /// The value of a variable.
    Read(Variable),
    /// An operation of one operand, other than a sine or a cosine.
    Unary(Unary, Box<Term>),
    /// An operation of two operands.
    Binary(Binary, Box<Term>, Box<Term>),
    /// A square root.
    Sqrt(Box<Term>),
    /// A constant power that is neither whole nor a root.
    Power(Box<Term>, f64),
}

/// What code can read that it does not compute. Numbers are positions in the lists of the [`Program`](super::Program).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Variable {
    /// A component of the state.
    State(usize),
    /// A given acceleration: the second rate of a coordinate.
    Acceleration(usize),
    /// The time.
    Time,
    /// An input.
    Input(usize),
    /// A force along a constraint.
    Force(usize),
    /// A constant of the model.
    Constant(usize),
    /// A parameter: in the blocks that are computed once, when the model is built.
    Parameter(usize),
    /// A quantity of the order of a power series that is being computed.
    Series(Coefficient),
}

/// What is known when the coefficients of order `k` of a motion are computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Coefficient {
    /// The number `k`.
    Order,
    /// The number `1 / k`.
    OverOrder,
    /// The coefficient of the time: 1 for `k = 1`, 0 for every other.
    Time,
    /// The coefficient of a component of the state.
    State(usize),
    /// The interior sum of a product of series.
    Sum(usize),
    /// What order 0 has left for all others.
    Kept(usize),
    /// The coefficient of a force along a constraint.
    Force(usize),
}

impl Block {
    /// The name of a value that a statement defines.
    pub fn name(&self, local: Local) -> &str {
        &self.names[local.0]
    }

    /// A block for this many zeros.
    pub(super) fn zeros(count: usize) -> Self {
        Self {
            results: vec![Term::Number(0.0); count],
            ..Self::default()
        }
    }

    /// What can be computed before some variables are known, with the last `count` results, and the rest, which also
    /// reads what was computed before. The results of the first part go on with what the rest reads of it.
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

    /// Every variable that is read.
    pub fn reads(&self) -> BTreeSet<Variable> {
        let mut reads = BTreeSet::new();
        let mut leaf = |leaf: &Term| {
            if let Term::Read(variable) = leaf {
                reads.insert(*variable);
            }
        };
        let of_lets = self.lets.iter().flat_map(Let::terms);
        of_lets.chain(&self.results).for_each(|term| term.leaves(&mut leaf));
        reads
    }
}

impl Let {
    /// The expressions that the statement computes with.
    pub fn terms(&self) -> impl Iterator<Item = &Term> {
        let (value, angles) = match self {
            Self::Value(_, term) => (Some(term), &[][..]),
            Self::SinCos(pairs) => (None, &pairs[..]),
        };
        value.into_iter().chain(angles.iter().map(|pair| &pair.angle))
    }

    /// The values that the statement defines.
    pub fn defines(&self) -> impl Iterator<Item = Local> {
        let (value, pairs) = match self {
            Self::Value(local, _) => (Some(*local), &[][..]),
            Self::SinCos(pairs) => (None, &pairs[..]),
        };
        let of_pairs = pairs.iter().flat_map(|pair| [pair.sine, pair.cosine]).flatten();
        value.into_iter().chain(of_pairs)
    }

    /// The values of other statements that it needs.
    pub fn needs(&self) -> BTreeSet<Local> {
        self.terms().flat_map(Term::locals).collect()
    }
}

impl Term {
    /// Calls `see` with every number, local and variable.
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

    /// The values of statements that it needs.
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
