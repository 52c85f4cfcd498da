//! Output of the results as `weights.md`, `weights.json` and a chart.

use std::error::Error;
use std::path::{Path, PathBuf};

use super::Results;
use super::insertions::PLACES;
use crate::report::{list, number, table, write};
use charts::bars::{Bar, Bars};
use charts::page::Picture;

/// Costs below this are noise, in nanoseconds.
const LEAST: f64 = 0.1;

pub(crate) fn all(results: &Results, out: &Path) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let text = markdown(results);
    println!("\n{text}");
    let mut files = vec![
        write(out.join("weights.md"), &text)?,
        write(out.join("weights.json"), &serde_json::to_string_pretty(results)?)?,
    ];
    files.extend(chart(results).save(&out.join("weights"))?);
    Ok(files)
}

fn markdown(results: &Results) -> String {
    format!(
        "# What operations take\n\n{}\n## Least squares\n\nIn units of an addition or multiplication of the same line; \
         in brackets what comes out when any one \
         model is left out.\n\n{}\n## One more operation\n\nIn units of an addition of the first line above: median \
         over four right-hand sides, least and \
         most in brackets.\n\n{}",
        list(&results.header),
        fits(results),
        insertions(results)
    )
}

fn fits(results: &Results) -> String {
    let weight = |value: f64, [low, high]: [f64; 2]| format!("{value:.1} [{low:.1}, {high:.1}]");
    let rows: Vec<Vec<String>> = results
        .fits
        .iter()
        .map(|fit| {
            vec![
                fit.mode.to_owned(),
                fit.functions.to_string(),
                format!("{:.3}", fit.addition),
                weight(fit.division.value, fit.division.range),
                weight(fit.sincos.value, fit.sincos.range),
                number(Some(fit.constant)),
                format!("{:.0} %", 100.0 * fit.error),
            ]
        })
        .collect();
    let head = [
        "functions",
        "how many",
        "ns of an addition",
        "division",
        "sine-cosine pair",
        "ns of a call",
        "error, root mean square",
    ];
    table(&head, 1, &rows)
}

fn insertions(results: &Results) -> String {
    let mut operations: Vec<&str> = results.insertions.iter().map(|insertion| insertion.operation).collect();
    operations.sort_unstable();
    operations.dedup();
    let rows: Vec<Vec<String>> = operations
        .iter()
        .map(|operation| {
            let cell = |(_, place): (&str, &str)| {
                let values = weights(results, operation, place);
                let (low, high) = (values.first(), values.last());
                match (middle(&values), low, high) {
                    (Some(middle), Some(low), Some(high)) => format!("{middle:.1} [{low:.1}, {high:.1}]"),
                    _ => String::new(),
                }
            };
            let cells = PLACES.map(cell);
            [vec![(*operation).to_owned()], cells.into()].concat()
        })
        .collect();
    table(&["operation", PLACES[0].1, PLACES[1].1, PLACES[2].1], 1, &rows)
}

/// Costs in ascending order.
fn weights(results: &Results, operation: &str, place: &str) -> Vec<f64> {
    let found = results
        .insertions
        .iter()
        .find(|insertion| insertion.operation == operation && insertion.place == place);
    let mut values = found.map_or(Vec::new(), |insertion| insertion.weights.clone());
    values.sort_by(f64::total_cmp);
    values
}

fn middle(values: &[f64]) -> Option<f64> {
    let half = values.len() / 2;
    match values.len() {
        0 => None,
        length if length % 2 == 0 => Some(0.5 * (values[half - 1] + values[half])),
        _ => Some(values[half]),
    }
}

fn chart(results: &Results) -> Bars {
    let operations = [
        ("division", "division"),
        ("sincos", "sine-cosine pair"),
        ("sqrt", "square root"),
        ("exp", "exponential"),
    ];
    let modes = ["in sequence", "side by side", "Jacobians"];
    let fitted = |operation: &str| {
        let bars = results.fits.iter().zip(modes).filter_map(|(fit, name)| {
            let weight = match operation {
                "division" => &fit.division,
                "sincos" => &fit.sincos,
                _ => return None,
            };
            Some(bar(name, weight.value))
        });
        bars.collect()
    };
    let places = ["on the path", "off the path", "side by side"];
    let inserted = |operation: &str| {
        let bars = PLACES.into_iter().zip(places).filter_map(|((_, place), name)| {
            let value = middle(&weights(results, operation, place))?;
            Some(bar(name, value))
        });
        bars.collect()
    };
    Bars {
        title: "What operations take, in additions".to_owned(),
        subtitle:
            "In generated functions, evaluated in sequence (with a critical path) or side by side; logarithmic axes"
                .to_owned(),
        axis: "time of an operation over that of an addition".to_owned(),
        logarithmic: true,
        columns: vec!["Least squares".to_owned(), "One operation more".to_owned()],
        rows: operations
            .map(|(name, title)| (title.to_owned(), vec![fitted(name), inserted(name)]))
            .into(),
    }
}

fn bar(label: &str, value: f64) -> Bar {
    Bar {
        label: label.to_owned(),
        value: Some(value.max(LEAST)),
        ours: true,
    }
}
