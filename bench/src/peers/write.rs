//! Output of the results as `peers.md`, `peers.json` and a chart.

use std::error::Error;
use std::path::{Path, PathBuf};

use super::candidate::{BATCH, BY_HAND, FUSED, Function, MODELS, OURS, Order, PLAIN};
use super::results::{Results, Row};
use crate::report::{count, list, number, table, write};
use crate::timing::Times;
use charts::bars::{Bar, Bars};
use charts::page::Picture;

/// Targets on Zen 3 with AVX2: maximum ratio of the time of the generated code in a plain build to the best generator.
/// It compares least times, which agree from run to run on a disturbed machine; medians do not.
const TARGETS: [(&str, Function, Order, f64); 10] = [
    ("eq22", Function::Rhs, Order::SideBySide, 0.45),
    ("eq22", Function::Rhs, Order::InSequence, 0.75),
    ("eq22", Function::Jacobian, Order::SideBySide, 0.62),
    ("ur5", Function::Rhs, Order::SideBySide, 0.45),
    ("ur5", Function::Jacobian, Order::SideBySide, 0.45),
    ("ur5", Function::Point, Order::SideBySide, 0.5),
    ("panda", Function::Rhs, Order::SideBySide, 0.55),
    ("panda", Function::Jacobian, Order::SideBySide, 0.55),
    ("xarm7", Function::Rhs, Order::SideBySide, 0.55),
    ("xarm7", Function::Jacobian, Order::SideBySide, 0.55),
];

/// Functions of each chart, side by side, and its file name.
const CHARTS: [(&[Function], &str); 2] = [
    (&[Function::Rhs, Function::Jacobian], "peers"),
    (&[Function::Point], "peers_point"),
];

/// The rows that compete for a function in one order.
struct Field<'a> {
    rows: Vec<&'a Row>,
}

impl<'a> Field<'a> {
    fn of(results: &'a Results, model: &str, function: Function, order: Order) -> Self {
        let wanted = |row: &&Row| row.model == model && row.function == function && row.order == order && !row.heat;
        Self {
            rows: results.rows.iter().filter(wanted).collect(),
        }
    }

    fn by(&self, peer: &str) -> Option<&'a Row> {
        self.rows.iter().copied().find(|row| row.peer == peer)
    }

    fn best_generator(&self) -> Option<&'a Row> {
        let rivals = self
            .rows
            .iter()
            .filter(|row| ![OURS, PLAIN, FUSED, BATCH, BY_HAND].contains(&&*row.peer));
        rivals
            .copied()
            .min_by(|a, b| a.times.least().total_cmp(&b.times.least()))
    }

    /// Ratio of the times of a build of the generated code to a row.
    fn ratio(&self, build: &str, row: &Row, of: fn(&Times, &Times) -> f64) -> Option<f64> {
        let ours = self.by(build).filter(|ours| ours.peer != row.peer)?;
        Some(of(&ours.times, &row.times))
    }
}

pub(crate) fn all(results: &Results, out: &Path) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let text = markdown(results);
    println!("\n{text}");
    let mut files = vec![
        write(out.join("peers.md"), &text)?,
        write(out.join("peers.json"), &serde_json::to_string(results)?)?,
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

fn summary(results: &Results) -> String {
    let mut rows = Vec::new();
    for (model, title) in MODELS {
        for &function in Function::of(model) {
            for order in Order::ALL {
                let field = Field::of(results, model, function, order);
                let Some(best) = field.best_generator() else { continue };
                let least = |row: Option<&Row>| number(row.map(|row| row.times.least()));
                let ratio = |build, of| field.ratio(build, best, of);
                let plain = ratio(PLAIN, Times::over_in_least);
                let target = TARGETS
                    .iter()
                    .find(|target| (target.0, target.1, target.2) == (model, function, order));
                rows.push(vec![
                    title.to_owned(),
                    function.title().to_owned(),
                    order.title().to_owned(),
                    count(field.by(OURS).and_then(|ours| ours.flops)),
                    format!("{}, {}", best.peer, best.form),
                    count(best.flops),
                    least(field.by(OURS)),
                    least(field.by(PLAIN)),
                    least(field.by(FUSED)),
                    least(field.by(BATCH)),
                    least(Some(best)),
                    number(ratio(OURS, Times::over)),
                    number(ratio(OURS, Times::over_in_least)),
                    number(ratio(PLAIN, Times::over)),
                    number(plain),
                    number(ratio(FUSED, Times::over_in_least)),
                    number(ratio(BATCH, Times::over_in_least)),
                    target.zip(plain).map_or(String::new(), |(&(.., target), reached)| {
                        let word = if reached <= target { "met" } else { "missed" };
                        format!("{target:.2}, {word}")
                    }),
                ]);
            }
        }
    }
    let head = [
        "model",
        "function",
        "states",
        "our operations",
        "best generator",
        "its operations",
        "our ns",
        "plain ns",
        "fused ns",
        "batch ns",
        "its ns",
        "ratio, median",
        "ratio of least",
        "plain, median",
        "plain, of least",
        "fused, of least",
        "batch, of least",
        "target",
    ];
    table(&head, 3, &rows)
}

fn best(results: &Results) -> String {
    let shown = |row: &&Row| !row.heat;
    let rows: Vec<Vec<String>> = results
        .rows
        .iter()
        .filter(shown)
        .map(|row| {
            let field = Field::of(results, &row.model, row.function, row.order);
            let without = |row: &Row| row.without.as_ref().map(Times::least);
            let ours = field.by(OURS).filter(|ours| ours.peer != row.peer);
            let ratio_without = ours.and_then(without).zip(without(row)).map(|(ours, its)| ours / its);
            let mut cells = cells(row);
            cells.extend([
                number(without(row)),
                number(row.sines.as_ref().map(Times::least)),
                number(field.ratio(OURS, row, Times::over)),
                number(field.ratio(OURS, row, Times::over_in_least)),
                number(field.ratio(PLAIN, row, Times::over)),
                number(field.ratio(PLAIN, row, Times::over_in_least)),
                number(ratio_without),
            ]);
            cells
        })
        .collect();
    let more = [
        "least without sine and cosine",
        "sine and cosine alone",
        "ratio, median of pairs",
        "ratio of least",
        "plain, median of pairs",
        "plain, of least",
        "ratio without",
    ];
    table(&[&HEAD[..], &more].concat(), 5, &rows)
}

/// Columns of a row on its own.
const HEAD: [&str; 10] = [
    "model",
    "function",
    "states",
    "by",
    "form",
    "operations",
    "divisions",
    "sine-cosine pairs",
    "least ns",
    "median ns",
];

fn cells(row: &Row) -> Vec<String> {
    vec![
        row.model.clone(),
        row.function.title().to_owned(),
        row.order.title().to_owned(),
        row.peer.clone(),
        row.form.clone(),
        count(row.flops),
        count(row.divisions),
        count(row.sine_cosine_pairs),
        number(Some(row.times.least())),
        number(Some(row.times.median())),
    ]
}

fn others(results: &Results) -> String {
    let rows: Vec<Vec<String>> = results.rows.iter().filter(|row| row.heat).map(cells).collect();
    table(&HEAD, 5, &rows)
}

fn chart(results: &Results, functions: &[Function]) -> Bars {
    let bar = |peer: &str, value: Option<f64>| Bar {
        label: match peer {
            OURS => "mechanism!",
            PLAIN => "plain build",
            FUSED => "fused",
            BATCH => "in batches",
            peer => peer,
        }
        .to_owned(),
        value,
        ours: [OURS, PLAIN, FUSED, BATCH].contains(&peer),
    };
    let field = |model: &str, function| Field::of(results, model, function, Order::SideBySide).rows;
    let panel = |model: &str, function| {
        let measured = field(model, function);
        let others = functions.iter().flat_map(|&function| field(model, function));
        let missing = others.filter(|row| measured.iter().all(|here| here.peer != row.peer));
        let bars = measured.iter().map(|row| bar(&row.peer, Some(row.times.least())));
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
