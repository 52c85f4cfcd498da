//! Calls of long routines, which scalars enter for the instruction set of the machine.

use pendulum_core::prelude::*;
use testbed::counted::{Counted, calls};
use testbed::mechanisms::{Eq22, Eq22Params};
use testbed::robots::{Ur5, Ur5Params};

const ZERO: Counted = Counted(0.0);

fn ur5() -> Ur5<Counted> {
    Ur5::new(Ur5Params {}).expect("physical").cast()
}

fn start<const N: usize>() -> SVector<Counted, N> {
    SVector::from([Counted(0.3); N])
}

#[test]
fn each_long_function_is_one_call() {
    let (ur5, x) = (ur5(), start());
    assert_eq!(calls(|| ur5.rhs(ZERO, &x)), 1);
    assert_eq!(calls(|| ur5.jacobian(ZERO, &x)), 1);
    assert_eq!(calls(|| ur5.rhs_and_jacobian(ZERO, &x)), 1);
    assert_eq!(calls(|| ur5.bias(ZERO, &x)), 1);
}

#[test]
fn short_functions_are_no_calls() {
    let (pendulum, x) = (Eq22::new(Eq22Params {}).expect("physical").cast::<Counted>(), start());
    assert_eq!(calls(|| pendulum.rhs_and_jacobian(ZERO, &x)), 0);
    assert_eq!(calls(|| pendulum.mass_matrix(ZERO, &x)), 0);
}

/// A method that called another function around the right-hand side would count twice.
#[test]
fn methods_call_once_for_each_evaluation() {
    fn check<M: Method<Ur5<Counted>, Counted, 12>>(method: &M) {
        let ur5 = ur5();
        let mut evaluations = 0;
        let calls = calls(|| {
            let mut stepper = method.stepper(&ur5, ZERO, Counted(0.1), start()).expect("valid");
            stepper.run().expect("smooth");
            evaluations = stepper.statistics().evaluations;
        });
        assert_eq!(calls, evaluations);
    }
    check(&Rk4::new(0.01));
    check(&Vern9::new());
    check(&Rodas5P::new());
    check(&Radau5::new());
}
