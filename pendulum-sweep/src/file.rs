//! Tables as Parquet files.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use parquet::basic::{Compression, Encoding, LogicalType, Repetition, Type as Physical};
use parquet::column::reader::get_typed_column_reader;
use parquet::column::writer::ColumnCloseResult;
use parquet::data_type::{ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::file::metadata::KeyValue;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::reader::{FileReader, RowGroupReader, SerializedFileReader};
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::types::{ColumnPath, Type};
use serde_json::{Value, json};

use crate::error::SweepError;
use crate::table::{Column, Table};

/// The keys of the metadata.
const DECLARATION: &str = "pendulum-sweep";
const UNITS: &str = "units";

/// Writes a table whose first row is number `first`, as one group of rows.
pub(crate) fn write(file: impl Write + Send, first: usize, table: &Table) -> io::Result<()> {
    let mut writer = writer(file, table)?;
    let rows = table.rows();
    let mut group = writer.next_row_group()?;
    let numbers: Vec<i64> = (first..first + rows).map(|row| row as i64).collect();
    write_column::<Int64Type>(&mut group, &numbers, None)?;
    for numbers in &table.numbers {
        write_column::<DoubleType>(&mut group, numbers, None)?;
    }
    let reasons: Vec<ByteArray> = table.failures.values().map(|reason| reason.as_str().into()).collect();
    let mut levels = vec![0_i16; rows];
    table.failures.keys().for_each(|&row| levels[row] = 1);
    write_column::<ByteArrayType>(&mut group, &reasons, Some(&levels))?;
    group.close()?;
    writer.close()?;
    Ok(())
}

/// Writes one file of the groups of several with the same columns, as they are; `empty` has the declaration, which all
/// of them must have.
pub(crate) fn concatenate(file: impl Write + Send, empty: &Table, parts: &[PathBuf]) -> io::Result<()> {
    let mut writer = writer(file, empty)?;
    for path in parts {
        let part = File::open(path)?;
        let reader = SerializedFileReader::new(part.try_clone()?)?;
        if metadata(&reader, DECLARATION)? != empty.declaration {
            let what = format!("{} is of another sweep", path.display());
            return Err(io::Error::new(io::ErrorKind::InvalidData, what));
        }
        for group in reader.metadata().row_groups() {
            let mut written = writer.next_row_group()?;
            for column in group.columns() {
                let copied = ColumnCloseResult {
                    bytes_written: u64::try_from(column.compressed_size()).map_err(io::Error::other)?,
                    rows_written: u64::try_from(group.num_rows()).map_err(io::Error::other)?,
                    metadata: column.clone(),
                    bloom_filter: None,
                    column_index: None,
                    offset_index: None,
                };
                written.append_column(&part, copied)?;
            }
            written.close()?;
        }
    }
    writer.close()?;
    Ok(())
}

fn writer<W: Write + Send>(file: W, table: &Table) -> io::Result<SerializedFileWriter<W>> {
    let (schema, properties) = (Arc::new(schema(table)?), Arc::new(properties(table)));
    Ok(SerializedFileWriter::new(file, schema, properties)?)
}

fn write_column<D: DataType>(
    group: &mut SerializedRowGroupWriter<'_, impl Write + Send>,
    values: &[D::T],
    levels: Option<&[i16]>,
) -> io::Result<()> {
    let column = group.next_column()?;
    let mut column = column.ok_or_else(|| io::Error::other("the schema has too few columns"))?;
    column.typed::<D>().write_batch(values, levels, None)?;
    Ok(column.close()?)
}

fn schema(empty: &Table) -> io::Result<Type> {
    let required = |name: &str, physical: Physical| {
        Type::primitive_type_builder(name, physical)
            .with_repetition(Repetition::REQUIRED)
            .build()
    };
    let mut fields = vec![Arc::new(required("row", Physical::INT64)?)];
    for column in &empty.columns {
        fields.push(Arc::new(required(&column.name, Physical::DOUBLE)?));
    }
    let failure = Type::primitive_type_builder("failure", Physical::BYTE_ARRAY)
        .with_repetition(Repetition::OPTIONAL)
        .with_logical_type(Some(LogicalType::String));
    fields.push(Arc::new(failure.build()?));
    Ok(Type::group_type_builder("sweep").with_fields(fields).build()?)
}

fn properties(empty: &Table) -> WriterProperties {
    let units: BTreeMap<&str, &str> = empty
        .columns
        .iter()
        .map(|column| (column.name.as_str(), column.unit.as_str()))
        .collect();
    let metadata = vec![
        KeyValue::new(DECLARATION.to_owned(), empty.declaration.clone()),
        KeyValue::new(UNITS.to_owned(), json!(units).to_string()),
    ];
    // numbers of results have no two alike, but row numbers follow one another
    WriterProperties::builder()
        .set_created_by(concat!("pendulum-sweep ", env!("CARGO_PKG_VERSION")).to_owned())
        .set_compression(Compression::UNCOMPRESSED)
        .set_dictionary_enabled(false)
        .set_column_encoding(ColumnPath::from("row"), Encoding::DELTA_BINARY_PACKED)
        .set_statistics_enabled(EnabledStatistics::Chunk)
        .set_column_dictionary_enabled(ColumnPath::from("failure"), true)
        .set_key_value_metadata(Some(metadata))
        .build()
}

impl Table {
    /// Reads a table that a sweep has written.
    ///
    /// # Errors
    /// [`SweepError::File`] if that is not possible, or if it is another kind of file.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, SweepError> {
        Self::read_file(path.as_ref())
    }

    pub(crate) fn read_file(path: &Path) -> Result<Self, SweepError> {
        read(path).map_err(SweepError::file(path))
    }

    /// Writes the table as a Parquet file, as [`run_to`](crate::Job::run_to) does.
    ///
    /// # Errors
    /// [`SweepError::File`].
    pub fn write(&self, path: impl AsRef<Path>) -> Result<(), SweepError> {
        let path = path.as_ref();
        let written = File::create(path).and_then(|file| write(file, 0, self));
        written.map_err(SweepError::file(path))
    }
}

fn read(path: &Path) -> io::Result<Table> {
    let reader = SerializedFileReader::new(File::open(path)?)?;
    let mut table = Table {
        columns: columns(&reader)?,
        numbers: Vec::new(),
        failures: BTreeMap::new(),
        declaration: metadata(&reader, DECLARATION)?,
    };
    table.numbers = vec![Vec::new(); table.columns.len()];
    for n in 0..reader.num_row_groups() {
        let group = reader.get_row_group(n)?;
        let (before, rows) = (
            table.rows(),
            usize::try_from(group.metadata().num_rows()).map_err(io::Error::other)?,
        );
        for (place, numbers) in table.numbers.iter_mut().enumerate() {
            read_column::<DoubleType>(&*group, 1 + place, rows, None, numbers)?;
        }
        let (mut levels, mut reasons) = (Vec::new(), Vec::new());
        read_column::<ByteArrayType>(&*group, 1 + table.columns.len(), rows, Some(&mut levels), &mut reasons)?;
        let failed = (0..rows).filter(|&row| levels[row] > 0);
        for (row, reason) in failed.zip(reasons) {
            table
                .failures
                .insert(before + row, String::from_utf8_lossy(reason.data()).into_owned());
        }
    }
    Ok(table)
}

fn read_column<D: DataType>(
    group: &dyn RowGroupReader,
    place: usize,
    rows: usize,
    mut levels: Option<&mut Vec<i16>>,
    values: &mut Vec<D::T>,
) -> io::Result<()> {
    let mut reader = get_typed_column_reader::<D>(group.get_column_reader(place)?);
    let mut left = rows;
    while left > 0 {
        let (read, ..) = reader.read_records(left, levels.as_deref_mut(), None, values)?;
        if read == 0 {
            return Err(io::Error::new(
                io::ErrorKind::UnexpectedEof,
                "a column has too few rows",
            ));
        }
        left -= read;
    }
    Ok(())
}

/// The declaration in a file.
pub(crate) fn declaration(path: &Path) -> io::Result<String> {
    metadata(&SerializedFileReader::new(File::open(path)?)?, DECLARATION)
}

fn metadata(reader: &SerializedFileReader<File>, key: &str) -> io::Result<String> {
    let entries = reader.metadata().file_metadata().key_value_metadata();
    let entry = entries.into_iter().flatten().find(|entry| entry.key == key);
    let value = entry.and_then(|entry| entry.value.clone());
    value.ok_or_else(|| io::Error::new(io::ErrorKind::InvalidData, "it was not written by a sweep"))
}

fn columns(reader: &SerializedFileReader<File>) -> io::Result<Vec<Column>> {
    let units: Value = serde_json::from_str(&metadata(reader, UNITS)?)?;
    let fields = reader.metadata().file_metadata().schema().get_fields();
    let names = fields
        .iter()
        .map(|field| field.name())
        .filter(|name| !["row", "failure"].contains(name));
    Ok(names
        .map(|name| Column::new(name, units[name].as_str().unwrap_or("1")))
        .collect())
}
