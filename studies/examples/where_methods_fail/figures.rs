//! Figures of the energy over time, of steps over friction, and of the horizon of prediction.

use pendulum_core::prelude::*;
use pendulum_core::stability::StabilityError;

use charts::chart::{Axis, Column, Curve, Figure, Line, Row, Scale};
use charts::methods::{legend, line};
use charts::page::RGBColor;
use testbed::scenes::DoublePendulum;
use testbed::scenes::double_pendulum;
use testbed::where_methods_fail::{chaos, energy, friction};

const PREDICTED: Line = Line {
    width: 1.6,
    ..Line::solid(RGBColor(170, 170, 170))
};

/// Largest relative energy error so far, over time.
pub(crate) fn energy() -> Figure {
    let panel = |x0: [f64; 4]| {
        vec![
            energy_of("Rk4", &Rk4::new(energy::H), x0),
            energy_of("Rk45", &Rk45::new().rtol(1e-6).atol(1e-6), x0),
            energy_of("Taylor", &Taylor::new().rtol(1e-12).atol(1e-12), x0),
            energy_of("Gauss4", &Gauss4::new(energy::H), x0),
            energy_of("Gauss6", &Gauss6::new(energy::H), x0),
        ]
    };
    let column = |title: &str| {
        Column::new(
            title,
            Axis::decades("time (s)", -1.0..energy::TIME.log10() + 0.5),
            Axis {
                ticks: 8,
                ..Axis::decades("relative error of the energy", -16.0..-2.0)
            },
        )
    };
    Figure {
        title: "Energy over time, without friction".to_owned(),
        subtitle: "Largest error so far; Rk4 and Gauss with h = 0.02 s, Rk45 with tolerances of 1e-6, Taylor of 1e-12"
            .to_owned(),
        size: (1600, 900),
        legend: legend(),
        columns: vec![column("Regular motion"), column("Chaotic motion")],
        rows: vec![Row::new(vec![panel(energy::REGULAR), panel(energy::CHAOTIC)])],
    }
}

fn energy_of(name: &str, method: &impl Method<DoublePendulum, f64, 4>, x0: [f64; 4]) -> Curve {
    const POINTS: f64 = 6.0;
    let mut largest = 0.0_f64;
    let mut points: Vec<(f64, f64)> = Vec::new();
    for (t, error) in energy::errors(method, &double_pendulum(0.0), x0) {
        largest = largest.max(error.abs());
        let t = t.log10();
        // one point per fraction of a decade
        if points
            .last()
            .is_none_or(|last| (last.0 * POINTS).floor() < (t * POINTS).floor())
        {
            points.push((t, largest.max(1e-16).log10()));
        }
    }
    Curve {
        label: Some(name.to_owned()),
        ..Curve::new(line(name), points)
    }
}

/// Number of steps over friction: it increases for explicit methods and decreases for implicit ones.
pub(crate) fn friction() -> Figure {
    const TOLERANCE: f64 = 1e-6;
    let exponents: Vec<f64> = (0..=16).map(|n| 0.25 * f64::from(n)).collect();
    let curve = |line: Line, steps: &dyn Fn(f64) -> f64| {
        let point = |&gamma: &f64| (gamma, steps(10_f64.powf(gamma)).log10());
        Curve::new(line, exponents.iter().map(point).collect())
    };
    let mut curves = Vec::new();
    macro_rules! observed {
        ($($name:literal: $method:ident),*) => {$(
            let method = $method::new().rtol(TOLERANCE).atol(TOLERANCE);
            let steps = |gamma| friction::work(&method, gamma).accepted as f64;
            curves.push(Curve { label: Some($name.to_owned()), ..curve(line($name), &steps) });
        )*};
    }
    macro_rules! predicted {
        ($($name:literal: $method:ident),*) => {$(
            let method = $method::new().rtol(TOLERANCE).atol(TOLERANCE);
            let steps = |gamma| friction::stable_steps(&method, gamma);
            let mut limit = curve(PREDICTED, &steps);
            limit.name = Some(concat!("stability limit of ", $name, ", predicted").to_owned());
            // with so few steps, the error limits them
            limit.points.retain(|point| point.1 > 1.0);
            curves.push(limit);
        )*};
    }
    observed!("Rk45": Rk45, "Vern9": Vern9, "Taylor": Taylor, "Rodas5P": Rodas5P, "Radau5": Radau5, "Auto": Auto);
    predicted!("Rk45": Rk45, "Vern9": Vern9, "Taylor": Taylor);
    Figure {
        title: "Steps against friction".to_owned(),
        subtitle: "Double pendulum, Eq. 22, from rest at (1, −1) rad, 10 s with tolerances of 1e-6".to_owned(),
        size: (1200, 880),
        legend: [legend(), vec![(PREDICTED, "stability limit, predicted".to_owned())]].concat(),
        columns: vec![Column::new(
            "",
            Axis::decades("friction γ of both axles (N m s)", 0.0..4.4),
            Axis::decades("accepted steps", 0.7..5.0),
        )],
        rows: vec![Row::new(vec![curves])],
    }
}

/// Horizon of prediction over the tolerance.
pub(crate) fn horizon() -> Result<Figure, StabilityError> {
    const STARTS: u32 = 64;
    let exponents = chaos::exponents_of_start(4e4)?;
    let tolerances = || (6..=24).map(|n| 10_f64.powf(-0.5 * f64::from(n)));
    let points = |time: &dyn Fn(f64) -> f64| {
        tolerances()
            .map(|tolerance| (-tolerance.log10(), time(tolerance)))
            .collect()
    };
    let observed = Curve {
        label: Some("Vern7".to_owned()),
        ..Curve::new(line("Vern7"), points(&|tolerance| chaos::horizon(tolerance, STARTS)))
    };
    let predicted = Curve::new(
        PREDICTED,
        points(&|tolerance| exponents.horizon(tolerance, chaos::LOST)),
    );
    Ok(Figure {
        title: "The horizon of prediction against the tolerance".to_owned(),
        subtitle: format!(
            "Time until a chaotic motion is off by {} rad or rad/s: mean of {STARTS} starts near (2, 2.5) rad",
            chaos::LOST
        ),
        size: (1200, 880),
        legend: vec![(
            PREDICTED,
            format!(
                "predicted: ln({} / tolerance) / λ with the Lyapunov exponent λ = {:.3} 1/s",
                chaos::LOST,
                exponents.values[0]
            ),
        )],
        columns: vec![Column::new(
            "",
            Axis {
                scale: Scale::Falling,
                ticks: 10,
                ..Axis::decades("tolerance", 3.0..12.8)
            },
            Axis::linear("time (s)", 0.0..20.0),
        )],
        rows: vec![Row::new(vec![vec![predicted, observed]])],
    })
}
