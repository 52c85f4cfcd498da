//! Error and time of every method at every tolerance.

use std::hint::black_box;
use std::time::{Duration, Instant};

use nalgebra::SVector;

use super::entrant::Entrant;
use super::lanes::{COUNT, Together, starts};
use super::results::{Curve, Point};
use super::scene::Scene;
use crate::timing::in_turns;

/// Time budget for all methods of a scene: one trajectory at a time, and in lanes.
const BUDGETS: [Duration; 2] = [Duration::from_secs(40), Duration::from_secs(15)];
/// Minimum duration of a pass, so that its setup is negligible.
const PASS: Duration = Duration::from_micros(200);

/// Tolerances from 1e-3 to 1e-14, two per decade.
pub(crate) fn tolerances() -> Vec<f64> {
    (6..=28).map(|half| 10.0_f64.powf(-0.5 * f64::from(half))).collect()
}

/// A setting that reached the end, ready to be timed.
struct Setting<'a> {
    curve: usize,
    point: Point,
    /// Number of trajectories in a pass.
    trajectories: usize,
    pass: Box<dyn Fn() + 'a>,
}

/// Measures one trajectory at a time, with all methods in turn.
pub(crate) fn alone(scene: &Scene, entrants: &[Entrant]) -> Vec<Curve> {
    let entrants: Vec<&Entrant> = entrants.iter().filter(|entrant| entrant.suits(scene)).collect();
    let mut curves: Vec<Curve> = entrants
        .iter()
        .map(|entrant| Curve::new(entrant.by, entrant.method))
        .collect();
    let mut settings = Vec::new();
    for (curve, entrant) in entrants.iter().enumerate() {
        for tolerance in tolerances() {
            let start = Instant::now();
            let end = match (entrant.integrate)(scene, tolerance, 1) {
                Ok(end) if scene.is_end(end.t) => end,
                Ok(end) => {
                    curves[curve]
                        .failures
                        .push((tolerance, format!("stopped at t = {}", end.t)));
                    continue;
                }
                Err(why) => {
                    curves[curve].failures.push((tolerance, why));
                    continue;
                }
            };
            let times = PASS.as_nanos().div_ceil(start.elapsed().as_nanos().max(1)) as usize;
            settings.push(Setting {
                curve,
                point: Point::new(tolerance, scene.error(&end.x), end.evaluations),
                trajectories: times,
                pass: Box::new(move || {
                    // It has not failed before.
                    let _ = black_box((entrant.integrate)(scene, tolerance, times));
                }),
            });
        }
    }
    time(settings, &mut curves, BUDGETS[0]);
    curves
}

/// Measures many trajectories at a time; the error is that of the first trajectory.
pub(crate) fn together(scene: &Scene, methods: &[Together]) -> Vec<Curve> {
    let mut curves: Vec<Curve> = methods
        .iter()
        .map(|method| Curve::new(method.by, method.method))
        .collect();
    let starts: &[SVector<f64, 4>] = &starts(scene);
    let mut settings = Vec::new();
    for (curve, method) in methods.iter().enumerate() {
        for tolerance in tolerances() {
            match (method.integrate)(scene, tolerance, starts) {
                Ok(ends) => settings.push(Setting {
                    curve,
                    point: Point::new(tolerance, scene.error(&ends[0].into()), None),
                    trajectories: COUNT,
                    pass: Box::new(move || {
                        let _ = black_box((method.integrate)(black_box(scene), tolerance, starts));
                    }),
                }),
                Err(why) => curves[curve].failures.push((tolerance, why)),
            }
        }
    }
    time(settings, &mut curves, BUDGETS[1]);
    curves
}

/// Measures the times, and adds the points to their curves.
fn time(settings: Vec<Setting<'_>>, curves: &mut [Curve], budget: Duration) {
    let passes: Vec<&dyn Fn()> = settings.iter().map(|setting| setting.pass.as_ref()).collect();
    let times = in_turns(&passes, 1, budget);
    for (setting, times) in settings.into_iter().zip(times) {
        let trajectories = setting.trajectories as f64;
        curves[setting.curve].points.push(Point {
            least: times.least() / trajectories,
            median: times.median() / trajectories,
            ..setting.point
        });
    }
}
