//! The generated code and hand-written code in loops over states with the same signature as those of the peers.
//!
//! The measurement compiles this package twice: for the processor of the machine, and as a plain `cargo build
//! --release` does.

pub mod cheap;
mod loops;

use std::ffi::c_long;
use std::hint::black_box;
use std::sync::LazyLock;

use nalgebra::{SMatrix, SVector};
use pendulum_core::prelude::*;
use pendulum_core::real::Real;
use serde::Deserialize;
use testbed::eq22::{Eq22, Plate};
use testbed::robots::{Panda, PandaParams, Ur5, Ur5Flange, Ur5FlangeParams, Ur5Params};
use testbed::scenes::{DoublePendulum, DoublePendulumParams};

use cheap::Cheap;

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

/// Flange of the UR5.
struct Flange<T>(Ur5Flange<T>);

fn flange<T: Real>() -> Flange<T> {
    Flange(
        Ur5Flange::new(Ur5FlangeParams::default())
            .expect("good parameters")
            .cast(),
    )
}

impl<T: Real> Flange<T> {
    /// Drops the derivatives by the rates: they are zero, and no peer computes them.
    #[inline]
    fn by_coordinates(&self, t: T, x: &SVector<T, 12>) -> (SVector<T, 3>, SMatrix<T, 3, 6>) {
        let (place, jacobian) = self.0.flange_and_jacobian(t, x);
        (place, jacobian.fixed_columns::<6>(0).into_owned())
    }
}

macro_rules! functions {
    ($($beside:ident $after:ident $cheap:ident: $model:ident, $function:ident;)*) => { $(
        /// States that do not depend on each other.
        ///
        /// # Safety
        /// `states` points to `count` states, and `out` to room for a result.
        #[unsafe(no_mangle)]
        #[allow(unsafe_code, reason = "called through its address")]
        pub unsafe extern "C" fn $beside(states: *const f64, out: *mut f64, count: c_long) {
            let model = $model::<f64>();
            // SAFETY: guaranteed by the caller.
            unsafe { loops::beside(loops::given(states, count), out, |x| model.$function(0.0, x)) }
        }

        /// Each state depends on the result of the previous one.
        ///
        /// # Safety
        /// `states` points to `count` states, and `out` to room for a result.
        #[unsafe(no_mangle)]
        #[allow(unsafe_code, reason = "called through its address")]
        pub unsafe extern "C" fn $after(states: *const f64, out: *mut f64, count: c_long) {
            let model = $model::<f64>();
            // SAFETY: guaranteed by the caller.
            unsafe { loops::after(loops::given(states, count), out, |x| model.$function(0.0, x)) }
        }

        /// States that do not depend on each other, with cheap sines and cosines, and without an output.
        ///
        /// # Safety
        /// `states` points to `count` states.
        #[unsafe(no_mangle)]
        #[allow(unsafe_code, reason = "called through its address")]
        pub unsafe extern "C" fn $cheap(states: *const f64, _: *mut f64, count: c_long) {
            let model = $model::<Cheap>();
            // SAFETY: guaranteed by the caller.
            let states = unsafe { loops::given(states, count) };
            loops::cheap(states, |x| model.$function(Cheap(0.0), x));
        }
    )* };
}

functions! {
    eq22_rhs eq22_rhs_in_sequence eq22_rhs_cheap: pendulum, rhs;
    eq22_jacobian eq22_jacobian_in_sequence eq22_jacobian_cheap: pendulum, rhs_and_jacobian;
    by_hand_rhs by_hand_rhs_in_sequence by_hand_rhs_cheap: by_hand, rhs;
    by_hand_jacobian by_hand_jacobian_in_sequence by_hand_jacobian_cheap: by_hand, rhs_and_jacobian;
    ur5_rhs ur5_rhs_in_sequence ur5_rhs_cheap: ur5, rhs;
    ur5_jacobian ur5_jacobian_in_sequence ur5_jacobian_cheap: ur5, rhs_and_jacobian;
    ur5_point ur5_point_in_sequence ur5_point_cheap: flange, by_coordinates;
    panda_rhs panda_rhs_in_sequence panda_rhs_cheap: panda, rhs;
    panda_jacobian panda_jacobian_in_sequence panda_jacobian_cheap: panda, rhs_and_jacobian;
    xarm7_rhs xarm7_rhs_in_sequence xarm7_rhs_cheap: xarm7, rhs;
    xarm7_jacobian xarm7_jacobian_in_sequence xarm7_jacobian_cheap: xarm7, rhs_and_jacobian;
    solo_rhs solo_rhs_in_sequence solo_rhs_cheap: solo, rhs;
}
