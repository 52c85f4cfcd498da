//! Models whose inputs follow a control law: the derivative of the law in each of three ways, and everything that it
//! enables.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use pendulum_core::method::{Fixed, Rosenbrock};
use pendulum_core::prelude::*;
use pendulum_core::real::lanes::Isa;
use pendulum_core::stability::{Lyapunov, Stability, equilibrium};
use pendulum_core::system::Differences;
use pendulum_core::tableau::Steinebach5;
use pendulum_core::{EnsembleError, InputLaw, Real, Reason};

mechanism! {
    /// A rod on a cart in the wind. Its angle is zero in the upright position.
    pub CartPole {
        params { m: kg = 0.2, l: m = 0.8, wind: N = 0 }
        input push: N,
        input twist: N m,
        gravity: [0, -9.81, 0],
        let gust = wind * sin(2 rad/s*t),
        body cart on ground { mass: 1, joint: prismatic(x), coordinate: s, torque: push + gust }
        body rod on cart { solids: [rod(m, [0, 0, 0], [0, l, 0])], joint: revolute(z), coordinate: angle,
            torque: twist }
    }
}

fn cart_pole(wind: f64) -> CartPole {
    let params = CartPoleParams {
        wind,
        ..Default::default()
    };
    CartPole::new(params).expect("physical")
}

/// A state feedback, and a motor that saturates and depends on time.
#[derive(Clone, PartialEq)]
struct Control {
    gains: [f64; 4],
    motor: f64,
}

impl InputLaw<4, 2> for Control {
    fn inputs<T: Real>(&self, t: T, x: &SVector<T, 4>) -> [T; 2] {
        let [a, b, c, d] = self.gains.map(T::from_f64);
        let push = -(a * x[0] + b * x[1] + c * x[2] + d * x[3]);
        let twist = T::from_f64(self.motor) * (x[1] * x[2] + t.sin_cos().0).tanh();
        CartPoleInputs { push, twist }.into()
    }
}

impl Control {
    fn law(&self) -> impl Fn(f64, &SVector<f64, 4>) -> CartPoleInputs {
        |t, x| self.inputs(t, x).into()
    }

    /// Derivative by hand.
    fn derivative(&self) -> impl Fn(f64, &SVector<f64, 4>) -> SMatrix<f64, 2, 4> {
        |t, x| {
            let slope = self.motor / (x[1] * x[2] + t.sin()).cosh().powi(2);
            let [a, b, c, d] = self.gains;
            SMatrix::from([[-a, 0.0], [-b, slope * x[2]], [-c, slope * x[1]], [-d, 0.0]])
        }
    }
}

const WILD: Control = Control {
    gains: [-3.0, -40.0, -5.0, -8.0],
    motor: 2.0,
};

/// Gains that place the eigenvalues of the upright cart-pole at -1, -2, -3 and -4: `[0 0 0 1] C^-1 p(A)` (Ackermann).
fn placed(model: &CartPole) -> Control {
    let (upright, none) = (SVector::zeros(), CartPoleInputs { push: 0.0, twist: 0.0 });
    let a = model.eval_with_jacobian(0.0, &upright, &none).1;
    let b: SVector<f64, 4> = model.input_jacobian(0.0, &upright, &none).column(0).into();
    let reach = SMatrix::<f64, 4, 4>::from_columns(&[b, a * b, a * a * b, a * a * a * b]);
    let last = reach.try_inverse().expect("controllable").row(3).into_owned();
    let eye = SMatrix::<f64, 4, 4>::identity();
    let gains = last * (a + eye) * (a + 2.0 * eye) * (a + 3.0 * eye) * (a + 4.0 * eye);
    Control {
        gains: gains.data.0.map(|[gain]| gain),
        motor: 0.0,
    }
}

#[test]
fn the_three_jacobians_agree() {
    let model = cart_pole(1.5);
    let known = model.with_inputs(WILD.law()).with_derivative(WILD.derivative());
    let exact = model.with_law(WILD);
    let near = model.with_inputs(WILD.law()).by_differences();
    let outside = Differences(model.with_inputs(WILD.law()));
    for (t, x) in [(0.3, [0.4, 0.9, -0.6, 1.1]), (-2.0, [-1.0, 2.5, 0.3, 0.0])] {
        let x = SVector::from(x);
        let (rhs, jacobian) = exact.rhs_and_jacobian(t, &x);
        assert_abs_diff_eq!(rhs, known.rhs(t, &x), epsilon = 1e-13);
        assert_eq!(jacobian, exact.jacobian(t, &x));
        assert_abs_diff_eq!(jacobian, known.jacobian(t, &x), epsilon = 1e-12);
        assert_abs_diff_eq!(jacobian, near.jacobian(t, &x), epsilon = 1e-8);
        assert_abs_diff_eq!(jacobian, outside.jacobian(t, &x), epsilon = 1e-7);
        let by_time = exact.time_derivative(t, &x);
        assert_abs_diff_eq!(by_time, known.time_derivative(t, &x), epsilon = 1e-8);
        assert_abs_diff_eq!(by_time, near.time_derivative(t, &x), epsilon = 1e-8);
        assert_abs_diff_eq!(by_time, outside.time_derivative(t, &x), epsilon = 1e-7);
        assert!(by_time.amax() > 0.1, "{by_time}");
    }
}

/// A mass tied by a stiff spring to a point that follows the sine of time.
mod follower {
    use super::*;

    mechanism! {
        pub Cart {
            input push: N,
            body cart on ground { mass: 1, joint: prismatic(x), coordinate: s, torque: push }
        }
    }

    #[derive(Clone, PartialEq)]
    pub(crate) struct Tie(pub(crate) f64);

    impl InputLaw<2, 1> for Tie {
        fn inputs<T: Real>(&self, t: T, x: &SVector<T, 2>) -> [T; 1] {
            let (rate, (sin, cos)) = (T::from_f64(self.0), t.sin_cos());
            // s = sin(t) at any rate: Prothero and Robinson
            [rate * (sin - x[0]) + rate * (cos - x[1]) - sin]
        }
    }

    pub(crate) fn tied(rate: f64) -> impl Jacobian<f64, 2> {
        Cart::new(CartParams {}).expect("physical").with_law(Tie(rate))
    }
}

#[test]
fn stiff_methods_keep_their_order() {
    let tied = follower::tied(3.0);
    let error = |steps: f64| {
        let method = Fixed::<Rosenbrock<Steinebach5, 8>>::new(1.0 / steps);
        (method.solve(&tied, 0.0, 1.0, [0.0, 1.0]).expect("regular").end()[0] - 1.0_f64.sin()).abs()
    };
    // without the time derivative the order would be 1
    let order = (error(10.0) / error(20.0)).log2();
    assert!(order > 4.7, "{order}");
}

#[test]
fn stiff_closed_loops_take_long_steps() {
    let tied = follower::tied(1e6);
    for solution in [
        Auto::new().solve(&tied, 0.0, 10.0, [0.5, 0.0]).expect("regular"),
        Rodas5P::new().solve(&tied, 0.0, 10.0, [0.5, 0.0]).expect("regular"),
        Radau5::new().solve(&tied, 0.0, 10.0, [0.5, 0.0]).expect("regular"),
    ] {
        let [s, v] = solution.end().data.0[0];
        // the transient from the initial condition decays at 1/s
        let rest = 0.5 * (-10.0_f64).exp();
        assert_abs_diff_eq!(s, 10.0_f64.sin() + rest, epsilon = 1e-5);
        assert_abs_diff_eq!(v, 10.0_f64.cos() - rest, epsilon = 1e-4);
        assert!(solution.statistics().accepted < 300, "{solution:?}");
    }
}

#[test]
fn a_cart_pole_stands_as_its_poles_were_placed() {
    let model = cart_pole(0.0);
    let closed = model.with_law(placed(&model));
    let upright = equilibrium(&closed, [0.1, 0.2, 0.0, 0.0]).expect("controlled");
    assert_eq!(upright.stability(), Stability::AsymptoticallyStable);
    assert_abs_diff_eq!(upright.x, SVector::zeros(), epsilon = 1e-12);
    for (eigenvalue, expected) in upright.spectrum.eigenvalues().zip([-1.0, -2.0, -3.0, -4.0]) {
        assert_abs_diff_eq!(eigenvalue.re, expected, epsilon = 1e-10);
        assert_eq!(eigenvalue.im, 0.0);
    }
    // small motions decay at the slowest of these rates
    let lyapunov = Lyapunov::new().transient(5.0).duration(20.0);
    let largest = lyapunov.largest(&closed, [0.01, 0.0, 0.0, 0.0]).expect("regular");
    assert_abs_diff_eq!(largest.values[0], -1.0, epsilon = 1e-3);
    let end = Auto::new()
        .solve(&closed, 0.0, 30.0, [0.0, 0.3, 0.0, 0.0])
        .expect("regular")
        .end();
    assert!(end.norm() < 1e-6, "{end}");
}

#[test]
fn ensembles_of_closed_loops_are_scalar_solves_bit_for_bit() {
    let lengths = [0.5, 0.8, 1.1, 1.4, 1.7];
    let law = placed(&cart_pole(0.0));
    let law = Control { motor: 0.3, ..law };
    let models = lengths.map(|l| {
        cart_pole(0.4).with_params(CartPoleParams {
            l,
            wind: 0.4,
            ..Default::default()
        })
    });
    let closed = models.map(|model| model.expect("physical").with_law(law.clone()));
    let starts: Vec<SVector<f64, 4>> = lengths.map(|l| SVector::from([0.1 * l, 0.1, 0.0, -0.2])).into();
    let (adaptive, fixed, stiff) = (Vern7::new().rtol(1e-9), Rk4::new(0.01), Rodas5P::new());
    for isa in Isa::available() {
        let adaptive_ends = adaptive.ensemble_on(isa, &closed, 0.0, 3.0, &starts).expect("regular");
        let fixed_ends = fixed.ensemble_on(isa, &closed, 0.0, 3.0, &starts).expect("regular");
        let stiff_ends = stiff.ensemble_on(isa, &closed, 0.0, 3.0, &starts).expect("regular");
        for (i, model) in closed.iter().enumerate() {
            let alone = adaptive.solve(model, 0.0, 3.0, starts[i]).expect("regular").end();
            assert_eq!(adaptive_ends[i], alone, "{isa:?}");
            let alone = fixed.solve(model, 0.0, 3.0, starts[i]).expect("regular").end();
            assert_eq!(fixed_ends[i], alone, "{isa:?}");
            let alone = stiff.solve(model, 0.0, 3.0, starts[i]).expect("regular").end();
            assert_eq!(stiff_ends[i], alone, "{isa:?}");
        }
    }
    // lanes share the law, so a different one is rejected
    let mut strange = closed.to_vec();
    strange[3] = cart_pole(0.0).with_law(WILD);
    let refused = fixed.ensemble(&strange, 0.0, 3.0, &starts).expect_err("two laws");
    let EnsembleError::InvalidInput(Reason::InvalidInput {
        what: "models",
        value: 3.0,
        ..
    }) = refused
    else {
        panic!("{refused}")
    };
}

#[test]
fn closed_loops_run_in_single_precision() {
    use pendulum_core::Cast;
    let model = cart_pole(0.0);
    let closed = model.with_law(placed(&model));
    let single = closed.cast::<f32>();
    let end = Auto::new()
        .solve(&single, 0.0, 2.0, [0.1, 0.1, 0.0, 0.0])
        .expect("regular")
        .end();
    let expected = Auto::new()
        .solve(&closed, 0.0, 2.0, [0.1, 0.1, 0.0, 0.0])
        .expect("regular")
        .end();
    assert_abs_diff_eq!(end.map(f64::from), expected, epsilon = 1e-3);
}

/// Indices by name, and parameters by index and name.
#[test]
fn components_and_parameters_have_names() {
    let places = [CartPole::S, CartPole::ANGLE, CartPole::DOT_S, CartPole::DOT_ANGLE];
    assert_eq!(places, [0, 1, 2, 3]);
    let mut values = CartPoleParams::default().to_array();
    let length = CartPoleParams::NAMES
        .iter()
        .position(|name| *name == "l")
        .expect("declared");
    values[length] = 1.6;
    let params = CartPoleParams::from_array(values);
    assert_eq!(
        params,
        CartPoleParams {
            l: 1.6,
            ..Default::default()
        }
    );
    let (long, short) = (cart_pole(0.0).with_params(params).expect("physical"), cart_pole(0.0));
    assert_eq!(long, CartPole::new(params).expect("physical"));
    assert_eq!(
        long.cast::<f32>(),
        short.cast::<f32>().with_params(params).expect("physical")
    );
    // constants are recomputed for the new length: a rod of twice the length has four times the inertia
    let energy = |model: &CartPole| model.kinetic(0.0, &SVector::from([0.0, 0.0, 0.0, 1.0]));
    assert_relative_eq!(energy(&long), 4.0 * energy(&short), max_relative = 1e-14);
    assert!(short.with_params(CartPoleParams { l: f64::NAN, ..params }).is_err());
}

#[test]
fn solutions_are_tables_that_read_back() {
    let solution = Vern7::new()
        .solve(&cart_pole(0.3).with_law(WILD), 0.0, 1.0, [0.1, 1e-7, 0.0, 0.0])
        .expect("regular");
    let mut table = Vec::new();
    solution.write_csv(&mut table, &CartPole::LAYOUT).expect("memory");
    let table = String::from_utf8(table).expect("text");
    let mut lines = table.lines();
    assert_eq!(lines.next(), Some("t,s,angle,dot(s),dot(angle)"));
    let read: Vec<Vec<f64>> = lines
        .map(|line| line.split(',').map(|n| n.parse().expect("a number")).collect())
        .collect();
    assert_eq!(read.len(), solution.t().len());
    for (row, (t, x)) in read.iter().zip(solution.points()) {
        assert_eq!(row[..], [t, x[0], x[1], x[2], x[3]]);
    }
    let mut table = Vec::new();
    solution
        .write_csv_at(&mut table, &CartPole::LAYOUT, [0.25, 0.5])
        .expect("memory");
    let expected = solution.at(0.5).expect("inside")[CartPole::ANGLE];
    let last = String::from_utf8(table)
        .expect("text")
        .lines()
        .last()
        .map(|line| line.split(',').nth(2) == Some(&format!("{expected:?}")));
    assert_eq!(last, Some(true));
    let outside = solution
        .write_csv_at(Vec::new(), &CartPole::LAYOUT, [1.5])
        .expect_err("outside");
    assert_eq!(outside.kind(), std::io::ErrorKind::InvalidInput);
    let wrong = solution
        .write_csv(Vec::new(), &follower::Cart::LAYOUT)
        .expect_err("another model");
    assert_eq!(wrong.to_string(), "the state has 2 components, s and dot(s), not 4");
}

/// Generated code uses full paths only, so that a scene may have almost any name.
#[allow(dead_code, non_camel_case_types)]
mod any_name {
    macro_rules! scenes {
        ($($scene:ident)*) => {
            $(pendulum_core::mechanism! {
                pub $scene {
                    params { m: kg = 1 }
                    input u: N,
                    body bead on ground { mass: m, joint: prismatic(x), coordinate: x, torque: u + 1 N*sin(1 rad/s*t) }
                }
            })*
        };
    }

    scenes! { Model Event Option Result String Some Ok Fn Clone Default From Into core std F L V }

    #[test]
    fn scenes_may_have_nearly_any_name() {
        let model = Model::new(ModelParams::default()).expect("physical");
        assert_eq!(model.params().m, 1.0);
    }
}
