//! Output of the results as `peers.md`, `peers.json` and a chart.

use std::error::Error;
use std::path::{Path, PathBuf};

use super::candidate::{Function, MODELS, OURS};
use super::results::{Results, Row};
use crate::report::{count, list, number, table, write};
use charts::bars::{Bar, Bars};
use charts::page::Picture;

/// Name of hand-written code, which is shown but is no generator to compete with.
const BY_HAND: &str = "by hand";

/// Targets: maximum ratio of the time of the generated code to the best generator, and number of its additions and
/// multiplications.
const TARGETS: [(&str, Function, f64, Option<usize>); 7] = [
    ("eq22", Function::Rhs, 0.8, Some(33)),
    ("eq22", Function::Jacobian, 0.8, Some(95)),
    ("ur5", Function::Rhs, 0.6, Some(520)),
    ("ur5", Function::Jacobian, 0.6, Some(3500)),
    ("ur5", Function::Point, 0.5, None),
    ("panda", Function::Rhs, 0.65, Some(1200)),
    ("panda", Function::Jacobian, 0.65, Some(7000)),
];

/// Functions of each chart, side by side, and its file name.
const CHARTS: [(&[Function], &str); 2] = [
    (&[Function::Rhs, Function::Jacobian], "peers"),
    (&[Function::Point], "peers_point"),
];

pub(crate) fn all(results: &Results, out: &Path) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let text = markdown(results);
    println!("\n{text}");
    let mut files = vec![
        write(out.join("peers.md"), &text)?,
        write(out.join("peers.json"), &serde_json::to_string_pretty(results)?)?,
    ];
    for (functions, name) in CHARTS {
        files.extend(chart(results, functions).save(&out.join(name))?);
    }
    Ok(files)
}

fn markdown(results: &Results) -> String {
    let mut text = format!("# The generated code and its peers\n\n{}\n", list(&results.header));
    if !results.notes.is_empty() {
        text += &format!("Left out:\n\n{}\n", list(&results.notes));
    }
    text += "## Against the best generator\n\n";
    text += &summary(results);
    text += "\n## The best form of each\n\nNanoseconds for one evaluation; ratios are ours over theirs.\n\n";
    text += &best(results);
    text += "\n## The other forms\n\n";
    text += &others(results);
    text
}

fn of<'a>(results: &'a Results, model: &'a str, function: Function) -> impl Iterator<Item = &'a Row> {
    results
        .rows
        .iter()
        .filter(move |row| row.model == model && row.function == function && !row.heat)
}

fn summary(results: &Results) -> String {
    let mut rows = Vec::new();
    for (model, title) in MODELS {
        for &function in Function::of(model) {
            let Some((.., ratio, operations)) = TARGETS.iter().find(|(name, of, ..)| *name == model && *of == function)
            else {
                continue;
            };
            let Some(ours) = of(results, model, function).find(|row| row.peer == OURS) else {
                continue;
            };
            let rivals = of(results, model, function).filter(|row| row.peer != OURS && row.peer != BY_HAND);
            let best = rivals.min_by(|a, b| a.least.total_cmp(&b.least));
            rows.push(vec![
                title.to_owned(),
                function.title().to_owned(),
                best.map_or("none".to_owned(), |row| format!("{}, {}", row.peer, row.form)),
                count(ours.flops),
                count(*operations),
                count(best.and_then(|row| row.flops)),
                number(Some(ours.least)),
                number(best.map(|row| row.least)),
                number(best.and_then(|row| row.ratio)),
                number(best.and_then(|row| row.ratio_of_least)),
                number(best.and_then(|row| row.ratio_without)),
                best.and_then(|row| row.ratio).map_or(String::new(), |reached| {
                    let word = if reached <= *ratio { "met" } else { "missed" };
                    format!("{ratio:.2}, {word}")
                }),
            ]);
        }
    }
    let head = [
        "model",
        "function",
        "best generator",
        "our operations",
        "target",
        "its operations",
        "our ns",
        "its ns",
        "ratio, median of pairs",
        "ratio of least",
        "ratio without sine and cosine",
        "target",
    ];
    table(&head, 3, &rows)
}

fn best(results: &Results) -> String {
    let rows: Vec<Vec<String>> = results.rows.iter().filter(|row| !row.heat).map(cells).collect();
    let head = [
        "model",
        "function",
        "by",
        "form",
        "operations",
        "divisions",
        "sine-cosine pairs",
        "least ns",
        "median ns",
        "least without sine and cosine",
        "sine and cosine alone",
        "ratio, median of pairs",
        "ratio of least",
        "ratio without",
    ];
    table(&head, 4, &rows)
}

fn cells(row: &Row) -> Vec<String> {
    vec![
        row.model.clone(),
        row.function.title().to_owned(),
        row.peer.clone(),
        row.form.clone(),
        count(row.flops),
        count(row.divisions),
        count(row.sine_cosine_pairs),
        number(Some(row.least)),
        number(Some(row.median)),
        number(row.least_without),
        number(row.sines),
        number(row.ratio),
        number(row.ratio_of_least),
        number(row.ratio_without),
    ]
}

fn others(results: &Results) -> String {
    let rows: Vec<Vec<String>> = results
        .rows
        .iter()
        .filter(|row| row.heat)
        .map(|row| cells(row)[..9].to_vec())
        .collect();
    let head = [
        "model",
        "function",
        "by",
        "form",
        "operations",
        "divisions",
        "sine-cosine pairs",
        "least ns",
        "median ns",
    ];
    table(&head, 4, &rows)
}

fn chart(results: &Results, functions: &[Function]) -> Bars {
    let bar = |peer: &str, value: Option<f64>| Bar {
        label: if peer == OURS { "mechanism!" } else { peer }.to_owned(),
        value,
        ours: peer == OURS,
    };
    let panel = |model: &str, function| {
        let measured = || of(results, model, function);
        let others = functions.iter().flat_map(|&function| of(results, model, function));
        let missing = others.filter(|row| measured().all(|here| here.peer != row.peer));
        let bars = measured().map(|row| bar(&row.peer, Some(row.least)));
        bars.chain(missing.map(|row| bar(&row.peer, None))).collect()
    };
    Bars {
        title: "Time of one evaluation".to_owned(),
        subtitle: "Generated code and the best form of each peer, taken in turns; logarithmic axes".to_owned(),
        axis: "time (ns)".to_owned(),
        logarithmic: true,
        columns: functions.iter().map(|function| capital(function.title())).collect(),
        rows: MODELS
            .iter()
            .filter(|(model, _)| functions.iter().all(|function| Function::of(model).contains(function)))
            .map(|&(model, title)| {
                let panels = functions.iter().map(|&function| panel(model, function));
                (title.to_owned(), panels.collect())
            })
            .collect(),
    }
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters
        .next()
        .map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}
