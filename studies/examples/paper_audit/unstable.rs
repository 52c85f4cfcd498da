//! Section 5: the fastest growth, or the slowest decay, of small motions about hanging, over both frictions.

use std::error::Error;

use pendulum_core::prelude::*;
use pendulum_core::stability::{Spectrum, StabilityError};

use crate::model;
use charts::chart::{Axis, Column, Curve, Figure, Line, Row};
use charts::page::{BLUE, ORANGE, VERMILION};
use testbed::printed::Pendulum;

type Form = fn(&Pendulum) -> SMatrix<f64, 4, 4>;

const RIGHT: Line = Line::solid(BLUE);
const PRINTED: [(Line, &str, Form); 2] = [
    (
        Line::solid(VERMILION),
        "with the sign of Eq. 24a",
        Pendulum::linear_with_sign_of_24a,
    ),
    (
        Line::dashed(ORANGE),
        "with friction in the denominator, Eq. 25 and 26",
        Pendulum::linear_with_friction_in_denominator,
    ),
];

/// The friction of the other axle, in N m s.
const OTHER: f64 = 0.1;
/// Powers of ten of the friction.
const POWERS: (f64, f64) = (-3.0, 4.0);
const POINTS: u32 = 700;

pub(crate) fn figure() -> Result<Figure, Box<dyn Error>> {
    println!("Section 5: growth rates (1/s) of small motions about hanging; frictions in N m s");
    println!("  gamma1  gamma2  generated  sign of 24a  denominator");
    for (gamma1, gamma2) in [
        (0.01, 0.1),
        (0.1, 0.1),
        (1.0, 0.1),
        (10.0, 0.1),
        (0.1, 0.01),
        (0.1, 1.0),
        (0.1, 10.0),
    ] {
        let paper = Pendulum::paper(gamma1, gamma2);
        let [first, second] = PRINTED.map(|(_, _, form)| fastest(&form(&paper)));
        let right = fastest(&generated(gamma1, gamma2)?)?;
        println!(
            "  {gamma1:<6}  {gamma2:<6}  {right:>9.5}  {:>11.5}  {:>11.5}",
            first?, second?
        );
    }
    let mut columns = Vec::new();
    for at in [|gamma| (gamma, OTHER), |gamma| (OTHER, gamma)] {
        let [decay, growth] = &mut [Vec::new(), Vec::new()];
        let mut add = |line, rates: Vec<(f64, f64)>| {
            decay.extend(runs(line, &rates, -1.0));
            growth.extend(runs(line, &rates, 1.0));
        };
        let mut right = Vec::new();
        for (power, gamma) in frictions() {
            let (gamma1, gamma2) = at(gamma);
            right.push((power, fastest(&generated(gamma1, gamma2)?)?));
        }
        for (line, _, form) in PRINTED {
            let rate = |(power, gamma)| {
                let (gamma1, gamma2) = at(gamma);
                Ok((power, fastest(&form(&Pendulum::paper(gamma1, gamma2)))?))
            };
            add(line, frictions().map(rate).collect::<Result<_, StabilityError>>()?);
        }
        add(RIGHT, right);
        columns.push([std::mem::take(decay), std::mem::take(growth)]);
    }
    Ok(chart(columns))
}

fn chart(columns: Vec<[Vec<Curve>; 2]>) -> Figure {
    let axis = |label: &str, range| Axis {
        ticks: 8,
        ..Axis::decades(label, range)
    };
    let printed = PRINTED.map(|(line, name, _)| (line, name.to_owned()));
    let legend = std::iter::once((RIGHT, "generated Jacobian".to_owned())).chain(printed);
    let row = |caption: &str, n: usize| Row {
        caption: caption.to_owned(),
        legend: Vec::new(),
        panels: columns.iter().map(|column| column[n].clone()).collect(),
    };
    Figure {
        title: "Hanging at rest: the correct linearization decays at every friction".to_owned(),
        subtitle: format!(
            "Williams (2023), Section 5: m = 1 kg, I = 1 kg m², c = d = 1 m, g = 9.8 m/s²; the other axle has {OTHER} \
            N m s"
        ),
        size: (1600, 1200),
        legend: legend.collect(),
        columns: [
            ("upper axle", "friction γ₁ (N m s)"),
            ("lower axle", "friction γ₂ (N m s)"),
        ]
        .map(|(title, label)| Column::new(title, axis(label, POWERS.0..POWERS.1), axis("rate (1/s)", -5.0..3.0)))
        .into(),
        rows: vec![
            row("Slowest decay, where stable", 0),
            row("Fastest growth, where unstable", 1),
        ],
    }
}

/// Powers of ten with the frictions they are of.
fn frictions() -> impl Iterator<Item = (f64, f64)> {
    let power = |n| POWERS.0 + (POWERS.1 - POWERS.0) * f64::from(n) / f64::from(POINTS);
    (0..=POINTS).map(power).map(|power| (power, 10.0_f64.powf(power)))
}

fn generated(gamma1: f64, gamma2: f64) -> Result<SMatrix<f64, 4, 4>, Box<dyn Error>> {
    Ok(model(gamma1, gamma2)?.jacobian(0.0, &SVector::zeros()))
}

fn fastest(matrix: &SMatrix<f64, 4, 4>) -> Result<f64, StabilityError> {
    Ok(Spectrum::of(matrix)?.modes()[0].growth_rate())
}

/// The stretches where the rate has this sign, in powers of ten.
fn runs(line: Line, rates: &[(f64, f64)], sign: f64) -> Vec<Curve> {
    let stretches = rates.split(|&(_, rate)| sign * rate <= 0.0);
    let curve = |stretch: &[(f64, f64)]| {
        Curve::new(
            line,
            stretch.iter().map(|&(x, rate)| (x, (sign * rate).log10())).collect(),
        )
    };
    stretches.filter(|stretch| stretch.len() > 1).map(curve).collect()
}
