//! Hybrid systems without friction.

use nalgebra::{SMatrix, SVector};

use crate::hybrid::{
    self, Hold, HybridJacobian, Kinematics, MAX_CONSTRAINTS, Mode, Status, apart, forces, independent,
    place_coordinates, project, set_of,
};
use crate::layout::StateLayout;
use crate::system::{Jacobian, System};

/// A hybrid system without friction, which is discontinuous at rest, and with some constraints held at limits.
///
/// If the right-hand side of the mode does not depend on the distance from a limit, a spring of stiffness 1 pulls back
/// to the limit. The result then vanishes only at rest on the limits.
pub(super) struct Frictionless<'a, const N: usize> {
    system: &'a dyn HybridJacobian<f64, N>,
    layout: Option<StateLayout<'a>>,
    mode: Mode,
    hold: Hold<f64>,
}

impl<'a, const N: usize> Frictionless<'a, N> {
    /// Without held constraints; `layout` is the layout of the system.
    pub(super) fn new(system: &'a dyn HybridJacobian<f64, N>, layout: Option<StateLayout<'a>>) -> Self {
        let (mode, hold) = (Mode::default(), Hold::default());
        Self {
            system,
            layout,
            mode,
            hold,
        }
    }

    /// Holds all constraints that touch a limit in `mode`, about the state `x`.
    pub(super) fn at_limits(self, mode: Mode, x: &SVector<f64, N>) -> Self {
        let system = self.system;
        let held = set_of((0..MAX_CONSTRAINTS).filter(|&n| mode.0[n].touches()));
        let solved = independent(&system.response(0.0, x, &[0.0; MAX_CONSTRAINTS]).matrix, held);
        let forces = [0.0; MAX_CONSTRAINTS];
        let hold = Hold { forces, held, solved };
        Self { mode, hold, ..self }
    }

    /// Projects to an exact state of rest: zero rates, exactly on the limits.
    pub(super) fn place(&self, mut x: SVector<f64, N>) -> SVector<f64, N> {
        Kinematics::of(self.system).rates().for_each(|n| x[n] = 0.0);
        project(self.system, &self.hold, &self.mode.0, 0.0, &mut x);
        place_coordinates(self.system, &self.mode.0, 0.0, &mut x);
        x
    }

    /// Constraint farthest beyond a limit, and the status of that limit.
    pub(super) fn beyond(&self, x: &SVector<f64, N>) -> Option<(usize, Status)> {
        let (laws, measures) = (self.system.laws(), self.system.measures(0.0, x));
        let beyond = (0..MAX_CONSTRAINTS)
            .filter(|&n| !self.mode.0[n].touches())
            .flat_map(|n| {
                let value = measures[n][0];
                let low = laws[n].low.map(|low| (low - value, n, Status::Low));
                [low, laws[n].high.map(|high| (value - high, n, Status::High))]
            });
        let beyond = beyond.flatten().filter(|&(by, ..)| by > 0.0);
        let farthest = beyond.max_by(|(a, ..), (b, ..)| a.total_cmp(b));
        farthest.map(|(_, n, status)| (n, status))
    }

    /// Held constraint with the largest tensile force at its limit, which a stop or wall cannot exert. Only forces that
    /// cause an acceleration above `slack` count.
    pub(super) fn pulled(&self, x: &SVector<f64, N>, slack: f64) -> Option<usize> {
        let (forces, response) = (
            forces(self.system, &self.hold, 0.0, x),
            self.system.response(0.0, x, &[0.0; MAX_CONSTRAINTS]),
        );
        let pulls = (0..MAX_CONSTRAINTS).map(|n| match self.mode.0[n] {
            Status::Low => (-forces[n] * response.matrix[n][n], n),
            Status::High => (forces[n] * response.matrix[n][n], n),
            _ => (0.0, n),
        });
        let most = pulls.max_by(|(a, _), (b, _)| a.total_cmp(b));
        most.filter(|&(pull, _)| pull > slack).map(|(_, n)| n)
    }

    /// Iterates over the constraints held by a force: the distance from the limit, and the response to a unit force.
    fn apart(&self, x: &SVector<f64, N>) -> impl Iterator<Item = (usize, f64, SVector<f64, N>)> {
        let (laws, mode, solved) = (self.system.laws(), self.mode, self.hold.solved);
        let at = (solved != 0).then(|| {
            (
                self.system.measures(0.0, x),
                self.system.response(0.0, x, &[0.0; MAX_CONSTRAINTS]),
            )
        });
        at.into_iter().flat_map(move |(measures, response)| {
            let apart = apart(&laws, &mode.0, &measures);
            let held = (0..MAX_CONSTRAINTS).filter(move |n| solved & 1 << n != 0);
            held.map(move |n| (n, apart[n], response.columns[n]))
        })
    }
}

impl<const N: usize> System<f64, N> for Frictionless<'_, N> {
    fn rhs(&self, t: f64, x: &SVector<f64, N>) -> SVector<f64, N> {
        let rates = hybrid::rhs(self.system, &self.hold, t, x);
        self.apart(x)
            .fold(rates, |rates, (_, apart, column)| rates - column * apart)
    }

    fn active(&self) -> usize {
        self.layout.map_or(N, StateLayout::length)
    }

    fn layout(&self) -> Option<StateLayout<'_>> {
        self.layout
    }

    fn project(&self, _t: f64, x: &mut SVector<f64, N>) {
        if let Some(layout) = self.layout {
            layout.normalise(x);
        }
    }
}

impl<const N: usize> Jacobian<f64, N> for Frictionless<'_, N> {
    fn jacobian(&self, t: f64, x: &SVector<f64, N>) -> SMatrix<f64, N, N> {
        self.rhs_and_jacobian(t, x).1
    }

    /// The derivative of the response columns is omitted: its factor is zero on the limit.
    fn rhs_and_jacobian(&self, t: f64, x: &SVector<f64, N>) -> (SVector<f64, N>, SMatrix<f64, N, N>) {
        let (mut rates, mut jacobian) = hybrid::rhs_and_jacobian(self.system, &self.hold, t, x);
        for (n, apart, column) in self.apart(x) {
            let [value, _] = self.system.measure_derivatives(t, x).by_state[n];
            rates -= column * apart;
            jacobian -= column * value.transpose();
        }
        (rates, jacobian)
    }
}
