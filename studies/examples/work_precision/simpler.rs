//! Accuracy of simpler models: small motion, and no friction, compared with the full model over the amplitude.

use std::error::Error;
use std::fmt;
use std::iter::successors;

use pendulum_core::accuracy::{Errors, Problem, Reference, Report, Sweep};
use pendulum_core::prelude::*;
use pendulum_core::stability::transition;

use crate::scenes::{DoublePendulum, DoublePendulumParams};
use charts::chart::{Axis, Column, Curve, Figure, Line, Marker, Row};
use charts::page::{BLUE, GREEN, VERMILION};

mechanism! {
    /// Like `DoublePendulum`, but without friction.
    Frictionless {
        gravity: [0, -9.8, 0],
        generate: [rhs, jacobian, energy, taylor],
        shape plate { mass: 1, com: [0, -1, 0], inertia: 1 }
        body upper on ground: plate { joint: revolute(z), coordinate: theta1 }
        body lower on upper: plate { joint: revolute(z) at [0, -1, 0], coordinate: theta2 absolute }
    }
}

/// End time, in seconds.
const T1: f64 = 10.0;
/// Tolerance relative to the amplitude.
const TOLERANCE: f64 = 1e-6;
/// Errors at which the amplitude is marked.
const LEVELS: [(f64, &str); 2] = [(1e-2, "1 %"), (1e-3, "0.1 %")];
const NAMES: [&str; 3] = ["linear", "without friction", "full, tolerance 1e-6"];

/// Results of the models at all amplitudes.
pub(crate) struct Simpler {
    amplitudes: Vec<Amplitude>,
}

/// Results for one amplitude, at which both angles start at rest.
struct Amplitude {
    degrees: f64,
    /// Largest error of angles and rates (per second) relative to the amplitude, and the time to compute the last
    /// state, in seconds, in the order of [`NAMES`].
    models: [(f64, f64); 3],
    evaluations: usize,
}

pub(crate) fn measure() -> Result<Simpler, Box<dyn Error>> {
    // 0.1 to 90 degrees
    let degrees = (0..=36).map(|n| 0.1 * 900.0_f64.powf(f64::from(n) / 36.0));
    Ok(Simpler {
        amplitudes: degrees.map(at).collect::<Result<_, _>>()?,
    })
}

fn at(degrees: f64) -> Result<Amplitude, Box<dyn Error>> {
    let model = DoublePendulum::new(DoublePendulumParams { gamma: 0.1 })?;
    let free = Frictionless::new(FrictionlessParams {})?;
    let amplitude = degrees.to_radians();
    let x0 = SVector::from([amplitude, amplitude, 0.0, 0.0]);
    let reference = Reference::integrate(&model, 0.0, T1, x0)?;
    let method = |tol: f64| Taylor::new().rtol(tol).atol(tol * amplitude);

    // The linear model is the transition matrix at rest.
    let flow = |t| transition(&model, 0.0, t, SVector::<f64, 4>::zeros(), 1e-12).map(|(_, flow)| flow);
    let whole = flow(T1)?;
    let problem = Problem::new(&model, 0.0, T1, x0, &reference);
    let linear_and_full = Sweep::new(problem)
        .other("linear", [0.0], |_| Ok(whole * std::hint::black_box(x0)))
        .method("full", [TOLERANCE], method)
        .run();
    let problem = Problem::new(&free, 0.0, T1, x0, &reference);
    let frictionless = Sweep::new(problem).method("frictionless", [TOLERANCE], method).run();

    // The flow over one interval, applied repeatedly.
    let interval = flow(T1 / 1000.0)?;
    let states = successors(Some(x0), |x| Some(interval * x)).zip(0..=1000);
    let linear = states.map(|(x, n)| Some((x - reference.at(T1 * f64::from(n) / 1000.0)?).amax()));
    let linear = linear.map(|error| error.unwrap_or(f64::INFINITY)).fold(0.0, f64::max);
    let of = |report: &Report, n: usize| -> Result<(f64, f64, usize), Box<dyn Error>> {
        let (_, measured) = report.methods[n].measured().next().ok_or("an integration failed")?;
        let Errors {
            largest, dense, last, ..
        } = measured.errors;
        let error = [largest, dense].into_iter().flatten().fold(last, f64::max);
        Ok((
            error,
            measured.minimum,
            measured.work.map_or(0, |work| work.evaluations),
        ))
    };
    let (_, linear_time, _) = of(&linear_and_full, 0)?;
    let (full, full_time, evaluations) = of(&linear_and_full, 1)?;
    let (free, free_time, _) = of(&frictionless, 0)?;
    Ok(Amplitude {
        degrees,
        models: [(linear, linear_time), (free, free_time), (full, full_time)]
            .map(|(error, time)| (error / amplitude, time)),
        evaluations,
    })
}

impl Simpler {
    /// Amplitude up to which the error of the linear model does not exceed `level`.
    fn limit(&self, level: f64) -> Option<f64> {
        let pairs = self.amplitudes.windows(2);
        let crossing = |pair: &[Amplitude]| {
            let [a, b] = [&pair[0], &pair[1]].map(|at| (at.degrees.ln(), (at.models[0].0 / level).ln()));
            (a.1 <= 0.0 && b.1 > 0.0).then(|| (a.0 - a.1 * (b.0 - a.0) / (b.1 - a.1)).exp())
        };
        pairs.into_iter().find_map(crossing)
    }

    pub(crate) fn figure(&self) -> Figure {
        let lines = [Line::solid(VERMILION), Line::dashed(BLUE), Line::solid(GREEN)];
        let panel = |value: fn((f64, f64)) -> f64| -> Vec<Curve> {
            let curve = |n: usize| {
                let point = |at: &Amplitude| (at.degrees.log10(), value(at.models[n]).log10());
                Curve::new(lines[n], self.amplitudes.iter().map(point).collect())
            };
            (0..NAMES.len()).map(curve).collect()
        };
        let note =
            |n: usize, (x, y): (f64, f64), text: String| Curve::note(lines[n].color, (x.log10(), y.log10()), &text);
        let times_of = |n: usize| {
            let times = self.amplitudes.iter().map(|at| at.models[n].1);
            times.fold((f64::INFINITY, 0.0_f64), |(least, most), time| {
                (least.min(time), most.max(time))
            })
        };
        let mut errors = panel(|(error, _)| error);
        for (level, name) in LEVELS {
            if let Some(limit) = self.limit(level) {
                errors.push(Curve {
                    line: Line::solid(lines[0].color).marked(Marker::Circle),
                    ..note(0, (limit, level), format!("within {name} up to {limit:.1}°"))
                });
            }
        }
        let frictionless = self.amplitudes[0].models[1].0;
        errors.push(note(
            1,
            (0.3, frictionless),
            format!("without friction: {:.0} %", 100.0 * frictionless),
        ));
        let mut times = panel(|(_, time)| 1e6 * time);
        let (least, most) = times_of(2);
        times.push(note(
            2,
            (5.0, 1e6 * least),
            format!("full: {:.0} to {:.0} µs", 1e6 * least, 1e6 * most),
        ));
        let (least, _) = times_of(0);
        times.push(note(0, (5.0, 1e6 * least), format!("linear: {:.0} ns", 1e9 * least)));
        let column = |title: &str, label: &str, [least, most]: [f64; 2]| {
            Column::new(
                title,
                Axis::decades("amplitude of both angles (°)", -1.0..2.0),
                Axis {
                    ticks: 10,
                    ..Axis::decades(label, least..most)
                },
            )
        };
        Figure {
            title: "Up to which amplitude is a simpler model enough?".to_owned(),
            subtitle: format!(
                "Double pendulum released at rest with equal angles, γ = 0.1 N m s, followed for {T1} s; all but the \
                linear model by Taylor"
            ),
            size: (1600, 960),
            legend: NAMES
                .into_iter()
                .zip(lines)
                .map(|(name, line)| (line, name.to_owned()))
                .collect(),
            columns: vec![
                column("Largest error of angles and rates", "error over the amplitude", ERRORS),
                column("Time for the state after 10 s", "time (µs)", TIMES),
            ],
            rows: vec![Row::new(vec![errors, times])],
        }
    }
}

/// Range of the error axis, in powers of ten.
const ERRORS: [f64; 2] = [-8.0, 1.0];
/// Range of the time axis, in powers of ten.
const TIMES: [f64; 2] = [-3.0, 2.0];

/// Prints a table over the amplitude, and the operation counts.
impl fmt::Display for Simpler {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "largest error of angles and rates (1/s) over the amplitude, and us for the state after {T1} s"
        )?;
        writeln!(
            f,
            "  degrees          linear              frictionless          full, 1e-6"
        )?;
        for Amplitude { degrees, models, .. } in self.amplitudes.iter().step_by(4) {
            write!(f, "  {degrees:>7.2}")?;
            for (error, time) in models {
                write!(f, "  {error:>8.1e} {:>9.4} us", 1e6 * time)?;
            }
            writeln!(f)?;
        }
        for (level, name) in LEVELS {
            if let Some(limit) = self.limit(level) {
                writeln!(f, "linear within {name} up to {limit:.2} degrees")?;
            }
        }
        writeln!(
            f,
            "operations: linear 28 for a state (12 additions, 16 multiplications)"
        )?;
        let [full, free] = [DoublePendulum::COST["rhs"], Frictionless::COST["rhs"]];
        writeln!(f, "  right-hand side: frictionless {free}; full {full}")?;
        let most = self.amplitudes.iter().map(|at| at.evaluations).max().unwrap_or(0);
        let least = self.amplitudes.iter().map(|at| at.evaluations).min().unwrap_or(0);
        write!(f, "  full: {least} to {most} power series for {T1} s, by amplitude")
    }
}
