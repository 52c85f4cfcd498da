//! Models of all padded lengths behind one interface.

#[cfg(feature = "full")]
mod analyses;

use std::sync::Arc;

use nalgebra::DMatrix;
use pendulum_core::inputs::TimeTable;
use pendulum_core::shapes::{Shape, Shapes};
use pendulum_core::tape::{Given, HybridModel, ModelError, Tape};
use pendulum_core::{Energy, Jacobian, System};

#[cfg(feature = "full")]
use self::analyses::Analyses;
use crate::ensemble::{self, Ensemble, Members};
use crate::error::Error;
use crate::method::Method;
use crate::motion::{Motion, Stopped};
use crate::padded::{LONGEST, Padded, active, padded};
use crate::solve::{self, Options};

/// Builds the model of a tape.
pub(crate) fn build(tape: &Arc<Tape>, params: &[f64]) -> Result<Arc<dyn Engine>, Error> {
    macro_rules! first_that_fits {
        ($($length:literal)*) => { $(
            if tape.length() <= $length {
                return Ok(Arc::new(tape.padded::<$length, true>(params)?));
            }
        )* };
    }
    #[cfg(feature = "full")]
    first_that_fits!(4);
    first_that_fits!(8 16 32);
    #[cfg(feature = "full")]
    first_that_fits!(64);
    Err(Error::TooLong {
        what: "the state",
        length: tape.length(),
        most: LONGEST,
    })
}

/// Analyses of a padded model: none without the feature `full`.
#[cfg(not(feature = "full"))]
pub(crate) trait Analyses {}

#[cfg(not(feature = "full"))]
impl<const N: usize> Analyses for Padded<f64, N> {}

/// A padded model of any length.
pub(crate) trait Engine: Analyses + Send + Sync {
    fn params(&self) -> &[f64];
    fn inputs(&self) -> &[f64];
    fn laws(&self) -> Vec<(usize, TimeTable<1>)>;
    fn with_params(&self, params: &[f64]) -> Result<Arc<dyn Engine>, ModelError>;
    fn with_inputs(&self, inputs: &[f64], laws: Vec<(usize, TimeTable<1>)>) -> Arc<dyn Engine>;
    fn rhs(&self, t: f64, x: &[f64]) -> Vec<f64>;
    fn jacobian(&self, t: f64, x: &[f64]) -> DMatrix<f64>;
    fn energy(&self, t: f64, x: &[f64]) -> [f64; 2];
    fn outputs(&self, t: f64, x: &[f64]) -> Vec<f64>;
    fn evaluate(&self, routine: usize, t: f64, x: &[f64], given: &Given<'_, f64>) -> Vec<f64>;
    fn shapes(&self, t: f64, x: &[f64]) -> Vec<Shape<'_>>;
    fn assemble(&self, t: f64, x: &[f64]) -> Result<Vec<f64>, Error>;
    fn solve(&self, method: &Method, span: [f64; 2], x0: &[f64], options: &Options<'_>) -> Result<Motion, Stopped>;
    fn ensemble(&self, method: &Method, span: [f64; 2], members: &Members<'_>) -> Result<Ensemble, Error>;
}

impl<const N: usize> Engine for Padded<f64, N> {
    fn params(&self) -> &[f64] {
        self.params()
    }

    fn inputs(&self) -> &[f64] {
        self.inputs()
    }

    fn laws(&self) -> Vec<(usize, TimeTable<1>)> {
        self.input_laws().map(|(n, law)| (n, law.clone())).collect()
    }

    fn with_params(&self, params: &[f64]) -> Result<Arc<dyn Engine>, ModelError> {
        Ok(Arc::new(self.with_params(params)?))
    }

    fn with_inputs(&self, inputs: &[f64], laws: Vec<(usize, TimeTable<1>)>) -> Arc<dyn Engine> {
        let mut model = self.clone();
        model.set_inputs(inputs);
        model.set_laws(laws);
        Arc::new(model)
    }

    fn rhs(&self, t: f64, x: &[f64]) -> Vec<f64> {
        active(System::rhs(self, t, &padded(x)), x.len())
    }

    fn jacobian(&self, t: f64, x: &[f64]) -> DMatrix<f64> {
        let jacobian = Jacobian::jacobian(self, t, &padded(x));
        DMatrix::from_fn(x.len(), x.len(), |i, j| jacobian[(i, j)])
    }

    fn energy(&self, t: f64, x: &[f64]) -> [f64; 2] {
        let x = padded(x);
        [self.kinetic(t, &x), self.potential(t, &x)]
    }

    fn outputs(&self, t: f64, x: &[f64]) -> Vec<f64> {
        let mut outputs = Vec::with_capacity(self.tape().outputs().len());
        self.each_output(t, &padded(x), &mut |_, output| outputs.push(output));
        outputs
    }

    fn evaluate(&self, routine: usize, t: f64, x: &[f64], given: &Given<'_, f64>) -> Vec<f64> {
        let mut results = vec![0.0; self.tape().routines()[routine].results()];
        HybridModel::evaluate(self, routine, t, &padded(x), given, &mut results);
        results
    }

    fn shapes(&self, t: f64, x: &[f64]) -> Vec<Shape<'_>> {
        Shapes::shapes(self, t, &padded(x))
    }

    fn assemble(&self, t: f64, x: &[f64]) -> Result<Vec<f64>, Error> {
        Ok(active(HybridModel::assemble(self, t, &padded(x))?, x.len()))
    }

    fn solve(&self, method: &Method, span: [f64; 2], x0: &[f64], options: &Options<'_>) -> Result<Motion, Stopped> {
        solve::solve(self, method, span, x0, options)
    }

    fn ensemble(&self, method: &Method, span: [f64; 2], members: &Members<'_>) -> Result<Ensemble, Error> {
        ensemble::ensemble(self, method, span, members)
    }
}
