//! Templates of controllers, filled.

use super::{Ilqr, LinearLaw, Weights};
use crate::emit::c::Scene;
use crate::emit::c::block::{Calls, number};
use crate::emit::c::template::lines;
use crate::program::Role;

/// Functions of the platform and of the generator that the templates call.
const CALLED: [&str; 5] = [
    "PENDULUM_SQRT",
    "Pendulum_abs",
    "Pendulum_is_finite",
    "Pendulum_max",
    "Pendulum_min",
];

impl Scene<'_> {
    /// Declarations of a controller. Empty without one.
    pub(in crate::emit::c) fn controller_header(&self) -> String {
        let Some(controller) = self.controller else {
            return String::new();
        };
        let law = controller
            .linear
            .as_ref()
            .map(|_| self.fill(include_str!("../templates/linear.h"), &[]));
        let ilqr = controller.ilqr.as_ref().map(|ilqr| {
            let values = [("steps", ilqr.steps.to_string()), ("h", number(ilqr.h))];
            self.fill(include_str!("../templates/ilqr.h"), &values)
        });
        let inputs = [("inputs", self.inputs.len().to_string())];
        let own = self.fill(include_str!("../templates/controller.h"), &inputs);
        own + &law.unwrap_or_default() + &ilqr.unwrap_or_default()
    }

    /// Definitions of a controller. Empty without one.
    pub(in crate::emit::c) fn controller_source(&self, calls: &mut Calls) -> String {
        let Some(controller) = self.controller else {
            return String::new();
        };
        calls.extend(CALLED.map(String::from));
        let [low, high] = controller.limits_of(self.inputs.len());
        let given = self.inputs.iter().enumerate();
        let own = [
            (
                "given",
                lines(given.map(|(m, input)| format!("given.{input} = u[{m}];"))),
            ),
            ("project", self.project("t1")),
            ("low", list(&low)),
            ("high", list(&high)),
        ];
        let law = controller.linear.as_ref().map(|LinearLaw { gain, x0, u0 }| {
            let values = [("gain", table(gain, u0.len())), ("x0", list(x0)), ("u0", list(u0))];
            self.fill(include_str!("../templates/linear.c"), &values)
        });
        self.fill(include_str!("../templates/controller.c"), &own)
            + &law.unwrap_or_default()
            + &controller.ilqr.as_ref().map(|ilqr| self.ilqr(ilqr)).unwrap_or_default()
    }

    fn ilqr(&self, ilqr: &Ilqr) -> String {
        let (n, m) = (self.program.layout.len(), self.inputs.len());
        let Weights { end, goal, start } = ilqr.weights(n, m);
        let turns = self.program.layout.quaternions().next().is_some();
        let starts = self.program.layout.quaternions().map(|places| places.start);
        let normalised = starts
            .map(|start| format!("Pendulum_normalise(N, a, end, {start});\nPendulum_normalise(M, b, end, {start});\n"));
        let end_of_step = "double end[N];\nfor (int n = 0; n < N; n++) end[n] = h * rate[n] + x[n];\n";
        let values = [
            ("q", rows(&ilqr.q, n)),
            ("r", rows(&ilqr.r, m)),
            ("end", rows(&end, n)),
            ("goal", list(&goal[0])),
            ("rest", list(&goal[1])),
            ("start", table(&start, m)),
            ("ones", vec!["1"; m].join(", ")),
            ("project", self.project("t + h")),
            (
                "normalise",
                if turns {
                    include_str!("../templates/normalise.c")
                } else {
                    ""
                }
                .to_owned(),
            ),
            (
                "normalised",
                if turns {
                    end_of_step.to_owned() + &normalised.collect::<String>()
                } else {
                    String::new()
                },
            ),
        ];
        self.fill(include_str!("../templates/ilqr.c"), &values)
    }

    /// Call that projects the state `out` at a time, if the model has invariants.
    fn project(&self, t: &str) -> String {
        let given = match self.program.with_role(Role::LoopCorrections) {
            Some(_) => format!("model, {t}, "),
            None => String::new(),
        };
        match self.program.layout.quaternions().next().is_some() || !given.is_empty() {
            true => format!("{}_project({given}out);", self.name),
            false => String::new(),
        }
    }
}

/// Numbers of an array, in one line.
fn list(numbers: &[f64]) -> String {
    let limit = |value: f64| match value.is_finite() {
        true => number(value),
        false => format!("{}HUGE_VAL", if value < 0.0 { "-" } else { "" }),
    };
    let numbers: Vec<String> = numbers.iter().copied().map(limit).collect();
    numbers.join(", ")
}

/// Numbers of an array, with the given number in each line.
fn rows(numbers: &[f64], columns: usize) -> String {
    lines(numbers.chunks(columns).map(|row| list(row) + ","))
}

/// Numbers of an array of arrays.
fn table(numbers: &[f64], columns: usize) -> String {
    lines(numbers.chunks(columns).map(|row| format!("{{{}}},", list(row))))
}
