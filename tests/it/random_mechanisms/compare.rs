//! Every function of a program against the oracle.
//!
//! Solutions are substituted into the equations that they solve, so that errors do not depend on the condition of the
//! mass matrix.

use std::collections::BTreeMap;

use nalgebra::DMatrix;
use pendulum_codegen::program::Program;
use pendulum_core::Real;
use testbed::dual::Dual;
use testbed::power_series::Series;
use testbed::random::Random;
use testbed::trees::{Oracle, Tree};

use super::evaluate::{Evaluator, Place};

/// Largest error of each function.
pub(super) type Worst = BTreeMap<&'static str, f64>;

/// Highest compared order of the series.
const ORDER: usize = 6;

/// Random points at which a tree is compared.
pub(super) fn places(tree: &Tree, random: &mut Random) -> Vec<Place> {
    let n = tree.dof();
    let mut list = |count: usize| -> Vec<f64> { (0..count).map(|_| random.between(-2.0, 2.0)).collect() };
    (0..3)
        .map(|_| Place {
            t: list(1)[0],
            state: list(2 * n),
            accelerations: list(n),
            inputs: list(tree.inputs.len()),
        })
        .collect()
}

/// Condition number of the mass matrix scaled to unit diagonal.
pub(super) fn condition(tree: &Tree, place: &Place) -> f64 {
    let n = tree.dof();
    let a = Oracle::with_defaults(tree, &place.inputs).mass_matrix(place.t, &place.state[..n]);
    // lever arms that are zero up to rounding errors
    let rounding = tree.masses_behind().into_iter().map(|mass| mass * 1e-24);
    if rounding.enumerate().any(|(k, rounding)| a[k][k] <= rounding) {
        return f64::INFINITY;
    }
    let scaled = DMatrix::from_fn(n, n, |i, j| a[i][j] / (a[i][i] * a[j][j]).sqrt());
    let values = scaled.symmetric_eigenvalues();
    if values.min() <= 0.0 {
        return f64::INFINITY;
    }
    values.max() / values.min()
}

/// Errors of a program at several places.
pub(super) fn errors(tree: &Tree, program: &Program, places: &[Place]) -> Worst {
    let mut worst = Worst::new();
    let program = Evaluator::new(program, &tree.parameters);
    for place in places {
        Comparison::new(tree, place).all(&program, &mut worst);
    }
    worst
}

/// Expected values at a place.
pub(super) struct Comparison<'a> {
    tree: &'a Tree,
    pub(super) oracle: Oracle<'a, f64>,
    pub(super) place: &'a Place,
    pub(super) n: usize,
    pub(super) mass_matrix: Vec<Vec<f64>>,
    /// Magnitude of the forces along each coordinate.
    pub(super) size: Vec<f64>,
}

/// Variable of a derivative.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum By {
    Time,
    /// Component of the state.
    State(usize),
    Parameter(usize),
    Input(usize),
}

impl<'a> Comparison<'a> {
    pub(super) fn new(tree: &'a Tree, place: &'a Place) -> Self {
        let (n, oracle) = (tree.dof(), Oracle::with_defaults(tree, &place.inputs));
        let mass_matrix = oracle.mass_matrix(place.t, &place.state[..n]);
        let mut comparison = Self {
            tree,
            oracle,
            place,
            n,
            mass_matrix,
            size: Vec::new(),
        };
        comparison.size = comparison.sizes();
        comparison
    }

    pub(super) fn q(&self) -> &[f64] {
        &self.place.state[..self.n]
    }

    pub(super) fn qd(&self) -> &[f64] {
        &self.place.state[self.n..]
    }

    /// Magnitude of the forces along each coordinate: from the masses behind the joint at these rates and gravity, with
    /// arms of 1 m, and from the forces of the declaration.
    fn sizes(&self) -> Vec<f64> {
        let gravity: f64 = self.tree.gravity.iter().map(|g| g.value.abs()).sum();
        let rate = self.qd().iter().fold(1.0, |largest: f64, rate| largest.max(rate.abs()));
        let forces = self.oracle.forces(self.place.t, self.q(), self.qd());
        let behind = self.tree.masses_behind();
        (0..self.n)
            .map(|k| behind[k] * (gravity + rate * rate) + forces[k].abs())
            .collect()
    }

    fn all(&self, program: &Evaluator<'_>, worst: &mut Worst) {
        let mut note = |what: &'static str, error: f64| {
            let entry = worst.entry(what).or_insert(0.0);
            *entry = if error.is_nan() { error } else { entry.max(error) };
        };
        let place = self.place;
        let (t, n) = (place.t, self.n);
        if let Some(results) = program.routine("mass_matrix", place) {
            let behind = self.tree.masses_behind();
            let entries = (0..n * n).map(|k| {
                let (i, j) = (k % n, k / n);
                let scale = (self.mass_matrix[i][i] * self.mass_matrix[j][j]).sqrt();
                let scale = scale.max(behind[i].min(behind[j]));
                (results[0][k] - self.mass_matrix[i][j]).abs() / scale
            });
            note("mass_matrix", largest(entries));
        }
        let mut vector =
            |what: &'static str, ours: Option<Vec<Vec<f64>>>, theirs: &dyn Fn() -> Vec<f64>, more: &[f64]| {
                let Some(ours) = ours else { return };
                let theirs = theirs();
                assert_eq!(ours[0].len(), theirs.len(), "{what}");
                let rows = (0..theirs.len())
                    .map(|k| (ours[0][k] - theirs[k]).abs() / (theirs[k].abs() + self.size[k] + more[k]));
                note(what, largest(rows));
            };
        let (q, qd, qdd) = (self.q(), self.qd(), &place.accelerations);
        let inertial = self.spread(qdd);
        vector(
            "bias",
            program.routine("bias", place),
            &|| self.oracle.bias(t, q, qd),
            &inertial,
        );
        vector(
            "momentum",
            program.routine("momentum", place),
            &|| self.oracle.momentum(t, q, qd),
            &self.spread(qd),
        );
        vector(
            "inverse_dynamics",
            program.routine("inverse_dynamics", place),
            &|| {
                // inputs count as zero
                let without = Oracle::with_defaults(self.tree, &vec![0.0; place.inputs.len()]);
                without.inverse_dynamics(t, [q, qd, qdd])
            },
            &inertial,
        );
        for (name, error) in ["kinetic", "potential"].into_iter().zip(self.energies(program)) {
            note(name, error);
        }
        self.accelerations(program, &mut note);
        self.adjoint(program, &mut note);
        self.canonical(program, &mut note);
        self.observed(program, &mut note);
        if let Some(ours) = program.routine("drive_forces", place) {
            let theirs = self.oracle.drive_forces(t, q, qd);
            let size = self
                .size
                .iter()
                .chain(&theirs)
                .fold(self.tree.mass(), |sum, x| sum + x.abs());
            let rows = ours[0]
                .iter()
                .zip(&theirs)
                .map(|(ours, theirs)| (ours - theirs).abs() / size);
            note("drive_forces", largest(rows));
        }
        if let Some(ours) = program.series(place, ORDER) {
            note("taylor", difference(&ours, &self.series()));
        }
    }

    /// Product `|A| |x|`.
    pub(super) fn spread(&self, x: &[f64]) -> Vec<f64> {
        let row = |row: &Vec<f64>| row.iter().zip(x).map(|(a, x)| (a * x).abs()).sum();
        self.mass_matrix.iter().map(row).collect()
    }

    /// Errors of the energies.
    fn energies(&self, program: &Evaluator<'_>) -> [f64; 2] {
        let theirs = self.oracle.energies(self.place.t, self.q(), self.qd());
        let size: f64 = self.size.iter().sum::<f64>() + self.tree.mass();
        [("kinetic", theirs[0]), ("potential", theirs[1])].map(|(name, theirs)| {
            let ours = program.routine(name, self.place).map_or(theirs, |ours| ours[0][0]);
            (ours - theirs).abs() / (theirs.abs() + size)
        })
    }

    /// Error of the state's rates, in the equations that they solve.
    pub(super) fn of_rates(&self, rates: &[f64]) -> f64 {
        let (t, n, q, qd) = (self.place.t, self.n, self.q(), self.qd());
        let qdd = &rates[n..];
        let (left, spread) = (self.oracle.inverse_dynamics(t, [q, qd, qdd]), self.spread(qdd));
        let same = rates[..n] == *qd;
        let rows = (0..n).map(|k| left[k].abs() / (spread[k] + self.size[k]));
        if same { largest(rows) } else { f64::NAN }
    }

    /// Error of the derivatives of these rates with respect to the state, column by column.
    pub(super) fn of_jacobian(&self, rates: &[f64], jacobian: &[f64]) -> f64 {
        let n = self.n;
        let columns = jacobian.chunks(2 * n).enumerate().map(|(j, column)| {
            let is_identity = (0..n).all(|i| column[i] == f64::from(u8::from(j == n + i)));
            let slope = self.slope(&rates[n..], By::State(j));
            let error = self.residual(&rates[n..], &column[n..], &slope);
            if is_identity { error } else { f64::NAN }
        });
        largest(columns)
    }

    fn accelerations(&self, program: &Evaluator<'_>, note: &mut impl FnMut(&'static str, f64)) {
        let n = self.n;
        let Some(rhs) = program.routine("rhs", self.place) else {
            return;
        };
        note("rhs", self.of_rates(&rhs[0]));
        if let Some(results) = program.routine("jacobian", self.place) {
            let rates = &results[0];
            note("rhs of the jacobian", self.of_rates(rates));
            note("jacobian", self.of_jacobian(rates, &results[1]));
            let by_time = program.routine("time_derivative", self.place);
            let by_time = by_time.map_or(vec![0.0; 2 * n], |results| results[0].clone());
            let slope = self.slope(&rates[n..], By::Time);
            note("time_derivative", self.residual(&rates[n..], &by_time[n..], &slope));
        }
        if let Some(results) = program.routine("input_jacobian", self.place) {
            for (m, column) in results[0].chunks(2 * n).enumerate() {
                let slope = self.slope(&rhs[0][n..], By::Input(m));
                let of_rates = largest(column[..n].iter().map(|entry| entry.abs()));
                note(
                    "input_jacobian",
                    of_rates + self.residual(&rhs[0][n..], &column[n..], &slope),
                );
            }
        }
        if let Some(results) = program.routine("parameter_jacobian", self.place) {
            for (p, column) in results[0].chunks(2 * n).enumerate() {
                let slope = self.slope(&rhs[0][n..], By::Parameter(p));
                let of_rates = largest(column[..n].iter().map(|entry| entry.abs()));
                note(
                    "parameter_jacobian",
                    of_rates + self.residual(&rhs[0][n..], &column[n..], &slope),
                );
            }
        }
    }

    /// Errors of the products of weights with the derivatives, against the derivatives themselves. They are relative to
    /// what rounding errors can be at the condition of the mass matrix.
    fn adjoint(&self, program: &Evaluator<'_>, note: &mut impl FnMut(&'static str, f64)) {
        let Some(products) = program.routine("adjoint", self.place) else {
            return;
        };
        let columns = |name: &str, n: usize| program.routine(name, self.place).map(|results| results[n].clone());
        let jacobians = [
            columns("jacobian", 1),
            columns("parameter_jacobian", 0),
            columns("input_jacobian", 0),
        ];
        // results without entries are left out
        let has = [true, !self.tree.parameters.is_empty(), !self.tree.inputs.is_empty()];
        let jacobians = jacobians.into_iter().zip(has).filter(|(_, has)| *has);
        let condition = condition(self.tree, self.place);
        for (products, (jacobian, _)) in products.iter().zip(jacobians) {
            let Some(jacobian) = jacobian else { continue };
            let errors = products
                .iter()
                .zip(jacobian.chunks(2 * self.n))
                .map(|(product, column)| {
                    let terms = self
                        .place
                        .state
                        .iter()
                        .zip(column)
                        .map(|(weight, entry)| weight * entry);
                    let terms: Vec<f64> = terms.collect();
                    let size: f64 = terms.iter().map(|term| term.abs()).sum();
                    (product - terms.iter().sum::<f64>()).abs() / (condition * (size + 1.0))
                });
            note("adjoint", largest(errors));
        }
    }

    /// Oracle, time and state, seeded with a derivative.
    pub(super) fn seeded(&self, by: By) -> (Oracle<'a, Dual>, Dual, Vec<Dual>) {
        let dual = |x: f64, own: By| Dual::new(x, f64::from(u8::from(own == by)));
        let list = |list: &[f64], own: fn(usize) -> By| -> Vec<Dual> {
            list.iter().enumerate().map(|(n, &x)| dual(x, own(n))).collect()
        };
        let parameters = list(&self.tree.parameters, By::Parameter);
        let oracle = Oracle::new(self.tree, parameters, list(&self.place.inputs, By::Input));
        (oracle, dual(self.place.t, By::Time), list(&self.place.state, By::State))
    }

    /// Derivative of `A qdd + b - Q`.
    fn slope(&self, qdd: &[f64], by: By) -> Vec<f64> {
        let (oracle, time, state) = self.seeded(by);
        let qdd: Vec<Dual> = qdd.iter().map(|&x| Dual::from_f64(x)).collect();
        let left = oracle.inverse_dynamics(time, [&state[..self.n], &state[self.n..], &qdd]);
        left.into_iter().map(|left| left.slope).collect()
    }

    /// Relative residual of `A x + slope`.
    fn residual(&self, qdd: &[f64], x: &[f64], slope: &[f64]) -> f64 {
        let (spread, around) = (self.spread(x), self.spread(qdd));
        let rows = (0..self.n).map(|k| {
            let product: f64 = self.mass_matrix[k].iter().zip(x).map(|(a, x)| a * x).sum();
            (product + slope[k]).abs() / (spread[k] + slope[k].abs() + around[k] + self.size[k])
        });
        largest(rows)
    }

    fn canonical(&self, program: &Evaluator<'_>, note: &mut impl FnMut(&'static str, f64)) {
        let (t, n, q, qd) = (self.place.t, self.n, self.q(), self.qd());
        let Some(ours) = program.routine("canonical", self.place) else {
            return;
        };
        let qdd = self.oracle.accelerations(t, q, qd);
        let (spread, around) = (self.spread(qd), self.spread(&qdd));
        let (momentum, rates) = (self.oracle.momentum(t, q, qd), self.oracle.momentum_rates(t, q, qd));
        let same = ours[0][..n] == *q && ours[1][..n] == *qd;
        let rows = (0..n).map(|k| {
            let size = self.size[k] + spread[k] + around[k];
            let [p, pd] =
                [(&ours[0], &momentum), (&ours[1], &rates)].map(|(ours, theirs)| (ours[n + k] - theirs[k]).abs());
            p.max(pd) / size
        });
        note("canonical", if same { largest(rows) } else { f64::NAN });
        let Some(ours) = program.routine("canonical_jacobian", self.place) else {
            return;
        };
        for j in 0..2 * n {
            let (oracle, time, state) = self.seeded(By::State(j));
            let (q, qd) = state.split_at(n);
            let [p, pd] = [oracle.momentum(time, q, qd), oracle.momentum_rates(time, q, qd)];
            let rows = (0..n).map(|k| {
                let error = |ours: &[f64], theirs: &[Dual]| {
                    let column = &ours[2 * n * j..2 * n * (j + 1)];
                    let size = theirs[k].slope.abs() + self.size[k] + spread[k] + around[k];
                    (column[n + k] - theirs[k].slope).abs() / size
                };
                error(&ours[0], &p).max(error(&ours[1], &pd))
            });
            note("canonical_jacobian", largest(rows));
        }
    }

    /// Coefficients of the motion: each pass corrects one more of them.
    fn series(&self) -> Vec<Vec<f64>> {
        const LENGTH: usize = ORDER + 1;
        let n = self.n;
        let time = Series::<LENGTH>(std::array::from_fn(|k| {
            [self.place.t, 1.0].get(k).copied().unwrap_or(0.0)
        }));
        let oracle = Oracle::with_defaults(self.tree, &[]);
        let mut state: Vec<Series<LENGTH>> = self.place.state.iter().map(|&x| Series::from_f64(x)).collect();
        for k in 1..LENGTH {
            let qdd = oracle.accelerations(time, &state[..n], &state[n..]);
            let rates: Vec<Series<LENGTH>> = state[n..].iter().copied().chain(qdd).collect();
            for (x, rate) in state.iter_mut().zip(&rates) {
                x.0[k] = rate.0[k - 1] / k as f64;
            }
        }
        (0..LENGTH).map(|k| state.iter().map(|x| x.0[k]).collect()).collect()
    }
}

/// Maximum of numbers, or NaN if one of them is NaN.
pub(super) fn largest(numbers: impl IntoIterator<Item = f64>) -> f64 {
    let larger = |a: f64, b: f64| if a.is_nan() || b.is_nan() { f64::NAN } else { a.max(b) };
    numbers.into_iter().fold(0.0, larger)
}

/// Largest difference of two series, each order weighted by a step as long as the range in which the whole series
/// converges.
fn difference(ours: &[Vec<f64>], theirs: &[Vec<f64>]) -> f64 {
    let size = |k: usize| largest(theirs[k].iter().map(|x| x.abs()));
    let last = theirs.len() - 1;
    let reach = (1..=last).map(|k| (size(0) / size(k)).powf(1.0 / k as f64));
    let reach = reach.fold(f64::INFINITY, f64::min);
    let scale = largest((0..=last).map(|k| size(k) * reach.powi(k as i32)));
    let order = |k: usize| {
        let differences = ours[k]
            .iter()
            .zip(&theirs[k])
            .map(|(ours, theirs)| (ours - theirs).abs());
        largest(differences) * reach.powi(k as i32) / scale
    };
    largest((0..=last).map(order))
}
