//! Modes that inputs do not reach or outputs do not show, in the components of the state.

use std::fmt;

use nalgebra::{Complex, DMatrix, DVector, SVector};

use super::reach::Mode;

/// Modes that are lost to inputs or outputs.
#[derive(Clone, Debug, PartialEq)]
pub struct LostModes<const N: usize> {
    /// The modes. Each of a complex pair is listed.
    pub modes: Vec<LostMode<N>>,
    /// True for the modes of a sampled model, whose eigenvalues have no unit.
    pub is_sampled: bool,
    /// Names of the components of the state; empty if the model has no layout.
    pub names: Vec<String>,
}

/// A mode that is lost to inputs or outputs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LostMode<const N: usize> {
    /// Eigenvalue, in 1/s for a continuous model.
    pub eigenvalue: Complex<f64>,
    /// Direction, scaled so that its largest component is 1: for inputs a left eigenvector `w`, where `w^T x` (without
    /// conjugation) does not depend on the inputs; for outputs a right eigenvector `v`, of which they show nothing.
    pub direction: SVector<Complex<f64>, N>,
}

/// Test of each mode of a linear model by the criterion of Popov, Belevitch and Hautus: the eigenvalue `lambda` is
/// controllable if `[A - lambda I, B]` has full rank, and observable if `[A - lambda I; C]` has.
///
/// T. Kailath, "Linear Systems" (1980), 2.4.3.
#[derive(Clone, Debug, PartialEq)]
pub struct PbhTest<const N: usize> {
    /// Each mode with its margin, in the order of [`Spectrum::modes`](crate::stability::Spectrum::modes).
    pub margins: Vec<ModeMargin>,
    /// Modes that are lost, by a separation of the controllable or observable subspace, after scaling of states and
    /// inputs to similar effects. A direction that is outside of it by less than 1e-10 counts as inside. An entry of
    /// `A` counts as zero below 1e-12 of the largest in its row or column, or 1e-16 of the largest of all, and an input
    /// or output whose scaled effect is below 1e-16 of the largest one counts as absent.
    pub lost: LostModes<N>,
}

/// An eigenvalue with its distance from being lost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ModeMargin {
    /// Eigenvalue, in 1/s for a continuous model.
    pub eigenvalue: Complex<f64>,
    /// Smallest singular value of `[A - lambda I, B]` or `[A - lambda I; C]`: the norm of the smallest change of the
    /// matrices after which the mode is lost. It depends on the units of state, inputs and outputs.
    ///
    /// R. Eising, Syst. Control Lett. 4 (1984) 263.
    pub margin: f64,
}

impl<const N: usize> PbhTest<N> {
    /// True if no mode is lost: the pair is controllable, or observable.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.lost.modes.is_empty()
    }

    /// Smallest margin of all modes; infinite if there are none.
    #[must_use]
    pub fn least_margin(&self) -> f64 {
        self.margins
            .iter()
            .map(|mode| mode.margin)
            .fold(f64::INFINITY, f64::min)
    }
}

impl<const N: usize> LostModes<N> {
    /// Modes of a model restricted to the span of `basis`.
    pub(super) fn new(modes: Vec<Mode>, basis: &DMatrix<f64>, is_sampled: bool, names: Vec<String>) -> Self {
        let lifted = basis.map(Complex::from);
        let placed = |mode: Mode| {
            let direction: DVector<Complex<f64>> = &lifted * mode.direction;
            let largest = direction[direction.map(Complex::norm).imax()];
            LostMode {
                eigenvalue: mode.eigenvalue,
                direction: SVector::from_fn(|n, _| direction[n] / largest),
            }
        };
        Self {
            modes: modes.into_iter().map(placed).collect(),
            is_sampled,
            names,
        }
    }
}

/// Ratio to the largest component below which components are left out of messages.
const SHOWN: f64 = 1e-3;

/// Parts of eigenvalues below this are rounding errors in messages, in 1/s or relative to the eigenvalue.
const ZERO_RATE: f64 = 1e-12;

/// A number with 3 significant digits at most.
struct Short(f64);

impl fmt::Display for Short {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let rounded = format!("{:.2e}", self.0).parse().unwrap_or(self.0);
        // Zero has no sign.
        match f64::abs(rounded) {
            0.0 => f.write_str("0"),
            1e-3..1e4 => write!(f, "{rounded}"),
            _ => write!(f, "{rounded:e}"),
        }
    }
}

/// "1 mode: 3.13 1/s along theta + 0.319 dot(theta)"; the second one of a complex pair is left out.
impl<const N: usize> fmt::Display for LostModes<N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let unit = if self.is_sampled { "" } else { " 1/s" };
        write!(f, "{} mode{}", self.modes.len(), self.agree("", "s"))?;
        for (n, mode) in self.modes.iter().filter(|mode| mode.eigenvalue.im >= 0.0).enumerate() {
            let separator = if n == 0 { ":" } else { "," };
            let Complex { re, im } = mode.eigenvalue;
            let least = ZERO_RATE * mode.eigenvalue.norm().max(1.0);
            let [re, im] = [re, im].map(|part| if part.abs() < least { 0.0 } else { part });
            if im == 0.0 {
                write!(f, "{separator} {}{unit} along ", Short(re))?;
            } else {
                write!(f, "{separator} ({} +- {}i){unit} along ", Short(re), Short(im))?;
            }
            self.direction(f, &mode.direction)?;
        }
        Ok(())
    }
}

impl<const N: usize> LostModes<N> {
    /// Word in agreement with the number of modes.
    pub(super) fn agree(&self, one: &'static str, several: &'static str) -> &'static str {
        if self.modes.len() == 1 { one } else { several }
    }

    fn direction(&self, f: &mut fmt::Formatter<'_>, direction: &SVector<Complex<f64>, N>) -> fmt::Result {
        let shown = direction
            .iter()
            .enumerate()
            .filter(|(_, component)| component.norm() >= SHOWN);
        for (n, (index, &Complex { re, im })) in shown.enumerate() {
            let sign = match (n, re < 0.0 && im.abs() < SHOWN) {
                (0, false) => "",
                (0, true) => "-",
                (_, false) => " + ",
                (_, true) => " - ",
            };
            f.write_str(sign)?;
            if im.abs() >= SHOWN {
                let re = if re.abs() < SHOWN { 0.0 } else { re };
                let sign = if im < 0.0 { "-" } else { "+" };
                write!(f, "({}{sign}{}i) ", Short(re), Short(im.abs()))?;
            } else if (re.abs() - 1.0).abs() >= SHOWN {
                write!(f, "{} ", Short(re.abs()))?;
            }
            match self.names.get(index) {
                Some(name) => f.write_str(name)?,
                None => write!(f, "x[{index}]")?,
            }
        }
        Ok(())
    }
}
