//! Section 4: largest Lyapunov exponent, with friction at 4 degrees, and without friction over the amplitude.

use std::error::Error;
use std::thread;

use pendulum_core::prelude::*;
use pendulum_core::stability::{Lyapunov, StabilityError, equilibrium};

use crate::model;
use charts::chart::{Axis, Column, Curve, Figure, Line, Row};
use charts::page::{BLUE, GREY};
use testbed::scenes::DoublePendulum;

/// Time over which growth is measured, in s.
const DURATION: f64 = 1e4;

/// Exponent of the motion from rest at `theta1 = 0` and the given `theta2`.
#[derive(Clone, Copy)]
struct Measured {
    degrees: f64,
    value: f64,
    uncertainty: f64,
}

pub(crate) fn figure() -> Result<Figure, Box<dyn Error>> {
    println!(
        "Section 4: largest Lyapunov exponent (1/s), from rest at theta1 = 0, theta2 = 4 degrees, over {DURATION} s"
    );
    for gamma in [0.1, 0.4, 1.0] {
        let model = model(gamma, gamma)?;
        let Measured { value, .. } = measure(&model, 4.0)?;
        let rest = equilibrium(&model, SVector::zeros())?;
        let slowest = rest.spectrum.modes()[0].growth_rate();
        println!("  gamma {gamma:<4} {value:>9.5}, the slowest mode {slowest:>9.5}");
    }
    let scan = scan(&model(0.0, 0.0)?)?;
    let regular = DURATION.ln() / DURATION;
    println!("  without friction over theta2; regular motion is at ln(t)/t = {regular:.5} at most, or about that");
    let is_chaotic = |m: &&Measured| m.value > 2.0 * regular && m.value > 3.0 * m.uncertainty;
    for measured in &scan {
        let told = measured.degrees <= 4.0 || measured.degrees % 20.0 == 0.0 || is_chaotic(&measured);
        if told {
            println!(
                "  {:>5} degrees {:>9.5} +- {:.5}",
                measured.degrees, measured.value, measured.uncertainty
            );
        }
    }
    let first = scan.iter().position(|m| is_chaotic(&m)).ok_or("no motion is chaotic")?;
    let last = scan
        .iter()
        .rposition(|m| !is_chaotic(&m))
        .ok_or("every motion is chaotic")?;
    let before = first.checked_sub(1).ok_or("the smallest motion is chaotic")?;
    println!(
        "  the first positive one is at {} degrees, after {} degrees",
        scan[first].degrees, scan[before].degrees
    );
    println!("  the last that is not is at {} degrees", scan[last].degrees);
    Ok(chart(&scan, regular))
}

/// Scans amplitudes in steps of 2 degrees, and of half a degree near the onset of chaos.
fn scan(model: &DoublePendulum) -> Result<Vec<Measured>, Box<dyn Error>> {
    let coarse = (1..=75).map(|n| 2.0 * f64::from(n));
    let degrees: Vec<f64> = coarse.chain((1..=58).map(|n| 150.0 + 0.5 * f64::from(n))).collect();
    let cores = thread::available_parallelism()?.get();
    // Interleaved, since chaotic motions take longer than regular ones.
    let share = |first: usize| {
        degrees
            .iter()
            .skip(first)
            .step_by(cores)
            .map(|&degrees| measure(model, degrees))
    };
    let mut all: Vec<Measured> = thread::scope(|scope| {
        let threads: Vec<_> = (0..cores)
            .map(|first| scope.spawn(move || share(first).collect()))
            .collect();
        let joined = threads
            .into_iter()
            .map(|thread| thread.join().expect("no measurement panics"));
        joined.collect::<Result<Vec<Vec<_>>, StabilityError>>()
    })?
    .concat();
    all.sort_by(|a, b| a.degrees.total_cmp(&b.degrees));
    Ok(all)
}

fn measure(model: &DoublePendulum, degrees: f64) -> Result<Measured, StabilityError> {
    let start = [0.0, degrees.to_radians(), 0.0, 0.0];
    let exponent = Lyapunov::new()
        .tolerance(1e-9)
        .duration(DURATION)
        .largest(model, start)?;
    Ok(Measured {
        degrees,
        value: exponent.values[0],
        uncertainty: exponent.uncertainty[0],
    })
}

fn chart(scan: &[Measured], regular: f64) -> Figure {
    const EXPONENT: Line = Line::solid(BLUE);
    const REGULAR: Line = Line::dashed(GREY);
    let exponents = scan.iter().map(|m| (m.degrees, m.value.log10())).collect();
    Figure {
        title: "Without friction, only the largest swings have a positive Lyapunov exponent".to_owned(),
        subtitle: format!(
            "Released from rest at θ₁ = 0, measured over {DURATION} s; m = 1 kg, I = 1 kg m², c = d = 1 m, g = 9.8 m/s²"
        ),
        size: (1600, 800),
        legend: vec![
            (EXPONENT, "measured".to_owned()),
            (REGULAR, "ln(t)/t: about the largest value of regular motion".to_owned()),
        ],
        columns: vec![Column::new(
            "",
            Axis {
                ticks: 10,
                ..Axis::linear("θ₂ at the start (°)", 0.0..180.0)
            },
            Axis::decades("largest exponent (1/s)", -4.0..0.0),
        )],
        rows: vec![Row::new(vec![vec![
            Curve::new(REGULAR, vec![(0.0, regular.log10()), (180.0, regular.log10())]),
            Curve::new(EXPONENT, exponents),
        ]])],
    }
}
