//! Declarations at the limits of the language, and the growth of the work on them.

use super::{is_thorough, parse};
use crate::check::check;
use crate::dynamics::Dynamics;
use crate::error::Errors;
use crate::expr::{Graph, MOST_POWER, Unary, ratio};
use crate::lower::{Lowered, lower};
use crate::program::{Extent, Program};

/// Minimum stack size of the threads on which compilers expand macros, in bytes.
const STACK: usize = 8 << 20;

/// Program of a declaration without units, with the number of nodes built for it, or its errors.
fn expand(declaration: &str) -> Result<(Program, usize), String> {
    let declaration = declaration.replacen('{', "{ units: none,", 1);
    let tokens = declaration.parse().expect("the declaration is made of tokens");
    let graph = Graph::new();
    let (scene, errors) = parse(tokens);
    let Some(scene) = scene else {
        return Err(errors.to_string());
    };
    let Lowered { model, spans } = lower(&graph, &scene, errors).map_err(|errors| errors.to_string())?;
    let dynamics = Dynamics::new(&model);
    check(&model, &spans, &dynamics, Errors::default()).map_err(|errors| errors.to_string())?;
    let program = Program::new(&model, &dynamics, Extent::Full).map_err(|constant| constant.0)?;
    Ok((program, graph.len()))
}

/// Errors of a declaration. Empty if there are none.
fn errors(declaration: &str) -> String {
    expand(declaration).err().unwrap_or_default()
}

/// A pendulum with further items.
fn pendulum(items: &str) -> String {
    format!(
        "pub P {{ gravity: [0, -9.81, 0], {items}
        body b on ground {{ mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: theta }} }}"
    )
}

/// Named expressions `a1` to `an`, each made of the one before it. `a0` is `first`.
fn chain(n: usize, first: &str, step: &str) -> String {
    let next = |k: usize| format!("let a{} = {},", k + 1, step.replace('@', &format!("a{k}")));
    let steps: String = (0..n).map(next).collect();
    format!("let a0 = {first}, {steps}")
}

/// Errors of a declaration, found on a stack of the same size as in a compiler.
fn errors_on_stack(declaration: String) -> String {
    let thread = std::thread::Builder::new().stack_size(STACK);
    let run = thread.spawn(move || errors(&declaration)).expect("a thread");
    run.join().expect("no panic")
}

/// Checks a rejected declaration, and the last one allowed.
fn assert_limit(allowed: &str, refused: &str, message: &str) {
    let run = |declaration: &str| errors_on_stack(pendulum(declaration));
    assert_eq!(run(allowed), "");
    let found = run(refused);
    assert!(found.contains(message), "{message}: {found}");
}

#[test]
fn numbers_have_500_digits_and_lie_between_1e_300_and_1e300() {
    let of = |digits: usize| format!("output y: 0.{} * theta,", "3".repeat(digits - 1));
    assert_limit(&of(500), &of(501), "too many digits");
    let of = |number: &str| format!("output y: {number} * theta,");
    assert_limit(&of("1e300"), &of("1.01e300"), "out of range");
    assert_limit(&of("1e-300"), &of("0.99e-300"), "out of range");
    assert_limit(&of("0e999"), &of("1e2147483647"), "out of range");
    assert_limit(&of("0.01e302"), &of("1e-2147483648"), "out of range");
}

#[test]
fn powers_have_numerators_and_denominators_up_to_64() {
    let of = |power: &str| format!("output y: (1 + theta^2)^{power},");
    assert_limit(&of("64"), &of("65"), "an exponent in output `y` is 65");
    assert_limit(&of("(-64)"), &of("(-65)"), "is -65");
    assert_limit(&of("(1/64)"), &of("(1/65)"), "is 1/65");
}

#[test]
fn expressions_have_2000_tokens_and_100_levels() {
    let sum = |tokens: usize| {
        format!(
            "output y: {}theta,",
            "-".repeat(tokens % 2) + &"1+".repeat((tokens - 1) / 2)
        )
    };
    assert_limit(&sum(1999), &sum(2001), "too long");
    let signs = |count: usize| format!("output y: {}theta,", "-".repeat(count));
    assert_limit(&signs(1998), &signs(2001), "too long");
    let signs = "(----------------".repeat(95) + "theta" + &")".repeat(95);
    assert_limit(
        &format!("output y: {signs},"),
        "output y: 1 + ,",
        "expected an expression",
    );
    let nested = |levels: usize| format!("output y: {}theta{},", "(".repeat(levels), ")".repeat(levels));
    assert_limit(&nested(100), &nested(101), "nested too deep");
}

/// Attributes before the name of the scene, which no rule for expressions covers.
#[test]
fn brackets_before_the_name_of_the_scene_are_not_followed_down() {
    for attribute in ["#[x@]", "#[x = @]", "#@", "@"] {
        let brackets = "(".repeat(20_000) + &")".repeat(20_000);
        let before = attribute.replace('@', &brackets);
        let found = errors_on_stack(format!("{before} {}", pendulum("")));
        assert!(found.contains("brackets are nested too deeply"), "{attribute}: {found}");
    }
}

#[test]
fn operations_stand_up_to_1000_deep_in_one_another() {
    let ends = [
        "potential",
        "output y",
        "generate: [rhs, canonical, taylor], force theta",
    ];
    for end in &ends[..if is_thorough() { 3 } else { 1 }] {
        let of = |n| chain(n, "theta", "@ * theta + 1") + &format!("{end}: a{n},");
        assert_limit(&of(500), &of(501), "more than 1000 nested operations");
    }
    // more than 1000 that do not contain one another
    let count = if is_thorough() { 5000 } else { 1100 };
    let many: String = (0..count).map(|k| format!("let a{k} = theta + {k},")).collect();
    let list: Vec<String> = (0..count).map(|k| format!("a{k}")).collect();
    assert_eq!(
        errors(&pendulum(&format!(
            "{many} generate: [], output y: [{}],",
            list.join(", ")
        ))),
        ""
    );
}

#[test]
fn products_of_equal_factors_are_gathered_up_to_a_power() {
    let g = Graph::new();
    let x = g.symbol("x", crate::expr::SymbolKind::Coordinate(0));
    let high = x.powi(MOST_POWER);
    assert_eq!(x.powi(MOST_POWER - 1) * x, high);
    assert_eq!((high * x).length(), 1 + high.length() + x.length());
    assert_eq!(high.powi(2).operands().next(), Some(high));
    // the value is unchanged
    let value = g.evaluate(&[high.powi(2) * x, high / x], |_| 1.01);
    assert!((value[0] / 1.01_f64.powi(129) - 1.0).abs() < 1e-13, "{value:?}");
    assert!((value[1] / 1.01_f64.powi(63) - 1.0).abs() < 1e-13, "{value:?}");
}

#[test]
fn long_numbers_stay_operations_and_never_become_zero() {
    let g = Graph::new();
    let mut x = g.number(ratio(3, 1));
    for _ in 0..10 {
        x = x * x;
    }
    assert!(x.as_number().is_some(), "3^1024 has 1624 binary digits");
    let long = x * x;
    assert!(long.as_number().is_none() && long.constant().is_some());
    // a number differs from one more than itself, and their difference is not found to vanish
    let more = 1 + long;
    assert_ne!(long, more);
    assert!(!(more - long).is_zero());
    assert!((long - long).is_zero());
    let quarter = ratio(1, 4) * long;
    assert!(quarter.as_number().is_none() && !quarter.is_zero());
    assert!(long.apply(Unary::Abs).as_number().is_none());
}

/// True if all coordinates have inertia, for the text of the bodies.
fn has_inertia(items: &str) -> bool {
    let found = errors(&format!("pub P {{ {items} }}"));
    assert!(found.is_empty() || found.contains("has no inertia"), "{found}");
    found.is_empty()
}

#[test]
fn inertia_is_found_whatever_the_parameters_and_the_scales() {
    let two = |parameters: &str, at: &str, mass: &str, arm: &str| {
        format!(
            "params {{ {parameters} }}
            body a on ground {{ mass: {mass}, com: [0, -{arm}, 0], joint: revolute(z), coordinate: x1 }}
            body b on a {{ mass: {mass}, com: [0, -{arm}, 0], joint: revolute(z) at [0, {at}, 0], coordinate: x2 }}"
        )
    };
    // a root that is real only for some parameters
    assert!(has_inertia(&two("l: m = 5", "-sqrt(l - 2)", "1", "1")));
    assert!(has_inertia(&two("l: m = 5", "-ln(l - 4.5)", "1", "1")));
    assert!(has_inertia(&two("", "-1", "1e-300", "1e-300")));
    assert!(has_inertia(&two("", "-1", "1e30", "1e30")));
    assert!(has_inertia(&two("m: kg = 1", "-1", "m^64", "(m^64)^64")));
    // differences of roots, some of which vanish
    let arm = |arm: &str| {
        format!(
            "params {{ l: m = 1 }} body a on ground {{ mass: 1, com: [0, {arm}, 0], joint: revolute(z), \
                coordinate: x1 }}"
        )
    };
    assert!(!has_inertia(&arm("(l + 1)^2 - l^2 - 2*l - 1")));
    assert!(!has_inertia(&arm("sin(l + 1)^2 + cos(1 + l)^2 - 1")));
    assert!(!has_inertia(&arm("sin(2*l - 1) - sin(2*l)*cos(1) + cos(2*l)*sin(1)")));
    assert!(has_inertia(&arm("(l + 1)^2 - l^2 - 2*l - 1 + 1e-200")));
    assert!(has_inertia(&arm("sqrt(l^2) + l")));
    assert!(has_inertia(&arm("abs(l) + l")));
    assert!(has_inertia(&arm("tan(l) + exp(l) - tanh(l)")));
    // a mass on its own axis of rotation, below joints whose axes have square roots of one number or another
    for axis in ["[-1, -3, -2]", "[1, 1, 0]", "[1, 1, 1]", "[0, 1, 2]", "[1, 2, 4]"] {
        let on_axis = |com: &str| {
            format!(
                "body a on ground {{ mass: 1024, joint: prismatic({axis}), coordinate: x1 }}
                body b on a {{ mass: 128, com: [0, {com}, 0.1875], joint: revolute(z) at [0, -0.25, 0.8125], \
                    coordinate: x2 }}"
            )
        };
        assert!(!has_inertia(&on_axis("0")), "{axis}");
        assert!(has_inertia(&on_axis("1e-9")), "{axis}");
        let body = |com: &str| {
            format!(
                "body a on ground {{ mass: 8, com: {com}, joint: revolute({axis}) at [0.375, 0, -0.8125], \
                    coordinate: x1 }}"
            )
        };
        assert!(!has_inertia(&body("[0, 0, 0]")), "{axis}");
        assert!(has_inertia(&body("[0.1, 0, 0]")), "{axis}");
    }
    // different functions of one argument do not cancel
    assert!(has_inertia(&arm("exp(l) - atan2(6, l)")));
    assert!(has_inertia(&arm("exp(l) - atan2(l, 6)")));
    // two joints on one axis move one mass, which only elimination detects
    let shared = |at: &str| {
        format!(
            "body a on ground {{ joint: revolute(z), coordinate: x1 }}
            body b on a {{ mass: 1, com: [0.1, -0.3, 0], joint: revolute(z) at {at}, coordinate: x2 }}"
        )
    };
    assert!(!has_inertia(&shared("[0, 0, 0.7]")));
    assert!(has_inertia(&shared("[0, 0.001, 0.7]")));
}

/// A body whose mass is on the axis of its joint has no inertia, which matters if accelerations are requested.
#[test]
fn inertia_is_asked_for_where_accelerations_are() {
    let on_axis = |items: &str| {
        has_inertia(&format!(
            "{items} body a on ground {{ mass: 1, joint: revolute(z), coordinate: x1 }}"
        ))
    };
    assert!(!on_axis(""));
    assert!(!on_axis("generate: [shapes, energy],"));
    assert!(on_axis("generate: [shapes],"));
    assert!(on_axis("generate: [], output y: x1,"));
    assert!(!on_axis("generate: [], output y: dot(x1),"));
}

/// Many roots hardly ever all exist modulo a prime, but the last rows need few of them.
#[test]
fn inertia_of_the_last_joints_is_found_beside_many_roots() {
    let axes = ["[1, 1, 0]", "[1, 1, 1]", "[1, 2, 0]", "[1, 2, 3]", "[1, 3, 1]"];
    let mut bodies = String::from("body b0 on ground { mass: 1, joint: fixed } ");
    for (n, axis) in axes.into_iter().enumerate() {
        bodies += &format!(
            "body b{} on b{n} {{ mass: 1, com: [1, 2, -1], inertia: [1, 1, 1], joint: revolute({axis}) at [1, 0, 2], \
                coordinate: x{n} }} ",
            n + 1
        );
    }
    assert!(has_inertia(&format!("generate: [mass_matrix], {bodies}")));
    let last = "body last on b5 { mass: 1, joint: revolute([1, 0, 5]) at [0, 1, 0], coordinate: y }";
    assert!(!has_inertia(&format!("generate: [mass_matrix], {bodies} {last}")));
}

/// A parameter that occurs only in drives changes nothing but their forces.
#[test]
fn parameters_of_drives_matter_where_their_forces_are_generated() {
    let driven = |generate: &str| {
        errors(&format!(
            "pub P {{ params {{ k: 1 = 2 }} generate: [{generate}],
            body cart on ground {{ mass: 1, joint: prismatic(x), motion: sin(t) }}
            point end on cart, force on end: [k, 0, 0],
            body b on cart {{ mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: theta }} }}"
        ))
    };
    assert_eq!(driven("rhs, drive_forces"), "");
    assert!(driven("rhs, energy").contains("parameter `k` has no effect"));
}

/// Subject of a family of declarations, and its declaration of a given size.
type Family = (&'static str, Box<dyn Fn(usize) -> String>);

#[test]
fn work_grows_with_the_square_of_a_declaration_at_most() {
    let acting = |step: &'static str| move |n| pendulum(&(chain(n, "theta", step) + &format!("force theta: a{n},")));
    let of_mass = |step: &str, n| {
        let lets = chain(n, "m", step);
        format!(
            "pub P {{ params {{ m: kg = 0.9 }} gravity: [0, -9.81, 0], {lets}
            body b on ground {{ mass: a{n}, com: [0, -1, 0], joint: revolute(z), coordinate: theta }} }}"
        )
    };
    let families: Vec<Family> = vec![
        ("products of functions", Box::new(acting("sin(@)*cos(@)"))),
        ("squares", Box::new(acting("@*@"))),
        ("sums of squares", Box::new(acting("@*@ + @"))),
        ("powers", Box::new(acting("(@ + 1)^64"))),
        ("functions in functions", Box::new(acting("sin(@)"))),
        (
            "potentials",
            Box::new(|n| pendulum(&(chain(n, "theta", "@*@ + @") + &format!("potential: a{n},")))),
        ),
        (
            "outputs",
            Box::new(|n| pendulum(&(chain(n, "theta", "sin(@)*cos(@)") + &format!("output y: a{n},")))),
        ),
        ("masses", Box::new(move |n| of_mass("@^2 + m^2", n))),
        (
            "masses of functions",
            Box::new(move |n| of_mass("sin(@)*cos(@) + 1", n)),
        ),
        (
            "exact numbers",
            Box::new(|n| pendulum(&(chain(n, "0.5", "(@*@ + 0.2)/1.3") + &format!("output y: a{n}*theta,")))),
        ),
        ("fixed bodies", Box::new(|n| fixed(n / 2))),
    ];
    for (name, family) in families {
        let work = |n: usize| {
            let (program, nodes) = expand(&family(n)).unwrap_or_else(|errors| panic!("{name}: {errors}"));
            nodes + format!("{:#}{}", program.equations, program.equations).len()
        };
        // shorter chains are multiplied out where that helps, and may be longer than these
        let [first, second] = [12, 24].map(work);
        assert!(second <= 4 * first, "{name}: {first}, then {second}");
    }
}

/// A body that turns, followed by a row of fixed bodies, each turned relative to the last.
fn fixed(n: usize) -> String {
    let next = |k: usize| {
        format!(
            "body b{} on b{k} {{ mass: 0.1{k}, com: [0.0{k}, 0.02, 0.03], \
                inertia: [0.01, 0.02, 0.015, 0.001, 0.002, 0.0015],
                joint: fixed at [0.1{k}, 0.2, 0.3{k}] rpy [0.{k}1, -0.2{k}, 0.3{k}] }}",
            k + 1
        )
    };
    let others: String = (0..n).map(next).collect();
    format!(
        "pub F {{ gravity: [0, 0, -9.81],
        body b0 on ground {{ mass: 1, com: [0.1, 0.2, 0.3], joint: revolute(x) rpy [0.1, 0.2, 0.3], \
            coordinate: theta }} {others} }}"
    )
}

/// Scenes that would take minutes to expand are rejected at once, without a stand-in of their size.
#[test]
fn of_motions() {
    let chain = |count: usize| -> proc_macro2::TokenStream {
        let mut bodies = String::new();
        for n in 0..count {
            let parent = if n == 0 {
                "ground".to_owned()
            } else {
                format!("b{}", n - 1)
            };
            bodies += &format!("body b{n} on {parent} {{ mass: 1, joint: prismatic(x), coordinate: x{n} }}\n");
        }
        format!("pub Chain {{ generate: [rhs], {bodies} }}")
            .parse()
            .expect("tokens")
    };
    let errors = crate::program(chain(5000)).expect_err("too many").to_string();
    assert!(
        errors.contains("5000 bodies are declared, but at most 1000 are supported [M007]"),
        "{errors}"
    );
    let errors = crate::program(chain(129)).expect_err("too many").to_string();
    assert!(
        errors.contains("129 coordinates and motions are declared, but at most 128 are supported [M007]"),
        "{errors}"
    );
    assert!(!crate::expand(chain(129)).to_string().contains("struct Chain"));
}
