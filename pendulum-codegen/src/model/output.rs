//! Quantities that a model evaluates.

use crate::expr::Expr;

/// A quantity to evaluate, with its rate and its derivatives.
#[derive(Clone, Debug)]
pub(crate) struct Output<'g> {
    /// Name.
    pub name: String,
    /// Documentation, line by line.
    pub docs: Vec<String>,
    /// What it is.
    pub shape: OutputShape,
    /// Its components, those of a matrix column by column.
    pub values: Vec<Expr<'g>>,
}

/// What an output is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum OutputShape {
    /// One number.
    Scalar,
    /// A list of this many.
    Vector(usize),
    /// The position of a point.
    Point,
    /// A rotation.
    Rotation,
}

/// A function whose zeros are events.
#[derive(Clone, Debug)]
pub(crate) struct Event<'g> {
    /// Name.
    pub name: String,
    /// Documentation, line by line.
    pub docs: Vec<String>,
    /// What passes zero.
    pub value: Expr<'g>,
    /// Whether the motion has a kink there.
    pub is_kink: bool,
}

impl Output<'_> {
    /// The names of its components: `tip` for one number, `tip.x` for the three of a point, `tip[0]` of other lists.
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
