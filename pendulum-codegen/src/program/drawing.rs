//! Drawing of a scene.

use rustc_hash::FxHashMap;

use super::block::{Block, Variable};
use super::build::{NotFinite, block};
use crate::expr::{Expr, ExprId};
use crate::form::{self, Chosen, Forms};
use crate::model::{Action, Body, BodyId, FigureKind, Model, Poses};
use crate::screw::{Twist, Vec3};

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
        shown.pivots();
        shown.springs_and_dampers();
        shown.points();
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

impl<'g> Shown<'_, 'g> {
    /// Adds an outline through points of bodies.
    fn show(&mut self, name: &str, kind: FigureKind, points: &[(Option<BodyId>, Vec3<'g>)], radius: Option<Expr<'g>>) {
        self.outlines.push(Outline {
            name: name.trim_start_matches("r#").to_owned(),
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

    /// Adds rods for bodies without solids: to the joints they carry and to those that close loops.
    fn arms(&mut self) {
        let model = self.model;
        let moving = model.bodies.iter().filter(|body| body.screw.is_some());
        let carried = moving.map(|body| (body.parent, body.placement.translation));
        let closing = model.closures.iter().flat_map(|closure| &closure.ends);
        for (owner, at) in carried.chain(closing.map(|end| (end.body, end.at))) {
            let is_bare = |owner: &Body<'g>| owner.figures.iter().all(|figure| figure.kind == FigureKind::Mass);
            let owner = owner.filter(|&owner| !model.bodies[owner].figures.is_empty());
            if let Some(owner) = owner.filter(|&owner| is_bare(&model.bodies[owner]) && !at.is_zero()) {
                let ends = [Vec3::zero(model.graph), at].map(|end| (Some(owner), end));
                self.show(&model.bodies[owner].name, FigureKind::Rod, &ends, None);
            }
        }
    }

    fn pivots(&mut self) {
        let model = self.model;
        // a free body hangs on no pivot; the slides of its joint have its name
        let is_free = |body: &Body<'g>| {
            let parts = model.bodies.iter().filter(|part| part.name == body.name);
            parts.filter_map(|part| part.screw).any(|screw| !screw.turns())
        };
        for (n, body) in model.bodies() {
            let turning = body.screw.filter(Twist::turns);
            if let Some(screw) = turning.filter(|_| !body.figures.is_empty() && !is_free(body)) {
                let at = screw.angular.cross(screw.linear);
                self.show(&body.name, FigureKind::Pivot, &[(Some(n), at)], None);
            }
        }
        for closure in &model.closures {
            let [end, _] = &closure.ends;
            self.show(name_of(model, end.body), FigureKind::Pivot, &[(end.body, end.at)], None);
        }
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
}

fn name_of<'m>(model: &'m Model<'_>, body: Option<BodyId>) -> &'m str {
    body.map_or("ground", |body| &model.bodies[body].name)
}
