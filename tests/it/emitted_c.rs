//! C code of scenes against their Rust code, bit for bit.

use std::array::from_fn;

use nalgebra::{SMatrix, SVector};
use pendulum_codegen::Sources;
use pendulum_codegen::program::Program;
use pendulum_core::ParameterError;
use pendulum_core::hybrid::{Hold, HybridJacobian, MAX_CONSTRAINTS, Response};
use pendulum_core::prelude::*;
use pendulum_core::real::Fused;
use pendulum_core::taylor::HybridSeries;
use pendulum_core::{Canonical, Controlled, TaylorSeries};
use testbed::mechanisms::{Furuta, FurutaParams};
use testbed::random::Random;
use testbed::robots::{Ur5, Ur5Params};
use testbed::scenes::{DoublePendulum, DoublePendulumParams};
use testbed::source::{MECHANISMS, ROBOTS, SCENES, declaration};

use crate::c_code::{ORDER, compiled, folder, output, results};

mechanism! {
    /// Names that C cannot take, two inputs, and every function of the platform.
    ///
    /// A path: C:\
    pub Driven {
        units: none,
        params { double: kg = 0.4, x: m = 0.7, härte: N/m = 3, hu00e4rte: m = 0.2, r#in: N m = 0.3 }
        input unsigned: N,
        input r#loop: N m,
        gravity: [0, -9.81, 0],
        generate: [rhs, jacobian, energy, parameter_jacobian],
        body cart on ground {
            mass: 2,
            joint: prismatic(x),
            coordinate: int,
            spring: (härte, hu00e4rte),
            torque: unsigned - 0.1 * tanh(5*qd) * abs(qd)^(1/3) * exp(-q^2) + tan(q/4) * ln(2 + q^2),
        }
        body rod on cart {
            solids: [rod(double, [0, 0, 0], [0, -x, 0])],
            joint: revolute(z),
            coordinate: out,
            torque: r#in * sin(3*t) + clamp(r#in * qd, -x, x) + r#loop * cos(q) - 0.02 * dot(int) * atan2(sin(q),
                2 + cos(q)) * sqrt(1 + qd^2),
        }
    }
}

mechanism! {
    /// Two joints in space.
    pub Wrist {
        params { l: m = 0.7, slope: rad = 0.2 }
        // constants have sines of their own, in plain arithmetic
        gravity: [9.81*sin(slope), 0, -9.81*cos(slope)],
        generate: [rhs, jacobian, energy],
        body first on ground {
            mass: 3, com: [0.01, 0.02, 0.15], inertia: [0.03, 0.03, 0.02],
            joint: revolute(z), coordinate: a, friction: 0.1,
        }
        body second on first {
            mass: 2, com: [0.2, 0, 0.01], inertia: [0.031, 0.027, 0.018, -0.004, 0.002, 0.003],
            joint: revolute([1, 2, 3]) at [0, l, 0.3], coordinate: b, friction: 0.1,
        }
    }
}

mechanism! {
    /// An inertia that is valid only for some parameters.
    pub Solid {
        params {
            ixx: kg m^2 = 1, iyy: kg m^2 = 1, izz: kg m^2 = 1,
            ixy: kg m^2 = 0, ixz: kg m^2 = 0, iyz: kg m^2 = 0,
        }
        body b on ground {
            mass: 1, inertia: [ixx, iyy, izz, ixy, ixz, iyz],
            joint: revolute([1, 2, 3]),
            coordinate: angle,
        }
    }
}

mechanism! {
    /// A driven joint, points, outputs and an event.
    pub Crane {
        params { l: m = 0.7, w: rad/s = 2 }
        gravity: [0, -9.81, 0],
        generate: [rhs, jacobian, energy, drive_forces],
        point hook on rope at [0, -l, 0],
        point wall on ground at [1, 0, 0],
        spring between hook and wall: (3, 0.4),
        force on hook: [-1 N s/m * dot(hook.x), 0, 0],
        output double: hook,
        output turned: rotation(rope),
        output speed: dot(hook.x),
        event passes: hook.x - 1/10,
        body trolley on ground { joint: prismatic(x), motion: sin(w*t)/2 }
        body rope on trolley { mass: 1, com: [0, -l, 0], joint: revolute(z), coordinate: int }
    }
}

mechanism! {
    /// First-order states, one with a name of C.
    pub Lagging {
        params { tau: s = 0.3, k: N/m = 2, r: ohm = 0.5, ind: V s/A = 0.1, c: N/A = 0.7 }
        gravity: [0, -9.81, 0],
        generate: [rhs, jacobian, energy, parameter_jacobian, taylor],
        state double { unit: N, rate: (k*tip.x - double)/tau }
        state i { unit: A, rate: (3 V*sin(2 rad/s*t) - r*i - c*dot(s))/ind }
        point tip on rod at [0, -1, 0],
        force on tip: [-double, 0, 0],
        body cart on ground { mass: 2, joint: prismatic(x), coordinate: s, torque: c*i }
        body rod on cart { mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: turn }
    }
}

mechanism! {
    /// Dry friction and a stop, and a moving wall.
    pub Constrained {
        params { mu: N m = 0.3 }
        gravity: [0, -9.81, 0],
        generate: [rhs, jacobian, energy, canonical, taylor],
        point tip on rod at [0, -1, 0],
        wall side { gap: 2 - tip.x + 0.125 m/s^2*t^2, restitution: 0.5 }
        body cart on ground { mass: 2, joint: prismatic(x), coordinate: s }
        body rod on cart {
            mass: 1, com: [0, -1, 0], joint: revolute(z), coordinate: turn, dry_friction: mu, stop: [-1, 1],
        }
    }
}

mechanism! {
    /// A loop in space without a closed form.
    pub Coupled {
        gravity: [0, 1, -9.81],
        generate: [rhs, jacobian, energy, taylor],
        body crank on ground { mass: 2, com: [0.01, 0, 0], inertia: 0.1, joint: revolute(z),
            coordinate: theta near 0.8 }
        body yoke on crank { mass: 0.1, inertia: 0.001, joint: revolute(z) at [0.06, 0, 0.02],
            coordinate: alpha depends near 0.1 }
        body rod on yoke { mass: 0.4, com: [0.4, 0, 0], inertia: [0.01, 0.01, 0.01], joint: revolute(y),
            coordinate: beta depends near -0.7 }
        body rocker on ground {
            mass: 0.9, com: [0, 0.3, 0.1], inertia: 0.02,
            joint: revolute([1, 0, 0.02]) at [0.4, 0, 0.1], coordinate: gamma depends near 0.6, friction: 0.3,
        }
        close rod at [0.815, 0, 0] to rocker at [0, 0.7, 0.1]: ball,
    }
}

/// Source of this file, with its declarations.
pub(crate) const OWN: &str = include_str!("emitted_c.rs");

/// Number of states in which each scene is compared.
const STATES: usize = 3000;

#[test]
fn the_double_pendulum_is_the_same() {
    let model = DoublePendulum::new(DoublePendulumParams::default()).expect("physical");
    same(SCENES, "DoublePendulum", 0.0, |t, x, _| {
        let x = SVector::<f64, 4>::from_column_slice(x);
        [motion(&model, t, &x), canonical(&model, t, &x), series(&model, t, &x)].concat()
    });
}

#[test]
fn the_furuta_pendulum_is_the_same() {
    let model = Furuta::new(FurutaParams {}).expect("physical");
    same(MECHANISMS, "Furuta", 0.0, |t, x, qdd| {
        let (x, qdd) = (
            SVector::<f64, 4>::from_column_slice(x),
            SVector::<f64, 2>::from_column_slice(qdd),
        );
        let (mass, bias, momentum) = (model.mass_matrix(t, &x), model.bias(t, &x), model.momentum(t, &x));
        let forces = model.inverse_dynamics(t, &x, &qdd);
        let own = [mass.as_slice(), bias.as_slice(), momentum.as_slice()].concat();
        [
            motion(&model, t, &x),
            own,
            canonical(&model, t, &x),
            forces.as_slice().to_vec(),
        ]
        .concat()
    });
}

#[test]
#[ignore = "takes long"]
fn a_robot_is_the_same() {
    let model = Ur5::new(Ur5Params {}).expect("physical");
    same(ROBOTS, "Ur5", 0.0, |t, x, qdd| {
        let (x, qdd) = (
            SVector::<f64, 12>::from_column_slice(x),
            SVector::<f64, 6>::from_column_slice(qdd),
        );
        let (mass, bias, momentum) = (model.mass_matrix(t, &x), model.bias(t, &x), model.momentum(t, &x));
        let forces = model.inverse_dynamics(t, &x, &qdd);
        let own = [mass.as_slice(), bias.as_slice(), momentum.as_slice(), forces.as_slice()].concat();
        [motion(&model, t, &x), own, series(&model, t, &x)].concat()
    });
}

#[test]
fn fused_code_is_the_same() {
    let program = printed(OWN, "Wrist").0;
    let sources = pendulum_codegen::c_fused(&program);
    assert!(sources.source.matches("PENDULUM_FMA").count() > 50);
    let model = Wrist::new(WristParams::default())
        .expect("physical")
        .cast::<Fused<f64>>();
    agree("Wrist", &program, &sources, 0.0, |t, x, _| {
        let (t, x) = (Fused(t), SVector::<f64, 4>::from_column_slice(x).map(Fused));
        let (rhs, (rates, jacobian)) = (model.rhs(t, &x), model.rhs_and_jacobian(t, &x));
        let energies = [model.kinetic(t, &x), model.potential(t, &x)];
        let all = [rhs.as_slice(), rates.as_slice(), jacobian.as_slice(), &energies].concat();
        all.into_iter().map(|number| number.0).collect()
    });
    let Some(folder) = folder("Wrist") else { return };
    let main = "#include <stdio.h>\n#include \"wrist.h\"\n\
                double twice(double a, double b, double c) { return a * b + c; }\n\
                int main(void) { printf(\"%d\", wrist_rounds_once()); return 0; }\n";
    // a platform whose operation rounds twice
    for (fma, expected) in [("fma", "1"), ("twice", "0")] {
        let source = format!("#define PENDULUM_FMA {fma}\n{}", sources.source);
        let sources = Sources {
            source,
            ..sources.clone()
        };
        let told = output(&compiled(&folder, &sources, main), &[]);
        assert_eq!(String::from_utf8_lossy(&told), expected, "{fma}");
    }
}

#[test]
fn functions_of_the_platform_are_called() {
    let model = Driven::new(DrivenParams::default()).expect("physical");
    // two libraries may differ in the last bit
    same(OWN, "Driven", 1e-15, |t, x, more| {
        let x = SVector::<f64, 4>::from_column_slice(x);
        // the numbers that follow the accelerations
        let u = DrivenInputs {
            unsigned: more[2],
            r#loop: more[3],
        };
        let (rhs, (rates, jacobian)) = (model.eval(t, &x, &u), model.eval_with_jacobian(t, &x, &u));
        let by_time = model.eval_time_derivative(t, &x, &u);
        let by_inputs: SMatrix<f64, 4, 2> = model.input_jacobian(t, &x, &u);
        let by_parameters = model.parameter_jacobian(t, &x, &u);
        let energies = [model.kinetic(t, &x), model.potential(t, &x)];
        let motion = [
            rhs.as_slice(),
            rates.as_slice(),
            jacobian.as_slice(),
            by_time.as_slice(),
            by_inputs.as_slice(),
            &energies,
        ];
        let saturation = [model.saturation_1(t, &x)];
        [&motion.concat()[..], by_parameters.as_slice(), &saturation].concat()
    });
}

#[test]
fn drives_outputs_and_events_are_the_same() {
    let model = Crane::new(CraneParams::default()).expect("physical");
    same(OWN, "Crane", 0.0, |t, x, _| {
        let x = SVector::<f64, 2>::from_column_slice(x);
        let mut all = motion_in_time(&model, t, &x);
        all.extend(&model.drive_forces(t, &x));
        let (value, jacobian) = model.double_and_jacobian(t, &x);
        all.extend(&model.double(t, &x));
        all.extend(&model.double_rate(t, &x));
        all.extend(&value);
        all.extend(&jacobian);
        let (value, jacobian) = model.turned_and_jacobian(t, &x);
        all.extend(&model.turned(t, &x));
        all.extend(&model.turned_rate(t, &x));
        all.extend(&value);
        all.extend(&jacobian);
        let (value, jacobian) = model.speed_and_jacobian(t, &x);
        all.extend([model.speed(t, &x), model.speed_rate(t, &x), value]);
        all.extend(&jacobian);
        let (values, jacobian) = model.outputs_and_jacobian(t, &x);
        all.extend(&model.outputs(t, &x));
        all.extend(&model.output_rates(t, &x));
        all.extend(&values);
        all.extend(&jacobian);
        all.push(model.passes(t, &x));
        all
    });
}

#[test]
fn states_are_the_same() {
    let model = Lagging::new(LaggingParams::default()).expect("physical");
    same(OWN, "Lagging", 0.0, |t, x, _| {
        let x = SVector::<f64, 6>::from_column_slice(x);
        let motion = motion(&model, t, &x);
        let (rates, energies) = motion.split_at(motion.len() - 2);
        let (by_time, by_parameters) = (model.time_derivative(t, &x), model.parameter_jacobian(t, &x));
        let whole = [rates, by_time.as_slice(), energies, by_parameters.as_slice()].concat();
        [whole, series(&model, t, &x)].concat()
    });
}

mechanism! {
    /// A ball joint with an arm, on a free body.
    pub Floating {
        gravity: [0, 0, -9.81],
        generate: [rhs, jacobian, energy, mass_matrix, taylor],
        body craft on ground {
            mass: 3, com: [0.1, 0.1, -0.1], inertia: [0.3, 0.25, 0.2],
            joint: free at [1, 0, 0], orientation: craft, position: int,
        }
        body bob on craft { mass: 0.7, com: [0, 0, -0.4], inertia: [0.01, 0.02, 0.015], joint: ball,
            orientation: double }
        body arm on bob { mass: 0.1, com: [0.2, 0, 0], joint: revolute(y), coordinate: out }
    }
}

#[test]
#[ignore = "takes long"]
fn balls_are_the_same() {
    let model = Floating::new(FloatingParams {}).expect("physical");
    same(OWN, "Floating", 0.0, |t, x, _| {
        let x = SVector::<f64, 22>::from_column_slice(x);
        let mut placed = x;
        model.project(t, &mut placed);
        let mass = model.mass_matrix(t, &x);
        let mut all = motion(&model, t, &x);
        all.extend(&mass);
        all.extend(series(&model, t, &x));
        all.extend(&placed);
        all
    });
}

mechanism! {
    /// Springs on angles that count their turns. Lengths decide which vector leads.
    pub Wound {
        params { a: m = 0.2, d: m = 0.6 }
        gravity: [0, -9.81, 0],
        generate: [rhs, energy],
        body crank on ground { mass: 0.5, com: [0.1, 0, 0], inertia: 0.002, joint: revolute(z),
            coordinate: theta near 0.8 }
        body coupler on crank {
            mass: 1.1, com: [0.25, 0, 0], inertia: 0.02,
            joint: revolute(z) at [a, 0, 0], coordinate: phi depends near -0.3, spring: (0.7, 0.1),
        }
        body rocker on ground {
            mass: 0.9, com: [0.2, 0, 0], inertia: 0.01,
            joint: revolute(z) at [d, 0, 0], coordinate: psi depends near 1.6, spring: (0.2, 0),
        }
        close coupler at [0.5, 0, 0] to rocker at [0.4, 0, 0]: revolute(z),
    }
}

mechanism! {
    /// A crank that turns all the way, in a closed loop.
    pub Looped {
        gravity: [0, -9.81, 0],
        generate: [rhs, jacobian, energy, mass_matrix, loop_wrenches, taylor],
        body crank on ground { mass: 0.5, com: [0.1, 0, 0], inertia: 0.002, joint: revolute(z),
            coordinate: theta near 0.8 }
        body coupler on crank {
            mass: 1.1, com: [0.25, 0, 0], inertia: 0.02,
            joint: revolute(z) at [0.2, 0, 0], coordinate: phi depends near -0.3,
        }
        body rocker on ground {
            mass: 0.9, com: [0.2, 0, 0], inertia: 0.01, joint: revolute(z) at [0.6, 0, 0],
                coordinate: psi depends near 1.6,
        }
        close coupler at [0.5, 0, 0] to rocker at [0.4, 0, 0]: revolute(z),
    }
}

#[test]
fn closed_loops_are_the_same() {
    let model = Looped::new(LoopedParams {}).expect("physical");
    same(OWN, "Looped", 0.0, |t, x, _| {
        let x = SVector::<f64, 2>::from_column_slice(x);
        let mut all = model.rhs(t, &x).as_slice().to_vec();
        let (margins, rates) = model.loop_margins(t, &x);
        all.extend(&margins);
        all.extend(&rates);
        all.extend(motion(&model, t, &x).into_iter().skip(2));
        all.extend(&model.mass_matrix(t, &x));
        all.extend(&model.loop_wrenches(t, &x));
        all.extend(series(&model, t, &x));
        all
    });
}

/// Equal except for the last bits of `atan2`, which is a platform function.
#[test]
fn angles_that_count_their_turns_are_the_same() {
    let model = Wound::new(WoundParams::default()).expect("physical");
    same(OWN, "Wound", 1e-13, |t, x, _| {
        let x = SVector::<f64, 2>::from_column_slice(x);
        let mut all = model.rhs(t, &x).as_slice().to_vec();
        let (margins, rates) = model.loop_margins(t, &x);
        all.extend(&margins);
        all.extend(&rates);
        all.extend([model.kinetic(t, &x), model.potential(t, &x)]);
        all
    });
}

#[test]
#[ignore = "takes long"]
fn coupled_loops_are_the_same() {
    let model = Coupled::new(CoupledParams {}).expect("physical");
    same(OWN, "Coupled", 0.0, |t, x, _| {
        let x = SVector::<f64, 5>::from_column_slice(x);
        let mut all = model.rhs(t, &x).as_slice().to_vec();
        let (margins, rates) = model.loop_margins(t, &x);
        all.extend(&margins);
        all.extend(&rates);
        all.extend(&model.loop_corrections(t, &x));
        let (distances, angles, sizes) = model.loop_gaps(t, &x);
        all.extend([distances, angles, sizes].iter().flatten());
        all.extend(motion(&model, t, &x).into_iter().skip(5));
        all.extend(series(&model, t, &x));
        all
    });
}

#[test]
fn constraints_are_the_same() {
    let model = Constrained::new(ConstrainedParams::default()).expect("physical");
    same(OWN, "Constrained", 0.0, |t, x, forces| {
        let (x, forces) = (SVector::<f64, 4>::from_column_slice(x), all_forces(forces, 2));
        let mut all = with_forces(&model, t, &x, &forces);
        let (variables, rates) = model.eval_canonical(t, &x, &forces);
        let (of_variables, of_rates) = model.eval_canonical_jacobian(t, &x, &forces);
        all.extend(variables.iter().chain(&rates).chain(&of_variables).chain(&of_rates));
        all.extend(series_with_forces(&model, t, &x, forces));
        all
    });
}

mechanism! {
    /// A floating body whose dry hinge has stops, a leg on a ball joint, and a moving floor.
    pub Landing {
        gravity: [0, 0, -9.81],
        generate: [rhs, jacobian, energy, taylor],
        point foot on leg at [0, 0, -0.5],
        wall floor { gap: foot.z - 0.125 m/s^2*t^2, restitution: 0.5 }
        body hull on ground {
            mass: 3, com: [0.1, 0.1, -0.1], inertia: [0.3, 0.25, 0.2], joint: free, orientation: o, position: p,
        }
        body flap on hull {
            mass: 0.1, com: [0.2, 0, 0], joint: revolute(y) at [0.1, 0, 0], coordinate: a,
            dry_friction: 0.3, stop: [-1, 1] restitution(0.4),
        }
        body leg on hull { mass: 0.7, com: [0, 0, -0.3], inertia: [0.01, 0.02, 0.015], joint: ball, orientation: leg }
    }
}

#[test]
#[ignore = "takes long"]
fn constraints_of_floating_bodies_are_the_same() {
    let model = Landing::new(LandingParams {}).expect("physical");
    same(OWN, "Landing", 0.0, |t, x, forces| {
        let (x, forces) = (SVector::<f64, 22>::from_column_slice(x), all_forces(forces, 2));
        let mut placed = x;
        model.project(t, &mut placed);
        let mut all = with_forces(&model, t, &x, &forces);
        all.extend(series_with_forces(&model, t, &x, forces));
        all.extend(&placed);
        all
    });
}

/// Forces along the first `count` constraints.
fn all_forces(forces: &[f64], count: usize) -> [f64; MAX_CONSTRAINTS] {
    from_fn(|n| if n < count { forces[n] } else { 0.0 })
}

/// Motion, measures and response under forces along the constraints, with their derivatives, and the energies.
fn with_forces<S, const N: usize>(model: &S, t: f64, x: &SVector<f64, N>, forces: &[f64; MAX_CONSTRAINTS]) -> Vec<f64>
where
    S: HybridJacobian<f64, N> + Energy<f64, N>,
{
    let count = model.constraints().len();
    let mut all = model.eval(t, x, forces).as_slice().to_vec();
    let measures = model.measures(t, x);
    all.extend(
        [0, 1]
            .iter()
            .flat_map(|&which| measures[..count].iter().map(move |measure| measure[which])),
    );
    let add = |all: &mut Vec<f64>, response: &Response<f64, N>| {
        all.extend(&response.rates);
        all.extend(&response.accelerations[..count]);
        all.extend(response.columns[..count].iter().flatten());
        all.extend(response.matrix[..count].iter().flat_map(|row| &row[..count]));
    };
    add(&mut all, &model.response(t, x, forces));
    let (rates, jacobian) = model.eval_with_jacobian(t, x, forces);
    all.extend(rates.iter().chain(&jacobian));
    let derivative = model.response_derivative(t, x, forces);
    add(&mut all, &derivative.response);
    all.extend(&derivative.rates);
    all.extend(derivative.accelerations[..count].iter().flatten());
    all.extend(&derivative.rates_by_time);
    all.extend(&derivative.accelerations_by_time[..count]);
    let measures = model.measure_derivatives(t, x);
    for which in [0, 1] {
        all.extend(measures.by_state[..count].iter().flat_map(|row| &row[which]));
    }
    for which in [0, 1] {
        all.extend(measures.by_time[..count].iter().map(|row| row[which]));
    }
    all.extend([model.kinetic(t, x), model.potential(t, x)]);
    all
}

/// Coefficients of the motion under constant forces along the constraints.
fn series_with_forces<S, const N: usize>(
    model: &S,
    t: f64,
    x: &SVector<f64, N>,
    forces: [f64; MAX_CONSTRAINTS],
) -> Vec<f64>
where
    S: TaylorSeries<f64, N> + HybridSeries<f64, N, Workspace = <S as TaylorSeries<f64, N>>::Workspace>,
{
    let constant = Hold {
        forces,
        ..Hold::default()
    };
    let mut series = [*x; ORDER + 1];
    model.eval_series(&constant, t, &mut series, &mut model.workspace());
    series[1..].iter().flatten().copied().collect()
}

/// Results of `motion`, with the time derivative inserted before the energies.
fn motion_in_time(model: &Crane, t: f64, x: &SVector<f64, 2>) -> Vec<f64> {
    let motion = motion(model, t, x);
    let (rates, energies) = motion.split_at(motion.len() - 2);
    [rates, model.time_derivative(t, x).as_slice(), energies].concat()
}

fn motion<S: Jacobian<f64, N> + Energy<f64, N>, const N: usize>(model: &S, t: f64, x: &SVector<f64, N>) -> Vec<f64> {
    let (rhs, (rates, jacobian)) = (model.rhs(t, x), model.rhs_and_jacobian(t, x));
    let energies = [model.kinetic(t, x), model.potential(t, x)];
    [rhs.as_slice(), rates.as_slice(), jacobian.as_slice(), &energies].concat()
}

fn canonical<S: Canonical<f64, N>, const N: usize>(model: &S, t: f64, x: &SVector<f64, N>) -> Vec<f64> {
    let ((x0, rates), (of_x, of_rates)) = (model.canonical(t, x), model.canonical_jacobian(t, x));
    [x0.as_slice(), rates.as_slice(), of_x.as_slice(), of_rates.as_slice()].concat()
}

fn series<S: TaylorSeries<f64, N>, const N: usize>(model: &S, t: f64, x: &SVector<f64, N>) -> Vec<f64> {
    let mut series = [*x; ORDER + 1];
    model.series(t, &mut series, &mut model.workspace());
    series[1..].iter().flatten().copied().collect()
}

#[test]
fn the_same_parameters_are_refused() {
    refused(SCENES, "DoublePendulum", 8, |p| {
        let [m, inertia, c, d, g, gamma1, gamma2] = *p else {
            unreachable!()
        };
        DoublePendulum::new(DoublePendulumParams {
            m,
            inertia,
            c,
            d,
            g,
            gamma1,
            gamma2,
        })
        .err()
    });
    refused(OWN, "Solid", 8, |p| {
        let [ixx, iyy, izz, ixy, ixz, iyz] = *p else {
            unreachable!()
        };
        Solid::new(SolidParams {
            ixx,
            iyy,
            izz,
            ixy,
            ixz,
            iyz,
        })
        .err()
    });
}

#[test]
fn the_example_integrates_figure_2() {
    let Some(folder) = folder("fig2") else { return };
    let (_, sources) = printed(SCENES, "DoublePendulum");
    let main = include_str!("../../examples/emitted_c/fig2.c");
    let output = output(&compiled(&folder, &sources, main), &[]);
    let text = String::from_utf8(output).expect("text");
    let last = text.lines().last().expect("a table").split(',');
    let last: Vec<f64> = last.map(|number| number.parse().expect("a number")).collect();
    let model = DoublePendulum::new(DoublePendulumParams::default()).expect("physical");
    let solution = Rk4::new(0.01).solve(&model, 0.0, 20.0, [0.0, 4.0_f64.to_radians(), 0.0, 0.0]);
    let (t, x) = solution.expect("regular").last();
    assert_eq!(last[1..], [&[t], x.as_slice()].concat());
}

/// Compares all results of a scene with default parameters in many states, either bit for bit or relative to the
/// largest result.
fn same(source: &str, name: &str, tolerance: f64, rust: impl Fn(f64, &[f64], &[f64]) -> Vec<f64>) {
    let (program, sources) = printed(source, name);
    agree(name, &program, &sources, tolerance, rust);
}

/// Compares the results of C code with those of Rust code, at many states.
fn agree(
    name: &str,
    program: &Program,
    sources: &Sources,
    tolerance: f64,
    rust: impl Fn(f64, &[f64], &[f64]) -> Vec<f64>,
) {
    let Some(folder) = folder(name) else { return };
    let (length, dof, inputs) = (program.layout.len(), program.layout.dof(), program.inputs.len());
    let mut random = Random::new(1);
    let mut states: Vec<Vec<f64>> = Vec::new();
    for n in 0..STATES {
        // in every fourth state, angles whose sums reach the limit of our own sine, zeros of either sign, and
        // non-finite values
        let reach = if n % 4 == 0 && tolerance == 0.0 {
            1e5 / dof as f64
        } else {
            4.0
        };
        let mut state: Vec<f64> = (0..1 + length + dof + inputs)
            .map(|_| random.between(-4.0, 4.0))
            .collect();
        state[1..=dof].iter_mut().for_each(|angle| *angle *= reach / 4.0);
        let special = [0.0, -0.0, 0.0, -0.0, f64::NAN, f64::INFINITY];
        for (at, value) in special.into_iter().take(if n % 100 == 0 { 6 } else { 4 }).enumerate() {
            if n % 5 == 0 {
                let place = random.between(0.0, state.len() as f64) as usize;
                state[place] = if at < 4 || tolerance == 0.0 { value } else { 0.0 };
            }
        }
        states.push(state);
    }
    let mut results = results(&folder, program, sources, &states).into_iter();
    for state in &states {
        let (ours, theirs) = (
            rust(state[0], &state[1..=length], &state[1 + length..]),
            results.next().expect("results"),
        );
        assert_eq!(ours.len(), theirs.len(), "{name}: every routine");
        let allowed = tolerance * ours.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
        for (n, (ours, theirs)) in ours.iter().zip(&theirs).enumerate() {
            let agree = ours.to_bits() == theirs.to_bits() || (ours.is_nan() && theirs.is_nan());
            assert!(
                agree || (ours - theirs).abs() <= allowed,
                "{name}: result {n} at {state:?}: {ours:e}, not {theirs:e}"
            );
        }
    }
}

/// Compares the errors of `new` for invalid parameters, which break at least `rules` rules in total.
fn refused(source: &str, name: &str, rules: usize, rust: impl Fn(&[f64]) -> Option<ParameterError>) {
    let Some(folder) = folder(&format!("{name}Refused")) else {
        return;
    };
    let (program, sources) = printed(source, name);
    let main = include_str!("emitted_c/refuse.c")
        .replace("NAME", &sources.name.to_uppercase())
        .replace("name", &sources.name);
    let program_of_c = compiled(&folder, &sources, &main);
    let mut random = Random::new(2);
    let mut sets: Vec<Vec<f64>> = Vec::new();
    for _ in 0..5_000 {
        let mut set: Vec<f64> = program
            .parameters
            .iter()
            .filter_map(|parameter| parameter.default)
            .collect();
        for _ in 0..2 {
            let values = [
                f64::NAN,
                f64::INFINITY,
                0.0,
                -0.0,
                -1.0,
                0.501,
                2.001,
                1e200,
                -1e200,
                1e-200,
            ];
            let at = |random: &mut Random, count: usize| random.between(0.0, count as f64) as usize;
            let place = at(&mut random, set.len());
            set[place] = values[at(&mut random, values.len())];
        }
        sets.push(set);
    }
    let text = String::from_utf8(output(&program_of_c, &sets)).expect("text");
    let expected = sets.iter().map(|set| match rust(set) {
        None => "no error".to_owned(),
        Some(error) => match program.constants_text.iter().position(|text| text == error.name) {
            Some(n) if error.rule.starts_with("a constant of the equations") => format!("{} {n}", error.rule),
            _ => format!("`{}`: {}", error.name, error.rule),
        },
    });
    let expected: Vec<String> = expected.collect();
    assert_eq!(text.lines().collect::<Vec<_>>(), expected);
    let mut kinds = expected;
    kinds.sort();
    kinds.dedup();
    assert!(kinds.len() > rules, "{kinds:?}");
}

/// Program of a declaration, and its C code.
fn printed(source: &str, name: &str) -> (Program, Sources) {
    let tokens = declaration(source, name).parse().expect("tokens");
    let program = pendulum_codegen::program(tokens).expect("no errors");
    let sources = pendulum_codegen::c(&program);
    (program, sources)
}
