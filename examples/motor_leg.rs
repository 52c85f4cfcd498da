//! A leg on a crank that a direct-current motor turns, under PID control of its speed.
//!
//! `cargo run --release --example motor_leg` brakes the crank, more at last than the voltage can carry, compares the
//! controller with one whose integral winds up, and draws both into `out/motor_leg/`.

use std::error::Error;
use std::path::Path;

use charts::chart::{Axis, Column, Curve, Figure, Line, Row};
use charts::page::{BLUE, GREY, Picture, VERMILION};
use pendulum_core::control::{Pid, Sampled, SampledSolution};
use pendulum_core::prelude::*;
use pendulum_draw::Drawing;

mechanism! {
    /// A crank, a shank and a rocker, whose foot goes back along a line for half a turn, on a motor with a gear.
    Leg {
        params {
            /// Resistance and inductance of the armature: a time constant of 1 ms.
            res: ohm = 1, ind: H = 0.001,
            /// Torque of the motor per ampere.
            k: N m/A = 0.03,
            /// Brake of the crank from 2 s on, and its increase from 4 to 5 s.
            load: N m = 3, overload: N m = 9,
        }
        input voltage: V,
        gravity: [0, -9.81, 0],
        let brake = load*(1 + tanh((t - 2 s)/(1 ms)))/2 + overload*(tanh((t - 4 s)/(1 ms)) - tanh((t - 5 s)/(1 ms)))/2,
        /// Current through the armature.
        state i { unit: A, rate: (voltage - res*i - k*20*dot(theta))/ind }
        body crank on ground {
            solids: [rod(0.1, [0, 0, 0], [0.1, 0, 0])],
            joint: revolute(z), coordinate: theta near 0, friction: 0.02, torque: -brake,
        }
        body rotor on ground {
            solids: [disk(0.2, 0.016, [0, 0, 0])],
            joint: revolute(z), motion: 20*theta, torque: k*i, // by a gear
        }
        body shank on crank {
            solids: [plate(0.2, [[0, 0], [0.167, 0], [0.195, 0.182]])],
            joint: revolute(z) at [0.1, 0, 0], coordinate: phi depends near 3.28,
        }
        body rocker on ground {
            solids: [rod(0.1, [0, 0, 0], [0.236, 0, 0])],
            joint: revolute(z) at [-0.164, 0.192, 0], coordinate: psi depends near -1.14,
        }
        close shank at [0.167, 0, 0] to rocker at [0.236, 0, 0]: revolute(z),
        point foot on shank at [0.195, 0.182, 0],
        generate: [rhs, jacobian, shapes],
    }
}

/// Speed of the crank that the controller holds, and the deviation at which it counts as settled, in rad/s. The linkage
/// alone makes the speed vary by 0.3 rad/s within a turn.
const SPEED: [f64; 2] = [10.0, 0.5];
/// Times in s at which the motor starts, the brake acts, the overload begins and ends.
const STEPS: [f64; 4] = [0.0, 2.0, 4.0, 5.0];
const T_END: f64 = 7.0;
/// Largest voltage, in V.
const LIMIT: f64 = 24.0;

type Motion = SampledSolution<f64, 3, 1, 1>;

/// Integrates both controllers: one whose integral follows the voltage at its limit, and one whose integral winds up.
fn motions(leg: &Leg, t_end: f64) -> Result<[Motion; 2], Box<dyn Error>> {
    let pid = Pid::new(2.0, 20.0, 0.0).set_point(SPEED[0]);
    let run = |pid| {
        Sampled::of_components(pid, 1e-3, [Leg::DOT_THETA])
            .resolution([0.08]) // of an encoder with 4096 counts a turn on the rotor, over a period
            .delay(1e-3)
            .limits([-LIMIT], [LIMIT])
            .solve(&Tsit5::new(), leg, 0.0, t_end, [0.0; 3])
    };
    Ok([run(pid)?, run(pid.tracking(f64::INFINITY))?])
}

/// Time from the step at `from` after which the speed stays near its goal until `until`, and the largest speed.
fn response(motion: &Motion, from: f64, until: f64) -> (f64, f64) {
    let points = motion.trajectory.points().filter(|(t, _)| (from..until).contains(t));
    points.fold((0.0, 0.0), |(settled, fastest), (t, x)| {
        let speed = x[Leg::DOT_THETA];
        let is_off = (speed - SPEED[0]).abs() > SPEED[1];
        (if is_off { t - from } else { settled }, f64::max(fastest, speed))
    })
}

fn main() -> Result<(), Box<dyn Error>> {
    let leg = Leg::new(LegParams::default())?;
    let both = motions(&leg, T_END)?;
    println!("                  settles after (s)    largest speed (rad/s)");
    println!("                follows   winds up     follows   winds up");
    for (step, from) in ["start", "load", "overload", "its end"].into_iter().zip(STEPS) {
        let until = STEPS.into_iter().find(|&next| next > from).unwrap_or(T_END);
        let [(settled, fastest), (wound_up, faster)] = both.each_ref().map(|motion| response(motion, from, until));
        let [settled, wound_up] = [settled, wound_up].map(|time| match time < 0.99 * (until - from) {
            true => format!("{time:.2}"),
            false => "never".to_owned(),
        });
        println!("{step:10} {settled:>12} {wound_up:>10} {fastest:11.1} {faster:10.1}");
    }

    let times: Vec<f64> = (0..=3500).map(|i| T_END * f64::from(i) / 3500.0).collect();
    let curves = |value: &dyn Fn(&Motion, f64) -> f64| {
        // the first one above the other
        let curve = |(motion, color)| {
            Curve::new(
                Line::dots(color),
                times.iter().map(|&t| (t, value(motion, t))).collect(),
            )
        };
        [(&both[1], VERMILION), (&both[0], BLUE)].map(curve).to_vec()
    };
    let state = |index: usize| move |motion: &Motion, t: f64| motion.trajectory.at(t).map_or(f64::NAN, |x| x[index]);
    let mut voltages = vec![Curve::new(Line::dashed(GREY), vec![(0.0, LIMIT), (T_END, LIMIT)])];
    voltages.extend(curves(&|motion, t| motion.inputs_at(t)[0]));
    let time = || Axis::linear("time t (s)", 0.0..T_END);
    let figure = Figure {
        title: "A motor turns the crank of a leg at 10 rad/s by a sampled PID controller".to_owned(),
        subtitle: "Brake of 3 N m from 2 s on, and of 12 N m from 4 to 5 s, which the voltage cannot carry".to_owned(),
        size: (1800, 680),
        legend: vec![
            (Line::solid(BLUE), "integral follows the limit".to_owned()),
            (Line::solid(VERMILION), "integral winds up".to_owned()),
            (Line::dashed(GREY), "limit of the voltage".to_owned()),
        ],
        columns: vec![
            Column::new("Crank", time(), Axis::linear("speed (rad/s)", 0.0..35.0)),
            Column::new("Input", time(), Axis::linear("voltage (V)", 0.0..30.0)),
            Column::new("Armature", time(), Axis::linear("current (A)", -5.0..25.0)),
        ],
        rows: vec![Row::new(vec![
            curves(&state(Leg::DOT_THETA)),
            voltages,
            curves(&state(Leg::I)),
        ])],
    };
    println!();
    let folder = Path::new("out/motor_leg");
    let turn = &motions(&leg, 0.66)?[0].trajectory;
    let mut files = Drawing::new(&leg, turn)
        .ghosts(6)
        .picture(&folder.join("leg"))?
        .to_vec();
    files.extend(figure.save(&folder.join("states"))?);
    files.iter().for_each(|path| println!("{}", path.display()));
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_speed_settles_after_a_step_of_the_load_and_the_integral_does_not_wind_up() {
        let leg = Leg::new(LegParams::default()).expect("physical");
        let [follows, winds_up] = motions(&leg, T_END).expect("regular");
        let [_, load, overload, end] = STEPS;
        let (settled, fastest) = response(&follows, load, overload);
        assert!(settled < 0.25 && fastest < 11.0, "{settled} {fastest}");
        let (settled, fastest) = response(&follows, end, T_END);
        let (wound_up, faster) = response(&winds_up, end, T_END);
        assert!(settled < 0.4 && fastest < 15.0, "{settled} {fastest}");
        assert!(
            wound_up > 1.5 * settled && faster > 2.0 * fastest,
            "{wound_up} {faster}"
        );
        // the current carries the brake of 3 N m and the friction of 0.02 N m s, over three turns
        let turns = 3.0 * std::f64::consts::TAU / SPEED[0];
        let mean = (0..4000).map(|i| follows.trajectory.at(overload - turns * f64::from(i) / 4000.0));
        let mean: f64 = mean.map(|x| x.expect("regular")[Leg::I] / 4000.0).sum();
        assert!(
            (mean / ((3.0 + 0.02 * SPEED[0]) / (0.03 * 20.0)) - 1.0).abs() < 0.01,
            "{mean}"
        );
    }
}
