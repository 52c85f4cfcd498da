//! The tableaus against the theory of Runge-Kutta methods: one condition per rooted tree.
//!
//! Sums are computed in twice the precision, so that the remaining error is the rounding of the coefficients to `f64`.
//! Its effect on a sum is bounded by the derivatives of the sum with respect to the coefficients. The conditions may be
//! violated by this bound.

mod double;
pub(crate) mod tree;

use double::Double;
use pendulum_core::tableau::{ButcherTableau, DormandPrince5, Kutta4, Tableau, Tsitouras5, Verner7, Verner9};
use tree::{Tree, trees};

/// Relative error of a single rounding.
const UNIT: f64 = f64::EPSILON / 2.0;

#[derive(Clone, Copy, Debug)]
struct Defect {
    found: f64,
    allowed: f64,
}

impl Defect {
    #[track_caller]
    fn check(self, what: &str) {
        assert!(self.found <= self.allowed, "{what}: {self:?}");
    }
}

/// A sum of coefficients with exact factors.
#[derive(Clone, Copy, Default)]
struct Sum {
    value: Double,
    /// Sum of the absolute values of the terms.
    size: f64,
}

impl Sum {
    fn plus(self, factor: Double, coefficient: f64) -> Self {
        let term = factor * coefficient.into();
        Self {
            value: self.value + term,
            size: self.size + term.round().abs(),
        }
    }

    fn defect(self, exact: f64) -> Defect {
        Defect {
            found: (self.value - exact.into()).round().abs(),
            allowed: UNIT * self.size,
        }
    }
}

/// A tableau that includes the stages for dense output.
struct Method {
    a: Vec<Vec<f64>>,
    c: Vec<f64>,
    dense: &'static [&'static [f64]],
}

impl Method {
    fn of<const S: usize>(tableau: &ButcherTableau<S>) -> Self {
        let (mut a, mut c) = (tableau.a.map(|row| row.to_vec()).to_vec(), tableau.c.to_vec());
        for (i, stage) in tableau.extra.iter().enumerate() {
            assert_eq!(stage.a.len(), S + i, "extra stage {i}");
            a.push(stage.a.to_vec());
            c.push(stage.c);
        }
        let dense = tableau.dense;
        assert!(dense.iter().all(|row| row.len() == a.len()));
        Self { a, c, dense }
    }

    /// Product `A v`.
    fn times(&self, v: &[Double]) -> Vec<Double> {
        let dot = |row: &Vec<f64>| {
            let terms = row.iter().zip(v).map(|(&a, &v)| v * a.into());
            terms.fold(Double::default(), |sum, term| sum + term)
        };
        self.a.iter().map(dot).collect()
    }

    /// Elementary weights `Phi_i(t)` of all stages `i` for every tree `t`: the weight of its trunk times the sum over
    /// `a_ij` of the weight of its branch.
    fn elementary_weights(&self, trees: &[Tree]) -> Vec<Vec<Double>> {
        let mut phi: Vec<Vec<Double>> = Vec::new();
        for tree in trees {
            phi.push(match tree.parts {
                None => vec![1.0.into(); self.a.len()],
                Some((trunk, branch)) => product(&phi[trunk], &self.times(&phi[branch])),
            });
        }
        phi
    }

    /// `sum_j factors_j dense[j][i]` for every stage `i`.
    fn combine(&self, factors: impl Iterator<Item = Double>) -> Vec<Sum> {
        let mut sums = vec![Sum::default(); self.a.len()];
        for (row, factor) in self.dense.iter().zip(factors) {
            for (sum, &coefficient) in sums.iter_mut().zip(*row) {
                *sum = sum.plus(factor, coefficient);
            }
        }
        sums
    }
}

/// Componentwise product.
fn product(left: &[Double], right: &[Double]) -> Vec<Double> {
    left.iter().zip(right).map(|(&left, &right)| left * right).collect()
}

/// `theta`, `theta^2` and so on.
fn powers(theta: f64) -> impl Iterator<Item = Double> {
    std::iter::successors(Some(Double::from(theta)), move |&power| Some(power * theta.into()))
}

/// Order conditions of a method.
struct Conditions {
    method: Method,
    trees: Vec<Tree>,
    phi: Vec<Vec<Double>>,
}

impl Conditions {
    /// Conditions of one order, one per tree: `gamma(t) sum_i b_i(theta) Phi_i(t) = theta^order`.
    fn defects(&self, weights: &[Sum], order: usize, theta: f64) -> Vec<Defect> {
        let values: Vec<_> = weights.iter().map(|weight| weight.value).collect();
        let power = powers(theta).nth(order - 1).expect("without end");
        let of_order = (0..self.trees.len()).filter(|&tree| self.trees[tree].order == order);
        let defect = |tree: usize| {
            let (phi, density) = (&self.phi[tree], self.trees[tree].density);
            let terms = product(&values, phi).into_iter();
            let sum = terms.fold(Double::default(), |sum, term| sum + term);
            let of_weights: f64 = weights.iter().zip(phi).map(|(b, phi)| b.size * phi.round().abs()).sum();
            Defect {
                found: (sum * density.into() - power).round().abs(),
                allowed: UNIT * density * (of_weights + self.sensitivity(tree, &values)),
            }
        };
        of_order.map(defect).collect()
    }

    /// First-order bound on the change of `sum_i v_i Phi_i(t)` under relative changes of all `a_ij`.
    fn sensitivity(&self, tree: usize, v: &[Double]) -> f64 {
        let Some((trunk, branch)) = self.trees[tree].parts else {
            return 0.0;
        };
        // Each a_ij occurs between trunk and branch, within the trunk, and within the branch.
        let at_root = product(v, &self.phi[trunk]);
        let mut at_branch = vec![Double::default(); v.len()];
        let mut between = 0.0;
        for (row, &root) in self.method.a.iter().zip(&at_root) {
            for (j, &a) in row.iter().enumerate() {
                let term = root * a.into();
                at_branch[j] = at_branch[j] + term;
                between += (term * self.phi[branch][j]).round().abs();
            }
        }
        let at_trunk = product(v, &self.method.times(&self.phi[branch]));
        between + self.sensitivity(trunk, &at_trunk) + self.sensitivity(branch, &at_branch)
    }

    /// Checks that the conditions hold up to `order` and fail at the next: the stated order is exact.
    fn check(&self, what: &str, weights: &[Sum], order: usize, theta: f64) {
        for order in 1..=order {
            for defect in self.defects(weights, order, theta) {
                defect.check(&format!("{what}, order {order} at {theta}"));
            }
        }
        let next = self.defects(weights, order + 1, theta);
        let is_missed = next.iter().any(|defect| defect.found > 1e3 * defect.allowed);
        assert!(is_missed, "{what} is of order {} at {theta}", order + 1);
    }
}

fn check<B: Tableau<S>, const S: usize>() {
    let tableau = &B::TABLEAU;
    assert!(tableau.ends_in_the_next_first_stage());
    let method = Method::of(tableau);
    for (row, &c) in method.a.iter().zip(&method.c) {
        let sum = row.iter().fold(Sum::default(), |sum, &a| sum.plus(1.0.into(), a));
        sum.plus((-1.0).into(), c).defect(0.0).check("c");
    }

    // Dense output matches the value and slope of the step at both ends.
    let whole = method.combine(powers(1.0));
    let slope = method.combine((1..).map(|power| f64::from(power).into()));
    for i in 0..method.a.len() {
        let b = tableau.b.get(i).copied().unwrap_or_default();
        let rest = whole[i].plus((-1.0).into(), b);
        rest.defect(0.0).check("dense(1) = b");
        let is = |stage: usize| if i == stage { 1.0 } else { 0.0 };
        assert_eq!(tableau.dense[0][i], is(0), "slope at the start");
        slope[i].defect(is(S - 1)).check("slope at the end");
    }

    let trees = trees(tableau.order + 1);
    let phi = method.elementary_weights(&trees);
    let conditions = Conditions { method, trees, phi };
    let given = |weights: &[f64]| -> Vec<Sum> {
        let weight = |&weight| Sum::default().plus(1.0.into(), weight);
        weights.iter().map(weight).collect()
    };
    conditions.check("b", &given(&tableau.b), tableau.order, 1.0);
    if let Some(b_hat) = &tableau.b_hat {
        conditions.check("b_hat", &given(b_hat), tableau.order_hat, 1.0);
    }
    for theta in [0.1, 0.3, 0.5, 0.77] {
        let weights = conditions.method.combine(powers(theta));
        conditions.check("dense", &weights, tableau.dense_order, theta);
    }
}

#[test]
fn kutta4() {
    check::<Kutta4, 5>();
}

#[test]
fn dormand_prince5() {
    check::<DormandPrince5, 7>();
}

#[test]
fn tsitouras5() {
    check::<Tsitouras5, 7>();
}

#[test]
fn verner7() {
    check::<Verner7, 11>();
}

#[test]
fn verner9() {
    check::<Verner9, 17>();
}
