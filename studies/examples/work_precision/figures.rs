//! Errors against time and evaluations.

use pendulum_core::accuracy::{Measured, MethodRuns, Report};

use crate::methods::{LANES, line};
use crate::scenes::{NEIGHBOURS, Scene};
use charts::chart::{Axis, Column, Curve, Figure, Row, Scale};

/// One row of panels for each scene.
type Reports<'r> = &'r [(&'r Scene, Report)];
/// What a panel has on its axes, or `None` where a method has no such thing.
type Value = fn(&Measured) -> Option<f64>;

/// Decades of the times, in microseconds, of evaluations, and of errors.
const TIMES: [f64; 2] = [0.0, 4.0];
const EVALUATIONS: [f64; 2] = [1.0, 5.0];
const ERRORS: [f64; 2] = [-14.0, 0.0];

const LAST: Value = |measured| Some(measured.errors.last);
const TIME: Value = |measured| Some(1e6 * measured.minimum);

pub(crate) fn methods(reports: Reports<'_>) -> Figure {
    let error = "error at the end (rad, rad/s)";
    let panels: [(Value, Value); 2] = [(LAST, TIME), (LAST, |measured| Some(measured.work?.evaluations as f64))];
    Figure {
        title: "Error of each method against the time that it takes".to_owned(),
        subtitle: "Each dot is a tolerance or a step; lower is faster, further right is more accurate; dashed: implicit methods, and Auto"
            .to_owned(),
        size: (1600, 1700),
        legend: Vec::new(),
        columns: vec![
            column(error, TIMES, "time for a trajectory (µs)"),
            column(error, EVALUATIONS, "evaluations of the right-hand side, or series"),
        ],
        rows: rows(reports, &panels, |name| !name.ends_with(LANES)),
    }
}

pub(crate) fn stiff(reports: Reports<'_>) -> Figure {
    let largest: Value = |measured| measured.errors.largest;
    Figure {
        title: "A stiff motion".to_owned(),
        subtitle: "Friction of 10⁴ N m s stops the first swing within milliseconds, and then the pendulum creeps"
            .to_owned(),
        size: (1600, 920),
        columns: vec![
            column("error at the end", TIMES, "time for a trajectory (µs)"),
            column(
                "largest error at a step, the fast start included",
                TIMES,
                "time for a trajectory (µs)",
            ),
        ],
        rows: rows(reports, &[(LAST, TIME), (largest, TIME)], |_| true),
        ..methods(&[])
    }
}

pub(crate) fn lanes(reports: Reports<'_>) -> Figure {
    let error = "error at the end (rad, rad/s)";
    let row = |(scene, report): &(&Scene, Report)| {
        let has_lanes = |name: &str| {
            report
                .methods
                .iter()
                .any(|series| series.name == format!("{name}{LANES}"))
        };
        Row {
            caption: scene.title.to_owned(),
            legend: Vec::new(),
            panels: vec![
                curves(report, (LAST, TIME), has_lanes),
                curves(report, (LAST, TIME), |name| name.ends_with(LANES)),
            ],
        }
    };
    Figure {
        title: "Many trajectories at a time, in the lanes of vector registers".to_owned(),
        subtitle: format!(
            "Left: one alone. Right: {NEIGHBOURS} together, from starts a little apart; the error is that of the first"
        ),
        columns: vec![
            column(error, TIMES, "alone: time for a trajectory (µs)"),
            column(error, TIMES, "in lanes: time for a trajectory (µs)"),
        ],
        rows: reports.iter().map(row).collect(),
        ..methods(&[])
    }
}

pub(crate) fn dense_and_energy(reports: Reports<'_>) -> Figure {
    let panels: [(Value, Value); 2] = [
        (|measured| measured.errors.dense, TIME),
        (|measured| measured.errors.energy, TIME),
    ];
    Figure {
        title: "Errors between the steps, and of the energy".to_owned(),
        subtitle:
            "Left: dense output at eight times within each step. Right: largest difference of the energy at a step, \
                   in units of the energy at the start"
                .to_owned(),
        columns: vec![
            column(
                "largest error of the dense output (rad, rad/s)",
                TIMES,
                "time for a trajectory (µs)",
            ),
            column("largest error of the energy", TIMES, "time for a trajectory (µs)"),
        ],
        rows: rows(reports, &panels, |name| !name.ends_with(LANES)),
        ..methods(&[])
    }
}

fn column(error: &str, [least, most]: [f64; 2], cost: &str) -> Column {
    Column {
        x: Axis {
            label: error.to_owned(),
            scale: Scale::Falling,
            range: -ERRORS[1]..-ERRORS[0],
            ticks: 8,
        },
        y: Axis {
            label: cost.to_owned(),
            scale: Scale::Decades,
            range: least..most,
            ticks: 5,
        },
    }
}

fn rows(reports: Reports<'_>, panels: &[(Value, Value)], shown: fn(&str) -> bool) -> Vec<Row> {
    let row = |(scene, report): &(&Scene, Report)| Row {
        caption: scene.title.to_owned(),
        legend: Vec::new(),
        panels: panels.iter().map(|&values| curves(report, values, shown)).collect(),
    };
    reports.iter().map(row).collect()
}

/// Errors below the axis stand at its end.
fn curves(report: &Report, (error, cost): (Value, Value), shown: impl Fn(&str) -> bool) -> Vec<Curve> {
    let point = |measured: &Measured| Some((-error(measured)?.log10().max(ERRORS[0]), cost(measured)?.log10()));
    let curve = |series: &MethodRuns| Curve {
        line: line(&series.name),
        points: series.measured().filter_map(|(_, measured)| point(measured)).collect(),
        label: Some(series.name.trim_end_matches(LANES).to_owned()),
    };
    report
        .methods
        .iter()
        .filter(|series| shown(&series.name))
        .map(curve)
        .collect()
}
