//! The generated code and hand-written code in loops over states with the same signature as those of the peers.
//!
//! The measurement compiles this package twice: for the processor of the machine, and as a plain `cargo build
//! --release` does.

pub mod cheap;
mod loops;

use std::ffi::c_long;
use std::hint::black_box;
use std::marker::PhantomData;
use std::sync::LazyLock;

use nalgebra::{SMatrix, SVector};
use pendulum_core::prelude::*;
use pendulum_core::real::lanes::Routine;
use pendulum_core::real::{Fused, Real};
use serde::Deserialize;
use testbed::eq22::{Eq22, Plate};
use testbed::robots::{Panda, PandaParams, Ur5, Ur5Flange, Ur5FlangeParams, Ur5Params};
use testbed::scenes::{DoublePendulum, DoublePendulumParams};

use loops::{After, Beside, Both, Function, Given, Rates, RatesAndJacobian, Rhs};

mechanism! {
    /// Solo 12 with its trunk in the air.
    pub Solo {
        robot: urdf("../../../testbed/data/urdf/solo12.urdf"),
        gravity: [0, 0, -9.81],
        body base_link on ground { joint: free, orientation: o, position: p }
        generate: [rhs],
    }
}

mechanism! {
    /// xArm 7 with the damping of its joints.
    pub Xarm7 {
        robot: urdf("../../../testbed/data/urdf/xarm7.urdf", without dry_friction),
        gravity: [0, 0, -9.81],
        generate: [rhs, jacobian],
    }
}

#[derive(Clone, Copy, Deserialize)]
struct Pendulum {
    m: f64,
    inertia: f64,
    c: f64,
    d: f64,
    g: f64,
    gamma1: f64,
    gamma2: f64,
}

/// Parameters of the double pendulum. They are not the round numbers of the paper, since products with 1 would vanish
/// from the code of those peers that insert numbers for parameters.
static PENDULUM: LazyLock<Pendulum> =
    LazyLock::new(|| serde_json::from_str(include_str!("../../double_pendulum.json")).expect("numbers"));

/// Type parameters stand for `f64` and for numbers with cheap sines and cosines.
fn pendulum<T: Real>() -> DoublePendulum<T> {
    let Pendulum {
        m,
        inertia,
        c,
        d,
        g,
        gamma1,
        gamma2,
    } = *PENDULUM;
    // Hide the parameters from the optimiser, so that they are known only at run time.
    let params = black_box(DoublePendulumParams {
        m,
        inertia,
        c,
        d,
        g,
        gamma1,
        gamma2,
    });
    DoublePendulum::new(params).expect("good parameters").cast()
}

fn by_hand<T: Real>() -> Eq22<T> {
    let p = black_box(*PENDULUM);
    let plate = |friction| Plate {
        mass: p.m,
        inertia: p.inertia,
        c: p.c,
        friction,
    };
    Eq22::new(plate(p.gamma1), plate(p.gamma2), p.d, p.g)
}

fn ur5<T: Real>() -> Ur5<T> {
    Ur5::new(Ur5Params::default()).expect("good parameters").cast()
}

fn panda<T: Real>() -> Panda<T> {
    Panda::new(PandaParams::default()).expect("good parameters").cast()
}

fn xarm7<T: Real>() -> Xarm7<T> {
    Xarm7::new(Xarm7Params::default()).expect("good parameters").cast()
}

fn solo<T: Real>() -> Solo<T> {
    Solo::new(SoloParams {}).expect("good parameters").cast()
}

fn flange<T: Real>() -> Ur5Flange<T> {
    Ur5Flange::new(Ur5FlangeParams::default())
        .expect("good parameters")
        .cast()
}

/// Position of the flange with its Jacobian.
struct Place<M>(M);

impl<T: Real> Function<T, 12> for Place<Ur5Flange<T>> {
    type Outcome = (SVector<T, 3>, SMatrix<T, 3, 6>);

    /// Drops the derivatives by the rates: they are zero, and no peer computes them.
    #[inline(always)]
    fn at(&self, x: &SVector<T, 12>) -> Self::Outcome {
        let (place, jacobian) = self.0.flange_and_jacobian(T::default(), x);
        (place, jacobian.fixed_columns::<6>(0).into_owned())
    }
}

/// A function with the signature of the peers, under a name in two parts.
macro_rules! export {
    ($name:literal $ending:literal: $run:expr) => {
        const _: () = {
            /// # Safety
            /// `states` points to `count` states, and `out` to room for a result.
            #[unsafe(export_name = concat!($name, $ending))]
            #[allow(unsafe_code, reason = "called through its address")]
            unsafe extern "C" fn run(states: *const f64, out: *mut f64, count: c_long) {
                // SAFETY: guaranteed by the caller.
                $run(unsafe { loops::given(states, out, count) });
            }
        };
    };
}

/// All loops over functions: plain and fused, and with cheap sines and cosines.
macro_rules! functions {
    ($($name:literal: $function:ident($model:ident);)*) => { $(
        export! { $name "": |given| plain(Beside($function($model())), given) }
        export! { $name "_in_sequence": |given| plain(After($function($model())), given) }
        export! { $name "_cheap": |given| loops::cheap($function($model()), given) }
        export! { $name "_fused": |given| fused(Beside($function($model())), given) }
        export! { $name "_fused_in_sequence": |given| fused(After($function($model())), given) }
    )* };
}

/// Runs a loop in numbers `f64`.
#[inline(always)]
fn plain<'a, const N: usize>(run: impl Routine<PhantomData<f64>, Given<'a, N>, Output = ()>, given: Given<'a, N>) {
    run.run(&mut PhantomData, &given);
}

/// Runs a loop in fused arithmetic, in code for the processor's instructions, as the steps of an integration do.
fn fused<'a, const N: usize>(
    run: impl Routine<PhantomData<Fused<f64>>, Given<'a, N>, Output = ()>,
    given: Given<'a, N>,
) {
    <Fused<f64>>::call(run, &mut PhantomData, &given);
}

functions! {
    "eq22_rhs": Rhs(pendulum);
    "eq22_jacobian": Both(pendulum);
    "by_hand_rhs": Rhs(by_hand);
    "by_hand_jacobian": Both(by_hand);
    "ur5_rhs": Rhs(ur5);
    "ur5_jacobian": Both(ur5);
    "ur5_point": Place(flange);
    "panda_rhs": Rhs(panda);
    "panda_jacobian": Both(panda);
    "xarm7_rhs": Rhs(xarm7);
    "xarm7_jacobian": Both(xarm7);
    "solo_rhs": Rhs(solo);
}

/// Functions in batches, with the rows and columns of their results.
macro_rules! batches {
    ($($name:literal: $function:ident($model:ident), $rows:literal, $columns:literal;)*) => { $(
        export! { $name "_batch": |given| loops::batch::<_, _, _, $rows, $columns>(&$function, &$model(), given) }
    )* };
}

batches! {
    "eq22_rhs": Rates(pendulum), 2, 1;
    "eq22_jacobian": RatesAndJacobian(pendulum), 2, 5;
    "ur5_rhs": Rates(ur5), 6, 1;
    "ur5_jacobian": RatesAndJacobian(ur5), 6, 13;
    "panda_rhs": Rates(panda), 7, 1;
    "panda_jacobian": RatesAndJacobian(panda), 7, 15;
    "xarm7_rhs": Rates(xarm7), 7, 1;
    "xarm7_jacobian": RatesAndJacobian(xarm7), 7, 15;
    "solo_rhs": Rates(solo), 18, 1;
}
