//! Charts of time and of operations over errors.

use charts::chart::{Figure, Line, Row};
use charts::page::GRID;
use studies::panels::{Cost, Error, Panels, Subject};
use testbed::work::{Measurement, TOGETHER};

use crate::scenes::Scene;

/// Scenes with their measurements; each scene is a row of panels.
type Scenes<'r> = &'r [(&'r Scene, Measurement)];

const TIME: Panels<'_> = Panels {
    title: "time",
    label: "error at the end (rad, rad/s)",
    error: Error::AtTheEnd,
    cost: Cost::Time,
};
const OPERATIONS: Panels<'_> = Panels {
    title: "operations",
    cost: Cost::Operations,
    ..TIME
};
const IN_LANES: Panels<'_> = Panels {
    title: "in lanes",
    cost: Cost::TimeInLanes,
    ..TIME
};
const OVER_TIME: Panels<'_> = Panels {
    title: "largest error",
    label: "largest error (rad, rad/s)",
    error: Error::OverTime,
    ..TIME
};
const DENSE: Panels<'_> = Panels {
    title: "dense output",
    error: Error::Dense,
    ..OVER_TIME
};
const ENERGY: Panels<'_> = Panels {
    title: "energy",
    label: "largest error over the energy at the start",
    error: Error::Energy,
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
            OVER_TIME,
        ],
    )
}

pub(crate) fn lanes(scenes: Scenes<'_>) -> Figure {
    figure(
        "Many trajectories at a time, in the lanes of vector registers",
        &format!("Alone, and {TOGETHER} together from starts a little apart, of which the first one's error is shown"),
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

fn figure(title: &str, subtitle: &str, scenes: Scenes<'_>, panels: &[Panels<'_>]) -> Figure {
    let mut rows: Vec<_> = scenes
        .iter()
        .map(|(scene, _)| Row {
            caption: scene.title.to_owned(),
            ..Row::new(Vec::new())
        })
        .collect();
    let columns = panels.iter().map(|panels| {
        let (column, curves) = panels.column(scenes.iter().map(subject));
        for (row, curves) in rows.iter_mut().zip(curves) {
            row.panels.push(curves);
        }
        column
    });
    let columns = columns.collect();
    let unknown = "within the uncertainty of the reference".to_owned();
    Figure {
        title: title.to_owned(),
        subtitle: subtitle.to_owned(),
        size: (1600, 140 + 780 * scenes.len() as u32),
        legend: [charts::methods::legend(), vec![(Line::area(GRID), unknown)]].concat(),
        columns,
        rows,
    }
}

fn subject<'m>((scene, measurement): &'m (&Scene, Measurement)) -> Subject<'m> {
    Subject {
        measurement,
        unit: 1.0,
        uncertainty: [1.0, 0.5].map(|part| scene.reference.uncertainty(part * scene.t1)),
    }
}
