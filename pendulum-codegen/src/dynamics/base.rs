//! Base parameters: the least number of quantities of its masses that the motion of a model depends on.

use super::links::{Link, links};
use crate::expr::{ExprId, Graph};
use crate::model::Model;
use crate::screw::{MassMoments, Symmetric3, Vec3, cross, mat_vec, transpose};

/// The base parameters of a model (Gautier and Khalil 1990), without those that are zero.
///
/// A link that turns has seven: two components of its first moment and five of its second moments. Where all that turns below it turns
/// about the same direction it has three, and one if nothing pushes it across that. A link that slides has its mass and its first
/// moment. Their number is the least one where all joints turn; helical joints, and slides among parallel axes, may have
/// combinations that are left standing.
pub fn base_parameters(model: &Model) -> Vec<ExprId> {
    let links = links(model);
    let (g, gravity) = (&model.graph, model.gravity);
    let mut paths: Vec<Path> = Vec::new();
    let mut parameters = Vec::new();
    for link in &links {
        let ground = Path {
            turning: Turning::Nothing,
            pushes: vec![gravity],
        };
        let below = link.parent.map_or(&ground, |parent| &paths[parent]);
        let path = below.with(g, link);
        parameters.extend(path.sees(g, link));
        paths.push(path);
    }
    parameters.retain(|&parameter| !g.is_zero(parameter));
    parameters
}

/// How a link can move, in its own frame.
#[derive(Debug)]
struct Path {
    turning: Turning,
    /// What accelerates its origin, as long as it does not turn freely.
    pushes: Vec<Vec3>,
}

#[derive(Clone, Copy, Debug)]
enum Turning {
    Nothing,
    About(Vec3),
    Freely,
}

impl Path {
    /// The motion of a link that a link with this motion carries.
    fn with(&self, g: &Graph, link: &Link) -> Self {
        let z = [g.zero(), g.zero(), g.one()];
        let back = transpose(link.placement.rotation);
        let mut pushes: Vec<Vec3> = self.pushes.iter().map(|&push| mat_vec(g, back, push)).collect();
        let turning = match self.turning {
            Turning::About(axis) => {
                // what turns moves every point that is off its axis
                pushes.push(mat_vec(g, back, link.placement.translation));
                Turning::About(mat_vec(g, back, axis))
            }
            other => other,
        };
        let turning = match (turning, link.turns) {
            (Turning::Nothing, true) => Turning::About(z),
            (Turning::About(axis), true) if across(g, axis, z) => Turning::Freely,
            (turning, _) => turning,
        };
        if !link.turns {
            pushes.push(z);
        }
        Self { turning, pushes }
    }

    /// The moments of a link that matter for this motion.
    fn sees(&self, g: &Graph, link: &Link) -> Vec<ExprId> {
        let MassMoments {
            mass,
            first: [hx, hy, hz],
            second: Symmetric3([xx, yy, zz, xy, xz, yz]),
        } = link.inertia;
        match (link.turns, self.turning) {
            (true, _) if !g.is_zero(link.pitch) => vec![mass, hx, hy, hz, xx, yy, zz, xy, xz, yz],
            (true, Turning::About(axis)) if self.pushes.iter().any(|&push| across(g, push, axis)) => {
                vec![hx, hy, g.add(xx, yy)]
            }
            (true, Turning::About(_)) => vec![g.add(xx, yy)],
            (true, _) => vec![hx, hy, xx, yy, xy, xz, yz],
            (false, Turning::Nothing) => vec![mass],
            (false, Turning::About(axis)) => {
                let first = [hx, hy, hz].into_iter().zip(axis);
                let units = [g.one(), g.integer(-1)];
                let across = first.filter(|(_, along)| !units.contains(along)).map(|(h, _)| h);
                std::iter::once(mass).chain(across).collect()
            }
            (false, Turning::Freely) => vec![mass, hx, hy, hz],
        }
    }
}

/// Whether two directions differ, other than in sign.
fn across(g: &Graph, a: Vec3, b: Vec3) -> bool {
    cross(g, a, b) != [g.zero(); 3]
}
