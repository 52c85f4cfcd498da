//! Numbers that count operations.

use std::cell::Cell;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use pendulum_core::real::lanes::{Isa, Kernel, LaneElement, Lanes, Routine};
use pendulum_core::{Float, Operations, Real};

/// Number that counts the operations applied to it.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Counted(pub f64);

thread_local! {
    static COUNT: Cell<Operations> = const { Cell::new(Operations::ZERO) };
    static CALLS: Cell<usize> = const { Cell::new(0) };
}

const ADDITION: Operations = Operations::new(1, 0, 0, 0, 0, 0);
const MULTIPLICATION: Operations = Operations::new(0, 1, 0, 0, 0, 0);
const DIVISION: Operations = Operations::new(0, 0, 1, 0, 0, 0);
const SINCOS: Operations = Operations::new(0, 0, 0, 1, 0, 0);
const FUNCTION: Operations = Operations::new(0, 0, 0, 0, 1, 0);

/// Adds to the operations counted in this thread.
pub fn charge(operations: Operations) {
    COUNT.set(COUNT.get().and(operations));
}

fn count(operation: Operations, value: f64) -> Counted {
    charge(operation);
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
    fn call<A: ?Sized, B: ?Sized, R: Routine<A, B>>(routine: R, changed: &mut A, read: &B) -> R::Output {
        CALLS.set(CALLS.get() + 1);
        routine.run(changed, read)
    }

    fn from_f64(v: f64) -> Self {
        Self(v)
    }

    fn piecewise<const C: usize>(self, piece: impl Fn(f64) -> [f64; C]) -> [Self; C] {
        self.0.piecewise(piece).map(Self)
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = Real::sin_cos(self.0);
        (count(SINCOS, sin), Self(cos))
    }

    functions! {
        tan(); exp(); ln(); sqrt(); tanh(); abs(); signum(); at_least(low); at_most(high); atan2(x); powf(exponent);
    }
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

impl LaneElement for Counted {
    fn run<K: Kernel<Self>>(_: Isa, kernel: K) -> K::Output {
        kernel.run::<Self>()
    }
}

/// Operations that `f` applies to [`Counted`] numbers.
pub fn spent(f: impl FnOnce()) -> Operations {
    let before = COUNT.get();
    f();
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

/// Number of long routines that `f` calls in [`Counted`] numbers.
pub fn calls<R>(f: impl FnOnce() -> R) -> usize {
    let before = CALLS.get();
    let _ = f();
    CALLS.get() - before
}
