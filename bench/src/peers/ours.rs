//! The generated code, and hand-written code.

use std::error::Error;
use std::hint::black_box;

use nalgebra::{SMatrix, SVector};
use pendulum_core::prelude::*;
use pendulum_core::real::Real;
use pendulum_core::{Cost, FunctionCost};
use serde::Deserialize;

use super::candidate::{Candidate, Function, OURS};
use crate::cheap::Cheap;
use crate::library::Program;
use testbed::eq22::{Eq22, Plate};
use testbed::robots::{Panda, PandaParams, Ur5, Ur5Flange, Ur5FlangeParams, Ur5Params};
use testbed::scenes::{DoublePendulum, DoublePendulumParams};

/// Parameters of the double pendulum. They are not the round numbers of the paper, since products with 1 would vanish
/// from the code of those peers that insert numbers for parameters.
pub(crate) const PENDULUM: &str = include_str!("../../peers/double_pendulum.json");

mechanism! {
    /// Solo 12 with its trunk in the air.
    pub(super) Solo {
        robot: urdf("../testbed/data/urdf/solo12.urdf"),
        gravity: [0, 0, -9.81],
        body base_link on ground { joint: free, orientation: o, position: p }
        generate: [rhs],
    }
}

#[derive(Deserialize)]
struct Pendulum {
    m: f64,
    inertia: f64,
    c: f64,
    d: f64,
    g: f64,
    gamma1: f64,
    gamma2: f64,
}

pub(crate) fn candidates() -> Result<Vec<Candidate>, Box<dyn Error>> {
    let mut all = Vec::new();
    let Pendulum {
        m,
        inertia,
        c,
        d,
        g,
        gamma1,
        gamma2,
    } = serde_json::from_str(PENDULUM)?;
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
    let pendulum = DoublePendulum::new(params)?;
    add::<_, _, 4>(
        &mut all,
        "eq22",
        OURS,
        pendulum,
        pendulum.cast::<Cheap>(),
        Some(DoublePendulum::COST),
    );
    let plate = |friction| Plate {
        mass: m,
        inertia,
        c,
        friction,
    };
    let (upper, lower) = black_box((plate(gamma1), plate(gamma2)));
    let hands = (
        Eq22::<f64>::new(upper, lower, d, g),
        Eq22::<Cheap>::new(upper, lower, d, g),
    );
    add::<_, _, 4>(&mut all, "eq22", "by hand", hands.0, hands.1, None);
    let ur5 = Ur5::new(Ur5Params::default())?;
    add::<_, _, 12>(&mut all, "ur5", OURS, ur5, ur5.cast::<Cheap>(), Some(Ur5::COST));
    all.push(flange()?);
    let panda = Panda::new(PandaParams::default())?;
    add::<_, _, 14>(&mut all, "panda", OURS, panda, panda.cast::<Cheap>(), Some(Panda::COST));
    let solo = Solo::new(SoloParams {})?;
    add_rhs::<_, _, 37>(&mut all, "solo", OURS, solo, solo.cast::<Cheap>(), Some(Solo::COST));
    Ok(all)
}

/// Adds the right-hand side.
fn add_rhs<S, C, const N: usize>(
    all: &mut Vec<Candidate>,
    model: &str,
    peer: &str,
    system: S,
    cheap: C,
    cost: Option<Cost>,
) where
    S: System<f64, N> + Clone + 'static,
    C: System<Cheap, N> + Clone + 'static,
{
    let cost = cost.map(|cost| cost["rhs"]);
    all.push(Candidate {
        model: model.to_owned(),
        function: Function::Rhs,
        peer: peer.to_owned(),
        form: format!("rhs{}", form(cost)),
        operations: cost.map(|cost| cost.operations),
        program: program(move |x| system.rhs(0.0, x), |xdot| accelerations(&xdot)),
        cheap: Some(program(move |x| cheap.rhs(Cheap(0.0), x), |_| Vec::new())),
        job: None,
    });
}

fn form(cost: Option<FunctionCost>) -> String {
    cost.map_or(String::new(), |cost| format!(": {}", cost.form))
}

/// Adds the right-hand side, alone and with the Jacobian.
fn add<S, C, const N: usize>(all: &mut Vec<Candidate>, model: &str, peer: &str, system: S, cheap: C, cost: Option<Cost>)
where
    S: Jacobian<f64, N> + Clone + 'static,
    C: Jacobian<Cheap, N> + Clone + 'static,
{
    add_rhs(all, model, peer, system.clone(), cheap.clone(), cost);
    let cost = cost.map(|cost| cost["jacobian"]);
    all.push(Candidate {
        model: model.to_owned(),
        function: Function::Jacobian,
        peer: peer.to_owned(),
        form: format!("rhs_and_jacobian{}", form(cost)),
        operations: cost.map(|cost| cost.operations),
        program: program(
            move |x| system.rhs_and_jacobian(0.0, x),
            |(xdot, jacobian)| [accelerations(&xdot), blocks(&jacobian)].concat(),
        ),
        cheap: Some(program(move |x| cheap.rhs_and_jacobian(Cheap(0.0), x), |_| Vec::new())),
        job: None,
    });
}

/// Position of the flange, and its Jacobian.
fn flange() -> Result<Candidate, Box<dyn Error>> {
    let arm = Ur5Flange::new(Ur5FlangeParams::default())?;
    let cheap = arm.cast::<Cheap>();
    let name = "flange_and_jacobian";
    let cost = Ur5Flange::COST[name];
    Ok(Candidate {
        model: "ur5".to_owned(),
        function: Function::Point,
        peer: OURS.to_owned(),
        form: format!("{name}: {}", cost.form),
        operations: Some(cost.operations),
        program: program(
            move |x| by_coordinates(arm.flange_and_jacobian(0.0, x)),
            |(place, jacobian)| [place.as_slice(), jacobian.as_slice()].concat(),
        ),
        cheap: Some(program(
            move |x| by_coordinates(cheap.flange_and_jacobian(Cheap(0.0), x)),
            |_| Vec::new(),
        )),
        job: None,
    })
}

/// Drops the derivatives by the rates: they are zero, and no peer computes them.
fn by_coordinates<T: Real>((place, jacobian): (SVector<T, 3>, SMatrix<T, 3, 12>)) -> (SVector<T, 3>, SMatrix<T, 3, 6>) {
    (place, jacobian.fixed_columns::<6>(0).into_owned())
}

fn program<T, R, const N: usize>(
    function: impl Fn(&SVector<T, N>) -> R + Clone + 'static,
    flat: impl Fn(R) -> Vec<f64> + 'static,
) -> Program
where
    T: Real,
{
    let timed = function.clone();
    Program {
        run: Box::new(move |states| {
            for x in states.chunks_exact(N) {
                black_box(timed(&SVector::from_fn(|n, _| T::from_f64(x[n]))));
            }
        }),
        value: Box::new(move |x| flat(function(&SVector::from_fn(|n, _| T::from_f64(x[n]))))),
    }
}

fn accelerations<const N: usize>(xdot: &SVector<f64, N>) -> Vec<f64> {
    // there may be one position more than rates
    xdot.as_slice()[N.div_ceil(2)..].to_vec()
}

/// Lower half, column by column: derivatives of the accelerations by coordinates and rates.
fn blocks<const N: usize>(jacobian: &SMatrix<f64, N, N>) -> Vec<f64> {
    jacobian.rows(N / 2, N / 2).iter().copied().collect()
}
