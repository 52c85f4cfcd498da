//! Units of FMI: a name, and powers of the base units.

use num_traits::ToPrimitive;

use crate::units::Unit;

/// Definition of a unit. `None` if the text is no unit with whole powers.
pub(super) fn definition(text: &str) -> Option<String> {
    let unit = Unit::of(text)?;
    let mut powers = String::new();
    for (name, power) in unit.dimension.powers() {
        let power = power.is_integer().then(|| power.to_i32()).flatten()?;
        powers += &format!(" {name}=\"{power}\"");
    }
    match radians(text) {
        0 => {}
        power => powers += &format!(" rad=\"{power}\""),
    }
    Some(format!("<Unit name=\"{text}\"><BaseUnit{powers}/></Unit>"))
}

/// Power of the radian, which has no dimension, in the text of a unit.
fn radians(text: &str) -> i32 {
    let power = |factor: &str| {
        let (name, power) = factor.split_once('^').unwrap_or((factor, "1"));
        power.parse::<i32>().ok().filter(|_| name == "rad").unwrap_or(0)
    };
    let product = |product: &str| {
        let mut factors = product.split('/').map(power);
        factors.next().unwrap_or(0) - factors.sum::<i32>()
    };
    text.split(' ').map(product).sum()
}

#[cfg(test)]
mod tests {
    use super::definition;

    #[test]
    fn units_have_powers_of_base_units() {
        for (text, powers) in [
            ("rad/s^2", " s=\"-2\" rad=\"1\""),
            ("N m/rad", " kg=\"1\" m=\"2\" s=\"-2\" rad=\"-1\""),
            ("ohm", " kg=\"1\" m=\"2\" s=\"-3\" A=\"-2\""),
            ("H", " kg=\"1\" m=\"2\" s=\"-2\" A=\"-2\""),
            ("F", " kg=\"-1\" m=\"-2\" s=\"4\" A=\"2\""),
            ("1", ""),
            ("m rad^-2/K", " m=\"1\" K=\"-1\" rad=\"-2\""),
        ] {
            let expected = format!("<Unit name=\"{text}\"><BaseUnit{powers}/></Unit>");
            assert_eq!(definition(text), Some(expected));
        }
        assert_eq!(definition("m^(1/2)"), None);
        assert_eq!(definition(""), None);
    }
}
