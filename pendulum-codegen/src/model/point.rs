//! Points of bodies.

use rustc_hash::FxHashMap;

use super::{Action, Coordinate, Model, Place, Poses, Tree, changes};
use crate::expr::{Derivative, Expr};
use crate::screw::Vec3;

/// A point of a body.
#[derive(Clone, Debug)]
pub(crate) struct Point<'g> {
    /// Name.
    pub name: String,
    /// Position on its body.
    pub place: Place<'g>,
    /// True if its body can move.
    pub moves: bool,
    /// Symbols of its position in the ground frame, until all bodies are known.
    pub position: Vec3<'g>,
    /// Symbols of its velocity in the ground frame.
    pub velocity: Vec3<'g>,
}

/// Time derivative of expressions in coordinates, points and the time.
pub(crate) fn along_motion<'g, 'm>(
    time: Expr<'g>,
    coordinates: impl Iterator<Item = &'m Coordinate<'g>>,
    points: impl Iterator<Item = [Vec3<'g>; 2]>,
) -> Derivative<'g>
where
    'g: 'm,
{
    let coordinates = changes(coordinates).into_iter();
    let points = points.flat_map(|[position, velocity]| position.0.into_iter().zip(velocity.0));
    Derivative::along(coordinates.chain(points).chain([(time, time.graph().one())]))
}

impl<'g> Tree<'g> {
    /// Time derivative of expressions in coordinates and the time.
    pub(crate) fn along_motion(&self) -> Derivative<'g> {
        along_motion(self.time, self.all_coordinates(), std::iter::empty())
    }
}

impl<'g> Model<'g> {
    /// Replaces the symbols of points by their positions and velocities.
    pub(crate) fn resolve_points(&mut self) {
        let poses = Poses::new(self);
        let mut along_motion = self.along_motion();
        let mut values = FxHashMap::default();
        for point in &self.points {
            let position = poses.point(point.place.body, point.place.at);
            let velocity = position.0.map(|x| along_motion.of(x));
            values.extend(point.position.0.into_iter().zip(position.0));
            values.extend(point.velocity.0.into_iter().zip(velocity));
        }
        let bodies = self.tree.bodies.iter_mut();
        let of_bodies = bodies.flat_map(|body| [&mut body.force, &mut body.passive, &mut body.potential]);
        let of_actions = self.tree.actions.iter_mut().flat_map(Action::expressions);
        let of_states = self.tree.states.iter_mut().map(|state| &mut state.rate);
        let of_outputs = self.outputs.iter_mut().flat_map(|output| &mut output.values);
        let of_events = self.events.iter_mut().map(|event| &mut event.value);
        let of_constraints = self.constraints.iter_mut().map(|constraint| &mut constraint.value);
        let places = of_bodies.chain(of_actions).chain(of_outputs).chain(of_events);
        let places = places.chain(of_constraints).chain(of_states);
        let places: Vec<&mut Expr<'g>> = places.collect();
        let unresolved: Vec<Expr<'g>> = places.iter().map(|place| **place).collect();
        let resolved = self.tree.graph.substitute(&unresolved, values);
        for (place, value) in places.into_iter().zip(resolved) {
            *place = value;
        }
    }
}
