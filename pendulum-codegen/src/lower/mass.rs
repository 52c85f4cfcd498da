//! Lowering of mass properties to spatial inertia in the body frame.

use proc_macro2::TokenStream;
use syn::Ident;

use super::Lower;
use super::expr::Place;
use super::joint::rotation;
use crate::ast::{Inertia, Properties};
use crate::error::{Code, Reported};
use crate::expr::Expr;
use crate::model::{Figure, FigureKind, Requirement};
use crate::screw::{SpatialInertia, Symmetric3, Vec3};

/// Mass properties, before the axis of a scalar inertia is known.
#[derive(Clone, Debug)]
pub(super) struct Mass<'g> {
    /// Mass properties without the scalar inertia.
    rigid: SpatialInertia<'g>,
    about_axis: Option<AboutAxis<'g>>,
    /// Figures to draw.
    pub(super) figures: Vec<Figure<'g>>,
}

/// Scalar inertia about the axis that the body turns about.
#[derive(Clone, Debug)]
struct AboutAxis<'g> {
    moment: Expr<'g>,
    /// Inertia of the mass at the centre of mass, if the scalar is about the joint and thus includes it.
    included: Option<Symmetric3<'g>>,
    tokens: TokenStream,
}

/// Axes that a body may turn about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Turns<'g> {
    /// No axis: the body does not turn.
    Never,
    /// One axis, given in the body frame.
    About(Vec3<'g>),
    /// Several axes.
    Freely,
}

impl<'g> Lower<'g> {
    /// Spatial inertia of a body in its own frame, and its figures.
    pub(super) fn inertia(
        &mut self,
        body: &Ident,
        mass: Option<(Mass<'g>, Turns<'g>)>,
    ) -> Result<(SpatialInertia<'g>, Vec<Figure<'g>>), Reported> {
        let Some((mass, turns)) = mass else {
            return Ok((SpatialInertia::zero(self.graph), Vec::new()));
        };
        let mut rigid = mass.rigid;
        match (mass.about_axis, turns) {
            (None, _) | (_, Turns::Never) => {}
            (Some(given), Turns::About(axis)) => {
                if let Some(included) = given.included {
                    let about_com = given.moment - axis.dot(included * axis);
                    self.physical_about_axis(body, &given.tokens, given.moment, about_com);
                }
                rigid.about_origin = rigid.about_origin + Symmetric3::outer(given.moment, axis);
            }
            (Some(given), Turns::Freely) => {
                let fact =
                    format!("the inertia of `{body}` is one number, but the body turns about more than one axis");
                let help = "give the principal moments `[ixx, iyy, izz]`, or all six entries `[ixx, iyy, izz, ixy, \
                            ixz, iyz]`";
                return Err(self.errors.on(Code::MassProperties, given.tokens, fact, help));
            }
        }
        Ok((rigid, mass.figures))
    }

    /// Mass properties of a body or shape. A field may be missing because of the error `unread`.
    pub(super) fn mass(
        &mut self,
        owner: &Ident,
        properties: &Properties,
        unread: Option<Reported>,
    ) -> Result<Mass<'g>, Reported> {
        let Some(solids) = &properties.solids else {
            return self.direct(owner, properties, unread);
        };
        let Properties { mass, com, inertia, .. } = properties;
        let com = com.as_ref().map(|com| &com.components[0]);
        let inertia = inertia.as_ref().map(|inertia| &inertia.entries[0]);
        if let Some(other) = mass.as_ref().or(com).or(inertia) {
            let help = "give either `solids`, or `mass`, `com` and `inertia`";
            return Err(self.errors.at(
                Code::MassProperties,
                other.span(),
                format_args!("the mass properties of `{owner}` follow from its solids"),
                help,
            ));
        }
        Ok(Mass {
            rigid: self.solids(owner, solids)?,
            about_axis: None,
            figures: std::mem::take(&mut self.figures),
        })
    }

    /// Mass, centre of mass and inertia as given.
    fn direct(
        &mut self,
        owner: &Ident,
        properties: &Properties,
        unread: Option<Reported>,
    ) -> Result<Mass<'g>, Reported> {
        let Properties { mass, com, inertia, .. } = properties;
        let of = |what: &str, unit: &'static str| Place::fixed(format!("the {what} of `{owner}`")).in_unit(unit);
        let zero = self.graph.zero();
        if let (None, Some(com), None) = (mass, com, unread) {
            let fact = format!("`{owner}` has a centre of mass but no mass");
            self.errors
                .on(Code::MassProperties, com, fact, "give it `mass: ..`, or remove `com`");
        }
        let mass = mass
            .as_ref()
            .map_or(Ok(zero), |e| self.positive(e, &of("mass", "kg"), Requirement::Positive));
        let com = com.as_ref().map_or(Ok(Vec3::zero(self.graph)), |v| {
            self.vector(v, &of("centre of mass", "m"))
        });
        let moments = inertia.as_ref().map(|inertia| self.moments(owner, inertia));
        let (mass, com, moments) = (mass?, com?, moments.transpose()?);
        let mut mass = Mass {
            rigid: SpatialInertia::of_body(mass, com, Symmetric3::zero(self.graph)),
            about_axis: None,
            figures: stick(com),
        };
        if let Some((inertia, moments)) = inertia.as_ref().zip(moments) {
            self.add_inertia(&mut mass, owner, inertia, moments);
        }
        Ok(mass)
    }

    /// Adds the rotational inertia of a body to the inertia of its mass at the centre of mass.
    fn add_inertia(&mut self, mass: &mut Mass<'g>, owner: &Ident, inertia: &Inertia, moments: Moments<'g>) {
        let about_origin = &mut mass.rigid.about_origin;
        let shift = *about_origin;
        // moments about the joint already include the mass at the centre of mass
        if inertia.about_joint {
            *about_origin = Symmetric3::zero(self.graph);
        }
        match moments {
            Moments::AboutAxis(moment) => {
                let what = format!("the inertia of `{owner}`");
                self.require(&inertia.entries[0], moment, Requirement::NonNegative, &what);
                mass.about_axis = Some(AboutAxis {
                    moment,
                    included: inertia.about_joint.then_some(shift),
                    tokens: inertia.tokens.clone(),
                });
            }
            Moments::All(moments) => {
                *about_origin = *about_origin + moments;
                let about_com = if inertia.about_joint { moments - shift } else { moments };
                self.physical(owner, inertia, about_com);
            }
        }
    }

    fn moments(&mut self, owner: &Ident, inertia: &Inertia) -> Result<Moments<'g>, Reported> {
        let place = Place::fixed(format!("the inertia of `{owner}`")).in_unit("kg m^2");
        let entries: Vec<_> = inertia.entries.iter().map(|e| self.expr(e, &place)).collect();
        let entries: Vec<_> = entries.into_iter().collect::<Result<_, _>>()?;
        let zero = self.graph.zero();
        let rpy = inertia.rpy.as_ref().map(|rpy| {
            let place = Place::fixed(format!("the angle of the inertia of `{owner}`")).in_unit("rad");
            self.vector(rpy, &place)
        });
        let rotation = rpy.transpose()?.map(rotation);
        let turned = |moments: Symmetric3<'g>| rotation.map_or(moments, |rotation| moments.rotated(rotation));
        match entries[..] {
            [about_axis] => Ok(Moments::AboutAxis(about_axis)),
            [xx, yy, zz] => Ok(Moments::All(turned(Symmetric3([xx, yy, zz, zero, zero, zero])))),
            [xx, yy, zz, xy, xz, yz] => Ok(Moments::All(turned(Symmetric3([xx, yy, zz, xy, xz, yz])))),
            _ => {
                let help = "give one number (planar scenes), `[ixx, iyy, izz]`, or `[ixx, iyy, izz, ixy, ixz, iyz]`";
                Err(self.errors.on(
                    Code::Arguments,
                    &inertia.tokens,
                    format_args!("the inertia of `{owner}` has {} entries", entries.len()),
                    help,
                ))
            }
        }
    }
}

/// Figure of a body of which only the centre of mass is known.
fn stick(com: Vec3<'_>) -> Vec<Figure<'_>> {
    vec![Figure {
        kind: FigureKind::Mass,
        points: vec![com, Vec3::zero(com[0].graph())],
        radius: None,
    }]
}

/// Rotational inertia, as given.
enum Moments<'g> {
    /// About the one axis that the body turns about.
    AboutAxis(Expr<'g>),
    /// About all axes.
    All(Symmetric3<'g>),
}
