//! Unit tests of the generator, and helpers shared by several of them.

mod base_parameters;
mod coefficients;
mod equations;
mod equations_text;
mod floating;
mod forms;
mod gallery;
mod limits;
mod linkages;
mod normal_form;
mod places;
mod robots;
mod solids;
mod units;
mod wanted;

use crate::ast::{self, ExprKind, Operator};
use crate::dynamics::Dynamics;
use crate::error::Errors;
use crate::expr::{Expr, Graph, Normalizer, Printer, Unary};
use crate::lower::lower;
use crate::model::Model;
use crate::parse::parse;

/// Budget of normal forms, in products of terms: more than any test needs.
const BUDGET: usize = 10_000_000;

/// True if all cases run rather than a share of them, like `testbed::random::share` for other packages.
fn is_thorough() -> bool {
    std::env::var_os("PENDULUM_THOROUGH").is_some()
}

/// Model of a declaration without units, which do not matter to its algebra.
fn model<'g>(graph: &'g Graph, declaration: &str) -> Model<'g> {
    with_units(graph, &declaration.replacen('{', "{ units: none,", 1))
}

/// Model of a declaration.
fn with_units<'g>(graph: &'g Graph, declaration: &str) -> Model<'g> {
    let tokens = declaration.parse().expect("the declaration is made of tokens");
    let (scene, errors) = parse(tokens);
    let lowered = scene
        .ok_or(errors)
        .and_then(|scene| lower(graph, &scene, Errors::default()));
    lowered.unwrap_or_else(|errors| panic!("{errors}")).model
}

/// Model of a declaration, and its dynamics from A, B and C.
fn dynamics<'g>(graph: &'g Graph, declaration: &str) -> (Model<'g>, Dynamics<'g>) {
    let model = model(graph, declaration);
    let dynamics = Dynamics::new(&model);
    (model, dynamics)
}

/// Expression of a hand-written formula in the symbols of a model.
fn formula<'g>(model: &Model<'g>, text: &str) -> Expr<'g> {
    let expr: ast::Expr = syn::parse_str(text).unwrap_or_else(|error| panic!("{text}: {error}"));
    read(model, &expr)
}

fn read<'g>(model: &Model<'g>, expr: &ast::Expr) -> Expr<'g> {
    match &expr.kind {
        ExprKind::Number(value) => model.graph.number(value.clone()),
        ExprKind::Measured(..) => panic!("formulas have plain numbers"),
        ExprKind::Name(name) if name == "pi" => model.graph.pi(),
        ExprKind::Name(name) => symbol(model, &name.to_string()),
        ExprKind::Component(point, axis) => symbol(model, &format!("{point}.{axis}")),
        ExprKind::RateComponent(of, axis) => symbol(model, &format!("dot({of}).{axis}")),
        ExprKind::Call(function, arguments) if function == "dot" => {
            let ExprKind::Name(name) = &arguments[0].kind else {
                panic!("dot of a name")
            };
            symbol(model, &format!("dot({name})"))
        }
        ExprKind::Call(function, arguments) if function == "sqrt" => read(model, &arguments[0]).sqrt(),
        ExprKind::Call(function, arguments) => {
            let op = Unary::ALL.iter().find(|op| function == op.spelling());
            read(model, &arguments[0]).apply(*op.expect("a known function"))
        }
        ExprKind::Neg(a) => -read(model, a),
        ExprKind::Binary(operator, a, b) => {
            let (a, b) = (read(model, a), read(model, b));
            match operator {
                Operator::Add => a + b,
                Operator::Sub => a - b,
                Operator::Mul => a * b,
                Operator::Div => a / b,
            }
        }
        ExprKind::Power(base, exponent) => {
            let (base, exponent) = (read(model, base), read(model, exponent));
            base.power(exponent.as_number().expect("a number").clone())
        }
    }
}

/// Symbol of a model by name.
fn symbol<'g>(model: &Model<'g>, name: &str) -> Expr<'g> {
    let parameters = model.parameters.iter().map(|p| (p.name.clone(), p.symbol));
    let coordinates = model
        .coordinates
        .iter()
        .flat_map(|c| [(c.name.clone(), c.position), (format!("dot({})", c.name), c.rate)]);
    let time = ("t".to_owned(), model.time);
    let found = parameters
        .chain(coordinates)
        .chain([time])
        .find(|(known, _)| known == name);
    found.unwrap_or_else(|| panic!("no symbol {name}")).1
}

/// Text of the normal form: equal for two expressions exactly if the expressions are equal.
fn normal_text(x: Expr<'_>) -> String {
    let mut normalizer = Normalizer::new(x.graph(), BUDGET);
    let normal = normalizer.normal(x).expect("small enough");
    Printer::new(x.graph()).print(normalizer.to_expr(&normal).id())
}

/// Asserts that an expression equals a formula in symbols.
fn assert_formula<'g>(model: &Model<'g>, what: &str, x: Expr<'g>, text: &str) {
    let difference = x - formula(model, text);
    assert_eq!(normal_text(difference), "0", "{what} is not {text}");
}

/// Quasi-random numbers: a Weyl sequence.
fn numbers(seed: u32) -> impl FnMut() -> f64 {
    let mut at = f64::from(seed);
    move || {
        at += 1.0;
        (at * 0.618_033_988_749_895).fract() * 2.0 - 1.0
    }
}

/// Guess of a coordinate in the declaration, after `near`.
fn near(text: &str, coordinate: &str) -> Option<f64> {
    let (_, after) = text.split_once(&format!("coordinate: {coordinate} "))?;
    let (_, number) = after.split([',', '}']).next()?.split_once("near ")?;
    Some(number.trim().parse().expect("a number"))
}
