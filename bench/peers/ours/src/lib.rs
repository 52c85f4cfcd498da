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

use loops::{After, Beside, Both, Function, Rhs};

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

/// Functions with the signature of the peers.
macro_rules! functions {
    ($($symbol:ident: $run:expr;)*) => { $(
        /// # Safety
        /// `states` points to `count` states, and `out` to room for a result.
        #[unsafe(no_mangle)]
        #[allow(unsafe_code, reason = "called through its address")]
        pub unsafe extern "C" fn $symbol(states: *const f64, out: *mut f64, count: c_long) {
            // SAFETY: guaranteed by the caller.
            $run(unsafe { loops::given(states, out, count) });
        }
    )* };
}

/// The loop in numbers `f64`.
macro_rules! plain {
    ($loop:ident($function:ident($model:ident))) => {
        |given| $loop($function($model::<f64>())).run(&mut PhantomData::<f64>, &given)
    };
}

/// The loop in fused arithmetic. It runs in code for the processor's instructions, as the steps of an integration do.
macro_rules! fused {
    ($loop:ident($function:ident($model:ident))) => {
        |given| {
            let run = $loop($function($model::<Fused<f64>>()));
            <Fused<f64>>::call(run, &mut PhantomData::<Fused<f64>>, &given);
        }
    };
}

/// All loops over a function: plain and fused, and with cheap sines and cosines.
macro_rules! all {
    ($($beside:ident $after:ident $cheap:ident $beside_fused:ident $after_fused:ident: $function:ident($model:ident);)*) => {
        functions! { $(
            $beside: plain!(Beside($function($model)));
            $after: plain!(After($function($model)));
            $cheap: |given| loops::cheap($function($model()), given);
            $beside_fused: fused!(Beside($function($model)));
            $after_fused: fused!(After($function($model)));
        )* }
    };
}

all! {
    eq22_rhs eq22_rhs_in_sequence eq22_rhs_cheap eq22_rhs_fused eq22_rhs_fused_in_sequence: Rhs(pendulum);
    eq22_jacobian eq22_jacobian_in_sequence eq22_jacobian_cheap eq22_jacobian_fused eq22_jacobian_fused_in_sequence: Both(pendulum);
    by_hand_rhs by_hand_rhs_in_sequence by_hand_rhs_cheap by_hand_rhs_fused by_hand_rhs_fused_in_sequence: Rhs(by_hand);
    by_hand_jacobian by_hand_jacobian_in_sequence by_hand_jacobian_cheap by_hand_jacobian_fused by_hand_jacobian_fused_in_sequence: Both(by_hand);
    ur5_rhs ur5_rhs_in_sequence ur5_rhs_cheap ur5_rhs_fused ur5_rhs_fused_in_sequence: Rhs(ur5);
    ur5_jacobian ur5_jacobian_in_sequence ur5_jacobian_cheap ur5_jacobian_fused ur5_jacobian_fused_in_sequence: Both(ur5);
    ur5_point ur5_point_in_sequence ur5_point_cheap ur5_point_fused ur5_point_fused_in_sequence: Place(flange);
    panda_rhs panda_rhs_in_sequence panda_rhs_cheap panda_rhs_fused panda_rhs_fused_in_sequence: Rhs(panda);
    panda_jacobian panda_jacobian_in_sequence panda_jacobian_cheap panda_jacobian_fused panda_jacobian_fused_in_sequence: Both(panda);
    xarm7_rhs xarm7_rhs_in_sequence xarm7_rhs_cheap xarm7_rhs_fused xarm7_rhs_fused_in_sequence: Rhs(xarm7);
    xarm7_jacobian xarm7_jacobian_in_sequence xarm7_jacobian_cheap xarm7_jacobian_fused xarm7_jacobian_fused_in_sequence: Both(xarm7);
    solo_rhs solo_rhs_in_sequence solo_rhs_cheap solo_rhs_fused solo_rhs_fused_in_sequence: Rhs(solo);
}
