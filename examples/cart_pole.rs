//! A pole on a cart, held upright by a linear-quadratic regulator.
//!
//! `cargo run --release --example cart_pole` linearises the model, computes the gain, compares small motions with the
//! full model, and draws the motion from 30 degrees into `out/cart_pole/`.

use std::error::Error;
use std::path::Path;

use charts::chart::{Axis, Column, Curve, Figure, Line, Row};
use charts::page::{BLUE, GREEN, Picture, VERMILION};
use pendulum_core::control::linearize;
use pendulum_core::prelude::*;
use pendulum_core::stability::equilibrium;

mechanism! {
    /// A pole hinged to a cart; the angle is 0 upright.
    CartPole {
        params { cart: kg = 1, pole: kg = 0.2, l: m = 0.6, g: m/s^2 = 9.81 }
        input push: N,
        gravity: [0, -g, 0],
        body slider on ground { mass: cart, joint: prismatic(x), coordinate: s, torque: push }
        body rod on slider {
            solids: [rod(pole, [0, 0, 0], [0, l, 0])],
            joint: revolute(z),
            coordinate: theta,
        }
    }
}

/// End time, in seconds.
const T_END: f64 = 6.0;

fn main() -> Result<(), Box<dyn Error>> {
    let model = CartPole::new(CartPoleParams::default())?;
    let weights = SMatrix::from_diagonal(&[1.0, 10.0, 1.0, 1.0].into());
    let upright = linearize(&model, 0.0, [0.0; 4], [0.0])?;
    let law = upright.lqr(&weights, &SMatrix::from([[0.1]]))?.law;
    let k = law.gain;
    println!("push = -K x with K = {k:.3}");

    let closed = model.with_law(law);
    let balance = equilibrium(&closed, upright.x0)?;
    println!("upright is {:?} with modes of", balance.stability());
    for mode in balance.spectrum.modes() {
        println!(
            "  {:8.3} 1/s, {:6.3} rad/s",
            mode.growth_rate(),
            mode.angular_frequency()
        );
    }

    let mut start = SVector::zeros();
    start[CartPole::THETA] = 30.0_f64.to_radians();
    let solution = Vern7::new().rtol(1e-9).atol(1e-9).solve(&closed, 0.0, T_END, start)?;
    println!("after {T_END} s, no component is above {:.1e}\n", solution.end().amax());

    let times: Vec<f64> = (0..=600).map(|i| T_END * f64::from(i) / 600.0).collect();
    let states = solution.sample(times.iter().copied())?;
    let curve = |line, value: &dyn Fn(&SVector<f64, 4>) -> f64| {
        Curve::new(line, times.iter().copied().zip(states.iter().map(value)).collect())
    };
    let time = || Axis::linear("time t (s)", 0.0..T_END);
    let figure = Figure {
        title: "A pole on a cart, released at 30° and balanced by LQR".to_owned(),
        subtitle: "Cart 1 kg, pole 0.2 kg and 0.6 m long".to_owned(),
        size: (1800, 620),
        legend: Vec::new(),
        columns: vec![
            Column::new("Pole", time(), Axis::linear("angle (°)", -15.0..35.0)),
            Column::new("Cart", time(), Axis::linear("position (m)", -1.4..0.2)),
            Column::new("Control", time(), Axis::linear("push (N)", -40.0..10.0)),
        ],
        rows: vec![Row::new(vec![
            vec![curve(Line::solid(BLUE), &|x| x[CartPole::THETA].to_degrees())],
            vec![curve(Line::solid(GREEN), &|x| x[CartPole::S])],
            vec![curve(Line::solid(VERMILION), &|x| -(k * x)[0])],
        ])],
    };
    for path in figure.save(Path::new("out/cart_pole/balance"))? {
        println!("{}", path.display());
    }
    Ok(())
}
