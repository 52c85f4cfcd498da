//! Charts of the errors over time, operations and tolerance.

use charts::chart::{Axis, Column, Curve, Figure, Line, Row, Scale};
use charts::methods::line;
use charts::page::GRID;
use pendulum_core::accuracy::{Measured, MethodRuns};
use testbed::work::{self, FIXED};

use crate::measure::Problem;

/// Range of relative errors, in powers of ten.
const ERRORS: [f64; 2] = [-16.0, 0.0];
/// Range of tolerances.
const TOLERANCES: [f64; 2] = [-14.0, -3.0];
/// Range of ratios of error and tolerance.
const RATIOS: [f64; 2] = [-8.0, 6.0];
/// Number of problems in a figure.
const TOGETHER: usize = 3;

/// Quantity drawn over the error.
#[derive(Clone, Copy)]
enum Cost {
    Time,
    Operations,
}

/// All figures with their file names.
pub(crate) fn all(problems: &[Problem]) -> Vec<(String, Figure)> {
    let groups = ["pendulum", "orbits", "stiff", "mechanisms"];
    let mut figures = Vec::new();
    for (name, problems) in groups.into_iter().zip(problems.chunks(TOGETHER)) {
        let titles: Vec<_> = problems.iter().map(|problem| problem.title).collect();
        let titles = titles.join("; ");
        figures.push((format!("time_{name}"), over_errors(&titles, problems, Cost::Time)));
        figures.push((
            format!("operations_{name}"),
            over_errors(&titles, problems, Cost::Operations),
        ));
        figures.push((format!("tolerance_{name}"), over_tolerances(&titles, problems)));
    }
    figures
}

fn over_errors(titles: &str, problems: &[Problem], cost: Cost) -> Figure {
    let falling = |error: f64| -error.log10().max(ERRORS[0]);
    let label = match cost {
        Cost::Time => "time for a trajectory (µs)",
        Cost::Operations => "additions and multiplications",
    };
    let panel = |problem: &Problem| {
        let curves = curves(problem, |n, _, setting, measured| {
            let cost = match cost {
                Cost::Time => 1e6 * measured.minimum,
                Cost::Operations => problem.measurement.flops(n, setting)? as f64,
            };
            Some((falling(measured.errors.last / problem.size), cost.log10()))
        });
        let decades = range(&curves);
        let (known, end) = (falling(problem.uncertainty), -ERRORS[0]);
        let corners = vec![
            (known, decades[0]),
            (end, decades[0]),
            (end, decades[1]),
            (known, decades[1]),
        ];
        let unknown = Curve::new(Line::area(GRID), corners);
        let column = Column::new(
            problem.title,
            Axis {
                scale: Scale::Falling,
                ticks: 9,
                ..Axis::decades("relative error at the end", -ERRORS[1]..-ERRORS[0])
            },
            Axis {
                ticks: 6,
                ..Axis::decades(label, decades[0]..decades[1])
            },
        );
        (column, std::iter::once(unknown).chain(curves).collect())
    };
    let what = match cost {
        Cost::Time => "Time of each method against its error",
        Cost::Operations => "Operations of each method against its error",
    };
    figure(what, titles, problems.iter().map(panel))
}

fn over_tolerances(titles: &str, problems: &[Problem]) -> Figure {
    let panel = |problem: &Problem| {
        let curves = curves(problem, |_, series, setting, measured| {
            let ratio = (measured.errors.last / problem.size / setting).log10();
            let shown = (!FIXED.contains(&&*series.name)).then(|| ratio.clamp(RATIOS[0], RATIOS[1]));
            Some((-setting.log10(), shown?))
        });
        let column = Column::new(
            problem.title,
            Axis {
                scale: Scale::Falling,
                ticks: 9,
                ..Axis::decades("tolerance", -TOLERANCES[1]..-TOLERANCES[0])
            },
            Axis {
                ticks: 8,
                ..Axis::decades("relative error over tolerance", RATIOS[0]..RATIOS[1])
            },
        );
        (column, curves)
    };
    figure(
        "Error of each method over its tolerance",
        titles,
        problems.iter().map(panel),
    )
}

fn figure(title: &str, subtitle: &str, panels: impl Iterator<Item = (Column, Vec<Curve>)>) -> Figure {
    let (columns, panels): (Vec<_>, Vec<_>) = panels.unzip();
    Figure {
        title: title.to_owned(),
        subtitle: subtitle.to_owned(),
        size: (2100, 900),
        legend: charts::methods::legend(),
        columns,
        rows: vec![Row::new(panels)],
    }
}

/// A curve for each method through the points of its settings.
fn curves(problem: &Problem, point: impl Fn(usize, &MethodRuns, f64, &Measured) -> Option<(f64, f64)>) -> Vec<Curve> {
    let methods = problem.measurement.report.methods.iter().enumerate();
    let curve = |(n, series): (usize, &MethodRuns)| {
        let drawn = series.measured().filter_map(|(setting, measured)| {
            Some((
                point(n, series, setting, measured)?,
                note(&series.name, setting, measured),
            ))
        });
        let (points, notes): (Vec<_>, Vec<_>) = drawn.unzip();
        Curve {
            label: Some(series.name.clone()),
            notes,
            ..Curve::new(line(&series.name), points)
        }
    };
    methods.map(curve).filter(|curve| !curve.points.is_empty()).collect()
}

/// Whole powers of ten around all values.
fn range(curves: &[Curve]) -> [f64; 2] {
    let values = || {
        curves
            .iter()
            .flat_map(|curve| curve.points.iter().map(|&(_, value)| value))
    };
    let least = values().fold(f64::INFINITY, f64::min);
    let most = values().fold(f64::NEG_INFINITY, f64::max);
    [(2.0 * least).floor() / 2.0, (2.0 * most).ceil() / 2.0]
}

/// Setting of a run, and its work.
fn note(method: &str, setting: f64, measured: &Measured) -> String {
    let setting = if FIXED.contains(&method) {
        format!("step of {setting:.3e}")
    } else {
        format!("tolerance {setting:.1e}")
    };
    work::note(&setting, measured)
}
