//! Shards of a file, each complete or absent.
//!
//! The numbers of all shards, which are most of the output, are written once: into one file, at a fixed offset for each
//! shard. A small file marks a shard as complete. It has the failures of the shard, and the checksums of both files in
//! its name. To merge, the contents of the small files are appended to the big one, which thereby becomes the table.
//!
//! A process that computes all shards, or merges them, holds an exclusive lock; processes that compute shares hold a
//! shared lock. Files of another sweep are never touched, locked or not: each small file contains the declaration, and
//! the name of the big one its checksum.

use std::collections::BTreeMap;
use std::ffi::{OsStr, OsString};
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::thread;
use std::time::Duration;

use crate::checksum::{self, Sum};
use crate::differences::differences;
use crate::error::SweepError;
use crate::file::{self, Ending, Part};
use crate::page::{MAGIC, bytes_of_page};
use crate::table::Table;

/// File of a sweep, and the folder of its shards.
pub(crate) struct Shards<'p> {
    path: &'p Path,
    folder: PathBuf,
    /// File with the numbers of all shards.
    numbers: PathBuf,
    points: usize,
    length: usize,
    pub(crate) count: usize,
    /// Table without rows, with the declaration.
    pub(crate) empty: Table,
    /// Buffers of finished shards, for reuse: fresh memory would cost as much time as writing the numbers.
    spare: Mutex<Vec<Vec<u8>>>,
    /// True if flushing to the disk has failed.
    is_lost: AtomicBool,
}

/// Access of a process to the shards of a sweep.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    /// Exclusive: computes all shards, or merges them.
    Alone,
    /// Shared: computes some shards while others compute the rest.
    Share,
}

/// Lock that holds the [`Role`] of this process until it is dropped.
pub(crate) struct Lock {
    _file: File,
}

const DECLARATION: &str = "declaration.json";
const LOCK: &str = "lock";
/// Name of the lock file that is held briefly while a process acquires its role.
const ENTRANCE: &str = "entrance";

/// Alignment of shards, in bytes: no two processes write to the same page of memory or block of a disk.
const PAGE: usize = 4096;

impl<'p> Shards<'p> {
    pub(crate) fn new(path: &'p Path, points: usize, length: usize, empty: Table) -> Result<Self, SweepError> {
        let ends_in_name = !path.as_os_str().to_string_lossy().ends_with(std::path::is_separator);
        let name = path.file_name().filter(|_| ends_in_name && !path.is_dir());
        let name =
            name.ok_or_else(|| SweepError::Invalid(format!("{} is a folder; name a file in it", path.display())))?;
        let mut folder = OsString::from(name);
        folder.push(".shards");
        let folder = path.with_file_name(folder);
        Ok(Self {
            path,
            numbers: folder.join(format!("{:08x}.numbers", crc32fast::hash(empty.declaration.as_bytes()))),
            folder,
            points,
            length,
            count: points.div_ceil(length),
            empty,
            spare: Mutex::default(),
            is_lost: AtomicBool::new(false),
        })
    }

    /// Rows of a shard.
    pub(crate) fn rows(&self, n: usize) -> Range<usize> {
        n * self.length..self.points.min((n + 1) * self.length)
    }

    /// Offset of the numbers of a shard.
    fn place(&self, n: usize) -> u64 {
        let room = file::most_bytes(self.empty.columns.len(), self.length.min(self.points));
        (PAGE + n * room.next_multiple_of(PAGE)) as u64
    }

    /// Returns those of `shards` that are missing. Removes broken ones.
    pub(crate) fn missing(&self, shards: impl Iterator<Item = usize>) -> Result<Vec<usize>, SweepError> {
        let present = self.present()?;
        let mut missing = Vec::new();
        for n in shards {
            if let Some(&sums) = present.get(&n) {
                let path = self.path_of(n, sums);
                if self.is_whole(n, sums, &path)? {
                    continue;
                }
                eprintln!("{} is broken; its shard is missing", path.display());
                fs::remove_file(&path).map_err(SweepError::file(&path))?;
            }
            missing.push(n);
        }
        Ok(missing)
    }

    /// Checks the checksums of a shard, which must belong to this sweep.
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

    /// Shards that exist, broken or not, with their expected checksums.
    fn present(&self) -> Result<BTreeMap<usize, [u32; 2]>, SweepError> {
        let entries = fs::read_dir(&self.folder).map_err(SweepError::file(&self.folder))?;
        let mut present = BTreeMap::new();
        for entry in entries {
            let name = entry.map_err(SweepError::file(&self.folder))?.file_name();
            let shard = |name: &str| {
                let mut parts = name.strip_suffix(".shard")?.split('-');
                let n: usize = parts.next()?.parse().ok()?;
                let [failures, numbers] = [parts.next()?, parts.next()?].map(|sum| u32::from_str_radix(sum, 16));
                let sums = [failures.ok()?, numbers.ok()?];
                (name == Self::name(n, sums)).then_some((n, sums))
            };
            present.extend(name.to_str().and_then(shard));
        }
        Ok(present)
    }

    fn name(n: usize, [failures, numbers]: [u32; 2]) -> String {
        format!("{n:06}-{failures:08x}-{numbers:08x}.shard")
    }

    /// Path of the small file of a shard.
    fn path_of(&self, n: usize, sums: [u32; 2]) -> PathBuf {
        self.folder.join(Self::name(n, sums))
    }

    /// True if the folder holds a sweep in progress.
    pub(crate) fn are_begun(&self) -> bool {
        self.folder.join(DECLARATION).exists()
    }

    /// True if the file exists. Returns an error if its metadata belong to another sweep.
    pub(crate) fn is_merged(&self) -> Result<bool, SweepError> {
        if !self.path.exists() {
            return Ok(false);
        }
        checksum::check_footer(self.path).map_err(SweepError::file(self.path))?;
        let (declaration, rows) = file::declaration(self.path).map_err(SweepError::file(self.path))?;
        self.compare(self.path, &declaration)?;
        if rows != self.points {
            let error = io::Error::new(io::ErrorKind::InvalidData, "it has too few rows, or too many");
            return Err(SweepError::File(self.path.to_owned(), error));
        }
        Ok(true)
    }

    /// Acquires `role`, and creates the folder if necessary. Returns `None` if the file exists already.
    ///
    /// # Errors
    /// [`SweepError::Busy`] if other processes hold a conflicting role, and [`SweepError::Other`].
    pub(crate) fn enter(&self, role: Role) -> Result<Option<Lock>, SweepError> {
        if !self.is_merged()? {
            let lock = self.open(role)?;
            // another process may have finished meanwhile
            if !self.is_merged()? {
                return Ok(Some(lock));
            }
        }
        checksum::check(self.path).map_err(SweepError::file(self.path))?;
        self.clean().map(|()| None)
    }

    fn open(&self, role: Role) -> Result<Lock, SweepError> {
        fs::create_dir_all(&self.folder).map_err(SweepError::file(&self.folder))?;
        let file = |path: &Path| {
            let mut options = OpenOptions::new();
            let file = options.write(true).create(true).truncate(false).open(path);
            file.map_err(SweepError::file(path))
        };
        let (entrance, lock) = (file(&self.folder.join(ENTRANCE))?, file(&self.folder.join(LOCK))?);
        // proceed without locks if the file system has none
        let _ = entrance.lock();
        let is_held = |locked: Result<(), TryLockError>| matches!(locked, Err(TryLockError::WouldBlock));
        let is_alone = !is_held(lock.try_lock());
        if !is_alone && role == Role::Alone {
            return Err(SweepError::Busy(self.path.to_owned()));
        }
        self.declare(is_alone)?;
        if role == Role::Share {
            let _ = lock.unlock();
            if is_held(lock.try_lock_shared()) {
                return Err(SweepError::Busy(self.path.to_owned()));
            }
        }
        file(&self.numbers)?;
        Ok(Lock { _file: lock })
    }

    /// Writes the declaration, or checks that the existing one is of this sweep. A different one is replaced if no
    /// other process is at work and there are no shards yet, so that nothing is lost.
    fn declare(&self, is_alone: bool) -> Result<(), SweepError> {
        let path = self.folder.join(DECLARATION);
        let text = match fs::read_to_string(&path) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(SweepError::File(path, error)),
            text => text.unwrap_or_default(),
        };
        // a power failure may leave an empty file
        if text.is_empty() || is_alone && self.present()?.is_empty() {
            return file::replace(&path, |file| file.write_all(self.empty.declaration.as_bytes()))
                .map_err(SweepError::file(&path));
        }
        self.compare(&self.folder, &text)
    }

    /// Creates the buffers of a shard to be computed.
    pub(crate) fn begin(&self, n: usize) -> Part {
        let memory = self.spare.lock().map_or(None, |mut spare| spare.pop());
        Part::new(self.rows(n), self.empty.columns.len(), memory.unwrap_or_default())
    }

    pub(crate) fn write(&self, n: usize, mut shard: Part) -> Result<(), SweepError> {
        let numbers = shard.numbers();
        let of_numbers = crc32fast::hash(numbers);
        let written = self.write_numbers(n, numbers);
        written.map_err(SweepError::file(&self.numbers))?;
        if self.is_lost.load(Ordering::Relaxed) {
            let error = io::Error::other("what was written could not go to the disk");
            return Err(SweepError::File(self.numbers.clone(), error));
        }
        let failures = shard.failures(&self.empty).map_err(SweepError::file(&self.folder))?;
        let path = self.path_of(n, [crc32fast::hash(&failures), of_numbers]);
        file::replace(&path, |file| file.write_all(&failures)).map_err(SweepError::file(&path))?;
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

    /// Runs `work`, which writes shards, while another thread flushes the written data to the disk. This avoids a wait
    /// at the end, and keeps the page cache small.
    pub(crate) fn flushed<R>(&self, work: impl FnOnce() -> Result<R, SweepError>) -> Result<R, SweepError> {
        let (done, until) = mpsc::channel();
        let (result, flushed) = thread::scope(|scope| {
            let flushed = scope.spawn(|| {
                self.flush(until)
                    .inspect_err(|_| self.is_lost.store(true, Ordering::Relaxed))
            });
            let result = work();
            drop(done);
            (result, flushed.join())
        });
        let flushed = flushed.unwrap_or_else(|_| Err(io::Error::other("the thread that writes to it has panicked")));
        flushed.map_err(SweepError::file(&self.numbers))?;
        result
    }

    /// Flushes periodically until the sender is dropped.
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

    /// Reads the numbers of a shard; the result is shorter if the file ends early.
    fn read(&self, n: usize, length: usize) -> io::Result<Vec<u8>> {
        let mut file = File::open(&self.numbers)?;
        file.seek(SeekFrom::Start(self.place(n)))?;
        let mut numbers = Vec::with_capacity(length);
        file.take(length as u64).read_to_end(&mut numbers)?;
        Ok(numbers)
    }

    /// Merges the shards into the file.
    pub(crate) fn merge(&self) -> Result<(), SweepError> {
        let present = self.present()?;
        if let Some(missing) = (0..self.count).find(|n| !present.contains_key(n)) {
            return Err(SweepError::Incomplete {
                present: present.len(),
                of: self.count,
                missing,
            });
        }
        let in_numbers = || SweepError::file(&self.numbers);
        let mut file = OpenOptions::new()
            .write(true)
            .open(&self.numbers)
            .map_err(in_numbers())?;
        let prepared = file
            .write_all(&MAGIC)
            .and_then(|()| file.set_len(self.place(self.count)));
        prepared.map_err(in_numbers())?;
        let sum = self.sum(&present);
        let mut ending = Ending::new(&mut file, &self.empty, sum).map_err(in_numbers())?;
        for (&n, &sums) in present.iter().take(self.count) {
            let path = self.path_of(n, sums);
            let failures = fs::read(&path).map_err(SweepError::file(&path))?.into();
            let (declaration, _) = file::read_failures(&failures, 0).map_err(SweepError::file(&path))?;
            self.compare(&path, &declaration)?;
            ending.add(self.place(n) as usize, &failures).map_err(in_numbers())?;
        }
        ending.finish().and_then(|()| file.sync_all()).map_err(in_numbers())?;
        self.publish()?;
        self.clean()
    }

    /// Checksum of the numbers of all shards at their offsets, combined from the checksum of each without reading them
    /// again.
    fn sum(&self, present: &BTreeMap<usize, [u32; 2]>) -> Sum {
        let mut sum = Sum::default();
        sum.add(&MAGIC);
        for (&n, &[_, of_numbers]) in present.iter().take(self.count) {
            sum.add_zeros(self.place(n));
            let length = self.empty.columns.len() * bytes_of_page(self.rows(n).len());
            sum.add_sum(of_numbers, length as u64);
        }
        sum.add_zeros(self.place(self.count));
        sum
    }

    /// Renames the finished file to its final name, unless that exists by now.
    fn publish(&self) -> Result<(), SweepError> {
        if self.is_merged()? {
            return Ok(());
        }
        match fs::hard_link(&self.numbers, self.path) {
            Ok(()) => {}
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => return self.is_merged().map(drop),
            // not all file systems have hard links
            Err(_) => fs::rename(&self.numbers, self.path).map_err(SweepError::file(self.path))?,
        }
        #[cfg(unix)]
        if let Some(parent) = self.path.parent() {
            let parent = if parent.as_os_str().is_empty() {
                Path::new(".")
            } else {
                parent
            };
            // flush the folder, where the system allows it, before the shards are removed
            let _ = File::open(parent).and_then(|folder| folder.sync_all());
        }
        Ok(())
    }

    /// Removes the remaining shards of this sweep once the file exists, and no other files.
    pub(crate) fn clean(&self) -> Result<(), SweepError> {
        let declaration = fs::read_to_string(self.folder.join(DECLARATION));
        if !declaration.is_ok_and(|text| text == self.empty.declaration) {
            return Ok(());
        }
        let remove = || {
            for entry in fs::read_dir(&self.folder)? {
                let path = entry?.path();
                let is_own = |name: &str| {
                    let ends = [".shard", ".numbers", ".tmp"];
                    [LOCK, ENTRANCE].contains(&name) || ends.iter().any(|end| name.ends_with(end))
                };
                if path.file_name().and_then(OsStr::to_str).is_some_and(is_own) {
                    fs::remove_file(path)?;
                }
            }
            fs::remove_file(self.folder.join(DECLARATION))?;
            fs::remove_dir(&self.folder)
        };
        match remove() {
            // another process may do the same at the same time; files of other origin stay
            Err(error) if ![io::ErrorKind::NotFound, io::ErrorKind::DirectoryNotEmpty].contains(&error.kind()) => {
                Err(SweepError::File(self.folder.clone(), error))
            }
            _ => Ok(()),
        }
    }

    /// Checks that a declaration is the one of this sweep; otherwise the error lists the differences.
    fn compare(&self, path: &Path, other: &str) -> Result<(), SweepError> {
        if other == self.empty.declaration {
            return Ok(());
        }
        let differs = differences(&self.empty.declaration, other);
        if differs.is_empty() {
            return Ok(());
        }
        let path = path.to_owned();
        Err(SweepError::Other { path, differs })
    }
}
