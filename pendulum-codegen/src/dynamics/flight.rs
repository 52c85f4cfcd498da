//! Slides of floating bodies, taken along the axes of the body that they carry.

use super::frames::Frame;
use super::joint::JointId;
use super::links::Links;
use crate::expr::Expr;
use crate::model::Floating;
use crate::screw::{Symmetric3, Vec3};

/// A floating body, which begins with the first link that turns.
#[derive(Clone, Copy, Debug)]
pub(super) struct Flight<'g> {
    /// Slides that carry it.
    pub(super) slides: [JointId; 3],
    /// Mass that moves with the slides alone, at the origin of the link.
    pub(super) mass: Expr<'g>,
    /// Axes of the body, in the frame of the link.
    axes: [Vec3<'g>; 3],
}

/// Floating bodies of a model.
#[derive(Clone, Debug)]
pub(super) struct Flights<'g> {
    /// Flight that begins with each link.
    begin: Vec<Option<Flight<'g>>>,
    /// True for each link that is a slide of a flight.
    slides: Vec<bool>,
}

impl<'g> Flights<'g> {
    pub(super) fn new(links: &Links<'g>, frames: &[Frame<'g>], floating: &[Floating<'g>]) -> Self {
        let mut flights = Self {
            begin: vec![None; frames.len()],
            slides: vec![false; frames.len()],
        };
        for joint in floating {
            let ((Some(first), _), (Some(link), back)) = (links.owners[joint.slide], links.owners[joint.turn]) else {
                continue;
            };
            let slides = [0, 1, 2].map(|n| JointId::new(usize::from(first) + n));
            for slide in slides {
                flights.slides[usize::from(slide)] = true;
            }
            flights.begin[usize::from(link)] = Some(Flight {
                slides,
                mass: frames[slides[2]].inertia.mass,
                axes: [0, 1, 2].map(|n| frames[link].of_body(back.rotation.column(n))),
            });
        }
        flights
    }

    /// Returns the flight that begins with a link.
    pub(super) fn from(&self, link: JointId) -> Option<&Flight<'g>> {
        self.begin[usize::from(link)].as_ref()
    }

    /// All flights, each with the link that it begins with.
    pub(super) fn all(&self) -> impl Iterator<Item = (JointId, &Flight<'g>)> {
        let links = JointId::all(self.begin.len()).zip(&self.begin);
        links.filter_map(|(link, flight)| Some((link, flight.as_ref()?)))
    }

    pub(super) fn is_slide(&self, link: JointId) -> bool {
        self.slides[usize::from(link)]
    }
}

impl<'g> Flight<'g> {
    /// Components of a vector of the link along the axes of the body.
    pub(super) fn along_axes(&self, v: Vec3<'g>) -> [Expr<'g>; 3] {
        self.axes.map(|axis| v.dot(axis))
    }

    /// Inverse of [`Flight::along_axes`].
    pub(super) fn of_axes(&self, v: [Expr<'g>; 3]) -> Vec3<'g> {
        let [x, y, z] = self.axes;
        v[0] * x + v[1] * y + v[2] * z
    }

    /// Mass matrix for accelerations along the axes e of the body: `e_i^T M e_j`, plus m on the diagonal. M is the
    /// `inertia` of the link against accelerations of its origin, and m the mass that moves with the slides alone.
    pub(super) fn mass_matrix(&self, inertia: Symmetric3<'g>) -> Vec<Vec<Expr<'g>>> {
        let column = |n: usize| {
            let mut column = self.along_axes(inertia * self.axes[n]);
            column[n] += self.mass;
            column.to_vec()
        };
        [0, 1, 2].map(column).to_vec()
    }
}
