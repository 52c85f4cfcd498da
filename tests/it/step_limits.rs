//! What steps take at most: counted operations against those that the methods promise, and stack.

use std::cell::Cell;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use pendulum_core::prelude::*;
use pendulum_core::real::lanes::Lanes;
use pendulum_core::{Float, Operations, Real};
use testbed::mechanisms::Tree;
use testbed::robots::{Ur5, Ur5Params};
use testbed::scenes::{DoublePendulum, DoublePendulumParams};

/// A number that counts what is done with it.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
struct Counted(f64);

thread_local! {
    static COUNT: Cell<Operations> = const { Cell::new(Operations::ZERO) };
}

const ADDITION: Operations = Operations::new(1, 0, 0, 0, 0, 0);
const MULTIPLICATION: Operations = Operations::new(0, 1, 0, 0, 0, 0);
const DIVISION: Operations = Operations::new(0, 0, 1, 0, 0, 0);
const SINCOS: Operations = Operations::new(0, 0, 0, 1, 0, 0);
const FUNCTION: Operations = Operations::new(0, 0, 0, 0, 1, 0);

fn count(operation: Operations, value: f64) -> Counted {
    COUNT.set(COUNT.get().and(operation));
    Counted(value)
}

macro_rules! operators {
    ($($trait:ident $method:ident $assign:ident $assigned:ident $symbol:tt $operation:ident;)*) => { $(
        impl $trait for Counted {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                count($operation, self.0 $symbol other.0)
            }
        }

        impl $assign for Counted {
            fn $assigned(&mut self, other: Self) {
                *self = *self $symbol other;
            }
        }
    )* };
}

operators! {
    Add add AddAssign add_assign + ADDITION;
    Sub sub SubAssign sub_assign - ADDITION;
    Mul mul MulAssign mul_assign * MULTIPLICATION;
    Div div DivAssign div_assign / DIVISION;
}

impl Neg for Counted {
    type Output = Self;

    fn neg(self) -> Self {
        count(ADDITION, -self.0)
    }
}

macro_rules! functions {
    ($($name:ident($($other:ident)?);)*) => { $(
        fn $name(self $(, $other: Self)?) -> Self {
            count(FUNCTION, Real::$name(self.0 $(, $other.0)?))
        }
    )* };
}

impl Real for Counted {
    fn from_f64(v: f64) -> Self {
        Self(v)
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = Real::sin_cos(self.0);
        (count(SINCOS, sin), Self(cos))
    }

    functions! { tan(); exp(); ln(); sqrt(); tanh(); abs(); signum(); atan2(x); powf(exponent); }
}

impl Lanes for Counted {
    type Scalar = Self;
    type Double = Self;

    fn splat(v: Self) -> Self {
        v
    }

    fn from_fn(mut f: impl FnMut(usize) -> Self) -> Self {
        f(0)
    }

    fn lane(&self, _: usize) -> Self {
        *self
    }

    fn all_finite(self) -> bool {
        self.0.is_finite()
    }

    fn select(self, negative: Self, otherwise: Self) -> Self {
        Self(Lanes::select(self.0, negative.0, otherwise.0))
    }
}

impl Float for Counted {
    const EPSILON: Self = Self(f64::EPSILON);
    const MIN_POSITIVE: Self = Self(f64::MIN_POSITIVE);

    fn to_f64(self) -> f64 {
        self.0
    }

    fn is_finite(self) -> bool {
        self.0.is_finite()
    }

    fn max(self, other: Self) -> Self {
        Self(self.0.max(other.0))
    }

    fn min(self, other: Self) -> Self {
        Self(self.0.min(other.0))
    }
}

/// The operations of the third step.
fn counted<M, S, const N: usize>(method: &M, model: &S) -> Operations
where
    M: Method<S, Counted, N>,
    S: System<Counted, N>,
{
    let mut stepper = method
        .stepper(model, Counted(0.0), Counted(10.0), [Counted(0.3); N])
        .expect("valid");
    stepper.step().and_then(|_| stepper.step()).expect("regular");
    let (before, tried) = (COUNT.get(), stepper.statistics().rejected);
    stepper.step().expect("regular").expect("a step");
    assert_eq!(stepper.statistics().rejected, tried, "one try");
    let after = COUNT.get();
    Operations::new(
        after.additions - before.additions,
        after.multiplications - before.multiplications,
        after.divisions - before.divisions,
        after.sincos - before.sincos,
        after.functions - before.functions,
        0,
    )
}

/// No more than is promised, and not much less: what is chosen in double precision is not counted.
fn assert_most(counted: Operations, most: Operations, what: &str) {
    let row = |o: Operations| [o.additions, o.multiplications, o.divisions, o.sincos, o.functions];
    for (counted, most) in std::iter::zip(row(counted), row(most)) {
        assert!(counted <= most && most <= counted + 40, "{what}: {counted} of {most}");
    }
}

#[test]
fn a_small_stack_is_enough() {
    fn run<M: Method<DoublePendulum, f64, 4>>(method: &M) {
        let model = DoublePendulum::new(DoublePendulumParams::default()).expect("physical");
        let mut stepper = method.stepper(&model, 0.0, 0.1, [0.3; 4]).expect("valid");
        stepper.run().expect("regular");
        std::hint::black_box(stepper.dense().at(0.09));
    }
    macro_rules! each {
        ($kib:literal: $($method:expr),*) => { $(
            // An overflow ends the whole program.
            let thread = std::thread::Builder::new().stack_size($kib << 10).spawn(|| run(&$method));
            thread.expect("a thread").join().expect(stringify!($method));
        )* };
    }
    each!(64: Rk4::new(0.01), Rk45::new(), Vern9::new(), Rodas5P::new(), Auto::new(), Gauss4::new(0.01));
    each!(256: Taylor::new());
}

#[test]
fn a_step_takes_no_more_than_its_method_says() {
    fn check<S: System<Counted, N>, const N: usize>(model: &S, rhs: Operations) {
        macro_rules! each {
            ($($method:ident: $value:expr;)*) => { $(
                assert_most(counted(&$value, model), $method::operations(rhs, N), stringify!($method));
            )* };
        }
        each! {
            Rk4: Rk4::new(0.01);
            Rk45: Rk45::new();
            Tsit5: Tsit5::new();
            Vern7: Vern7::new();
            Vern9: Vern9::new();
        }
    }
    let model = DoublePendulum::new(DoublePendulumParams::default()).expect("physical");
    check(&model.cast::<Counted>(), DoublePendulum::COST["rhs"].operations);
    let model = Tree::new(Default::default()).expect("physical");
    check(&model.cast::<Counted>(), Tree::COST["rhs"].operations);
    let model = Ur5::new(Ur5Params {}).expect("physical");
    check(&model.cast::<Counted>(), Ur5::COST["rhs"].operations);
}
