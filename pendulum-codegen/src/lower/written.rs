//! Formulas of expressions as written, with their names and their form.

use crate::ast::{Expr, ExprKind, Operator};
use crate::expr::{Formula, Summand};

/// Formula of an expression as written in the declaration, with `q` and `qd` replaced by the position and the rate of
/// the joint.
pub(super) fn written(expr: &Expr, joint: Option<&[Formula; 2]>) -> Formula {
    let part = |expr: &Expr| written(expr, joint);
    let boxed = |expr: &Expr| Box::new(part(expr));
    match &expr.kind {
        ExprKind::Number(n) => Formula::Number(n.clone()),
        ExprKind::Measured(measured) => Formula::Measured(measured.digits.clone(), measured.unit.text.clone()),
        ExprKind::Name(name) => match (name.to_string().as_str(), joint) {
            ("q", Some([position, _])) => position.clone(),
            ("qd", Some([_, rate])) => rate.clone(),
            (name, _) => Formula::name(name),
        },
        ExprKind::Component(point, axis) => Formula::name(&format!("{point}.{axis}")),
        ExprKind::RateComponent(of, axis) => Formula::name(&format!("dot({of}).{axis}")),
        ExprKind::Call(function, arguments) => {
            Formula::Call(function.to_string(), arguments.iter().map(part).collect())
        }
        ExprKind::Neg(a) => Formula::Neg(boxed(a)),
        ExprKind::Binary(operator @ (Operator::Add | Operator::Sub), a, b) => {
            // sums associate to the left, and brackets on the right are kept
            let mut terms = part(a).into_terms(false);
            terms.push(Summand {
                negative: *operator == Operator::Sub,
                formula: part(b),
            });
            Formula::Sum(terms)
        }
        ExprKind::Binary(Operator::Mul, a, b) => {
            let mut factors = match part(a) {
                Formula::Product(factors) => factors,
                factor => vec![factor],
            };
            factors.push(part(b));
            Formula::Product(factors)
        }
        ExprKind::Binary(Operator::Div, a, b) => Formula::Quotient(boxed(a), boxed(b)),
        ExprKind::Power(base, exponent) => Formula::Power(boxed(base), boxed(exponent)),
    }
}
