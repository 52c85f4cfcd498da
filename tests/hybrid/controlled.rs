//! Scenes with inputs and with dry friction, stops or walls move like scenes with the control law in the declaration.

use std::f64::consts::FRAC_PI_2;

use nalgebra::{SMatrix, SVector};
use pendulum_core::hybrid::{Mode, Status};
use pendulum_core::prelude::*;
use pendulum_core::real::Real;
use pendulum_core::real::lanes::Isa;
use pendulum_core::stability::{Lyapunov, resting, transition};
use pendulum_core::{InputLaw, Solution};
use testbed::dual::Dual;
use testbed::random::Random;

use super::scenes::{check_derivatives, check_response, check_tangents};

mechanism! {
    /// A dry cart between stops, driven by a motor that saturates, and a rod on it beside a moving wall.
    pub Pushed {
        params { mu: N = 2, more: N = 0.5, e: 1 = 0.4 }
        input push: N,
        input twist: N m,
        gravity: [0, -9.81, 0],
        point tip on rod at [0, -1, 0],
        wall side { gap: 1.4 - tip.x + 0.1 m*sin(2 rad/s*t), restitution: 0.6 }
        body cart on ground {
            mass: 2, joint: prismatic(x), coordinate: s, torque: 10 N*tanh(push/10 N),
            dry_friction: mu, static_friction: mu + more, stop: [-1, 1] restitution(e),
        }
        body rod on cart {
            solids: [rod(0.5, [0, 0, 0], [0, -1, 0])], joint: revolute(z), coordinate: a, dry_friction: 0.2,
            torque: twist,
        }
    }
}

mechanism! {
    /// `Pushed` with the control law in the scene.
    pub Written {
        params { mu: N = 2, more: N = 0.5, e: 1 = 0.4 }
        gravity: [0, -9.81, 0],
        point tip on rod at [0, -1, 0],
        wall side { gap: 1.4 - tip.x + 0.1 m*sin(2 rad/s*t), restitution: 0.6 }
        let push = -12 N/m*s - 1 N s/m*dot(s) + 6 N*sin(1.3 rad/s*t),
        let twist = -0.3 N m s*dot(a)*cos(a) + 0.4 N m*sin(a + 0.5 rad/s*t),
        body cart on ground {
            mass: 2, joint: prismatic(x), coordinate: s, torque: 10 N*tanh(push/10 N),
            dry_friction: mu, static_friction: mu + more, stop: [-1, 1] restitution(e),
        }
        body rod on cart {
            solids: [rod(0.5, [0, 0, 0], [0, -1, 0])], joint: revolute(z), coordinate: a, dry_friction: 0.2,
            torque: twist,
        }
    }
}

/// Control law of `Written`.
#[derive(Clone, PartialEq)]
struct Control;

impl InputLaw<4, 2> for Control {
    fn inputs<T: Real>(&self, t: T, x: &SVector<T, 4>) -> [T; 2] {
        let number = T::from_f64;
        let [s, a, ds, da] = x.data.0[0];
        let push = -number(12.0) * s - ds + number(6.0) * (number(1.3) * t).sin_cos().0;
        let damping = -number(0.3) * da * a.sin_cos().1;
        let twist = damping + number(0.4) * (a + number(0.5) * t).sin_cos().0;
        PushedInputs { push, twist }.into()
    }
}

type Closed = pendulum_core::WithInputs<Pushed, pendulum_core::inputs::Generic<Control>, 2>;

fn closed(params: PushedParams) -> Closed {
    Pushed::new(params).expect("physical").with_law(Control)
}

fn written(PushedParams { mu, more, e }: PushedParams) -> Written {
    Written::new(WrittenParams { mu, more, e }).expect("physical")
}

const START: [f64; 4] = [0.5, -0.7, 2.0, 1.0];

#[test]
fn responses_and_their_derivatives_know_the_law() {
    let dual = Pushed::new(PushedParams::default()).expect("physical").cast::<Dual>();
    let dual = pendulum_core::WithInputs::with_law(dual, Control);
    let closed = closed(PushedParams::default());
    check_response::<_, _, 4>(&closed, &dual, 3);
    check_derivatives::<_, _, 4>(&closed, &dual, 3);
}

#[test]
fn tangents_know_the_law() {
    let (impacts, _) = check_tangents(&closed(PushedParams::default()), [0.7, -0.7, 3.0, 1.0], 0.4, 1e-7);
    assert!(impacts > 0);
    let (_, matrix) = transition(&closed(PushedParams::default()), 0.0, 2.0, START, 1e-12).expect("regular");
    let (_, theirs) = transition(&written(PushedParams::default()), 0.0, 2.0, START, 1e-12).expect("regular");
    assert!((matrix - theirs).amax() < 1e-8 * theirs.amax(), "{matrix} {theirs}");
}

/// Compares the ends of all modes, and the states within them.
fn assert_same<const N: usize>(ours: &Solution<f64, N>, theirs: &Solution<f64, N>, allowed: f64, what: &str) {
    assert_eq!(ours.modes().len(), theirs.modes().len(), "{what}");
    for ((t, mode), (t_other, other)) in ours.modes().iter().zip(theirs.modes()) {
        assert!(
            (t - t_other).abs() < allowed && mode == other,
            "{what}: {mode:?} at {t}, {other:?} at {t_other}"
        );
    }
    for n in 1..50 {
        let t = ours.last().0 * f64::from(n) / 50.0;
        let apart = (ours.at(t).expect("inside") - theirs.at(t).expect("inside")).amax();
        assert!(apart < allowed, "{what}: {apart:e} apart at {t}");
    }
}

#[test]
fn every_method_integrates_a_closed_loop_as_a_scene_with_its_law() {
    let params = PushedParams::default();
    let (closed, written) = (closed(params), written(params));
    let tight = Vern9::new().rtol(1e-13).atol(1e-13);
    let reference = tight.solve(&written, 0.0, 8.0, START).expect("regular");
    let seen = |wanted: fn(&Mode) -> bool| reference.modes().iter().any(|(_, mode)| wanted(mode));
    assert!(reference.modes().len() > 10, "{:?}", reference.modes());
    assert!(seen(|mode| mode.0[0] == Status::Stuck) && seen(|mode| mode.0[1] == Status::Stuck));
    macro_rules! check {
        ($($method:ident $allowed:literal),*) => {
            $(
                let method = $method::new().rtol(1e-12).atol(1e-12);
                let ours = method.solve(&closed, 0.0, 8.0, START).expect("regular");
                assert_same(&ours, &reference, $allowed, stringify!($method));
            )*
        };
    }
    check!(Vern9 1e-9, Vern7 1e-9, Tsit5 1e-8, Rk45 1e-8, Rodas5P 1e-8, Rodas4 1e-7, Radau5 1e-7, Auto 1e-8);
    // the rate of a held joint is exactly zero
    let ours = tight.solve(&closed, 0.0, 8.0, START).expect("regular");
    let mut rests = 0;
    for pair in ours.modes().windows(2) {
        let ((from, mode), (to, _)) = (pair[0], pair[1]);
        let x = ours.at(0.5 * (from + to)).expect("inside");
        for n in (0..2).filter(|&n| mode.0[n] == Status::Stuck) {
            assert!(x[2 + n] == 0.0, "{x} in {mode:?}");
            rests += 1;
        }
    }
    assert!(rests > 1, "{rests}");
}

/// The law as a closure, with its derivative as another closure, by differences, and generic.
#[test]
fn laws_of_each_kind_give_the_same_motion() {
    let model = Pushed::new(PushedParams::default()).expect("physical");
    let law = |t: f64, x: &SVector<f64, 4>| PushedInputs::from(Control.inputs(t, x));
    let derivative = |t: f64, x: &SVector<f64, 4>| {
        let twist = [
            0.3 * x[3] * x[1].sin() + 0.4 * (x[1] + 0.5 * t).cos(),
            -0.3 * x[1].cos(),
        ];
        SMatrix::from([[-12.0, 0.0], [0.0, twist[0]], [-1.0, 0.0], [0.0, twist[1]]])
    };
    let tight = Vern9::new().rtol(1e-13).atol(1e-13);
    let generic = tight.solve(&model.with_law(Control), 0.0, 4.0, START).expect("regular");
    let alone = tight.solve(&model.with_inputs(law), 0.0, 4.0, START).expect("regular");
    assert_eq!(alone.end().map(f64::to_bits), generic.end().map(f64::to_bits));
    let stiff = Rodas5P::new().rtol(1e-11).atol(1e-11);
    let by_hand = model.with_inputs(law).with_derivative(derivative);
    let by_hand = stiff.solve(&by_hand, 0.0, 4.0, START).expect("regular");
    assert_same(&by_hand, &generic, 1e-8, "by hand");
    let by_differences = model.with_inputs(law).by_differences();
    let by_differences = stiff.solve(&by_differences, 0.0, 4.0, START).expect("regular");
    assert_same(&by_differences, &generic, 1e-7, "by differences");
}

#[test]
fn closed_loops_in_lanes_have_the_bits_of_those_alone() {
    fn same<M>(method: &M)
    where
        M: Ensemble<Closed, f64, 4> + Method<Closed, f64, 4>,
    {
        let mut random = Random::new(5);
        let (models, starts): (Vec<Closed>, Vec<SVector<f64, 4>>) = (0..16)
            .map(|_| {
                let params = PushedParams {
                    mu: random.between(0.2, 2.0),
                    ..PushedParams::default()
                };
                let start = [(-0.5, 0.5), (-0.8, 0.4), (-3.0, 3.0), (-3.0, 3.0)];
                let start = start.map(|(low, high)| random.between(low, high));
                (closed(params), SVector::from(start))
            })
            .unzip();
        for isa in Isa::available() {
            let ends = method.ensemble_on(isa, &models, 0.0, 3.0, &starts).expect("regular");
            for ((model, start), end) in models.iter().zip(&starts).zip(&ends) {
                let alone = method.solve(model, 0.0, 3.0, *start).expect("regular");
                assert_eq!(alone.end().map(f64::to_bits), end.map(f64::to_bits), "from {start}");
            }
        }
    }
    same(&Tsit5::new());
    same(&Vern9::new().rtol(1e-9).atol(1e-9));
    same(&Rk4::new(0.01));
}

mechanism! {
    /// A block on a dry track.
    pub Block {
        params { mu: N = 0.5, at_rest: N = 0.6 }
        input push: N,
        body block on ground {
            mass: 1, joint: prismatic(x), coordinate: s, torque: push, dry_friction: mu, static_friction: at_rest,
        }
    }
}

/// A proportional control, or a force that grows.
#[derive(Clone, PartialEq)]
struct Plain {
    stiffness: f64,
    growth: f64,
}

impl InputLaw<2, 1> for Plain {
    fn inputs<T: Real>(&self, t: T, x: &SVector<T, 2>) -> [T; 1] {
        [T::from_f64(self.growth) * t - T::from_f64(self.stiffness) * x[0]]
    }
}

#[test]
fn a_proportional_control_comes_to_rest_beside_its_goal() {
    // each swing takes half a period, about a centre shifted by friction, and is shorter than the last by twice this
    // shift
    let (stiffness, mu, start) = (4.0, 0.5, 1.05);
    let model = Block::new(BlockParams { mu, at_rest: 0.6 }).expect("physical");
    let law = |growth| Plain { stiffness, growth };
    let swings = [1.05_f64, -0.8, 0.55, -0.3, 0.05];
    macro_rules! check {
        ($($name:literal $method:expr),*) => {
            $(
                let solution = $method.solve(&model.with_law(law(0.0)), 0.0, 10.0, [start, 0.0]).expect($name);
                let modes = &solution.modes()[1..];
                assert_eq!(modes.len(), swings.len() - 1, "{} {modes:?}", $name);
                for (n, (t, _)) in modes.iter().enumerate() {
                    let turns = FRAC_PI_2 * (n + 1) as f64;
                    assert!((t - turns).abs() < 1e-12, "{}: {t} for {turns}", $name);
                    let x = solution.at(turns).expect("inside");
                    assert!((x[0] - swings[n + 1]).abs() < 1e-12, "{}: {x} at {turns}", $name);
                }
                assert_eq!(modes[swings.len() - 2].1.0[0], Status::Stuck, "{}", $name);
                assert!(solution.end()[1] == 0.0, "{}", $name);
            )*
        };
    }
    macro_rules! tight {
        ($method:ident) => {
            $method::new().rtol(1e-13).atol(1e-13)
        };
    }
    check!(
        "Vern9" tight!(Vern9), "Tsit5" tight!(Tsit5), "Rodas5P" tight!(Rodas5P), "Radau5" tight!(Radau5),
        "Auto" tight!(Auto)
    );
    // it may stay there, within static friction
    let rest = resting(&model.with_law(law(0.0)), [0.05, 0.0]).expect("held");
    assert_eq!(rest.x, SVector::from([0.05, 0.0]));
}

#[test]
fn a_law_in_time_breaks_friction_loose() {
    let model = Block::new(BlockParams { mu: 0.5, at_rest: 0.6 }).expect("physical");
    let law = Plain {
        stiffness: 0.0,
        growth: 0.25,
    };
    for (name, solution) in [
        (
            "Vern9",
            Vern9::new().solve(&model.with_law(law.clone()), 0.0, 5.0, [0.0; 2]),
        ),
        (
            "Rodas5P",
            Rodas5P::new().solve(&model.with_law(law.clone()), 0.0, 5.0, [0.0; 2]),
        ),
    ] {
        let solution = solution.expect("regular");
        let (t, mode) = solution.modes()[1];
        assert!(
            (t - 0.6 / 0.25).abs() < 1e-12 && mode.0[0] == Status::Forward,
            "{name}: {t}"
        );
        assert_eq!(solution.at(2.3).expect("inside"), SVector::from([0.0; 2]), "{name}");
    }
}

/// The exponents of the closed loop equal those of the scene with its law.
#[test]
fn exponents_know_the_law() {
    let params = PushedParams {
        mu: 0.3,
        ..PushedParams::default()
    };
    let lyapunov = Lyapunov::new().transient(2.0).duration(8.0);
    let ours = lyapunov.largest(&closed(params), START).expect("regular");
    let theirs = lyapunov.largest(&written(params), START).expect("regular");
    assert!(
        (ours.values[0] - theirs.values[0]).abs() < 1e-6,
        "{} {}",
        ours.values[0],
        theirs.values[0]
    );
}
