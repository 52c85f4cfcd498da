//! Figure 2 of the paper: angles and rates for three values of friction.

use std::error::Error;

use pendulum_core::{OutsideSpan, Solution};

use charts::chart::{Axis, Column, Curve, Figure, Line, Row};
use charts::page::{BLUE, VERMILION};

const UPPER: Line = Line::solid(BLUE);
const LOWER: Line = Line::dashed(VERMILION);

/// Number of points for each curve, enough for a smooth line.
const POINTS: u32 = 800;

/// Figure with a row of panels for each solution, named by its friction.
pub(crate) fn figure2(runs: &[(f64, Solution<f64, 4>)], t_end: f64) -> Result<Figure, Box<dyn Error>> {
    let rows = runs.iter().map(|(gamma, solution)| row(*gamma, solution, t_end));
    Ok(Figure {
        title: "Compound double pendulum with friction, released from rest at θ₁ = 0°, θ₂ = 4°".to_owned(),
        subtitle: "After Williams (2023), Fig. 2: equal plates, m = 1 kg, inertia 1 kg m², c = d = 1 m; g = 9.8 m/s²; \
                   γ₁ = γ₂ = γ"
            .to_owned(),
        size: (1600, 1500),
        legend: vec![
            (UPPER, "upper plate: θ₁ and dθ₁/dt".to_owned()),
            (LOWER, "lower plate: θ₂ and dθ₂/dt".to_owned()),
        ],
        columns: [
            ("angles", "angle θ (°)", -4.6..4.6),
            ("rates", "rate dθ/dt (°/s)", -11.5..11.5),
        ]
        .map(|(title, label, range)| {
            Column::new(
                title,
                Axis::linear("time t (s)", 0.0..t_end),
                Axis::linear(label, range),
            )
        })
        .into(),
        rows: rows.collect::<Result<_, _>>()?,
    })
}

fn row(gamma: f64, solution: &Solution<f64, 4>, t_end: f64) -> Result<Row, OutsideSpan> {
    let times: Vec<f64> = (0..=POINTS).map(|n| t_end * f64::from(n) / f64::from(POINTS)).collect();
    let states = solution.sample(times.iter().copied())?;
    let curve = |line, component: usize| {
        let degrees = states.iter().map(|x| x[component].to_degrees());
        Curve::new(line, times.iter().copied().zip(degrees).collect())
    };
    Ok(Row {
        caption: format!("γ = {gamma} N m s"),
        legend: Vec::new(),
        panels: vec![
            vec![curve(UPPER, 0), curve(LOWER, 1)],
            vec![curve(UPPER, 2), curve(LOWER, 3)],
        ],
    })
}
