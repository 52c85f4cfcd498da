//! Equilibria over the friction of both joints: decay of the hanging state, growth at the inverted ones.

use std::error::Error;
use std::fmt;

use pendulum_core::prelude::SVector;
use pendulum_core::stability::{Equilibrium, Stability, equilibria};

use crate::progress::on_all_cores;
use crate::scene::DoublePendulum;
use charts::chart::{Axis, Scale};
use charts::heat::{Atlas, Map, Palette};

/// Smallest friction, as a power of ten in N m s.
const LEAST: f64 = -3.0;
/// Largest friction, as a power of ten in N m s.
const MOST: f64 = 4.0;

/// Grid of `size` by `size` pairs of frictions.
pub(crate) struct Frictions {
    size: usize,
    pairs: Vec<Pair>,
}

/// Results of the linear theory for a pair; rates in 1/s.
struct Pair {
    /// Decay rate of the slowest mode of the hanging state.
    decay: f64,
    /// Number of oscillatory modes of the hanging state.
    swinging: usize,
    /// Ratio of the decay rates of its fastest and its slowest mode.
    stiffness: f64,
    /// Smallest growth rate of the three inverted states, each by its fastest mode.
    growth: f64,
}

pub(crate) fn measure(size: usize) -> Result<Frictions, Box<dyn Error>> {
    let gamma = |n: usize| 10.0_f64.powf(LEAST + (MOST - LEAST) * (n as f64 + 0.5) / size as f64);
    let pendulums = (0..size * size).map(|n| DoublePendulum::with_friction(gamma(n % size), gamma(n / size)));
    let pendulums = pendulums.collect::<Result<Vec<_>, _>>()?;
    let pairs = on_all_cores("equilibria over friction", &pendulums, |pendulum| {
        let found = equilibria(pendulum, [SVector::zeros()]).map_err(|error| error.to_string())?;
        let kinds = || found.iter().map(Equilibrium::stability).collect::<Vec<_>>();
        Pair::of(&found).ok_or_else(|| format!("not one stable and three unstable equilibria: {:?}", kinds()))
    });
    Ok(Frictions { size, pairs: pairs? })
}

impl Pair {
    /// Evaluates the hanging state and the three inverted ones; `None` if one of them has not the stability expected
    /// with friction.
    fn of(equilibria: &[Equilibrium<4>]) -> Option<Self> {
        let [hanging, inverted @ ..] = equilibria else {
            return None;
        };
        let as_expected = hanging.stability() == Stability::AsymptoticallyStable
            && inverted.len() == 3
            && inverted.iter().all(|state| state.stability() == Stability::Unstable);
        let modes = hanging.spectrum.modes();
        let decays = || modes.iter().map(|mode| -mode.growth_rate());
        let fastest = decays().fold(0.0, f64::max);
        let decay = decays().fold(f64::INFINITY, f64::min);
        let growth = inverted.iter().map(|state| state.spectrum.modes()[0].growth_rate());
        as_expected.then(|| Self {
            decay,
            swinging: modes.iter().filter(|mode| mode.angular_frequency() > 0.0).count() / 2,
            stiffness: fastest / decay,
            growth: growth.fold(f64::INFINITY, f64::min),
        })
    }
}

impl Frictions {
    pub(crate) fn atlas(&self) -> Atlas {
        let axis = |label: &str| Axis {
            label: label.to_owned(),
            scale: Scale::Decades,
            range: LEAST..MOST,
            ticks: 8,
        };
        let map = |colors: Axis, steps: usize, value: &dyn Fn(&Pair) -> f64| Map {
            x: axis("friction of the upper axle γ₁ (N m s)"),
            y: axis("friction of the lower axle γ₂ (N m s)"),
            colors,
            palette: Palette::Rising,
            steps,
            cells: self.pairs.iter().map(value).collect(),
            across: self.size,
            curves: Vec::new(),
        };
        let decades = |label: &str, value: fn(&Pair) -> f64| {
            let (least, most) = self.range(value);
            let colors = Axis {
                label: label.to_owned(),
                scale: Scale::Decades,
                range: least.log10().floor()..most.log10().ceil(),
                ticks: 8,
            };
            map(colors, 128, &|pair| value(pair).log10())
        };
        let swinging = Axis {
            label: "Hanging: how many of the two modes swing".to_owned(),
            scale: Scale::Linear,
            range: -0.5..2.5,
            ticks: 3,
        };
        Atlas {
            title: "Friction never makes the hanging state unstable, and never holds up an inverted one".to_owned(),
            subtitle: "Eigenvalues of the generated Jacobian at the four equilibria of the double pendulum, Eq. 22"
                .to_owned(),
            legend: Vec::new(),
            columns: 2,
            maps: vec![
                decades("Hanging: decay rate of the slowest mode (1/s)", |pair| pair.decay),
                map(swinging, 3, &|pair| pair.swinging as f64),
                decades("Hanging: decay rates, fastest over slowest", |pair| pair.stiffness),
                decades("Inverted: growth rate, smallest of the three (1/s)", |pair| pair.growth),
            ],
        }
    }

    fn range(&self, value: impl Fn(&Pair) -> f64) -> (f64, f64) {
        let values = || self.pairs.iter().map(&value);
        (values().fold(f64::INFINITY, f64::min), values().fold(0.0, f64::max))
    }
}

impl fmt::Display for Frictions {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let count = self.pairs.len();
        writeln!(
            f,
            "{count} pairs of frictions, 1e{LEAST} to 1e{MOST} N m s: the hanging state is asymptotically stable, the \
            inverted ones are unstable, at all of them"
        )?;
        let (least, most) = self.range(|pair| pair.decay);
        writeln!(f, "  decay rate of the slowest mode {least:.2e} to {most:.2e} /s")?;
        let (least, most) = self.range(|pair| pair.stiffness);
        writeln!(f, "  decay rates, fastest over slowest, {least:.3} to {most:.2e}")?;
        let share = |swinging| {
            let pairs = self.pairs.iter().filter(|pair| pair.swinging == swinging);
            100.0 * pairs.count() as f64 / count as f64
        };
        let [none, one, two] = [0, 1, 2].map(share);
        writeln!(
            f,
            "  two modes swing at {two:.1} % of the pairs, one at {one:.1} %, none at {none:.1} %"
        )?;
        let (least, most) = self.range(|pair| pair.growth);
        write!(
            f,
            "  growth rate at the inverted states, least of the three, {least:.2e} to {most:.2e} /s"
        )
    }
}
