//! Many motions of one mechanism, which begin near each other.

use pendulum_runtime::{Ensemble, Error, Members, Method, Model};

use crate::message::{Accuracy, Moved};
use crate::{drag, frames};

/// Longest step, in s.
const LONGEST: f64 = 1.0 / 240.0;
/// Number of times that the longest step may be halved.
const MOST_HALVINGS: u32 = 4;
/// Largest error of a span, relative to the size of a component where this is above 1.
const LARGEST_ERROR: f64 = 1e-5;
/// Part of the largest error below which steps become longer: one of twice the length has 16 times the error.
const SMALL: f64 = 1.0 / 32.0;

/// States of the motions, one after the other.
#[derive(Debug)]
pub(crate) struct Crowd {
    x: Vec<f64>,
    halvings: u32,
}

impl Crowd {
    /// Motions about a state, that differ by up to `spread`.
    pub(crate) fn new(model: &Model, t: f64, x: &[f64], count: usize, spread: f64) -> Result<Self, Error> {
        let mut all = Vec::with_capacity(count * x.len());
        for n in 0..count {
            let by = spread * (n as f64 / (count - 1).max(1) as f64 - 0.5);
            all.extend(drag::near(model, t, x, by)?);
        }
        Ok(Self { x: all, halvings: 0 })
    }

    /// Integrates all, and adds for each frame its time, and the lines of all motions: two points of each shape that
    /// moves and has them.
    pub(crate) fn go(
        &mut self,
        model: &Model,
        span: [f64; 2],
        frames: usize,
        numbers: &mut Vec<f64>,
    ) -> Result<Moved, Error> {
        let times = frames::times(span, frames);
        let accuracy = self.choose_step(model, span)?;
        let all = integrated(model, accuracy.h, span, &self.x, &times)?;
        let length = model.components().len();
        let count = self.x.len() / length.max(1);
        for (n, &t) in times.iter().enumerate() {
            numbers.push(t);
            for k in 0..count {
                let place = (k * times.len() + n) * length;
                for shape in frames::shapes(model, t, &all.samples[place..place + length])? {
                    if let ([from, to, ..], true) = (&shape.points[..], frames::moves(&shape)) {
                        numbers.extend([from.x, from.y, from.z, to.x, to.y, to.z]);
                    }
                }
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
            accuracy: Some(accuracy),
            ..Moved::default()
        })
    }

    /// Chooses the length of steps by the error of the first motion, the middle one and the last one.
    fn choose_step(&mut self, model: &Model, span: [f64; 2]) -> Result<Accuracy, Error> {
        let length = model.components().len().max(1);
        let count = self.x.len() / length;
        let some = [0, count / 2, count.saturating_sub(1)];
        let starts: Vec<f64> = some
            .iter()
            .flat_map(|n| self.x.iter().skip(n * length).take(length))
            .copied()
            .collect();
        let ends = |halvings| integrated(model, step(halvings), span, &starts, &[]).map(|all| all.ends);
        let mut now = ends(self.halvings)?;
        loop {
            let finer = ends(self.halvings + 1)?;
            let error = error(&now, &finer);
            let accuracy = Accuracy {
                h: step(self.halvings),
                error,
            };
            if error > LARGEST_ERROR && self.halvings < MOST_HALVINGS {
                self.halvings += 1;
                now = finer;
                continue;
            }
            if error < SMALL * LARGEST_ERROR {
                self.halvings = self.halvings.saturating_sub(1);
            }
            return Ok(accuracy);
        }
    }
}

/// Length of steps, in s.
fn step(halvings: u32) -> f64 {
    LONGEST / f64::from(1 << halvings)
}

fn integrated(model: &Model, h: f64, span: [f64; 2], starts: &[f64], times: &[f64]) -> Result<Ensemble, Error> {
    let members = Members {
        starts,
        parameters: None,
        laws: &[],
        times,
        cancel: None,
    };
    model.ensemble(&Method::new("Rk4")?.h(h), span, &members)
}

/// Error of states, by those of steps of half the length (Richardson 1911): relative where a component is above 1.
fn error(x: &[f64], finer: &[f64]) -> f64 {
    let of = |(x, finer): (&f64, &f64)| 16.0 / 15.0 * (x - finer).abs() / finer.abs().max(1.0);
    let larger = |a: f64, b: f64| if b.is_nan() { f64::INFINITY } else { a.max(b) };
    x.iter().zip(finer).map(of).fold(0.0, larger)
}
