//! Output of the results as `scaling.md`, `scaling.json` and a chart.

use std::error::Error;
use std::path::{Path, PathBuf};

use super::FUNCTIONS;
use super::results::{Results, Robot, Row};
use crate::report::{list, number, table, write};
use charts::page::{BLUE, GREY, Picture, VERMILION};
use charts::panels::{Column, Curve, Panels};

/// Target times for Panda with Jacobian, in seconds: expansion alone, and with compilation.
const TARGETS: [f64; 2] = [1.0, 5.0];

pub(crate) fn all(results: &Results, out: &Path) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let text = markdown(results);
    println!("\n{text}");
    let mut files = vec![
        write(out.join("scaling.md"), &text)?,
        write(out.join("scaling.json"), &serde_json::to_string_pretty(results)?)?,
    ];
    files.extend(chart(results).save(&out.join("scaling"))?);
    Ok(files)
}

fn markdown(results: &Results) -> String {
    let mut text = format!(
        "# Growth with the number of joints\n\n{}\nSeconds and nanoseconds are the least of several.\n\n",
        list(&results.header)
    );
    for (_, _, function) in FUNCTIONS {
        for chain in ["planar", "spatial"] {
            text += &format!("## {chain}, {function}\n\n{}\n", chains(results, chain, function));
        }
    }
    text + "## Robots with Jacobian\n\n" + &robots(&results.robots)
}

/// Table of a chain, and the exponent of growth from half of the joints to all of them.
fn chains(results: &Results, chain: &str, function: &str) -> String {
    let of: Vec<&Row> = of(results, chain, function).collect();
    let rows: Vec<Vec<String>> = of.iter().map(|row| cells(row)).collect();
    let head = [
        "joints",
        "form",
        "other bases",
        "operations",
        "divisions",
        "expansion, s",
        "compilation, s",
        "ns",
    ];
    let exponent = |value: &dyn Fn(&Row) -> f64| {
        let last = of.last()?;
        let half = of.iter().find(|row| 2 * row.joints == last.joints)?;
        Some((value(last) / value(half)).log2())
    };
    let exponents = [
        exponent(&|row| row.operations as f64),
        exponent(&|row| row.expansion),
        exponent(&|row| row.compilation),
        exponent(&|row| row.nanoseconds),
    ]
    .map(number);
    format!(
        "{}\nExponents from 6 to 12 joints: operations {}, expansion {}, compilation {}, evaluation {}.\n",
        table(&head, 3, &rows),
        exponents[0],
        exponents[1],
        exponents[2],
        exponents[3]
    )
}

fn of<'a>(results: &'a Results, chain: &str, function: &str) -> impl Iterator<Item = &'a Row> {
    results
        .rows
        .iter()
        .filter(move |row| row.chain == chain && row.function == function)
}

fn cells(row: &Row) -> Vec<String> {
    let others = row.bases.iter().skip(1);
    let others: Vec<String> = others
        .map(|other| format!("{} {}", other.basis, other.operations))
        .collect();
    vec![
        row.joints.to_string(),
        row.form.clone(),
        others.join(", "),
        row.operations.to_string(),
        row.divisions.to_string(),
        format!("{:.4}", row.expansion),
        number(Some(row.compilation)),
        number(Some(row.nanoseconds)),
    ]
}

fn robots(robots: &[Robot]) -> String {
    let against = |value: f64, target: f64| {
        let word = if value <= target { "met" } else { "missed" };
        format!("{target} s, {word}")
    };
    let rows: Vec<Vec<String>> = robots
        .iter()
        .map(|robot| {
            let sum = robot.expansion + robot.compilation;
            let targets = TARGETS.map(Some).map(|target| target.filter(|_| robot.name == "Panda"));
            vec![
                robot.name.to_owned(),
                number(Some(robot.expansion)),
                targets[0].map_or(String::new(), |target| against(robot.expansion, target)),
                number(Some(sum)),
                targets[1].map_or(String::new(), |target| against(sum, target)),
                number(Some(robot.together)),
            ]
        })
        .collect();
    let head = [
        "robot",
        "expansion, s",
        "target",
        "expansion + compilation, s",
        "target",
        "rustc with the macro, s",
    ];
    table(&head, 1, &rows)
}

type Value = fn(&Row) -> f64;

fn chart(results: &Results) -> Panels {
    let columns: [(&str, Value); 4] = [
        ("operations", |row| row.operations as f64),
        ("expansion (s)", |row| row.expansion),
        ("compilation (s)", |row| row.compilation),
        ("evaluation (ns)", |row| row.nanoseconds),
    ];
    let colors = [BLUE, VERMILION];
    let panel = |chain: &str, n: usize, value: Value| {
        let mut curves = Vec::new();
        for ((_, _, function), color) in FUNCTIONS.into_iter().zip(colors) {
            if n == 0 {
                curves.extend(bases(results, chain, function).into_iter().map(|points| Curve {
                    color,
                    width: 1.2,
                    points,
                    guides: Vec::new(),
                    name: String::new(),
                }));
            }
            let points = of(results, chain, function).map(|row| (row.joints as f64, value(row)));
            let guides = if color == BLUE { vec![1, 2] } else { vec![3] };
            curves.push(Curve {
                color,
                width: 3.2,
                points: points.collect(),
                guides,
                name: String::new(),
            });
        }
        curves
    };
    Panels {
        title: "Growth with the number of joints".to_owned(),
        subtitle: "Chains of 2 to 12 joints; both axes logarithmic; thin: the best form on each other basis; dashed: \
                   powers of n"
            .to_owned(),
        legend: vec![vec![
            (BLUE, 3.2, FUNCTIONS[0].2.to_owned()),
            (VERMILION, 3.2, FUNCTIONS[1].2.to_owned()),
            (GREY, 1.2, "other bases, in the colour of the function".to_owned()),
        ]],
        x: "joints".to_owned(),
        x_ticks: vec![2.0, 3.0, 4.0, 6.0, 8.0, 12.0],
        panel: (292.0, 300.0),
        columns: columns
            .iter()
            .map(|(label, _)| Column {
                label: (*label).to_owned(),
            })
            .collect(),
        rows: ["planar", "spatial"]
            .map(|chain| {
                let panels = columns
                    .iter()
                    .enumerate()
                    .map(|(n, (_, value))| panel(chain, n, *value));
                (format!("{chain} chains"), panels.collect())
            })
            .into(),
    }
}

/// Counts on each basis that was not chosen everywhere.
fn bases(results: &Results, chain: &str, function: &str) -> Vec<Vec<(f64, f64)>> {
    ["closed form", "A, B and C", "recursion", "articulated bodies"]
        .map(|basis| {
            of(results, chain, function)
                .filter_map(|row| {
                    let counted = row.bases.iter().find(|counted| counted.basis == basis)?;
                    Some((row.joints as f64, counted.operations as f64))
                })
                .collect()
        })
        .into()
}
