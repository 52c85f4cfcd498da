//! Chaos over the amplitude, with and without friction.
//!
//! With friction every motion comes to rest, and the exponent in the long run is the negative one of the slowest mode
//! at rest. A positive exponent over a finite time measures the transient chaos.

use std::error::Error;
use std::fmt;

use charts::page::RGBColor;
use pendulum_core::prelude::*;
use pendulum_core::stability::Lyapunov;

use crate::progress::on_all_cores;
use crate::scene::{DoublePendulum, chaos_above};
use charts::chart::{Axis, Column, Curve, Figure, Line, Row};
use charts::page::{BLUE, INK, ORANGE, VERMILION};

/// Friction of both joints, in N m s.
const FRICTIONS: [f64; 4] = [0.0, 0.003, 0.03, 0.3];
/// Initial angles of both plates, as multiples of the amplitude.
const RELEASES: [([f64; 2], &str); 2] = [([0.0, 1.0], "θ₁ = 0, θ₂ = a"), ([1.0, 1.0], "θ₁ = θ₂ = a")];
/// Time over which exponents are measured, in s.
const DURATION: f64 = 200.0;
const TOLERANCE: f64 = 1e-7;
const COLORS: [RGBColor; FRICTIONS.len()] = [INK, BLUE, ORANGE, VERMILION];

/// Results for all releases.
pub(crate) struct Amplitudes {
    /// Amplitudes, in degrees.
    amplitudes: Vec<f64>,
    releases: Vec<Release>,
}

/// Motions of one release over the amplitude.
struct Release {
    caption: &'static str,
    /// Largest Lyapunov exponents over [`DURATION`], in 1/s, for each friction.
    exponents: Vec<Vec<f64>>,
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
        releases.push(Release {
            caption,
            exponents: exponents.chunks(size).map(<[f64]>::to_vec).collect(),
        });
    }
    Ok(Amplitudes { amplitudes, releases })
}

/// Initial condition at rest.
fn start([theta1, theta2]: [f64; 2], degrees: f64) -> SVector<f64, 4> {
    let amplitude = degrees.to_radians();
    SVector::from([theta1 * amplitude, theta2 * amplitude, 0.0, 0.0])
}

impl Amplitudes {
    pub(crate) fn figure(&self) -> Figure {
        let lines = COLORS.map(Line::solid);
        let column = |release: &Release| {
            let exponents = || release.exponents.iter().flatten().copied();
            let least = exponents().fold(f64::INFINITY, f64::min);
            let most = exponents().fold(f64::NEG_INFINITY, f64::max);
            Column::new(
                &format!("Released at {}", release.caption),
                Axis {
                    ticks: 10,
                    ..Axis::linear("amplitude a (°)", 0.0..180.0)
                },
                Axis::linear(
                    "largest finite-time exponent (1/s)",
                    (20.0 * least).floor() / 20.0..(20.0 * most).ceil() / 20.0,
                ),
            )
        };
        let panel = |release: &Release| -> Vec<Curve> {
            let curves = release.exponents.iter().zip(lines);
            let curve = |(exponents, line): (&Vec<f64>, Line)| {
                let points = self.amplitudes.iter().copied().zip(exponents.iter().copied());
                Curve::new(Line { width: 2.2, ..line }, points.collect())
            };
            curves.map(curve).collect()
        };
        let legend = FRICTIONS.iter().zip(lines);
        Figure {
            title: "At which amplitudes is the double pendulum chaotic?".to_owned(),
            subtitle: format!(
                "Eq. 22, released at rest with equal friction γ in both axles, followed for {DURATION} s"
            ),
            size: (1600, 820),
            legend: legend
                .map(|(gamma, line)| (line, format!("γ = {gamma} N m s")))
                .collect(),
            columns: self.releases.iter().map(column).collect(),
            rows: vec![Row::new(self.releases.iter().map(panel).collect())],
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
        for Release { caption, exponents } in &self.releases {
            write!(f, "\n  {caption}")?;
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
