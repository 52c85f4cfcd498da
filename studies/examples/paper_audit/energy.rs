//! Energy without friction under Eq. 22b and Eq. 20 as printed.

use std::error::Error;

use pendulum_core::prelude::*;

use crate::model;
use charts::chart::{Axis, Column, Curve, Figure, Line, Row};
use charts::page::{BLUE, ORANGE, VERMILION};
use testbed::printed::Pendulum;

const RIGHT: Line = Line::solid(BLUE);
const EQ_22B: Line = Line::solid(VERMILION);
const EQ_20: Line = Line::dashed(ORANGE);

/// Initial angles at rest, in rad, each with the range of the energy axis.
const STARTS: [([f64; 2], std::ops::Range<f64>); 2] = [([1.2, -0.6], -4.0..1.0), ([0.5, 2.0], -5.0..20.0)];
const END: f64 = 20.0;
const POINTS: u32 = 800;

pub(crate) fn figure() -> Result<Figure, Box<dyn Error>> {
    println!(
        "Energy without friction within {END} s, less that at the start (J); rest is the energy at the start above \
        hanging"
    );
    let free = model(0.0, 0.0)?;
    let paper = Pendulum::paper(0.0, 0.0);
    let eq22b = FnSystem(|_t, x: &SVector<f64, 4>| paper.eq22b_printed(x));
    let eq20 = FnSystem(|_t, x: &SVector<f64, 4>| paper.eq20_printed(x));
    let mut panels = Vec::new();
    for (start, _) in STARTS {
        panels.push(vec![
            curve("generated", RIGHT, &free, &free, start)?,
            curve("Eq. 20 as printed", EQ_20, &free, &eq20, start)?,
            curve("Eq. 22b as printed", EQ_22B, &free, &eq22b, start)?,
        ]);
    }
    let column = |([theta1, theta2], range): ([f64; 2], _)| {
        Column::new(
            &format!("Released at θ₁ = {theta1}, θ₂ = {theta2} rad").replace('-', "\u{2212}"),
            Axis::linear("time t (s)", 0.0..END),
            Axis::linear("energy gained (J)", range),
        )
    };
    Ok(Figure {
        title: "Without friction, the printed equations do not conserve energy".to_owned(),
        subtitle: "Two plates, released from rest; m = 1 kg, I = 1 kg m², c = d = 1 m, g = 9.8 m/s²".to_owned(),
        size: (1600, 720),
        legend: vec![
            (RIGHT, "generated".to_owned()),
            (EQ_22B, "Eq. 22b as printed".to_owned()),
            (EQ_20, "Eq. 20 as printed".to_owned()),
        ],
        columns: STARTS.map(column).into(),
        rows: vec![Row {
            caption: String::new(),
            legend: Vec::new(),
            panels,
        }],
    })
}

fn curve(
    name: &str,
    line: Line,
    free: &impl Energy<f64, 4>,
    system: &impl System<f64, 4>,
    [theta1, theta2]: [f64; 2],
) -> Result<Curve, Box<dyn Error>> {
    let method = Vern9::new().rtol(1e-12).atol(1e-12);
    let solution = method.solve(system, 0.0, END, [theta1, theta2, 0.0, 0.0])?;
    let energy = |x: &SVector<f64, 4>| free.energy(0.0, x);
    let first = energy(&solution.x()[0]);
    let mut points = Vec::new();
    for n in 0..=POINTS {
        let t = END * f64::from(n) / f64::from(POINTS);
        points.push((t, energy(&solution.at(t)?) - first));
    }
    let gains = solution.x().iter().map(|x| energy(x) - first);
    let (low, high) = gains.fold((0.0_f64, 0.0_f64), |(low, high), gain| (low.min(gain), high.max(gain)));
    let rest = first - energy(&SVector::zeros());
    println!("  from ({theta1}, {theta2}), {rest:.2} J, {name:<18} {low:>9.2e} to {high:>9.2e}");
    Ok(Curve::new(line, points))
}
