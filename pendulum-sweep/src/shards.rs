//! The shards of a file: each complete or absent.
//!
//! The numbers of all shards, which are most of what is written, lie in one file from the beginning, each shard in a
//! place of its own, so that they are written once. A small file tells that a shard is complete: it has the failures of
//! the shard, and in its name the checksums of both. The big file becomes the table by adding to it what the small ones
//! have.

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::thread;
use std::time::Duration;

use serde_json::Value;

use crate::error::SweepError;
use crate::file::{self, Part};
use crate::table::Table;

/// The file of a sweep, and the folder of its shards.
pub(crate) struct Shards<'p> {
    path: &'p Path,
    folder: PathBuf,
    /// The file with the numbers of all shards.
    numbers: PathBuf,
    points: usize,
    length: usize,
    pub(crate) count: usize,
    /// The table without rows, with the declaration.
    pub(crate) empty: Table,
    /// Memory that shards have had: fresh memory would cost as much as to write it.
    spare: Mutex<Vec<Vec<u8>>>,
}

const DECLARATION: &str = "declaration.json";

/// Shards begin at multiples of this many bytes: no two processes write to the same page of memory or block of a disk.
const PAGE: usize = 4096;

impl<'p> Shards<'p> {
    pub(crate) fn new(path: &'p Path, points: usize, length: usize, empty: Table) -> Result<Self, SweepError> {
        let name = path.file_name();
        let name = name.ok_or_else(|| SweepError::Invalid(format!("{} is not the name of a file", path.display())))?;
        let mut folder = OsString::from(name);
        folder.push(".shards");
        let folder = path.with_file_name(folder);
        Ok(Self {
            path,
            numbers: folder.join("numbers"),
            folder,
            points,
            length,
            count: points.div_ceil(length),
            empty,
            spare: Mutex::default(),
        })
    }

    /// The rows of a shard.
    pub(crate) fn rows(&self, n: usize) -> Range<usize> {
        n * self.length..self.points.min((n + 1) * self.length)
    }

    /// Where the numbers of a shard begin.
    fn place(&self, n: usize) -> u64 {
        let room = file::most_bytes(self.empty.columns.len(), self.length.min(self.points));
        (PAGE + n * room.next_multiple_of(PAGE)) as u64
    }

    /// Those of some shards that are not there. Broken ones are removed.
    pub(crate) fn missing(&self, shards: impl Iterator<Item = usize>) -> Result<Vec<usize>, SweepError> {
        let present = self.present()?;
        let mut missing = Vec::new();
        for n in shards {
            if let Some(&sums) = present.get(&n) {
                let path = self.of(n, sums);
                if self.is_whole(n, sums, &path)? {
                    continue;
                }
                eprintln!("{} is broken, and is computed again", path.display());
                fs::remove_file(&path).map_err(SweepError::file(&path))?;
            }
            missing.push(n);
        }
        Ok(missing)
    }

    /// Whether a shard has its checksums; it must be of this sweep.
    fn is_whole(&self, n: usize, [of_failures, of_numbers]: [u32; 2], path: &Path) -> Result<bool, SweepError> {
        let failures = fs::read(path).map_err(SweepError::file(path))?;
        if crc32fast::hash(&failures) != of_failures {
            return Ok(false);
        }
        let columns = self.empty.columns.len();
        let (declaration, length) = file::read_failures(&failures.into(), columns).map_err(SweepError::file(path))?;
        self.compare(path, &declaration)?;
        let numbers = self.read(n, length).map_err(SweepError::file(&self.numbers))?;
        Ok(crc32fast::hash(&numbers) == of_numbers)
    }

    /// The shards that are there, broken or not, with the checksums that they should have.
    fn present(&self) -> Result<BTreeMap<usize, [u32; 2]>, SweepError> {
        let entries = fs::read_dir(&self.folder).map_err(SweepError::file(&self.folder))?;
        let mut present = BTreeMap::new();
        for entry in entries {
            let name = entry.map_err(SweepError::file(&self.folder))?.file_name();
            let shard = |name: &str| {
                let mut parts = name.strip_suffix(".shard")?.split('-');
                let n: usize = parts.next()?.parse().ok()?;
                let [failures, numbers] = [parts.next()?, parts.next()?].map(|sum| u32::from_str_radix(sum, 16));
                Some((n, [failures.ok()?, numbers.ok()?]))
            };
            present.extend(name.to_str().and_then(shard));
        }
        Ok(present)
    }

    fn of(&self, n: usize, [failures, numbers]: [u32; 2]) -> PathBuf {
        self.folder.join(format!("{n:06}-{failures:08x}-{numbers:08x}.shard"))
    }

    /// Whether the file is there; it must be that of this sweep.
    pub(crate) fn is_merged(&self) -> Result<bool, SweepError> {
        if !self.path.exists() {
            return Ok(false);
        }
        let declaration = file::declaration(self.path).map_err(SweepError::file(self.path))?;
        self.compare(self.path, &declaration).map(|()| true)
    }

    /// Makes the folder, or sees that what is there is of this sweep.
    pub(crate) fn open(&self) -> Result<(), SweepError> {
        fs::create_dir_all(&self.folder).map_err(SweepError::file(&self.folder))?;
        let declaration = self.folder.join(DECLARATION);
        let has_shards = !self.present()?.is_empty();
        match fs::read_to_string(&declaration) {
            // nothing is lost where there is nothing yet; a loss of power may leave an empty text
            Ok(text) if has_shards && !text.is_empty() => self.compare(&self.folder, &text)?,
            Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(SweepError::File(declaration, error)),
            _ => whole(&declaration, self.empty.declaration.as_bytes()).map_err(SweepError::file(&declaration))?,
        }
        let mut options = OpenOptions::new();
        let numbers = options.write(true).create(true).truncate(false).open(&self.numbers);
        numbers.map(drop).map_err(SweepError::file(&self.numbers))
    }

    /// A shard that is to be computed.
    pub(crate) fn begin(&self, n: usize) -> Part {
        let memory = self.spare.lock().map_or(None, |mut spare| spare.pop());
        Part::new(self.rows(n), self.empty.columns.len(), memory.unwrap_or_default())
    }

    pub(crate) fn write(&self, n: usize, shard: Part) -> Result<(), SweepError> {
        let numbers = self.write_numbers(n, shard.numbers());
        numbers.map_err(SweepError::file(&self.numbers))?;
        let failures = shard.failures(&self.empty).map_err(SweepError::file(&self.folder))?;
        let path = self.of(n, [crc32fast::hash(&failures), crc32fast::hash(shard.numbers())]);
        whole(&path, &failures).map_err(SweepError::file(&path))?;
        if let Ok(mut spare) = self.spare.lock() {
            spare.push(shard.into_memory());
        }
        Ok(())
    }

    fn write_numbers(&self, n: usize, numbers: &[u8]) -> io::Result<()> {
        let mut file = OpenOptions::new().write(true).open(&self.numbers)?;
        file.seek(SeekFrom::Start(self.place(n)))?;
        file.write_all(numbers)
    }

    /// Does something that writes shards, while what is written goes to the disk. At the end nothing waits for the disk,
    /// and however long it takes, the memory of the system is not full of it.
    pub(crate) fn flushed<R>(&self, work: impl FnOnce() -> Result<R, SweepError>) -> Result<R, SweepError> {
        let (done, until) = mpsc::channel();
        let (result, flushed) = thread::scope(|scope| {
            let flushed = scope.spawn(|| self.flush(until));
            let result = work();
            drop(done);
            (result, flushed.join())
        });
        let result = result?;
        let flushed = flushed.unwrap_or_else(|_| Err(io::Error::other("the thread that writes to it has panicked")));
        flushed.map_err(SweepError::file(&self.numbers))?;
        Ok(result)
    }

    /// Writes to the disk, again and again, what there is.
    fn flush(&self, until: Receiver<()>) -> io::Result<()> {
        const PERIOD: Duration = Duration::from_secs(1);
        let file = OpenOptions::new().write(true).open(&self.numbers)?;
        while let Err(RecvTimeoutError::Timeout) = until.recv_timeout(PERIOD) {
            file.sync_data()?;
            #[cfg(target_os = "linux")]
            rustix::fs::fadvise(&file, 0, None, rustix::fs::Advice::DontNeed)?;
        }
        Ok(())
    }

    /// The numbers of a shard, as far as they are there.
    fn read(&self, n: usize, length: usize) -> io::Result<Vec<u8>> {
        let mut file = File::open(&self.numbers)?;
        file.seek(SeekFrom::Start(self.place(n)))?;
        let mut numbers = Vec::with_capacity(length);
        file.take(length as u64).read_to_end(&mut numbers)?;
        Ok(numbers)
    }

    /// Makes the file of the shards.
    pub(crate) fn merge(&self) -> Result<(), SweepError> {
        let present = self.present()?;
        if let Some(missing) = (0..self.count).find(|n| !present.contains_key(n)) {
            return Err(SweepError::Incomplete {
                present: present.len(),
                of: self.count,
                missing,
            });
        }
        let conclude = || {
            let mut file = OpenOptions::new().write(true).open(&self.numbers)?;
            file.write_all(&file::MAGIC)?;
            file.set_len(self.place(self.count))?;
            let shards = present.iter().take(self.count);
            let parts = shards.map(|(&n, &sums)| Ok((self.place(n), fs::read(self.of(n, sums))?.into())));
            file::conclude(&mut file, &self.empty, parts)?;
            file.sync_all()?;
            fs::rename(&self.numbers, self.path)
        };
        conclude().map_err(SweepError::file(self.path))?;
        self.clean()
    }

    /// Removes what is left of the shards when the file is there.
    pub(crate) fn clean(&self) -> Result<(), SweepError> {
        let declaration = fs::read_to_string(self.folder.join(DECLARATION));
        if declaration.is_ok_and(|text| text == self.empty.declaration) {
            fs::remove_dir_all(&self.folder).map_err(SweepError::file(&self.folder))?;
        }
        Ok(())
    }

    /// That a declaration is the one of this sweep, and else in what it differs.
    fn compare(&self, path: &Path, other: &str) -> Result<(), SweepError> {
        if other == self.empty.declaration {
            return Ok(());
        }
        let read = |text: &str| serde_json::from_str(text).unwrap_or(Value::Null);
        let mut differs = Vec::new();
        differences("", (&read(&self.empty.declaration), &read(other)), &mut differs);
        let path = path.to_owned();
        Err(SweepError::Other { path, differs })
    }
}

/// Where another declaration differs from the own one, and how.
fn differences(place: &str, (own, other): (&Value, &Value), differs: &mut Vec<String>) {
    match (own, other) {
        (Value::Object(own), Value::Object(other)) => {
            let added = other.keys().filter(|key| !own.contains_key(*key));
            for key in own.keys().chain(added) {
                let of = |object: &serde_json::Map<String, Value>| object.get(key).cloned().unwrap_or_default();
                let place = if place.is_empty() {
                    key
                } else {
                    &format!("{place}.{key}")
                };
                differences(place, (&of(own), &of(other)), differs);
            }
        }
        (Value::Array(own), Value::Array(other)) if own.len() == other.len() => {
            for (n, pair) in own.iter().zip(other).enumerate() {
                differences(&format!("{place}[{n}]"), pair, differs);
            }
        }
        _ if own == other => {}
        _ => {
            let [own, other] = [own, other].map(shortened);
            differs.push(format!("{place}: {other} in place of {own}"));
        }
    }
}

/// A value as text, of which much is left out.
fn shortened(value: &Value) -> String {
    const MOST: usize = 120;
    let text = value.to_string();
    match text.char_indices().nth(MOST) {
        Some((end, _)) => format!("{}..", &text[..end]),
        None if value.is_null() => "nothing".to_owned(),
        None => text,
    }
}

/// Writes a file that is complete or absent at any time, under another name at first. Where power fails, some of it may
/// be missing.
fn whole(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(format!(".{}.tmp", std::process::id()));
    let unfinished = path.with_file_name(name);
    fs::write(&unfinished, bytes)
        .and_then(|()| fs::rename(&unfinished, path))
        .inspect_err(|_| {
            // what is unfinished is of no use; the error says more than that it could not be removed
            let _ = fs::remove_file(&unfinished);
        })
}
