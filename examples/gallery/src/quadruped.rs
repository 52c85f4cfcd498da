//! # Quadruped that leaps
//!
//! A trunk and four legs of two hinges each, in the air: 14 degrees of freedom. Torques in the joints make the legs
//! paddle. They change neither the parabola of the centre of mass nor the angular momentum about it.

use nalgebra::Vector3;
use pendulum_core::prelude::*;

use crate::{Check, Run, larger, orientation};

mechanism! {
    /// x points ahead, y to the left, z upward.
    pub Quadruped {
        params { k: N m = 4, c: N m s = 0.05, pull: N m = 2.5, w: rad/s = 20 }
        gravity: [0, 0, -9.81],
        let beat = pull*sin(w*t),
        shape thigh { solids: [rod(0.3, [0, 0, 0], [0, 0, -0.2])] }
        shape shin { solids: [rod(0.15, [0, 0, 0], [0, 0, -0.2])] }
        body trunk on ground {
            solids: [cuboid(4, [0.44, 0.14, 0.08], [0, 0, 0])], joint: free, orientation: o, position: p,
        }
        body thigh1 on trunk: thigh {
            joint: revolute(y) at [0.2, 0.1, 0], coordinate: hip1, spring: (k, 0.5), friction: c, torque: beat,
        }
        body shin1 on thigh1: shin { joint: revolute(y) at [0, 0, -0.2], coordinate: knee1,
            spring: (k, -1), friction: c }
        body thigh2 on trunk: thigh {
            joint: revolute(y) at [0.2, -0.1, 0], coordinate: hip2, spring: (k, 0.5), friction: c, torque: -beat,
        }
        body shin2 on thigh2: shin { joint: revolute(y) at [0, 0, -0.2], coordinate: knee2,
            spring: (k, -1), friction: c }
        body thigh3 on trunk: thigh {
            joint: revolute(y) at [-0.2, 0.1, 0], coordinate: hip3, spring: (k, 0.5), friction: c, torque: -beat,
        }
        body shin3 on thigh3: shin { joint: revolute(y) at [0, 0, -0.2], coordinate: knee3,
            spring: (k, -1), friction: c }
        body thigh4 on trunk: thigh {
            joint: revolute(y) at [-0.2, -0.1, 0], coordinate: hip4, spring: (k, 0.5), friction: c, torque: beat,
        }
        body shin4 on thigh4: shin { joint: revolute(y) at [0, 0, -0.2], coordinate: knee4,
            spring: (k, -1), friction: c }
        point foot1 on shin1 at [0, 0, -0.2], point foot2 on shin2 at [0, 0, -0.2],
        point foot3 on shin3 at [0, 0, -0.2], point foot4 on shin4 at [0, 0, -0.2],
        output foot1: foot1, output foot2: foot2, output foot3: foot3, output foot4: foot4,
        generate: [rhs, energy, shapes],
    }
}

/// Mass of the trunk.
const TRUNK: f64 = 4.0;
/// Masses of a thigh and a shin.
const ROD: [f64; 2] = [0.3, 0.15];

/// Point mass: its mass, position and velocity.
type Mass = (f64, Vector3<f64>, Vector3<f64>);

/// Indices of the positions and rates of hip and knee, leg by leg.
const LEGS: [[usize; 4]; 4] = [
    [
        Quadruped::HIP1,
        Quadruped::KNEE1,
        Quadruped::DOT_HIP1,
        Quadruped::DOT_KNEE1,
    ],
    [
        Quadruped::HIP2,
        Quadruped::KNEE2,
        Quadruped::DOT_HIP2,
        Quadruped::DOT_KNEE2,
    ],
    [
        Quadruped::HIP3,
        Quadruped::KNEE3,
        Quadruped::DOT_HIP3,
        Quadruped::DOT_KNEE3,
    ],
    [
        Quadruped::HIP4,
        Quadruped::KNEE4,
        Quadruped::DOT_HIP4,
        Quadruped::DOT_KNEE4,
    ],
];

/// Positions of the hips on the trunk.
const HIPS: [[f64; 3]; 4] = [[0.2, 0.1, 0.0], [0.2, -0.1, 0.0], [-0.2, 0.1, 0.0], [-0.2, -0.1, 0.0]];

/// Hip, knee and foot of a leg, with their velocities, by hand.
fn leg(x: &SVector<f64, 29>, n: usize) -> [(Vector3<f64>, Vector3<f64>); 3] {
    let [hip, knee, hip_rate, knee_rate] = LEGS[n].map(|at| x[at]);
    let turned = orientation(x, Quadruped::O);
    let three = |at: usize| -> Vector3<f64> { x.fixed_rows::<3>(at).into_owned() };
    let (place, velocity, spin) = (
        three(Quadruped::P_X),
        three(Quadruped::DOT_P_X),
        three(Quadruped::DOT_O),
    );
    // direction of a rod, and its rate, for a rotation about y, in the frame of the trunk
    let along = |angle: f64, rate: f64| {
        let (sine, cosine) = angle.sin_cos();
        [
            Vector3::new(-sine, 0.0, -cosine),
            rate * Vector3::new(-cosine, 0.0, sine),
        ]
        .map(|v| 0.2 * v)
    };
    let [thigh, thigh_rate] = along(hip, hip_rate);
    let [shin, shin_rate] = along(hip + knee, hip_rate + knee_rate);
    let first = (Vector3::from(HIPS[n]), Vector3::zeros());
    let second = (first.0 + thigh, thigh_rate);
    let third = (second.0 + shin, second.1 + shin_rate);
    [first, second, third].map(|(at, rate)| (place + turned * at, velocity + turned * (spin.cross(&at) + rate)))
}

/// All masses as points; a thin rod is equivalent to two thirds of its mass in the middle and one sixth at each end.
fn masses(x: &SVector<f64, 29>) -> Vec<Mass> {
    let mut masses = Vec::new();
    for n in 0..4 {
        let joints = leg(x, n);
        for (m, ends) in ROD.into_iter().zip(joints.windows(2)) {
            let middle = (0.5 * (ends[0].0 + ends[1].0), 0.5 * (ends[0].1 + ends[1].1));
            masses.extend([(m / 6.0, ends[0]), (m / 6.0, ends[1]), (m / 1.5, middle)].map(|(m, (at, v))| (m, at, v)));
        }
    }
    masses
}

/// Centre of mass, its velocity, and the angular momentum about it.
fn whole(x: &SVector<f64, 29>) -> [Vector3<f64>; 3] {
    let three = |at: usize| -> Vector3<f64> { x.fixed_rows::<3>(at).into_owned() };
    let mut masses = masses(x);
    masses.push((TRUNK, three(Quadruped::P_X), three(Quadruped::DOT_P_X)));
    let total: f64 = masses.iter().map(|(m, ..)| m).sum();
    let centre = masses.iter().map(|(m, at, _)| *m * at).sum::<Vector3<f64>>() / total;
    let velocity = masses.iter().map(|(m, _, v)| *m * v).sum::<Vector3<f64>>() / total;
    let orbits: Vector3<f64> = masses.iter().map(|(m, at, v)| *m * (at - centre).cross(v)).sum();
    let [x2, y2, z2] = [0.44, 0.14, 0.08].map(|edge: f64| edge * edge);
    let inertia = TRUNK / 12.0 * Vector3::new(y2 + z2, x2 + z2, x2 + y2);
    let spin = orientation(x, Quadruped::O) * inertia.component_mul(&three(Quadruped::DOT_O));
    [centre, velocity, orbits + spin]
}

/// Checks the parabola of the centre of mass and the angular momentum about it, both with all masses by hand, the feet,
/// and the power of the joints.
pub fn run() -> Result<Run, Box<dyn std::error::Error>> {
    let params = QuadrupedParams::default();
    let model = Quadruped::new(params)?;
    let mut start = SVector::from([0.0; 29]);
    start[Quadruped::O] = 1.0;
    for [hip, knee, ..] in LEGS {
        (start[hip], start[knee]) = (0.5, -1.0);
    }
    start
        .fixed_rows_mut::<3>(Quadruped::DOT_P_X)
        .copy_from_slice(&[2.2, 0.0, 3.2]);
    start
        .fixed_rows_mut::<3>(Quadruped::DOT_O)
        .copy_from_slice(&[0.4, -0.8, 0.6]);
    let solution = Vern9::new().rtol(1e-12).atol(1e-12).solve(&model, 0.0, 0.7, start)?;
    let [centre, velocity, angular] = whole(&start);
    let gravity = Vector3::new(0.0, 0.0, -9.81);
    let (mut off, mut turned, mut feet) = (0.0, 0.0, 0.0);
    for (t, x) in solution.points() {
        let [now, _, about] = whole(x);
        off = larger(off, (now - centre - t * velocity - 0.5 * t * t * gravity).norm());
        turned = larger(turned, (about - angular).norm());
        let found = [
            model.foot1(t, x),
            model.foot2(t, x),
            model.foot3(t, x),
            model.foot4(t, x),
        ];
        for (n, foot) in found.into_iter().enumerate() {
            feet = larger(feet, (foot - leg(x, n)[2].0).norm());
        }
    }
    let checks = vec![
        Check::new("centre of mass off its parabola, in m", off, 0.0, 1e-12),
        Check::new("change of the angular momentum, in N m s", turned, 0.0, 1e-12),
        Check::new("feet, in m", feet, 0.0, 1e-14),
    ];
    let powers = move |t: f64, x: &SVector<f64, 29>| {
        let QuadrupedParams { c, pull, w, .. } = params;
        let beat = pull * (w * t).sin();
        let legs = LEGS.iter().zip([beat, -beat, -beat, beat]);
        let each = legs.flat_map(|(leg, torque)| {
            let [hip, knee] = [x[leg[2]], x[leg[3]]];
            [torque * hip, -c * hip * hip, -c * knee * knee]
        });
        each.collect()
    };
    Run::new(checks, model, solution, powers, |drawing| {
        drawing
            .seen_from([0.25, -1.0, 0.3], [0.0, 0.0, 1.0])
            .ghosts(3)
            .speed(0.25)
    })
}
