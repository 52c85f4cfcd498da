//! Normal form: two expressions are equal exactly if their normal forms print identically.

use super::{BUDGET, dynamics, formula, model, normal_text, numbers};
use crate::expr::{Graph, Normalizer, Printer, SymbolKind, TooLarge};
use crate::pass::{Operations, collect, share};

/// Scene that declares the symbols of the formulas: parameters a, b, c and coordinates x, y, z.
const SYMBOLS: &str = "pub Symbols {
    params { a: 1, b: 1, c: 1 }
    body p on ground { mass: a, com: [0, b, 0], joint: revolute(z), coordinate: x }
    body q on p { mass: c, com: [0, 1, 0], joint: revolute(z) at [0, 1, 0], coordinate: y }
    body r on q { mass: 1, com: [0, 1, 0], joint: revolute(z) at [0, 1, 0], coordinate: z }
}";

const EQUAL: [(&str, &str); 14] = [
    ("sin(x)^2 + cos(x)^2", "1"),
    ("(a + b)^2 - a^2 - b^2", "2*a*b"),
    ("sin(x + y)", "sin(x)*cos(y) + cos(x)*sin(y)"),
    ("cos(x - y)", "cos(y - x)"),
    ("cos(x)*cos(x + y) + sin(x)*sin(x + y)", "cos(y)"),
    ("sin(3*x)", "3*sin(x) - 4*sin(x)^3"),
    ("cos(x)^4", "1 - 2*sin(x)^2 + sin(x)^4"),
    ("sin(x + pi/2)", "cos(x)"),
    ("6^(1/2)*6^(1/2)*a", "6*a"),
    ("a/(b + c) - b/(b + c)", "(a - b)/(b + c)"),
    ("a*b/(a*c)", "b/c"),
    ("0.1 + 0.2 - 0.3", "0"),
    ("(a^2)^(1/2)*(a^2)^(1/2)", "a^2"),
    ("exp(a + b) - exp(b + a)", "0"),
];

const DIFFERENT: [(&str, &str); 5] = [
    ("sin(x)^2 - cos(x)^2", "1"),
    ("sin(x + y)", "sin(x) + sin(y)"),
    ("a*b", "a + b"),
    ("tanh(x)", "x"),
    ("0.1 + 0.2", "0.30000000000000001"),
];

#[test]
fn equal_expressions_print_the_same() {
    let graph = Graph::new();
    let model = model(&graph, SYMBOLS);
    for (left, right) in EQUAL {
        let (x, y) = (formula(&model, left), formula(&model, right));
        assert_eq!(normal_text(x), normal_text(y), "{left} and {right}");
    }
    for (left, right) in DIFFERENT {
        let (x, y) = (formula(&model, left), formula(&model, right));
        assert_ne!(normal_text(x), normal_text(y), "{left} and {right}");
    }
}

/// Normal form, collection of angles and sharing of common subexpressions preserve values.
#[test]
fn passes_do_not_change_values() {
    let g = &Graph::new();
    let (model, dynamics) = dynamics(g, SYMBOLS);
    let more = [
        "sin(x + y)*cos(x)*a - a*cos(x + y)*sin(x) + b*sin(x)^2*c - b*c + (a + b + c)*dot(x)/(a + cos(y))",
        "a*sin(x)*cos(y)*dot(z)^3 + a*cos(x)*sin(y)*dot(z)^3 - dot(z)/(2 + sin(x)^2) - (a + c + b)^(3/2)*x^-2",
    ];
    let mut originals = [
        dynamics.balance.mass_matrix.concat(),
        dynamics.balance.residual,
        vec![dynamics.lagrangian.kinetic],
    ]
    .concat();
    originals.extend(more.map(|text| formula(&model, text)));
    let mut normalizer = Normalizer::new(g, BUDGET);
    let mut rewritten = Vec::new();
    for &x in &originals {
        let normal = normalizer.normal(x).expect("small enough");
        rewritten.push(normalizer.to_expr(&normal));
        let collected = collect(&mut normalizer, &normal).expect("small enough");
        assert!(collected.len() <= normal.len());
        rewritten.push(normalizer.to_expr(&collected));
    }
    let plain = share(g, &rewritten, false);
    let shared = share(g, &rewritten, true);
    for shared in [&plain, &shared] {
        assert!(Operations::of(g, shared).weight() <= Operations::of(g, &rewritten).weight());
    }
    for seed in 0..20 {
        let mut next = numbers(31 * seed);
        let values: rustc_hash::FxHashMap<String, f64> =
            g.symbols().map(|s| (s.name.clone(), next().abs() + 0.1)).collect();
        let all = [&originals[..], &rewritten, &shared, &plain].concat();
        let all = g.evaluate(&all, |symbol| values[&symbol.name]);
        let (originals, rest) = all.split_at(originals.len());
        let (rewritten, rest) = rest.split_at(rewritten.len());
        let (shared, plain) = rest.split_at(rewritten.len());
        for (n, x) in originals.iter().enumerate() {
            for y in [rewritten, shared, plain]
                .into_iter()
                .flat_map(|list| [list[2 * n], list[2 * n + 1]])
            {
                assert!(
                    (x - y).abs() <= 1e-12 * x.abs().max(1.0),
                    "expression {n}: {x} became {y}"
                );
            }
        }
    }
}

#[test]
fn a_polynomial_beyond_the_budget_is_given_up() {
    let graph = Graph::new();
    let model = model(&graph, SYMBOLS);
    let x = formula(&model, "(a + b + c + x + y + z)^12");
    assert_eq!(Normalizer::new(&graph, 1000).normal(x), Err(TooLarge));
}

#[test]
fn powers_that_cancel_are_not_printed() {
    let graph = Graph::new();
    let [m, l] = ["m", "l"].map(|name| graph.symbol(name, SymbolKind::Parameter(0)));
    let text = Printer::new(&graph).print((m.powi(2) * l / m.powi(2) / l.powi(2)).id());
    assert_eq!(text, "1/l");
}
