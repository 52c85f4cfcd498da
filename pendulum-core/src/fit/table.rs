//! Tables of numbers with named columns.

use std::error::Error;
use std::io;

use super::nearest;
use crate::error::{debug_as_display, messages};

/// A table of numbers with named columns, such as a recording.
///
/// ```
/// use pendulum_core::fit::Table;
///
/// let table = Table::read_csv("time, angle\n0.0, 1.5\n0.1,\n".as_bytes())?;
/// assert_eq!(table.names(), ["time", "angle"]);
/// assert_eq!(table.column("time")?, [0.0, 0.1]);
/// assert!(table.column("angle")?[1].is_nan());
/// # Ok::<(), pendulum_core::fit::TableError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    names: Vec<String>,
    columns: Vec<Vec<f64>>,
}

impl Table {
    /// Reads comma-separated values: a line of names, then lines of numbers. Empty cells and `NaN` are missing values,
    /// which become NaN. Lines that start with `#` are comments.
    ///
    /// # Errors
    /// If reading fails, if a line has another number of cells than the first, if a cell is not a number, or if two
    /// columns have the same name.
    pub fn read_csv(reader: impl io::Read) -> Result<Self, TableError> {
        let mut reader = csv::ReaderBuilder::new()
            .trim(csv::Trim::All)
            .comment(Some(b'#'))
            .from_reader(reader);
        let names: Vec<String> = reader.headers()?.iter().map(str::to_owned).collect();
        if let Some(n) = (1..names.len()).find(|&n| names[..n].contains(&names[n])) {
            return Err(TableError::Twice { name: names[n].clone() });
        }
        let mut columns = vec![Vec::new(); names.len()];
        for record in reader.records() {
            let record = record?;
            for ((cell, column), name) in record.iter().zip(&mut columns).zip(&names) {
                let number = match cell {
                    "" => f64::NAN,
                    _ => cell.parse().map_err(|_| TableError::NotANumber {
                        line: record.position().map_or(0, csv::Position::line),
                        name: name.clone(),
                        cell: cell.to_owned(),
                    })?,
                };
                column.push(number);
            }
        }
        Ok(Self { names, columns })
    }

    /// Names of the columns.
    #[must_use]
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// Numbers of a column, NaN where they are missing.
    ///
    /// # Errors
    /// If there is no column of this name.
    pub fn column(&self, name: &str) -> Result<&[f64], TableError> {
        match self.names.iter().position(|own| own == name) {
            Some(n) => Ok(&self.columns[n]),
            None => Err(TableError::NoColumn {
                name: name.to_owned(),
                nearest: nearest(name, self.names.iter().map(String::as_str)),
                names: self.names.clone(),
            }),
        }
    }
}

/// A table that cannot be read, or has no such column.
#[non_exhaustive]
pub enum TableError {
    /// Reading failed, or a line has another number of cells than the first.
    Csv(csv::Error),
    /// A cell is not a number.
    NotANumber {
        /// Number of the line, from 1 on.
        line: u64,
        /// Name of the column.
        name: String,
        /// Text of the cell.
        cell: String,
    },
    /// Two columns have the same name.
    Twice {
        /// The name.
        name: String,
    },
    /// There is no column of this name.
    NoColumn {
        /// The name.
        name: String,
        /// The most similar name, if one is similar.
        nearest: Option<String>,
        /// Names of all columns.
        names: Vec<String>,
    },
}

debug_as_display! { [] TableError; }

messages! {
    [] TableError;
    Self::Csv(error) => "{error}";
    Self::NotANumber { line, name, cell } =>
        "line {line}, column `{name}`: `{cell}` is not a number; leave the cell of a missing value empty";
    Self::Twice { name } => "two columns have the name `{name}`: rename one";
    Self::NoColumn { name, nearest: Some(nearest), .. } =>
        "no column has the name `{name}`; did you mean `{nearest}`?";
    Self::NoColumn { name, nearest: None, names } => "no column has the name `{name}`; the columns are `{all}`",
        all = names.join("`, `");
}

impl Error for TableError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            Self::Csv(error) => Some(error),
            _ => None,
        }
    }
}

impl From<csv::Error> for TableError {
    fn from(error: csv::Error) -> Self {
        Self::Csv(error)
    }
}

#[cfg(test)]
mod tests {
    use super::{Table, TableError};

    fn error(text: &str) -> String {
        Table::read_csv(text.as_bytes()).expect_err("not a table").to_string()
    }

    #[test]
    fn errors_name_the_place() {
        let message = error("t,a\n0,1\n1,2x\n");
        assert!(
            message.starts_with("line 3, column `a`: `2x` is not a number"),
            "{message}"
        );
        assert!(error("t,a\n0,1\n1\n").contains("line: 3"));
        assert!(error("t,t\n0,1\n").starts_with("two columns have the name `t`"));
    }

    #[test]
    fn an_unknown_column_is_compared_with_the_others() {
        let table = Table::read_csv("\u{feff}time_s,\"q1, rad\",q2_rad\r\n0,1,2\r\n".as_bytes()).expect("a table");
        assert_eq!(table.column("q1, rad").expect("a column"), [1.0]);
        let Err(error @ TableError::NoColumn { .. }) = table.column("q2") else {
            panic!("there is no such column");
        };
        assert!(error.to_string().ends_with("did you mean `q2_rad`?"), "{error}");
        assert!(
            table
                .column("voltage")
                .expect_err("none")
                .to_string()
                .ends_with("`time_s`, `q1, rad`, `q2_rad`")
        );
    }
}
