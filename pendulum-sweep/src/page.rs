//! Pages of numbers in a Parquet file, written without the library.

use std::error::Error;
use std::io;
use std::ops::Range;

/// Magic number at the start of a Parquet file.
pub(crate) const MAGIC: [u8; 4] = *b"PAR1";

/// Size of a page of `rows` rows, in bytes.
pub(crate) fn bytes_of_page(rows: usize) -> usize {
    bytes_of_head(rows) + size_of::<f64>() * rows
}

/// Size of the header of a page, in bytes.
pub(crate) fn bytes_of_head(rows: usize) -> usize {
    head_of_page(rows, 0).len()
}

/// Header of a page of numbers with a checksum.
pub(crate) fn head_of_page(rows: usize, checksum: u32) -> Vec<u8> {
    const PLAIN: usize = 0;
    header_of_page(rows, size_of::<f64>() * rows, PLAIN, checksum)
}

/// Encodes a `PageHeader` of `parquet.thrift` in Thrift's compact protocol. Its length is the same for all checksums.
fn header_of_page(rows: usize, bytes: usize, encoding: usize, checksum: u32) -> Vec<u8> {
    const I32: u8 = 5;
    const STRUCT: u8 = 12;
    let mut head = Vec::new();
    let field = |head: &mut Vec<u8>, step: u8, kind: u8| head.push(step << 4 | kind);
    let integer = |head: &mut Vec<u8>, number: usize| {
        field(head, 1, I32);
        push_varint(head, 2 * number);
    };
    // the kind (data page), and the size with and without compression
    for number in [0, bytes, bytes] {
        integer(&mut head, number);
    }
    // CRC-32 as a signed number, padded to the maximum length of five bytes
    field(&mut head, 1, I32);
    let checksum = (checksum << 1) ^ ((checksum as i32 >> 31) as u32);
    head.extend((0..5).map(|piece| (checksum >> (7 * piece)) as u8 & 0x7f | if piece < 4 { 0x80 } else { 0 }));
    field(&mut head, 1, STRUCT);
    // number of rows, encoding, and RLE for both kinds of levels
    for number in [rows, encoding, 3, 3] {
        integer(&mut head, number);
    }
    head.extend([0, 0]);
    head
}

/// Appends a number in groups of seven bits, the lowest first.
fn push_varint(bytes: &mut Vec<u8>, mut number: usize) {
    while number >= 0x80 {
        bytes.push(number as u8 | 0x80);
        number >>= 7;
    }
    bytes.push(number as u8);
}

/// Page of consecutive numbers, stored as differences (`DELTA_BINARY_PACKED`).
pub(crate) fn page_of_rows(rows: &Range<usize>) -> Vec<u8> {
    const DELTA_BINARY_PACKED: usize = 5;
    const BLOCK: usize = 128;
    const MINIBLOCKS: usize = 4;
    let mut numbers = Vec::new();
    // signed numbers are doubled (zigzag)
    for number in [BLOCK, MINIBLOCKS, rows.len(), 2 * rows.start] {
        push_varint(&mut numbers, number);
    }
    for _ in 0..rows.len().saturating_sub(1).div_ceil(BLOCK) {
        // minimum difference (1, doubled), and zero further bits for each miniblock
        push_varint(&mut numbers, 2);
        numbers.extend([0; MINIBLOCKS]);
    }
    let mut page = header_of_page(
        rows.len(),
        numbers.len(),
        DELTA_BINARY_PACKED,
        crc32fast::hash(&numbers),
    );
    page.extend(numbers);
    page
}

/// Converts a number of a file, which may be too large for this machine.
pub(crate) fn number<T: TryInto<usize, Error: Error + Send + Sync + 'static>>(number: T) -> io::Result<usize> {
    number.try_into().map_err(io::Error::other)
}

pub(crate) fn broken(what: &str) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, what)
}
