//! Tables of results.

use std::collections::BTreeMap;
use std::ops::Index;

/// Name and unit of a column.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Column {
    /// The name.
    pub name: String,
    /// The unit, as in `rad/s`; `1` for a pure number.
    pub unit: String,
}

impl Column {
    /// A column with a name and a unit.
    #[must_use]
    pub fn new(name: &str, unit: &str) -> Self {
        let (name, unit) = (name.to_owned(), unit.to_owned());
        Self { name, unit }
    }
}

/// Results of a sweep: a row for each point, in order.
///
/// `table["angle"]` returns the numbers of a column. Rows of failed trajectories are included, with the last good state
/// if there is one, NaN elsewhere, and a reason.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    pub(crate) columns: Vec<Column>,
    pub(crate) rows: usize,
    pub(crate) numbers: Vec<Vec<f64>>,
    pub(crate) failures: BTreeMap<usize, String>,
    pub(crate) declaration: String,
}

impl Table {
    /// Number of rows.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// All columns: first the numbers of the points, then the results.
    #[must_use]
    pub fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// Numbers of a column, if there is one of that name.
    #[must_use]
    pub fn column(&self, name: &str) -> Option<&[f64]> {
        let place = self.columns.iter().position(|column| column.name == name)?;
        Some(&self.numbers[place])
    }

    /// Rows that failed, with the reasons.
    #[must_use]
    pub fn failures(&self) -> &BTreeMap<usize, String> {
        &self.failures
    }

    /// Declaration of the sweep, with the versions of these crates, as JSON.
    #[must_use]
    pub fn declaration(&self) -> &str {
        &self.declaration
    }
}

impl Index<&str> for Table {
    type Output = [f64];

    /// # Panics
    /// If there is no column of that name.
    fn index(&self, name: &str) -> &[f64] {
        self.column(name).unwrap_or_else(|| {
            let names: Vec<&str> = self.columns.iter().map(|column| column.name.as_str()).collect();
            panic!("the table has no column `{name}`; it has {}", names.join(", "))
        })
    }
}
