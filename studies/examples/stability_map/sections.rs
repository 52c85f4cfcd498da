//! Poincare sections without friction: all motions of one energy, at the instants at which the upper plate swings
//! forward through its lowest position.

use std::error::Error;
use std::f64::consts::PI;
use std::fmt;

use pendulum_core::Occurrence;
use pendulum_core::prelude::*;
use pendulum_core::stability::{Lyapunov, section};

use crate::progress::on_all_cores;
use crate::scene::{DoublePendulum, chaos_above};
use charts::chart::{Axis, Column, Curve, Figure, Line, Row, Stroke};
use charts::page::{BLUE, RGBColor, VERMILION};

/// Energies above hanging at rest, in J.
const ENERGIES: [f64; 3] = [12.0, 21.0, 26.0];
/// Number of initial conditions along each of two lines: with the momentum [`MOMENTUM`] of the lower plate, and with
/// the lower plate hanging.
const STARTS: usize = 16;
/// Momentum of the lower plate on the first line, in kg m^2/s, which passes through the large islands.
const MOMENTUM: f64 = -2.0;
/// Duration of a section, in s.
const DURATION: f64 = 2000.0;
/// Time over which exponents are measured, in s.
const EXPONENT: f64 = 500.0;
const TOLERANCE: f64 = 1e-10;
const TANGENT_TOLERANCE: f64 = 1e-7;
/// Maximum energy error at each passage, in J.
const DRIFT: f64 = 1e-6;

const REGULAR: Line = dots(BLUE);
const CHAOTIC: Line = dots(VERMILION);

const fn dots(color: RGBColor) -> Line {
    Line {
        width: 1.6,
        stroke: Stroke::Dots,
        ..Line::solid(color)
    }
}

/// Motions of each energy.
pub(crate) struct Sections(Vec<Vec<Motion>>);

/// Points of a motion in the section (angle of the lower plate and its momentum), and whether it is chaotic.
struct Motion {
    points: Vec<(f64, f64)>,
    chaotic: bool,
}

pub(crate) fn measure() -> Result<Sections, Box<dyn Error>> {
    let pendulum = DoublePendulum::with_friction(0.0, 0.0)?;
    let motions = |energy| on_all_cores("sections", &starts(&pendulum, energy), |x0| motion(&pendulum, x0));
    Ok(Sections(
        ENERGIES.into_iter().map(motions).collect::<Result<_, String>>()?,
    ))
}

/// Initial conditions of one energy in the section.
fn starts(pendulum: &DoublePendulum, energy: f64) -> Vec<SVector<f64, 4>> {
    let hanging = pendulum.potential(0.0, &SVector::zeros());
    let inertia = pendulum.mass_matrix(0.0, &SVector::zeros())[(1, 1)];
    let along = |n: usize| (2 * n + 1) as f64 / STARTS as f64 - 1.0;
    let across = (0..STARTS).map(|n| (PI * along(n), MOMENTUM));
    let plumb = (0..STARTS).map(|n| (0.0, (2.0 * inertia * energy).sqrt() * along(n)));
    across
        .chain(plumb)
        .filter_map(|(theta2, momentum2)| {
            let at = SVector::from([0.0, theta2, 0.0, 0.0]);
            let kinetic = energy + hanging - pendulum.potential(0.0, &at);
            // The momentum of the upper plate solves p . W p / 2 = kinetic; of the two solutions one swings forward.
            let w = pendulum.mass_matrix(0.0, &at).try_inverse()?;
            let square = 2.0 * kinetic * w[(0, 0)] - w.determinant() * momentum2 * momentum2;
            let momentum1 = (square.sqrt() - w[(0, 1)] * momentum2) / w[(0, 0)];
            let rates = w * SVector::from([momentum1, momentum2]);
            (square > 0.0).then(|| SVector::from([0.0, theta2, rates[0], rates[1]]))
        })
        .collect()
}

fn motion(pendulum: &DoublePendulum, x0: &SVector<f64, 4>) -> Result<Motion, String> {
    // The sine increases there, and at the highest position on the way back.
    let through = Event::new(|_t, x: &SVector<f64, 4>| x[0].sin()).rising();
    let method = Taylor::new().rtol(TOLERANCE).atol(TOLERANCE);
    let passages = section(&method, pendulum, 0.0, DURATION, *x0, &through).map_err(|error| error.to_string())?;
    let energy = pendulum.energy(0.0, x0);
    let mut points = Vec::new();
    for Occurrence { t, x, .. } in passages {
        let error = (pendulum.energy(t, &x) - energy).abs();
        if error > DRIFT {
            return Err(format!(
                "the energy is {error:.1e} J off at a passage after {t:.3} s: the integration went wrong"
            ));
        }
        if x[0].cos() > 0.0 {
            let momenta = pendulum.mass_matrix(t, &x) * x.fixed_rows::<2>(2);
            let turns = (x[1] / (2.0 * PI)).round();
            points.push((x[1] / PI - 2.0 * turns, momenta[1]));
        }
    }
    let lyapunov = Lyapunov::new().tolerance(TANGENT_TOLERANCE).duration(EXPONENT);
    let exponent = lyapunov.largest(pendulum, *x0).map_err(|error| error.to_string())?;
    Ok(Motion {
        points,
        chaotic: exponent.values[0] > chaos_above(EXPONENT),
    })
}

impl Sections {
    pub(crate) fn figure(&self) -> Figure {
        let most = |motions: &[Motion]| {
            let momenta = motions
                .iter()
                .flat_map(|motion| &motion.points)
                .map(|point| point.1.abs());
            momenta.fold(0.0, f64::max).ceil()
        };
        let column = |(energy, motions): (&f64, &Vec<Motion>)| {
            Column::new(
                &format!("Energy {energy} J above hanging"),
                Axis::linear("angle of the lower plate θ₂ / π", -1.0..1.0),
                Axis::linear("momentum p₂ (kg m²/s)", -most(motions)..most(motions)),
            )
        };
        let panel = |motions: &Vec<Motion>| {
            let curve = |motion: &Motion| {
                let line = if motion.chaotic { CHAOTIC } else { REGULAR };
                Curve::new(line, motion.points.clone())
            };
            motions.iter().map(curve).collect()
        };
        Figure {
            title: "Poincaré sections: regular motions keep to curves, chaotic ones do not".to_owned(),
            subtitle: format!(
                "Double pendulum, Eq. 22, without friction, {DURATION} s: the lower plate whenever the upper one \
                swings forth through its lowest place"
            ),
            size: (1900, 840),
            legend: vec![(REGULAR, "regular".to_owned()), (CHAOTIC, "chaotic".to_owned())],
            columns: ENERGIES.iter().zip(&self.0).map(column).collect(),
            rows: vec![Row::new(self.0.iter().map(panel).collect())],
        }
    }
}

impl fmt::Display for Sections {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Poincare sections, each motion followed for {DURATION} s")?;
        for (energy, motions) in ENERGIES.iter().zip(&self.0) {
            let passages: usize = motions.iter().map(|motion| motion.points.len()).sum();
            let chaotic = motions.iter().filter(|motion| motion.chaotic).count();
            write!(
                f,
                "\n  {energy} J: {} motions, {chaotic} of them chaotic; {passages} passages",
                motions.len()
            )?;
        }
        Ok(())
    }
}
