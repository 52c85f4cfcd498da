//! Routines and the power series as C functions.

use super::Scene;
use super::block::{Calls, Piece, statements};
use super::names::function;
use super::template::lines;
use crate::emit::CORRECTIONS;
use crate::expr::Precedence;
use crate::program::{Argument, Role, Routine, Series, Shape};

impl Scene<'_> {
    /// Documentation and prototypes of routines and series.
    pub(super) fn declarations(&self) -> String {
        let declaration = |routine: &Routine| {
            let docs = documentation(routine) + &self.about_forces(routine);
            let values = [("docs", docs), ("prototype", self.prototype(routine))];
            self.fill("\n/// @docs@\n@prototype@;", &values)
        };
        let routines: String = self.program.routines.iter().map(declaration).collect();
        let series = self.program.series.iter();
        routines
            + &self
                .projection()
                .map(|[docs, prototype]| self.fill(&format!("\n/// {docs}\n{prototype};"), &[]))
                .unwrap_or_default()
            + &series
                .map(|_| self.fill(include_str!("templates/series.h"), &[]))
                .collect::<String>()
    }

    /// Documentation of the forces along the constraints, if a routine takes them.
    fn about_forces(&self, routine: &Routine) -> String {
        if !routine.arguments.contains(&Argument::Forces) {
            return String::new();
        }
        let constraints = self.program.constraints.iter();
        let names: Vec<&str> = constraints.map(|constraint| constraint.name.as_str()).collect();
        format!(
            "forces: the force along each constraint, {}, in N or N m; for kinetic friction mu, -mu times the sign of \
             the rate.",
            names.join(", ")
        )
    }

    /// Definitions of routines and series.
    pub(super) fn routines(&self, calls: &mut Calls) -> String {
        let routines = self.program.routines.iter();
        let routines: String = routines.map(|routine| self.routine(routine, calls)).collect();
        let series = self.program.series.as_ref();
        let projection = self.projection().map(|[_, prototype]| {
            let body = self.fill(&self.projected(calls), &[]);
            self.fill(&format!("\n{prototype} {{\n    @body@\n}}"), &[("body", body)])
        });
        let projection = projection.unwrap_or_default();
        routines + &projection + &series.map(|series| self.series(series, calls)).unwrap_or_default()
    }

    /// Documentation and prototype of the function that normalises quaternions and closes loops, if the model has any.
    fn projection(&self) -> Option<[String; 2]> {
        let closes = self.program.with_role(Role::LoopCorrections).is_some();
        let turns = self.program.layout.quaternions().next().is_some();
        let docs = match (turns, closes) {
            (false, false) => return None,
            (true, false) => "Normalises the quaternions of a state. Call it after each step.",
            (false, true) => {
                "Closes the loops of a state. Call it after each step, and on a guess until nothing changes."
            }
            (true, true) => {
                "Normalises the quaternions of a state and closes its loops. Call it after each step, and on a guess \
                 until nothing changes."
            }
        };
        let model = if closes {
            "const @name@_model *model, double t, "
        } else {
            ""
        };
        let prototype = format!("void @name@_project({model}double x[@length@])");
        Some([docs.to_owned(), prototype])
    }

    /// Body of the projection function.
    fn projected(&self, calls: &mut Calls) -> String {
        let mut body = String::new();
        let norms = self.program.layout.quaternions().map(|places| {
            calls.insert("PENDULUM_SQRT".to_owned());
            let square = places.clone().map(|n| format!("x[{n}] * x[{n}]"));
            let norm = format!("norm = PENDULUM_SQRT({});\n", square.collect::<Vec<_>>().join(" + "));
            norm + &lines(places.map(|n| format!("x[{n}] /= norm;")))
        });
        let norms: String = norms.collect();
        if !norms.is_empty() {
            body += &format!("double norm;\n{norms}");
        }
        let places: Vec<usize> = self.program.layout.dependents().collect();
        if !places.is_empty() {
            let corrected = places
                .iter()
                .enumerate()
                .map(|(n, place)| format!("    x[{place}] += correction[{n}];"));
            body += &format!(
                "double correction[{}];\nint n;\nfor (n = 0; n < {CORRECTIONS}; n++) {{\n    \
                 @name@_loop_corrections(model, t, x, correction);\n{}}}\n",
                places.len(),
                lines(corrected)
            );
        }
        body
    }

    pub(super) fn routine(&self, routine: &Routine, calls: &mut Calls) -> String {
        let (code, results) = self.code(&routine.block, calls);
        let body = code + &stores(routine, &results);
        let values = [("prototype", self.prototype(routine)), ("body", body)];
        self.fill("\n@prototype@ {\n    @body@\n}", &values)
    }

    fn prototype(&self, routine: &Routine) -> String {
        let arguments = routine.arguments.iter().map(|argument| match argument {
            Argument::Inputs => ", const @name@_inputs *u".to_owned(),
            Argument::Forces => self.forces(),
            Argument::Accelerations => format!(", const double qdd[{}]", self.program.layout.dof()),
            Argument::Weights => ", const double weights[@length@]".to_owned(),
            Argument::Direction => {
                let length = self.program.layout.len() + self.program.inputs.len();
                format!(", const double direction[{length}]")
            }
        });
        let results = outs(routine).map(|(out, shape)| match shape {
            Shape::Symmetric(n) => format!(", double {out}[{}]", n * n),
            shape => format!(", double {out}[{}]", shape.len()),
        });
        let more: String = arguments.chain(results).collect();
        let kind = outs(routine).next().map_or("double", |_| "void");
        let name = format!("{kind} @name@_{}", function(&routine.name));
        let prototype = format!("{name}(const @name@_model *model, double t, const double x[@length@]{more})");
        self.fill(&prototype, &[]).trim_end().to_owned()
    }

    /// Argument for the forces along the constraints. Empty if there are none.
    pub(super) fn forces(&self) -> String {
        match self.program.constraints.len() {
            0 => String::new(),
            constraints => format!(", const double forces[{constraints}]"),
        }
    }

    fn series(&self, series: &Series, calls: &mut Calls) -> String {
        let (start, results) = self.code(&series.start, calls);
        let (rates, kept) = results.split_at(self.program.layout.len());
        let rates = statements(rates, |n| format!("series[1][{n}]"));
        let start = start + &rates + &statements(kept, |n| format!("kept[{n}]"));
        // forces along the constraints are constant, so both blocks can run at once
        let mut order = series.before.clone();
        order.lets.extend(series.order.lets.iter().cloned());
        order.names.clone_from(&series.order.names);
        order.results.clone_from(&series.order.results);
        let (order, results) = self.code(&order, calls);
        let (rates, sides) = results.split_at(self.program.layout.len());
        let (left, right) = sides.split_at(series.products);
        let left = statements(left, |n| format!("left[{n}]"));
        let right = statements(right, |n| format!("right[{n}]"));
        let next = rates.iter().map(|rate| rate.within(Precedence::Product)).enumerate();
        let next = lines(next.map(|(n, rate)| format!("series[k + 1][{n}] = {rate} * over_next;")));
        let values = [("start", start), ("order", order + &left + &right + &next)];
        self.fill(include_str!("templates/series.c"), &values)
    }
}

/// Documentation of a routine and of the memory layout of its results.
fn documentation(routine: &Routine) -> String {
    let results = outs(routine).map(|(out, shape)| {
        let (rows, columns, kind) = match shape {
            Shape::Symmetric(n) => (n, n, "symmetric "),
            Shape::Matrix(n, m) => (n, m, ""),
            Shape::Scalar => return format!("{out}: a number."),
            Shape::Vector(n) => return format!("{out}: {n} numbers."),
        };
        format!("{out}: a {kind}matrix, {rows} x {columns}; row i of column j is {out}[i + {rows} * j].")
    });
    lines([routine.doc.to_owned()].into_iter().chain(results))
}

/// Results stored through pointers, with their names. A single number is returned instead.
fn outs(routine: &Routine) -> impl Iterator<Item = (String, Shape<usize>)> {
    let shapes = routine.shapes.iter().copied().enumerate();
    let named = |(n, shape)| match routine.shapes.len() {
        1 => ("out".to_owned(), shape),
        _ => (format!("out{n}"), shape),
    };
    let returned = routine.shapes.as_slice() == [Shape::Scalar];
    shapes.map(named).filter(move |_| !returned)
}

/// Statements that store the results of a routine, or return the only one.
fn stores(routine: &Routine, mut results: &[Piece]) -> String {
    if let ([Shape::Scalar], [result]) = (routine.shapes.as_slice(), results) {
        return format!("return {};\n", result.0);
    }
    let store = |(out, shape): (String, Shape<usize>)| {
        let (own, rest) = results.split_at(shape.len());
        results = rest;
        let Shape::Symmetric(size) = shape else {
            return statements(own, |n| format!("{out}[{n}]"));
        };
        let triangle: Vec<_> = (0..size).flat_map(|i| (i..size).map(move |j| (i, j))).collect();
        let both = |(i, j)| match i == j {
            true => format!("{out}[{}]", i + size * i),
            false => format!("{out}[{}] = {out}[{}]", j + size * i, i + size * j),
        };
        statements(own, |n| both(triangle[n]))
    };
    outs(routine).map(store).collect()
}
