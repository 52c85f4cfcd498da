//! One sample after the other.

use nalgebra::SVector;

use super::legs::{Leg, Legs};
use super::noise::Noise;
use super::{Controller, MAX_DELAY, Outputs, Sampled};
use crate::error::Reason;
use crate::real::Float;

/// Number of commands that are kept: the one that acts, and the waiting ones. A power of two needs no division.
const KEPT: usize = (MAX_DELAY + 1).next_power_of_two();

/// A sample of a [`Sampled`] controller.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Sample<T, const P: usize, const M: usize> {
    /// Time of the measurement.
    pub t: T,
    /// Measurements, with their noise, rounded.
    pub measured: SVector<T, P>,
    /// Command of the controller.
    pub command: [T; M],
    /// Command after rounding and limits.
    pub sent: [T; M],
    /// Inputs of the model: what was sent, with noise.
    pub inputs: [T; M],
    /// Time from which the inputs act on the model.
    pub acts_from: T,
}

/// The controller of one trajectory: its memory, and the commands on their way.
#[derive(Clone)]
pub(super) struct Run<T, S, const M: usize> {
    state: S,
    noise: Noise,
    /// True without noise and resolutions.
    is_exact: bool,
    /// Inputs commanded by the last samples, at the number of each modulo the length.
    commanded: [[T; M]; KEPT],
    start: [T; M],
}

impl<C, W, const P: usize, const M: usize> Sampled<C, W, P, M> {
    /// The controller of a trajectory at its start.
    pub(super) fn run<T: Float>(&self, member: u64) -> Run<T, C::State, M>
    where
        C: Controller<T, P, M>,
    {
        let start = self.start.map(T::from_f64);
        Run {
            state: self.controller.start(T::from_f64(self.period)),
            noise: Noise::new(self.seed, member),
            is_exact: [
                &self.noise[..],
                &self.input_noise,
                &self.resolution,
                &self.input_resolution,
            ]
            .iter()
            .all(|deviations| deviations.iter().all(|&deviation| deviation == 0.0)),
            commanded: [start; KEPT],
            start,
        }
    }

    /// Takes a sample at the start of a leg, in the state `x`, and passes it to `keep`.
    #[inline(always)]
    pub(super) fn sample<T, const N: usize>(
        &self,
        run: &mut Run<T, C::State, M>,
        (leg, legs): (&Leg<T>, &Legs<T>),
        x: &SVector<T, N>,
        keep: impl FnOnce(Sample<T, P, M>),
    ) -> Result<(), Reason>
    where
        T: Float,
        C: Controller<T, P, M>,
        W: Outputs<T, N, P>,
    {
        let (t, k) = (leg.from, leg.sample);
        let mut measured = self.outputs.outputs(t, x);
        if !run.is_exact {
            self.disturb(&mut measured, run.noise, k);
        }
        let command = self.controller.sample(t, &measured, &mut run.state);
        let mut sent = command;
        for (input, sent) in sent.iter_mut().enumerate() {
            let (low, high) = (T::from_f64(self.low[input]), T::from_f64(self.high[input]));
            let mut is_finite = sent.is_finite();
            if !run.is_exact {
                *sent = rounded(*sent, self.input_resolution[input]);
                is_finite &= sent.is_finite();
            }
            if !is_finite {
                return Err(Reason::CommandNotFinite { input, t: t.to_f64() });
            }
            *sent = sent.at_least(low).at_most(high);
        }
        self.controller.sent(&command, &sent, &mut run.state);
        let mut inputs = sent;
        if !run.is_exact {
            for (m, input) in inputs
                .iter_mut()
                .enumerate()
                .filter(|&(m, _)| self.input_noise[m] > 0.0)
            {
                *input += T::from_f64(self.input_noise[m] * run.noise.normal(k, 2 * m + 1));
            }
        }
        run.commanded[k % KEPT] = inputs;
        keep(Sample {
            t,
            measured,
            command,
            sent,
            inputs,
            acts_from: legs.acts_from(k),
        });
        Ok(())
    }
}

impl<C, W, const P: usize, const M: usize> Sampled<C, W, P, M> {
    /// Adds noise to measurements, and rounds them.
    #[inline(never)]
    fn disturb<T: Float>(&self, measured: &mut SVector<T, P>, noise: Noise, sample: usize) {
        for (p, measured) in measured.iter_mut().enumerate() {
            if self.noise[p] > 0.0 {
                *measured += T::from_f64(self.noise[p] * noise.normal(sample, 2 * p));
            }
            *measured = rounded(*measured, self.resolution[p]);
        }
    }
}

impl<T: Copy, S, const M: usize> Run<T, S, M> {
    /// Inputs during a leg.
    #[inline(always)]
    pub(super) fn inputs(&self, leg: &Leg<T>) -> [T; M] {
        let acts = leg.sample.checked_sub(leg.lag);
        acts.map_or(self.start, |sample| self.commanded[sample % KEPT])
    }
}

/// The nearest multiple of `step`, without derivatives, or the number itself if `step` is 0.
#[inline(always)]
fn rounded<T: Float>(number: T, step: f64) -> T {
    if step == 0.0 {
        return number;
    }
    let [multiple] = number.piecewise(|number| [libm::rint(number / step) * step]);
    multiple
}
