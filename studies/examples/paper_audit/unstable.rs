//! Section 5: number and growth rate of unstable small motions about hanging, under the printed and the correct
//! equations.

use std::error::Error;

use pendulum_core::prelude::*;
use pendulum_core::stability::{Spectrum, StabilityError};

use crate::model;
use charts::chart::{Axis, Column, Curve, Figure, Line, Row};
use charts::page::{BLUE, GREY, ORANGE, VERMILION};
use testbed::printed::Pendulum;

const RIGHT: Line = Line::solid(BLUE);
const EQ_24A: Line = Line::solid(VERMILION);
const EQ_25: Line = Line::dashed(ORANGE);
const THRESHOLD: Line = Line::dashed(GREY);

/// Friction of the lower joint in each column, in N m s.
const GAMMA2: [f64; 3] = [0.01, 1.0, 100.0];
/// Range of the friction of the upper joint, as powers of ten in N m s.
const POWERS: (f64, f64) = (-2.0, 2.0);
const POINTS: u32 = 800;

pub(crate) fn figure() -> Result<Figure, Box<dyn Error>> {
    println!("Section 5: small motions about hanging, the largest growth rate (1/s) and how many eigenvalues grow");
    println!("  gamma1  gamma2  generated     Eq. 24a       Eq. 25");
    for (gamma1, gamma2) in [
        (0.1, 0.1),
        (1.0, 0.1),
        (2.4, 0.1),
        (2.6, 0.1),
        (10.0, 0.1),
        (100.0, 0.1),
        (0.1, 1.0),
        (10.0, 1.0),
    ] {
        print!("  {gamma1:<6}  {gamma2:<6}");
        for matrix in matrices(gamma1, gamma2)? {
            let (growth, count) = growth(&matrix)?;
            print!("  {growth:>9.5} {count}");
        }
        println!();
    }
    let panels = GAMMA2.map(panel).into_iter().collect::<Result<_, _>>()?;
    let columns = GAMMA2.map(|gamma2| {
        let x = Axis::decades("friction γ₁ of the upper axle (N m s)", POWERS.0..POWERS.1);
        let y = Axis::linear("unstable eigenvalues", -0.2..4.2);
        Column::new(&format!("γ₂ = {gamma2} N m s"), x, y)
    });
    Ok(Figure {
        title: "Hanging at rest loses its stability in the printed equations alone".to_owned(),
        subtitle: "Eigenvalues with a positive real part, of four; m = 1 kg, I = 1 kg m², c = d = 1 m, g = 9.8 m/s²"
            .to_owned(),
        size: (1600, 640),
        legend: vec![
            (RIGHT, "generated Jacobian".to_owned()),
            (EQ_24A, "Eq. 24a as printed".to_owned()),
            (EQ_25, "Eq. 25 as printed".to_owned()),
            (THRESHOLD, "a = 2.5, Section 5".to_owned()),
        ],
        columns: columns.into(),
        rows: vec![Row::new(panels)],
    })
}

fn panel(gamma2: f64) -> Result<Vec<Curve>, Box<dyn Error>> {
    let mut counts = [Vec::new(), Vec::new(), Vec::new()];
    for n in 0..=POINTS {
        let power = POWERS.0 + (POWERS.1 - POWERS.0) * f64::from(n) / f64::from(POINTS);
        for (counts, matrix) in counts.iter_mut().zip(matrices(10.0_f64.powf(power), gamma2)?) {
            counts.push((power, growth(&matrix)?.1 as f64));
        }
    }
    let [right, eq_24a, eq_25] = counts;
    let threshold = vec![(2.5_f64.log10(), -0.2), (2.5_f64.log10(), 4.2)];
    Ok(vec![
        Curve::new(THRESHOLD, threshold),
        Curve::new(EQ_24A, eq_24a),
        Curve::new(RIGHT, right),
        Curve::new(EQ_25, eq_25),
    ])
}

/// Generated Jacobian, and the matrices of Eq. 24a and 25 as printed.
fn matrices(gamma1: f64, gamma2: f64) -> Result<[SMatrix<f64, 4, 4>; 3], Box<dyn Error>> {
    let paper = Pendulum::paper(gamma1, gamma2);
    Ok([
        model(gamma1, gamma2)?.jacobian(0.0, &SVector::zeros()),
        paper.linear_with_sign_of_24a(),
        paper.eq25_printed(),
    ])
}

/// Largest real part of the eigenvalues, and the number of positive ones.
fn growth(matrix: &SMatrix<f64, 4, 4>) -> Result<(f64, usize), StabilityError> {
    let spectrum = Spectrum::of(matrix)?;
    let count = spectrum.eigenvalues().filter(|eigenvalue| eigenvalue.re > 0.0).count();
    Ok((spectrum.modes()[0].growth_rate(), count))
}
