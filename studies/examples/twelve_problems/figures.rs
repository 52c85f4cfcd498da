//! Charts of the errors over time, operations and tolerance.

use charts::chart::{Axis, Column, Curve, Figure, Line, Row, Scale};
use charts::page::GRID;
use pendulum_core::accuracy::MethodRuns;
use studies::panels::{Cost, Error, Panels, Subject, curve};
use testbed::work::{FIXED, LANES};

use crate::measure::Problem;

/// Range of tolerances, in powers of ten.
const TOLERANCES: [f64; 2] = [-14.0, -3.0];
/// Range of ratios of error and tolerance, in powers of ten.
const RATIOS: [f64; 2] = [-8.0, 6.0];
/// Number of problems in a figure.
const TOGETHER: usize = 3;

/// Figure of costs over errors: its file name, its title, the label of its errors.
struct Chart {
    name: &'static str,
    title: &'static str,
    label: &'static str,
    error: Error,
    cost: Cost,
}

const CHARTS: [Chart; 5] = [
    Chart {
        name: "time",
        title: "Time of each method against its error",
        label: "relative error at the end",
        error: Error::AtTheEnd,
        cost: Cost::Time,
    },
    Chart {
        name: "operations",
        title: "Operations of each method against its error",
        label: "relative error at the end",
        error: Error::AtTheEnd,
        cost: Cost::Operations,
    },
    Chart {
        name: "over_time",
        title: "Time of each method against its largest error at a step",
        label: "largest relative error at a step",
        error: Error::OverTime,
        cost: Cost::Time,
    },
    Chart {
        name: "dense",
        title: "Time of each method against the largest error of its dense output",
        label: "largest relative error of the dense output",
        error: Error::Dense,
        cost: Cost::Time,
    },
    Chart {
        name: "lanes",
        title: "Time of each method for one of 64 trajectories in lanes, against its error",
        label: "relative error at the end",
        error: Error::AtTheEnd,
        cost: Cost::TimeInLanes,
    },
];

/// All figures with their file names.
pub(crate) fn all(problems: &[Problem]) -> Vec<(String, Figure)> {
    let groups = ["pendulum", "orbits", "stiff", "mechanisms"];
    let mut figures = Vec::new();
    for (group, problems) in groups.into_iter().zip(problems.chunks(TOGETHER)) {
        for chart in CHARTS {
            figures.push((format!("{}_{group}", chart.name), over_errors(&chart, problems)));
        }
        figures.push((format!("tolerance_{group}"), over_tolerances(problems)));
    }
    figures
}

fn over_errors(chart: &Chart, problems: &[Problem]) -> Figure {
    let panel = |problem: &Problem| {
        let panels = Panels {
            title: problem.title,
            label: chart.label,
            error: chart.error,
            cost: chart.cost,
        };
        let subject = Subject {
            measurement: &problem.measurement,
            unit: problem.size,
            uncertainty: problem.uncertainty,
        };
        let (column, curves) = panels.column(std::iter::once(subject));
        (column, curves.into_iter().flatten().collect())
    };
    let mut figure = figure(chart.title, problems, panel);
    let unknown = "within the uncertainty of the reference".to_owned();
    figure.legend.push((Line::area(GRID), unknown));
    figure
}

fn over_tolerances(problems: &[Problem]) -> Figure {
    let panel = |problem: &Problem| {
        let adaptive = |series: &&MethodRuns| !FIXED.contains(&&*series.name) && !series.name.ends_with(LANES);
        let over_tolerance = |series: &MethodRuns| {
            curve(series, |tolerance, measured| {
                let ratio = (measured.errors.last / problem.size / tolerance).log10();
                Some((-tolerance.log10(), ratio.clamp(RATIOS[0], RATIOS[1])))
            })
        };
        let methods = problem.measurement.report.methods.iter().filter(adaptive);
        let curves = methods.map(over_tolerance).filter(|curve| !curve.points.is_empty());
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
        (column, curves.collect())
    };
    figure("Error of each method over its tolerance", problems, panel)
}

fn figure(title: &str, problems: &[Problem], panel: impl Fn(&Problem) -> (Column, Vec<Curve>)) -> Figure {
    let (columns, panels): (Vec<_>, Vec<_>) = problems.iter().map(panel).unzip();
    let titles: Vec<_> = problems.iter().map(|problem| problem.title).collect();
    Figure {
        title: title.to_owned(),
        subtitle: titles.join("; "),
        size: (2100, 900),
        legend: charts::methods::legend(),
        columns,
        rows: vec![Row::new(panels)],
    }
}
