//! Charts of time and of operations over errors.

use pendulum_core::accuracy::{Measured, MethodRuns};

use testbed::work::{self, FIXED, Measurement};

use crate::methods::LANES;
use crate::scenes::{NEIGHBOURS, Scene};
use charts::chart::{Axis, Column, Curve, Figure, Line, Row, Scale};
use charts::methods::line;
use charts::page::GRID;

/// Scenes with their measurements; each scene is a row of panels.
type Scenes<'r> = &'r [(&'r Scene, Measurement)];
/// Measured error; `None` for methods without it.
type Value = fn(&Measured) -> Option<f64>;

/// Cost of a run.
#[derive(Clone, Copy)]
enum Cost {
    Time,
    Operations,
}

/// Settings of a column of panels.
#[derive(Clone, Copy)]
struct Panels {
    title: &'static str,
    error: (&'static str, Value),
    /// Uncertainty of the reference for this error.
    uncertainty: fn(&Scene) -> f64,
    cost: (&'static str, Cost),
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
    cost: ("time for a trajectory (µs)", Cost::Time),
    decades: [0.65, 4.25],
    shows: |series| !series.name.ends_with(LANES),
};
const OPERATIONS: Panels = Panels {
    title: "operations",
    cost: ("additions and multiplications, counted", Cost::Operations),
    decades: [4.1, 7.7],
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

pub(crate) fn methods(scenes: Scenes<'_>) -> Figure {
    figure(
        "Time and operations of each method against its error",
        "Each mark is a tolerance or a step; lower is faster, further right is more accurate. Operations are those of \
        model and method",
        scenes,
        &[TIME, OPERATIONS],
    )
}

pub(crate) fn stiff(scenes: Scenes<'_>) -> Figure {
    figure(
        "A stiff motion",
        "Friction of 10⁴ N m s stops the first swing within milliseconds, and then the pendulum creeps; the largest \
        error includes the start",
        scenes,
        &[
            Panels {
                title: "error at the end",
                ..TIME
            },
            LARGEST,
        ],
    )
}

pub(crate) fn lanes(scenes: Scenes<'_>) -> Figure {
    figure(
        "Many trajectories at a time, in the lanes of vector registers",
        &format!(
            "Alone, and {NEIGHBOURS} together from starts a little apart, of which the first one's error is shown"
        ),
        scenes,
        &[Panels { title: "alone", ..TIME }, IN_LANES],
    )
}

pub(crate) fn dense_and_energy(scenes: Scenes<'_>) -> Figure {
    figure(
        "Errors between the steps, and of the energy",
        "Dense output at eight times within each step; largest difference of the energy at a step",
        scenes,
        &[DENSE, ENERGY],
    )
}

fn figure(title: &str, subtitle: &str, scenes: Scenes<'_>, columns: &[Panels]) -> Figure {
    let row = |(scene, measurement): &(&Scene, Measurement)| Row {
        caption: scene.title.to_owned(),
        legend: Vec::new(),
        panels: columns.iter().map(|panels| panels.curves(scene, measurement)).collect(),
    };
    Figure {
        title: title.to_owned(),
        subtitle: subtitle.to_owned(),
        size: (1600, 140 + 780 * scenes.len() as u32),
        legend: [
            charts::methods::legend(),
            vec![(Line::area(GRID), "within the uncertainty of the reference".to_owned())],
        ]
        .concat(),
        columns: columns.iter().map(Panels::column).collect(),
        rows: scenes.iter().map(row).collect(),
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
    fn curves(&self, scene: &Scene, measurement: &Measurement) -> Vec<Curve> {
        let falling = |error: f64| -error.log10().max(ERRORS[0]);
        let curve = |(n, series): (usize, &MethodRuns)| {
            let name = series.name.trim_end_matches(LANES);
            let point = |(setting, measured): (f64, &Measured)| {
                let cost = match self.cost.1 {
                    Cost::Time => 1e6 * measured.minimum,
                    Cost::Operations => measurement.flops(n, setting)? as f64,
                };
                let point = (falling((self.error.1)(measured)?), cost.log10());
                Some((point, note(name, setting, measured)))
            };
            let (points, notes) = series.measured().filter_map(point).unzip();
            Curve {
                label: Some(name.to_owned()),
                notes,
                ..Curve::new(line(name), points)
            }
        };
        let [least, most] = self.decades;
        let [known, end] = [falling((self.uncertainty)(scene)), -ERRORS[0]];
        let unknown = Curve::new(
            Line::area(GRID),
            vec![(known, least), (end, least), (end, most), (known, most)],
        );
        let shown = measurement
            .report
            .methods
            .iter()
            .enumerate()
            .filter(|(_, series)| (self.shows)(series));
        std::iter::once(unknown).chain(shown.map(curve)).collect()
    }
}

/// Setting of a run, and its work.
fn note(method: &str, setting: f64, measured: &Measured) -> String {
    let setting = if FIXED.contains(&method) {
        format!("step of {setting:.4} s")
    } else {
        format!("tolerance {setting:.1e}")
    };
    work::note(&setting, measured)
}
