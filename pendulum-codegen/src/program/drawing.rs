//! Drawing of a scene.

use rustc_hash::FxHashMap;

use super::block::{Block, Variable};
use super::build::{NotFinite, block};
use crate::expr::{Derivative, Expr, ExprId, Level};
use crate::form::{self, Chosen, Forms};
use crate::model::{Action, Body, BodyId, Constraint, Coordinate, FigureKind, Model, Poses};
use crate::screw::Vec3;

/// Outlines of a scene, and code for their positions.
#[derive(Clone, Debug, Default)]
pub struct Drawing {
    /// Outlines.
    pub outlines: Vec<Outline>,
    /// Points of each outline in turn, each as three coordinates in the ground frame, followed by the radius if there
    /// is one.
    pub block: Block,
}

/// Outline of one object.
#[derive(Clone, Debug)]
pub struct Outline {
    /// Body, or point; for springs and dampers the body of their first end.
    pub name: String,
    /// Body to which the object belongs; `ground` if that body is at rest.
    pub body: String,
    /// Kind of the object.
    pub kind: FigureKind,
    /// Number of points.
    pub points: usize,
    /// True if the outline has a radius.
    pub radius: bool,
}

/// Outlines of a scene, and expressions for their points and radii.
pub(super) struct Sketch<'g> {
    outlines: Vec<Outline>,
    pub(super) chosen: Chosen<'g>,
}

impl<'g> Sketch<'g> {
    /// Collects the outlines of a model.
    pub(super) fn new(forms: &mut Forms<'g>, model: &Model<'g>) -> Self {
        let mut shown = Shown {
            model,
            poses: Poses::new(model),
            outlines: Vec::new(),
            values: Vec::new(),
        };
        shown.solids();
        shown.arms();
        shown.joints();
        shown.springs_and_dampers();
        shown.points();
        shown.walls();
        Self {
            chosen: form::values(forms, model, &shown.values),
            outlines: shown.outlines,
        }
    }

    /// Generates the code of the drawing. `known` maps expressions to the variables that the code may read.
    pub(super) fn finish(self, model: &Model<'g>, known: &FxHashMap<ExprId, Variable>) -> Result<Drawing, NotFinite> {
        Ok(Drawing {
            outlines: self.outlines,
            block: block(model.graph, &self.chosen.roots, known)?,
        })
    }
}

/// Outlines collected so far, and expressions for their points and radii.
struct Shown<'m, 'g> {
    model: &'m Model<'g>,
    poses: Poses<'g>,
    outlines: Vec<Outline>,
    values: Vec<Expr<'g>>,
}

/// A point of a body.
type At<'g> = (Option<BodyId>, Vec3<'g>);

impl<'g> Shown<'_, 'g> {
    /// Adds an outline through points of bodies. It belongs to the body of the first point.
    fn show(&mut self, name: &str, kind: FigureKind, points: &[At<'g>], radius: Option<Expr<'g>>) {
        let owner = points[0].0.filter(|_| !self.is_at_rest(points[0].0));
        let plain = |name: &str| name.trim_start_matches("r#").to_owned();
        self.outlines.push(Outline {
            name: plain(name),
            body: plain(name_of(self.model, owner)),
            kind,
            points: points.len(),
            radius: radius.is_some(),
        });
        let points = points.iter().flat_map(|&(body, at)| self.poses.point(body, at).0);
        self.values.extend(points.chain(radius));
    }

    fn solids(&mut self) {
        for (n, body) in self.model.bodies() {
            for figure in &body.figures {
                let points: Vec<_> = figure.points.iter().map(|&at| (Some(n), at)).collect();
                self.show(&body.name, figure.kind, &points, figure.radius);
            }
        }
    }

    /// Adds rods for bodies without solids: to the joints they carry, to those that close loops, and to their points.
    fn arms(&mut self) {
        let model = self.model;
        let moving = model.bodies.iter().filter(|body| body.screw.is_some());
        let carried = moving.map(|body| (body.parent, body.placement.translation));
        let closing = model.closures.iter().flat_map(|closure| &closure.ends);
        let closing = closing.map(|end| (end.body, end.at));
        let points = model.points.iter().map(|point| (point.place.body, point.place.at));
        let mut drawn: Vec<At<'g>> = Vec::new();
        for (owner, at) in carried.chain(closing).chain(points) {
            let is_bare = |owner: &Body<'g>| {
                !owner.figures.is_empty() && owner.figures.iter().all(|figure| figure.kind == FigureKind::Mass)
            };
            let owner = owner.filter(|&owner| is_bare(&model.bodies[owner]) && !at.is_zero());
            if owner.is_some() && !drawn.contains(&(owner, at)) {
                let ends = [Vec3::zero(model.graph), at].map(|end| (owner, end));
                self.show(name_of(model, owner), FigureKind::Rod, &ends, None);
                drawn.push((owner, at));
            }
        }
    }

    fn joints(&mut self) {
        let model = self.model;
        let visible = model.bodies().filter(|(_, body)| !body.figures.is_empty());
        for (n, body, screw) in visible.filter_map(|(n, body)| Some((n, body, body.screw?))) {
            let carrier = self.carrier(body);
            if !screw.turns() && self.is_at_rest(carrier) {
                let (at, axis) = (body.placement.translation, body.placement.rotation * screw.linear);
                let ends = [at, at + axis].map(|end| (body.parent, end));
                self.show(&body.name, FigureKind::Guide, &ends, None);
            } else if screw.turns() && !self.is_free(body) {
                let at = screw.angular.cross(screw.linear);
                self.show(&body.name, self.pivot(carrier), &[(Some(n), at)], None);
            }
        }
        for closure in &model.closures {
            let [end, other] = &closure.ends;
            let kind = if self.is_at_rest(end.body) {
                self.pivot(end.body)
            } else {
                self.pivot(other.body)
            };
            self.show(name_of(model, end.body), kind, &[(end.body, end.at)], None);
        }
    }

    /// Body to which the joint of a body connects it. A joint of several degrees of freedom has parts of its name.
    fn carrier(&self, body: &Body<'g>) -> Option<BodyId> {
        let parent = body.parent?;
        let carrier = &self.model.bodies[parent];
        if carrier.name == body.name {
            self.carrier(carrier)
        } else {
            Some(parent)
        }
    }

    /// Kind of a joint that rotates, by the body that carries it.
    fn pivot(&self, carrier: Option<BodyId>) -> FigureKind {
        if self.is_at_rest(carrier) {
            FigureKind::Support
        } else {
            FigureKind::Pivot
        }
    }

    /// True for ground, and for a body fixed to it.
    fn is_at_rest(&self, body: Option<BodyId>) -> bool {
        let Some(body) = body.map(|body| &self.model.bodies[body]) else {
            return true;
        };
        body.screw.is_none() && self.is_at_rest(body.parent)
    }

    /// True for a body that turns about no pivot: it slides as well, by its own joint or by that of a massless body
    /// that carries it.
    fn is_free(&self, body: &Body<'g>) -> bool {
        let model = self.model;
        let slides = |part: &Body<'g>| part.screw.is_some_and(|screw| !screw.turns());
        let carrier = body.parent.map(|parent| &model.bodies[parent]);
        let is_slide = |carrier: &Body<'g>| {
            let mut motion = carrier.motion.terms();
            carrier.figures.is_empty() && slides(carrier) && !motion.any(|(k, _)| model.is_driven(k))
        };
        let mut parts = model.bodies.iter().filter(|part| part.name == body.name);
        carrier.is_some_and(is_slide) || parts.any(slides)
    }

    fn springs_and_dampers(&mut self) {
        for action in &self.model.actions {
            let Action::Between { ends, potential, .. } = action else {
                continue;
            };
            let kind = match potential {
                None => FigureKind::Damper,
                Some(_) => FigureKind::Spring,
            };
            let name = name_of(self.model, ends[0].body);
            self.show(name, kind, &ends.each_ref().map(|end| (end.body, end.at)), None);
        }
    }

    fn points(&mut self) {
        for point in &self.model.points {
            let kind = if point.moves {
                FigureKind::Point
            } else {
                FigureKind::Anchor
            };
            self.show(&point.name, kind, &[(point.place.body, point.place.at)], None);
        }
    }

    /// Adds the flat walls.
    fn walls(&mut self) {
        let model = self.model;
        for wall in model.constraints.iter().filter(|own| own.coordinate.is_none()) {
            let touching = self.touching_point(wall).or_else(|| self.touching_body(wall));
            if let Some((at, normal)) = touching {
                let unit = (1 / normal.dot(normal).sqrt()) * normal;
                let foot = at - (wall.value / normal.dot(normal)) * normal;
                let ends = [foot, foot + unit].map(|end| (None, end));
                self.show(&wall.name, FigureKind::Wall, &ends, None);
            }
        }
    }

    /// Position of the declared point that a flat wall keeps off, and the derivative of the gap by this position.
    fn touching_point(&self, wall: &Constraint<'g>) -> Option<(Vec3<'g>, Vec3<'g>)> {
        let by = |x: Expr<'g>| Derivative::by(x).of(wall.declared);
        let slopes = self
            .model
            .points
            .iter()
            .map(|point| (point, Vec3(point.position.0.map(by))));
        let mut touching = slopes.filter(|(_, slope)| !slope.is_zero());
        let (point, normal) = touching.next()?;
        let mut coordinates = self.model.coordinates.iter();
        let is_alone = touching.next().is_none() && coordinates.all(|own| own.derivative().of(wall.declared).is_zero());
        let position = self.poses.point(point.place.body, point.place.at);
        (is_alone && is_fixed(normal)).then_some((position, normal))
    }

    /// Origin of the first body whose motion changes the gap of a flat wall as the coordinates do, or the point of a
    /// sphere about it that is nearest to the wall; and the derivative of the gap by its position.
    fn touching_body(&self, wall: &Constraint<'g>) -> Option<(Vec3<'g>, Vec3<'g>)> {
        let graph = self.model.graph;
        let coordinates = || self.model.coordinates.iter().map(Coordinate::derivative);
        let slopes: Vec<Expr<'g>> = coordinates().map(|mut by| by.of(wall.value)).collect();
        let normal = |(n, body): (BodyId, &Body<'g>)| {
            let origin = self.poses.point(Some(n), Vec3::zero(graph));
            let ways: Vec<Vec3<'g>> = coordinates().map(|mut by| Vec3(origin.0.map(|x| by.of(x)))).collect();
            let parts = slopes.iter().zip(&ways).filter(|(slope, _)| !slope.is_zero());
            let normal = parts.fold(Vec3::zero(graph), |sum, (&slope, &way)| sum + slope * way);
            let explains = |(&slope, &way): (&Expr<'g>, &Vec3<'g>)| normal.dot(way) == slope;
            let is_flat = !normal.is_zero() && is_fixed(normal) && slopes.iter().zip(&ways).all(explains);
            let nearest = |radius: Expr<'g>| origin - (radius / normal.dot(normal).sqrt()) * normal;
            is_flat.then(|| (radius_about_origin(body).map_or(origin, nearest), normal))
        };
        self.model.bodies().find_map(normal)
    }
}

/// Radius of the sphere about the origin of a body, if it has one.
fn radius_about_origin<'g>(body: &Body<'g>) -> Option<Expr<'g>> {
    let mut spheres = body.figures.iter().filter(|own| own.kind == FigureKind::Sphere);
    let sphere = spheres.find(|own| own.points[0].is_zero())?;
    Some(sphere.points[1].0[0])
}

/// True if a vector is constant in time, for given parameters.
fn is_fixed(vector: Vec3<'_>) -> bool {
    vector.0.iter().all(|x| x.level() <= Level::Parameter)
}

fn name_of<'m>(model: &'m Model<'_>, body: Option<BodyId>) -> &'m str {
    body.map_or("ground", |body| &model.bodies[body].name)
}
