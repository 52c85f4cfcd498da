//! Panels of work-precision charts: costs of methods over their errors.

use charts::chart::{Axis, Column, Curve, Line, Scale};
use charts::methods::line;
use charts::page::GRID;
use pendulum_core::accuracy::{Measured, MethodRuns};
use testbed::work::{self, LANES, Measurement};

/// Range of the error axis, in powers of ten.
const ERRORS: [f64; 2] = [-17.0, 0.0];

/// Error over which a cost is drawn.
#[derive(Clone, Copy)]
pub enum Error {
    /// The error of the last state.
    AtTheEnd,
    /// Largest one at the steps.
    OverTime,
    /// Largest one at the steps and between them.
    Dense,
    /// Largest one of the energy, in a unit that the problem states.
    Energy,
}

/// Cost of a run.
#[derive(Clone, Copy)]
pub enum Cost {
    /// Time for a trajectory of a method alone.
    Time,
    /// Time for one of many trajectories, side by side.
    TimeInLanes,
    /// Additions and multiplications of a method alone, and of its model.
    Operations,
}

/// A problem with its measured methods.
pub struct Subject<'m> {
    /// Errors, times and operations of its methods.
    pub measurement: &'m Measurement,
    /// Unit of the errors: 1, or the size of the state if they are relative.
    pub unit: f64,
    /// Uncertainty of the reference at the end and between, in the unit of the state.
    pub uncertainty: [f64; 2],
}

/// Panels, one above the other, that show an error and a cost of several problems.
pub struct Panels<'p> {
    /// Title of the column.
    pub title: &'p str,
    /// Label of the error axis.
    pub label: &'p str,
    /// Error along the horizontal axis.
    pub error: Error,
    /// Cost along the vertical axis.
    pub cost: Cost,
}

impl Panels<'_> {
    /// The column, with the curves of each problem.
    pub fn column<'m>(&self, subjects: impl Iterator<Item = Subject<'m>>) -> (Column, Vec<Vec<Curve>>) {
        let subjects: Vec<_> = subjects.collect();
        let curves: Vec<_> = subjects.iter().map(|subject| self.curves(subject)).collect();
        let costs = range(curves.iter().flatten());
        let unknown = subjects.iter().map(|subject| self.unknown(subject, costs));
        let panels = unknown.zip(curves).map(|(unknown, curves)| {
            let all = std::iter::once(unknown).chain(curves);
            all.collect()
        });
        let x = Axis {
            scale: Scale::Falling,
            ticks: 9,
            ..Axis::decades(self.label, -ERRORS[1]..-ERRORS[0])
        };
        let y = Axis {
            ticks: 6,
            ..Axis::decades(self.cost.label(), costs[0]..costs[1])
        };
        (Column::new(self.title, x, y), panels.collect())
    }

    /// Area of errors within the uncertainty of the reference.
    fn unknown(&self, subject: &Subject<'_>, [least, most]: [f64; 2]) -> Curve {
        let uncertainty = match self.error {
            Error::AtTheEnd => subject.uncertainty[0],
            Error::OverTime | Error::Dense => subject.uncertainty[1],
            Error::Energy => 0.0,
        };
        let (known, end) = (falling(uncertainty / subject.unit), -ERRORS[0]);
        let corners = vec![(known, least), (end, least), (end, most), (known, most)];
        Curve::new(Line::area(GRID), corners)
    }

    /// A curve for each method through the points of its settings.
    fn curves(&self, subject: &Subject<'_>) -> Vec<Curve> {
        let methods = subject.measurement.report.methods.iter().enumerate();
        let shown = methods.filter(|(_, series)| self.cost.is_of(series));
        let curve = |(n, series): (usize, &MethodRuns)| {
            self::curve(series, |setting, measured| {
                let cost = match self.cost {
                    Cost::Time | Cost::TimeInLanes => 1e6 * measured.minimum,
                    Cost::Operations => subject.measurement.flops(n, setting)? as f64,
                };
                Some((falling(self.error.of(measured)? / subject.unit), cost.log10()))
            })
        };
        shown.map(curve).filter(|curve| !curve.points.is_empty()).collect()
    }
}

impl Error {
    fn of(self, measured: &Measured) -> Option<f64> {
        let errors = measured.errors;
        match self {
            Self::AtTheEnd => Some(errors.last),
            Self::OverTime => errors.largest,
            Self::Dense => errors.dense,
            Self::Energy => errors.energy,
        }
    }
}

impl Cost {
    fn label(self) -> &'static str {
        match self {
            Self::Time | Self::TimeInLanes => "time for a trajectory (µs)",
            Self::Operations => "additions and multiplications",
        }
    }

    /// True if the runs have this cost.
    fn is_of(self, series: &MethodRuns) -> bool {
        let in_lanes = series.name.ends_with(LANES);
        in_lanes == matches!(self, Self::TimeInLanes)
    }
}

/// Curve of a method through the points of its settings, each with a note.
pub fn curve(series: &MethodRuns, point: impl Fn(f64, &Measured) -> Option<(f64, f64)>) -> Curve {
    let name = series.name.trim_end_matches(LANES);
    let drawn = series
        .measured()
        .filter_map(|(setting, measured)| Some((point(setting, measured)?, work::note(name, setting, measured))));
    let (points, notes) = drawn.unzip();
    Curve {
        label: Some(name.to_owned()),
        notes,
        ..Curve::new(line(name), points)
    }
}

/// Position of an error on its axis; those below the axis are drawn at its end.
fn falling(error: f64) -> f64 {
    -error.log10().max(ERRORS[0])
}

/// Half powers of ten around all values, with some room.
fn range<'c>(curves: impl Iterator<Item = &'c Curve> + Clone) -> [f64; 2] {
    let values = || {
        curves
            .clone()
            .flat_map(|curve| curve.points.iter().map(|&(_, value)| value))
    };
    let least = values().fold(f64::INFINITY, f64::min);
    let most = values().fold(f64::NEG_INFINITY, f64::max);
    [(2.0 * least).floor() / 2.0, (2.0 * most).ceil() / 2.0]
}
