//! Power series of equations by hand: beside generated ones, and beside the right-hand side evaluated on series.

use nalgebra::SVector;
use pendulum_core::dual::Dual;
use pendulum_core::prelude::*;
use pendulum_core::system::{Equations, EquationsSystem};
use pendulum_core::taylor::MAX_ORDER;
use pendulum_core::{Real, TaylorSeries};
use testbed::by_hand::three;
use testbed::power_series::{LENGTH, difference, motion};
use testbed::problems::*;
use testbed::random::Random;

/// Series of a motion.
fn series<const N: usize>(
    system: &impl TaylorSeries<f64, N>,
    t: f64,
    x: impl Into<SVector<f64, N>>,
    length: usize,
) -> Vec<SVector<f64, N>> {
    let mut series = vec![x.into(); length];
    system.series(t, &mut series, &mut system.workspace());
    series
}

#[test]
fn as_generated() {
    fn compare<const N: usize>(
        name: &str,
        declared: &impl TaylorSeries<f64, N>,
        by_hand: &impl TaylorSeries<f64, N>,
        x: [f64; N],
    ) {
        let [declared, by_hand] = [
            series(declared, 0.0, x, MAX_ORDER + 1),
            series(by_hand, 0.0, x, MAX_ORDER + 1),
        ];
        let difference = difference(&by_hand, &declared);
        assert!(difference < 1e-14, "{name}: {difference:e}");
    }
    let (henon_heiles, arenstorf, pleiades) = three();
    let declared = HenonHeiles::new(HenonHeilesParams {}).expect("valid");
    compare("Henon and Heiles", &declared, &henon_heiles, [0.3, 0.1, 0.2, 0.4]);
    let declared = Arenstorf::new(ArenstorfParams::default()).expect("valid");
    compare("Arenstorf", &declared, &arenstorf, [0.5, 0.3, 0.1, -1.2]);
    let declared = Pleiades::new(PleiadesParams {}).expect("valid");
    compare("Pleiades", &declared, &pleiades, PLEIADES);
}

/// A function of a state that grows, and of time.
#[derive(Clone, Copy, PartialEq)]
struct Of(Function);

#[derive(Clone, Copy, Debug, PartialEq)]
enum Function {
    Sums,
    Products,
    Quotients,
    SinCos,
    Tan,
    Exp,
    Ln,
    Sqrt,
    Tanh,
    Abs,
    Signum,
    AtLeast,
    AtMost,
    Atan2,
    Whole,
    Reciprocal,
    Fractional,
    Table,
    Powers,
    /// Has the rate of [`Powers`](Self::Powers).
    Logarithms,
}

const FUNCTIONS: [Function; 18] = [
    Function::Sums,
    Function::Products,
    Function::Quotients,
    Function::SinCos,
    Function::Tan,
    Function::Exp,
    Function::Ln,
    Function::Sqrt,
    Function::Tanh,
    Function::Abs,
    Function::Signum,
    Function::AtLeast,
    Function::AtMost,
    Function::Atan2,
    Function::Whole,
    Function::Reciprocal,
    Function::Fractional,
    Function::Table,
];

impl Equations<2> for Of {
    fn rhs<T: Real>(&self, t: T, x: &SVector<T, 2>) -> SVector<T, 2> {
        let [a, b] = x.data.0[0];
        let [one, two] = [1.0, 2.0].map(T::from_f64);
        // positive, and of size 1
        let size = one + a * a + b.mul_add(b, one / two);
        let rate = match self.0 {
            Function::Sums => (two - a) - (b - two) + (one - -b) + two * t + a / two,
            Function::Products => a.mul_sub(b, t).mul_neg_add(two, a) * (a + b),
            Function::Quotients => a / size + two / size - t / (one + t * t),
            Function::SinCos => {
                let (sin, cos) = (a - b).sin_cos();
                sin + two * cos * cos
            }
            Function::Tan => (a / size).tan(),
            Function::Exp => (-size).exp() * a,
            Function::Ln => size.ln(),
            Function::Sqrt => size.sqrt() - (two * size).sqrt(),
            // the series of the exponential function, from which the other side is, rounds the more the faster this
            // varies
            Function::Tanh => ((a + t) / (two + two)).tanh(),
            Function::Abs => a.abs() - (two * b).abs(),
            Function::Signum => a.signum() * b,
            Function::AtLeast => (a * a).at_least(b) + b.at_least(-two) + two.at_least(a) + one.at_least(two),
            Function::AtMost => (a * a).at_most(b) + b.at_most(-two) + two.at_most(a) + one.at_most(two),
            Function::Atan2 => size.atan2(a) + a.atan2(-size) + two.atan2(b * b + one) + (b * b + one).atan2(one),
            Function::Whole => a.powf(T::from_f64(5.0)) - b.powf(two) + size.powf(T::default()) + a.powf(one),
            Function::Reciprocal => size.powf(T::from_f64(-3.0)),
            Function::Fractional => size.powf(T::from_f64(-1.5)) + size.powf(T::from_f64(0.7)),
            Function::Table => {
                let [level, slope] = a.piecewise(|a| if a < 0.0 { [0.1, -0.5] } else { [0.3, 0.7] });
                level + slope * a * b
            }
            Function::Powers => size.powf(a) + two.powf(b) + size.powf(t),
            Function::Logarithms => {
                let logarithm = size.ln();
                (logarithm * a).exp() + (two.ln() * b).exp() + (logarithm * t).exp()
            }
        };
        SVector::from([rate, a - T::from_f64(0.3) * b])
    }
}

#[test]
fn each_function_as_the_right_hand_side_on_series() {
    let mut random = Random::new(11);
    let same = FUNCTIONS.map(|function| [function, function]);
    for functions in same.into_iter().chain([[Function::Powers, Function::Logarithms]]) {
        let [ours, theirs] = functions.map(|function| EquationsSystem(Of(function)));
        let function = functions[0];
        for _ in 0..5 {
            let t = random.between(-1.0, 1.0);
            let x = SVector::from_fn(|_, _| random.between(-1.0, 1.0));
            let found = series(&ours, t, x, LENGTH);
            let difference = difference(&found, &motion(&theirs, t, x));
            assert!(difference < 1e-14, "{function:?}: {difference:e}");
        }
    }
}

/// `x^3` and `|x|`, which is constant at zero.
#[derive(Clone, PartialEq)]
struct AtZero;

impl Equations<2> for AtZero {
    fn rhs<T: Real>(&self, t: T, x: &SVector<T, 2>) -> SVector<T, 2> {
        let one = T::from_f64(1.0);
        SVector::from([one + x[0].powf(T::from_f64(3.0)), t.abs()])
    }
}

#[test]
fn whole_powers_and_absolute_values_at_zero() {
    let found = series(&EquationsSystem(AtZero), 0.0, [0.0, 0.0], 9);
    for (order, x) in found.iter().enumerate() {
        // x = t + t^4/4 + 3/28 t^7 + ..
        let expected = [(1, 1.0), (4, 0.25), (7, 3.0 / 28.0)];
        let expected = expected
            .into_iter()
            .find(|(of, _)| *of == order)
            .map_or(0.0, |(_, x)| x);
        assert!((x[0] - expected).abs() < 1e-15 && x[1] == 0.0, "order {order}: {x}");
    }
}

/// Errors of steps of a fixed order, against a tight solution.
#[test]
fn an_order_of_convergence() {
    let (henon_heiles, ..) = three();
    let start = SVector::from([0.3, 0.1, 0.2, 0.4]);
    let exact = Taylor::new()
        .rtol(1e-14)
        .atol(1e-14)
        .solve(&henon_heiles, 0.0, 4.0, start);
    let exact = exact.expect("regular").end();
    let error = |order: usize, steps: u32| {
        let (h, mut x) = (4.0 / f64::from(steps), start);
        for _ in 0..steps {
            let terms = series(&henon_heiles, 0.0, x, order + 1);
            x = terms.iter().rev().fold(SVector::zeros(), |sum, x| sum * h + x);
        }
        (x - exact).amax()
    };
    for order in [4, 7, 10] {
        let found = (error(order, 8) / error(order, 16)).log2();
        assert!((found - order as f64).abs() < 0.6, "{found} in place of {order}");
    }
}

#[test]
fn the_method_takes_the_steps_of_the_declared_system() {
    let (_, by_hand, _) = three();
    let declared = Arenstorf::new(ArenstorfParams::default()).expect("valid");
    let (start, period) = ([0.994, 0.0, 0.0, -2.001_585_106_379_082_4], 17.065_216_560_157_964);
    for tolerance in [1e-6, 1e-9, 1e-12] {
        let method = Taylor::new().rtol(tolerance).atol(tolerance);
        let expected = method.solve(&declared, 0.0, period, start).expect("regular");
        let found = method.solve(&by_hand, 0.0, period, start).expect("regular");
        assert_eq!(found.statistics().accepted, expected.statistics().accepted);
        let exact = SVector::from(start);
        let [found, expected] = [&found, &expected].map(|solution| (solution.end() - exact).amax());
        assert!(found < 1.1 * expected + 1e-9, "{found:e}, {expected:e}");
    }
}

/// Derivatives by the start are series of dual numbers.
#[test]
fn derivatives_by_the_start() {
    let (henon_heiles, ..) = three();
    let start = [0.3, 0.1, 0.2, 0.4];
    let method = Taylor::new().rtol(1e-12).atol(1e-12);
    let end = |x: SVector<f64, 4>| method.solve(&henon_heiles, 0.0, 5.0, x).expect("regular").end();
    let along = SVector::from([1.0, -2.0, 0.5, 3.0]);
    let mut start_with_slope = SVector::from(start).map(Dual::<f64, 1>::constant);
    for (x, along) in start_with_slope.iter_mut().zip(&along) {
        x.slopes = [*along];
    }
    let ends = method.solve(
        &henon_heiles,
        Dual::constant(0.0),
        Dual::constant(5.0),
        start_with_slope,
    );
    let ends = ends.expect("regular").end();
    let step = 1e-5;
    let difference =
        (end(SVector::from(start) + along * step) - end(SVector::from(start) - along * step)) / (2.0 * step);
    assert!((ends.map(|x| x.slopes[0]) - difference).amax() < 1e-7 * difference.amax());
}
