//! Cells, each a problem and an error to reach: who is the first.

use serde::Serialize;
use twelve::OURS;

use super::results::{Curve, Measure};
use super::sweep::{Setting, median};

/// Relative errors to reach.
pub(crate) const TARGETS: [f64; 10] = [1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13];
/// Ratio up to which times are taken as equal, and the largest that is accepted.
pub(crate) const LIMITS: [f64; 2] = [1.1, 1.5];
/// An error to reach is at least this many times the uncertainty of the reference.
const KNOWN: f64 = 2.0;

/// The fastest of our methods and of the peers with at most an error.
#[derive(Clone, Serialize)]
pub(crate) struct Cell {
    pub target: f64,
    pub ours: Option<Fastest>,
    pub peer: Option<Fastest>,
    /// Our time over the peer's, from the least times; 0 without a peer, infinite without one of ours.
    pub ratio: f64,
    /// Median of this ratio over the rounds in which both were measured, or the same if one was soon left out.
    pub paired: f64,
}

#[derive(Clone, Serialize)]
pub(crate) struct Fastest {
    pub by: &'static str,
    pub method: &'static str,
    pub tolerance: f64,
    pub nanoseconds: f64,
}

/// Cells of a problem whose errors are known well enough, and that any method reaches.
pub(crate) fn cells(curves: &[Curve], settings: &[Setting], measure: Measure, uncertainty: f64) -> Vec<Cell> {
    let known = TARGETS.into_iter().filter(|target| *target >= KNOWN * uncertainty);
    let cell = |target: f64| {
        let fastest = |is_ours: bool| {
            let reaching = settings.iter().filter(|setting| {
                setting.point.error(measure) <= target && (curves[setting.curve].by == OURS) == is_ours
            });
            reaching.min_by(|a, b| a.point.least.total_cmp(&b.point.least))
        };
        let named = |setting: &Setting| {
            let (curve, point) = (&curves[setting.curve], setting.point);
            Fastest {
                by: curve.by,
                method: curve.method,
                tolerance: point.tolerance,
                nanoseconds: point.least,
            }
        };
        let (ours, peer) = (fastest(true), fastest(false));
        let (ratio, paired) = match (ours, peer) {
            (Some(ours), Some(peer)) => (ours.point.least / peer.point.least, paired(ours, peer)),
            (Some(_), None) => (0.0, 0.0),
            (None, Some(_)) => (f64::INFINITY, f64::INFINITY),
            (None, None) => return None,
        };
        Some(Cell {
            target,
            ours: ours.map(named),
            peer: peer.map(named),
            ratio,
            paired,
        })
    };
    known.filter_map(cell).collect()
}

/// Median ratio of samples of the same rounds, if there are as many of both.
fn paired(ours: &Setting, peer: &Setting) -> f64 {
    if ours.samples.len() != peer.samples.len() {
        return ours.point.least / peer.point.least;
    }
    median(ours.samples.iter().zip(&peer.samples).map(|(a, b)| a / b).collect())
}
