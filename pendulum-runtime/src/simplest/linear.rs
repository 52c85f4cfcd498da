//! Linear models about equilibria, as declarations of first-order states.

use std::f64::consts::TAU;
use std::fmt::Write;

use pendulum_core::stability::StabilityError;

use crate::error::Error;
use crate::model::Model;

/// Size below which a coordinate of an equilibrium, or a rate there, is zero.
const SMALL: f64 = 1e-10;

/// The equilibrium of a model that is nearest to each start, without repetition, or why there is none. Angles with a
/// period are taken near the start.
pub(super) fn equilibria(model: &Model, starts: &[Vec<f64>]) -> Result<Vec<Vec<f64>>, String> {
    if model.layout().quaternions().next().is_some() {
        return Err("there are no linear models of orientations yet".to_owned());
    }
    let (found, _) = model.equilibria(starts).map_err(|error| match error {
        Error::Stability(StabilityError::TimeDependent) => "the equations depend on time".to_owned(),
        error => error.in_one_line(),
    })?;
    let near = |x: &[f64], start: &[f64]| -> Vec<f64> {
        let turned = x.iter().zip(start).zip(model.components());
        turned
            .map(|((x, start), component)| match component.periodic {
                true => x + TAU * ((start - x) / TAU).round(),
                false => *x,
            })
            .map(|x| if x.abs() < SMALL { 0.0 } else { x })
            .collect()
    };
    let distance = |x: &[f64], start: &[f64]| x.iter().zip(start).map(|(x, start)| (x - start).powi(2)).sum::<f64>();
    let mut nearest: Vec<Vec<f64>> = Vec::new();
    for start in starts {
        let copies = found.iter().map(|own| near(&own.x, start));
        let first = copies.min_by(|a, b| distance(a, start).total_cmp(&distance(b, start)));
        nearest.extend(first.filter(|x| !nearest.contains(x)));
    }
    match nearest.is_empty() {
        true => Err("no equilibrium was found from the starts".to_owned()),
        false => Ok(nearest),
    }
}

/// Name of an equilibrium: its coordinates and first-order states.
pub(super) fn name(model: &Model, x: &[f64]) -> String {
    let rates = model.layout().slots.iter().flat_map(|slot| slot.rates.clone());
    let rates: Vec<usize> = rates.collect();
    let shown = x
        .iter()
        .zip(model.components())
        .enumerate()
        .filter(|(n, _)| !rates.contains(n));
    let shown: Vec<String> = shown
        .map(|(_, (x, component))| format!("{} = {}", component.name, (1e4 * x).round() / 1e4 + 0.0))
        .collect();
    shown.join(", ")
}

/// Declaration of a model that is linear about an equilibrium, with the outputs of these numbers.
pub(super) fn declaration(model: &Model, x: &[f64], outputs: &[usize]) -> Result<String, Error> {
    let mut names: Vec<String> = Vec::new();
    // those of the components, then those of the outputs
    let components = model.components().iter().map(|own| own.name.as_str());
    for name in components.chain(outputs.iter().map(|&n| model.outputs()[n])) {
        let plain = identifier(name);
        let mut longer = std::iter::successors(Some(plain), |name| Some(format!("{name}_")));
        names.extend(longer.find(|name| !names.contains(name)));
    }
    let (names, of_outputs) = names.split_at(model.components().len());
    let a = model.jacobian(0.0, x)?;
    let sum = |value: f64, slopes: Vec<f64>| {
        let largest = slopes.iter().fold(0.0, |largest: f64, slope| largest.max(slope.abs()));
        let mut text = String::new();
        if value != 0.0 {
            write!(text, "{value:?}").expect("memory");
        }
        for ((slope, name), x) in slopes.into_iter().zip(names).zip(x) {
            if slope.abs() <= 1e-14 * largest {
                continue;
            }
            let (sign, size) = if slope < 0.0 { ("-", -slope) } else { ("+", slope) };
            match (text.is_empty(), sign) {
                (true, "+") => {}
                (true, _) => text.push('-'),
                (false, _) => write!(text, " {sign} ").expect("memory"),
            }
            if size != 1.0 {
                write!(text, "{size:?}*").expect("memory");
            }
            match *x == 0.0 {
                true => text.push_str(name),
                false if *x < 0.0 => write!(text, "({name} + {:?})", -x).expect("memory"),
                false => write!(text, "({name} - {x:?})").expect("memory"),
            }
        }
        if text.is_empty() { "0".to_owned() } else { text }
    };
    let mut text = format!(
        "/// `{}`, linear about {}.\npub Linear {{\n    units: none,\n",
        model.name(),
        self::name(model, x)
    );
    for (n, name) in names.iter().enumerate() {
        // at an equilibrium the rates vanish
        let rate = sum(0.0, a.row(n).iter().copied().collect());
        writeln!(text, "    state {name} {{ rate: {rate} }}").expect("memory");
    }
    let values = model.outputs_at(0.0, x)?;
    let slopes = model.engine.output_slopes(x);
    for (&n, name) in outputs.iter().zip(of_outputs) {
        let output = sum(values[n], slopes.row(n).iter().copied().collect());
        writeln!(text, "    output {name}: {output},").expect("memory");
    }
    text.push_str("}\n");
    Ok(text)
}

/// A component as one word: `theta_rate` for `dot(theta)`.
fn identifier(name: &str) -> String {
    let word = match name.strip_prefix("dot(").and_then(|rest| rest.split_once(')')) {
        Some((of, part)) => format!("{of}_rate{part}"),
        None => name.to_owned(),
    };
    let plain = |c: char| if c.is_alphanumeric() { c } else { '_' };
    word.chars()
        .map(plain)
        .collect::<String>()
        .trim_end_matches('_')
        .to_owned()
}
