//! Two robots against reference data: scenes with a closed form that is long, or too long to generate.

use std::sync::Arc;

use nalgebra::{SMatrix, SVector};
use pendulum_codegen::program::Program;
use pendulum_core::prelude::*;
use pendulum_core::real::lanes::{F64x4, Lanes};
use pendulum_core::tape::{Model, Tape};
use testbed::robots::*;
use testbed::source::{ROBOTS, declaration};

/// Largest error over largest entry: rounding errors of some thousand operations.
const TOLERANCE: f64 = 1e-11;

testbed::agrees! {
    ur5: Ur5, 6;
    panda: Panda, 7;
}

/// Additions and multiplications of the right-hand side, and of the Jacobian with everything it needs. CasADi's C code
/// for the same models, after its own elimination of common subexpressions, has 890 and 5649 for UR5, 1910 and 9806 for
/// Panda.
#[test]
fn the_code_is_short() {
    let [ur5, panda] = [Ur5::COST, Panda::COST];
    let counts = [ur5["rhs"], ur5["jacobian"], panda["rhs"], panda["jacobian"]].map(|cost| cost.flops());
    let most = [380, 1600, 1150, 4800];
    assert!(
        counts.iter().zip(most).all(|(&count, most)| count <= most),
        "{counts:?}"
    );
}

/// A loop solves the columns of long Jacobians. Scalars run it for more columns than lanes, and tapes have no loops.
#[test]
fn a_long_jacobian_has_the_same_bits_in_lanes_and_on_a_tape() {
    let program = |name| pendulum_codegen::program(declaration(ROBOTS, name).parse().expect("tokens")).expect(name);
    let [ur5, panda] = ["Ur5", "Panda"].map(program);
    let columns = |program: &Program| {
        let block = &program.routine("jacobian").expect("requested").block;
        block.columns.as_ref().map(|columns| columns.given.len())
    };
    // the turn of the first joint changes nothing
    assert_eq!([columns(&ur5), columns(&panda)], [None, Some(13)]);

    let compiled = Panda::new(PandaParams::default()).expect("physical");
    let tape: Arc<Tape> = Arc::new(pendulum_codegen::tape(&panda).parse().expect("a tape"));
    let on_tape: Model<f64, 14> = tape.model(&[]).expect("physical");
    let in_lanes: Panda<F64x4> = compiled.cast();
    let state = |lane: usize| SVector::from_fn(|n, _| ((n + 1) as f64).sin() + lane as f64 / 8.0);
    let states = SVector::from_fn(|n, _| F64x4::from_fn(|lane| state(lane)[n]));
    let (rates, jacobian) = in_lanes.rhs_and_jacobian(F64x4::splat(0.0), &states);
    for lane in 0..4 {
        let own = compiled.rhs_and_jacobian(0.0, &state(lane));
        assert_eq!(own, on_tape.rhs_and_jacobian(0.0, &state(lane)));
        assert_eq!(own, (rates.map(|x| x.lane(lane)), jacobian.map(|x| x.lane(lane))));
    }
}

/// A force in the frame of its body adds few operations as a wrench on the link, and many by `J^T f`.
#[test]
fn a_force_on_the_flange_is_a_wrench() {
    let robot = declaration(ROBOTS, "Ur5");
    let (head, bodies) = robot.split_once("generate: [").expect("a list");
    let (_, bodies) = bodies.split_once("],").expect("its end");
    let force = "params { f: N } point flange on b6 at [0, 0.0823, 0], force on flange: [f, 0, 2*f] in b6,";
    let pushed = format!("{head} generate: [rhs], {force} {bodies}");
    let program = pendulum_codegen::program(pushed.parse().expect("tokens")).expect("a declaration");
    let cost = &program.routine("rhs").expect("a right-hand side").cost;
    assert_eq!(cost.form, "recursion with wrenches on links, L^T D L");
    let operations = cost.operations.additions + cost.operations.multiplications;
    // without the force it takes 378
    assert!(operations <= 405, "{operations}");
}
