//! Output of the results as tables, JSON and charts.

use std::error::Error;
use std::path::{Path, PathBuf};

use charts::page::Picture;
use serde::Serialize;
use serde_json::{Value, json};
use twelve::{OURS, Problem};

use super::cells::{Cell, Fastest, LIMITS, TARGETS};
use super::chart::chart;
use super::measured::Measured;
use super::results::{Cost, Measure};
use super::sweep::Setting;
use crate::report::{list, number, table, write};

/// Results of all problems.
pub(crate) struct Results {
    pub header: Vec<String>,
    pub notes: Vec<String>,
    pub problems: Vec<Measured>,
}

pub(crate) fn all(results: &Results, out: &Path) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let text = markdown(results);
    println!("\n{text}");
    let mut files = vec![
        write(out.join("twelve.md"), &text)?,
        write(out.join("twelve.json"), &serde_json::to_string(&raw(results))?)?,
    ];
    for (name, problems) in GROUPS.into_iter().zip(results.problems.chunks(TOGETHER)) {
        files.extend(chart(name, problems, Cost::Time).save(&out.join(name))?);
        files.extend(chart(name, problems, Cost::Operations).save(&out.join(format!("{name}_operations")))?);
    }
    Ok(files)
}

/// Charts, each of the next problems.
const GROUPS: [&str; 4] = ["pendulum", "orbits", "stiff", "mechanisms"];
/// Number of problems in a chart.
const TOGETHER: usize = 3;

fn markdown(results: &Results) -> String {
    let mut text = format!("# Twelve problems\n\n{}\n", list(&results.header));
    if !results.notes.is_empty() {
        text += &format!("Left out:\n\n{}\n", list(&results.notes));
    }
    text += &format!("{}\n{}\n", summary(results), ratios(results));
    text += "Microseconds for a trajectory with the cheapest setting whose end has at most the relative \
             error.\n\n";
    for measured in &results.problems {
        let Problem { title, uncertainty, .. } = measured.problem;
        text += &format!(
            "## {title}\n\nUncertainty of the reference: {uncertainty:.0e}\n\n{}\n",
            times(measured)
        );
    }
    text
}

/// Numbers of cells, by both kinds of ratios and for both measures of the error.
fn summary(results: &Results) -> String {
    type Cells = fn(&Measured) -> &[Cell];
    type Ratio = fn(&Cell) -> f64;
    let kinds: [(&str, Cells, Ratio); 3] = [
        ("least times", |measured| &measured.cells, |cell| cell.ratio),
        ("medians of the rounds", |measured| &measured.cells, |cell| cell.paired),
        (
            "least times, errors over time",
            |measured| &measured.cells_along,
            |cell| cell.ratio,
        ),
    ];
    let row = |(name, cells, ratio): (&str, Cells, Ratio)| {
        let cells = || results.problems.iter().flat_map(cells);
        let count = |limit: f64| cells().filter(|cell| ratio(cell) <= limit).count();
        let share = |count: usize| format!("{count} ({:.0} %)", 100.0 * count as f64 / cells().count() as f64);
        let worst = cells().map(ratio).fold(0.0, f64::max);
        vec![
            name.to_owned(),
            cells().count().to_string(),
            share(count(1.0)),
            share(count(LIMITS[0])),
            share(count(LIMITS[1])),
            number(Some(worst)),
        ]
    };
    let head = [
        "ratios of",
        "cells",
        "first",
        "within 10 %",
        "within 1.5",
        "worst ratio",
    ];
    table(&head, 1, &kinds.map(row))
}

/// Our time over the time of the fastest peer, with both methods.
fn ratios(results: &Results) -> String {
    let name = |fastest: &Option<Fastest>| {
        fastest.as_ref().map_or("-".to_owned(), |fastest| match fastest.by {
            OURS => fastest.method.to_owned(),
            by => format!("{by} {}", fastest.method),
        })
    };
    let rows: Vec<Vec<String>> = results
        .problems
        .iter()
        .map(|measured| {
            let cell = |target: f64| {
                let found = measured.cells.iter().find(|cell| cell.target == target);
                found.map_or(String::new(), |cell| {
                    let ratio = match cell.ratio {
                        0.0 => "alone".to_owned(),
                        ratio if ratio.is_infinite() => "not reached".to_owned(),
                        ratio => number(Some(ratio)),
                    };
                    let ratio = if cell.ratio <= LIMITS[0] {
                        ratio
                    } else {
                        format!("**{ratio}**")
                    };
                    format!("{ratio}: {} / {}", name(&cell.ours), name(&cell.peer))
                })
            };
            [measured.problem.title.to_owned()]
                .into_iter()
                .chain(TARGETS.map(cell))
                .collect()
        })
        .collect();
    table(&head(&["our time over that of the fastest peer"]), 1, &rows)
}

/// Head of a table with a column for each error to reach.
fn head(words: &[&'static str]) -> Vec<&'static str> {
    const ERRORS: [&str; TARGETS.len()] = [
        "1e-4", "1e-5", "1e-6", "1e-7", "1e-8", "1e-9", "1e-10", "1e-11", "1e-12", "1e-13",
    ];
    words.iter().copied().chain(ERRORS).collect()
}

/// A row for each method.
fn times(measured: &Measured) -> String {
    let mut rows = Vec::new();
    let known: Vec<f64> = measured.cells.iter().map(|cell| cell.target).collect();
    for curve in &measured.curves {
        let time = |target: f64| {
            let point = curve
                .reaching(Measure::End, Cost::Time, target)
                .filter(|_| known.contains(&target));
            number(point.map(|point| 1e-3 * point.least))
        };
        let bold = if curve.by == OURS { "**" } else { "" };
        let names = [curve.by, curve.method].map(|word| format!("{bold}{word}{bold}"));
        rows.push(names.into_iter().chain(TARGETS.map(time)).collect::<Vec<String>>());
    }
    table(&head(&["by", "method"]), 2, &rows)
}

/// All settings with their samples.
fn raw(results: &Results) -> Value {
    let problem = |measured: &Measured| {
        let setting = |setting: &Setting| {
            let curve = &measured.curves[setting.curve];
            json!({
                "by": curve.by, "method": curve.method, "tolerance": setting.point.tolerance,
                "error": finite(setting.point.error(Measure::End)),
                "error_along": finite(setting.point.error(Measure::Along)), "evaluations": setting.point.evaluations,
                "operations": setting.point.operations,
                "least": setting.point.least, "median": setting.point.median,
                "nanoseconds": setting.samples.iter().map(|sample| sample.round()).collect::<Vec<_>>(),
            })
        };
        let failures = measured.curves.iter().flat_map(|curve| {
            let failure = |(tolerance, why): &(f64, String)| {
                json!({"by": curve.by, "method": curve.method, "tolerance": tolerance, "why": why})
            };
            curve.failures.iter().map(failure).collect::<Vec<_>>()
        });
        let Problem {
            name,
            title,
            is_stiff,
            uncertainty,
            uncertainty_along,
            ..
        } = measured.problem;
        json!({
            "name": name, "title": title, "is_stiff": is_stiff,
            "uncertainty": uncertainty, "uncertainty_along": uncertainty_along,
            "cells": measured.cells, "cells_along": measured.cells_along,
            "settings": measured.settings.iter().map(setting).collect::<Vec<_>>(),
            "failures": failures.collect::<Vec<_>>(),
        })
    };
    json!({
        "header": results.header, "left_out": results.notes,
        "problems": results.problems.iter().map(problem).collect::<Vec<_>>(),
    })
}

/// JSON has no other numbers.
fn finite(value: f64) -> impl Serialize {
    value.is_finite().then_some(value)
}
