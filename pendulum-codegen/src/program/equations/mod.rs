//! Equations of motion as text.

mod compose;
mod lines;
mod names;
mod torques;

use std::fmt::{Display, Formatter, Result};

pub(crate) use compose::equations;
use lines::wrapped;

use crate::expr::{Definition, Formula, latex_definitions};

/// Forms of the equations that are wanted; the others are left empty.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Extent {
    /// None.
    None,
    /// The short form.
    Short,
    /// Both forms.
    Full,
}

/// Equations of motion of a scene: `A qdd + b = Q`.
///
/// `{}` prints them in the shortest form found, with the names of the declaration; `{:#}` prints every `let` and every
/// torque in full. Numbers are those of SI units; only torques that the short form prints as written name theirs. The
/// language of declarations parses both, line by line; a line that starts with spaces continues the one before.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Equations {
    /// Names of the coordinates.
    pub coordinates: Vec<String>,
    /// True if joints are driven.
    pub driven: bool,
    /// True if something acts on the scene beside its joints.
    pub acted: bool,
    /// Short form, with names for repeated parts.
    pub short: Listing,
    /// Full form of the same equations, with torques multiplied out.
    pub full: Listing,
    /// Time derivatives of the first-order states, by their names.
    pub states: Vec<Definition>,
    /// Expressions that vanish where loops without a closed form are closed.
    pub closings: Vec<Formula>,
    /// Constraints.
    pub constraint_forces: Vec<ConstraintForce>,
}

/// Force along a constraint, and its law.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ConstraintForce {
    /// Force along the constraint, as in the equations.
    pub force: Formula,
    /// Law of the force: words, each followed by a formula.
    pub law: Vec<(&'static str, Formula)>,
}

/// Entries of the equations, and definitions of the names in them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Listing {
    /// Nonzero entries: the upper triangle of the mass matrix, the bias, the forces.
    pub rows: Vec<Row>,
    /// Definitions of the names. Each needs only names defined before it.
    pub definitions: Vec<Definition>,
}

/// Entry of the mass matrix, the bias or the forces.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// Matrix or vector of the entry.
    pub kind: RowKind,
    /// Names of its coordinates: two for the mass matrix, one otherwise.
    pub indices: Vec<String>,
    /// Value.
    pub formula: Formula,
}

/// Parts of the equations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum RowKind {
    /// Mass matrix.
    MassMatrix,
    /// Velocity terms and gravity.
    Bias,
    /// Forces of the joints.
    Force,
}

impl RowKind {
    /// Letter in print.
    pub fn letter(self) -> &'static str {
        match self {
            Self::MassMatrix => "A",
            Self::Bias => "b",
            Self::Force => "Q",
        }
    }
}

impl Row {
    /// Left side, such as `A[theta1, theta2]`.
    pub fn entry(&self) -> Formula {
        Formula::Entry(self.kind.letter(), self.indices.clone())
    }
}

impl Display for Listing {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        for row in &self.rows {
            writeln!(f, "{}", wrapped(&format!("{} = {}", row.entry(), row.formula)))?;
        }
        if !self.definitions.is_empty() {
            f.write_str("\nwhere\n")?;
        }
        for Definition { name, formula } in &self.definitions {
            writeln!(f, "{}", wrapped(&format!("{name} = {formula}")))?;
        }
        Ok(())
    }
}

impl Display for Equations {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        if !self.coordinates.is_empty() {
            let [b, q] = self.sides();
            let heading = format!("A qdd + b = Q, where A is symmetric, b holds {b}, Q {q}");
            writeln!(f, "{}\n", wrapped(&heading))?;
            let listing = if f.alternate() { &self.full } else { &self.short };
            Display::fmt(listing, f)?;
            if !self.states.is_empty() {
                f.write_str("\nand the first-order states\n")?;
            }
        }
        for Definition { name, formula } in &self.states {
            writeln!(f, "{}", wrapped(&format!("dot({name}) = {formula}")))?;
        }
        if !self.closings.is_empty() {
            writeln!(f, "\nwith {SOLVED}")?;
        }
        for closing in &self.closings {
            writeln!(f, "{}", wrapped(&format!("0 = {closing}")))?;
        }
        if !self.constraint_forces.is_empty() {
            f.write_str("\nand along the constraints\n")?;
        }
        for ConstraintForce { force, law } in &self.constraint_forces {
            let law = law.iter().map(|(words, formula)| format!("{words} {formula}"));
            writeln!(f, "{}", wrapped(&format!("{force}: {}", law.collect::<String>())))?;
        }
        Ok(())
    }
}

/// Meaning of the names for quantities that closed loops determine by linear equations.
const SOLVED: &str =
    "slope_y_x, the derivative of y by x, and drift_y, the second rate of y where no x accelerates, from";

impl Equations {
    /// Descriptions of `b` and `Q`.
    fn sides(&self) -> [&'static str; 2] {
        [
            match self.driven {
                false => "velocity terms and gravity",
                true => "velocity terms, gravity and the inertia forces of the drives",
            },
            match self.acted {
                false => "the forces of the joints",
                true => "all other forces",
            },
        ]
    }

    /// Returns the short form in LaTeX, a displayed formula for each row, for documents that load `amsmath`.
    pub fn latex(&self) -> String {
        let [b, q] = self.sides();
        let mut text = match self.coordinates.is_empty() {
            true => String::new(),
            false => {
                format!("\\[ A\\,\\ddot{{q}} + b = Q, \\]\nwhere $A$ is symmetric, $b$ holds {b}, and $Q$ {q}:\n")
            }
        };
        for row in &self.short.rows {
            text.push_str(&row.formula.latex_equation(&row.entry()));
        }
        if !self.short.definitions.is_empty() {
            text.push_str("where\n");
        }
        text.push_str(&latex_definitions(&self.short.definitions));
        if !self.states.is_empty() && !self.coordinates.is_empty() {
            text.push_str("and the first-order states\n");
        }
        for Definition { name, formula } in &self.states {
            text.push_str(&formula.latex_equation(&Formula::rate(name)));
        }
        if !self.closings.is_empty() {
            text.push_str(&format!("with {}:\n", SOLVED.replace('_', "\\_")));
        }
        for closing in &self.closings {
            text.push_str(&closing.latex_equation(&Formula::sum(Vec::new())));
        }
        for ConstraintForce { force, law } in &self.constraint_forces {
            let law = law
                .iter()
                .map(|(words, formula)| format!("{words} ${}$", formula.latex()));
            text.push_str(&format!("Along ${}$: {}.\n", force.latex(), law.collect::<String>()));
        }
        text
    }
}
