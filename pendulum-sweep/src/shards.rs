//! The shards of a file: each complete or absent.

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};

use crc32fast::Hasher;
use serde_json::Value;

use crate::error::SweepError;
use crate::file;
use crate::table::Table;

/// The file of a sweep, and the folder of its shards.
pub(crate) struct Shards<'p> {
    path: &'p Path,
    folder: PathBuf,
    points: usize,
    length: usize,
    pub(crate) count: usize,
    /// The table without rows, with the declaration.
    pub(crate) empty: Table,
}

const DECLARATION: &str = "declaration.json";

impl<'p> Shards<'p> {
    pub(crate) fn new(path: &'p Path, points: usize, length: usize, empty: Table) -> Result<Self, SweepError> {
        let name = path.file_name();
        let name = name.ok_or_else(|| SweepError::Invalid(format!("{} is not the name of a file", path.display())))?;
        let mut folder = OsString::from(name);
        folder.push(".shards");
        Ok(Self {
            path,
            folder: path.with_file_name(folder),
            points,
            length,
            count: points.div_ceil(length),
            empty,
        })
    }

    /// The rows of a shard.
    pub(crate) fn rows(&self, n: usize) -> Range<usize> {
        n * self.length..self.points.min((n + 1) * self.length)
    }

    /// Those of some shards that are not there. Broken ones are removed: the name of a shard has the checksum of its
    /// bytes.
    pub(crate) fn missing(&self, shards: impl Iterator<Item = usize>) -> Result<Vec<usize>, SweepError> {
        let present = self.present()?;
        let is_missing = |n: &usize| match present.get(n) {
            None => Ok(true),
            Some(path) => {
                let bytes = fs::read(path).map_err(SweepError::file(path))?;
                let is_broken = *path != self.of(*n, crc32fast::hash(&bytes));
                if is_broken {
                    eprintln!("{} is broken, and is computed again", path.display());
                    fs::remove_file(path).map_err(SweepError::file(path))?;
                }
                Ok(is_broken)
            }
        };
        let checked = shards.filter_map(|n| match is_missing(&n) {
            Ok(is_missing) => is_missing.then_some(Ok(n)),
            Err(error) => Some(Err(error)),
        });
        checked.collect()
    }

    /// The shards that are there, broken or not.
    fn present(&self) -> Result<BTreeMap<usize, PathBuf>, SweepError> {
        let entries = fs::read_dir(&self.folder).map_err(SweepError::file(&self.folder))?;
        let mut present = BTreeMap::new();
        for entry in entries {
            let path = entry.map_err(SweepError::file(&self.folder))?.path();
            let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
            let number = name.strip_suffix(".parquet").and_then(|name| name.split_once('-'));
            if let Some(n) = number.and_then(|(number, _)| number.parse().ok()) {
                present.insert(n, path);
            }
        }
        Ok(present)
    }

    fn of(&self, n: usize, sum: u32) -> PathBuf {
        self.folder.join(format!("{n:06}-{sum:08x}.parquet"))
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
        match fs::read_to_string(&declaration) {
            Ok(text) => self.compare(&self.folder, &text),
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                let text = self.empty.declaration.clone();
                whole(&declaration, |file| {
                    file.write_all(text.as_bytes())?;
                    Ok(declaration.clone())
                })
            }
            Err(error) => Err(SweepError::File(declaration, error)),
        }
    }

    pub(crate) fn write(&self, n: usize, table: &Table) -> Result<(), SweepError> {
        whole(&self.folder.join(format!("{n:06}")), |file| {
            let mut file = Summed {
                file: BufWriter::new(file),
                sum: Hasher::new(),
            };
            file::write(&mut file, self.rows(n).start, table)?;
            file.flush()?;
            Ok(self.of(n, file.sum.finalize()))
        })
    }

    /// Puts the file together, and removes the shards.
    pub(crate) fn merge(&self) -> Result<(), SweepError> {
        let present = self.present()?;
        if let Some(missing) = (0..self.count).find(|n| !present.contains_key(n)) {
            return Err(SweepError::Incomplete {
                present: present.len(),
                of: self.count,
                missing,
            });
        }
        let parts: Vec<PathBuf> = present.into_values().take(self.count).collect();
        whole(self.path, |file| {
            file::concatenate(file, &self.empty, &parts)?;
            Ok(self.path.to_owned())
        })?;
        fs::remove_dir_all(&self.folder).map_err(SweepError::file(&self.folder))
    }

    /// That a declaration is the one of this sweep, and else in what it differs.
    fn compare(&self, path: &Path, other: &str) -> Result<(), SweepError> {
        if other == self.empty.declaration {
            return Ok(());
        }
        let [own, other] =
            [self.empty.declaration.as_str(), other].map(|text| serde_json::from_str(text).unwrap_or(Value::Null));
        let parts = own
            .as_object()
            .into_iter()
            .flatten()
            .filter(|(part, value)| other.get(part) != Some(value));
        let differs = parts.map(|(part, _)| part.clone()).collect();
        let path = path.to_owned();
        Err(SweepError::Other { path, differs })
    }
}

/// A file, and the checksum of what is written to it.
struct Summed<W> {
    file: W,
    sum: Hasher,
}

impl<W: Write> Write for Summed<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.file.write(bytes)?;
        self.sum.update(&bytes[..written]);
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

/// Writes a file that is complete or absent at any time, under a name like `path` at first, and then under the one that
/// `write` returns.
fn whole(path: &Path, write: impl FnOnce(&mut File) -> io::Result<PathBuf>) -> Result<(), SweepError> {
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(format!(".{}.tmp", std::process::id()));
    let unfinished = path.with_file_name(name);
    if let Some(folder) = path.parent().filter(|folder| !folder.as_os_str().is_empty()) {
        fs::create_dir_all(folder).map_err(SweepError::file(folder))?;
    }
    let written = File::create(&unfinished).and_then(|mut file| {
        let path = write(&mut file)?;
        file.sync_all()?;
        fs::rename(&unfinished, path)
    });
    written.map_err(|error| {
        // what is unfinished is of no use; the error says more than that it could not be removed
        let _ = fs::remove_file(&unfinished);
        SweepError::File(path.to_owned(), error)
    })
}
