//! Linear models about equilibria, as declarations of first-order states.

use std::f64::consts::TAU;
use std::fmt::Write;

use nalgebra::DMatrix;
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

/// Declaration of a model that is linear about an equilibrium, with the outputs of these numbers, and with the inputs
/// that act to first order.
pub(super) fn declaration(model: &Model, x: &[f64], outputs: &[usize]) -> Result<String, Error> {
    // about constants, also where inputs follow samples
    let names = model.inputs().iter().map(|own| own.name.as_str());
    let constants: Vec<_> = names.zip(model.inputs_now().iter().copied()).collect();
    let model = &model.with_inputs(&constants)?;
    let (a, b) = (model.jacobian(0.0, x)?, input_jacobian(model, x)?);
    let (a, b) = (without_noise(a), without_noise(b));
    let acting: Vec<usize> = (0..b.ncols()).filter(|&n| b.column(n).amax() > 0.0).collect();
    // those of the inputs come first, since questions name them
    let inputs = acting.iter().map(|&n| model.inputs()[n].name.as_str());
    let components = model.components().iter().map(|own| own.name.as_str());
    let declared = outputs.iter().map(|&n| model.outputs()[n]);
    let names = distinct(inputs.chain(components).chain(declared));
    let (of_inputs, names) = names.split_at(acting.len());
    let (of_components, of_outputs) = names.split_at(x.len());
    let values = acting.iter().map(|&n| model.inputs_now()[n]);
    let variables = of_components.iter().zip(x.iter().copied());
    let variables: Vec<(&String, f64)> = variables.chain(of_inputs.iter().zip(values)).collect();

    let mut text = format!(
        "/// `{}`, linear about {}.\npub Linear {{\n    units: none,\n",
        model.name(),
        self::name(model, x)
    );
    for name in of_inputs {
        writeln!(text, "    input {name},").expect("memory");
    }
    for (n, name) in of_components.iter().enumerate() {
        let of_inputs = acting.iter().map(|&input| b[(n, input)]);
        // at an equilibrium the rates vanish
        let rate = sum(0.0, a.row(n).iter().copied().chain(of_inputs), &variables);
        writeln!(text, "    state {name} {{ rate: {rate} }}").expect("memory");
    }
    let values = model.outputs_at(0.0, x)?;
    let slopes = without_noise(model.engine.output_slopes(x));
    for (&n, name) in outputs.iter().zip(of_outputs) {
        let output = sum(values[n], slopes.row(n).iter().copied(), &variables);
        writeln!(text, "    output {name}: {output},").expect("memory");
    }
    text.push_str("}\n");
    Ok(text)
}

/// Derivatives of the right-hand side by the inputs: a column for each, none without inputs.
fn input_jacobian(model: &Model, x: &[f64]) -> Result<DMatrix<f64>, Error> {
    if model.inputs().is_empty() {
        return Ok(DMatrix::zeros(x.len(), 0));
    }
    let mut results = model.evaluate("input_jacobian", 0.0, x, &[])?;
    Ok(results.swap_remove(0))
}

/// Replaces rounding errors in each row by zeros.
fn without_noise(mut matrix: DMatrix<f64>) -> DMatrix<f64> {
    for mut row in matrix.row_iter_mut() {
        let largest = row.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
        row.iter_mut()
            .filter(|x| x.abs() <= 1e-14 * largest)
            .for_each(|x| *x = 0.0);
    }
    matrix
}

/// Names as words, each different from those before it.
fn distinct<'n>(all: impl Iterator<Item = &'n str>) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for name in all {
        let mut longer = std::iter::successors(Some(identifier(name)), |name| Some(format!("{name}_")));
        names.extend(longer.find(|name| !names.contains(name)));
    }
    names
}

/// Text of a linear function: its value at the values of the variables, and its slopes by them.
fn sum(value: f64, slopes: impl Iterator<Item = f64>, variables: &[(&String, f64)]) -> String {
    let mut text = String::new();
    if value != 0.0 {
        write!(text, "{value:?}").expect("memory");
    }
    for (slope, (name, x)) in slopes.zip(variables).filter(|(slope, _)| *slope != 0.0) {
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
