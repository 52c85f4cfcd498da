//! The two files: types, and the model with its checks.

use super::Scene;
use super::block::{Calls, number, statements};
use super::functions::functions;
use super::names::{identifiers, words};
use super::single::single_functions;
use super::template::{fill, lines};
use crate::program::{Condition, FINITE_CONSTANT, FINITE_PARAMETER, Quantity, ROUNDING, SlotKind};

impl Scene<'_> {
    /// Header for a source that calls the functions with these heads.
    pub(super) fn header(&self, heads: &[String]) -> String {
        let program = self.program;
        let [positions, rates] = program.layout.components();
        let slots = || program.layout.slots.iter();
        let units = slots().flat_map(|slot| slot.positions.clone().map(|n| (n, "", slot.kind.unit())));
        let units_of_rates = slots().flat_map(|slot| {
            let of = match slot.kind {
                SlotKind::Quaternion => "the angular velocity of ",
                _ => "the rate of ",
            };
            slot.rates.clone().map(move |n| (n, of, slot.kind.rate_unit()))
        });
        let names = positions.iter().chain(&rates);
        let state = units.chain(units_of_rates).zip(names);
        let state = state.map(|((n, of, unit), name)| format!("x[{n}]  {of}{name}, in {unit}"));
        let states = program.layout.states.iter();
        let state = state.chain(states.map(|own| format!("x[{}]  {}, in {}", own.index, own.name, own.unit)));
        let meanings = program.constants_text.iter().enumerate();
        let codes = (1..).zip(self.codes()).zip(self.rules());
        let code = |((n, code), rule): ((usize, String), String)| format!("/// {rule}\n{code} = {n},");
        let platform = heads.iter().filter(|head| head.contains(':')).cloned();
        let of_number = match (self.fused, self.is_single()) {
            (true, _) => " for Fused<f64>, up to the coefficients of series",
            (_, true) => " for f32",
            _ => "",
        };
        let values = [
            ("docs", program.docs.join("\n")),
            ("state", lines(state)),
            ("equations", program.equations.to_string()),
            ("number", of_number.to_owned()),
            ("platform", lines(platform)),
            ("parameters", fields(&program.parameters, &self.parameters)),
            ("defaults", self.defaults(include_str!("templates/defaults.h"))),
            ("inputs", self.real(self.inputs())),
            ("real", self.real("double".to_owned()).trim_end().to_owned()),
            ("meanings", lines(meanings.map(|(n, text)| format!("k[{n}] = {text}")))),
            ("codes", lines(codes.map(code))),
            ("last", (self.rules().len() + 1).to_string()),
            ("fused", self.of_fused(include_str!("templates/fused.h"))),
            ("routines", self.real(self.declarations())),
            ("controller", self.real(self.controller_header())),
        ];
        self.fill(include_str!("templates/header.h"), &values)
    }

    /// Source, and the heads of the functions that it calls.
    pub(super) fn source(&self) -> (String, Vec<String>) {
        let (program, mut calls) = (self.program, Calls::new());
        let refuse = |code: &str, holds| format!("if (!({holds})) return {code};\n");
        let codes = self.codes();
        let (codes, of_rules) = codes.split_at(self.parameters.len());
        let finite = |(code, field): (&String, &String)| refuse(code, format!("Pendulum_is_finite(params->{field})"));
        let (mut checks, checked) = self.plain_code(&program.checked, &mut calls);
        checks += &statements(&checked, |n| format!("const double r{n}"));
        for (code, rule) in of_rules.iter().zip(&program.rules) {
            let holds = match rule.condition {
                Condition::Positive => format!("r{} > 0.0", rule.value),
                Condition::NonNegative => format!("r{} >= 0.0", rule.value),
                Condition::NonNegativeWithin(scale) => {
                    calls.insert("Pendulum_abs".to_owned());
                    format!("r{} >= {} * Pendulum_abs(r{scale})", rule.value, number(-ROUNDING))
                }
            };
            checks += &refuse(code, holds);
        }
        let (code, constants) = self.plain_code(&program.constants, &mut calls);
        let texts = self.rules().into_iter().chain([FINITE_CONSTANT.to_owned()]);
        if self.fused {
            calls.insert("PENDULUM_FMA".to_owned());
        }
        calls.insert("Pendulum_is_finite".to_owned());
        let mut later = Calls::new();
        let routines = self.real(self.routines(&mut later));
        let controller = self.real(self.controller_source(&mut later));
        let (heads, functions): (Vec<String>, Vec<String>) = self.functions(calls, later).into_iter().unzip();
        // constants are computed in double precision, as in Rust
        let [real, back] = match self.is_single() {
            true => ["(float)k[i]", "(double)(float)k[i]"],
            false => ["k[i]"; 2],
        };
        let only_if = |holds: bool, text: &str| if holds { text.to_owned() } else { String::new() };
        let is_infinite = [&routines, &controller].iter().any(|code| code.contains("HUGE_VAL"));
        let values = [
            ("fused", self.of_fused(include_str!("templates/fused.c"))),
            ("routines", routines),
            ("controller", controller),
            ("functions", functions.concat()),
            ("infinite", only_if(is_infinite, "#include <math.h>")),
            ("single", only_if(self.is_single(), include_str!("templates/single.c"))),
            ("real_k", real.to_owned()),
            ("kept_k", back.to_owned()),
            ("defaults", self.defaults(include_str!("templates/defaults.c"))),
            ("finite", codes.iter().zip(&self.parameters).map(finite).collect()),
            ("checks", checks),
            ("code", code + &statements(&constants, |n| format!("k[{n}]"))),
            ("texts", lines(texts.map(|text| format!("{text:?},")))),
        ];
        (self.fill(include_str!("templates/source.c"), &values), heads)
    }

    /// Heads and code of the functions that are called to build the model, and later.
    fn functions(&self, mut calls: Calls, later: Calls) -> Vec<(String, String)> {
        let owned = |(head, code): (&str, &str)| (head.to_owned(), code.to_owned());
        if self.is_single() {
            return functions(&calls).map(owned).chain(single_functions(&later)).collect();
        }
        calls.extend(later);
        functions(&calls).map(owned).collect()
    }

    /// Fills a template for fused arithmetic. Empty if sums are not fused.
    fn of_fused(&self, template: &str) -> String {
        if self.fused {
            self.fill(template, &[])
        } else {
            String::new()
        }
    }

    /// Fills a template for the default parameters. Empty if a parameter has no default. C has no empty structures.
    fn defaults(&self, template: &str) -> String {
        let defaults = self.program.parameters.iter().map(|parameter| parameter.default);
        let Some(values) = defaults.collect::<Option<Vec<f64>>>() else {
            return String::new();
        };
        let values = lines(values.into_iter().map(|value| number(value) + ","));
        let values = if values.is_empty() { "0.0".to_owned() } else { values };
        self.fill(template, &[("values", values)])
    }

    /// Structure of the inputs, if there are any.
    fn inputs(&self) -> String {
        let template = include_str!("templates/inputs.h");
        let template = if self.inputs.is_empty() { "" } else { template };
        self.fill(template, &[("fields", fields(&self.program.inputs, &self.inputs))])
    }

    /// Names of the error codes, in the order of [`rules`](Self::rules): the parameter, or the combination of
    /// parameters, followed by the error.
    fn codes(&self) -> Vec<String> {
        let finite = self
            .program
            .parameters
            .iter()
            .map(|parameter| (&parameter.name, "NOT_FINITE"));
        let rules = self.program.rules.iter().map(|rule| match rule.condition {
            Condition::Positive => (&rule.name, "NOT_POSITIVE"),
            Condition::NonNegative | Condition::NonNegativeWithin(_) => (&rule.name, "NEGATIVE"),
        });
        let code = |(name, what): (&String, &str)| format!("{}_{}_{what}", self.name, words(name)).to_uppercase();
        identifiers(&finite.chain(rules).map(code).collect::<Vec<_>>())
    }

    /// Rules for parameters, as text.
    fn rules(&self) -> Vec<String> {
        let (parameters, rules) = (&self.program.parameters, &self.program.rules);
        let finite = parameters.iter().map(|parameter| (&parameter.name, FINITE_PARAMETER));
        let rules = finite.chain(rules.iter().map(|rule| (&rule.name, rule.text.as_str())));
        rules.map(|(name, text)| format!("`{name}`: {text}")).collect()
    }
}

/// Fields of a structure. C has no structures without fields.
pub(super) fn fields(quantities: &[Quantity], names: &[String]) -> String {
    let field = |(quantity, name): (&Quantity, &String)| {
        let is_number = quantity.unit == "1";
        let unit = if is_number { "a plain number" } else { &quantity.unit };
        let docs = lines(quantity.docs.iter().cloned());
        let values = [("docs", docs), ("unit", unit.to_owned()), ("name", name.clone())];
        fill("///@docs@\n/// Unit: @unit@.\ndouble @name@;", &values)
    };
    match names {
        [] => "double unused;".to_owned(),
        names => quantities.iter().zip(names).map(field).collect(),
    }
}
