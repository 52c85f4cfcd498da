//! Chaos over the amplitude, with and without friction, and the Poincare sections of the motions without.
//!
//! With friction every motion comes to rest, and the exponent of long times is that of the slowest mode there, which is negative: what is
//! positive over a finite time is the chaos on the way.

use std::error::Error;
use std::fmt;

use charts::page::RGBColor;
use pendulum_core::Occurrence;
use pendulum_core::prelude::*;
use pendulum_core::stability::{Lyapunov, section};

use crate::progress::on_all_cores;
use crate::scene::{DoublePendulum, chaos_above};
use charts::chart::{Axis, Column, Curve, Figure, Line, Row, Scale};
use charts::heat::{Atlas, Map};
use charts::page::{BLUE, INK, ORANGE, VERMILION};

/// The friction of both axles, in N m s.
const FRICTIONS: [f64; 4] = [0.0, 0.003, 0.03, 0.3];
/// The angles of both plates at the start, over the amplitude.
const RELEASES: [([f64; 2], &str); 2] = [([0.0, 1.0], "θ₁ = 0, θ₂ = a"), ([1.0, 1.0], "θ₁ = θ₂ = a")];
/// How long exponents are measured, and how long sections are recorded, in s.
const DURATION: f64 = 200.0;
const SECTION: f64 = 2000.0;
const TOLERANCE: f64 = 1e-7;
const SECTION_TOLERANCE: f64 = 1e-10;
/// The energy at each passage is that of the start to so many joules.
const ENERGY: f64 = 1e-6;
const COLORS: [RGBColor; FRICTIONS.len()] = [INK, BLUE, ORANGE, VERMILION];

/// All motions.
pub(crate) struct Amplitudes {
    /// In degrees.
    amplitudes: Vec<f64>,
    releases: Vec<Release>,
}

/// The motions of one release over the amplitude.
struct Release {
    caption: &'static str,
    /// The largest Lyapunov exponents over [`DURATION`], in 1/s, for each friction.
    exponents: Vec<Vec<f64>>,
    /// The rates of the lower plate, in rad/s, where the upper one swings forth through its lowest place.
    sections: Vec<Vec<f64>>,
}

pub(crate) fn measure(size: usize) -> Result<Amplitudes, Box<dyn Error>> {
    let amplitudes: Vec<_> = (0..size).map(|n| 180.0 * (n as f64 + 0.5) / size as f64).collect();
    let pendulums = FRICTIONS.map(|gamma| DoublePendulum::with_friction(gamma, gamma));
    let pendulums = pendulums.into_iter().collect::<Result<Vec<_>, _>>()?;
    let lyapunov = Lyapunov::new().tolerance(TOLERANCE).duration(DURATION);
    let mut releases = Vec::new();
    for (angles, caption) in RELEASES {
        let starts: Vec<_> = amplitudes.iter().map(|degrees| start(angles, *degrees)).collect();
        let motions: Vec<_> = pendulums
            .iter()
            .flat_map(|pendulum| starts.iter().map(move |x0| (pendulum, *x0)))
            .collect();
        let exponents = on_all_cores("exponents over amplitude", &motions, |&(pendulum, x0)| {
            lyapunov.largest(pendulum, x0).map(|exponents| exponents.values[0])
        })?;
        let sections = on_all_cores("sections over amplitude", &starts, |x0| passages(&pendulums[0], x0))?;
        releases.push(Release {
            caption,
            exponents: exponents.chunks(size).map(<[f64]>::to_vec).collect(),
            sections,
        });
    }
    Ok(Amplitudes { amplitudes, releases })
}

/// At rest.
fn start([theta1, theta2]: [f64; 2], degrees: f64) -> SVector<f64, 4> {
    let amplitude = degrees.to_radians();
    SVector::from([theta1 * amplitude, theta2 * amplitude, 0.0, 0.0])
}

/// The rates of the lower plate where the upper one swings forth through its lowest place.
fn passages(frictionless: &DoublePendulum, x0: &SVector<f64, 4>) -> Result<Vec<f64>, String> {
    // The sine rises there, and at the highest place on the way back.
    let through = Event::new(|_t, x: &SVector<f64, 4>| x[0].sin()).rising();
    let method = Taylor::new().rtol(SECTION_TOLERANCE).atol(SECTION_TOLERANCE);
    let passages = section(&method, frictionless, 0.0, SECTION, *x0, &through).map_err(|error| error.to_string())?;
    let energy = frictionless.energy(0.0, x0);
    let mut rates = Vec::new();
    for Occurrence { t, x, .. } in passages {
        let error = (frictionless.energy(t, &x) - energy).abs();
        if error > ENERGY {
            return Err(format!(
                "the energy is {error:.1e} J off at a passage after {t:.3} s: the integration went wrong"
            ));
        }
        if x[0].cos() > 0.0 {
            rates.push(x[3]);
        }
    }
    Ok(rates)
}

impl Amplitudes {
    /// The exponents as curves.
    pub(crate) fn figure(&self) -> Figure {
        let lines = COLORS.map(Line::solid);
        let column = |release: &Release| {
            let exponents = || release.exponents.iter().flatten().copied();
            let least = exponents().fold(f64::INFINITY, f64::min);
            let most = exponents().fold(f64::NEG_INFINITY, f64::max);
            Column {
                x: self.axis(),
                y: Axis {
                    label: "largest finite-time exponent (1/s)".to_owned(),
                    scale: Scale::Linear,
                    range: (20.0 * least).floor() / 20.0..(20.0 * most).ceil() / 20.0,
                    ticks: 8,
                },
            }
        };
        let panel = |release: &Release| -> Vec<Curve> {
            let curves = release.exponents.iter().zip(lines);
            let curve = |(exponents, line): (&Vec<f64>, Line)| Curve {
                line: Line { width: 2.2, ..line },
                points: self.amplitudes.iter().copied().zip(exponents.iter().copied()).collect(),
                label: None,
            };
            curves.map(curve).collect()
        };
        let legend = FRICTIONS.iter().zip(lines);
        Figure {
            title: "From which amplitude on is the double pendulum chaotic?".to_owned(),
            subtitle: format!(
                "Eq. 22, released at rest with the same friction in both axles, followed for {DURATION} s"
            ),
            size: (1600, 820),
            legend: legend
                .map(|(gamma, line)| (line, format!("γ = {gamma} N m s")))
                .collect(),
            columns: self.releases.iter().map(column).collect(),
            rows: vec![Row {
                caption: format!(
                    "left: {}; right: {}",
                    self.releases[0].caption, self.releases[1].caption
                ),
                legend: Vec::new(),
                panels: self.releases.iter().map(panel).collect(),
            }],
        }
    }

    /// The sections as densities.
    pub(crate) fn atlas(&self) -> Atlas {
        Atlas {
            title: "Poincare sections over the amplitude: regular motion keeps to a curve, chaos does not".to_owned(),
            subtitle: format!(
                "Eq. 22 without friction, {SECTION} s: the lower plate where the upper one swings forth through its lowest place; white: never"
            ),
            legend: Vec::new(),
            columns: 2,
            maps: self.releases.iter().map(|release| self.map(release)).collect(),
        }
    }

    fn map(&self, release: &Release) -> Map {
        let size = self.amplitudes.len();
        let largest = release
            .sections
            .iter()
            .flatten()
            .fold(0.0, |largest: f64, rate| largest.max(rate.abs()));
        let most = largest.ceil();
        let mut cells = vec![0.0; size * size];
        for (column, rates) in release.sections.iter().enumerate() {
            for rate in rates {
                let row = ((0.5 + 0.5 * rate / most) * size as f64) as usize;
                cells[row.min(size - 1) * size + column] += 100.0 / rates.len() as f64;
            }
        }
        Map {
            x: self.axis(),
            y: Axis {
                label: "rate of the lower plate (rad/s)".to_owned(),
                scale: Scale::Linear,
                range: -most..most,
                ticks: 8,
            },
            colors: Axis {
                label: format!("{}: share of the passages (%)", release.caption),
                scale: Scale::Decades,
                range: -1.0..2.0,
                ticks: 4,
            },
            steps: 64,
            cells: cells
                .into_iter()
                .map(|share| if share > 0.0 { share.log10() } else { f64::NAN })
                .collect(),
            across: size,
            curves: Vec::new(),
        }
    }

    fn axis(&self) -> Axis {
        Axis {
            label: "amplitude a (°)".to_owned(),
            scale: Scale::Linear,
            range: 0.0..180.0,
            ticks: 10,
        }
    }
}

impl fmt::Display for Amplitudes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} amplitudes, released at rest, each followed for {DURATION} s",
            self.amplitudes.len()
        )?;
        for Release {
            caption,
            exponents,
            sections,
        } in &self.releases
        {
            write!(
                f,
                "\n  {caption}; {} passages",
                sections.iter().map(Vec::len).sum::<usize>()
            )?;
            for (gamma, exponents) in FRICTIONS.iter().zip(exponents) {
                let chaotic = exponents
                    .iter()
                    .filter(|&&exponent| exponent > chaos_above(DURATION))
                    .count();
                let share = 100.0 * chaotic as f64 / exponents.len() as f64;
                let most = exponents.iter().copied().fold(f64::NEG_INFINITY, f64::max);
                write!(
                    f,
                    "\n    friction {gamma} N m s: finite-time exponents up to {most:.3} /s; {share:.1} % chaotic"
                )?;
                if let Some(first) = exponents.iter().position(|&exponent| exponent > chaos_above(DURATION)) {
                    write!(f, ", the first at {:.1} degrees", self.amplitudes[first])?;
                }
            }
        }
        Ok(())
    }
}
