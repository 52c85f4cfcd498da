//! Bodies that follow a hand.

use nalgebra::{DMatrix, DVector, Point3, Vector3};
use pendulum_runtime::{Error, Model, SlotKind};

use crate::frames;
use crate::start::can_move;

/// Most steps that are tried towards the hand.
const TRIES: usize = 60;
/// Damping at first, relative to the squares of the derivatives.
const LEAST: f64 = 1e-9;
/// Shortest step towards the hand, in m.
const GAIN: f64 = 1e-6;
/// Change of a coordinate in a difference quotient, in rad or m.
const DIFFERENCE: f64 = 1e-6;

/// Returns the state at rest in which a point of a shape is as near as possible to a place on the screen. Loops remain
/// closed, and joints within their stops.
pub(crate) fn dragged(
    model: &Model,
    t: f64,
    x: &[f64],
    (shape, point): (usize, usize),
    to: [f64; 2],
    view: [[f64; 3]; 2],
) -> Result<Vec<f64>, Error> {
    let view = view.map(|[x, y, z]| Vector3::new(x, y, z));
    let missing = |x: &[f64]| -> Result<DVector<f64>, Error> {
        let shapes = frames::shapes(model, t, x)?;
        let at = shapes.get(shape).and_then(|shape| shape.points.get(point));
        let at = at.copied().unwrap_or_else(Point3::origin).coords;
        Ok(DVector::from_fn(2, |n, _| to[n] - view[n].dot(&at)))
    };
    let mut now = x.to_vec();
    // friction and inertia do not count: the hand is strong
    for slot in model.layout().slots {
        now[slot.rates.clone()].fill(0.0);
    }
    let mut left = missing(&now)?;
    let mut damping = LEAST;
    let mut slope = slopes(model, t, &now, &left, &missing)?;
    for _ in 0..TRIES {
        // Levenberg and Marquardt: the shortest change of the coordinates that leads there, the shorter the more damped
        let normal = &slope * slope.transpose();
        let scale = damping * normal.trace() + f64::MIN_POSITIVE;
        let Some(solved) = (normal + DMatrix::identity(2, 2) * scale).lu().solve(&left) else {
            break;
        };
        let next = changed(model, t, &now, &(slope.transpose() * solved));
        let rest = next.and_then(|next| Ok((missing(&next)?, next)));
        match rest {
            Ok((rest, next)) if rest.norm() < left.norm() && can_move(model, t, &next) => {
                let gained = left.norm() - rest.norm();
                (now, left) = (next, rest);
                if gained < GAIN {
                    break;
                }
                slope = slopes(model, t, &now, &left, &missing)?;
                damping = LEAST.max(damping / 10.0);
            }
            _ => damping *= 10.0,
        }
    }
    Ok(now)
}

/// Derivatives of the place on the screen by the independent coordinates.
fn slopes(
    model: &Model,
    t: f64,
    x: &[f64],
    left: &DVector<f64>,
    missing: &impl Fn(&[f64]) -> Result<DVector<f64>, Error>,
) -> Result<DMatrix<f64>, Error> {
    let count = freedoms(model);
    let mut slopes = DMatrix::zeros(2, count);
    for n in 0..count {
        let change = DVector::from_fn(count, |k, _| if k == n { DIFFERENCE } else { 0.0 });
        // where the loops cannot follow, the coordinate stays
        if let Ok(x) = changed(model, t, x, &change) {
            slopes.set_column(n, &((left - missing(&x)?) / DIFFERENCE));
        }
    }
    Ok(slopes)
}

/// Number of independent changes of the coordinates: as many as rates.
fn freedoms(model: &Model) -> usize {
    model.layout().slots.iter().map(|slot| slot.rates.len()).sum()
}

/// State near another: the first coordinate differs, or the orientation about its first axis.
pub(crate) fn near(model: &Model, t: f64, x: &[f64], by: f64) -> Result<Vec<f64>, Error> {
    let change = DVector::from_fn(freedoms(model), |n, _| if n == 0 { by } else { 0.0 });
    changed(model, t, x, &change)
}

/// State in which loops are closed and orientations have unit length.
pub(crate) fn placed(model: &Model, t: f64, mut x: Vec<f64>) -> Result<Vec<f64>, Error> {
    for place in model.layout().quaternions() {
        let Some(own) = x.get_mut(place) else { continue };
        let length = own.iter().map(|own| own * own).sum::<f64>().sqrt();
        if length > 0.0 {
            own.iter_mut().for_each(|own| *own /= length);
        }
    }
    model.assemble(t, &x)
}

/// State after small changes of the independent coordinates: of an orientation, by the components of a rotation.
fn changed(model: &Model, t: f64, x: &[f64], change: &DVector<f64>) -> Result<Vec<f64>, Error> {
    let mut x = x.to_vec();
    let mut changes = change.iter().copied();
    for slot in model.layout().slots {
        let own: Vec<f64> = changes.by_ref().take(slot.rates.len()).collect();
        let place = slot.positions.start;
        match (slot.kind, &own[..]) {
            (SlotKind::Quaternion, &[a, b, c]) => {
                let [w, i, j, k] = [x[place], x[place + 1], x[place + 2], x[place + 3]];
                let before = nalgebra::Quaternion::new(w, i, j, k);
                let by = nalgebra::UnitQuaternion::from_scaled_axis(Vector3::new(a, b, c));
                let after = (before * by.into_inner()).normalize();
                (x[place], x[place + 1], x[place + 2], x[place + 3]) = (after.w, after.i, after.j, after.k);
            }
            _ => own.iter().enumerate().for_each(|(n, own)| x[place + n] += own),
        }
    }
    model.assemble(t, &x)
}
