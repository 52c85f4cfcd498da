//! Blocks as C code.

use std::collections::BTreeSet;

use super::Scene;
use super::names::identifiers;
use super::template::lines;
use crate::expr::{Binary, Precedence, Unary};
use crate::program::{Block, Coefficient, Let, Local, MultiplyAdd, Signs, SinCos, Term, Variable};

/// Names of called functions, collected while their calls are written.
pub(super) type Calls = BTreeSet<String>;

/// C expression and its precedence.
pub(super) struct Piece(pub(super) String, Precedence);

impl Piece {
    /// Returns the expression, in parentheses if its precedence is below `least`.
    pub(super) fn within(&self, least: Precedence) -> String {
        let Self(text, precedence) = self;
        let (open, close) = if *precedence < least { ("(", ")") } else { ("", "") };
        format!("{open}{text}{close}")
    }
}

/// Literal that parses back to exactly the same value. Zeros have no sign, as in the Rust code.
pub(super) fn number(value: f64) -> String {
    format!("{:?}", value + 0.0)
}

/// Statements that store values in their places.
pub(super) fn statements(values: &[Piece], place: impl Fn(usize) -> String) -> String {
    let numbered = values.iter().enumerate();
    lines(numbered.map(|(n, Piece(value, _))| format!("{} = {value};", place(n))))
}

impl Scene<'_> {
    /// Name of a variable in generated code, and the expression it is copied from.
    pub(super) fn variable(&self, variable: Variable) -> (String, String) {
        let listed = |name: &str, n: usize, list: &str| (format!("{name}{n}"), format!("{list}[{n}]"));
        let (positions, rates, states) = (&self.positions, &self.rates, &self.states);
        let (inputs, parameters) = (&self.inputs, &self.parameters);
        match variable {
            Variable::State(n) if n < positions.len() => (format!("q_{}", positions[n]), format!("x[{n}]")),
            Variable::State(n) => {
                let n_rate = n - positions.len();
                let name = match rates.get(n_rate) {
                    Some(name) => format!("qd_{name}"),
                    None => format!("s_{}", states[n_rate - rates.len()]),
                };
                (name, format!("x[{n}]"))
            }
            Variable::Acceleration(n) => (format!("qdd_{}", rates[n]), format!("qdd[{n}]")),
            Variable::Weight(n) => listed("w", n, "weights"),
            Variable::Direction(n) => listed("d", n, "direction"),
            Variable::Time => ("t".to_owned(), "t".to_owned()),
            Variable::Input(n) => (format!("u_{}", inputs[n]), format!("u->{}", inputs[n])),
            Variable::Force(n) => listed("f", n, "forces"),
            Variable::Constant(n) => listed("k", n, "model->k"),
            Variable::Parameter(n) => (format!("p_{}", parameters[n]), format!("params->{}", parameters[n])),
            Variable::Given(_) | Variable::Factor(_) | Variable::Solved(_) => unreachable!("loops are unrolled"),
            Variable::Series(Coefficient::Side(_)) => unreachable!("derivatives of series are not printed"),
            Variable::Series(Coefficient::Order) => ("order_k".to_owned(), "(double)k".to_owned()),
            Variable::Series(Coefficient::OverOrder) => ("over_k".to_owned(), "1.0 / (double)k".to_owned()),
            Variable::Series(Coefficient::Time) => ("time_k".to_owned(), "k == 1 ? 1.0 : 0.0".to_owned()),
            Variable::Series(Coefficient::State(n)) => listed("x", n, "series[k]"),
            Variable::Series(Coefficient::Sum(n)) => listed("s", n, "sums"),
            Variable::Series(Coefficient::Kept(n)) => listed("h", n, "kept"),
            // forces are constant
            Variable::Series(Coefficient::Force(n)) => (format!("force{n}"), "0.0".to_owned()),
        }
    }

    /// Statements of a block, and its results. All variables are copied first, so results may be stored in their place.
    pub(super) fn code(&self, block: &Block, calls: &mut Calls) -> (String, Vec<Piece>) {
        self.written(block, calls, self.fused)
    }

    /// Like [`code`](Self::code), for what is computed once in plain arithmetic, as in Rust.
    pub(super) fn plain_code(&self, block: &Block, calls: &mut Calls) -> (String, Vec<Piece>) {
        self.written(block, calls, false)
    }

    fn written(&self, block: &Block, calls: &mut Calls, fused: bool) -> (String, Vec<Piece>) {
        let block = &*block.unrolled();
        let reads = block.reads().into_iter().filter(|read| *read != Variable::Time);
        let reads = reads.map(|read| self.variable(read));
        let reads = lines(reads.map(|(name, place)| format!("const double {name} = {place};")));
        let (scene, locals) = (self, identifiers(&block.names));
        let mut writer = Writer {
            scene,
            locals,
            calls,
            fused,
        };
        let code: String = block.lets.iter().map(|code| writer.statement(code)).collect();
        let results = block.results.iter().map(|term| writer.term(term)).collect();
        (reads + &code, results)
    }
}

struct Writer<'s> {
    scene: &'s Scene<'s>,
    /// Names of the values defined by statements.
    locals: Vec<String>,
    calls: &'s mut Calls,
    /// True if sums with a product are fused.
    fused: bool,
}

impl Writer<'_> {
    fn local(&self, local: Local) -> String {
        self.locals[local.index()].clone()
    }

    fn statement(&mut self, code: &Let) -> String {
        match code {
            Let::Value(of, term) => format!("const double {} = {};\n", self.local(*of), self.term(term).0),
            Let::SinCos(pairs) => pairs.iter().map(|pair| self.sine_and_cosine(pair)).collect(),
        }
    }

    fn sine_and_cosine(&mut self, pair: &SinCos) -> String {
        let needed = ["PENDULUM_SIN", "PENDULUM_COS", "Pendulum_pair"];
        self.calls.extend(needed.map(String::from));
        let function = if self.fused {
            "Pendulum_sincos_fused"
        } else {
            "Pendulum_sincos"
        };
        let call = self.call(function, &[&pair.angle]);
        let at = pair.sine.or(pair.cosine).map_or(0, Local::index);
        let value = |name, of| format!("const double {} = a{at}.{name};\n", self.local(of));
        let sine = pair.sine.map(|of| value("sin", of)).unwrap_or_default();
        let cosine = pair.cosine.map(|of| value("cos", of)).unwrap_or_default();
        format!("const Pendulum_pair a{at} = {call};\n{sine}{cosine}")
    }

    fn call(&mut self, function: &str, arguments: &[&Term]) -> String {
        self.calls.insert(function.to_owned());
        let arguments = arguments.iter().map(|term| self.term(term).0);
        format!("{function}({})", arguments.collect::<Vec<_>>().join(", "))
    }

    fn call_platform(&mut self, function: &str, arguments: &[&Term]) -> String {
        self.call(&format!("PENDULUM_{}", function.to_uppercase()), arguments)
    }

    fn term(&mut self, term: &Term) -> Piece {
        use Precedence::{Atom, Power, Product, Sum, Unary as Prefix};
        if let Some(fused) = term.multiply_add().filter(|_| self.fused) {
            return Piece(self.multiply_add(&fused), Atom);
        }
        let (text, precedence) = match term {
            Term::Number(value) => (number(*value), if *value < 0.0 { Prefix } else { Atom }),
            Term::Local(of) => (self.local(*of), Atom),
            Term::Read(variable) => (self.scene.variable(*variable).0, Atom),
            // not `--a`, which would be a decrement
            Term::Unary(Unary::Neg, a) => (format!("-{}", self.term(a).within(Power)), Prefix),
            Term::Unary(Unary::Abs, a) => (self.call("Pendulum_abs", &[a]), Atom),
            Term::Unary(Unary::Sign, a) => (self.call("Pendulum_signum", &[a]), Atom),
            Term::Unary(op, a) => (self.call_platform(op.spelling(), &[a]), Atom),
            Term::Binary(Binary::Atan2, a, b) => (self.call_platform("atan2", &[a, b]), Atom),
            Term::Binary(op @ (Binary::Max | Binary::Min), a, b) => {
                (self.call(&format!("Pendulum_{}", op.spelling()), &[a, b]), Atom)
            }
            Term::Binary(op, a, b) => {
                let (own, right) = match op {
                    Binary::Add | Binary::Sub => (Sum, Product),
                    _ => (Product, Prefix),
                };
                let (a, b) = (self.term(a).within(own), self.term(b).within(right));
                (format!("{a} {} {b}", op.spelling()), own)
            }
            Term::Sqrt(a) => (self.call_platform("sqrt", &[a]), Atom),
            Term::Power(a, exponent) => (self.call_platform("pow", &[a, &Term::Number(*exponent)]), Atom),
        };
        Piece(text, precedence)
    }

    /// Call of the fused operation. A negation is exact.
    fn multiply_add(&mut self, fused: &MultiplyAdd<'_>) -> String {
        let [a, b] = fused.factors.map(|factor| self.term(factor));
        let other = self.term(fused.other);
        let negated = |piece: &Piece| format!("-{}", piece.within(Precedence::Power));
        self.calls.insert("PENDULUM_FMA".to_owned());
        match fused.signs {
            Signs::Add => format!("PENDULUM_FMA({}, {}, {})", a.0, b.0, other.0),
            Signs::Subtract => format!("PENDULUM_FMA({}, {}, {})", a.0, b.0, negated(&other)),
            Signs::SubtractProduct => format!("PENDULUM_FMA({}, {}, {})", negated(&a), b.0, other.0),
        }
    }
}
