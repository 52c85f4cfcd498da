//! Gaps of loops without a closed form.
//!
//! The equations of such loops also vanish if an end is turned by half a turn, and with redundant equations Newton's
//! method may converge to the least sum of squares. Initial states are therefore judged by distances and angles.

use super::Solver;
use super::equations::Equation;
use super::plane::Loop;
use crate::expr::{Binary, Expr, Unary};
use crate::model::{BodyId, Gap, Tree, between};
use crate::model::{Closure, Tie};
use crate::screw::Vec3;

impl<'g> Solver<'g, '_> {
    /// Gaps of the loops that are solved together.
    pub(super) fn gaps_of(
        &self,
        equations: &[Equation<'g>],
        loops: &[Option<Loop<'g>>],
        left: &[usize],
    ) -> Vec<Gap<'g>> {
        let gap = |&number: &usize| {
            let own = equations.iter().filter(|equation| equation.number == number);
            let lengths = own.filter(|equation| equation.unit == "m");
            let squares = lengths.map(|equation| equation.value.powi(2));
            let closure = &self.tree.closures[number];
            let [distance, angle, size] = [
                self.graph.sum(squares.collect::<Vec<_>>()).sqrt(),
                // the axes of a loop in a plane are parallel
                loops[number]
                    .as_ref()
                    .map_or_else(|| closure.angle(self.tree), |_| self.graph.zero()),
                closure.size(self.tree),
            ];
            Gap {
                number,
                distance,
                angle,
                size,
            }
        };
        left.iter().map(gap).collect()
    }
}

impl<'g> Closure<'g> {
    /// Angle between the two frames, or the two axes, tied by the joint.
    fn angle(&self, tree: &Tree<'g>) -> Expr<'g> {
        let frames = between(tree, self.ends.map(|end| end.body));
        let [a, b] = [0, 1].map(|n| frames[n].rotation * self.axes[n]);
        let (sine, cosine) = match self.tie {
            Tie::Ball => return tree.graph.zero(),
            Tie::Revolute(axis) => {
                let [a, b] = [a, b].map(|axes| axes * axis);
                (a.cross(b), a.dot(b))
            }
            Tie::Prismatic(_) | Tie::Fixed => {
                let pairs = [0, 1, 2].map(|n| (a.column(n), b.column(n)));
                let zero = Vec3::zero(tree.graph);
                let twice = pairs.iter().fold(zero, |sum, (a, b)| sum + a.cross(*b));
                // twice the sine, and the trace, which is 1 plus twice the cosine
                (twice, tree.graph.sum(pairs.map(|(a, b)| a.dot(b))) - tree.graph.one())
            }
        };
        sine.dot(sine).sqrt().combine(Binary::Atan2, cosine)
    }

    /// Sum of the lengths from each end to the body that carries both.
    fn size(&self, tree: &Tree<'g>) -> Expr<'g> {
        let carrier = self.carrier(tree);
        let of_ends = self.ends.map(|end| {
            let below = |&body: &BodyId| tree.bodies[body].parent;
            let chain = std::iter::successors(end.body.filter(|_| end.body != carrier), |body| {
                below(body).filter(|&parent| Some(parent) != carrier)
            });
            chain.fold(length(end.at), |sum, body| {
                let body = &tree.bodies[body];
                let own = sum + length(body.placement.translation);
                body.screw.map_or(own, |screw| {
                    let (w, v) = (screw.angular, screw.linear);
                    let (arm, along) = match screw.turns() {
                        true => (length(w.cross(v)), w.dot(v)),
                        false => (tree.graph.zero(), length(v)),
                    };
                    own + 2 * arm + (along * tree.position_of(&body.motion)).apply(Unary::Abs)
                })
            })
        });
        of_ends[0] + of_ends[1]
    }
}

fn length(v: Vec3<'_>) -> Expr<'_> {
    v.dot(v).sqrt()
}
