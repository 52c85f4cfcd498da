//! Tables as Parquet files.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{self, BufWriter, Seek, SeekFrom, Write};
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

use bytes::Bytes;
use parquet::basic::{Compression, Encoding, LogicalType, Repetition, Type as Physical};
use parquet::column::reader::get_typed_column_reader;
use parquet::data_type::{ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::file::metadata::{
    ColumnChunkMetaData, FileMetaData, KeyValue, ParquetMetaData, ParquetMetaDataOptions, ParquetMetaDataReader,
    ParquetMetaDataWriter, RowGroupMetaData,
};
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::reader::{FileReader, RowGroupReader, SerializedFileReader};
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::types::{ColumnPath, SchemaDescriptor, Type};
use serde_json::{Value, json};

use crate::error::SweepError;
use crate::table::{Column, Table};

/// The keys of the metadata.
const DECLARATION: &str = "pendulum-sweep";
const UNITS: &str = "units";

/// Some rows as they lie in a file: the numbers in one piece, each column a page, and apart from them the others: the
/// numbers of the rows, and the failures.
pub(crate) struct Part {
    rows: Range<usize>,
    numbers: Vec<u8>,
    failures: BTreeMap<usize, String>,
}

impl Part {
    /// Rows whose numbers are all 0; their bytes lie where `memory` did.
    pub(crate) fn new(rows: Range<usize>, columns: usize, mut memory: Vec<u8>) -> Self {
        memory.clear();
        memory.reserve(most_bytes(columns, rows.len()));
        let head = head_of_page(rows.len());
        for _ in 0..columns {
            memory.extend(&head);
            memory.resize(memory.len() + size_of::<f64>() * rows.len(), 0);
        }
        Self {
            rows,
            numbers: memory,
            failures: BTreeMap::new(),
        }
    }

    /// Keeps the numbers of some rows, column by column, the first of which is number `row` of these.
    pub(crate) fn keep<'n>(&mut self, row: usize, columns: impl IntoIterator<Item = &'n [f64]>) {
        let length = size_of::<f64>() * self.rows.len();
        let head = head_of_page(self.rows.len()).len();
        for (page, numbers) in self.numbers.chunks_exact_mut(head + length).zip(columns) {
            let (places, _) = page[head..].as_chunks_mut();
            for (place, number) in places[row..].iter_mut().zip(numbers) {
                *place = number.to_le_bytes();
            }
        }
    }

    /// The failure of a row.
    pub(crate) fn fail(&mut self, row: usize, reason: String) {
        self.failures.insert(row, reason);
    }

    /// How many rows failed.
    pub(crate) fn failed(&self) -> usize {
        self.failures.len()
    }

    pub(crate) fn numbers(&self) -> &[u8] {
        &self.numbers
    }

    /// The memory of the numbers, for others.
    pub(crate) fn into_memory(self) -> Vec<u8> {
        self.numbers
    }

    /// The others, as a Parquet file.
    pub(crate) fn others(&self, empty: &Table) -> io::Result<Vec<u8>> {
        let mut file = Vec::new();
        let mut writer = SerializedFileWriter::new(&mut file, Arc::new(schema(&[])?), Arc::new(properties(empty)))?;
        let mut group = writer.next_row_group()?;
        let rows: Vec<i64> = self.rows.clone().map(|row| row as i64).collect();
        write_column::<Int64Type>(&mut group, &rows, None)?;
        let reasons: Vec<ByteArray> = self.failures.values().map(|reason| reason.as_str().into()).collect();
        let mut levels = vec![0_i16; rows.len()];
        self.failures.keys().for_each(|&row| levels[row] = 1);
        write_column::<ByteArrayType>(&mut group, &reasons, Some(&levels))?;
        group.close()?;
        writer.close()?;
        Ok(file)
    }
}

/// The most bytes that the numbers of so many rows take.
pub(crate) fn most_bytes(columns: usize, rows: usize) -> usize {
    const MOST_OF_HEAD: usize = 32;
    columns * (MOST_OF_HEAD + size_of::<f64>() * rows)
}

/// The bytes that they take.
fn bytes_of_page(rows: usize) -> usize {
    head_of_page(rows).len() + size_of::<f64>() * rows
}

/// What is before the numbers of a page: a `PageHeader` of `parquet.thrift` in Thrift's compact protocol.
fn head_of_page(rows: usize) -> Vec<u8> {
    const I32: u8 = 5;
    const STRUCT: u8 = 12;
    let mut head = Vec::new();
    let field = |head: &mut Vec<u8>, step: u8, kind: u8| head.push(step << 4 | kind);
    let integer = |head: &mut Vec<u8>, number: usize| {
        field(head, 1, I32);
        let mut zigzag = 2 * number;
        while zigzag >= 0x80 {
            head.push(zigzag as u8 | 0x80);
            zigzag >>= 7;
        }
        head.push(zigzag as u8);
    };
    // a data page, and its size with and without compression
    let length = size_of::<f64>() * rows;
    for number in [0, length, length] {
        integer(&mut head, number);
    }
    field(&mut head, 2, STRUCT);
    // numbers that are PLAIN, and levels that would be RLE
    for number in [rows, 0, 3, 3] {
        integer(&mut head, number);
    }
    head.extend([0, 0]);
    head
}

/// The declaration in the [others](Part::others) of a part, and how many bytes its numbers take.
pub(crate) fn read_others(others: &Bytes, columns: usize) -> io::Result<(String, usize)> {
    let metadata = ParquetMetaDataReader::new().parse_and_finish(others)?;
    let rows = usize::try_from(metadata.file_metadata().num_rows()).map_err(io::Error::other)?;
    Ok((entry(&metadata, DECLARATION)?, columns * bytes_of_page(rows)))
}

/// What a Parquet file begins with.
pub(crate) const MAGIC: [u8; 4] = *b"PAR1";

/// Ends a file that has the numbers of all parts already, each from a place on: adds the others and the metadata.
pub(crate) fn conclude(
    file: &mut File,
    empty: &Table,
    parts: impl IntoIterator<Item = io::Result<(u64, Bytes)>>,
) -> io::Result<()> {
    let mut end = file.seek(SeekFrom::End(0))?;
    let mut file = BufWriter::new(file);
    let of_others = Arc::new(SchemaDescriptor::new(Arc::new(schema(&[])?)));
    let options = ParquetMetaDataOptions::new().with_schema(of_others);
    let schema = Arc::new(SchemaDescriptor::new(Arc::new(schema(&empty.columns)?)));
    let (mut groups, mut all) = (Vec::new(), 0);
    for part in parts {
        let (place, others) = part?;
        let reader = ParquetMetaDataReader::new().with_metadata_options(Some(options.clone()));
        let metadata = reader.parse_and_finish(&others)?;
        let group = metadata.row_group(0);
        let rows = group.num_rows();
        let mut moved = |column: usize, to: usize| -> io::Result<ColumnChunkMetaData> {
            let column = group.column(column);
            let (start, length) = column.byte_range();
            file.write_all(&others[start as usize..(start + length) as usize])?;
            let moved = |offset: i64| offset - start as i64 + end as i64;
            let builder = ColumnChunkMetaData::builder(schema.column(to))
                .set_encodings_mask(*column.encodings_mask())
                .set_num_values(column.num_values())
                .set_total_compressed_size(column.compressed_size())
                .set_total_uncompressed_size(column.uncompressed_size())
                .set_data_page_offset(moved(column.data_page_offset()))
                .set_dictionary_page_offset(column.dictionary_page_offset().map(moved));
            let builder = match column.statistics() {
                Some(statistics) => builder.set_statistics(statistics.clone()),
                None => builder,
            };
            end += length;
            Ok(builder.build()?)
        };
        let page = bytes_of_page(rows as usize) as i64;
        let numbers = (0..empty.columns.len()).map(|column| {
            let builder = ColumnChunkMetaData::builder(schema.column(1 + column))
                .set_encodings(vec![Encoding::PLAIN, Encoding::RLE])
                .set_num_values(rows)
                .set_total_compressed_size(page)
                .set_total_uncompressed_size(page)
                .set_data_page_offset(place as i64 + column as i64 * page);
            Ok(builder.build()?)
        });
        let mut columns = vec![moved(0, 0)?];
        columns.extend(numbers.collect::<io::Result<Vec<_>>>()?);
        columns.push(moved(1, 1 + empty.columns.len())?);
        let group = RowGroupMetaData::builder(schema.clone())
            .set_num_rows(rows)
            .set_total_byte_size(columns.iter().map(ColumnChunkMetaData::uncompressed_size).sum())
            .set_column_metadata(columns)
            .set_ordinal(i16::try_from(groups.len()).map_err(io::Error::other)?)
            .set_file_offset(place as i64);
        groups.push(group.build()?);
        all += rows;
    }
    let properties = properties(empty);
    let head = FileMetaData::new(
        properties.writer_version().as_num(),
        all,
        Some(properties.created_by().to_owned()),
        properties.key_value_metadata().cloned(),
        schema,
        None,
    );
    ParquetMetaDataWriter::new(&mut file, &ParquetMetaData::new(head, groups)).finish()?;
    file.flush()
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

/// The columns of a file, with these numbers.
fn schema(numbers: &[Column]) -> io::Result<Type> {
    let required = |name: &str, physical: Physical| {
        Type::primitive_type_builder(name, physical)
            .with_repetition(Repetition::REQUIRED)
            .build()
    };
    let mut fields = vec![Arc::new(required("row", Physical::INT64)?)];
    for column in numbers {
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
    // row numbers follow one another, and few failures differ
    let [row, failure] = ["row", "failure"].map(ColumnPath::from);
    WriterProperties::builder()
        .set_created_by(concat!("pendulum-sweep ", env!("CARGO_PKG_VERSION")).to_owned())
        .set_compression(Compression::UNCOMPRESSED)
        .set_offset_index_disabled(true)
        .set_statistics_enabled(EnabledStatistics::Chunk)
        .set_column_encoding(row.clone(), Encoding::DELTA_BINARY_PACKED)
        .set_column_dictionary_enabled(row, false)
        .set_column_dictionary_enabled(failure, true)
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
        let written = File::create(path).and_then(|mut file| write(&mut file, self));
        written.map_err(SweepError::file(path))
    }
}

/// The most rows of a part: a page has to be shorter than 2 GiB.
pub(crate) const MOST_ROWS: usize = 1 << 20;

fn write(file: &mut File, table: &Table) -> io::Result<()> {
    file.write_all(&MAGIC)?;
    let mut others = Vec::new();
    for first in (0..table.rows()).step_by(MOST_ROWS) {
        let rows = first..table.rows().min(first + MOST_ROWS);
        let mut part = Part::new(rows.clone(), table.columns.len(), Vec::new());
        part.keep(0, table.numbers.iter().map(|numbers| &numbers[rows.clone()]));
        for (row, reason) in table.failures.range(rows) {
            part.fail(row - first, reason.clone());
        }
        let place = file.stream_position()?;
        file.write_all(part.numbers())?;
        others.push(Ok((place, part.others(table)?.into())));
    }
    conclude(file, table, others)
}

fn read(path: &Path) -> io::Result<Table> {
    let reader = SerializedFileReader::new(File::open(path)?)?;
    let mut table = Table {
        columns: columns(&reader)?,
        numbers: Vec::new(),
        failures: BTreeMap::new(),
        declaration: entry(reader.metadata(), DECLARATION)?,
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
    entry(SerializedFileReader::new(File::open(path)?)?.metadata(), DECLARATION)
}

fn entry(metadata: &ParquetMetaData, key: &str) -> io::Result<String> {
    let entries = metadata.file_metadata().key_value_metadata();
    let entry = entries.into_iter().flatten().find(|entry| entry.key == key);
    let value = entry.and_then(|entry| entry.value.clone());
    value.ok_or_else(|| broken("it was not written by a sweep"))
}

fn broken(what: &str) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, what)
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
