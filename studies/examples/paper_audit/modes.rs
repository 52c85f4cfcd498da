//! Fig. 2 as the sum of two damped modes.

use std::error::Error;

use pendulum_core::prelude::*;
use pendulum_core::stability::equilibrium;

use crate::model;
use charts::chart::{Axis, Column, Curve, Figure, Line, Row};
use charts::page::{BLUE, INK, ORANGE, VERMILION};
use testbed::fit::{eigenvalues_of, fit};
use testbed::printed::Pendulum;

const MOTION: Line = Line::solid(INK);
const SLOW: Line = Line::solid(BLUE);
const FAST: Line = Line::solid(ORANGE);
const LEFT_OF_UPPER: Line = Line::solid(VERMILION);
const LEFT_OF_LOWER: Line = Line::dashed(INK);

/// Friction of both joints, in N m s.
const FRICTIONS: [f64; 3] = [0.1, 0.4, 1.0];
const END: f64 = 20.0;
const AMPLITUDE: f64 = 4.0;
const POINTS: u32 = 400;

/// Time with the state.
type Sample = (f64, SVector<f64, 4>);

pub(crate) fn figure() -> Result<Figure, Box<dyn Error>> {
    println!(
        "Fig. 2 as two modes: from rest at theta1 = 0, theta2 = {AMPLITUDE} degrees, {END} s; rates in 1/s and rad/s"
    );
    let rows = FRICTIONS.map(row).into_iter().collect::<Result<_, _>>()?;
    let column = |title: &str, label: &str, range| {
        Column::new(title, Axis::linear("time t (s)", 0.0..END), Axis::linear(label, range))
    };
    Ok(Figure {
        title: "Fig. 2 of the paper is the sum of two damped modes".to_owned(),
        subtitle: "Released from rest at θ₁ = 0°, θ₂ = 4°; amplitudes by least squares, frequencies and decay from \
        the generated Jacobian"
            .to_owned(),
        size: (1600, 1150),
        legend: vec![
            (MOTION, "θ₂".to_owned()),
            (SLOW, "slow mode of θ₂".to_owned()),
            (FAST, "fast mode of θ₂".to_owned()),
            (LEFT_OF_UPPER, "remainder of θ₁".to_owned()),
            (LEFT_OF_LOWER, "remainder of θ₂".to_owned()),
        ],
        columns: vec![
            column("motion and modes", "angle (°)", -4.6..4.6),
            column("what the modes leave", "remainder (0.001°)", -5.5..5.5),
        ],
        rows,
    })
}

fn row(gamma: f64) -> Result<Row, Box<dyn Error>> {
    let model = model(gamma, gamma)?;
    let samples = sample(&model, AMPLITUDE)?;
    let rest = equilibrium(&model, SVector::zeros())?;
    let fitted = fit(&rest.spectrum, &samples);
    let seen = eigenvalues_of(&samples)?;
    println!("  gamma {gamma}");
    for ((mode, amplitude), seen) in fitted.modes.iter().zip(&fitted.amplitudes).zip(seen) {
        let part = |angle: usize| (amplitude * mode.shape[angle]).norm().to_degrees();
        println!(
            "    frequency {:.5}, decay {:.5}, damping ratio {:.5}; amplitudes {:.4} and {:.4} degrees; the motion \
            itself has {:.5}, {:.5}",
            mode.angular_frequency(),
            -mode.growth_rate(),
            mode.damping_ratio(),
            part(0),
            part(1),
            seen.im,
            -seen.re
        );
    }
    let quarter = sample(&model, 0.25 * AMPLITUDE)?;
    let [four, one] = [&samples, &quarter].map(|samples| fit(&rest.spectrum, samples).residual(samples).to_degrees());
    println!(
        "    two modes leave {four:.5} degrees, {:.3} % of {AMPLITUDE}; at {} degree {one:.2e}: power {:.3} of the \
        amplitude",
        100.0 * four / AMPLITUDE,
        0.25 * AMPLITUDE,
        (four / one).log(4.0)
    );
    let paper = Pendulum::paper(gamma, gamma);
    let printed = sample(&FnSystem(|_t, x: &SVector<f64, 4>| paper.eq22b_printed(x)), AMPLITUDE)?;
    let apart = samples
        .iter()
        .zip(&printed)
        .map(|((_, a), (_, b))| (a - b).fixed_rows::<2>(0).amax());
    let apart = apart.fold(0.0, f64::max).to_degrees();
    println!("    Eq. 22b as printed moves the angles by {apart:.5} degrees at most");

    let curve = |line, value: &dyn Fn(&Sample) -> f64| {
        Curve::new(line, samples.iter().map(|sample| (sample.0, value(sample))).collect())
    };
    Ok(Row {
        caption: format!("γ₁ = γ₂ = {gamma} N m s"),
        legend: Vec::new(),
        panels: vec![
            vec![
                curve(FAST, &|(t, _)| fitted.angles(1, *t)[1].to_degrees()),
                curve(SLOW, &|(t, _)| fitted.angles(0, *t)[1].to_degrees()),
                curve(MOTION, &|(_, x)| x[1].to_degrees()),
            ],
            vec![
                curve(LEFT_OF_UPPER, &|sample| 1e3 * fitted.rest(sample)[0].to_degrees()),
                curve(LEFT_OF_LOWER, &|sample| 1e3 * fitted.rest(sample)[1].to_degrees()),
            ],
        ],
    })
}

fn sample(system: &impl System<f64, 4>, degrees: f64) -> Result<Vec<Sample>, Box<dyn Error>> {
    let method = Vern9::new().rtol(1e-12).atol(1e-14);
    let solution = method.solve(system, 0.0, END, [0.0, degrees.to_radians(), 0.0, 0.0])?;
    let times = (0..=POINTS).map(|n| END * f64::from(n) / f64::from(POINTS));
    times.map(|t| Ok((t, solution.at(t)?))).collect()
}
