//! Motion in coordinates and momenta, against the right-hand side and by dual numbers.

use nalgebra::{SMatrix, SVector};
use pendulum_core::prelude::*;
use testbed::dual::Dual;
use testbed::mechanisms::*;
use testbed::reference::{assert_close, samples};

/// Largest error over largest entry: rounding errors of some hundred operations.
const TOLERANCE: f64 = 1e-12;

/// A test for each mechanism, at the states of the reference data.
macro_rules! agrees {
    ($($test:ident: $model:ident, $dof:literal;)*) => {$(
        #[test]
        fn $test() {
            const D: usize = $dof;
            const N: usize = 2 * D;
            let model = $model::new(Default::default()).expect("physical");
            let dual = model.cast::<Dual>();
            for sample in samples::<N, D>(stringify!($test)) {
                let x = &sample.state;
                let along = |direction: &SVector<f64, N>| x.zip_map(direction, Dual::new);
                let (y, rate) = model.canonical(0.0, x);
                let rates = x.fixed_rows::<D>(D).into_owned();
                assert_eq!(y.fixed_rows::<D>(0), x.fixed_rows::<D>(0), "the coordinates come first");
                assert_eq!(rate.fixed_rows::<D>(0), rates, "and their rates");
                assert_close("momenta", TOLERANCE, y.fixed_rows::<D>(D).into_owned(), sample.mass_matrix * rates);
                // the chain rule, along the motion
                let motion = along(&model.rhs(0.0, x));
                let swept = dual.canonical(Dual::default(), &motion).0.map(|component| component.slope);
                assert_close("rates of the momenta", TOLERANCE, rate, swept);
                let (of_y, of_rate) = model.canonical_jacobian(0.0, x);
                let columns: [_; N] = std::array::from_fn(|k| {
                    let unit = SVector::from_fn(|i, _| f64::from(u8::from(i == k)));
                    let (y, rate) = dual.canonical(Dual::default(), &along(&unit));
                    [y, rate].map(|vector| vector.map(|component| component.slope))
                });
                let of = |part: usize| SMatrix::from_columns(&columns.map(|column| column[part]));
                assert_close("derivatives of the variables", TOLERANCE, of_y, of(0));
                assert_close("derivatives of their rates", TOLERANCE, of_rate, of(1));
            }
        }
    )*};
}

agrees! {
    eq22: Eq22, 2;
    eq22_joint: Eq22Joint, 2;
    irregular_plates: IrregularPlates, 2;
    chain5: Chain5, 5;
    cart_pole: CartPole, 2;
    furuta: Furuta, 2;
    screw_joint: ScrewJoint, 2;
    elbow3: Elbow3, 3;
    tree: Tree, 4;
    spring_pendulum_rig: SpringPendulumRig, 2;
}

#[test]
fn nothing_is_divided_or_solved() {
    for cost in [Eq22::COST, Chain5::COST, Tree::COST] {
        assert_eq!(cost["canonical"].operations.divisions, 0);
        assert_eq!(cost["canonical_jacobian"].operations.divisions, 0);
    }
    assert!(Eq22::COST["canonical"].flops() <= Eq22::COST["rhs"].flops());
}
