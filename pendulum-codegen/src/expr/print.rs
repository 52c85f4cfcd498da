//! Expressions as text, as a person would write them: flat sums and products, numbers and parameters first.

use std::collections::HashMap;

use num_traits::{One, Signed};

use super::{Binary, ExprId, Graph, Node, Precedence, Rational, Unary, ratio};

/// Prints expressions; some may have been given names.
#[derive(Debug)]
pub struct Printer<'g> {
    graph: &'g Graph,
    names: HashMap<ExprId, String>,
}

impl<'g> Printer<'g> {
    /// A printer in which no expression but the symbols has a name.
    pub fn new(graph: &'g Graph) -> Self {
        Self {
            graph,
            names: HashMap::new(),
        }
    }

    /// Prints `x` under a name from now on.
    pub fn name(&mut self, x: ExprId, name: String) {
        self.names.insert(x, name);
    }

    /// The text of `x`.
    pub fn print(&self, x: ExprId) -> String {
        self.text(x).0
    }

    /// The text of `x` that stands behind its own name.
    pub fn definition(&self, x: ExprId) -> String {
        self.unnamed(x).0
    }

    fn text(&self, x: ExprId) -> (String, Precedence) {
        match self.names.get(&x) {
            Some(name) => (name.clone(), Precedence::Atom),
            None => self.unnamed(x),
        }
    }

    fn unnamed(&self, x: ExprId) -> (String, Precedence) {
        match self.graph.node(x) {
            Node::Number(n) => number(n),
            Node::Pi => ("pi".to_owned(), Precedence::Atom),
            Node::Symbol(s) => (self.graph.name_and_kind(*s).name.clone(), Precedence::Atom),
            Node::Binary(Binary::Add | Binary::Sub, ..) => self.sum(x),
            Node::Binary(Binary::Mul | Binary::Div, ..) | Node::Unary(Unary::Neg, _) => self.product(x),
            Node::Power(_, n) if !n.is_positive() || *n != ratio(1, 2) => self.product(x),
            Node::Power(a, _) => (format!("sqrt({})", self.print(*a)), Precedence::Atom),
            Node::Unary(op, a) => (format!("{}({})", op.spelling(), self.print(*a)), Precedence::Atom),
            Node::Binary(op, a, b) => (
                format!("{}({}, {})", op.spelling(), self.print(*a), self.print(*b)),
                Precedence::Atom,
            ),
        }
    }

    fn sum(&self, x: ExprId) -> (String, Precedence) {
        let mut terms = Vec::new();
        self.gather_terms(x, true, false, &mut terms);
        // a leading minus is easily overlooked
        terms.sort_by_key(|(negative, _)| *negative);
        let mut text = String::new();
        for (n, (negative, term)) in terms.into_iter().enumerate() {
            text.push_str(match (n, negative) {
                (0, false) => "",
                (0, true) => "-",
                (_, false) => " + ",
                (_, true) => " - ",
            });
            text.push_str(&term);
        }
        (text, Precedence::Sum)
    }

    fn gather_terms(&self, x: ExprId, top: bool, negative: bool, terms: &mut Vec<(bool, String)>) {
        if !top && self.names.contains_key(&x) {
            terms.push((negative, self.print(x)));
            return;
        }
        match *self.graph.node(x) {
            Node::Binary(op @ (Binary::Add | Binary::Sub), a, b) => {
                self.gather_terms(a, false, negative, terms);
                self.gather_terms(b, false, negative != (op == Binary::Sub), terms);
            }
            Node::Unary(Unary::Neg, a) => self.gather_terms(a, false, !negative, terms),
            _ => {
                let (text, _) = self.text(x);
                match text.strip_prefix('-') {
                    Some(positive) => terms.push((!negative, positive.to_owned())),
                    None => terms.push((negative, text)),
                }
            }
        }
    }

    fn product(&self, x: ExprId) -> (String, Precedence) {
        let mut factors = Vec::new();
        let negative = self.gather_factors(x, true, ratio(1, 1), &mut factors);
        // numbers, then parameters, then the state, each in the order of declaration
        factors.sort_by_key(|&(id, _)| (self.graph.as_number(id).is_none(), self.graph.level(id), id));
        let mut merged: Vec<(ExprId, Rational)> = Vec::new();
        for (id, power) in factors {
            match merged.last_mut() {
                Some((last, sum)) if *last == id => *sum += power,
                _ => merged.push((id, power)),
            }
        }
        let write = |list: Vec<(ExprId, Rational)>| {
            let mut texts: Vec<(String, Precedence)> =
                list.into_iter().map(|(id, power)| self.factor(id, &power)).collect();
            match texts.len() {
                0 => None,
                1 => texts.pop(),
                _ => {
                    let tight = |(text, grip)| {
                        if grip >= Precedence::Product {
                            text
                        } else {
                            format!("({text})")
                        }
                    };
                    Some((
                        texts.into_iter().map(tight).collect::<Vec<_>>().join("*"),
                        Precedence::Product,
                    ))
                }
            }
        };
        let (below, above): (Vec<_>, Vec<_>) = merged.into_iter().partition(|(_, power)| power.is_negative());
        let below = write(below.into_iter().map(|(id, power)| (id, -power)).collect());
        let (above, grip) = write(above).unwrap_or(("1".to_owned(), Precedence::Atom));
        let (text, grip) = match below {
            None => (above, grip),
            Some((below, below_grip)) => {
                let above = if grip >= Precedence::Product {
                    above
                } else {
                    format!("({above})")
                };
                let below = if below_grip > Precedence::Product {
                    below
                } else {
                    format!("({below})")
                };
                (format!("{above}/{below}"), Precedence::Product)
            }
        };
        match (negative, grip) {
            (false, _) => (text, grip),
            (true, Precedence::Sum) => (format!("-({text})"), Precedence::Sum),
            (true, _) => (format!("-{text}"), Precedence::Sum),
        }
    }

    fn gather_factors(&self, x: ExprId, top: bool, power: Rational, factors: &mut Vec<(ExprId, Rational)>) -> bool {
        if !top && self.names.contains_key(&x) {
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

    fn factor(&self, x: ExprId, power: &Rational) -> (String, Precedence) {
        if power.is_one() {
            return self.text(x);
        }
        if *power == ratio(1, 2) {
            return (format!("sqrt({})", self.print(x)), Precedence::Atom);
        }
        let (base, grip) = self.text(x);
        let base = if grip == Precedence::Atom {
            base
        } else {
            format!("({base})")
        };
        let (exponent, grip) = number(power);
        let exponent = if grip == Precedence::Atom {
            exponent
        } else {
            format!("({exponent})")
        };
        (format!("{base}^{exponent}"), Precedence::Power)
    }
}

/// Decimal where that is exact and short, a fraction elsewhere.
fn number(n: &Rational) -> (String, Precedence) {
    let sign = |grip| if n.is_negative() { Precedence::Sum } else { grip };
    if n.denom().is_one() {
        return (n.to_string(), sign(Precedence::Atom));
    }
    let decimal = format!("{:?}", super::eval::nearest_f64(n));
    let digits = decimal.split_once('.').map_or("", |(_, digits)| digits);
    let scale = num_traits::Pow::pow(&ratio(10, 1), digits.len());
    let exact = !decimal.contains('e') && (n * scale).is_integer() && decimal.len() <= 18;
    if exact {
        (decimal, sign(Precedence::Atom))
    } else {
        (n.to_string(), sign(Precedence::Product))
    }
}
