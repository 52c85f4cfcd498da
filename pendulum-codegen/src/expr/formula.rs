//! Formulas in handwritten notation: the tree that is printed as text and as LaTeX.
//!
//! A formula is a notation, not a value: `a + b` and `b + a` are two formulas. A [`Printer`](super::Printer) makes it
//! from an expression of the graph, or it is taken verbatim from the text of a declaration.

use super::Rational;

/// A written formula.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Formula {
    /// A number, exactly.
    Number(Rational),
    /// A number and its unit, verbatim.
    Measured(String, String),
    /// A name.
    Name(String),
    /// An entry of a matrix or a vector, such as `A[theta1, theta2]`: its name and the names of its indices.
    Entry(&'static str, Vec<String>),
    /// `function(arguments)`; `dot(name)` is a rate.
    Call(String, Vec<Formula>),
    /// `-a`
    Neg(Box<Formula>),
    /// `a + b - c`
    Sum(Vec<Summand>),
    /// `a*b*c`
    Product(Vec<Formula>),
    /// `a/b`
    Quotient(Box<Formula>, Box<Formula>),
    /// `a^b`
    Power(Box<Formula>, Box<Formula>),
}

/// A term of a sum.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Summand {
    /// True if the term is subtracted.
    pub negative: bool,
    /// Formula that is added or subtracted.
    pub formula: Formula,
}

/// `name = formula`
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Definition {
    /// The name.
    pub name: String,
    /// Formula that it stands for.
    pub formula: Formula,
}

impl Formula {
    /// A name, without the `r#` of a raw identifier.
    pub fn name(name: &str) -> Self {
        Self::Name(name.trim_start_matches("r#").to_owned())
    }

    /// The rate of a coordinate.
    pub fn rate(coordinate: &str) -> Self {
        Self::Call("dot".to_owned(), vec![Self::name(coordinate)])
    }

    /// Product of factors; `None` if there are none.
    pub(super) fn product(mut factors: Vec<Formula>) -> Option<Self> {
        if factors.len() > 1 {
            return Some(Self::Product(factors));
        }
        factors.pop()
    }

    /// Terms of a sum, negated if `negative` is set; any other formula is one term.
    pub fn into_terms(self, negative: bool) -> Vec<Summand> {
        use num_traits::Signed;
        match self {
            Self::Sum(mut terms) => {
                terms.iter_mut().for_each(|term| term.negative ^= negative);
                terms
            }
            Self::Neg(formula) if !matches!(*formula, Self::Sum(_)) => formula.into_terms(!negative),
            Self::Neg(formula) => vec![Summand {
                negative: !negative,
                formula: *formula,
            }],
            Self::Number(n) if n.is_negative() => vec![Summand {
                negative: !negative,
                formula: Self::Number(-n),
            }],
            formula => vec![Summand { negative, formula }],
        }
    }

    /// The sum of terms.
    pub fn sum(mut terms: Vec<Summand>) -> Self {
        match (terms.len(), terms.pop()) {
            (_, None) => Self::Number(super::ratio(0, 1)),
            (
                1,
                Some(Summand {
                    negative: false,
                    formula,
                }),
            ) => formula,
            (
                1,
                Some(Summand {
                    negative: true,
                    formula,
                }),
            ) => Self::Neg(Box::new(formula)),
            (_, Some(last)) => {
                terms.push(last);
                Self::Sum(terms)
            }
        }
    }

    /// Direct subformulas.
    pub fn parts(&self) -> Vec<&Formula> {
        match self {
            Self::Number(_) | Self::Measured(..) | Self::Name(_) | Self::Entry(..) => Vec::new(),
            Self::Call(_, parts) | Self::Product(parts) => parts.iter().collect(),
            Self::Neg(a) => vec![a],
            Self::Sum(terms) => terms.iter().map(|term| &term.formula).collect(),
            Self::Quotient(a, b) | Self::Power(a, b) => vec![a, b],
        }
    }

    /// Names that occur anywhere in the formula.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        let mut left = vec![self];
        std::iter::from_fn(move || {
            while let Some(formula) = left.pop() {
                if let Self::Name(name) = formula {
                    return Some(name.as_str());
                }
                left.extend(formula.parts());
            }
            None
        })
    }

    /// Quantities defined elsewhere: names, and rates such as `dot(theta)`.
    pub(crate) fn mentions(&self) -> Vec<String> {
        match self {
            Self::Name(name) => vec![name.clone()],
            Self::Call(function, _) if function == "dot" => vec![self.to_string()],
            _ => self.parts().into_iter().flat_map(Self::mentions).collect(),
        }
    }
}

impl Definition {
    /// The left side: a name or a rate.
    pub fn left(&self) -> Formula {
        let rate = self.name.strip_prefix("dot(").and_then(|name| name.strip_suffix(')'));
        rate.map_or_else(|| Formula::name(&self.name), Formula::rate)
    }
}
