//! How a scene looks.

use rustc_hash::FxHashMap;

use super::block::{Block, Variable};
use super::build::{NotFinite, block};
use crate::expr::{Expr, ExprId};
use crate::form::{self, Chosen, Forms};
use crate::model::{Action, Body, BodyId, FigureKind, Model, Poses};
use crate::screw::{Twist, Vec3};

/// What there is to see, and code for where it is.
#[derive(Clone, Debug, Default)]
pub struct Drawing {
    /// What there is.
    pub outlines: Vec<Outline>,
    /// The points of each outline one after the other, each as three coordinates in the ground frame, and after them
    /// the radius.
    pub block: Block,
}

/// Something to see.
#[derive(Clone, Debug)]
pub struct Outline {
    /// The body, or the point; for springs and dampers the body of their first end.
    pub name: String,
    /// What it is.
    pub kind: FigureKind,
    /// The number of its points.
    pub points: usize,
    /// Whether it has a radius.
    pub radius: bool,
}

/// What there is to see in a scene, and the values that it takes.
pub(super) struct Sketch<'g> {
    outlines: Vec<Outline>,
    pub(super) chosen: Chosen<'g>,
}

impl<'g> Sketch<'g> {
    /// The sketch of a model.
    pub(super) fn new(forms: &mut Forms<'g>, model: &Model<'g>) -> Self {
        let poses = Poses::new(model);
        let (mut outlines, mut values) = (Vec::new(), Vec::new());
        let mut show = |name: &str, kind, points: Vec<Vec3<'g>>, radius: Option<Expr<'g>>| {
            outlines.push(Outline {
                name: name.trim_start_matches("r#").to_owned(),
                kind,
                points: points.len(),
                radius: radius.is_some(),
            });
            values.extend(points.into_iter().flat_map(|point| point.0).chain(radius));
        };
        for (n, body) in model.bodies() {
            for figure in &body.figures {
                let points = figure.points.iter().map(|&point| poses.point(Some(n), point)).collect();
                show(&body.name, figure.kind, points, figure.radius);
            }
        }
        // of a body without solids, where it reaches the joints that it carries, and those that close loops
        let moving = model.bodies.iter().filter(|body| body.screw.is_some());
        let carried = moving.map(|body| (body.parent, body.placement.translation));
        let closing = || model.closures.iter().flat_map(|closure| &closure.ends);
        for (owner, at) in carried.chain(closing().map(|end| (end.body, end.at))) {
            let is_bare = |owner: &Body<'g>| owner.figures.iter().all(|figure| figure.kind == FigureKind::Mass);
            let owner = owner.filter(|&owner| !model.bodies[owner].figures.is_empty());
            let owner = owner.filter(|&owner| is_bare(&model.bodies[owner]) && !at.is_zero());
            if let Some(owner) = owner {
                let points = [Vec3::zero(model.graph), at].map(|point| poses.point(Some(owner), point));
                show(&model.bodies[owner].name, FigureKind::Rod, points.into(), None);
            }
        }
        // what moves freely hangs on nothing; the slides of its joint have its name
        let is_free = |body: &Body<'g>| {
            let parts = model.bodies.iter().filter(|part| part.name == body.name);
            parts.filter_map(|part| part.screw).any(|screw| !screw.turns())
        };
        for (n, body) in model.bodies() {
            let turning = body.screw.filter(Twist::turns);
            let Some(screw) = turning.filter(|_| !body.figures.is_empty() && !is_free(body)) else {
                continue;
            };
            let at = screw.angular.cross(screw.linear);
            show(&body.name, FigureKind::Pivot, vec![poses.point(Some(n), at)], None);
        }
        for closure in &model.closures {
            let [end, _] = &closure.ends;
            let pivot = vec![poses.point(end.body, end.at)];
            show(name_of(model, end.body), FigureKind::Pivot, pivot, None);
        }
        for action in &model.actions {
            let Action::Between { ends, potential, .. } = action else {
                continue;
            };
            let kind = if potential.is_none() {
                FigureKind::Damper
            } else {
                FigureKind::Spring
            };
            let name = name_of(model, ends[0].body);
            show(
                name,
                kind,
                ends.iter().map(|end| poses.point(end.body, end.at)).collect(),
                None,
            );
        }
        for point in &model.points {
            let kind = if point.moves {
                FigureKind::Point
            } else {
                FigureKind::Anchor
            };
            show(
                &point.name,
                kind,
                vec![poses.point(point.place.body, point.place.at)],
                None,
            );
        }
        let chosen = form::values(forms, model, &values);
        Self { outlines, chosen }
    }

    /// The drawing; `known` is what its code can read.
    pub(super) fn finish(self, model: &Model<'g>, known: &FxHashMap<ExprId, Variable>) -> Result<Drawing, NotFinite> {
        Ok(Drawing {
            outlines: self.outlines,
            block: block(model.graph, &self.chosen.roots, known)?,
        })
    }
}

fn name_of<'m>(model: &'m Model<'_>, body: Option<BodyId>) -> &'m str {
    body.map_or("ground", |body| &model.bodies[body].name)
}
