//! Model descriptions of FMUs. `pendulum-python/tests/test_fmu.py` checks them against the schema of FMI.

use std::collections::BTreeSet;

use pendulum_codegen::{Fmu, fmu};
use roxmltree::{Document, Node};

const NAMES: &str = "
    /// Is it \"well\" formed & <valid>?
    pub Names {
        params { time: s = 0.3, r#in: kg, k: N m/rad = 2 }
        input r#loop: N m,
        state i { unit: A, rate: 1 A/s*sin(t/time) }
        output s: [a, 2*dot(a), abs(b.x)^(1/2)],
        output turned: rotation(arm),
        event passes: b.x,
        point b on arm at [0, -1, 0],
        body arm on ground {
            mass: r#in, com: [0, -1, 0], joint: revolute(z), coordinate: a, spring: (k, 0), torque: r#loop,
        }
        body ball on arm { mass: 1, inertia: [1, 1, 1], joint: ball, orientation: o }
    }";

fn of(scene: &str) -> Fmu {
    let program = pendulum_codegen::program(scene.parse().expect("tokens"));
    fmu(&program.expect("no errors")).expect("an FMU")
}

fn variable<'d>(document: &'d Document<'_>, name: &str) -> Node<'d, 'd> {
    let mut variables = document.descendants().filter(|node| node.has_tag_name("Float64"));
    let found = variables.find(|node| node.attribute("name") == Some(name));
    found.unwrap_or_else(|| panic!("no {name}"))
}

#[test]
fn a_description_is_well_formed() {
    let fmu = of(NAMES);
    let document = Document::parse(&fmu.files[0].1).expect("XML");
    let root = document.root_element();
    assert_eq!(root.attribute("description"), Some("Is it \"well\" formed & <valid>?"));
    let variables = || document.descendants().filter(|node| node.has_tag_name("Float64"));
    for key in ["name", "valueReference"] {
        let values: BTreeSet<_> = variables().map(|node| node.attribute(key)).collect();
        assert_eq!(values.len(), variables().count(), "{key}");
    }
    let known: BTreeSet<_> = variables()
        .filter_map(|node| node.attribute("valueReference"))
        .collect();
    for node in document.descendants() {
        let of = ["valueReference", "dependencies", "derivative"].map(|key| node.attribute(key).unwrap_or_default());
        assert!(
            of.iter()
                .flat_map(|list| list.split_whitespace())
                .all(|one| known.contains(one)),
            "{node:?}"
        );
    }
    for (name, unit, start, causality) in [
        ("time", Some("s"), Some("0.3"), "parameter"),
        // the independent variable makes way for a parameter
        ("time_", Some("s"), None, "independent"),
        ("in", Some("kg"), Some("NaN"), "parameter"),
        ("k", Some("N m/rad"), Some("2.0"), "parameter"),
        ("loop", Some("N m"), Some("0.0"), "input"),
        ("der(a)", Some("rad/s"), Some("0.0"), "output"),
        ("der(a,2)", Some("rad/s^2"), None, "local"),
        ("o.w", Some("1"), Some("1.0"), "output"),
        ("der(o.w)", Some("1/s"), None, "local"),
        ("o.omega.x", Some("rad/s"), Some("0.0"), "output"),
        ("der(i)", Some("A/s"), None, "local"),
        ("s[1]", Some("1/s"), None, "output"),
        // FMI has no fractional powers of units
        ("s[2]", None, None, "output"),
        ("turned[0,2]", Some("1"), None, "output"),
    ] {
        let node = variable(&document, name);
        let found = (
            node.attribute("unit"),
            node.attribute("start"),
            node.attribute("causality"),
        );
        assert_eq!(found, (unit, start, Some(causality)), "{name}");
    }
}

#[test]
fn letters_beyond_ascii_are_flat_names() {
    let fmu = of("pub Greek { body b on ground { mass: 1, joint: prismatic(x), coordinate: ξ } }");
    let document = Document::parse(&fmu.files[0].1).expect("XML");
    assert_eq!(
        document.root_element().attribute("variableNamingConvention"),
        Some("flat")
    );
    variable(&document, "der(ξ,2)");
}

#[test]
fn no_scene_takes_the_name_of_a_file() {
    for name in ["Model", "Fmi3Model", "Instance", "Fmi3"] {
        let fmu = of(&format!(
            "pub {name} {{ body b on ground {{ mass: 1, joint: prismatic(x), coordinate: x }} }}"
        ));
        let paths: BTreeSet<&String> = fmu.files.iter().map(|(path, _)| path).collect();
        assert_eq!(paths.len(), fmu.files.len(), "{name}");
    }
}
