//! Output of the results as `methods.md`, `methods.json` and a chart.

use std::error::Error;
use std::path::{Path, PathBuf};

use super::entrant::OURS;
use super::results::{Curve, Point, Results, SceneResults};
use crate::report::{count, list, number, table, write};
use charts::page::{BLUE, GREEN, INK, ORANGE, PURPLE, Picture, RGBColor, SKY, VERMILION};
use charts::panels::{self, Column, Panels};

/// Target errors of the final state.
const TARGETS: [f64; 4] = [1e-6, 1e-8, 1e-10, 1e-12];

/// Libraries and their colours, distinguishable with any colour vision (Okabe and Ito, 2008).
const LIBRARIES: [(&str, RGBColor); 10] = [
    (OURS, BLUE),
    ("heyoka", VERMILION),
    ("GSL", GREEN),
    ("Boost.odeint", ORANGE),
    ("CVODE", INK),
    ("ode_solvers", PURPLE),
    ("differential-equations", SKY),
    ("diffsol", RGBColor(150, 150, 150)),
    ("ARKODE", RGBColor(140, 86, 75)),
    ("SciPy", RGBColor(188, 189, 34)),
];

pub(crate) fn all(results: &Results, out: &Path) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let text = markdown(results);
    println!("\n{text}");
    let mut files = vec![
        write(out.join("methods.md"), &text)?,
        write(out.join("methods.json"), &serde_json::to_string_pretty(results)?)?,
    ];
    files.extend(chart(results).save(&out.join("methods"))?);
    Ok(files)
}

fn markdown(results: &Results) -> String {
    let mut text = format!("# Time to reach an error\n\n{}\n", list(&results.header));
    if !results.notes.is_empty() {
        text += &format!("Left out:\n\n{}\n", list(&results.notes));
    }
    text += "Microseconds for a trajectory with the cheapest setting whose final state is as accurate, the least and \
             the median; \
             evaluations of the right-hand side with that setting, where the library tells.\n\n";
    for scene in &results.scenes {
        text += &format!("## {}: {}\n\n{}\n", scene.name, scene.title, contest(&scene.alone));
        if !scene.together.is_empty() {
            text += &format!("In lanes, for each trajectory:\n\n{}\n", contest(&scene.together));
        }
    }
    text
}

/// A row for each method, the fastest to 1e-8 first.
fn contest(curves: &[Curve]) -> String {
    let mut curves: Vec<&Curve> = curves.iter().collect();
    let key = |curve: &Curve, target: f64| curve.reaching(target).map_or(f64::INFINITY, |point| point.least);
    curves.sort_by(|a, b| {
        let by = |target| key(a, target).total_cmp(&key(b, target));
        by(TARGETS[1]).then(by(TARGETS[0]))
    });
    let mut head = vec!["by".to_owned(), "method".to_owned()];
    head.extend(TARGETS.map(|target| format!("{target:.0e}")));
    head.extend(TARGETS.map(|target| format!("evaluations, {target:.0e}")));
    let rows: Vec<Vec<String>> = curves.iter().map(|curve| row(curve)).collect();
    table(&head.iter().map(String::as_str).collect::<Vec<_>>(), 2, &rows)
}

fn row(curve: &Curve) -> Vec<String> {
    let bold = |word: &str| {
        if curve.by == OURS {
            format!("**{word}**")
        } else {
            word.to_owned()
        }
    };
    let mut cells = vec![bold(curve.by), bold(curve.method)];
    let time = |point: &Point| {
        let [least, median] = [point.least, point.median].map(|time| number(Some(1e-3 * time)));
        format!("{least} ({median})")
    };
    cells.extend(TARGETS.map(|target| curve.reaching(target).map_or(String::new(), time)));
    cells.extend(TARGETS.map(|target| count(curve.reaching(target).and_then(|point| point.evaluations))));
    cells
}

/// Range of the error axis.
pub(crate) const RANGE: (f64, f64) = (1e-14, 1e-2);

fn chart(results: &Results) -> Panels {
    type Select = fn(&SceneResults) -> &[Curve];
    let rows: [(&str, Select); 2] = [
        ("One at a time", |scene| &scene.alone),
        ("In lanes", |scene| &scene.together),
    ];
    Panels {
        title: "Time to reach an error".to_owned(),
        subtitle: "Microseconds for a trajectory over the error of its end; of each library the method that is the \
                   first to reach 1e-8, of ours all"
            .to_owned(),
        legend: legend(results.scenes.iter().flat_map(|scene| &scene.alone)),
        x: "error of the final state".to_owned(),
        x_ticks: (0..=6).map(|n| RANGE.0 * 100.0_f64.powi(n)).collect(),
        panel: (480.0, 480.0),
        columns: results
            .scenes
            .iter()
            .map(|scene| Column {
                label: format!("{}, {}", scene.name, scene.title),
            })
            .collect(),
        rows: rows
            .map(|(caption, curves)| {
                let panels = results.scenes.iter().map(|scene| panel(curves(scene)));
                (caption.to_owned(), panels.collect())
            })
            .into(),
    }
}

/// Rows of a colour, width and name for each library that has a curve.
pub(crate) fn legend<'a>(curves: impl Iterator<Item = &'a Curve> + Clone) -> Vec<Vec<(RGBColor, f64, String)>> {
    let occurs = |library: &str| curves.clone().any(|curve| curve.by == library);
    let keys: Vec<_> = LIBRARIES
        .into_iter()
        .filter(|(library, _)| occurs(library))
        .map(|(library, color)| (color, if library == OURS { 4.0 } else { 2.5 }, library.to_owned()))
        .collect();
    keys.chunks(5).map(<[_]>::to_vec).collect()
}

/// Curves of all of our methods, and of the best method of each library.
pub(crate) fn panel(curves: &[Curve]) -> Vec<panels::Curve> {
    let mut drawn = Vec::new();
    for (library, color) in LIBRARIES.into_iter().rev() {
        let of = curves.iter().filter(|curve| curve.by == library);
        let key = |curve: &Curve| curve.reaching(TARGETS[1]).map_or(f64::INFINITY, |point| point.least);
        let best = of.clone().min_by(|a, b| key(a).total_cmp(&key(b)));
        for curve in of {
            let is_best = best.is_some_and(|best| best.method == curve.method);
            if library == OURS || is_best {
                drawn.push(panels::Curve {
                    color,
                    width: if library == OURS && is_best { 4.0 } else { 2.5 },
                    points: front(curve),
                    guides: Vec::new(),
                    name: if library == OURS {
                        curve.method.to_owned()
                    } else {
                        String::new()
                    },
                });
            }
        }
    }
    drawn
}

/// Pareto front of a method: settings that no other one beats in both error and time (in microseconds), beginning with
/// the most accurate.
fn front(curve: &Curve) -> Vec<(f64, f64)> {
    let in_range = |point: &&Point| (RANGE.0..=RANGE.1).contains(&point.error);
    let mut points: Vec<&Point> = curve.points.iter().filter(in_range).collect();
    points.retain(|point| {
        curve
            .reaching(point.error)
            .is_some_and(|best| best.least >= point.least)
    });
    points.sort_by(|a, b| a.error.total_cmp(&b.error));
    points.iter().map(|point| (point.error, 1e-3 * point.least)).collect()
}
