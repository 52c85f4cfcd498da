//! Numeric evaluation of a program: every block statement by statement, as a printer would write it.

use pendulum_codegen::program::{Block, Coefficient, Let, Program, Shape, Term, Unary, Variable};
use pendulum_core::Real;

/// Program with values for its parameters.
pub(crate) struct Evaluator<'p> {
    program: &'p Program,
    constants: Vec<f64>,
    /// Kinetic friction of each constraint.
    friction: Vec<f64>,
}

/// Point of evaluation.
#[derive(Clone, Debug)]
pub(crate) struct Place {
    pub(crate) t: f64,
    /// Coordinates, then their rates.
    pub(crate) state: Vec<f64>,
    pub(crate) accelerations: Vec<f64>,
    pub(crate) inputs: Vec<f64>,
}

impl Place {
    /// All numbers in a row.
    pub(crate) fn numbers(&self) -> Vec<f64> {
        [&[self.t], &self.state[..], &self.accelerations, &self.inputs].concat()
    }
}

impl<'p> Evaluator<'p> {
    pub(crate) fn new(program: &'p Program, parameters: &[f64]) -> Self {
        let constants = values(&program.constants, |variable| match variable {
            Variable::Parameter(n) => parameters[n],
            other => panic!("a constant reads {other:?}"),
        });
        let numbers = values(&program.laws, |variable| match variable {
            Variable::Parameter(n) => parameters[n],
            Variable::Constant(n) => constants[n],
            other => panic!("a law reads {other:?}"),
        });
        let mut rest = numbers.iter();
        let friction = program.constraints.iter().map(|constraint| {
            let slipping = rest.next().copied().expect("a number");
            // static friction, the two numbers of impacts, and limits
            let others = 3 + usize::from(constraint.low) + usize::from(constraint.high);
            rest.nth(others - 1).expect("its other numbers");
            slipping
        });
        let friction = friction.collect();
        Self {
            program,
            constants,
            friction,
        }
    }

    /// Results of a routine, one list for each shape, with all entries of symmetric matrices.
    pub(crate) fn routine(&self, name: &str, place: &Place) -> Option<Vec<Vec<f64>>> {
        let routine = self.program.routine(name)?;
        let all = values(&routine.block, |variable| self.read(variable, place));
        let mut rest = &all[..];
        let results = routine.shapes.iter().map(|shape| {
            let (own, others) = rest.split_at(shape.len());
            rest = others;
            match *shape {
                Shape::Symmetric(n) => {
                    let at = |i: usize, j: usize| i * n - i * (i + 1) / 2 + j;
                    let entry = |k: usize| own[at((k / n).min(k % n), (k / n).max(k % n))];
                    (0..n * n).map(entry).collect()
                }
                _ => own.to_vec(),
            }
        });
        Some(results.collect())
    }

    /// Concatenated results of all routines.
    pub(crate) fn all(&self, place: &Place) -> Vec<f64> {
        let routines = self.program.routines.iter();
        let results = routines.flat_map(|routine| self.routine(&routine.name, place));
        results.flatten().flatten().collect()
    }

    /// Coefficients of the motion in powers of time, from the state on.
    pub(crate) fn series(&self, place: &Place, order: usize) -> Option<Vec<Vec<f64>>> {
        let series = self.program.series.as_ref()?;
        let (length, products) = (self.program.layout.len(), series.products);
        let start = values(&series.start, |variable| self.read(variable, place));
        let (first, kept) = start.split_at(length);
        let mut x = vec![place.state.clone(), first.to_vec()];
        let (mut left, mut right): (Vec<Vec<f64>>, Vec<Vec<f64>>) = (vec![Vec::new()], vec![Vec::new()]);
        for k in 1..order {
            let product = |m: usize, j: usize| left[j][m] * right[k - j][m];
            let sums: Vec<f64> = (0..products).map(|m| interior_sum(k, |j| product(m, j))).collect();
            let results = values(&series.order, |variable| match variable {
                Variable::Series(Coefficient::Order) => k as f64,
                Variable::Series(Coefficient::OverOrder) => 1.0 / k as f64,
                Variable::Series(Coefficient::Time) => f64::from(u8::from(k == 1)),
                Variable::Series(Coefficient::State(n)) => x[k][n],
                Variable::Series(Coefficient::Sum(n)) => sums[n],
                Variable::Series(Coefficient::Kept(n)) => kept[n],
                other => self.read(other, place),
            });
            let (rates, sides) = results.split_at(length);
            let over_next = 1.0 / (k + 1) as f64;
            x.push(rates.iter().map(|rate| rate * over_next).collect());
            left.push(sides[..products].to_vec());
            right.push(sides[products..].to_vec());
        }
        Some(x)
    }

    fn read(&self, variable: Variable, place: &Place) -> f64 {
        match variable {
            Variable::State(n) => place.state[n],
            Variable::Acceleration(n) => place.accelerations[n],
            Variable::Weight(n) => place.state[n],
            Variable::Direction(n) => place.numbers()[1 + n],
            Variable::Input(n) => place.inputs[n],
            Variable::Time => place.t,
            Variable::Constant(n) => self.constants[n],
            Variable::Force(n) => {
                let terms = self.program.constraints[n].rate.iter();
                let rate: f64 = terms.map(|&(n, sign)| f64::from(sign) * place.state[n]).sum();
                -self.friction[n] * Real::signum(rate)
            }
            other => panic!("a routine reads {other:?}"),
        }
    }
}

/// Sum of the products of order `k`, in the order of generated code: interior products with even and with odd numbers,
/// then the first and the last.
fn interior_sum(k: usize, product: impl Fn(usize) -> f64) -> f64 {
    let every_other = |first: usize| {
        (first..k.saturating_sub(1))
            .step_by(2)
            .fold(0.0, |sum, j| sum + product(j))
    };
    let middle = every_other(2) + every_other(3);
    match k {
        1 => middle,
        2 => middle + product(1),
        _ => middle + (product(1) + product(k - 1)),
    }
}

/// Results of a block.
fn values(block: &Block, read: impl Fn(Variable) -> f64) -> Vec<f64> {
    let mut locals = vec![f64::NAN; block.names.len()];
    for code in &block.lets {
        match code {
            Let::Value(local, term) => locals[local.index()] = value(term, &locals, &read),
            Let::SinCos(pairs) => {
                for pair in pairs {
                    let (sine, cosine) = Real::sin_cos(value(&pair.angle, &locals, &read));
                    pair.sine.iter().for_each(|local| locals[local.index()] = sine);
                    pair.cosine.iter().for_each(|local| locals[local.index()] = cosine);
                }
            }
        }
    }
    block.results.iter().map(|term| value(term, &locals, &read)).collect()
}

fn value(term: &Term, locals: &[f64], read: &impl Fn(Variable) -> f64) -> f64 {
    let of = |term: &Term| value(term, locals, read);
    match term {
        // printers write zeros without a sign
        Term::Number(number) => number + 0.0,
        Term::Local(local) => locals[local.index()],
        Term::Read(variable) => read(*variable),
        Term::Unary(Unary::Sign, a) => Real::signum(of(a)),
        Term::Unary(op, a) => op.value(of(a)),
        Term::Binary(op, a, b) => op.value(of(a), of(b)),
        Term::Sqrt(a) => of(a).sqrt(),
        Term::Power(a, exponent) => of(a).powf(*exponent),
    }
}
