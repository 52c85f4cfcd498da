//! Quantities that a model evaluates.

use crate::expr::Expr;

/// A quantity to evaluate, with its rate and its derivatives.
#[derive(Clone, Debug)]
pub(crate) struct Output<'g> {
    /// Name.
    pub name: String,
    /// Documentation, line by line.
    pub docs: Vec<String>,
    /// Kind of quantity.
    pub shape: OutputShape,
    /// Components; those of a matrix are stored column by column.
    pub values: Vec<Expr<'g>>,
    /// Unit of each component, as text; empty if it is unknown.
    pub units: Vec<String>,
}

/// Kind of an output.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum OutputShape {
    /// One number.
    Scalar,
    /// A list of numbers, of this length.
    Vector(usize),
    /// The position of a point.
    Point,
    /// A rotation.
    Rotation,
}

/// An event at the zeros of a function.
#[derive(Clone, Debug)]
pub(crate) struct Event<'g> {
    /// Name.
    pub name: String,
    /// Documentation, line by line.
    pub docs: Vec<String>,
    /// Function whose zeros are the events.
    pub value: Expr<'g>,
    /// True if the motion has a kink at the event.
    pub is_kink: bool,
}

impl Output<'_> {
    /// Names of the components: `tip` for a number, `tip.x` for a point, `tip[0]` for a list, `tip[0, 0]` for a
    /// rotation.
    pub(crate) fn labels(&self) -> Vec<String> {
        let name = self.name.trim_start_matches("r#");
        match self.shape {
            OutputShape::Scalar => vec![name.to_owned()],
            OutputShape::Point => ["x", "y", "z"].map(|axis| format!("{name}.{axis}")).into(),
            OutputShape::Vector(n) => (0..n).map(|k| format!("{name}[{k}]")).collect(),
            OutputShape::Rotation => (0..9).map(|k| format!("{name}[{}, {}]", k % 3, k / 3)).collect(),
        }
    }
}
