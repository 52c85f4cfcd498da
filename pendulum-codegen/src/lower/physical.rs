//! Conditions on numbers, checked now for constants, or by `new` for expressions of parameters.

use std::collections::BTreeSet;

use proc_macro2::TokenStream;
use quote::ToTokens;
use syn::Ident;

use super::Lower;
use super::expr::Place;
use crate::ast::{self, Inertia};
use crate::error::{Code, Reported};
use crate::expr::{Expr, Level, Printer, Symbol, SymbolKind};
use crate::model::{Parameter, Requirement, Rule};
use crate::screw::Symmetric3;

/// Triangle inequality for each axis: the sum of the first two principal moments is at least the third.
const TRIANGLES: [[&str; 3]; 3] = [["iyy", "izz", "ixx"], ["ixx", "izz", "iyy"], ["ixx", "iyy", "izz"]];

impl<'g> Lower<'g> {
    /// Lowers an expression that must be positive, or must not be negative.
    pub(super) fn positive(
        &mut self,
        e: &ast::Expr,
        place: &Place<'g>,
        requirement: Requirement<'g>,
    ) -> Result<Expr<'g>, Reported> {
        let value = self.expr(e, place)?;
        self.require(e, value, requirement, &place.what);
        Ok(value)
    }

    /// Checks the sign of a value; `what` names it in errors.
    pub(super) fn require(&mut self, at: &impl ToTokens, value: Expr<'g>, requirement: Requirement<'g>, what: &str) {
        let must = if requirement == Requirement::Positive {
            "must be positive"
        } else {
            "must not be negative"
        };
        if let Some(number) = self.broken_by(value, requirement) {
            let fact = format_args!("{what} is {number}");
            self.errors.on(Code::OutOfBounds, at, fact, format_args!("it {must}"));
        } else if value.level() == Level::Parameter {
            let name = Printer::new(self.graph).print(value.id());
            self.rule(Rule {
                value,
                requirement,
                name,
                text: format!("{what} {must}"),
            });
        }
    }

    /// Checks a rotational inertia about the centre of mass.
    ///
    /// An inertia is physical exactly if `tr(J)/2 - J`, the matrix of second moments, has no negative eigenvalue
    /// (Traversaro et al. 2016), that is, if none of its principal minors is negative.
    pub(super) fn physical(&mut self, owner: &Ident, inertia: &Inertia, about_com: Symmetric3<'g>) {
        let diagonal = inertia.entries.len() == 3 && inertia.rpy.is_none() && !inertia.about_joint;
        for (n, (value, scale)) in minors(about_com).into_iter().enumerate().filter(|_| !inertia.judged) {
            let requirement = Requirement::NonNegativeWithin(scale);
            if self.broken_by(value, requirement).is_some() {
                let (fact, help) = match TRIANGLES.get(n) {
                    Some([p, q, r]) if diagonal => {
                        let text = |name: &str| {
                            let at = ["ixx", "iyy", "izz"]
                                .iter()
                                .position(|known| *known == name)
                                .unwrap_or(0);
                            Printer::new(self.graph).print(about_com.0[at].id())
                        };
                        let [a, b, c] = [p, q, r].map(|name| text(name));
                        let fact = format!("principal moments violate the triangle inequality: {a} + {b} < {c}");
                        (fact, format!("a rigid body needs {p} + {q} >= {r}"))
                    }
                    _ => (
                        format!(
                            "no rigid body has the inertia of `{owner}`: its principal moments about the centre of \
                             mass violate the triangle inequality"
                        ),
                        "check the signs, the order [ixx, iyy, izz, ixy, ixz, iyz], and the reference point".to_owned(),
                    ),
                };
                self.errors.on(Code::NotARigidBody, &inertia.tokens, fact, help);
                return;
            }
            if value.level() == Level::Parameter {
                let text = match TRIANGLES.get(n) {
                    Some([p, q, r]) => {
                        format!("the inertia of `{owner}` about its centre of mass must satisfy {p} + {q} >= {r}")
                    }
                    None => format!("the principal moments of inertia of `{owner}` must obey the triangle inequality"),
                };
                self.rule(Rule {
                    value,
                    requirement,
                    name: format!("inertia of {owner}"),
                    text,
                });
            }
        }
    }

    /// Checks an inertia about the joint axis: the remainder about the centre of mass must not be negative.
    pub(super) fn physical_about_axis(
        &mut self,
        owner: &Ident,
        at: &TokenStream,
        about_axis: Expr<'g>,
        about_com: Expr<'g>,
    ) {
        let requirement = Requirement::NonNegativeWithin(about_axis);
        if let Some(number) = self.broken_by(about_com, requirement) {
            let fact = format!(
                "the inertia of `{owner}` about its joint is too small: about the centre of mass it is {number}"
            );
            self.errors.on(
                Code::NotARigidBody,
                at,
                fact,
                "it must be at least the mass times the squared distance of the centre of mass from the axis",
            );
        } else if about_com.level() == Level::Parameter {
            let text = format!(
                "the inertia of `{owner}` about its joint must not be less than that of its mass at the centre of mass"
            );
            self.rule(Rule {
                value: about_com,
                requirement,
                name: format!("inertia of {owner}"),
                text,
            });
        }
    }

    /// Reports defaults that `new` would reject, with one rule for each parameter.
    pub(super) fn report_refused_defaults(&mut self, params: &[ast::Param], parameters: &[Parameter<'g>]) {
        let value_of = |symbol: &Symbol| match symbol.kind {
            SymbolKind::Parameter(n) => parameters[n].default.unwrap_or(f64::NAN),
            _ => f64::NAN,
        };
        let mut reported = BTreeSet::new();
        for rule in self.rules.iter().chain(&self.for_defaults) {
            let symbols = self.graph.reachable(&[rule.value]);
            let mut read = parameters
                .iter()
                .zip(params)
                .filter(|(p, _)| symbols.contains(&p.symbol.id()));
            let Some((parameter, param)) = read.next_back() else {
                continue;
            };
            let values = [rule.value, rule.requirement.scale().unwrap_or(rule.value)];
            let [value, scale] = self.graph.evaluate(&values, value_of)[..] else {
                continue;
            };
            if value.is_nan() || rule.requirement.allows(value, scale.abs()) || !reported.insert(&parameter.name) {
                continue;
            }
            if let Some(Ok(default)) = &param.default {
                let fact = format!("invalid default of `{}`: {}", parameter.name, rule.text);
                self.errors
                    .on(Code::RefusedDefault, default, fact, "change the default, or remove it");
            }
        }
    }

    /// Value of a constant that violates a requirement.
    pub(super) fn broken_by(&self, value: Expr<'g>, requirement: Requirement<'g>) -> Option<f64> {
        let scale = requirement.scale().map_or(Some(0.0), Expr::constant)?.abs();
        value.constant().filter(|&number| !requirement.allows(number, scale))
    }

    pub(super) fn rule(&mut self, rule: Rule<'g>) {
        let same = |known: &Rule<'g>| known.value == rule.value && known.requirement == rule.requirement;
        if !self.rules.iter().any(same) {
            self.rules.push(rule);
        }
    }
}

/// Principal minors of `tr(J) - 2 J`, each with a number of the size of its terms.
fn minors(about_com: Symmetric3<'_>) -> [(Expr<'_>, Expr<'_>); 7] {
    let [xx, yy, zz, xy, xz, yz] = about_com.0;
    let trace = xx + yy + zz;
    let (square, cube) = (trace.powi(2), trace.powi(3));
    let [a, b, c] = [xx, yy, zz].map(|moment| trace - 2 * moment);
    // the off-diagonal entries are -2 J_ij; their signs matter in the determinant only
    let [d, e, f] = [xy, xz, yz].map(|product| -(2 * product));
    let (ab, ac, bc) = (a * b - d * d, a * c - e * e, b * c - f * f);
    // by expansion along the first row
    let determinant = a * bc - d * (d * c - e * f) + e * (d * f - b * e);
    [
        (a, trace),
        (b, trace),
        (c, trace),
        (ab, square),
        (ac, square),
        (bc, square),
        (determinant, cube),
    ]
}
