//! Products of weights with derivatives of the right-hand side, against its Jacobians, and gradients of trajectories,
//! against derivatives forward in time.

use nalgebra::SVector;
use pendulum_core::dual::Dual;
use pendulum_core::method::DiscreteAdjoint;
use pendulum_core::prelude::*;
use pendulum_core::sensitivity::{self, Cost, Variable};
use pendulum_core::{Adjoint, ControlledAdjoint, InputLaw, Parametric, Real, Reason};

use crate::states::{
    Linkage, LinkageParams, Lorenz, LorenzParams, Mixed, MixedParams, Motor, MotorInputs, MotorParams, Servo,
    ServoParams,
};

/// Largest difference relative to the largest number, below which two results agree.
const TOLERANCE: f64 = 1e-13;

#[track_caller]
fn agree<const N: usize>(what: &str, ours: &SVector<f64, N>, theirs: &SVector<f64, N>) {
    let scale = theirs.amax().max(1.0);
    assert!(
        (ours - theirs).amax() < TOLERANCE * scale,
        "{what}: {ours} and not {theirs}"
    );
}

/// Weights and a direction without symmetry.
fn numbers<const N: usize>(first: f64) -> SVector<f64, N> {
    SVector::from_fn(|n, _| (first + 1.7 * n as f64).sin() + 0.3)
}

/// Checks the routines of a scene without inputs. Dual numbers give the derivative of `J^T w` along a direction.
macro_rules! check {
    ($model:expr, $dual:expr, $t:expr, $x:expr) => {{
        let (model, x) = ($model, SVector::from($x));
        let (weights, direction) = (numbers(0.4), numbers(2.1));
        let (by_state, by_parameters) = model.adjoint($t, &x, &weights);
        agree("by state", &by_state, &(model.jacobian($t, &x).transpose() * weights));
        let jacobian = model.parameter_jacobian($t, &x);
        agree("by parameters", &by_parameters, &(jacobian.transpose() * weights));
        let moved = x.zip_map(&direction, |x, d| Dual { value: x, slopes: [d] });
        let jacobian = $dual.jacobian(Dual::from_f64($t), &moved).map(|entry| entry.slopes[0]);
        let product = model.hessian_product($t, &x, &weights, &direction);
        agree("second derivative", &product, &(jacobian.transpose() * weights));
    }};
}

#[test]
fn equations_without_bodies() {
    let model = Lorenz::new(LorenzParams::default()).expect("valid");
    check!(model, model.cast::<Dual<f64, 1>>(), 0.0, [1.5, -2.0, 20.0]);
}

#[test]
fn a_closed_loop() {
    let model = Linkage::new(LinkageParams::default()).expect("physical");
    check!(model, model.cast::<Dual<f64, 1>>(), 0.0, [0.7, 2.0, 1.5]);
}

#[test]
fn a_ball_joint_on_a_driven_pivot() {
    let model = Mixed::new(MixedParams::default()).expect("physical");
    let x = [0.8, 0.4, 0.4, 0.2, 0.5, -0.7, 1.1, 2.5];
    check!(model, model.cast::<Dual<f64, 1>>(), 0.7, x);
}

#[test]
fn dry_friction_that_slips() {
    let model = Servo::new(ServoParams::default()).expect("physical");
    check!(model, model.cast::<Dual<f64, 1>>(), 0.0, [0.3, 2.0, 1.5, 0.1]);
}

#[test]
fn inputs() {
    let model = Motor::new(MotorParams::default()).expect("physical");
    let (x, u) = (SVector::from([0.3, -1.2, 2.0, 0.1]), MotorInputs { u: 6.0 });
    let weights = numbers(0.4);
    let (by_state, by_parameters, by_input) = model.adjoint(0.0, &x, &u, &weights);
    let (_, jacobian) = model.eval_with_jacobian(0.0, &x, &u);
    agree("by state", &by_state, &(jacobian.transpose() * weights));
    let jacobian = model.parameter_jacobian(0.0, &x, &u);
    agree("by parameters", &by_parameters, &(jacobian.transpose() * weights));
    let jacobian = model.input_jacobian(0.0, &x, &u);
    agree("by input", &by_input, &(jacobian.transpose() * weights));
    let (by_state, by_input) = model.hessian_product(0.0, &x, &u, &weights, &numbers(2.1));
    assert_eq!(by_input, SVector::from([0.0]));
    let direction = numbers::<5>(2.1);
    let moved = SVector::<Dual<f64, 1>, 4>::from_fn(|n, _| Dual {
        value: x[n],
        slopes: [direction[n]],
    });
    let u = MotorInputs {
        u: Dual {
            value: 6.0,
            slopes: [direction[4]],
        },
    };
    let (_, jacobian) = model
        .cast::<Dual<f64, 1>>()
        .eval_with_jacobian(Dual::from_f64(0.0), &moved, &u);
    let jacobian = jacobian.map(|entry| entry.slopes[0]);
    agree("second derivative", &by_state, &(jacobian.transpose() * weights));
}

mechanism! {
    Bare {
        gravity: [0, -9.81, 0],
        body bob on ground { solids: [point(1, [0, -1, 0])], joint: revolute(z), coordinate: theta }
        generate: [rhs, jacobian, adjoint],
    }
}

mechanism! {
    BareCart {
        input push: N,
        body cart on ground { mass: 2, joint: prismatic(x), coordinate: place, torque: push - place*1 N/m }
        generate: [rhs, jacobian, adjoint],
    }
}

#[test]
fn without_parameters() {
    let none = SVector::<f64, 0>::zeros();
    let model = Bare::new(BareParams::default()).expect("physical");
    let (x, weights) = (SVector::from([0.4, 0.3]), numbers(0.4));
    let by_state = model.jacobian(0.0, &x).transpose() * weights;
    assert_eq!(Adjoint::adjoint(&model, 0.0, &x, &weights), (by_state, none));
    let model = BareCart::new(BareCartParams::default()).expect("physical");
    let inputs = BareCartInputs { push: 3.0 };
    let by_state = SVector::from([-0.5 * weights[1], weights[0]]);
    let by_input = SVector::from([0.5 * weights[1]]);
    assert_eq!(
        model.controlled_adjoint(0.0, &x, &inputs, &weights),
        (by_state, none, by_input)
    );
}

/// A sum of all components at the end, with weights, and of squares along the way.
struct Mixture;

impl<const N: usize> Cost<N> for Mixture {
    fn end<T: Real>(&self, t: T, x: &SVector<T, N>) -> T {
        let weights = numbers::<N>(0.7).map(T::from_f64);
        x.zip_fold(&weights, t * x[0], |sum, x, weight| sum + weight * x.sin_cos().0)
    }

    fn running<T: Real>(&self, t: T, x: &SVector<T, N>) -> Option<T> {
        Some(x.iter().fold(t, |sum, &x| sum + x * x))
    }
}

/// [`Mixture`] without its running cost, which forward derivatives do not integrate.
struct AtEnd;

impl<const N: usize> Cost<N> for AtEnd {
    fn end<T: Real>(&self, t: T, x: &SVector<T, N>) -> T {
        Mixture.end(t, x)
    }
}

/// Compares the gradient of a cost at the end with derivatives forward in time, which takes all variables one by one.
#[track_caller]
fn gradients_agree<X, M, const N: usize, const P: usize>(method: &X, model: &M, t1: f64, x0: [f64; N], tolerance: f64)
where
    M: Parametric<N, P> + Adjoint<f64, N, P>,
    X: Method<M, f64, N> + Method<M::In<Dual<f64, 1>>, Dual<f64, 1>, N> + DiscreteAdjoint,
{
    let gradient = sensitivity::gradient(method, model, 0.0, t1, x0, &AtEnd).expect("regular");
    let starts = (0..N).map(|n| (Variable::Start(n), gradient.by_start[n]));
    let parameters = (0..P).map(|p| (Variable::Parameter(p), gradient.by_parameters[p]));
    let scale = gradient.by_start.amax().max(gradient.by_parameters.amax());
    for (variable, ours) in starts.chain(parameters) {
        let motion = sensitivity::solve(method, model, 0.0, t1, x0, [variable]).expect("regular");
        let cost = AtEnd.end(Dual::constant(t1), &motion.solution().end());
        assert_eq!(gradient.value, cost.value, "{variable:?}");
        let error = (ours - cost.slopes[0]).abs();
        assert!(
            error < tolerance * scale,
            "{variable:?}: {ours} and not {}",
            cost.slopes[0]
        );
    }
}

#[test]
fn gradients_are_the_derivatives_forward_in_time() {
    let lorenz = Lorenz::new(LorenzParams::default()).expect("valid");
    let x0 = [1.5, -2.0, 20.0];
    gradients_agree(&Rk4::new(0.01), &lorenz, 2.0, x0, 1e-12);
    gradients_agree(&Rk45::new(), &lorenz, 2.0, x0, 1e-12);
    gradients_agree(&Tsit5::new(), &lorenz, 2.0, x0, 1e-12);
    gradients_agree(&Vern7::new(), &lorenz, 2.0, x0, 1e-12);
    gradients_agree(&Vern9::new(), &lorenz, 2.0, x0, 1e-12);
    let linkage = Linkage::new(LinkageParams::default()).expect("physical");
    gradients_agree(&Vern9::new(), &linkage, 1.0, [0.7, 0.0, 0.0], 1e-12);
    let mixed = Mixed::new(MixedParams::default()).expect("physical");
    let x0 = [0.8, 0.4, 0.4, 0.2, 0.5, -0.7, 1.1, 2.5];
    gradients_agree(&Vern7::new(), &mixed, 3.0, x0, 1e-12);
    gradients_agree(&Rk4::new(0.02), &mixed, 3.0, x0, 1e-12);
}

/// A voltage against the motion.
#[derive(Clone, PartialEq)]
struct Brake;

impl InputLaw<4, 1> for Brake {
    fn inputs<T: Real>(&self, t: T, x: &SVector<T, 4>) -> [T; 1] {
        [t.sin_cos().1 - T::from_f64(0.3) * x[1] - x[3].sin_cos().0]
    }
}

#[test]
fn gradients_pass_through_the_law_of_the_inputs() {
    let model = Motor::new(MotorParams::default()).expect("physical").with_law(Brake);
    gradients_agree(&Vern9::new(), &model, 3.0, [1.3, -1.2, 2.0, 0.1], 1e-12);
}

mechanism! {
    /// [`Swing`] with the running cost of [`Mixture`] as a first-order state.
    pub Counting {
        params { l: m = 1.2, damping: N m s = 0.2, rest: 1/rad^2 = 1, rush: s^2/rad^2 = 1 }
        gravity: [0, -9.81, 0],
        state work { unit: s, rate: t/(1 s) + rest*theta^2 + rush*dot(theta)^2 }
        body bob on ground {
            solids: [point(1, [0, -l, 0])], joint: revolute(z), coordinate: theta, friction: damping,
        }
        generate: [rhs, jacobian, adjoint],
    }
}

mechanism! {
    pub Swing {
        params { l: m = 1.2, damping: N m s = 0.2 }
        gravity: [0, -9.81, 0],
        body bob on ground {
            solids: [point(1, [0, -l, 0])], joint: revolute(z), coordinate: theta, friction: damping,
        }
        generate: [rhs, jacobian, adjoint],
    }
}

struct Last;

impl Cost<3> for Last {
    fn end<T: Real>(&self, t: T, x: &SVector<T, 3>) -> T {
        x[2] + Mixture.end(t, &SVector::from([x[0], x[1]]))
    }
}

#[test]
fn a_running_cost_is_the_integral_that_a_state_computes() {
    let swing = Swing::new(SwingParams::default()).expect("physical");
    let counting = Counting::new(CountingParams::default()).expect("physical");
    let method = Rk4::new(0.01);
    let ours = sensitivity::gradient(&method, &swing, 0.0, 3.0, [1.0, 0.5], &Mixture).expect("regular");
    let theirs = sensitivity::gradient(&method, &counting, 0.0, 3.0, [1.0, 0.5, 0.0], &Last).expect("regular");
    assert!((ours.value - theirs.value).abs() < 1e-13 * theirs.value);
    agree(
        "by start",
        &ours.by_start,
        &SVector::from([theirs.by_start[0], theirs.by_start[1]]),
    );
    agree(
        "by parameters",
        &ours.by_parameters,
        &SVector::from([theirs.by_parameters[0], theirs.by_parameters[1]]),
    );
}

#[test]
fn gradients_of_dual_numbers_have_second_derivatives() {
    let params = SwingParams::default();
    let gradient = |l: f64, start: f64| {
        let swing = Swing::new(SwingParams { l, ..params }).expect("physical");
        let method = Rk4::new(0.01);
        let gradient = sensitivity::gradient(&method, &swing, 0.0, 3.0, [start, 0.5], &Mixture).expect("regular");
        [
            gradient.by_start[0],
            gradient.by_start[1],
            gradient.by_parameters[0],
            gradient.by_parameters[1],
        ]
    };
    // along a longer pendulum and a larger angle
    let (direction, h) = ([0.3, -0.4], 1e-4);
    let moved = |steps: f64| gradient(params.l + steps * h * direction[0], 1.0 + steps * h * direction[1]);
    let central = |steps: f64| {
        let (after, before) = (moved(steps), moved(-steps));
        SVector::<f64, 4>::from_fn(|n, _| (after[n] - before[n]) / (2.0 * steps * h))
    };
    let differences = (central(1.0) * 4.0 - central(2.0)) / 3.0;
    let swing = Swing::new(params).expect("physical");
    let dual = |value: f64, slope: f64| Dual { value, slopes: [slope] };
    let model = swing.with_parameters([dual(params.l, direction[0]), dual(params.damping, 0.0)]);
    let x0 = [dual(1.0, direction[1]), dual(0.5, 0.0)];
    let [t0, t1] = [0.0, 3.0].map(|t| dual(t, 0.0));
    let second = sensitivity::gradient(&Rk4::new(0.01), &model, t0, t1, x0, &Mixture).expect("regular");
    let second = [
        second.by_start[0],
        second.by_start[1],
        second.by_parameters[0],
        second.by_parameters[1],
    ];
    for (ours, theirs) in second.into_iter().zip(differences.iter()) {
        assert!(
            (ours.slopes[0] - theirs).abs() < 1e-9 * theirs.abs().max(1.0),
            "{} and not {theirs}",
            ours.slopes[0]
        );
    }
}

/// A cost without a derivative at the end, and one that is not finite.
struct Distance;
struct Logarithm;

impl Cost<2> for Distance {
    fn end<T: Real>(&self, _t: T, x: &SVector<T, 2>) -> T {
        (x[0] * x[0] + x[1] * x[1] - T::from_f64(1.0)).sqrt()
    }
}

impl Cost<2> for Logarithm {
    fn end<T: Real>(&self, _t: T, x: &SVector<T, 2>) -> T {
        (x[0] - T::from_f64(10.0)).ln()
    }
}

#[test]
fn a_cost_that_is_not_finite_is_an_error() {
    let swing = Swing::new(SwingParams::default()).expect("physical");
    let gradient = sensitivity::gradient(&Rk4::new(0.01), &swing, 0.0, 1.0, [0.5, 0.0], &Logarithm);
    assert_eq!(gradient, Err(Reason::CostNotFinite));
    // without motion
    let gradient = sensitivity::gradient(&Rk4::new(0.01), &swing, 0.0, 0.0, [1.0, 0.0], &Distance);
    assert_eq!(gradient, Err(Reason::CostNotFinite));
}
