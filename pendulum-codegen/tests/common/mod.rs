//! What several tests of the generator share.
#![allow(
    dead_code,
    unreachable_pub,
    reason = "each test is a crate of its own and uses a part of this"
)]

use pendulum_codegen::ast::{Expr, ExprKind, Operator};
use pendulum_codegen::dynamics::Dynamics;
use pendulum_codegen::expr::{ExprId, Normalizer, Printer, Unary};
use pendulum_codegen::model::Model;

/// More than any test needs.
pub const BUDGET: usize = 10_000_000;

/// The model of a declaration, and its dynamics from A, B and C.
pub fn dynamics(declaration: &str) -> (Model, Dynamics) {
    let tokens = declaration.parse().expect("the declaration is made of tokens");
    let mut model = pendulum_codegen::model(tokens).unwrap_or_else(|errors| panic!("{errors}"));
    let dynamics = Dynamics::new(&mut model);
    (model, dynamics)
}

/// A formula written by hand, in the symbols of a model.
pub fn formula(model: &Model, text: &str) -> ExprId {
    let expr: Expr = syn::parse_str(text).unwrap_or_else(|error| panic!("{text}: {error}"));
    read(model, &expr)
}

fn read(model: &Model, expr: &Expr) -> ExprId {
    match &expr.kind {
        ExprKind::Number(value) => model.graph.number(value.clone()),
        ExprKind::Name(name) if name == "pi" => model.graph.pi(),
        ExprKind::Name(name) => symbol(model, &name.to_string()),
        ExprKind::Call(function, arguments) if function == "dot" => {
            let ExprKind::Name(name) = &arguments[0].kind else {
                panic!("dot of a name")
            };
            symbol(model, &format!("dot({name})"))
        }
        ExprKind::Call(function, arguments) => {
            let argument = read(model, &arguments[0]);
            let op = Unary::ALL
                .iter()
                .find(|op| function == op.spelling())
                .expect("a known function");
            model.graph.unary(*op, argument)
        }
        ExprKind::Neg(a) => {
            let a = read(model, a);
            model.graph.neg(a)
        }
        ExprKind::Binary(operator, a, b) => {
            let (a, b) = (read(model, a), read(model, b));
            match operator {
                Operator::Add => model.graph.add(a, b),
                Operator::Sub => model.graph.sub(a, b),
                Operator::Mul => model.graph.mul(a, b),
                Operator::Div => model.graph.div(a, b),
            }
        }
        ExprKind::Power(base, exponent) => {
            let (base, exponent) = (read(model, base), read(model, exponent));
            let exponent = model.graph.as_number(exponent).expect("a number").clone();
            model.graph.power(base, exponent)
        }
    }
}

/// A symbol of a model by its name.
pub fn symbol(model: &Model, name: &str) -> ExprId {
    let parameters = model.parameters.iter().map(|p| (p.name.clone(), p.symbol));
    let coordinates = model
        .coordinates
        .iter()
        .flat_map(|c| [(c.name.clone(), c.position), (format!("dot({})", c.name), c.rate)]);
    let found = parameters.chain(coordinates).find(|(known, _)| known == name);
    found.unwrap_or_else(|| panic!("no symbol {name}")).1
}

/// The normal form as text: equal for two expressions exactly when they are equal.
pub fn normal_text(model: &Model, x: ExprId) -> String {
    let mut normalizer = Normalizer::new(BUDGET);
    let normal = normalizer.normal(&model.graph, x).expect("small enough");
    let x = normalizer.to_expr(&model.graph, &normal);
    Printer::new(&model.graph).print(x)
}

/// Asserts that an expression equals a formula in symbols.
pub fn assert_formula(model: &Model, what: &str, x: ExprId, text: &str) {
    let hand = formula(model, text);
    let difference = model.graph.sub(x, hand);
    assert_eq!(normal_text(model, difference), "0", "{what} is not {text}");
}

/// Numbers without a pattern: a Weyl sequence.
pub fn numbers(seed: u32) -> impl FnMut() -> f64 {
    let mut at = f64::from(seed);
    move || {
        at += 1.0;
        (at * 0.618_033_988_749_895).fract() * 2.0 - 1.0
    }
}
