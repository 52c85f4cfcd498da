//! The results as `peers.md`, `peers.json` and a chart.

use std::error::Error;
use std::path::{Path, PathBuf};

use super::candidate::{Function, MODELS, OURS};
use super::results::{Results, Row};
use crate::report::{count, list, number, table, write};
use charts::bars::{Bar, Bars};
use charts::page::Picture;

/// Code that was written by hand is shown, but is no generator to be faster than.
const BY_HAND: &str = "by hand";

/// What is aimed at: the generated code's time over that of the best generator, and its additions and multiplications.
const TARGETS: [(&str, f64, [usize; 2]); 3] = [
    ("eq22", 0.8, [33, 95]),
    ("ur5", 0.6, [520, 3500]),
    ("panda", 0.65, [1200, 7000]),
];

pub(crate) fn all(results: &Results, out: &Path) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let text = markdown(results);
    println!("\n{text}");
    let mut files = vec![
        write(out.join("peers.md"), &text)?,
        write(out.join("peers.json"), &serde_json::to_string_pretty(results)?)?,
    ];
    files.extend(chart(results).save(&out.join("peers"))?);
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
        let Some((_, ratio, operations)) = TARGETS.iter().find(|(name, ..)| *name == model) else {
            continue;
        };
        for (function, at) in [(Function::Rhs, 0), (Function::Jacobian, 1)] {
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
                operations[at].to_string(),
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

fn chart(results: &Results) -> Bars {
    let functions = [Function::Rhs, Function::Jacobian];
    let panel = |model: &str, function| {
        let bar = |row: &Row| Bar {
            label: if row.peer == OURS {
                "mechanism!".to_owned()
            } else {
                row.peer.clone()
            },
            value: row.least,
            ours: row.peer == OURS,
        };
        of(results, model, function).map(bar).collect()
    };
    Bars {
        title: "Time of one evaluation".to_owned(),
        subtitle: "The generated code and the best form of each peer, taken in turns; nanoseconds, logarithmic"
            .to_owned(),
        logarithmic: true,
        columns: functions.map(|function| capital(function.title())).to_vec(),
        rows: MODELS
            .iter()
            .map(|&(model, title)| {
                (
                    title.to_owned(),
                    functions.map(|function| panel(model, function)).into(),
                )
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
