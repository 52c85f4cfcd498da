//! Charts of errors over time and over evaluations.

use pendulum_core::accuracy::{Measured, MethodRuns, Report};

use crate::methods::{LANES, line};
use crate::scenes::{NEIGHBOURS, Scene};
use charts::chart::{Axis, Column, Curve, Figure, Line, Row, Scale};
use charts::page::GRID;

/// Scenes with their reports; each scene is a row of panels.
type Reports<'r> = &'r [(&'r Scene, Report)];
/// Measured quantity; `None` for methods without it.
type Value = fn(&Measured) -> Option<f64>;

/// Settings of a column of panels.
#[derive(Clone, Copy)]
struct Panels {
    title: &'static str,
    error: (&'static str, Value),
    /// Uncertainty of the reference for this error.
    uncertainty: fn(&Scene) -> f64,
    cost: (&'static str, Value),
    /// Range of the cost axis, in powers of ten.
    decades: [f64; 2],
    shows: fn(&MethodRuns) -> bool,
}

/// Range of the error axis, in powers of ten.
const ERRORS: [f64; 2] = [-17.0, 0.0];

const TIME: Panels = Panels {
    title: "time",
    error: ("error at the end (rad, rad/s)", |measured| Some(measured.errors.last)),
    uncertainty: |scene| scene.reference.uncertainty(scene.t1),
    cost: ("time for a trajectory (µs)", |measured| Some(1e6 * measured.minimum)),
    decades: [0.0, 4.5],
    shows: |series| !series.name.ends_with(LANES),
};
const EVALUATIONS: Panels = Panels {
    title: "evaluations",
    cost: ("evaluations of the right-hand side, or series", |measured| {
        Some(measured.work?.evaluations as f64)
    }),
    decades: [1.0, 5.5],
    ..TIME
};
const IN_LANES: Panels = Panels {
    title: "in lanes",
    shows: |series| series.name.ends_with(LANES),
    ..TIME
};
/// Largest error, also between the points that are known to all digits.
const LARGEST: Panels = Panels {
    title: "largest error",
    error: ("largest error (rad, rad/s)", |measured| measured.errors.largest),
    uncertainty: |scene| scene.reference.uncertainty(0.5 * scene.t1),
    ..TIME
};
const DENSE: Panels = Panels {
    title: "dense output",
    error: ("largest error (rad, rad/s)", |measured| measured.errors.dense),
    ..LARGEST
};
const ENERGY: Panels = Panels {
    title: "energy",
    error: ("largest error over the energy at the start", |measured| {
        measured.errors.energy
    }),
    uncertainty: |_| 0.0,
    ..TIME
};

pub(crate) fn methods(reports: Reports<'_>) -> Figure {
    figure(
        "Error of each method against the time that it takes",
        "Each dot is a tolerance or a step; lower is faster, further right is more accurate",
        reports,
        &[TIME, EVALUATIONS],
    )
}

pub(crate) fn stiff(reports: Reports<'_>) -> Figure {
    figure(
        "A stiff motion",
        "Friction of 10⁴ N m s stops the first swing within milliseconds, and then the pendulum creeps; the largest \
        error includes the start",
        reports,
        &[
            Panels {
                title: "error at the end",
                ..TIME
            },
            LARGEST,
        ],
    )
}

pub(crate) fn lanes(reports: Reports<'_>) -> Figure {
    figure(
        "Many trajectories at a time, in the lanes of vector registers",
        &format!(
            "Alone, and {NEIGHBOURS} together from starts a little apart, of which the first one's error is shown"
        ),
        reports,
        &[Panels { title: "alone", ..TIME }, IN_LANES],
    )
}

pub(crate) fn dense_and_energy(reports: Reports<'_>) -> Figure {
    figure(
        "Errors between the steps, and of the energy",
        "Dense output at eight times within each step; largest difference of the energy at a step",
        reports,
        &[DENSE, ENERGY],
    )
}

fn figure(title: &str, subtitle: &str, reports: Reports<'_>, columns: &[Panels]) -> Figure {
    let row = |(scene, report): &(&Scene, Report)| Row {
        caption: scene.title.to_owned(),
        legend: Vec::new(),
        panels: columns.iter().map(|panels| panels.curves(scene, report)).collect(),
    };
    Figure {
        title: title.to_owned(),
        subtitle: subtitle.to_owned(),
        size: (1600, 140 + 780 * reports.len() as u32),
        legend: [
            charts::methods::legend(),
            vec![(Line::area(GRID), "within the uncertainty of the reference".to_owned())],
        ]
        .concat(),
        columns: columns.iter().map(Panels::column).collect(),
        rows: reports.iter().map(row).collect(),
    }
}

impl Panels {
    fn column(&self) -> Column {
        let [least, most] = self.decades;
        Column::new(
            self.title,
            Axis {
                scale: Scale::Falling,
                ticks: 9,
                ..Axis::decades(self.error.0, -ERRORS[1]..-ERRORS[0])
            },
            Axis {
                ticks: 6,
                ..Axis::decades(self.cost.0, least..most)
            },
        )
    }

    /// Clamps errors below the axis to its end.
    fn curves(&self, scene: &Scene, report: &Report) -> Vec<Curve> {
        let falling = |error: f64| -error.log10().max(ERRORS[0]);
        let point = |measured: &Measured| Some((falling((self.error.1)(measured)?), (self.cost.1)(measured)?.log10()));
        let curve = |series: &MethodRuns| Curve {
            line: line(&series.name),
            points: series.measured().filter_map(|(_, measured)| point(measured)).collect(),
            label: Some(series.name.trim_end_matches(LANES).to_owned()),
        };
        let [least, most] = self.decades;
        let [known, end] = [falling((self.uncertainty)(scene)), -ERRORS[0]];
        let unknown = Curve::new(
            Line::area(GRID),
            vec![(known, least), (end, least), (end, most), (known, most)],
        );
        let shown = report.methods.iter().filter(|series| (self.shows)(series));
        std::iter::once(unknown).chain(shown.map(curve)).collect()
    }
}
