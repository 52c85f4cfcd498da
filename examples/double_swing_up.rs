//! Two rods on a cart, swung up from rest and held upright by a force on the cart.
//!
//! `cargo run --release --example double_swing_up` plans the motion by iterative LQR, holds it by its gains and then by
//! LQR with a Kalman filter, with noise of sensors and motor, counts how often that succeeds, and draws it into
//! `out/double_swing_up/`.

use std::error::Error;
use std::f64::consts::PI;
use std::ops::Range;
use std::path::Path;

use charts::chart::{Axis, Column, Curve, Figure, Line, Row};
use charts::page::{BLUE, GREEN, GREY, INK, Picture, VERMILION};
use pendulum_core::control::{
    Ilqr, OutputFeedback, Quadratic, Sampled, SampledSolution, Tracker, WholeState, linearize,
};
use pendulum_core::prelude::*;
use pendulum_draw::Drawing;

mechanism! {
    /// The angles are 0 upright, and both from the vertical.
    TwoRods {
        input push: N,
        gravity: [0, -9.81, 0],
        body cart on ground {
            solids: [cuboid(1, [0.16, 0.06, 0.1], [0, 0, 0])], joint: prismatic(x), coordinate: s, torque: push,
        }
        body lower on cart { solids: [rod(0.3, [0, 0, 0], [0, 0.5, 0])], joint: revolute(z), coordinate: a }
        body upper on lower {
            solids: [rod(0.3, [0, 0, 0], [0, 0.5, 0])], joint: revolute(z) at [0, 0.5, 0], coordinate: b absolute,
        }
        point tip on upper at [0, 0.5, 0],
        generate: [rhs, jacobian, shapes],
    }
}

/// A motion of 200 steps, which take `STEP` s each.
type Motion = Ilqr<Quadratic<f64, 6, 1>, f64, 6, 1, 200>;
type Held = Sampled<Tracker<Motion, OutputFeedback<6, 1, 6>>, WholeState, 6, 1>;

const STEP: f64 = 0.02;
/// Sampling period in s.
const PERIOD: f64 = 0.005;
/// Largest force on the cart, in N.
const LIMIT: f64 = 12.0;
/// Standard deviations of the measurements, in m and rad, and of the rates, in m/s and rad/s.
const NOISE: [f64; 6] = [1e-3, 2e-3, 2e-3, 0.01, 0.02, 0.02];
/// Standard deviation of the force, in N.
const INPUT_NOISE: f64 = 0.5;
const HANGING: [f64; 6] = [0.0, PI, PI, 0.0, 0.0, 0.0];
/// End time in s.
const T_END: f64 = 8.0;
/// Largest angle of rods that count as upright, in rad: ten times what the noise leaves.
const UPRIGHT: f64 = 0.1;

/// Plans the motion, and makes the controller that holds it and then the rods.
fn controller(model: &TwoRods) -> Result<Held, Box<dyn Error>> {
    let upright = linearize(model, 0.0, [0.0; 6], [0.0])?
        .with_outputs(|_t, x, _u| (*x).into())
        .discretize(PERIOD)?;
    let weights = SMatrix::from_diagonal(&[1.0, 10.0, 10.0, 1.0, 1.0, 1.0].into());
    // sums over the samples, times their period: integrals
    let hold = upright.lqr(&(weights * PERIOD), &SMatrix::from([[0.1 * PERIOD]]))?;
    let process = upright.b * upright.b.transpose() * INPUT_NOISE.powi(2);
    let errors = SMatrix::from_diagonal(&SVector::from(NOISE.map(|noise| noise * noise)));
    let filtered = upright.output_feedback(&hold.law, &upright.kalman(&process, &errors)?)?;
    let cost = Quadratic::diagonal([0.1, 0.1, 0.1, 0.01, 0.01, 0.01], [0.01]).end(hold.cost);
    let mut motion = Motion::new(STEP, cost).limits([-LIMIT], [LIMIT]).start([1.0]);
    let solved = motion.solve(model, 0.0, HANGING)?;
    println!(
        "planned 4 s in {} iterations, at a cost of {:.2}",
        solved.iterations, solved.cost
    );
    Ok(Sampled::new(motion.tracker(filtered), PERIOD).limits([-LIMIT], [LIMIT]))
}

/// Angles after `T_END` of motions with `level` times the noise, each with a seed of its own: the larger of the two.
fn angles(model: &TwoRods, controller: Held, level: f64, count: usize) -> Result<Vec<f64>, Box<dyn Error>> {
    let noisy = controller
        .noise(NOISE.map(|noise| level * noise))
        .input_noise([level * INPUT_NOISE]);
    let starts = vec![HANGING.into(); count];
    let ends = noisy.ensemble(&Tsit5::new(), std::slice::from_ref(model), 0.0, T_END, &starts)?;
    Ok(ends
        .iter()
        .map(|x| x[TwoRods::A].abs().max(x[TwoRods::B].abs()))
        .collect())
}

/// Root mean square of the force over a span of time, in N.
fn force(motion: &SampledSolution<f64, 6, 6, 1>, span: Range<f64>) -> f64 {
    let sent = motion.samples.iter().filter(|sample| span.contains(&sample.t));
    let squares: Vec<f64> = sent.map(|sample| sample.sent[0].powi(2)).collect();
    (squares.iter().sum::<f64>() / squares.len() as f64).sqrt()
}

fn main() -> Result<(), Box<dyn Error>> {
    let model = TwoRods::new(TwoRodsParams {})?;
    let controller = controller(&model)?;
    println!("noise   upright   largest angle (rad)");
    for level in [0.0, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0] {
        let angles = angles(&model, controller, level, 200)?;
        let up = angles.iter().filter(|&&angle| angle < UPRIGHT).count();
        println!(
            "{level:4} x   {up:3}/200   {:.3}",
            angles.iter().copied().fold(0.0, f64::max)
        );
    }

    let noisy = controller.noise(NOISE).input_noise([INPUT_NOISE]);
    let motion = noisy.solve(&Tsit5::new(), &model, 0.0, T_END, HANGING)?;
    println!(
        "force upright, rms: {:.2} N by the gains of the plan, {:.2} N with the filter\n",
        force(&motion, 3.0..4.0),
        force(&motion, 7.0..8.0)
    );
    let times: Vec<f64> = (0..=1600).map(|i| T_END * f64::from(i) / 1600.0).collect();
    let states = motion.trajectory.sample(times.iter().copied())?;
    let curve = |line, value: &dyn Fn(&SVector<f64, 6>) -> f64| {
        Curve::new(line, times.iter().copied().zip(states.iter().map(value)).collect())
    };
    let level = |height| Curve::new(Line::dashed(GREY), vec![(0.0, height), (T_END, height)]);
    let time = || Axis::linear("time t (s)", 0.0..T_END);
    let figure = Figure {
        title: "A double pendulum on a cart, swung up and held at 200 Hz".to_owned(),
        subtitle: format!(
            "Planned for 4 s by iterative LQR, with at most {LIMIT} N; then held by LQR on the estimate of a Kalman \
             filter"
        ),
        size: (1800, 680),
        legend: vec![
            (Line::solid(BLUE), "lower rod".to_owned()),
            (Line::solid(VERMILION), "upper rod".to_owned()),
            (Line::solid(GREEN), "cart".to_owned()),
            (Line::dots(INK), "force, every 5 ms".to_owned()),
            (Line::dashed(GREY), "its limit".to_owned()),
        ],
        columns: vec![
            Column::new("Rods", time(), Axis::linear("angle from upright (°)", -60.0..300.0)),
            Column::new("Cart", time(), Axis::linear("position (m)", -0.8..0.4)),
            Column::new("Force on the cart", time(), Axis::linear("force (N)", -15.0..15.0)),
        ],
        rows: vec![Row::new(vec![
            vec![
                curve(Line::solid(BLUE), &|x| x[TwoRods::A].to_degrees()),
                curve(Line::solid(VERMILION), &|x| x[TwoRods::B].to_degrees()),
            ],
            vec![curve(Line::solid(GREEN), &|x| x[TwoRods::S])],
            vec![
                level(LIMIT),
                level(-LIMIT),
                Curve::new(
                    Line::dots(INK),
                    motion.samples.iter().map(|sample| (sample.t, sample.sent[0])).collect(),
                ),
            ],
        ])],
    };
    let folder = Path::new("out/double_swing_up");
    let swing = noisy.solve(&Tsit5::new(), &model, 0.0, 2.4, HANGING)?.trajectory;
    let drawing = Drawing::new(&model, &swing).ghosts(12);
    let mut files = drawing.picture(&folder.join("rods"))?.to_vec();
    files.extend(figure.save(&folder.join("states"))?);
    files.iter().for_each(|path| println!("{}", path.display()));
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rods_stay_upright_under_noise_for_every_seed() {
        let model = TwoRods::new(TwoRodsParams {}).expect("physical");
        let controller = controller(&model).expect("a motion");
        let angles = angles(&model, controller, 1.0, 8).expect("regular");
        assert!(angles.iter().all(|&angle| angle < 0.02), "{angles:?}");
        // the filter leaves less noise in the force
        let noisy = controller.noise(NOISE).input_noise([INPUT_NOISE]);
        let motion = noisy
            .solve(&Tsit5::new(), &model, 0.0, T_END, HANGING)
            .expect("regular");
        let [planned, filtered] = [3.0..4.0, 7.0..8.0].map(|span| force(&motion, span));
        assert!(filtered < 0.5 * planned, "{filtered} {planned}");
    }
}
