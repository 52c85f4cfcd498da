//! Expressions as formulas in handwritten notation: flat sums and products, numbers and parameters first.

use num_traits::{One, Signed, ToPrimitive, Zero};
use rustc_hash::FxHashMap;

use super::formula::Summand;
use super::{Binary, ExprId, Formula, Graph, Node, Rational, SymbolKind, Unary, multiply, ratio};

/// Printer of expressions, some of which may have names.
#[derive(Debug)]
pub(crate) struct Printer<'g> {
    graph: &'g Graph,
    names: FxHashMap<ExprId, Formula>,
    /// Maximum number of operations of an expression written out; longer parts are replaced by dots.
    most: u64,
    /// If set, numbers are multiplied and added up.
    computes: bool,
}

/// Maximum number of operations of a constant written out; longer constants are written as numbers.
pub(crate) const LONGEST_CONSTANT: u64 = 100;

/// Maximum number of operations of a text that stands alone.
const LONGEST_TEXT: u64 = 1_000;

impl<'g> Printer<'g> {
    /// A printer in which only the symbols have names.
    pub(crate) fn new(graph: &'g Graph) -> Self {
        Self {
            graph,
            names: FxHashMap::default(),
            most: u64::MAX,
            computes: false,
        }
    }

    /// A printer that multiplies and adds up numbers: for display, not for output that documents a computation.
    pub(crate) fn that_computes(graph: &'g Graph) -> Self {
        Self {
            computes: true,
            ..Self::new(graph)
        }
    }

    /// Names `x` in all formulas printed from now on.
    pub(crate) fn name(&mut self, x: ExprId, name: Formula) {
        self.names.insert(x, name);
    }

    /// Text of `x`, with dots in place of parts that are too long.
    pub(crate) fn print(&self, x: ExprId) -> String {
        self.short(x).to_string()
    }

    /// Formula of `x`, with dots in place of parts that are too long.
    pub(crate) fn short(&self, x: ExprId) -> Formula {
        let short = Self {
            graph: self.graph,
            names: self.names.clone(),
            most: LONGEST_TEXT,
            computes: self.computes,
        };
        short.definition(x)
    }

    /// Formula of `x`: its name, if it has one.
    pub(crate) fn formula(&self, x: ExprId) -> Formula {
        self.stand_in(x).unwrap_or_else(|| self.definition(x))
    }

    /// Replacement of an expression: its name, the value of a long constant, or dots.
    fn stand_in(&self, x: ExprId) -> Option<Formula> {
        if let Some(name) = self.names.get(&x) {
            return Some(name.clone());
        }
        let length = self.graph.length(x);
        match self.graph.constant(x) {
            Some(value) if length > LONGEST_CONSTANT => Some(Formula::Name(format!("{value:?}"))),
            _ => (length > self.most).then(|| Formula::name("..")),
        }
    }

    /// Formula that the name of `x` stands for.
    pub(crate) fn definition(&self, x: ExprId) -> Formula {
        match self.graph.node(x) {
            Node::Number(n) => Formula::Number(n.clone()),
            Node::Pi => Formula::name("pi"),
            Node::Symbol(s) => {
                let symbol = self.graph.name_and_kind(*s);
                let of_rate = symbol.name.strip_prefix("dot(").and_then(|name| name.strip_suffix(')'));
                let of_force = symbol
                    .name
                    .strip_prefix("force(")
                    .and_then(|name| name.strip_suffix(')'));
                match (symbol.kind, of_rate.or(of_force)) {
                    (SymbolKind::Rate(_), Some(coordinate)) => Formula::rate(coordinate),
                    (SymbolKind::Force(_), Some(name)) => Formula::Call("force".to_owned(), vec![Formula::name(name)]),
                    _ => Formula::name(&symbol.name),
                }
            }
            Node::Binary(Binary::Add | Binary::Sub, ..) => self.sum(x),
            Node::Binary(Binary::Mul | Binary::Div, ..) | Node::Unary(Unary::Neg, _) => self.product(x),
            Node::Power(_, n) if !n.is_positive() || *n != ratio(1, 2) => self.product(x),
            Node::Power(a, _) => self.call("sqrt", &[*a]),
            Node::Unary(op, a) => self.call(op.spelling(), &[*a]),
            Node::Binary(op, a, b) => self.call(op.spelling(), &[*a, *b]),
        }
    }

    fn call(&self, function: &str, arguments: &[ExprId]) -> Formula {
        let arguments = arguments.iter().map(|&argument| self.formula(argument));
        Formula::Call(function.to_owned(), arguments.collect())
    }

    fn sum(&self, x: ExprId) -> Formula {
        let mut terms = Vec::new();
        self.gather_terms(x, true, false, &mut terms);
        let mut terms = if self.computes { with_one_number(terms) } else { terms };
        // a leading minus is easily overlooked
        terms.sort_by_key(|term| term.negative);
        Formula::sum(terms)
    }

    fn gather_terms(&self, x: ExprId, top: bool, negative: bool, terms: &mut Vec<Summand>) {
        let named = !top && self.stand_in(x).is_some();
        match *self.graph.node(x) {
            Node::Binary(op @ (Binary::Add | Binary::Sub), a, b) if !named => {
                self.gather_terms(a, false, negative, terms);
                self.gather_terms(b, false, negative != (op == Binary::Sub), terms);
            }
            Node::Unary(Unary::Neg, a) if !named => self.gather_terms(a, false, !negative, terms),
            _ => {
                let term = match self.formula(x) {
                    Formula::Neg(formula) => Summand {
                        negative: !negative,
                        formula: *formula,
                    },
                    Formula::Number(n) if n.is_negative() => Summand {
                        negative: !negative,
                        formula: Formula::Number(-n),
                    },
                    formula => Summand { negative, formula },
                };
                terms.push(term);
            }
        }
    }

    fn product(&self, x: ExprId) -> Formula {
        let mut factors = Vec::new();
        let mut negative = self.gather_factors(x, true, ratio(1, 1), &mut factors);
        // numbers, then parameters, then the state, each in the order of declaration
        factors.sort_by_key(|&(id, _)| (self.graph.as_number(id).is_none(), self.graph.level(id), id));
        let mut merged: Vec<(ExprId, Rational)> = Vec::new();
        for (id, power) in factors {
            match merged.last_mut() {
                Some((last, sum)) if *last == id => *sum += power,
                _ => merged.push((id, power)),
            }
        }
        merged.retain(|(_, power)| !power.is_zero());
        let number = if self.computes {
            self.take_number(&mut merged)
        } else {
            Rational::one()
        };
        negative ^= number.is_negative();
        let number = Some(number.abs())
            .filter(|number| !number.is_one())
            .map(Formula::Number);
        let (below, above): (Vec<_>, Vec<_>) = merged.into_iter().partition(|(_, power)| power.is_negative());
        let mut write = |number: Option<Formula>, list: Vec<(ExprId, Rational)>| {
            let factors = list.into_iter().map(|(id, power)| match self.factor(id, power.abs()) {
                Formula::Neg(factor) if self.computes => {
                    negative = !negative;
                    *factor
                }
                factor => factor,
            });
            Formula::product(number.into_iter().chain(factors).collect())
        };
        let above = write(number, above).unwrap_or(Formula::Number(Rational::one()));
        let product = match write(None, below) {
            None => above,
            Some(below) => Formula::Quotient(Box::new(above), Box::new(below)),
        };
        if negative {
            Formula::Neg(Box::new(product))
        } else {
            product
        }
    }

    /// Removes the numbers among the factors and returns their product.
    fn take_number(&self, factors: &mut Vec<(ExprId, Rational)>) -> Rational {
        let mut product = Rational::one();
        factors.retain(|(id, power)| {
            let power = power.to_i32().filter(|n| *n > 0 && power.is_integer());
            let (Some(number), Some(power)) = (self.graph.as_number(*id), power) else {
                return true;
            };
            product = multiply(&product, &number.pow(power));
            false
        });
        product
    }

    fn gather_factors(&self, x: ExprId, top: bool, power: Rational, factors: &mut Vec<(ExprId, Rational)>) -> bool {
        if !top && self.stand_in(x).is_some() {
            factors.push((x, power));
            return false;
        }
        match self.graph.node(x) {
            Node::Binary(Binary::Mul, a, b) => {
                let left = self.gather_factors(*a, false, power.clone(), factors);
                self.gather_factors(*b, false, power, factors) != left
            }
            Node::Binary(Binary::Div, a, b) => {
                let left = self.gather_factors(*a, false, power.clone(), factors);
                self.gather_factors(*b, false, -power, factors) != left
            }
            Node::Number(n) if (-n).is_one() && power.is_integer() => (power.to_integer() % 2i32) != 0.into(),
            Node::Unary(Unary::Neg, a) if power.is_integer() => {
                let odd = (power.to_integer() % 2i32) != 0.into();
                self.gather_factors(*a, false, power, factors) != odd
            }
            Node::Power(a, n) if *n != ratio(1, 2) => {
                factors.push((*a, n * power));
                false
            }
            _ => {
                factors.push((x, power));
                false
            }
        }
    }

    fn factor(&self, x: ExprId, power: Rational) -> Formula {
        if power.is_one() {
            return self.formula(x);
        }
        if power == ratio(1, 2) {
            return self.call("sqrt", &[x]);
        }
        Formula::Power(Box::new(self.formula(x)), Box::new(Formula::Number(power)))
    }
}

/// Adds up the numbers in a sum, in the place of the first.
fn with_one_number(terms: Vec<Summand>) -> Vec<Summand> {
    let value = |term: &Summand| match &term.formula {
        Formula::Number(n) if term.negative => Some(-n),
        Formula::Number(n) => Some(n.clone()),
        _ => None,
    };
    if terms.iter().filter_map(value).count() < 2 {
        return terms;
    }
    let mut sum = Some(terms.iter().filter_map(value).sum::<Rational>());
    let kept = terms.into_iter().filter_map(|term| match value(&term) {
        None => Some(term),
        Some(_) => sum.take().filter(|sum| !sum.is_zero()).map(|sum| Summand {
            negative: sum.is_negative(),
            formula: Formula::Number(sum.abs()),
        }),
    });
    kept.collect()
}
