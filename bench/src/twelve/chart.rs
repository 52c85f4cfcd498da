//! Charts of time and operations over error.

use charts::page::{BLUE, GREEN, INK, ORANGE, PURPLE, RGBColor, SKY, VERMILION};
use charts::panels::{self, Column, Panels};
use twelve::OURS;

use super::measured::Measured;
use super::results::{Cost, Curve, Measure, Point};

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

/// Range of the error axis.
const RANGE: (f64, f64) = (1e-14, 1e-2);

/// Error that decides which method of a library is drawn.
const SELECTIVE: f64 = 1e-8;

/// Chart with a column for each problem, and a row for each measure of the error.
pub(crate) fn chart(name: &str, problems: &[Measured], cost: Cost) -> Panels {
    let row = |(caption, measure): (&str, Measure)| {
        let panels = problems.iter().map(|measured| panel(&measured.curves, measure, cost));
        (caption.to_owned(), panels.collect())
    };
    let (what, of) = match cost {
        Cost::Time => ("Time", "Microseconds for a trajectory"),
        Cost::Operations => (
            "Operations",
            "Additions and multiplications of the model, or of series, for a trajectory",
        ),
    };
    Panels {
        title: format!("{what} to reach an error: {name}"),
        subtitle: format!(
            "{of} over its relative error; of each library the method that is the first to reach 1e-8, of ours all"
        ),
        legend: legend(problems.iter().flat_map(|measured| &measured.curves)),
        x: "relative error".to_owned(),
        x_ticks: (0..=6).map(|n| RANGE.0 * 100.0_f64.powi(n)).collect(),
        panel: (480.0, 480.0),
        columns: problems
            .iter()
            .map(|measured| Column {
                label: measured.problem.title.to_owned(),
            })
            .collect(),
        rows: [("Error at the end", Measure::End), ("Error over time", Measure::Along)]
            .map(row)
            .into(),
    }
}

/// Rows of a colour, width and name for each library that has a curve.
fn legend<'a>(curves: impl Iterator<Item = &'a Curve> + Clone) -> Vec<Vec<(RGBColor, f64, String)>> {
    let occurs = |library: &str| curves.clone().any(|curve| curve.by == library);
    let keys: Vec<_> = LIBRARIES
        .into_iter()
        .filter(|(library, _)| occurs(library))
        .map(|(library, color)| (color, if library == OURS { 4.0 } else { 2.5 }, library.to_owned()))
        .collect();
    keys.chunks(5).map(<[_]>::to_vec).collect()
}

/// Curves of all of our methods, and of the best method of each library.
fn panel(curves: &[Curve], measure: Measure, cost: Cost) -> Vec<panels::Curve> {
    let mut drawn = Vec::new();
    for (library, color) in LIBRARIES.into_iter().rev() {
        let of = curves.iter().filter(|curve| curve.by == library);
        let key = |curve: &Curve| {
            let point = curve.reaching(measure, cost, SELECTIVE);
            point.map_or(f64::INFINITY, |point| point.cost(cost))
        };
        let best = of.clone().min_by(|a, b| key(a).total_cmp(&key(b)));
        for curve in of {
            let is_best = best.is_some_and(|best| best.method == curve.method);
            if library == OURS || is_best {
                drawn.push(panels::Curve {
                    color,
                    width: if library == OURS && is_best { 4.0 } else { 2.5 },
                    points: front(curve, measure, cost),
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

/// Pareto front of a method: settings that no other one beats in both error and cost (microseconds or operations),
/// beginning with the most accurate.
fn front(curve: &Curve, measure: Measure, cost: Cost) -> Vec<(f64, f64)> {
    let in_range = |point: &&Point| (RANGE.0..=RANGE.1).contains(&point.error(measure)) && point.cost(cost).is_finite();
    let mut points: Vec<&Point> = curve.points.iter().filter(in_range).collect();
    points.retain(|point| {
        curve
            .reaching(measure, cost, point.error(measure))
            .is_some_and(|best| best.cost(cost) >= point.cost(cost))
    });
    let unit = match cost {
        Cost::Time => 1e-3,
        Cost::Operations => 1.0,
    };
    points.sort_by(|a, b| a.error(measure).total_cmp(&b.error(measure)));
    points
        .iter()
        .map(|point| (point.error(measure), unit * point.cost(cost)))
        .collect()
}
