//! Results by name.

use std::collections::BTreeMap;
use std::ops::Index;

/// What the numbers of a column are.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Column {
    /// Its name.
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

/// The results of a sweep: a row for each point, in order.
///
/// `table["angle"]` are the numbers of a column. Rows of trajectories that failed are there too: with the last good state
/// where there is one, NaN elsewhere, and a reason.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    pub(crate) columns: Vec<Column>,
    pub(crate) rows: usize,
    pub(crate) numbers: Vec<Vec<f64>>,
    pub(crate) failures: BTreeMap<usize, String>,
    pub(crate) declaration: String,
}

impl Table {
    /// How many rows there are.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// What the columns are: first the numbers of the points, then what was kept.
    #[must_use]
    pub fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// The numbers of a column, if there is one of that name.
    #[must_use]
    pub fn column(&self, name: &str) -> Option<&[f64]> {
        let place = self.columns.iter().position(|column| column.name == name)?;
        Some(&self.numbers[place])
    }

    /// The rows that failed, and why.
    #[must_use]
    pub fn failures(&self) -> &BTreeMap<usize, String> {
        &self.failures
    }

    /// The declaration of the sweep, with the versions of these crates, as JSON.
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
