//! Orientations, positions and their components by name: `o.w`, `p.x`, `dot(o).x`.

use syn::Ident;

use super::Lower;
use super::expr::Place;
use super::measure::{Measure, Quantity};
use super::scope::Kind;
use crate::ast;
use crate::error::{Code, Reported};
use crate::expr::{Expr, SymbolKind};
use crate::model::Coordinate;

/// Components of an orientation or of a position, which are written after a dot.
#[derive(Clone, Debug)]
pub(super) struct Components<'g> {
    kind: Kind,
    values: Vec<(&'static str, Expr<'g>)>,
    rates: Vec<(&'static str, Expr<'g>)>,
}

const AXES: [&str; 3] = ["x", "y", "z"];

impl Components<'_> {
    fn measures(&self) -> [Measure; 2] {
        match self.kind {
            Kind::Position => [Measure::of("m"), Measure::of("m/s")],
            _ => [Measure::ONE, Measure::of("rad/s")],
        }
    }
}

impl<'g> Lower<'g> {
    /// Appends the coordinates of the orientation and position of a body. Their rates are declared later, by the names
    /// stored here.
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
            // the scalar part has the same number as x, but another name
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

    /// Records the components of the orientations and positions of a scene.
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

    /// Components of an orientation, scalar first, or of a position.
    pub(super) fn components_of(&self, name: &Ident) -> impl Iterator<Item = Expr<'g>> + use<'g> {
        let values = self.components.get(&name.to_string()).map(|own| own.values.clone());
        values.into_iter().flatten().map(|(_, value)| value)
    }

    /// `o.w` or `p.x`; none if the name belongs to neither an orientation nor a position.
    pub(super) fn component_of_joint(&mut self, name: &Ident, axis: &Ident) -> Option<Result<Quantity<'g>, Reported>> {
        let components = self.components.get(&name.to_string())?.clone();
        let found = components.values.iter().find(|(known, _)| axis == known);
        let [measure, _] = components.measures();
        Some(match found {
            Some(&(_, value)) => Ok(Quantity { value, measure }),
            None => {
                let fact = format_args!("{} has no component `{axis}`", components.kind.one());
                let known = components.values.iter().map(|(axis, _)| *axis);
                let help = format!("write {}", listed(known, |axis| format!("{name}.{axis}")));
                Err(self.errors.at(Code::UnknownName, axis.span(), fact, help))
            }
        })
    }

    /// Name of the orientation that has a component.
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
            if let Some(reported) = self.broken.get(&name.to_string()) {
                return Err(*reported);
            }
            let fact = format_args!("`{name}` is not an orientation, so its rate has no components");
            let help = match self.names.kind(&name.to_string()) {
                Some(Kind::Point) => format!("write `dot({name}.{axis})` for the rate of a component"),
                Some(Kind::Coordinate) => format!("write `dot({name})`"),
                _ => "name the `orientation` of a ball or free joint".to_owned(),
            };
            return Err(self.errors.at(Code::WrongKind, name.span(), fact, help));
        };
        let found = components.rates.iter().find(|(known, _)| axis == known);
        let [_, measure] = components.measures();
        let Some(&(_, value)) = found else {
            let fact = format_args!("the rate of {} has no component `{axis}`", components.kind.one());
            let help = format!(
                "write {}",
                listed(AXES.into_iter(), |axis| format!("dot({name}).{axis}"))
            );
            return Err(self.errors.at(Code::UnknownName, axis.span(), fact, help));
        };
        let value = self.permit(value, name.span(), place)?;
        Ok(Quantity { value, measure })
    }

    /// Reports an orientation, position or point in place of a number, with help on how to write its components.
    pub(super) fn not_a_number(&mut self, name: &Ident, is_rate: bool) -> Option<Reported> {
        let text = name.to_string();
        let (kind, axes) = match self.components.get(&text) {
            Some(own) => (own.kind, own.values.iter().map(|(axis, _)| *axis).collect()),
            None if self.names.kind(&text) == Some(Kind::Point) => (Kind::Point, AXES.to_vec()),
            None => return None,
        };
        let fact = format_args!("`{name}` is {}, not a number", kind.one());
        let help = match kind {
            _ if !is_rate => listed(axes.into_iter(), |axis| format!("{name}.{axis}")),
            Kind::Point => listed(AXES.into_iter(), |axis| format!("dot({name}.{axis})")),
            _ => listed(AXES.into_iter(), |axis| format!("dot({name}).{axis}")),
        };
        Some(
            self.errors
                .at(Code::WrongKind, name.span(), fact, format!("write {help}")),
        )
    }
}

/// Lists names for use in a sentence: `o.w`, `o.x` or `o.y`.
fn listed(axes: impl DoubleEndedIterator<Item = &'static str>, form: impl Fn(&str) -> String) -> String {
    let mut names: Vec<String> = axes.map(|axis| format!("`{}`", form(axis))).collect();
    let last = names.pop().unwrap_or_default();
    format!("{} or {last}", names.join(", "))
}

/// Index of the first of the three coordinates of an orientation or of a position. The kind matters because, by
/// mistake, both may have the same name.
pub(super) fn first_of(coordinates: &[Coordinate<'_>], name: &Ident, kind: Kind) -> Option<usize> {
    let turns = kind == Kind::Orientation;
    let name = format!("{name}.x");
    coordinates
        .iter()
        .position(|c| c.name == name && c.is_of_orientation() == turns)
}

/// A coordinate before its rate is declared.
#[derive(Clone, Debug)]
pub(super) struct Unrated<'g> {
    pub(super) name: String,
    /// Name of the rate.
    pub(super) rate: String,
    pub(super) position: Expr<'g>,
    /// Quaternion of an orientation, and the axis of the body.
    pub(super) turns: Option<([Expr<'g>; 4], usize)>,
}

impl<'g> Unrated<'g> {
    /// The coordinate with its rate and acceleration.
    pub(super) fn with_rates(self, rate: Expr<'g>, acceleration: Expr<'g>) -> Coordinate<'g> {
        match self.turns {
            None => Coordinate::plain(self.name, [self.position, rate, acceleration]),
            Some((quaternion, axis)) => Coordinate::turn(self.name, quaternion, axis, [rate, acceleration]),
        }
    }
}
