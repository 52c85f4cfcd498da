//! Gauss-Legendre methods, in coordinates and momenta.

use nalgebra::SVector;

use crate::cost::Operations;
use crate::dense::Step;
use crate::error::Reason;
use crate::hybrid::InMode;
use crate::layout::StateLayout;
use crate::linear::{Lu, factoring, solving};
use crate::method::collocation::{self, Pencil, add_scaled};
use crate::method::operations as count;
use crate::method::scheme::{Accepted, NonFinite, OneStep, Scheme, Stalled};
use crate::method::stages::{Called, shifted};
use crate::method::toggle::stop_at_toggles;
use crate::method::{Fixed, hermite};
use crate::real::Float;
use crate::statistics::Statistics;
use crate::step_size::Tolerance;
use crate::system::{Canonical, System};
use crate::tableau::{GaussLegendre, GaussTableau, HasGaussTableau, MOST_POINTS};

/// The Gauss-Legendre method of two, three or eight stages, of order 4, 6 or 16, in canonical variables. `PAIRS` is the
/// number of pairs of complex eigenvalues: half of the stages, rounded down.
///
/// It is symplectic and symmetric (E. Hairer, C. Lubich, G. Wanner, "Geometric Numerical Integration", II.1.3 and
/// VI.4): without friction, the energy error of a regular motion stays bounded and falls with the step to the power of
/// the order, conserved momenta are constant up to rounding, and backward integration retraces the motion.
///
/// There is no error estimate, so only fixed steps are available.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Gauss<const STAGES: usize, const PAIRS: usize = 1>;

impl<const STAGES: usize, const PAIRS: usize> Fixed<Gauss<STAGES, PAIRS>>
where
    GaussLegendre: HasGaussTableau<STAGES, PAIRS>,
{
    /// Upper bound of the operations of one step, in a system of `n` state components. `canonical` are the operations
    /// of the canonical equations, `jacobian` those of their Jacobian: the costs `canonical` and `canonical_jacobian`
    /// of a generated model.
    ///
    /// The bound assumes 100 iterations, the maximum. Comparisons and moves of numbers are extra. The choice of the
    /// time of a step is included, dense output is not.
    #[must_use]
    pub const fn operations(canonical: Operations, jacobian: Operations, n: usize) -> Operations {
        let modes = &<GaussLegendre as HasGaussTableau<STAGES, PAIRS>>::TABLEAU.modes;
        let points = STAGES + 2;
        let weight = Operations::new(1, 2, 1, 0, 0, 7);
        let term = count::multiplied(n).and(count::added(n));
        let stage = weight.and(term).times(points).and(count::TIME);
        let prediction = stage.times(STAGES).and(Operations::new(0, 0, 1, 0, 0, 4));
        let middle = count::added(n).times(STAGES).and(count::multiplied(n)).and(count::TIME);
        let parts = canonical.and(count::TIME).and(count::multiplied(n + 1));
        let parts = parts.and(term).and(count::added(2 * n)).times(STAGES);
        let swept = term.times(STAGES).and(count::added(n)).times(STAGES);
        let largest = Operations::new((STAGES + 1) * n, 0, 0, 0, STAGES * n, STAGES + n);
        let iteration = parts.and(swept).and(collocation::changes(modes, n)).and(largest);
        // the last change is rounding, and not applied
        let updates = count::added(STAGES * n).times(MAX_ITERATIONS - 1);
        // a change larger than the one before is compared with the size of rounding errors
        let rises = Operations::new(0, 1, 0, 0, 1, 11).times(MAX_RISES + 1);
        let increment = count::added(n).times(STAGES).and(count::added(n).times(6));
        let rates = jacobian.and(canonical).and(factoring::<f64>(n)).and(solving::<f64>(n));
        let rates = rates.and(count::added(n).times(2));
        prediction
            .and(middle)
            .and(jacobian)
            .and(collocation::pencil(modes, n))
            .and(largest)
            .and(iteration.times(MAX_ITERATIONS))
            .and(updates)
            .and(rises)
            .and(increment)
            .and(rates)
            .and(count::ON_GRID)
    }
}

impl<S, T, const STAGES: usize, const PAIRS: usize, const N: usize> OneStep<S, T, N> for Gauss<STAGES, PAIRS>
where
    GaussLegendre: HasGaussTableau<STAGES, PAIRS>,
    S: Canonical<T, N> + ?Sized,
    T: Float,
{
    type Scheme = GaussStages<T, STAGES, PAIRS, N>;

    fn scheme(&self, system: &S, _tolerance: Option<Tolerance<T>>) -> Result<Self::Scheme, Reason> {
        let zeros = SVector::from_element(T::default());
        let start = Point { y: zeros, lost: zeros };
        Ok(GaussStages {
            start,
            slope: zeros,
            positions: system.layout().map_or(N / 2, StateLayout::positions),
            before: None,
            tried: (start, [zeros; STAGES]),
            coefficients: [zeros; MOST_POINTS - 1],
        })
    }
}

/// Stages of a step of a Gauss method.
#[derive(Clone, Copy, Debug)]
pub struct GaussStages<T, const STAGES: usize, const PAIRS: usize, const N: usize> {
    /// Start of the next step.
    start: Point<T, N>,
    /// Derivative of the state at the initial point.
    slope: SVector<T, N>,
    /// Number of canonical variables that are coordinates; the momenta follow them.
    positions: usize,
    /// The last step: its start, its stages and its length.
    before: Option<(SVector<T, N>, [SVector<T, N>; STAGES], T)>,
    /// End and stages of the last attempt.
    tried: (Point<T, N>, [SVector<T, N>; STAGES]),
    coefficients: [SVector<T, N>; MOST_POINTS - 1],
}

/// A point in canonical variables, which the method advances.
#[derive(Clone, Copy, Debug)]
struct Point<T, const N: usize> {
    y: SVector<T, N>,
    /// Rounding error of the last addition of a step (compensated summation).
    lost: SVector<T, N>,
}

/// Maximum number of iterations.
const MAX_ITERATIONS: usize = 100;

/// Maximum ratio of a step to the last one, up to which the last step is extrapolated.
const MAX_RATIO: f64 = 4.0;

/// Minimum ratio, in rounding units: in a shorter step all stages are at the end of the last one, where the weights are
/// not defined.
const MIN_RATIO: f64 = 1024.0;

/// Maximum number of iterations whose changes grow: the first may move away from starting values more accurate than
/// they show.
const MAX_RISES: usize = 2;

/// A vector for each stage.
type Vectors<T, const STAGES: usize, const N: usize> = [SVector<T, N>; STAGES];

impl<T: Float, const STAGES: usize, const PAIRS: usize, const N: usize> GaussStages<T, STAGES, PAIRS, N>
where
    GaussLegendre: HasGaussTableau<STAGES, PAIRS>,
{
    const TABLEAU: GaussTableau<STAGES, PAIRS> = GaussLegendre::TABLEAU;

    /// Degree of the dense output.
    const DEGREE: usize = if STAGES <= 3 { 2 * STAGES - 1 } else { STAGES + 1 };

    /// Starting values: extrapolates the polynomial through start, stages and end of the last step. Falls back to a
    /// straight line if there is no last step, or if it was too short, as from an impact to the grid, or far longer.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn predicted(&self, x: &SVector<T, N>, h: T) -> [SVector<T, N>; STAGES] {
        let table = const { &Self::TABLEAU };
        let last = self
            .before
            .as_ref()
            .map(|(x0, stages, before)| (x0, stages, h / *before));
        let mut predicted = [*x; STAGES];
        let [least, most] = [T::EPSILON * T::from_f64(MIN_RATIO), T::from_f64(MAX_RATIO)];
        let Some((x0, stages, ratio)) = last.filter(|(.., ratio)| *ratio >= least && *ratio <= most) else {
            for (predicted, c) in predicted.iter_mut().zip(table.c) {
                add_scaled(&mut predicted.data.0[0], h * T::from_f64(c), &self.slope);
            }
            return predicted;
        };
        for (predicted, c) in predicted.iter_mut().zip(table.c) {
            let weights = table.weights(T::from_f64(1.0) + ratio * T::from_f64(c));
            let mut sum = [T::default(); N];
            add_scaled(&mut sum, weights[0], x0);
            for j in 0..STAGES {
                add_scaled(&mut sum, weights[j + 1], &stages[j]);
            }
            add_scaled(&mut sum, weights[STAGES + 1], x);
            *predicted = SVector::from(sum);
        }
        predicted
    }

    /// Sets the coefficients of the polynomial through start, stages and end of the last step, which is of the order of
    /// the stages.
    fn interpolate(&mut self, step: &Step<T, N>) {
        let table = const { &Self::TABLEAU };
        let (_, stages) = &self.tried;
        for (power, weights) in table.powers.iter().enumerate().take(Self::DEGREE) {
            let mut sum = [T::default(); N];
            for (weight, state) in weights.iter().zip(stages.iter().chain([&step.x1])) {
                add_scaled(&mut sum, T::from_f64(*weight), &(state - step.x0));
            }
            self.coefficients[power] = SVector::from(sum);
        }
    }

    /// Returns the products `h b_i f_i` of the rates of the stages of a step, and the residuals of its equations.
    #[inline(always)]
    fn residuals<S: Canonical<T, N> + ?Sized>(
        &self,
        system: &InMode<'_, S, T>,
        (t, h): (T, T),
        stages: &Vectors<T, STAGES, N>,
    ) -> (Vectors<T, STAGES, N>, Vectors<T, STAGES, N>) {
        let GaussTableau { c, b, w, .. } = const { &Self::TABLEAU };
        let zeros = SVector::from([T::default(); N]);
        let (mut parts, mut residuals) = ([zeros; STAGES], [zeros; STAGES]);
        let Point { y, lost } = &self.start;
        let mut half = [T::default(); N];
        for i in 0..STAGES {
            let (variables, rates) = Called(system).canonical(t + h * T::from_f64(c[i]), &stages[i]);
            let weight = h * T::from_f64(b[i]);
            for k in 0..N {
                parts[i][k] = rates[k] * weight;
                // sum increments: they are smaller than the variables, and so are their rounding errors
                residuals[i][k] = (y[k] - variables[k]) + lost[k];
            }
            add_scaled(&mut half, T::from_f64(0.5), &parts[i]);
        }
        for (residual, w) in residuals.iter_mut().zip(w) {
            let mut sum = half;
            for (part, &w) in parts.iter().zip(w) {
                add_scaled(&mut sum, T::from_f64(w), part);
            }
            *residual = shifted(residual, &SVector::from(sum));
        }
        (parts, residuals)
    }

    /// Solves for the stages of a step from `x` at `t`, and returns them with the products `h b_i f_i` of their rates.
    /// The result is not finite if a rate is not.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn solve<S: Canonical<T, N> + ?Sized>(
        &self,
        system: &InMode<'_, S, T>,
        (t, x): (T, &SVector<T, N>),
        h: T,
        work: &mut Statistics,
    ) -> Result<(Vectors<T, STAGES, N>, Vectors<T, STAGES, N>), Stalled> {
        let modes = const { &Self::TABLEAU.modes };
        let [one_half, zero] = [0.5, 0.0].map(T::from_f64);
        let mut stages = self.predicted(x, h);
        // the middle of the step, amid the stages
        let middle = stages
            .iter()
            .fold(SVector::from_element(zero), |sum, stage| sum + stage)
            * T::from_f64(1.0 / STAGES as f64);
        let (of_variables, of_rates) = Called(system).canonical_jacobian(t + h * one_half, &middle);
        let pencil = Pencil::new(modes, h, [&of_variables, &of_rates], system.active()).map_err(|_| Stalled)?;
        work.jacobians += 1;
        work.factorizations += pencil.factorizations();
        // of the states, beside which the last changes are rounding errors
        let size = largest(&stages);
        let (mut before, mut rises) = (T::from_f64(f64::INFINITY), 0);
        for _ in 0..MAX_ITERATIONS {
            work.iterations += 1;
            work.evaluations += STAGES;
            let (parts, residuals) = self.residuals(system, (t, h), &stages);
            let changes = pencil.solve(modes, &residuals, system.active());
            let change = largest(&changes);
            if !change.is_finite() {
                return if before.is_finite() {
                    Err(Stalled)
                } else {
                    Ok((stages, parts))
                };
            }
            // iterate until the changes stop falling, at the level of rounding: a remaining error would cause a drift
            if change >= before || change == zero {
                if change <= T::EPSILON.sqrt() * size {
                    return Ok((stages, parts));
                }
                rises += 1;
                if rises > MAX_RISES {
                    return Err(Stalled);
                }
            }
            before = change;
            for (stage, change) in stages.iter_mut().zip(&changes) {
                *stage = shifted(stage, change);
                system.pin(stage);
            }
        }
        Err(Stalled)
    }
}

impl<S, T, const STAGES: usize, const PAIRS: usize, const N: usize> Scheme<S, T, N> for GaussStages<T, STAGES, PAIRS, N>
where
    GaussLegendre: HasGaussTableau<STAGES, PAIRS>,
    S: Canonical<T, N> + ?Sized,
    T: Float,
{
    fn error_order(&self) -> usize {
        2 * STAGES
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn begin(&mut self, system: &InMode<'_, S, T>, t: T, x: &SVector<T, N>, work: &mut Statistics) -> SVector<T, N> {
        work.evaluations += 2;
        self.slope = system.rhs(t, x);
        self.before = None;
        self.start = Point {
            y: Called(system).canonical(t, x).0,
            lost: SVector::from_element(T::default()),
        };
        self.slope
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn attempt(
        &mut self,
        system: &InMode<'_, S, T>,
        (t, x): (T, &SVector<T, N>),
        (t_new, x_new): (T, &mut SVector<T, N>),
        work: &mut Statistics,
    ) -> Result<T, Stalled> {
        let (stages, parts) = self.solve(system, (t, x), t_new - t, work)?;
        let increment = parts.iter().fold(self.start.lost, |sum, part| sum + part);
        let (y, lost) = sum_and_rest(&self.start.y, &increment);
        if NonFinite::check(&y).is_err() {
            *x_new = y;
            return Ok(T::default());
        }
        // the coordinates are final; their rates solve A qd = p, linearized at nearby rates
        let nearby = SVector::from_fn(|k, _| {
            if k < self.positions {
                y[k]
            } else {
                stages[STAGES - 1][k]
            }
        });
        let (of_variables, _) = Called(system).canonical_jacobian(t_new, &nearby);
        let missing = y - Called(system).canonical(t_new, &nearby).0;
        let change = Lu::new(of_variables.data.0, system.active())
            .map_err(|_| Stalled)?
            .solve(&missing.data.0[0], system.active());
        work.evaluations += 1;
        work.jacobians += 1;
        work.factorizations += 1;
        self.tried = (Point { y, lost }, stages);
        *x_new = nearby + SVector::from(change);
        system.pin(x_new);
        stop_at_toggles(system, (t, x), (t_new, x_new));
        Ok(T::default())
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn arrive(
        &mut self,
        _system: &InMode<'_, S, T>,
        _end: (T, &SVector<T, N>),
        _work: &mut Statistics,
    ) -> Option<&SVector<T, N>> {
        None
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn accept(&mut self, _system: &InMode<'_, S, T>, step: &Step<T, N>, _lanes: Accepted<T>, _work: &mut Statistics) {
        let (end, stages) = self.tried;
        self.start = end;
        self.before = Some((step.x0, stages, step.h));
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn dense(&mut self, system: &InMode<'_, S, T>, step: &Step<T, N>, work: &mut Statistics) -> &[SVector<T, N>] {
        match STAGES {
            2 => self.coefficients[..Self::DEGREE].copy_from_slice(&hermite::cubic(system, step, work)),
            3 => self.coefficients[..Self::DEGREE].copy_from_slice(&hermite::quintic(system, step, work)),
            _ => self.interpolate(step),
        }
        Scheme::<S, T, N>::coefficients(self)
    }

    fn coefficients(&self) -> &[SVector<T, N>] {
        &self.coefficients[..Self::DEGREE]
    }
}

/// Rounded sum, and its rounding error (D. E. Knuth, "The Art of Computer Programming 2", 4.2.2, Theorem B).
#[cfg_attr(not(debug_assertions), inline(always))]
fn sum_and_rest<T: Float, const N: usize>(a: &SVector<T, N>, b: &SVector<T, N>) -> (SVector<T, N>, SVector<T, N>) {
    let sum = a + b;
    let of_b = sum - a;
    let of_a = sum - of_b;
    (sum, (a - of_a) + (b - of_b))
}

/// Magnitude of the largest component; not finite if a component is not.
#[cfg_attr(not(debug_assertions), inline(always))]
fn largest<T: Float, const N: usize>(vectors: &[SVector<T, N>]) -> T {
    // by components first, which do not wait for one another
    let (mut largest, mut sums) = ([T::default(); N], [T::default(); N]);
    for vector in vectors {
        for ((largest, sum), &component) in largest.iter_mut().zip(&mut sums).zip(vector) {
            *largest = largest.max(component.abs());
            *sum += component;
        }
    }
    let (mut all, mut sum) = (T::default(), T::default());
    for (largest, of_component) in largest.into_iter().zip(sums) {
        all = all.max(largest);
        sum += of_component;
    }
    // the maximum of a number and NaN is the number
    if sum.is_finite() { all } else { sum }
}
