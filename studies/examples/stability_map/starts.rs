//! Map over the initial angles at rest without friction: time at which an angle first passes upright, and largest
//! exponent.

use std::error::Error;
use std::f64::consts::PI;
use std::fmt;

use pendulum_core::prelude::*;
use pendulum_core::stability::{Lyapunov, StabilityError, section};

use crate::progress::on_all_cores;
use crate::scene::{DoublePendulum, chaos_above};
use charts::chart::{Axis, Curve, Line, Scale};
use charts::heat::{Atlas, Map, Palette};
use charts::page::INK;

/// Duration of each motion, in s.
const DURATION: f64 = 100.0;
/// Tolerance of the motion. With exponents near 1/s, errors of 1e-10 grow to the size of the motion within 23 s; beyond
/// that, the map shows a motion that is statistically as likely as the true one.
const TOLERANCE: f64 = 1e-10;
/// Tolerance of the motion with its tangent.
const TANGENT_TOLERANCE: f64 = 1e-7;

/// Grid of `size` by `size` initial conditions.
pub(crate) struct Starts {
    size: usize,
    motions: Vec<Motion>,
}

/// Results for an initial condition.
#[derive(Clone, Copy)]
struct Motion {
    angles: [f64; 2],
    /// Time at which an angle first passed upright, in s.
    flip: Option<f64>,
    /// Largest Lyapunov exponent over [`DURATION`], in 1/s.
    exponent: f64,
}

pub(crate) fn measure(size: usize) -> Result<Starts, Box<dyn Error>> {
    let pendulum = DoublePendulum::with_friction(0.0, 0.0)?;
    let angle = |n: usize| PI * ((2 * n + 1) as f64 / size as f64 - 1.0);
    // The mirror image of a motion starts at the opposite angles, at the mirrored index of the list.
    let half: Vec<_> = (0..(size * size).div_ceil(2))
        .map(|n| [angle(n % size), angle(n / size)])
        .collect();
    let flips = on_all_cores("flips over starts", &half, |angles| flip(&pendulum, angles))?;
    let lyapunov = Lyapunov::new().tolerance(TANGENT_TOLERANCE).duration(DURATION);
    let exponents = on_all_cores("exponents over starts", &half, |&[theta1, theta2]| {
        lyapunov.largest(&pendulum, [theta1, theta2, 0.0, 0.0])
    })?;
    let motions = half.iter().zip(flips).zip(exponents);
    let mut motions: Vec<_> = motions
        .map(|((&angles, flip), exponent)| Motion {
            angles,
            flip,
            exponent: exponent.values[0],
        })
        .collect();
    let mirrored = size * size - motions.len();
    for n in (0..mirrored).rev() {
        let angles = motions[n].angles.map(|angle| -angle);
        motions.push(Motion { angles, ..motions[n] });
    }
    if let Some(motion) = motions
        .iter()
        .find(|motion| motion.flip.is_some() && !motion.can_flip())
    {
        let [theta1, theta2] = motion.angles;
        return Err(format!(
            "from ({theta1}, {theta2}) rad a flip is found that energy does not allow: the integration went wrong"
        )
        .into());
    }
    Ok(Starts { size, motions })
}

/// Time at which an angle first passes upright, if it does.
fn flip(pendulum: &DoublePendulum, &[theta1, theta2]: &[f64; 2]) -> Result<Option<f64>, StabilityError> {
    // The cosine of half an angle changes its sign at all odd multiples of a half turn.
    let upright = Event::new(|_t, x: &SVector<f64, 4>| (0.5 * x[0]).cos() * (0.5 * x[1]).cos())
        .falling()
        .terminal();
    let method = Taylor::new().rtol(TOLERANCE).atol(TOLERANCE);
    let flips = section(&method, pendulum, 0.0, DURATION, [theta1, theta2, 0.0, 0.0], &upright)?;
    Ok(flips.first().map(|flip| flip.t))
}

impl Motion {
    /// True if the energy suffices for an angle to pass upright. This takes at least the energy of the state in which
    /// the lower plate stands and the upper one hangs.
    ///
    /// The potential energy is `-m g d (2 cos(theta1) + cos(theta2))`; in that state it is `-m g d (2 - 1)`.
    fn can_flip(&self) -> bool {
        let [theta1, theta2] = self.angles;
        2.0 * theta1.cos() + theta2.cos() <= 1.0
    }
}

/// Initial angles, in units of pi, with just enough energy for a flip.
fn bound() -> Vec<(f64, f64)> {
    let steps = 200;
    let upper = |n: i32| PI / 2.0 * f64::from(n) / f64::from(steps);
    let points = |sign: f64| move |n: i32| (upper(n) / PI, sign * (1.0 - 2.0 * upper(n).cos()).acos() / PI);
    (-steps..=steps)
        .map(points(1.0))
        .chain((-steps..=steps).rev().map(points(-1.0)))
        .collect()
}

impl Starts {
    pub(crate) fn atlas(&self) -> Atlas {
        let axis = |label: &str| Axis {
            label: label.to_owned(),
            scale: Scale::Linear,
            range: -1.0..1.0,
            ticks: 5,
        };
        let line = Line {
            width: 2.4,
            ..Line::dashed(INK)
        };
        let map = |colors: Axis, palette: Palette, value: &dyn Fn(&Motion) -> f64| Map {
            x: axis("angle of the upper plate θ₁ / π"),
            y: axis("angle of the lower plate θ₂ / π"),
            colors,
            palette,
            steps: 64,
            cells: self.motions.iter().map(value).collect(),
            across: self.size,
            curves: vec![Curve::new(line, bound())],
        };
        let flips = Axis {
            label: "First flip (s)".to_owned(),
            scale: Scale::Decades,
            range: 0.0..DURATION.log10(),
            ticks: 7,
        };
        let exponents = Axis {
            label: "Largest finite-time Lyapunov exponent (1/s)".to_owned(),
            scale: Scale::Linear,
            range: 0.0..(10.0 * self.exponents().1).ceil() / 10.0,
            ticks: 8,
        };
        Atlas {
            title: "Which starts at rest flip, and which are chaotic?".to_owned(),
            subtitle: format!(
                "Double pendulum, Eq. 22, without friction, followed for {DURATION} s; white: no flip in that \
                time, or a zero exponent"
            ),
            legend: vec![(line, "just enough energy for a flip: 2 cos θ₁ + cos θ₂ = 1".to_owned())],
            columns: 2,
            maps: vec![
                map(flips, Palette::Rising, &|motion| {
                    motion.flip.map_or(f64::NAN, f64::log10)
                }),
                map(exponents, Palette::Signed, &|motion| motion.exponent),
            ],
        }
    }

    fn exponents(&self) -> (f64, f64) {
        let exponents = || self.motions.iter().map(|motion| motion.exponent);
        (
            exponents().fold(f64::INFINITY, f64::min),
            exponents().fold(f64::NEG_INFINITY, f64::max),
        )
    }

    /// Share of all initial conditions, in percent.
    fn share(&self, of: impl Fn(&&Motion) -> bool) -> f64 {
        100.0 * self.motions.iter().filter(of).count() as f64 / self.motions.len() as f64
    }
}

impl fmt::Display for Starts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "{} starts at rest without friction, each followed for {DURATION} s",
            self.motions.len()
        )?;
        let first = self
            .motions
            .iter()
            .filter_map(|motion| motion.flip)
            .fold(f64::INFINITY, f64::min);
        let [can, does] = [
            self.share(|motion| motion.can_flip()),
            self.share(|motion| motion.flip.is_some()),
        ];
        writeln!(
            f,
            "  energy allows {can:.2} % to flip; {does:.2} % do, the first after {first:.2} s; of the others none does"
        )?;
        let (least, most) = self.exponents();
        writeln!(f, "  finite-time Lyapunov exponent {least:.3} to {most:.3} /s")?;
        let chaotic = |motion: &Motion| motion.exponent > chaos_above(DURATION);
        write!(
            f,
            "  {:.2} % are chaotic (above {:.3} /s), {:.2} % with too little energy for a flip; {:.2} % flip and are \
            not chaotic",
            self.share(|motion| chaotic(motion)),
            chaos_above(DURATION),
            self.share(|motion| chaotic(motion) && !motion.can_flip()),
            self.share(|motion| !chaotic(motion) && motion.flip.is_some()),
        )
    }
}
