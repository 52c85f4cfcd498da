//! A UR5 from a URDF file, whose tool draws a figure of eight under model-predictive control.
//!
//! `cargo run --release --example arm_path` follows the path with and without noise and an unknown load, measures the
//! time that a sample takes, and draws arm and errors into `out/arm_path/`.

use std::error::Error;
use std::f64::consts::{PI, TAU};
use std::time::Instant;

use pendulum_core::control::{Controller, CostDerivatives, Ilqr, Objective, Predictive, Sampled, SampledSolution};
use pendulum_core::prelude::*;

mod figures;

mechanism! {
    /// The arm with a tool.
    Arm {
        robot: urdf("testbed/data/urdf/ur5.urdf"),
        gravity: [0, 0, -9.81],
        params { pen_mass: kg = 0.5 }
        input pan: N m, input lift: N m, input elbow: N m, input wrist1: N m, input wrist2: N m, input wrist3: N m,
        body shoulder_link on base_link { torque: pan }
        body upper_arm_link on shoulder_link { torque: lift }
        body forearm_link on upper_arm_link { torque: elbow }
        body wrist_1_link on forearm_link { torque: wrist1 }
        body wrist_2_link on wrist_1_link { torque: wrist2 }
        body wrist_3_link on wrist_2_link { torque: wrist3 }
        body pen on tool0 { solids: [rod(pen_mass, [0, 0, -0.08], [0, 0, 0.1])], joint: fixed }
        point tip on pen at [0, 0, 0.1],
        point flange on pen,
        /// Points to be on the path, and above it.
        output tool: [tip.x, tip.y, tip.z, flange.x, flange.y, flange.z],
        generate: [rhs, jacobian, inverse_dynamics, shapes],
    }
}

type Pose = SVector<f64, 6>;

/// Duration of one turn around the figure, in s.
const TURN: f64 = 4.0;
const T_END: f64 = 8.0;
/// Sampling period, and length of a step of the plan, in s.
const PERIOD: f64 = 0.02;
/// Number of times that each sample is computed again for its time.
const REPEATS: usize = 5;
const START: [f64; 12] = [0.0, -1.2, 1.6, -1.97, -PI / 2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];

/// Place of the tip at a time, and of the flange, 0.1 m above: a figure of eight in a horizontal plane.
fn path(t: f64) -> Pose {
    let phase = TAU * t / TURN;
    let (x, y, z) = (0.6 + 0.1 * (2.0 * phase).sin(), 0.1 + 0.25 * phase.sin(), 0.15);
    [x, y, z, x, y, z + 0.1].into()
}

/// Squared distance from the path, with small weights of the rates and the torques.
#[derive(Clone, Copy)]
struct Follow<'a> {
    arm: &'a Arm,
}

const DISTANCE: f64 = 1e5;
const RATE: f64 = 0.1;
const TORQUE: f64 = 1e-4;

impl Follow<'_> {
    /// Cost of the state.
    fn cost(&self, t: f64, x: &SVector<f64, 12>) -> f64 {
        let rates = x.fixed_rows::<6>(6);
        DISTANCE * (self.arm.tool(t, x) - path(t)).norm_squared() + RATE * rates.norm_squared()
    }

    /// Its gradient, and its second derivatives without those of the positions (Gauss-Newton).
    fn derivatives(&self, t: f64, x: &SVector<f64, 12>) -> (SVector<f64, 12>, SMatrix<f64, 12, 12>) {
        let (tool, jacobian) = self.arm.tool_and_jacobian(t, x);
        let weighted = 2.0 * DISTANCE * jacobian.transpose();
        let (mut gradient, mut second) = (weighted * (tool - path(t)), weighted * jacobian);
        for n in 6..12 {
            gradient[n] += 2.0 * RATE * x[n];
            second[(n, n)] += 2.0 * RATE;
        }
        (gradient, second)
    }
}

impl Objective<f64, 12, 6> for Follow<'_> {
    fn running(&self, t: f64, x: &SVector<f64, 12>, u: &[f64; 6]) -> f64 {
        self.cost(t, x) + TORQUE * u.iter().map(|u| u * u).sum::<f64>()
    }

    fn running_derivatives(&self, t: f64, x: &SVector<f64, 12>, u: &[f64; 6]) -> CostDerivatives<f64, 12, 6> {
        let (gradient, second) = self.derivatives(t, x);
        CostDerivatives {
            x: gradient,
            u: 2.0 * TORQUE * SVector::from(*u),
            xx: second,
            xu: SMatrix::zeros(),
            uu: SMatrix::from_diagonal_element(2.0 * TORQUE),
        }
    }

    fn end(&self, t: f64, x: &SVector<f64, 12>) -> f64 {
        PERIOD * self.cost(t, x)
    }

    fn end_derivatives(&self, t: f64, x: &SVector<f64, 12>) -> (SVector<f64, 12>, SMatrix<f64, 12, 12>) {
        let (gradient, second) = self.derivatives(t, x);
        (PERIOD * gradient, PERIOD * second)
    }
}

type Planner<'a> = Predictive<Arm, Ilqr<Follow<'a>, f64, 12, 6, 30>>;
type Motion = SampledSolution<f64, 12, 12, 6>;

/// Plans the first 0.6 s, from where the arm is held.
fn planner(arm: &Arm) -> Result<Planner<'_>, Box<dyn Error>> {
    let hold = arm.inverse_dynamics(0.0, &SVector::from(START), &SVector::zeros());
    let mut ilqr = Ilqr::new(PERIOD, Follow { arm })
        .limits(Arm::EFFORT_LIMITS.map(|most| -most), Arm::EFFORT_LIMITS)
        .start(hold);
    ilqr.solve(arm, 0.0, START)?;
    Ok(ilqr.controller(*arm)?)
}

/// The motion of an arm with a mass of its pen, with noise of encoders (1e-4 rad) and rates (1e-2 rad/s) or none.
fn follow(planner: &Planner<'_>, [mass, noise]: [f64; 2], t_end: f64) -> Result<Motion, Box<dyn Error>> {
    let arm = Arm::new(ArmParams { pen_mass: mass })?;
    let noise = std::array::from_fn(|n| noise * if n < 6 { 1e-4 } else { 1e-2 });
    let sampled = Sampled::new(*planner, PERIOD).noise(noise);
    Ok(sampled.solve(&Tsit5::new(), &arm, 0.0, t_end, START)?)
}

/// Distance of the tip from the path in mm, each 10 ms.
fn distances(arm: &Arm, motion: &Motion) -> Result<Vec<(f64, f64)>, Box<dyn Error>> {
    let times = (0..)
        .map(|i| 0.01 * f64::from(i))
        .take_while(|&t| t <= motion.trajectory.last().0);
    let distance = |t| {
        let off = arm.tool(t, &motion.trajectory.at(t)?) - path(t);
        Ok((t, 1e3 * off.fixed_rows::<3>(0).norm()))
    };
    times.map(distance).collect()
}

/// Times that the controller takes for the samples, in ms. It computes them again `REPEATS` times, and the fastest
/// counts, since other programs interrupt this one.
fn times(planner: &Planner<'_>, motion: &Motion) -> Vec<(f64, f64)> {
    let mut times: Vec<_> = motion.samples.iter().map(|sample| (sample.t, f64::INFINITY)).collect();
    for _ in 0..REPEATS {
        let mut state = planner.start(PERIOD);
        for (sample, (_, time)) in motion.samples.iter().zip(&mut times) {
            let start = Instant::now();
            let command = planner.sample(sample.t, &sample.measured, &mut state);
            *time = time.min(1e3 * start.elapsed().as_secs_f64());
            assert_eq!(command, sample.command);
        }
    }
    times
}

/// Largest torque of each sample over its limit, in percent.
fn torques(motion: &Motion) -> Vec<(f64, f64)> {
    let share = |sent: [f64; 6]| {
        (0..6)
            .map(|m| 100.0 * sent[m].abs() / Arm::EFFORT_LIMITS[m])
            .fold(0.0, f64::max)
    };
    motion
        .samples
        .iter()
        .map(|sample| (sample.t, share(sample.sent)))
        .collect()
}

/// Curves over the time of one run.
struct Run {
    name: &'static str,
    /// Distance from the path in mm.
    off: Vec<(f64, f64)>,
    /// Largest torque in percent of its limit.
    torque: Vec<(f64, f64)>,
    /// Time of a sample in ms.
    time: Vec<(f64, f64)>,
}

fn main() -> Result<(), Box<dyn Error>> {
    let arm = Arm::new(ArmParams::default())?;
    let planner = planner(&arm)?;
    let period = 1e3 * PERIOD;
    println!("                              off by (mm)   torque (%)   time (ms) of {period} ms");
    println!("                             rms  largest      largest       median   slowest");
    let mut runs = Vec::new();
    for (name, case) in [
        ("as planned", [0.5, 0.0]),
        ("with noise", [0.5, 1.0]),
        ("noise, and a pen of 1 kg", [1.0, 1.0]),
    ] {
        let motion = follow(&planner, case, T_END)?;
        let (off, torque, time) = (distances(&arm, &motion)?, torques(&motion), times(&planner, &motion));
        // after the first second, in which the arm comes onto the path
        let [offs, torques, mut sorted] = [&off, &torque, &time].map(|curve| {
            let late = curve.iter().filter(|(t, _)| *t >= 1.0);
            late.map(|(_, value)| *value).collect::<Vec<f64>>()
        });
        sorted.sort_by(f64::total_cmp);
        let rms = (offs.iter().map(|off| off * off).sum::<f64>() / offs.len() as f64).sqrt();
        let [far, strong] = [offs, torques].map(|values| values.into_iter().fold(0.0, f64::max));
        let (median, slowest) = (sorted[sorted.len() / 2], sorted[sorted.len() - 1]);
        println!("{name:24} {rms:7.3} {far:8.3} {strong:12.0} {median:12.2} {slowest:9.2}");
        runs.push(Run {
            name,
            off,
            torque,
            time,
        });
    }
    println!();
    let turn = follow(&planner, [0.5, 0.0], TURN)?.trajectory;
    let files = [figures::arm(&arm, &turn)?, figures::errors(&runs)?];
    files.iter().flatten().for_each(|path| println!("{}", path.display()));
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pen_stays_on_the_path_under_noise_and_an_unknown_load() {
        let arm = Arm::new(ArmParams::default()).expect("physical");
        let planner = planner(&arm).expect("a motion");
        for (case, most) in [([0.5, 0.0], 0.2), ([1.0, 1.0], 1.5)] {
            let motion = follow(&planner, case, 1.5).expect("regular");
            let off = distances(&arm, &motion).expect("regular");
            assert!(off[0].1 > 10.0, "the start is beside the path");
            let late = off.iter().filter(|(t, _)| *t >= 0.5);
            assert!(late.clone().all(|(_, off)| *off < most), "{late:?}");
        }
    }
}
