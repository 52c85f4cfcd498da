//! Base parameters: the smallest set of mass parameters that determines the motion of a model.

use super::links::{Link, links};
use crate::expr::Expr;
use crate::model::Model;
use crate::screw::{MassMoments, Symmetric3, Vec3};

/// Base parameters of a model (Gautier and Khalil 1990), without vanishing ones.
///
/// A link that turns has seven: two components of its first moment and five of its second moments. It has three if all
/// turning links below it turn about its own direction, and one if moreover nothing accelerates it across this
/// direction. A link that slides has its mass and its first moment. The set is minimal if all joints turn; with helical
/// joints, or slides among parallel axes, redundant combinations may remain.
pub(crate) fn base_parameters<'g>(model: &Model<'g>) -> Vec<Expr<'g>> {
    let links = links(model).links;
    let ground = Path {
        turning: Turning::Nothing,
        pushes: vec![model.gravity],
    };
    let mut paths: Vec<Path<'g>> = Vec::new();
    let mut parameters = Vec::new();
    for link in &links {
        let below = link.parent.map_or(&ground, |parent| &paths[parent]);
        let path = below.with(link);
        parameters.extend(path.sees(link));
        paths.push(path);
    }
    parameters.retain(|parameter| !parameter.is_zero());
    parameters
}

/// Motion that a link can have, in its own frame.
#[derive(Debug)]
struct Path<'g> {
    turning: Turning<'g>,
    /// Directions in which its origin can be accelerated, as long as it does not turn freely.
    pushes: Vec<Vec3<'g>>,
}

#[derive(Clone, Copy, Debug)]
enum Turning<'g> {
    Nothing,
    About(Vec3<'g>),
    Freely,
}

impl<'g> Path<'g> {
    /// Motion of a link carried by a link with this motion.
    fn with(&self, link: &Link<'g>) -> Self {
        let z = Vec3::z(link.force.graph());
        let back = link.placement.rotation.transpose();
        let mut pushes: Vec<Vec3<'g>> = self.pushes.iter().map(|&push| back * push).collect();
        let turning = match self.turning {
            Turning::About(axis) => {
                // a rotation moves every point off its axis
                pushes.push(back * link.placement.translation);
                Turning::About(back * axis)
            }
            other => other,
        };
        let turning = match (turning, link.turns()) {
            (Turning::Nothing, true) => Turning::About(z),
            (Turning::About(axis), true) if across(axis, z) => Turning::Freely,
            (turning, _) => turning,
        };
        if !link.turns() {
            pushes.push(z);
        }
        Self { turning, pushes }
    }

    /// Moments of a link that matter for this motion.
    fn sees(&self, link: &Link<'g>) -> Vec<Expr<'g>> {
        let MassMoments {
            mass,
            first: Vec3([hx, hy, hz]),
            second: Symmetric3([xx, yy, zz, xy, xz, yz]),
        } = link.inertia;
        match (link.turns(), self.turning) {
            (true, _) if !link.pitch().is_zero() => vec![mass, hx, hy, hz, xx, yy, zz, xy, xz, yz],
            (true, Turning::About(axis)) if self.pushes.iter().any(|&push| across(push, axis)) => {
                vec![hx, hy, xx + yy]
            }
            (true, Turning::About(_)) => vec![xx + yy],
            (true, _) => vec![hx, hy, xx, yy, xy, xz, yz],
            (false, Turning::Nothing) => vec![mass],
            (false, Turning::About(axis)) => {
                let first = [hx, hy, hz].into_iter().zip(axis.0);
                let along_axis = |x: Expr<'g>| x.is_one() || (-x).is_one();
                let across = first.filter(|(_, along)| !along_axis(*along)).map(|(h, _)| h);
                std::iter::once(mass).chain(across).collect()
            }
            (false, Turning::Freely) => vec![mass, hx, hy, hz],
        }
    }
}

/// True if two directions differ, other than in sign.
fn across<'g>(a: Vec3<'g>, b: Vec3<'g>) -> bool {
    !a.cross(b).is_zero()
}
