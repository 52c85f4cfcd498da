//! Lyapunov exponents of a motion that keeps its energy: they come in pairs.

use std::error::Error;

use pendulum_core::Real;
use pendulum_core::prelude::*;
use pendulum_core::stability::Lyapunov;

use super::Answer;

mechanism! {
    /// A double pendulum of two point masses, with both angles against the vertical.
    pub Bobs {
        params { m: kg = 1, l: m = 1, g: m/s^2 = 9.81 }
        gravity: [0, -g, 0],
        shape bob { solids: [point(m, [0, -l, 0])] }
        body upper on ground: bob { joint: revolute(z), coordinate: theta1 absolute }
        body lower on upper: bob { joint: revolute(z) at [0, -l, 0], coordinate: theta2 absolute }
        generate: [rhs, jacobian],
    }
}

/// Angles in rad, less whole turns, and momenta in N m s where `dysts` starts its double pendulum.
const START: [f64; 4] = [-44.334542, 223.53554, -1.2249799, 2.535486];

/// State with rates in place of momenta: those of point masses of 1 kg on rods of 1 m.
fn start() -> [f64; 4] {
    let [a, b, p, q] = START;
    let turn = std::f64::consts::TAU;
    let (sin, cos) = Real::sin_cos(a - b);
    let scale = 1.0 + sin * sin;
    [a % turn, b % turn, (p - q * cos) / scale, (2.0 * q - p * cos) / scale]
}

/// The four exponents in 1/s, and the change of the logarithm of a volume in coordinates and momenta.
///
/// The exponents are those of coordinates and rates, whose volume is that of coordinates and momenta over the
/// determinant of the mass matrix, `1 + sin(theta1 - theta2)^2`.
pub(crate) fn exponents() -> Result<([f64; 4], f64), Box<dyn Error>> {
    let (bobs, start) = (Bobs::new(BobsParams::default())?, start());
    let found = Lyapunov::new()
        .tolerance(1e-10)
        .duration(500.0)
        .exponents::<4, _>(&bobs, start)?;
    let mass = |x: &[f64]| Real::ln(1.0 + Real::sin_cos(x[0] - x[1]).0.powi(2));
    let growth = found.values.iter().sum::<f64>() * found.t;
    Ok((found.values, growth + mass(found.x.as_slice()) - mass(&start)))
}

pub(crate) fn answer() -> Result<Answer, Box<dyn Error>> {
    let ([a, b, c, d], volume) = exponents()?;
    let unpaired = (a + d).abs().max((b + c).abs());
    let text = format!(
        "{a:.2}, {b:.2}, {c:.2} and {d:.2} 1/s; pairs add up to {unpaired:.3} 1/s or less, and a volume's logarithm \
         changes by {:.0e}",
        volume.abs()
    );
    Ok(Answer::new(unpaired, text))
}
