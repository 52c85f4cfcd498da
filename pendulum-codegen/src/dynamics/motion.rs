//! Motion of links.

use super::flight::Flights;
use super::frames::Frame;
use super::joint::JointId;
use super::links::Link;
use crate::expr::Expr;
use crate::screw::{Mat3, Symmetric3, Twist, Vec3};

/// Motion of a link, in its frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct Motion<'g> {
    /// Angular velocity.
    pub(super) w: Vec3<'g>,
    /// Angular acceleration.
    alpha: Vec3<'g>,
    /// Acceleration of the origin less the acceleration of gravity.
    pub(super) a: Vec3<'g>,
    /// Acceleration of every other point relative to the origin, as a matrix that multiplies its position.
    pub(super) field: Mat3<'g>,
}

/// Computes the motion of the links for given accelerations along their joints. Accelerations of floating bodies are
/// relative to free fall.
///
/// In the frame of the link, with the offset o and the accelerations `a + U r` of the parent, and the velocities `w_J`
/// and `v_J` that the joint adds:
///
/// ```text
/// w = R^T w_p + w_J    alpha = R^T alpha_p + w x w_J + s_w qdd    a = R^T (a_p + U_p o) + 2 (R^T w_p) x v_J + s_v qdd
/// ```
pub(super) fn motions<'g>(
    links: &[Link<'g>],
    frames: &[Frame<'g>],
    flights: &Flights<'g>,
    gravity: Vec3<'g>,
    second_rates: &[Expr<'g>],
) -> Vec<Motion<'g>> {
    let mut motions: Vec<Motion<'g>> = Vec::new();
    let still = Vec3::zero(gravity.0[0].graph());
    for n in JointId::all(links.len()) {
        let (link, frame, second_rate) = (&links[n], &frames[n], second_rates[n]);
        let [w, alpha, a] = match (flights.from(n), link.parent.map(|parent| motions[parent])) {
            (Some(flight), _) => [
                still,
                still,
                flight.of_axes(flight.slides.map(|slide| second_rates[slide])),
            ],
            (None, Some(Motion { w, alpha, a, field })) => {
                [w, alpha, a + field * frame.offset].map(|v| frame.of_parent(v))
            }
            (None, None) => [still, still, frame.of_parent(-gravity)],
        };
        let Twist { angular, linear } = frame.velocity;
        let joint = second_rate * link.screw;
        let alpha = alpha + w.cross(angular) + joint.angular;
        let a = a + w.cross(2 * linear) + joint.linear;
        let w = w + angular;
        let field = acceleration_field(w, alpha);
        motions.push(Motion { w, alpha, a, field });
    }
    motions
}

/// Matrix `U` for which `U r` is the acceleration of a point at `r` relative to the origin: `alpha x r + w x (w x r)`.
pub(super) fn acceleration_field<'g>(w: Vec3<'g>, alpha: Vec3<'g>) -> Mat3<'g> {
    let square = w.0.map(|x| x.powi(2));
    Mat3::from_fn(|i, j| {
        if i == j {
            return -(square[(i + 1) % 3] + square[(i + 2) % 3]);
        }
        let (product, turning) = (w[i] * w[j], alpha[3 - i - j]);
        if (i + 1) % 3 == j {
            product - turning
        } else {
            product + turning
        }
    })
}

/// The moment `integral r x (U r) dm`, from the second moments of mass.
pub(super) fn inertial_moment<'g>(u: &Mat3<'g>, second: Symmetric3<'g>) -> Vec3<'g> {
    let s = second.full();
    Vec3([(1, 2), (2, 0), (0, 1)].map(|(i, j)| {
        // sum_k U_jk S_ik - U_ik S_jk; the two terms in S_ij are combined
        let k = 3 - i - j;
        let outer = [u[j][i] * s[i][i], u[j][k] * s[i][k]];
        let inner = [u[i][j] * s[j][j], u[i][k] * s[j][k]];
        let both = (u[j][j] - u[i][i]) * s[i][j];
        (outer[0] + outer[1]) - (inner[0] + inner[1]) + both
    }))
}
