//! Joints that turn about all axes: their coordinates, and the bodies in a row that they are made of.

use std::collections::BTreeMap;

use syn::Ident;

use super::Lower;
use super::expr::Place;
use super::joint_units::JointUnits;
use super::mass::{Mass, Turns};
use super::measure::{Measure, Quantity};
use super::scope::Kind;
use crate::ast::{self, JointKind};
use crate::error::Reported;
use crate::expr::{Expr, SymbolKind};
use crate::model::{Body, BodyId, Combination, Coordinate, CoordinateId, Heading, Requirement};
use crate::parse::HINGES;
use crate::screw::{Mat3, SpatialInertia, Transform, Twist, Vec3};

/// What stands behind the dot of an orientation or of a position.
#[derive(Clone, Debug)]
pub(super) struct Components<'g> {
    kind: Kind,
    values: Vec<(&'static str, Expr<'g>)>,
    rates: Vec<(&'static str, Expr<'g>)>,
}

const AXES: [&str; 3] = ["x", "y", "z"];

/// What a joint may lack, and what to do about it.
const ORIENTATION: [&str; 2] = ["orientation", "add `orientation: o`, the name of its unit quaternion"];
const POSITION: [&str; 2] = ["position", "add `position: p`, the name of the place of its frame"];

impl Components<'_> {
    fn measures(&self) -> [Measure; 2] {
        match self.kind {
            Kind::Position => [Measure::of("m"), Measure::of("m/s")],
            _ => [Measure::ONE, Measure::of("rad/s")],
        }
    }
}

/// `o.w`, `o.x`, .. as a list in words, each between other text.
fn listed(axes: impl DoubleEndedIterator<Item = &'static str>, form: impl Fn(&str) -> String) -> String {
    let mut names: Vec<String> = axes.map(|axis| format!("`{}`", form(axis))).collect();
    let last = names.pop().unwrap_or_default();
    format!("{} or {last}", names.join(", "))
}

/// Whether the joint of a body turns about all axes, and whether it slides as well.
pub(super) fn freedom(body: &ast::Body) -> Option<bool> {
    match body.fields.joint.as_ref()?.kind {
        Ok(JointKind::Ball) => Some(false),
        Ok(JointKind::Free) => Some(true),
        _ => None,
    }
}

/// The first of the three coordinates of an orientation or of a position. By mistake one may have the name of the other.
fn first_of(coordinates: &[Coordinate<'_>], name: &Ident, kind: Kind) -> Option<usize> {
    let turns = kind == Kind::Orientation;
    let name = format!("{name}.x");
    coordinates
        .iter()
        .position(|c| c.name == name && c.is_of_orientation() == turns)
}

impl<'g> Lower<'g> {
    /// The coordinates of the orientations and positions of a body, behind those that are known. Their rates are known
    /// only later, so their names come with them.
    pub(super) fn freedom_coordinates(&mut self, body: &ast::Body, coordinates: &mut Vec<Unrated<'g>>) {
        if let Some(ident) = &body.fields.position {
            let measure = Measure::of("m");
            self.names
                .declare(&mut self.errors, Kind::Position, ident, (measure, None));
            for axis in AXES {
                let name = format!("{ident}.{axis}");
                let position = self.graph.symbol(&name, SymbolKind::Coordinate(coordinates.len()));
                coordinates.push(Unrated {
                    rate: format!("dot({name})"),
                    name,
                    position,
                    turns: None,
                });
            }
        }
        if let Some(ident) = &body.fields.orientation {
            self.names
                .declare(&mut self.errors, Kind::Orientation, ident, (Measure::ONE, None));
            let component =
                |axis: &str, n: usize| self.graph.symbol(&format!("{ident}.{axis}"), SymbolKind::Coordinate(n));
            let first = coordinates.len();
            let [x, y, z] = [0, 1, 2].map(|n| component(AXES[n], first + n));
            // the number of the scalar part is that of no other component of the same name
            let quaternion = [component("w", first), x, y, z];
            for (n, axis) in AXES.into_iter().enumerate() {
                coordinates.push(Unrated {
                    name: format!("{ident}.{axis}"),
                    rate: format!("dot({ident}).{axis}"),
                    position: self.graph.zero(),
                    turns: Some((quaternion, n)),
                });
            }
        }
    }

    /// Notes what stands behind the dots of the orientations and positions of a scene.
    pub(super) fn name_components(&mut self, bodies: &[ast::Body], coordinates: &[Coordinate<'g>]) {
        let of = |name: &Ident, kind| {
            let first = first_of(coordinates, name, kind)?;
            coordinates.get(first..first + 3)
        };
        for body in bodies {
            let names = [
                (&body.fields.position, Kind::Position),
                (&body.fields.orientation, Kind::Orientation),
            ];
            for (name, kind) in names {
                let Some((name, own)) = name.as_ref().and_then(|name| Some((name, of(name, kind)?))) else {
                    continue;
                };
                let values = match kind {
                    Kind::Orientation => {
                        let quaternion = own[0].changes.iter().map(|(component, _)| *component);
                        ["w", "x", "y", "z"].into_iter().zip(quaternion).collect()
                    }
                    _ => AXES.into_iter().zip(own.iter().map(|c| c.position)).collect(),
                };
                let components = Components {
                    kind,
                    values,
                    rates: AXES.into_iter().zip(own.iter().map(|c| c.rate)).collect(),
                };
                self.components.insert(name.to_string(), components);
            }
        }
    }

    /// `o.w` or `p.x`; none where the name is neither that of an orientation nor of a position.
    pub(super) fn component_of_joint(&mut self, name: &Ident, axis: &Ident) -> Option<Result<Quantity<'g>, Reported>> {
        let components = self.components.get(&name.to_string())?.clone();
        let found = components.values.iter().find(|(known, _)| axis == known);
        let [measure, _] = components.measures();
        Some(match found {
            Some(&(_, value)) => Ok(Quantity { value, measure }),
            None => {
                let fact = format_args!("{} has no `{axis}`", components.kind.one());
                let known = components.values.iter().map(|(axis, _)| *axis);
                let help = format!("write {}", listed(known, |axis| format!("{name}.{axis}")));
                Err(self.errors.at(axis.span(), fact, help))
            }
        })
    }

    /// The name of the orientation that has a component.
    pub(super) fn orientation_of(&self, component: Expr<'g>) -> Option<&str> {
        let mut all = self.components.iter();
        let found = all
            .find(|(_, own)| own.kind == Kind::Orientation && own.values.iter().any(|(_, value)| *value == component));
        found.map(|(name, _)| name.as_str())
    }

    /// `dot(o).x`
    pub(super) fn rate_component(
        &mut self,
        name: &Ident,
        axis: &Ident,
        place: &Place<'g>,
    ) -> Result<Quantity<'g>, Reported> {
        let Some(components) = self.components.get(&name.to_string()).cloned() else {
            let fact = format_args!("`{name}` is no orientation, so its rate has no components");
            let help = match self.names.kind(&name.to_string()) {
                Some(Kind::Point) => format!("write `dot({name}.{axis})` for the rate of a component"),
                Some(Kind::Coordinate) => format!("write `dot({name})`"),
                _ => "name the `orientation` of a ball or free joint".to_owned(),
            };
            return Err(self.errors.at(name.span(), fact, help));
        };
        let found = components.rates.iter().find(|(known, _)| axis == known);
        let [_, measure] = components.measures();
        let Some(&(_, value)) = found else {
            let fact = format_args!("the rate of {} has no `{axis}`", components.kind.one());
            let help = format!(
                "write {}",
                listed(AXES.into_iter(), |axis| format!("dot({name}).{axis}"))
            );
            return Err(self.errors.at(axis.span(), fact, help));
        };
        let value = self.permit(value, name.span(), place)?;
        Ok(Quantity { value, measure })
    }

    /// Says how to write a component where the name of all of them stands.
    pub(super) fn not_a_number(&mut self, name: &Ident, is_rate: bool) -> Option<Reported> {
        let components = self.components.get(&name.to_string())?.clone();
        let fact = format_args!("`{name}` is {}, not a number", components.kind.one());
        let help = if is_rate {
            listed(AXES.into_iter(), |axis| format!("dot({name}).{axis}"))
        } else {
            listed(components.values.iter().map(|(axis, _)| *axis), |axis| {
                format!("{name}.{axis}")
            })
        };
        Some(self.errors.at(name.span(), fact, format!("write {help}")))
    }

    /// Refuses names of orientations and positions where the joint has none.
    pub(super) fn require_no_freedom(&mut self, body: &ast::Body) -> Result<(), Reported> {
        let names = [
            (&body.fields.orientation, "turn freely, so it has no orientation"),
            (&body.fields.position, "move freely, so it has no position"),
        ];
        let given = names.into_iter().find_map(|(name, what)| Some((name.as_ref()?, what)));
        let Some((name, what)) = given else { return Ok(()) };
        match (&body.fields.joint, body.unread) {
            (Some(joint), _) if joint.kind.is_err() => return Ok(()),
            // the joint may be what could not be read
            (None, Some(reported)) => return Err(reported),
            _ => {}
        }
        let fact = format_args!("the joint of `{}` does not {what}", body.name);
        let help =
            "`joint: ball` has an `orientation`, `joint: free` a `position` too, and other joints a `coordinate`";
        Err(self.errors.at(name.span(), fact, help))
    }

    /// What a joint that turns about all axes must have, and what makes no sense there.
    fn check_freedom(&mut self, body: &ast::Body, slides: bool) -> Result<(), Reported> {
        let (fields, name) = (&body.fields, &body.name);
        let kind = if slides { "free" } else { "ball" };
        let mut first = Ok(());
        let mut refuse = |reported: Reported| first = first.and(Err(reported));
        if let Some(depends) = &fields.depends {
            let fact = format_args!("the {kind} joint of `{name}` has an orientation, which cannot depend");
            refuse(self.errors.at(depends.span(), fact, HINGES));
        } else if let Some(coordinate) = &fields.coordinate {
            let help = if slides {
                "write `orientation: o, position: p`; components are `o.w` and `p.x`"
            } else {
                "write `orientation: o`; its components are `o.w`, `o.x`, `o.y` and `o.z`"
            };
            let fact = format_args!("the {kind} joint of `{name}` has an orientation, and not one coordinate");
            refuse(self.errors.at(coordinate.span(), fact, help));
        } else if fields.orientation.is_none() && fields.motion.is_none() {
            refuse(self.missing(body, ORIENTATION));
        }
        match &fields.position {
            Some(position) if !slides => {
                let fact = format_args!("the ball joint of `{name}` stays where it is, so it has no position");
                refuse(
                    self.errors
                        .at(position.span(), fact, "leave it out, or make the joint `free`"),
                );
            }
            None if slides && fields.coordinate.is_none() && fields.motion.is_none() => {
                refuse(self.missing(body, POSITION));
            }
            _ => {}
        }
        let orientation = fields.orientation.as_ref().map_or("o".to_owned(), ToString::to_string);
        let moment = format!(
            "write `dissipation: -m*dot({orientation}).x,` for a moment `m` about the x axis of the body, \
             or `force on tip: [fx, fy, fz] in {name},` for a force on a point of it, along its axes"
        );
        let spring = fields.spring.as_ref().map(|(stiffness, _)| &stiffness.tokens);
        let friction = fields.friction.as_ref().filter(|_| slides);
        let refused = [
            (
                fields.motion.as_ref().map(|e| &e.tokens),
                "cannot follow a motion",
                "drive joints with one coordinate each",
            ),
            (
                spring,
                "has no spring",
                "write `spring between a and b: (k, l),` between points, or a `potential`",
            ),
            (
                fields.torque.as_ref().map(|e| &e.tokens),
                "has no scalar torque",
                &moment,
            ),
            (
                friction.map(|e| &e.tokens),
                "has no friction",
                "nothing touches what moves freely: write drag as `force on point: ..`",
            ),
            (
                fields.dry_friction.as_ref().map(|e| &e.tokens),
                "has no dry friction",
                "write viscous friction, `friction: e`",
            ),
            (
                fields.static_friction.as_ref().map(|e| &e.tokens),
                "has no dry friction",
                "write viscous friction, `friction: e`",
            ),
            (
                fields.stop.as_ref().map(|stop| &stop.tokens),
                "has no stop",
                "write a `potential` that keeps it away",
            ),
        ];
        for (tokens, what, help) in refused {
            if let Some(tokens) = tokens {
                let fact = format_args!("the {kind} joint of `{name}` {what}");
                refuse(self.errors.on(tokens, fact, help));
            }
        }
        first
    }

    /// Reports what is missing, unless it may be what could not be read.
    fn missing(&mut self, body: &ast::Body, [what, help]: [&str; 2]) -> Reported {
        body.unread.unwrap_or_else(|| {
            let fact = format_args!("the joint of `{}` has no {what}", body.name);
            self.errors.at(body.name.span(), fact, help)
        })
    }

    /// The bodies of a joint that turns about all axes: three turns in a row on bodies without mass, of which the first is
    /// turned by the quaternion, and before them three slides where the joint moves freely.
    pub(super) fn free_bodies(
        &mut self,
        body: &ast::Body,
        slides: bool,
        parent: Result<Option<BodyId>, Reported>,
        bodies: &[Body<'g>],
        coordinates: &[Coordinate<'g>],
        shapes: &BTreeMap<String, Result<Mass<'g>, Reported>>,
    ) -> Result<Vec<Body<'g>>, Reported> {
        let g = self.graph;
        let mass = self.mass_of_body(body, shapes);
        let geometry = self.geometry(&body.name, body.fields.joint.as_ref());
        let fits = self.check_freedom(body, slides);
        let place = Place::fixed(format!("the friction of `{}`", body.name)).in_unit(JointUnits::Turns.friction());
        let friction = body.fields.friction.as_ref().filter(|_| !slides);
        let friction = friction.map_or(Ok(g.zero()), |e| self.positive(e, &place, Requirement::NonNegative));
        let (mass, placement, friction, parent) = (mass?, geometry?.placement, friction?, parent?);
        fits?;
        let figures = mass.as_ref().map(|mass| mass.figures.clone()).unwrap_or_default();
        let massless = SpatialInertia::zero(g);
        let inertia = match mass {
            None => massless,
            Some(mass) => mass.of_body(self, &body.name, Turns::Freely)?,
        };
        let own = |name: &Option<Ident>, kind| first_of(coordinates, name.as_ref()?, kind);
        let Some(turning) = own(&body.fields.orientation, Kind::Orientation) else {
            return Err(self.missing(body, ORIENTATION));
        };
        let sliding = own(&body.fields.position, Kind::Position);
        let identity = Transform::identity(g);
        let mut parts: Vec<Body<'g>> = Vec::new();
        let mut hang = |k: usize, screw: Twist<'g>, turned: Option<Mat3<'g>>, spin: Option<Vec3<'g>>| {
            let parent = match parts.len() {
                0 => parent,
                n => Some(BodyId::new(bodies.len() + n - 1)),
            };
            let placement = if parts.is_empty() { placement } else { identity };
            let placement = placement
                * Transform {
                    rotation: turned.unwrap_or(identity.rotation),
                    ..identity
                };
            let before = parent.map(|parent| match usize::from(parent).checked_sub(bodies.len()) {
                Some(n) => parts[n].heading.clone(),
                None => bodies[parent].heading.clone(),
            });
            let heading = match before {
                Some(before) if turned.is_none() => Heading {
                    rest: before.rest * placement.rotation,
                    ..before
                },
                _ => Heading {
                    station: parent,
                    axis: None,
                    turn: Combination::default(),
                    rest: placement.rotation,
                },
            };
            let force = spin.map_or(g.zero(), |_| -(friction * coordinates[k].rate));
            parts.push(Body {
                name: body.name.to_string(),
                parent,
                placement,
                screw: Some(screw),
                spin,
                coordinate: Some(CoordinateId::new(k)),
                motion: Combination::one(CoordinateId::new(k)),
                heading,
                inertia: massless,
                figures: Vec::new(),
                force,
                passive: force,
                torque: None,
                potential: g.zero(),
                law: None,
            });
        };
        let (zero, axes) = (Vec3::zero(g), [0, 1, 2].map(|axis| Vec3::unit(g, axis)));
        for (k, linear) in sliding.into_iter().flat_map(|first| (first..).zip(axes)) {
            hang(k, Twist { angular: zero, linear }, None, None);
        }
        let rotation = Mat3::of_quaternion([0, 1, 2, 3].map(|n| coordinates[turning].changes[n].0));
        let mut turned = Some(rotation);
        let mut spin = Vec3([0, 1, 2].map(|n| coordinates[turning + n].rate));
        for (k, angular) in (turning..).zip(axes) {
            hang(k, Twist { angular, linear: zero }, turned.take(), Some(spin));
            spin = zero;
        }
        if let Some(last) = parts.last_mut() {
            (last.inertia, last.figures) = (inertia, figures);
        }
        Ok(parts)
    }
}

/// A coordinate before its rate is known.
#[derive(Clone, Debug)]
pub(super) struct Unrated<'g> {
    pub(super) name: String,
    /// The name of its rate.
    pub(super) rate: String,
    pub(super) position: Expr<'g>,
    /// Of an orientation its quaternion, and the axis of the body.
    pub(super) turns: Option<([Expr<'g>; 4], usize)>,
}

impl<'g> Unrated<'g> {
    /// The coordinate with its rate and its second rate.
    pub(super) fn with_rates(self, rate: Expr<'g>, acceleration: Expr<'g>) -> Coordinate<'g> {
        match self.turns {
            None => Coordinate::plain(self.name, [self.position, rate, acceleration]),
            Some((quaternion, axis)) => Coordinate::turn(self.name, quaternion, axis, [rate, acceleration]),
        }
    }
}
