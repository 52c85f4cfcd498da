//! Units: parsing, printing, and exact conversion of numbers with units.

use super::*;
use crate::units::{Dimension, Power, Unit};

fn dimension(unit: &str) -> Dimension {
    Unit::of(unit).unwrap_or_else(|| panic!("{unit}")).dimension
}

/// Value of a number in the model.
fn value(graph: &Graph, number: &str) -> f64 {
    let body = "body cart on ground { mass: 1, joint: prismatic(x), coordinate: x }";
    let model = with_units(graph, &format!("pub Cart {{ output y: {number}, {body} }}"));
    model.outputs[0].values[0].constant().expect("a number")
}

#[test]
fn dimensions_are_written_as_the_language_reads_them() {
    let texts = [
        ("kg m^2/s^2", "N m"),
        ("N m s/rad", "N m s"),
        ("N m/rad s", "N m s"),
        ("N/m/s", "N/m/s"),
        ("kg/s", "N s/m"),
        ("J/s", "W"),
        ("kg*m^2", "kg m^2"),
        ("1/s", "1/s"),
        ("Pa", "N/m^2"),
        ("m s^-2", "m/s^2"),
        ("rad", "1"),
        ("W/A", "N m/s/A"),
        ("K", "K"),
    ];
    for (unit, text) in texts {
        assert_eq!(dimension(unit).to_string(), text, "{unit}");
        assert_eq!(dimension(text), dimension(unit), "{text}");
    }
    let half = Dimension::ONE.times(dimension("m"), Power::new(-3, 2));
    assert_eq!(half.map(|half| half.to_string()).as_deref(), Some("1/m^(3/2)"));
}

#[test]
fn powers_too_large_are_not_known() {
    let mut product = Some(dimension("m"));
    for _ in 0..6 {
        product = product.and_then(|product| Dimension::ONE.times(product, Power::from(64)));
    }
    assert_eq!(product, None);
}

#[test]
fn numbers_with_units_are_exact() {
    let graph = Graph::default();
    let pi = std::f64::consts::PI;
    let numbers = [
        ("250 g", 0.25),
        ("250g", 0.25),
        ("1.5 cm", 0.015),
        ("3 km/min", 50.0),
        ("90 deg", pi / 2.0),
        ("90deg^2", 90.0 * pi * pi / 32400.0),
        ("3 rpm", pi / 10.0),
        ("2 turn", 4.0 * pi),
        ("1 lbf", 4.4482216152605),
        ("-2 mm/ms^2 * 3", -6000.0),
        ("1e-3 kN m", 1.0),
        ("5 W/mA", 5000.0),
        ("7 ohm/V", 7.0),
        ("2 mH/uF", 2000.0),
        ("2 kg/m*4", 8.0),
    ];
    for (number, expected) in numbers {
        assert_eq!(
            value(&graph, &format!("10000 + {number}")),
            10000.0 + expected,
            "{number}"
        );
        // a number with a unit is the same node as its value in SI units
        assert_eq!(value(&graph, &format!("({number})/({number})")), 1.0);
    }
    let written = "pub Arm { body b on ground { mass: 1, joint: revolute(z) rpy [0, 90 deg, 0], coordinate: th,
        com: [25 cm, 0, 0], spring: (3 N m/deg, 30deg), torque: -0.2 N m s*qd } }";
    let in_si = "pub Arm { body b on ground { mass: 1, joint: revolute(z) rpy [0, pi/2, 0], coordinate: th,
        com: [0.25, 0, 0], spring: (540*pi^(-1), pi/6), torque: -0.2 N m s*qd } }";
    let [written, in_si] = [written, in_si].map(|text| {
        let model = with_units(&graph, text);
        let body = &model.bodies[0];
        format!(
            "{:?} {:?} {}",
            body.placement,
            body.inertia,
            Printer::new(&graph).print(body.force.id())
        )
    });
    assert_eq!(written, in_si);
}
