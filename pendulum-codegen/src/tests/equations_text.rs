//! The printed equations, parsed by the language's own parser and evaluated, equal the equations of motion.

use std::collections::{BTreeMap, BTreeSet};

use rustc_hash::FxHashMap;

use super::{dynamics, linkages, model, near};
use crate::ast::{Expr, ExprKind, Operator};
use crate::dynamics::Dynamics;
use crate::expr::{Definition, Formula, Graph, SymbolKind};
use crate::model::Model;
use crate::program::equations::equations;
use crate::program::{Equations, Extent, Listing};

/// Maximum length of the text for a chain of eight links, in bytes.
const PAGE: usize = 5_000;

const MAGNET: &str = "pub Magnet {
    params { m: kg, l: m, g: m/s^2, k: N m^3, a: m, h: m, gamma: N m s }
    gravity: [0, -g, 0],
    let dx = l*sin(th) - a,
    let dy = l + h - l*cos(th),
    let unused_by_the_torque = l/2,
    let r2 = dx^2 + dy^2,
    let pull = k/(r2*sqrt(r2)),
    body bob on ground {
        solids: [point(m, [0, -l, 0]), point(m, [0, -unused_by_the_torque, 0])],
        joint: revolute(z), coordinate: th, friction: gamma,
        torque: -pull*(dx*l*cos(q) + dy*l*sin(q)),
    }
}";

const CUBIC: &str = "pub Cubic {
    params { a: 1, k: N m }
    body b on ground { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th, torque: -k*(th - a)^3 }
}";

/// A torque on two absolute coordinates, and one that is shorter than its name.
const ABSOLUTE: &str = "pub Absolute {
    params { c: N m s, k: N m, u0: N m }
    input u: N m,
    gravity: [0, -9.81, 0],
    let stretch = q2 - q1 - 1/3,
    body upper on ground { mass: 2, com: [0, -1, 0], joint: revolute(z), coordinate: q1, friction: c, \
        torque: u0*sin(3*t) }
    body lower on upper {
        mass: 1, com: [0, -1, 0], joint: revolute(z) at [0, -1, 0], coordinate: q2 absolute, friction: c,
        torque: -k*stretch*(1 + stretch^2) - tanh(qd)/abs(q)^(1/2) + atan2(u, 2 + cos(q)),
    }
    body last on lower {
        mass: 1, com: [0, -1, 0], joint: revolute(-z) at [0, -1, 0], coordinate: q3 absolute, torque: u,
    }
}";

/// Drives, points by name in a torque and a force, and elements between points.
const ACTED: &str = "pub Acted {
    params { l: m, k: N/m, c: N s/m, w: rad/s }
    gravity: [0, -9.81, 0],
    point tip on lower at [0, -l, 0],
    point wall on ground at [2, 1, 0],
    let push = k*tip.x - c*tip.y^2,
    force q1: push*sin(t),
    force on tip: [c*dot(tip.x), 1, 0],
    spring between tip and wall: (k, l),
    damper between wall and tip: c,
    potential: k*tip.y^4,
    body pivot on ground { joint: prismatic(x), motion: l*cos(w*t) }
    body upper on pivot { mass: 2, com: [0, -1, 0], joint: revolute(z), coordinate: q1, torque: -k*tip.y }
    body lower on upper { mass: 1, com: [0, -1, 0], joint: revolute(z) at [0, -1, 0], coordinate: q2 absolute, \
        friction: c }
}";

/// A ball that carries an arm.
const BALL: &str = "pub Ball {
    params { m: kg, l: m, gamma: N m s }
    gravity: [0, 0, -9.81],
    potential: o.w^2,
    body bob on ground {
        mass: m, com: [0, 0, -l], inertia: [0.04, 0.07, 0.05], joint: ball, orientation: o, friction: gamma,
    }
    body arm on bob { mass: 1, com: [0, l, 0], inertia: [0.05, 0.05, 0.1], joint: revolute(z) at [0, 0, -l], \
        coordinate: q1 }
}";

/// Identical links on parallel joints. `absolute` is appended to the names of coordinates, and a letter in place of a
/// number is a parameter.
fn chain(n: usize, link: &str, mass: &str, length: &str, absolute: &str) -> String {
    let body = |k: usize| {
        let parent = if k == 0 {
            "ground".to_owned()
        } else {
            format!("b{}", k - 1)
        };
        let at = if k == 0 { "0".to_owned() } else { format!("-{length}") };
        format!("body b{k} on {parent}: link {{ joint: revolute(z) at [0, {at}, 0], coordinate: q{k} {absolute} }}")
    };
    let bodies: String = (0..n).map(body).collect();
    let params = [(mass, "kg"), (length, "m")]
        .into_iter()
        .filter(|(name, _)| name.parse::<f64>().is_err());
    let params: String = params.map(|(name, unit)| format!("{name}: {unit},")).collect();
    format!("pub Chain {{ params {{ {params} }} gravity: [0, -9.81, 0], shape link {{ {link} }} {bodies} }}")
}

/// Bodies of any shape on joints in all directions.
fn spatial(n: usize) -> String {
    let body = |k: usize| {
        let parent = if k == 0 {
            "ground".to_owned()
        } else {
            format!("b{}", k - 1)
        };
        let axis = ["z", "y", "x"][k % 3];
        format!(
            "body b{k} on {parent} {{ mass: {}, com: [0.02, 0.01, 0.1], inertia: [0.1, 0.12, 0.05, 0.001, 0.002, 0.003],
                joint: revolute({axis}) at [0.1, 0.05, 0.3], coordinate: q{k} }}",
            k + 1
        )
    };
    format!(
        "pub Arm {{ gravity: [0, 0, -9.81], {} }}",
        (0..n).map(body).collect::<String>()
    )
}

fn rods(mass: &str, length: &str, absolute: &str) -> String {
    let link = format!("solids: [rod({mass}, [0, 0, 0], [0, -{length}, 0])]");
    chain(8, &link, mass, length, absolute)
}

fn crooked(mass: &str, length: &str, absolute: &str) -> String {
    chain(
        8,
        &format!("mass: {mass}, com: [0.02, -0.5, 0], inertia: 0.1"),
        mass,
        length,
        absolute,
    )
}

/// Equations of a scene without its code, which takes far longer.
fn written<'g>(graph: &'g Graph, declaration: &str) -> (Model<'g>, Dynamics<'g>, Equations) {
    let (model, dynamics) = dynamics(graph, declaration);
    let recursive = Dynamics::recursive(&model, dynamics.lagrangian.potential, false);
    let equations = equations(
        &model,
        &dynamics.lagrangian.force,
        Extent::Full,
        (&recursive.balance, &recursive.lagrangian),
        None,
    );
    (model, dynamics, equations)
}

/// Lines `name = formula` by name. Entries become names: `A[x, y]` is `A__x__y`.
fn lines(text: &str) -> BTreeMap<String, Expr> {
    let whole = text.replace("\n    ", " ");
    let lines = whole
        .lines()
        .skip(1)
        .filter_map(|line| plain(line).split_once(" = ").map(|(l, r)| (l.to_owned(), r.to_owned())));
    lines
        .map(|(left, right)| {
            (
                left,
                syn::parse_str(&right).unwrap_or_else(|error| panic!("{right}: {error}")),
            )
        })
        .collect()
}

fn plain(line: &str) -> String {
    let (mut plain, mut inside) = (String::new(), false);
    for c in line.chars() {
        match c {
            '[' => (inside, plain) = (true, plain + "__"),
            ']' => inside = false,
            ',' if inside => plain.push_str("__"),
            ' ' if inside => {}
            '.' if inside => plain.push('_'),
            _ => plain.push(c),
        }
    }
    plain
}

/// Value of a formula whose names are numbers or other lines.
fn value(expr: &Expr, symbols: &FxHashMap<String, f64>, lines: &BTreeMap<String, Expr>) -> f64 {
    let of = |expr: &Expr| value(expr, symbols, lines);
    match &expr.kind {
        ExprKind::Number(n) => num_traits::ToPrimitive::to_f64(n).expect("a number"),
        ExprKind::Measured(..) => panic!("no unit is written in these"),
        ExprKind::Name(name) if name == "pi" => std::f64::consts::PI,
        ExprKind::Name(name) => match (symbols.get(&name.to_string()), lines.get(&name.to_string())) {
            (Some(value), _) => *value,
            (None, Some(line)) => of(line),
            // zero rows are not printed
            (None, None) => panic!("{name} stands for nothing"),
        },
        ExprKind::Call(function, arguments) => match (function.to_string().as_str(), &arguments[..]) {
            (
                "dot",
                [
                    Expr {
                        kind: ExprKind::Name(name),
                        ..
                    },
                ],
            ) => {
                let name = format!("dot({name})");
                lines.get(&name).map_or_else(|| symbols[&name], of)
            }
            ("sin", [x]) => of(x).sin(),
            ("cos", [x]) => of(x).cos(),
            ("sqrt", [x]) => of(x).sqrt(),
            ("tanh", [x]) => of(x).tanh(),
            ("abs", [x]) => of(x).abs(),
            ("atan2", [y, x]) => of(y).atan2(of(x)),
            (function, _) => panic!("{function}"),
        },
        ExprKind::Neg(a) => -of(a),
        ExprKind::Binary(Operator::Add, a, b) => of(a) + of(b),
        ExprKind::Binary(Operator::Sub, a, b) => of(a) - of(b),
        ExprKind::Binary(Operator::Mul, a, b) => of(a) * of(b),
        ExprKind::Binary(Operator::Div, a, b) => of(a) / of(b),
        ExprKind::Power(a, b) => of(a).powf(of(b)),
        ExprKind::Component(of_what, axis) => {
            let name = format!("{of_what}.{axis}");
            // component of a point, or of an orientation
            lines.get(&name).map_or_else(|| symbols[&name], of)
        }
        ExprKind::RateComponent(of_what, axis) => symbols[&format!("dot({of_what}).{axis}")],
    }
}

/// Asserts the properties of all equations, and returns their text.
fn checked(declaration: &str) -> String {
    let graph = Graph::new();
    let (model, dynamics, equations) = written(&graph, declaration);
    assert_true(declaration, &model, &dynamics, &equations);
    assert_ordered(&equations);
    assert_well_formed(&equations.latex());
    equations.to_string()
}

/// Asserts that every entry equals its value in the dynamics from A, B and C, near the assembled configuration.
fn assert_true(declaration: &str, model: &Model<'_>, dynamics: &Dynamics<'_>, equations: &Equations) {
    let g = model.graph;
    let mut next = 0.0_f64;
    let mut symbols: FxHashMap<String, f64> = g
        .symbols()
        .map(|symbol| {
            // quasi-random numbers: a Weyl sequence
            next += 0.618_033_988_749_895;
            let value = next.fract() * 2.0 - 1.0;
            let value = match (near(declaration, &symbol.name), symbol.kind) {
                (Some(near), _) => near + 0.01 * value,
                (None, SymbolKind::Parameter(n)) => model.parameters[n].default.unwrap_or(value.abs() + 0.5),
                (None, _) => value,
            };
            (symbol.name.clone(), value)
        })
        .collect();
    let dependents = model.loops.dependence.definitions();
    let dependents: BTreeSet<&str> = dependents
        .filter_map(|(symbol, _)| Some(symbol.as_symbol()?.name.as_str()))
        .collect();
    symbols.retain(|name, _| !dependents.contains(name.as_str()));
    let names = model.coordinate_names().into_iter().map(|name| name.replace('.', "_"));
    let names: Vec<String> = names.collect();
    let mut entries = Vec::new();
    for (i, first) in names.iter().enumerate() {
        for (j, second) in names.iter().enumerate().skip(i) {
            entries.push((format!("A__{first}__{second}"), dynamics.balance.mass_matrix[i][j]));
        }
        entries.push((format!("b__{first}"), dynamics.lagrangian.bias[i]));
        entries.push((format!("Q__{first}"), dynamics.lagrangian.force[i]));
    }
    let roots: Vec<_> = entries.iter().map(|(_, id)| *id).collect();
    let values = g.evaluate(&model.written_out(&roots), |symbol| symbols[&symbol.name]);
    for text in [format!("{equations}"), format!("{equations:#}")] {
        let lines = lines(&text);
        for ((name, _), expected) in entries.iter().zip(&values) {
            let printed = lines.get(name).map_or(0.0, |line| value(line, &symbols, &lines));
            assert!(
                (printed - expected).abs() <= 1e-9 * (1.0 + expected.abs()),
                "{name} is {expected}, not {printed}, in\n{text}"
            );
        }
    }
}

/// Asserts that every definition is used, and precedes its uses.
fn assert_ordered(equations: &Equations) {
    for Listing { rows, definitions } in [&equations.short, &equations.full] {
        let rows = rows.iter().map(|row| &row.formula);
        let formulas: Vec<&Formula> = rows
            .chain(definitions.iter().map(|definition| &definition.formula))
            .collect();
        for (n, Definition { name, formula }) in definitions.iter().enumerate() {
            let later = definitions[n..]
                .iter()
                .find(|later| formula.mentions().contains(&later.name));
            assert!(later.is_none(), "{name} uses {later:?} in\n{equations}");
            assert!(
                formulas.iter().any(|formula| formula.mentions().contains(name)),
                "{name} is unused"
            );
        }
    }
}

/// Asserts that braces and brackets are balanced, and that all commands are known.
fn assert_well_formed(latex: &str) {
    const KNOWN: [&str; 27] = [
        "[",
        "]",
        ",",
        "\\",
        "frac",
        "sqrt",
        "dot",
        "ddot",
        "left",
        "right",
        "bigl",
        "bigr",
        "mathrm",
        "operatorname",
        "sin",
        "cos",
        "tanh",
        "begin",
        "end",
        "quad",
        "qquad",
        "cdot",
        "gamma",
        "theta",
        "pi",
        "tan",
        "exp",
    ];
    let mut depth = 0_i32;
    for c in latex.chars() {
        depth += i32::from(c == '{') - i32::from(c == '}');
        assert!(depth >= 0, "{latex}");
    }
    assert_eq!(depth, 0, "{latex}");
    let mut counts: BTreeMap<&str, i32> = BTreeMap::new();
    for (at, _) in latex.match_indices('\\') {
        if latex[..at].ends_with('\\') && !latex[..at].ends_with("\\\\\\") {
            continue;
        }
        let rest = &latex[at + 1..];
        let letters = rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len());
        let command = &rest[..letters.max(1)];
        assert!(KNOWN.contains(&command), "\\{command} in {latex}");
        *counts.entry(command).or_default() += 1;
    }
    for (open, close) in [("left", "right"), ("bigl", "bigr"), ("begin", "end"), ("[", "]")] {
        assert_eq!(counts.get(open), counts.get(close), "\\{open} in {latex}");
    }
}

#[test]
fn what_is_printed_is_the_equation() {
    for declaration in [MAGNET, CUBIC, ABSOLUTE, ACTED, BALL, &spatial(3), &spatial(4)] {
        checked(declaration);
    }
}

/// Quantities determined by loops are defined in terms of the state, line by line.
#[test]
fn loops_in_closed_form_are_printed_with_all_that_they_determine() {
    let mut count = 0;
    for declaration in linkages::SCENES {
        if model(&Graph::new(), declaration).loops.closings.is_empty() {
            let text = checked(declaration);
            assert!([" 1*", "(1*", "*1*"].iter().all(|one| !text.contains(one)), "{text}");
            assert!(text.lines().all(|line| line.len() <= 120), "{text}");
            count += 1;
        }
    }
    assert!(count > 5, "{count}");
}

#[test]
fn chains_are_printed_on_a_page() {
    for absolute in ["", "absolute"] {
        for (mass, length) in [("1.5", "0.7"), ("m", "l")] {
            for declaration in [rods(mass, length, absolute), crooked(mass, length, absolute)] {
                let text = checked(&declaration);
                assert!(text.len() <= PAGE, "{} characters:\n{text}", text.len());
            }
        }
    }
}

/// Expanding a name would double the length each time.
#[test]
fn a_chain_of_names_keeps_names() {
    let lets: String = (1..=30)
        .map(|n| format!("let a{n} = a{0}*a{0} + sin(a{0}), ", n - 1))
        .collect();
    for law in ["potential: a30", "force th: a30"] {
        let scene = format!(
            "pub Chain {{ let a0 = th, {lets} {law}, generate: [rhs],
                body b on ground {{ mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: th }} }}"
        );
        let text = written(&Graph::new(), &scene).2.to_string();
        assert!(text.len() < 4_000, "{} characters", text.len());
    }
}

#[test]
fn a_law_of_six_lines_stays_six_lines() {
    let text = written(&Graph::new(), MAGNET).2.to_string();
    let (rows, definitions) = text.split_once("\nwhere\n").expect("definitions");
    assert!(
        rows.ends_with("Q[th] = -gamma*dot(th) - pull*(dx*l*cos(th) + dy*l*sin(th))\n"),
        "{text}"
    );
    let expected = "dx = l*sin(th) - a
dy = l + h - l*cos(th)
r2 = dx^2 + dy^2
pull = k/(r2*sqrt(r2))
";
    assert_eq!(definitions, expected);
    assert!(text.len() < 400, "{text}");
}

#[test]
fn powers_of_sums_stay() {
    let text = written(&Graph::new(), CUBIC).2.to_string();
    assert!(text.contains("Q[th] = -k*(th - a)^3\n"), "{text}");
    let full = format!("{:#}", written(&Graph::new(), CUBIC).2);
    assert!(full.contains("3*a*k*th^2"), "{full}");
}

#[test]
fn a_torque_on_several_coordinates_has_a_name() {
    let text = written(&Graph::new(), ABSOLUTE).2.to_string();
    assert!(
        text.contains("Q[q1] = c*dot(q2) - 2*c*dot(q1) + u0*sin(3*t) - torque_lower\n"),
        "{text}"
    );
    assert!(
        text.contains("Q[q2] = c*dot(q1) - c*dot(q2) + torque_lower + u\n"),
        "{text}"
    );
    assert!(text.contains("Q[q3] = u\n"), "{text}");
    let law = "stretch = q2 - q1 - 1/3
torque_lower = -k*stretch*(1 + stretch^2) - tanh(dot(q2) - dot(q1))/abs(q2 - q1)^(1/2) + atan2(u, 2 + cos(q2 - q1))
";
    assert!(text.ends_with(law), "{text}");
}

/// Names that the declaration uses for something else are not reused.
#[test]
fn names_do_not_clash() {
    let declaration = chain(5, "mass: s1, com: [t0, -w2, 0]", "s1", "w2", "").replace("s1: kg", "s1: kg, t0: m");
    let graph = Graph::new();
    let (model, dynamics, equations) = written(&graph, &declaration);
    let own: BTreeSet<&str> = model.parameters.iter().map(|p| p.name.as_str()).collect();
    let definitions = &equations.short.definitions;
    assert!(definitions.len() > 10, "{equations}");
    let distinct: BTreeSet<&str> = definitions.iter().map(|definition| definition.name.as_str()).collect();
    assert_eq!(distinct.len(), definitions.len());
    assert!(distinct.is_disjoint(&own), "{equations}");
    assert_true(&declaration, &model, &dynamics, &equations);
}

#[test]
fn latex_names_are_letters_with_indices() {
    let declaration = "pub Pendulum {
        params { m: kg, l_max: m, gamma2: N m s, inertia: kg m^2 }
        gravity: [0, -9.81, 0],
        body b on ground {
            mass: m, com: [0, -l_max, 0], inertia: inertia, joint: revolute(z), coordinate: theta1, friction: gamma2,
            torque: -sin(theta1)*m*(1/2) + qd^2/m,
        }
    }";
    let latex = written(&Graph::new(), declaration).2.latex();
    let expected = [
        "A_{\\theta_{1},\\,\\theta_{1}} = \\mathrm{inertia} + m\\,l_{\\mathrm{max}}^{2}",
        "b_{\\theta_{1}} = 9.81\\,m\\,l_{\\mathrm{max}}\\,\\sin \\theta_{1}",
        "Q_{\\theta_{1}} = -\\gamma_{2}\\,\\dot{\\theta}_{1} - \\sin(\\theta_{1})\\,m\\,\\frac{1}{2} \
            + \\frac{\\dot{\\theta}_{1}^{2}}{m}",
    ];
    for row in expected {
        assert!(latex.contains(row), "{row} in\n{latex}");
    }
}
