//! Many motions of one mechanism, which begin near each other.

use pendulum_runtime::{Error, Members, Method, Model};

use crate::message::Moved;
use crate::page::times;
use crate::{drag, frames};

/// States of the motions, one after the other.
#[derive(Debug)]
pub(crate) struct Crowd {
    x: Vec<f64>,
}

impl Crowd {
    /// Motions about a state, that differ by up to `spread`.
    pub(crate) fn new(model: &Model, t: f64, x: &[f64], count: usize, spread: f64) -> Result<Self, Error> {
        let mut all = Vec::with_capacity(count * x.len());
        for n in 0..count {
            let by = spread * (n as f64 / (count - 1).max(1) as f64 - 0.5);
            all.extend(drag::near(model, t, x, by)?);
        }
        Ok(Self { x: all })
    }

    /// Integrates all, and adds for each frame its time, and the shapes of all motions.
    pub(crate) fn go(
        &mut self,
        model: &Model,
        method: &Method,
        span: [f64; 2],
        frames: usize,
        numbers: &mut Vec<f64>,
    ) -> Result<Moved, Error> {
        let times = times(span, frames);
        let members = Members {
            starts: &self.x,
            parameters: None,
            times: &times,
            cancel: None,
        };
        let all = model.ensemble(method, span, &members)?;
        let length = model.components().len();
        let count = self.x.len() / length.max(1);
        for (n, &t) in times.iter().enumerate() {
            numbers.push(t);
            for k in 0..count {
                let place = (k * times.len() + n) * length;
                frames::push_shapes(numbers, model, t, &all.samples[place..place + length])?;
            }
        }
        self.x = all.ends;
        let stopped = all.stopped.first().map(|(n, t, reason)| {
            let many = all.stopped.len();
            format!("{many} of {count} motions stopped; motion {n} at t = {t:?}: {reason}")
        });
        Ok(Moved {
            width: numbers.len() / times.len().max(1),
            t: span[1],
            stopped,
            ..Moved::default()
        })
    }
}
