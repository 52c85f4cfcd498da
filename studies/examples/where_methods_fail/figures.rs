//! The energy over time, steps against friction, and the horizon of prediction.

use std::ops::Range;

use pendulum_core::prelude::*;
use pendulum_core::stability::StabilityError;

use charts::chart::{Axis, Column, Curve, Figure, Line, Row, Scale};
use charts::methods::line;
use charts::page::{BLUE, INK};
use testbed::scenes::DoublePendulum;
use testbed::where_methods_fail::scenes::double_pendulum;
use testbed::where_methods_fail::{chaos, energy, friction};

fn axis(label: &str, scale: Scale, range: Range<f64>, ticks: usize) -> Axis {
    Axis {
        label: label.to_owned(),
        scale,
        range,
        ticks,
    }
}

/// The largest relative errors of the energy so far.
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
    let column = |name: &str| Column {
        x: axis("time (s)", Scale::Decades, -1.0..energy::TIME.log10(), 4),
        y: axis(
            &format!("{name}: relative error of the energy"),
            Scale::Decades,
            -16.0..0.0,
            8,
        ),
    };
    Figure {
        title: "Energy over time, without friction".to_owned(),
        subtitle: "Largest error so far. Rk4 and Gauss with h = 0.02 s, Rk45 within 1e-6, Taylor within 1e-12"
            .to_owned(),
        size: (1600, 860),
        legend: Vec::new(),
        columns: vec![column("regular"), column("chaotic")],
        rows: vec![Row {
            caption: String::new(),
            legend: Vec::new(),
            panels: vec![panel(energy::REGULAR), panel(energy::CHAOTIC)],
        }],
    }
}

fn energy_of(name: &str, method: &impl Method<DoublePendulum, f64, 4>, x0: [f64; 4]) -> Curve {
    const POINTS: f64 = 12.0;
    let mut largest = 0.0_f64;
    let mut points: Vec<(f64, f64)> = Vec::new();
    for (t, error) in energy::errors(method, &double_pendulum(0.0), x0) {
        largest = largest.max(error.abs());
        let t = t.log10();
        // one point in each part of a decade
        if points
            .last()
            .is_none_or(|last| (last.0 * POINTS).floor() < (t * POINTS).floor())
        {
            points.push((t, largest.max(1e-16).log10()));
        }
    }
    Curve {
        line: line(name),
        points,
        label: Some(name.to_owned()),
    }
}

/// Steps of explicit methods grow with friction, those of implicit ones fall.
pub(crate) fn friction() -> Figure {
    const TOLERANCE: f64 = 1e-6;
    let exponents: Vec<f64> = (0..=16).map(|n| 0.25 * f64::from(n)).collect();
    let curve = |name: &str, line: Line, steps: &dyn Fn(f64) -> f64| Curve {
        line,
        points: exponents
            .iter()
            .map(|&gamma| (gamma, steps(10_f64.powf(gamma)).log10()))
            .collect(),
        label: Some(name.to_owned()).filter(|name| !name.is_empty()),
    };
    let mut curves = Vec::new();
    macro_rules! observed {
        ($($name:literal: $method:ident),*) => {$(
            let method = $method::new().rtol(TOLERANCE).atol(TOLERANCE);
            let steps = |gamma| friction::work(&method, gamma).accepted as f64;
            curves.push(curve($name, line($name), &steps));
        )*};
    }
    macro_rules! predicted {
        ($($name:literal: $method:ident),*) => {$(
            let method = $method::new().rtol(TOLERANCE).atol(TOLERANCE);
            let steps = |gamma| friction::stable_steps(&method, gamma);
            let thin = Line { width: 1.6, ..Line::dashed(INK) };
            curves.push(curve("", thin, &steps));
        )*};
    }
    observed!("Rk45": Rk45, "Vern9": Vern9, "Taylor": Taylor, "Rodas5P": Rodas5P, "Radau5": Radau5, "Auto": Auto);
    predicted!("Rk45": Rk45, "Vern9": Vern9, "Taylor": Taylor);
    Figure {
        title: "Steps against friction".to_owned(),
        subtitle: "Eq. 22 from (1, −1), 10 s within 1e-6. Thin: what stability asks for, by the generated Jacobian"
            .to_owned(),
        size: (1200, 860),
        legend: Vec::new(),
        columns: vec![Column {
            x: axis("friction γ of both axles (N m s)", Scale::Decades, 0.0..4.0, 5),
            y: axis("accepted steps", Scale::Decades, 1.0..5.0, 5),
        }],
        rows: vec![Row {
            caption: String::new(),
            legend: Vec::new(),
            panels: vec![curves],
        }],
    }
}

/// How long a motion can be told ahead.
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
        line: Line::solid(BLUE),
        points: points(&|tolerance| chaos::horizon(tolerance, STARTS)),
        label: Some("Vern7".to_owned()),
    };
    let predicted = Curve {
        line: Line::dashed(INK),
        points: points(&|tolerance| exponents.horizon(tolerance, chaos::LOST)),
        label: None,
    };
    Ok(Figure {
        title: "The horizon of prediction against the tolerance".to_owned(),
        subtitle: format!(
            "Time to an error of {}, mean of {STARTS} starts near (2, 2.5). Dashed: ln({} / tolerance) / λ, λ = {:.3} / s",
            chaos::LOST,
            chaos::LOST,
            exponents.values[0]
        ),
        size: (1200, 860),
        legend: Vec::new(),
        columns: vec![Column {
            x: axis("tolerance", Scale::Falling, 3.0..12.0, 9),
            y: axis("time (s)", Scale::Linear, 0.0..24.0, 6),
        }],
        rows: vec![Row {
            caption: String::new(),
            legend: Vec::new(),
            panels: vec![vec![predicted, observed]],
        }],
    })
}
