//! Parquet files of tables.

use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::{self, BufWriter, Seek, SeekFrom, Write};
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

use bytes::Bytes;
use parquet::basic::{Compression, Encoding, LogicalType, Repetition, Type as Physical};
use parquet::column::reader::get_typed_column_reader;
use parquet::data_type::{ByteArray, ByteArrayType, DataType, DoubleType};
use parquet::file::metadata::{
    ColumnChunkMetaData, ColumnChunkMetaDataBuilder, FileMetaData, KeyValue, ParquetMetaData, ParquetMetaDataOptions,
    ParquetMetaDataReader, ParquetMetaDataWriter, RowGroupMetaData,
};
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::reader::{FileReader, RowGroupReader, SerializedFileReader};
use parquet::file::statistics::Statistics;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::{ColumnPath, SchemaDescriptor, Type, TypePtr};
use serde_json::{Value, json};

use crate::checksum::{self, Sum};
use crate::error::SweepError;
use crate::page::{MAGIC, broken, bytes_of_head, bytes_of_page, head_of_page, number, page_of_rows};
use crate::table::{Column, Table};

/// Metadata key of the declaration.
const DECLARATION: &str = "pendulum-sweep";
/// Metadata key of the units.
const UNITS: &str = "units";

/// Rows in the layout of the file: the numbers in one buffer with one page per column, and the failures apart from
/// them. The column `row` follows from the position of the part.
pub(crate) struct Part {
    rows: Range<usize>,
    numbers: Vec<u8>,
    failures: BTreeMap<usize, String>,
}

impl Part {
    /// Creates a part whose numbers are still to be [stored](Self::keep), reusing the allocation `memory`.
    pub(crate) fn new(rows: Range<usize>, columns: usize, mut memory: Vec<u8>) -> Self {
        let head = head_of_page(rows.len(), 0);
        memory.resize(columns * bytes_of_page(rows.len()), 0);
        for page in memory.chunks_exact_mut(bytes_of_page(rows.len())) {
            page[..head.len()].copy_from_slice(&head);
        }
        Self {
            rows,
            numbers: memory,
            failures: BTreeMap::new(),
        }
    }

    /// Stores the numbers of some rows, column by column; `row` is the index of the first row within the part.
    pub(crate) fn keep(&mut self, row: usize, columns: impl IntoIterator<Item = impl IntoIterator<Item = f64>>) {
        let length = size_of::<f64>() * self.rows.len();
        let head = bytes_of_head(self.rows.len());
        for (page, numbers) in self.numbers.chunks_exact_mut(head + length).zip(columns) {
            let (places, _) = page[head..].as_chunks_mut();
            for (place, number) in places[row..].iter_mut().zip(numbers) {
                *place = number.to_le_bytes();
            }
        }
    }

    /// Records the failure of a row.
    pub(crate) fn fail(&mut self, row: usize, reason: String) {
        self.failures.insert(row, reason);
    }

    /// Number of failed rows.
    pub(crate) fn failed(&self) -> usize {
        self.failures.len()
    }

    /// Completes the checksum of each page and returns the bytes. All numbers must have been [stored](Self::keep).
    pub(crate) fn numbers(&mut self) -> &[u8] {
        let rows = self.rows.len();
        for page in self.numbers.chunks_exact_mut(bytes_of_page(rows)) {
            let (head, numbers) = page.split_at_mut(bytes_of_head(rows));
            head.copy_from_slice(&head_of_page(rows, crc32fast::hash(numbers)));
        }
        &self.numbers
    }

    /// Returns the buffer of the numbers for reuse.
    pub(crate) fn into_memory(self) -> Vec<u8> {
        self.numbers
    }

    /// Encodes the failures as a Parquet file.
    pub(crate) fn failures(&self, empty: &Table) -> io::Result<Vec<u8>> {
        let mut file = Vec::new();
        let schema = Arc::new(schema_of(vec![failure()?])?);
        let mut writer = SerializedFileWriter::new(&mut file, schema, Arc::new(properties(empty)))?;
        let mut group = writer.next_row_group()?;
        let reasons: Vec<ByteArray> = self.failures.values().map(|reason| reason.as_str().into()).collect();
        let mut levels = vec![0_i16; self.rows.len()];
        self.failures.keys().for_each(|&row| levels[row] = 1);
        let column = group.next_column()?;
        let mut column = column.ok_or_else(|| io::Error::other("the schema has too few columns"))?;
        column
            .typed::<ByteArrayType>()
            .write_batch(&reasons, Some(&levels), None)?;
        column.close()?;
        group.close()?;
        writer.close()?;
        Ok(file)
    }
}

/// Upper bound for the size of `rows` rows of numbers, in bytes.
pub(crate) fn most_bytes(columns: usize, rows: usize) -> usize {
    const MOST_OF_HEAD: usize = 32;
    columns * (MOST_OF_HEAD + size_of::<f64>() * rows)
}

/// Returns the declaration in the [failures](Part::failures) of a part, and the size of its numbers in bytes.
pub(crate) fn read_failures(failures: &Bytes, columns: usize) -> io::Result<(String, usize)> {
    let metadata = ParquetMetaDataReader::new().parse_and_finish(failures)?;
    let rows = number(metadata.file_metadata().num_rows())?;
    Ok((entry(&metadata, DECLARATION)?, columns * bytes_of_page(rows)))
}

/// Writes the rest of a file that already has the numbers of all parts: the columns `row` and `failure`, and the
/// metadata.
pub(crate) struct Ending<'f> {
    file: BufWriter<&'f mut File>,
    /// Offset of the next page.
    end: usize,
    /// Checksum of everything written so far.
    sum: Sum,
    properties: WriterProperties,
    schema: Arc<SchemaDescriptor>,
    /// Options to read the failures of a part.
    of_failures: ParquetMetaDataOptions,
    rows: usize,
    groups: Vec<RowGroupMetaData>,
}

impl<'f> Ending<'f> {
    /// Continues at the end of a file whose checksum is `sum`.
    pub(crate) fn new(file: &'f mut File, empty: &Table, sum: Sum) -> io::Result<Self> {
        let of_failures = Arc::new(SchemaDescriptor::new(Arc::new(schema_of(vec![failure()?])?)));
        Ok(Self {
            end: number(file.seek(SeekFrom::End(0))?)?,
            file: BufWriter::new(file),
            sum,
            properties: properties(empty),
            schema: Arc::new(SchemaDescriptor::new(Arc::new(schema(&empty.columns)?))),
            of_failures: ParquetMetaDataOptions::new().with_schema(of_failures),
            rows: 0,
            groups: Vec::new(),
        })
    }

    /// Adds the next part, given the offset of its numbers and its [failures](Part::failures).
    pub(crate) fn add(&mut self, place: usize, failures: &Bytes) -> io::Result<()> {
        let options = Some(self.of_failures.clone());
        let reader = ParquetMetaDataReader::new().with_metadata_options(options);
        let metadata = reader.parse_and_finish(failures)?;
        let rows = self.rows..self.rows + number(metadata.row_group(0).num_rows())?;
        let mut columns = vec![self.row_numbers(&rows)?];
        let page = bytes_of_page(rows.len());
        for column in 1..self.schema.num_columns() - 1 {
            let place = place + (column - 1) * page;
            columns.push(
                self.one_page(column, Encoding::PLAIN, rows.len(), place..place + page)
                    .build()?,
            );
        }
        columns.push(self.failures(metadata.row_group(0).column(0), failures)?);
        let group = RowGroupMetaData::builder(self.schema.clone())
            .set_num_rows(rows.len() as i64)
            .set_total_byte_size(columns.iter().map(ColumnChunkMetaData::uncompressed_size).sum())
            .set_column_metadata(columns)
            .set_ordinal(i16::try_from(self.groups.len()).map_err(io::Error::other)?)
            .set_file_offset(place as i64);
        self.groups.push(group.build()?);
        self.rows = rows.end;
        Ok(())
    }

    /// Writes the column `row`.
    fn row_numbers(&mut self, rows: &Range<usize>) -> io::Result<ColumnChunkMetaData> {
        let bytes = self.write(&page_of_rows(rows))?;
        let [least, most] = [rows.start as i64, rows.end as i64 - 1];
        let statistics = Statistics::int64(Some(least), Some(most), None, Some(0), false);
        let column = self.one_page(0, Encoding::DELTA_BINARY_PACKED, rows.len(), bytes);
        Ok(column.set_statistics(statistics).build()?)
    }

    /// Copies the column `failure` from its own file.
    fn failures(&mut self, column: &ColumnChunkMetaData, file: &Bytes) -> io::Result<ColumnChunkMetaData> {
        let (start, length) = column.byte_range();
        let (from, length) = (number(start)?, number(length)?);
        let bytes = self.write(&file[from..from + length])?;
        let moved = |offset: i64| offset - start as i64 + bytes.start as i64;
        let dictionary = column.dictionary_page_offset().map(moved);
        let builder = column.clone().into_builder();
        let placed = builder.set_data_page_offset(moved(column.data_page_offset()));
        Ok(placed.set_dictionary_page_offset(dictionary).build()?)
    }

    /// Metadata of a column that is one page of a part.
    fn one_page(
        &self,
        column: usize,
        encoding: Encoding,
        rows: usize,
        bytes: Range<usize>,
    ) -> ColumnChunkMetaDataBuilder {
        ColumnChunkMetaData::builder(self.schema.column(column))
            .set_encodings(vec![encoding, Encoding::RLE])
            .set_num_values(rows as i64)
            .set_total_compressed_size(bytes.len() as i64)
            .set_total_uncompressed_size(bytes.len() as i64)
            .set_data_page_offset(bytes.start as i64)
    }

    /// Writes bytes and returns their range in the file.
    fn write(&mut self, bytes: &[u8]) -> io::Result<Range<usize>> {
        self.file.write_all(bytes)?;
        self.sum.add(bytes);
        let start = self.end;
        self.end += bytes.len();
        Ok(start..self.end)
    }

    /// Writes the metadata with the checksums.
    pub(crate) fn finish(mut self) -> io::Result<()> {
        let mut entries = self.properties.key_value_metadata().cloned().unwrap_or_default();
        entries.push(self.sum.entry());
        let head = FileMetaData::new(
            self.properties.writer_version().as_num(),
            self.rows as i64,
            Some(self.properties.created_by().to_owned()),
            Some(entries),
            self.schema,
            None,
        );
        let mut footer = Vec::new();
        ParquetMetaDataWriter::new(&mut footer, &ParquetMetaData::new(head, self.groups)).finish()?;
        checksum::seal(&mut footer)?;
        self.file.write_all(&footer)?;
        self.file.flush()
    }
}

/// Schema of a file with the columns `numbers`.
fn schema(numbers: &[Column]) -> io::Result<Type> {
    let mut fields = vec![required("row", Physical::INT64)?];
    for column in numbers {
        fields.push(required(&column.name, Physical::DOUBLE)?);
    }
    fields.push(failure()?);
    schema_of(fields)
}

fn schema_of(fields: Vec<TypePtr>) -> io::Result<Type> {
    Ok(Type::group_type_builder("sweep").with_fields(fields).build()?)
}

fn required(name: &str, physical: Physical) -> io::Result<TypePtr> {
    let field = Type::primitive_type_builder(name, physical).with_repetition(Repetition::REQUIRED);
    Ok(Arc::new(field.build()?))
}

/// Field of the column `failure`.
fn failure() -> io::Result<TypePtr> {
    let field = Type::primitive_type_builder("failure", Physical::BYTE_ARRAY)
        .with_repetition(Repetition::OPTIONAL)
        .with_logical_type(Some(LogicalType::String));
    Ok(Arc::new(field.build()?))
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
    WriterProperties::builder()
        .set_created_by(concat!("pendulum-sweep ", env!("CARGO_PKG_VERSION")).to_owned())
        .set_compression(Compression::UNCOMPRESSED)
        .set_offset_index_disabled(true)
        .set_statistics_enabled(EnabledStatistics::Chunk)
        // there are few distinct failures
        .set_column_dictionary_enabled(ColumnPath::from("failure"), true)
        .set_key_value_metadata(Some(metadata))
        .build()
}

impl Table {
    /// Reads a table written by a sweep.
    ///
    /// # Errors
    /// [`SweepError::File`] if the file cannot be read or has another format.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, SweepError> {
        Self::read_file(path.as_ref())
    }

    pub(crate) fn read_file(path: &Path) -> Result<Self, SweepError> {
        read(path).map_err(SweepError::file(path))
    }

    /// Writes the table as a Parquet file, with the same columns and metadata as [`run_to`](crate::Job::run_to). An
    /// existing file is replaced.
    ///
    /// # Errors
    /// [`SweepError::File`].
    pub fn write(&self, path: impl AsRef<Path>) -> Result<(), SweepError> {
        let path = path.as_ref();
        let written = replace(path, |file| {
            write(file, self)?;
            file.sync_all()
        });
        written.map_err(SweepError::file(path))
    }
}

/// Writes a file under a temporary name and renames it when it is complete. After a power failure, part of it may be
/// missing.
pub(crate) fn replace(path: &Path, write: impl FnOnce(&mut File) -> io::Result<()>) -> io::Result<()> {
    let mut unfinished = path.as_os_str().to_owned();
    unfinished.push(format!(".{}.tmp", std::process::id()));
    let written = File::create(&unfinished).and_then(|mut file| write(&mut file));
    written.and_then(|()| fs::rename(&unfinished, path)).inspect_err(|_| {
        // an unfinished file is useless; the first error is more informative than a failure to remove it
        let _ = fs::remove_file(&unfinished);
    })
}

/// Maximum number of rows of a part: a page must be shorter than 2 GiB.
pub(crate) const MOST_ROWS: usize = 1 << 20;

fn write(file: &mut File, table: &Table) -> io::Result<()> {
    file.write_all(&MAGIC)?;
    let mut sum = Sum::default();
    sum.add(&MAGIC);
    let mut parts = Vec::new();
    for first in (0..table.rows).step_by(MOST_ROWS) {
        let rows = first..table.rows.min(first + MOST_ROWS);
        let mut part = Part::new(rows.clone(), table.columns.len(), Vec::new());
        let numbers = table.numbers.iter();
        part.keep(0, numbers.map(|numbers| numbers[rows.clone()].iter().copied()));
        for (row, reason) in table.failures.range(rows) {
            part.fail(row - first, reason.clone());
        }
        let place = number(file.stream_position()?)?;
        file.write_all(part.numbers())?;
        sum.add(part.numbers());
        parts.push((place, part.failures(table)?.into()));
    }
    let mut ending = Ending::new(file, table, sum)?;
    for (place, failures) in &parts {
        ending.add(*place, failures)?;
    }
    ending.finish()
}

fn read(path: &Path) -> io::Result<Table> {
    let reader = SerializedFileReader::new(File::open(path)?)?;
    let mut table = Table {
        columns: columns(&reader)?,
        rows: 0,
        numbers: Vec::new(),
        failures: BTreeMap::new(),
        declaration: entry(reader.metadata(), DECLARATION)?,
    };
    table.numbers = vec![Vec::new(); table.columns.len()];
    for n in 0..reader.num_row_groups() {
        let group = reader.get_row_group(n)?;
        let (before, rows) = (table.rows, number(group.metadata().num_rows())?);
        table.rows += rows;
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

/// Returns the declaration in a file, and its number of rows.
pub(crate) fn declaration(path: &Path) -> io::Result<(String, usize)> {
    let reader = SerializedFileReader::new(File::open(path)?)?;
    let metadata = reader.metadata();
    Ok((
        entry(metadata, DECLARATION)?,
        number(metadata.file_metadata().num_rows())?,
    ))
}

fn entry(metadata: &ParquetMetaData, key: &str) -> io::Result<String> {
    let entries = metadata.file_metadata().key_value_metadata();
    let entry = entries.into_iter().flatten().find(|entry| entry.key == key);
    let value = entry.and_then(|entry| entry.value.clone());
    value.ok_or_else(|| broken("it was not written by a sweep"))
}

fn columns(reader: &SerializedFileReader<File>) -> io::Result<Vec<Column>> {
    let units: Value = serde_json::from_str(&entry(reader.metadata(), UNITS)?)?;
    let fields = reader.metadata().file_metadata().schema().get_fields();
    let names = fields
        .iter()
        .map(|field| field.name())
        .filter(|name| !["row", "failure"].contains(name));
    Ok(names
        .map(|name| Column::new(name, units[name].as_str().unwrap_or("1")))
        .collect())
}
