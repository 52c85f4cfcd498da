//! Checksums of finished files, which detect every flipped bit.
//!
//! Each page of numbers carries the CRC-32 that the Parquet format provides, for all readers. The metadata hold two
//! more: the checksum of all bytes before the metadata, and the checksum of the metadata themselves, computed with its
//! own digits as zeros.

use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom};
use std::path::Path;

use crc32fast::Hasher;
use parquet::file::metadata::{KeyValue, ParquetMetaData, ParquetMetaDataReader};

use crate::page::{MAGIC, broken, bytes_of_head, bytes_of_page, head_of_page, number, page_of_rows};

/// Key of the metadata entry with both checksums, of eight digits each.
const KEY: &str = "pendulum-sweep checksums";
const DIGITS: usize = 8;

/// Advice to the user about a damaged file.
const REMEDY: &str =
    "since the sweep wrote it, bits have changed: restore a copy, or remove the file and run the sweep again";

/// Running checksum of the bytes of a file from its start.
#[derive(Clone, Default)]
pub(crate) struct Sum {
    hasher: Hasher,
    length: u64,
}

impl Sum {
    pub(crate) fn add(&mut self, bytes: &[u8]) {
        self.hasher.update(bytes);
        self.length += bytes.len() as u64;
    }

    /// Adds zeros up to the offset `place`.
    pub(crate) fn add_zeros(&mut self, place: u64) {
        const ZEROS: [u8; 4096] = [0; 4096];
        while self.length < place {
            let count = (place - self.length).min(ZEROS.len() as u64);
            self.add(&ZEROS[..count as usize]);
        }
    }

    /// Adds `length` bytes whose checksum is `sum`.
    pub(crate) fn add_sum(&mut self, sum: u32, length: u64) {
        self.hasher.combine(&Hasher::new_with_initial_len(sum, length));
        self.length += length;
    }

    /// Returns the metadata entry, with zeros in place of the checksum of the metadata.
    pub(crate) fn entry(&self) -> KeyValue {
        let of_metadata = "0".repeat(DIGITS);
        KeyValue::new(
            KEY.to_owned(),
            format!("{:08x}{of_metadata}", self.hasher.clone().finalize()),
        )
    }
}

/// Writes the checksum of a footer (the metadata and the bytes that follow them) into the footer.
pub(crate) fn seal(footer: &mut [u8]) -> io::Result<()> {
    let place = place_of_sums(footer).ok_or_else(|| broken("its checksums are missing"))? + DIGITS;
    let sum = crc32fast::hash(footer);
    footer[place..place + DIGITS].copy_from_slice(format!("{sum:08x}").as_bytes());
    Ok(())
}

/// Returns the offset of the checksums in a footer.
fn place_of_sums(footer: &[u8]) -> Option<usize> {
    // one byte for the field, and one for the length
    const BETWEEN: usize = 2;
    let key = footer.windows(KEY.len()).rposition(|part| part == KEY.as_bytes())?;
    let place = key + KEY.len() + BETWEEN;
    (place + 2 * DIGITS <= footer.len()).then_some(place)
}

/// Footer whose checksum is correct.
struct Footer {
    /// Offset of the footer in the file.
    start: u64,
    /// Checksum of all bytes before the footer.
    sum: u32,
}

/// Checks the footer of a file. A file without checksums passes.
///
/// # Errors
/// If the footer has changed, or if the file cannot be read.
pub(crate) fn check_footer(path: &Path) -> io::Result<()> {
    footer(&mut File::open(path)?).map(drop)
}

fn footer(file: &mut File) -> io::Result<Option<Footer>> {
    let length = file.seek(SeekFrom::End(0))?;
    let mut tail = [0; 8];
    if length < tail.len() as u64 {
        return Ok(None);
    }
    file.seek(SeekFrom::End(-8))?;
    file.read_exact(&mut tail)?;
    let [a, b, c, d, magic @ ..] = tail;
    let of_footer = u64::from(u32::from_le_bytes([a, b, c, d])) + 8;
    if magic != MAGIC || of_footer > length {
        return Ok(None);
    }
    let start = file.seek(SeekFrom::Start(length - of_footer))?;
    let mut footer = Vec::new();
    file.read_to_end(&mut footer)?;
    let Some(place) = place_of_sums(&footer) else {
        return Ok(None);
    };
    let sums = [place, place + DIGITS].map(|place| {
        let digits = str::from_utf8(&footer[place..place + DIGITS]).ok()?;
        u32::from_str_radix(digits, 16)
            .ok()
            .filter(|sum| format!("{sum:08x}") == digits)
    });
    footer[place + DIGITS..][..DIGITS].fill(b'0');
    match sums {
        [Some(sum), Some(own)] if crc32fast::hash(&footer) == own => Ok(Some(Footer { start, sum })),
        _ => Err(broken(&format!("its metadata are damaged; {REMEDY}"))),
    }
}

/// Checks a whole file. Files without checksums, as earlier versions wrote them, pass.
///
/// # Errors
/// If a bit has changed, or if the file cannot be read. The error names the place, where it can be determined.
pub(crate) fn check(path: &Path) -> io::Result<()> {
    let mut file = File::open(path)?;
    let footer = footer(&mut file)?;
    let metadata = ParquetMetaDataReader::new().parse_and_finish(&file)?;
    let Some(footer) = footer else {
        // no single flipped bit removes both the checksums of the pages and those of the file
        return match has_sums_of_pages(&mut file, &metadata)? {
            true => Err(broken(&format!("its checksums are damaged; {REMEDY}"))),
            false => Ok(()),
        };
    };
    let mut hasher = Hasher::new();
    let mut memory = vec![0; 1 << 20];
    file.rewind()?;
    let mut left = footer.start;
    while left > 0 {
        let count = left.min(memory.len() as u64) as usize;
        file.read_exact(&mut memory[..count])?;
        hasher.update(&memory[..count]);
        left -= count as u64;
    }
    if hasher.finalize() == footer.sum {
        return Ok(());
    }
    let place = damaged(&mut file, &metadata)?;
    let place = place.unwrap_or_else(|| "the column `failure`, or what lies between columns,".to_owned());
    Err(broken(&format!("{place} is damaged; {REMEDY}")))
}

/// Checks whether the pages of numbers have checksums.
fn has_sums_of_pages(file: &mut File, metadata: &ParquetMetaData) -> io::Result<bool> {
    let Some(group) = metadata.row_groups().first().filter(|group| group.num_columns() > 2) else {
        return Ok(false);
    };
    let rows = number(group.num_rows())?;
    let expected = head_of_page(rows, 0);
    let mut head = vec![0; expected.len()];
    file.seek(SeekFrom::Start(group.column(1).byte_range().0))?;
    file.read_exact(&mut head)?;
    // count differing bits outside the bytes of the checksum; a single one may be the damage itself
    let differ = head.iter().zip(&expected).map(|(a, b)| (a ^ b).count_ones());
    let is_sum = expected
        .iter()
        .zip(head_of_page(rows, 0x7fff_ffff))
        .map(|(&a, b)| a != b);
    let others = differ.zip(is_sum).filter(|&(_, is_sum)| !is_sum);
    Ok(others.map(|(bits, _)| bits).sum::<u32>() <= 1)
}

/// Returns the first column of numbers with a changed page, in words for a message.
fn damaged(file: &mut File, metadata: &ParquetMetaData) -> io::Result<Option<String>> {
    let mut first = 0;
    for (n, group) in metadata.row_groups().iter().enumerate() {
        let rows = first..first + number(group.num_rows())?;
        first = rows.end;
        let columns = group.columns();
        for (k, column) in columns.iter().enumerate().take(columns.len().saturating_sub(1)) {
            let (start, length) = column.byte_range();
            let mut page = vec![0; number(length)?];
            file.seek(SeekFrom::Start(start))?;
            file.read_exact(&mut page)?;
            let is_whole = if k == 0 {
                page == page_of_rows(&rows)
            } else {
                let head = bytes_of_head(rows.len());
                page.len() == bytes_of_page(rows.len())
                    && page[..head] == head_of_page(rows.len(), crc32fast::hash(&page[head..]))
            };
            if !is_whole {
                let (name, last) = (column.column_descr().name(), rows.end - 1);
                return Ok(Some(format!(
                    "the column `{name}` in row group {n}, rows {} to {last},",
                    rows.start
                )));
            }
        }
    }
    Ok(None)
}
