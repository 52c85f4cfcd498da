//! Derivatives of trajectories.

use nalgebra::{DMatrix, SVector};
use pendulum_core::dense::Dense;
use pendulum_core::dual::Dual;
use pendulum_core::sensitivity::{self, Variable};
use pendulum_core::{Observer, Rk4, Rodas5P, System, Vern9};

use crate::error::Error;
use crate::event::kinks;
use crate::method::{Kind, Method};
use crate::padded::{Padded, padded};
use crate::sampler::check_times;
use crate::worker::Cancel;

/// Number of derivatives that are carried at once.
pub(crate) const PART: usize = 8;
/// A number with that many derivatives.
pub(crate) type Tangent = Dual<f64, PART>;
/// Maximum number of parameters of a model whose trajectories are differentiated.
pub(crate) const MOST_PARAMETERS: usize = 64;

/// States at given times, with their derivatives.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Sensitivity {
    /// States, one for each time.
    pub x: Vec<Vec<f64>>,
    /// Derivatives at each time: a row for each component, a column for each variable.
    pub derivatives: Vec<DMatrix<f64>>,
}

/// Checks that there are not too many parameters.
pub(crate) fn check_parameters<const N: usize>(model: &Padded<f64, N>) -> Result<(), Error> {
    let length = model.params().len();
    (length <= MOST_PARAMETERS).then_some(()).ok_or(Error::TooLong {
        what: "the list of parameters",
        length,
        most: MOST_PARAMETERS,
    })
}

/// Integration with derivatives.
pub(crate) trait TaskWithDerivatives<const N: usize> {
    type Output;

    fn by(self, method: impl pendulum_core::Method<Padded<Tangent, N>, Tangent, N> + Sync) -> Self::Output;
}

impl Method {
    /// Integrates with derivatives.
    ///
    /// # Errors
    /// If the method has no derivatives here.
    pub(crate) fn run_with_derivatives<K, const N: usize>(&self, task: K) -> Result<K::Output, Error>
    where
        K: TaskWithDerivatives<N>,
    {
        match self.kind {
            Kind::Rk4 => Ok(task.by(Rk4::new(self.h.unwrap_or(f64::NAN)))),
            Kind::Vern9 => Ok(task.by(self.set(Vern9::new()))),
            Kind::Rodas5P => Ok(task.by(self.set(Rodas5P::new()))),
            _ => {
                let rule = "derivatives of trajectories are computed by `Vern9`, by `Rodas5P` for stiff systems, or \
                            by `Rk4` in steps of the samples of an input";
                Err(Error::setting("method", format!("{rule}, not by `{}`", self.name())))
            }
        }
    }
}

/// Samples of a trajectory in dual numbers.
struct Samples<'t, const N: usize> {
    cancel: &'t Cancel<'t>,
    times: &'t [f64],
    forward: bool,
    x: Vec<SVector<Tangent, N>>,
}

impl<const N: usize> Observer<Tangent, N> for Samples<'_, N> {
    fn is_cancelled(&self) -> bool {
        (self.cancel)()
    }

    fn start(&mut self, t: Tangent, x: &SVector<Tangent, N>) {
        let at_start = self.times.iter().take_while(|own| **own == t.value);
        self.x.extend(at_start.map(|_| *x));
    }

    fn step(&mut self, dense: &Dense<'_, Tangent, N>) {
        let end = dense.step().t1.value;
        while let Some(&t) = self.times.get(self.x.len())
            && (if self.forward { t <= end } else { t >= end })
        {
            self.x.push(dense.at(Dual::constant(t)));
        }
    }
}

struct Part<'m, const N: usize> {
    cancel: &'m Cancel<'m>,
    model: &'m Padded<f64, N>,
    times: &'m [f64],
    x0: SVector<f64, N>,
    by: [Variable; PART],
}

impl<const N: usize> TaskWithDerivatives<N> for Part<'_, N> {
    type Output = Result<Vec<SVector<Tangent, N>>, Error>;

    fn by(self, method: impl pendulum_core::Method<Padded<Tangent, N>, Tangent, N>) -> Self::Output {
        let (model, x0) = sensitivity::seeded::<_, N, MOST_PARAMETERS, PART>(self.model, self.x0, self.by);
        let (first, last) = (self.times[0], self.times[self.times.len() - 1]);
        let mut samples = Samples {
            cancel: self.cancel,
            times: self.times,
            forward: last >= first,
            x: Vec::with_capacity(self.times.len()),
        };
        let [t0, t1] = [first, last].map(Dual::constant);
        // as in fits, so that they share the code
        let mut observer: &mut dyn Observer<Tangent, N> = &mut samples;
        method.follow(&model, t0, t1, x0, &kinks(&model)?, &mut observer)?;
        Ok(samples.x)
    }
}

pub(crate) fn sensitivity<const N: usize>(
    model: &Padded<f64, N>,
    method: &Method,
    times: &[f64],
    x0: &[f64],
    (by, cancel): (&[Variable], &Cancel<'_>),
) -> Result<Sensitivity, Error> {
    check_parameters(model)?;
    let length = x0.len();
    let wrong = |what: &str, rule: &str| Err(Error::setting(what, rule));
    let (first, last) = match times {
        [first, .., last] if first != last => (first, last),
        _ => return wrong("times", "give the start and at least one other time"),
    };
    if by.is_empty() {
        return wrong("by", "name at least one parameter or component");
    }
    check_times(times, [*first, *last])?;
    let mut sensitivity = Sensitivity {
        x: Vec::new(),
        derivatives: vec![DMatrix::zeros(length, by.len()); times.len()],
    };
    for (n, variables) in by.chunks(PART).enumerate() {
        // the last part repeats a variable
        let by = std::array::from_fn(|k| variables.get(k).copied().unwrap_or(variables[0]));
        let x0 = padded(x0);
        let states = method.run_with_derivatives(Part {
            cancel,
            model,
            times,
            x0,
            by,
        })??;
        for (x, derivatives) in states.iter().zip(&mut sensitivity.derivatives) {
            for k in 0..variables.len() {
                let column = x.iter().take(length).map(|component| component.slopes[k]);
                column
                    .enumerate()
                    .for_each(|(row, slope)| derivatives[(row, n * PART + k)] = slope);
            }
        }
        let values = |x: &SVector<Tangent, N>| x.iter().take(length).map(|x| x.value).collect();
        sensitivity.x = states.iter().map(values).collect();
    }
    Ok(sensitivity)
}

/// Derivatives of all outputs by the state, at the time 0: a row for each output.
pub(crate) fn output_slopes<const N: usize>(model: &Padded<f64, N>, x: &[f64]) -> DMatrix<f64> {
    let mut slopes = DMatrix::zeros(model.tape().outputs().len(), x.len());
    for first in (0..x.len()).step_by(PART) {
        let by = std::array::from_fn(|k| Variable::Start((first + k).min(x.len() - 1)));
        let (model, x0) = sensitivity::seeded::<_, N, MOST_PARAMETERS, PART>(model, padded(x), by);
        let mut row = 0;
        model.each_output(Dual::constant(0.0), &x0, &mut |_, output: Tangent| {
            for k in 0..PART.min(x.len() - first) {
                slopes[(row, first + k)] = output.slopes[k];
            }
            row += 1;
        });
    }
    slopes
}
