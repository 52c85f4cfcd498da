//! Dry friction and stops under sampled controllers.

use nalgebra::SVector;
use pendulum_core::control::{LinearLaw, Pid, Sampled};
use pendulum_core::prelude::*;

mechanism! {
    /// A block that sticks and slips, between a wall and the open.
    pub Block {
        params { m: kg = 1, mu: N = 2 }
        input push: N,
        body block on ground {
            mass: m, joint: prismatic(x), coordinate: s, torque: push, dry_friction: mu, stop: [0, 0.5],
        }
    }
}

pub(super) fn block() -> Block {
    Block::new(BlockParams::default()).expect("physical")
}

#[test]
fn a_block_sticks_and_slips_as_the_commands_say() {
    let sampled = Sampled::of_outputs(Square, 0.1, |t: f64, _x: &SVector<f64, 2>| [t]);
    let motion = sampled
        .solve(&Vern7::new(), &block(), 0.0, 1.1, [0.1, 0.0])
        .expect("a motion");
    // 1 m/s^2 over a period, then -1.5 m/s^2 until it sticks
    let stops = 0.1 / 1.5;
    let expected = 0.1 + 5.0 * (0.005 + 0.05 * stops);
    assert!(
        (motion.trajectory.end() - SVector::from([expected, 0.0])).amax() < 1e-12,
        "{}",
        motion.trajectory.end()
    );
    let modes = motion.trajectory.modes();
    assert_eq!(modes.len(), 11, "{modes:?}");
    for (k, (from, mode)) in modes.iter().enumerate() {
        let slips = 0.1 + 0.2 * (k / 2) as f64;
        let expected = if k == 0 {
            0.0
        } else if k % 2 == 1 {
            slips
        } else {
            slips - 0.1 + stops
        };
        assert!(
            mode.is_held(0) == (k % 2 == 0) && (from - expected).abs() < 1e-12,
            "{k} {from} {expected}"
        );
    }
}

/// Pushes with 3 N in odd periods of 0.1 s, with 0.5 N in the others.
#[derive(Clone, Debug, PartialEq)]
struct Square;

impl pendulum_core::InputLaw<1, 1> for Square {
    fn inputs<T: pendulum_core::Real>(&self, _t: T, measured: &SVector<T, 1>) -> [T; 1] {
        measured[0].piecewise(|t| [if (t / 0.1).round() as usize % 2 == 1 { 3.0 } else { 0.5 }])
    }
}

#[test]
fn a_mode_that_goes_on_across_samples_is_reported_once() {
    // held at the wall by a command that varies from sample to sample
    let law = LinearLaw {
        gain: nalgebra::SMatrix::<f64, 1, 2>::new(3.0, 1.0),
        x0: SVector::zeros(),
        u0: [-4.0],
    };
    let sampled = Sampled::new(law, 0.01).noise([0.05, 0.05]);
    let motion = sampled
        .solve(&Vern7::new(), &block(), 0.0, 2.0, [0.2, -0.5])
        .expect("a motion");
    let modes = motion.trajectory.modes();
    assert!((2..5).contains(&modes.len()), "{modes:?}");
    assert_eq!(motion.trajectory.end(), SVector::from([0.0, 0.0]));
    assert_eq!(motion.trajectory.impacts().len(), 1);
    assert_eq!(motion.samples.len(), 200);
    let end = sampled.end(&Vern7::new(), &block(), 0.0, 2.0, [0.2, -0.5]);
    assert_eq!(end, Ok(motion.trajectory.end()));
}

#[test]
fn a_motion_with_friction_is_that_of_a_loop_over_the_samples() {
    let pid = Pid::new(60.0, 80.0, 8.0).set_point(0.3);
    let sampled = Sampled::of_components(pid, 0.01, [Block::S]).limits([-6.0], [6.0]);
    let method = Vern9::new().rtol(1e-12).atol(1e-12);
    let motion = sampled
        .solve(&method, &block(), 0.0, 1.5, [0.45, 1.0])
        .expect("a motion");
    let (impacts, modes) = (motion.trajectory.impacts().len(), motion.trajectory.modes());
    assert!(impacts == 1 && modes.len() >= 3, "{impacts} {modes:?}");
    let mut x = SVector::from([0.45, 1.0]);
    for (k, sample) in motion.samples.iter().enumerate() {
        let push = sample.inputs[0];
        let held = block().with_inputs(move |_t, _x| BlockInputs { push });
        x = method
            .solve(&held, 0.01 * k as f64, (0.01 * (k + 1) as f64).min(1.5), x)
            .expect("a motion")
            .end();
    }
    assert!(
        (motion.trajectory.end() - x).amax() < 1e-9,
        "{} {x}",
        motion.trajectory.end()
    );
}

#[test]
fn ensembles_with_friction_have_the_bits_of_trajectories_alone() {
    let pid = Pid::new(60.0, 80.0, 8.0).set_point(0.3);
    let sampled = Sampled::of_components(pid, 0.01, [Block::S]).noise([1e-3]);
    let starts: Vec<_> = (0..5).map(|i| SVector::from([0.1 * f64::from(i), 0.3])).collect();
    let ends = sampled
        .ensemble(&Tsit5::new(), &[block()], 0.0, 1.0, &starts)
        .expect("motions");
    for (i, start) in starts.iter().enumerate() {
        assert_eq!(
            sampled.member(i as u64).end(&Tsit5::new(), &block(), 0.0, 1.0, *start),
            Ok(ends[i])
        );
    }
}
