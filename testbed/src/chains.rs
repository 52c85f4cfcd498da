//! Declarations of chains of any length; `generate` lists the code to generate.

/// Declares a chain of equal links with parallel revolute axes.
pub fn planar(n: usize, generate: &str) -> String {
    let bodies = (0..n).map(|k| {
        let (parent, at) = below(k, "[0, -1, 0]");
        format!("body b{k} on {parent}: link {{ joint: revolute(z) at {at}, coordinate: q{k}, friction: c }}")
    });
    format!(
        "pub Chain {{ params {{ g: m/s^2, m: kg, c: N m s }} gravity: [0, -g, 0], generate: [{generate}],
            shape link {{ mass: m, com: [0.02, -0.5, 0], inertia: 0.1 }} {} }}",
        bodies.collect::<String>()
    )
}

/// Declares a chain of bodies with arbitrary inertia, whose revolute axes alternate between z, y and x.
pub fn spatial(n: usize, generate: &str) -> String {
    let bodies = (0..n).map(|k| {
        let (parent, at) = below(k, "[0.1, 0.05, 0.3]");
        format!(
            "body b{k} on {parent} {{ mass: {}, com: [0.02, 0.01, 0.1], inertia: [0.1, 0.12, 0.05, 0.001, 0.002, 0.003],
                joint: revolute({}) at {at}, coordinate: q{k} }}",
            k + 1,
            ["z", "y", "x"][k % 3]
        )
    });
    format!(
        "pub Chain {{ gravity: [0, 0, -9.81], generate: [{generate}], {} }}",
        bodies.collect::<String>()
    )
}

fn below(k: usize, at: &str) -> (String, &str) {
    match k {
        0 => ("ground".to_owned(), "[0, 0, 0]"),
        _ => (format!("b{}", k - 1), at),
    }
}
