//! The twelve problems end where others found: E. Hairer and G. Wanner, "Solving Ordinary Differential Equations" I and
//! II, and the "Test Set for Initial Value Problem Solvers", release 2.4.

use pendulum_core::{Cast, Jacobian, TaylorSeries};
use testbed::counted::Counted;
use testbed::problems::{Visitor, each};
use testbed::work::Scene;

/// Published components of final states, with their index.
fn published(name: &str) -> &'static [(usize, f64)] {
    match name {
        "arenstorf" => &[(0, 0.994), (1, 0.0), (2, 0.0), (3, -2.001_585_106_379_082_4)],
        // x1, y1, x2, y2, .. y7
        "pleiades" => &[
            (0, 0.370_613_914_397_050_2),
            (1, -3.943_437_585_517_392),
            (2, 3.237_284_092_057_233),
            (3, -3.271_380_973_972_55),
            (4, -3.222_559_032_418_324),
            (5, 5.225_081_843_456_543),
            (13, 1.091_449_240_428_98),
        ],
        "van_der_pol" => &[(0, 1.706_167_732_170_483), (1, -0.892_809_701_024_797_5)],
        "hires" => &[
            (0, 0.737_131_257_332_566_8e-3),
            (1, 0.144_248_572_631_618_5e-3),
            (2, 0.588_872_974_096_757_5e-4),
            (3, 0.117_565_134_328_314_9e-2),
            (4, 0.238_635_619_883_133_1e-2),
            (5, 0.623_896_825_274_279_6e-2),
            (6, 0.284_999_839_518_576_9e-2),
            (7, 0.285_000_160_481_423_1e-2),
        ],
        "robertson" => &[
            (0, 0.208_334_014_970_125_5e-7),
            (1, 0.833_336_077_033_471_3e-13),
            (2, 0.999_999_979_166_505),
        ],
        _ => &[],
    }
}

#[derive(Default)]
struct Ends {
    visited: Vec<&'static str>,
    compared: usize,
}

impl Visitor for Ends {
    fn visit<S, const N: usize>(&mut self, scene: Scene<S, N>, _is_stiff: bool)
    where
        S: Cast<N, In<f64> = S> + Jacobian<f64, N> + TaylorSeries<f64, N>,
        S::In<Counted>: Jacobian<Counted, N> + TaylorSeries<Counted, N>,
    {
        let end = scene.reference.at(scene.t1).expect("the end");
        let uncertainty = scene.reference.uncertainty(scene.t1);
        // close encounters amplify rounding errors
        assert!(uncertainty < 1e-9 * end.amax(), "{}: {uncertainty:e}", scene.name);
        for &(n, expected) in published(scene.name) {
            // the absolute tolerance of the reference, and rounding errors that a close encounter amplifies
            let least = if scene.name == "arenstorf" { 1e-10 } else { 1e-14 };
            let tolerance = 2e-11 * expected.abs() + least;
            assert!(
                (end[n] - expected).abs() <= tolerance,
                "{} {n}: {} {expected}",
                scene.name,
                end[n]
            );
            self.compared += 1;
        }
        self.visited.push(scene.name);
    }
}

#[test]
fn end_as_published() {
    let mut ends = Ends::default();
    each(&mut ends).expect("each is solved");
    assert_eq!((ends.visited.len(), ends.compared), (12, 24), "{:?}", ends.visited);
}
