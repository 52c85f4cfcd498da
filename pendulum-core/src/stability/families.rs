//! Equilibria and periodic orbits of a family of systems, as curves.

use nalgebra::{DMatrix, DVector, SMatrix, SVector};

use super::curve::{Curve, Growth, Linear, ROUNDING, Test};
use super::equilibrium::{require_as_many_rates, within_a_turn};
use super::orbit::NOISE;
use super::shooting::{Lap, after, check_period, direction, resolution};
use super::{BifurcationKind, Eigenmode, Equilibrium, Multiplier, PeriodicOrbit, StabilityError};
use crate::error::ParameterError;
use crate::layout::SlotKind;
use crate::system::{Jacobian, System};

/// A family of systems: one for each value of a parameter in a span.
pub(super) struct Family<'f, F> {
    pub(super) member: &'f F,
    pub(super) span: (f64, f64),
}

impl<F, S> Family<'_, F>
where
    F: Fn(f64) -> Result<S, ParameterError>,
{
    fn unit(&self) -> f64 {
        self.span.1 - self.span.0
    }

    /// Converts the scaled parameter back, exactly at the ends of the span.
    fn parameter(&self, scaled: f64) -> f64 {
        let parameter = scaled * self.unit();
        let is_at = |end: &f64| (parameter - end).abs() <= 1e-12 * self.unit();
        [self.span.0, self.span.1].into_iter().find(is_at).unwrap_or(parameter)
    }

    /// Derivative of `f` with respect to the scaled parameter: a central difference of half-width `reach` (as a
    /// fraction of the span), one-sided at the ends of the span.
    fn slope<const N: usize>(
        &self,
        parameter: f64,
        reach: f64,
        f: impl Fn(f64, &S) -> Result<SVector<f64, N>, StabilityError>,
    ) -> Result<SVector<f64, N>, StabilityError> {
        let reach = reach * self.unit();
        let low = (parameter - reach).max(self.span.0);
        let high = (parameter + reach).min(self.span.1);
        let change = f(high, &(self.member)(high)?)? - f(low, &(self.member)(low)?)?;
        Ok(change * (self.unit() / (high - low)))
    }
}

/// Curve of equilibria. The unknowns are the state and the parameter.
pub(super) struct EquilibriumCurve<'f, F, const N: usize> {
    pub(super) family: Family<'f, F>,
    pub(super) angles: Vec<usize>,
    pub(super) sizes: Scales<N>,
}

impl<F, S, const N: usize> Curve<N> for EquilibriumCurve<'_, F, N>
where
    F: Fn(f64) -> Result<S, ParameterError>,
    S: Jacobian<f64, N>,
{
    type Solution = Equilibrium<N>;

    fn linearize(&self, u: &DVector<f64>) -> Result<Linear, StabilityError> {
        let (x, parameter) = (self.sizes.state(u), self.family.parameter(u[N]));
        let system = (self.family.member)(parameter)?;
        require_as_many_rates(&system)?;
        let (rhs, jacobian) = system.rhs_and_jacobian(0.0, &x);
        let slope = self
            .family
            .slope(parameter, Curve::<N>::reach(self), |_, system| Ok(system.rhs(0.0, &x)))?;
        let (rhs, slope) = (self.sizes.scaled(&rhs), self.sizes.scaled(&slope));
        let jacobian = self.sizes.scaled_matrix(&jacobian);
        Ok(Linear {
            residual: DVector::from_column_slice(rhs.as_slice()),
            derivative: DMatrix::from_fn(N, N + 1, |i, j| if j < N { jacobian[(i, j)] } else { slope[i] }),
            resolution: 100.0 * f64::EPSILON * (jacobian.norm() + slope.norm()) * (1.0 + u.norm()),
        })
    }

    fn solution(&self, u: &DVector<f64>) -> Result<Equilibrium<N>, StabilityError> {
        Equilibrium::at(&(self.family.member)(self.family.parameter(u[N]))?, self.sizes.state(u))
    }

    fn growths(&self, solution: &Equilibrium<N>) -> Vec<Growth> {
        let growth = |mode: &Eigenmode<N>| Growth {
            excess: mode.growth_rate(),
            uncertainty: mode.uncertainty,
            rounding: mode.uncertainty,
            value: mode.eigenvalue,
        };
        solution.spectrum.modes().iter().map(growth).collect()
    }

    fn of_pair(&self, growth: &Growth) -> BifurcationKind {
        BifurcationKind::Hopf {
            angular_frequency: growth.value.im.abs(),
        }
    }

    const REAL_LIMIT: f64 = 0.0;

    fn doubling(&self, _solution: &Equilibrium<N>) -> Option<Test> {
        None
    }

    fn finer(&self) -> Option<Self> {
        None
    }

    fn reach(&self) -> f64 {
        libm::cbrt(f64::EPSILON)
    }

    fn joins(&self, _from: &DVector<f64>, _to: &DVector<f64>) -> Result<(), StabilityError> {
        Ok(())
    }

    fn apart(&self, from: &DVector<f64>, to: &DVector<f64>) -> DVector<f64> {
        self.sizes.without_turns(to - from, &self.angles)
    }

    fn noise(&self) -> f64 {
        1e-12
    }
}

/// Ratio of tolerances for the error estimate.
const FINER: f64 = 1e-2;
/// Tolerance below which only rounding errors remain.
const LEAST_TOLERANCE: f64 = 1e-14;

/// Curve of periodic orbits. The unknowns are the state, the ratio of the period to the initial one if the period is
/// free, and the parameter.
pub(super) struct OrbitCurve<'f, F, P, const N: usize> {
    pub(super) family: Family<'f, F>,
    pub(super) period: Period<&'f P>,
    pub(super) tolerance: f64,
    pub(super) angles: Vec<usize>,
    pub(super) sizes: Scales<N>,
}

/// Period of the orbits of a family.
#[derive(Clone, Copy)]
pub(super) enum Period<P> {
    /// Unknown, in units of the given value.
    Free(f64),
    /// Given as a function of the parameter.
    Given(P),
}

impl<F, P: Fn(f64) -> f64, const N: usize> OrbitCurve<'_, F, P, N> {
    fn period(&self, u: &DVector<f64>, parameter: f64) -> f64 {
        match self.period {
            Period::Free(unit) => u[u.len() - 2] * unit,
            Period::Given(period) => period(parameter),
        }
    }

    fn is_free(&self) -> bool {
        matches!(self.period, Period::Free(_))
    }
}

impl<F, S, P, const N: usize> Curve<N> for OrbitCurve<'_, F, P, N>
where
    F: Fn(f64) -> Result<S, ParameterError>,
    S: Jacobian<f64, N>,
    P: Fn(f64) -> f64,
{
    type Solution = PeriodicOrbit<N>;

    fn linearize(&self, u: &DVector<f64>) -> Result<Linear, StabilityError> {
        let (x, parameter) = (self.sizes.state(u), self.family.parameter(u[u.len() - 1]));
        let system = (self.family.member)(parameter)?;
        let period = self.period(u, parameter);
        check_period(period)?;
        let lap = Lap::run(&system, (x, period), self.tolerance, &self.angles)?;
        let slope = self
            .family
            .slope(parameter, Curve::<N>::reach(self), |parameter, system| {
                let period = self.period(u, parameter);
                check_period(period)?;
                Ok(after(system, (x, period), self.tolerance)?)
            })?;
        let (slope, monodromy) = (self.sizes.scaled(&slope), self.sizes.scaled_matrix(&lap.monodromy));
        let mut residual = DVector::from_column_slice(self.sizes.scaled(&lap.gap).as_slice());
        let mut derivative = DMatrix::from_fn(N, u.len(), |i, j| match j {
            j if j == i => monodromy[(i, j)] - 1.0,
            j if j < N => monodromy[(i, j)],
            j if j == u.len() - 1 => slope[i],
            _ => 0.0,
        });
        if let Period::Free(unit) = self.period {
            derivative
                .column_mut(N)
                .copy_from(&(self.sizes.scaled(&lap.velocity) * unit));
            // Phase condition: steps are normal to the orbit.
            let along = self
                .sizes
                .scaled(&direction(&system, &x, period, self.tolerance)?)
                .normalize();
            residual = residual.push(0.0);
            derivative = derivative.insert_row(N, 0.0);
            derivative.view_mut((N, 0), (1, N)).tr_copy_from(&along);
        }
        Ok(Linear {
            residual,
            derivative,
            resolution: resolution(&monodromy, &self.sizes.scaled(&x), self.tolerance),
        })
    }

    fn solution(&self, u: &DVector<f64>) -> Result<PeriodicOrbit<N>, StabilityError> {
        let (x, parameter) = (self.sizes.state(u), self.family.parameter(u[u.len() - 1]));
        let system = (self.family.member)(parameter)?;
        let period = self.period(u, parameter);
        let lap = Lap::run(&system, (x, period), self.tolerance, &self.angles)?;
        let along = self
            .is_free()
            .then(|| direction(&system, &x, period, self.tolerance))
            .transpose()?;
        PeriodicOrbit::new((x, period, lap.turns), lap.monodromy, along, self.tolerance)
    }

    fn growths(&self, solution: &PeriodicOrbit<N>) -> Vec<Growth> {
        let growth = |multiplier: &Multiplier| Growth {
            excess: multiplier.excess(),
            uncertainty: multiplier.uncertainty,
            rounding: multiplier.uncertainty * (ROUNDING / self.noise()).min(1.0),
            value: multiplier.value,
        };
        solution.nontrivial().iter().map(growth).collect()
    }

    fn of_pair(&self, growth: &Growth) -> BifurcationKind {
        BifurcationKind::Torus {
            angle: growth.value.arg().abs(),
        }
    }

    const REAL_LIMIT: f64 = 1.0;

    fn doubling(&self, solution: &PeriodicOrbit<N>) -> Option<Test> {
        let monodromy = self.sizes.scaled_matrix(&solution.monodromy);
        let monodromy = DMatrix::from_column_slice(N, N, monodromy.as_slice());
        let noise = ROUNDING * monodromy.norm();
        Some(Test::singular(monodromy + DMatrix::identity(N, N), noise))
    }

    fn finer(&self) -> Option<Self> {
        let tolerance = (FINER * self.tolerance).max(LEAST_TOLERANCE);
        let (member, span) = (self.family.member, self.family.span);
        Some(Self {
            family: Family { member, span },
            period: self.period,
            tolerance,
            angles: self.angles.clone(),
            sizes: self.sizes,
        })
    }

    fn reach(&self) -> f64 {
        libm::cbrt(self.tolerance)
    }

    /// Beyond an equilibrium to which orbits shrink, the same orbits repeat, shifted by half a period.
    fn joins(&self, from: &DVector<f64>, to: &DVector<f64>) -> Result<(), StabilityError> {
        if !self.is_free() {
            return Ok(());
        }
        let motion = |u: &DVector<f64>| {
            let parameter = self.family.parameter(u[u.len() - 1]);
            direction(
                &(self.family.member)(parameter)?,
                &self.sizes.state(u),
                self.period(u, parameter),
                self.tolerance,
            )
        };
        if motion(from)?.dot(&motion(to)?) > 0.0 {
            Ok(())
        } else {
            Err(StabilityError::AtRest)
        }
    }

    fn apart(&self, from: &DVector<f64>, to: &DVector<f64>) -> DVector<f64> {
        self.sizes.without_turns(to - from, &self.angles)
    }

    fn noise(&self) -> f64 {
        NOISE * self.tolerance
    }
}

/// Sizes of the components of a state, the units of steps along a branch.
#[derive(Clone, Copy)]
pub(super) struct Scales<const N: usize>(SVector<f64, N>);

impl<const N: usize> Scales<N> {
    /// Sizes for a scene with the characteristic length `length`. Angles have the size 1 rad, and rates are divided by
    /// `time`. All sizes are 1 without a layout.
    pub(super) fn of(system: &(impl System<f64, N> + ?Sized), length: f64, time: f64) -> Self {
        let mut sizes = SVector::from([1.0; N]);
        for slot in system.layout().map_or(&[][..], |layout| layout.slots) {
            let size = if slot.kind == SlotKind::Length { length } else { 1.0 };
            slot.positions.clone().for_each(|place| sizes[place] = size);
            slot.rates.clone().for_each(|place| sizes[place] = size / time);
        }
        Self(sizes)
    }

    /// State at a point of a curve.
    pub(super) fn state(&self, u: &DVector<f64>) -> SVector<f64, N> {
        SVector::from_fn(|i, _| u[i] * self.0[i])
    }

    pub(super) fn scaled(&self, x: &SVector<f64, N>) -> SVector<f64, N> {
        x.component_div(&self.0)
    }

    fn scaled_matrix(&self, matrix: &SMatrix<f64, N, N>) -> SMatrix<f64, N, N> {
        SMatrix::from_fn(|i, j| matrix[(i, j)] * self.0[j] / self.0[i])
    }

    fn without_turns(&self, mut apart: DVector<f64>, angles: &[usize]) -> DVector<f64> {
        for &angle in angles {
            apart[angle] = within_a_turn(apart[angle] * self.0[angle]) / self.0[angle];
        }
        apart
    }
}
