//! The shards of a file: each complete or absent.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};

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
    empty: Table,
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

    pub(crate) fn has(&self, n: usize) -> bool {
        self.of(n).exists()
    }

    fn of(&self, n: usize) -> PathBuf {
        self.folder.join(format!("{n:06}.parquet"))
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
                whole(&declaration, |file| file.write_all(text.as_bytes()))
            }
            Err(error) => Err(SweepError::File(declaration, error)),
        }
    }

    pub(crate) fn write(&self, n: usize, table: &Table) -> Result<(), SweepError> {
        whole(&self.of(n), |file| {
            file::write(file, &self.empty, [Ok((self.rows(n).start, table.clone()))])
        })
    }

    /// Puts the file together, and removes the shards.
    pub(crate) fn merge(&self) -> Result<(), SweepError> {
        self.open()?;
        let missing = (0..self.count).find(|&n| !self.has(n));
        if let Some(missing) = missing {
            let present = (0..self.count).filter(|&n| self.has(n)).count();
            return Err(SweepError::Incomplete {
                present,
                of: self.count,
                missing,
            });
        }
        let shards = (0..self.count).map(|n| Ok((self.rows(n).start, Table::read_file(&self.of(n))?)));
        whole(self.path, |file| file::write(file, &self.empty, shards))?;
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

/// Writes a file that is complete or absent at any time.
fn whole(path: &Path, write: impl FnOnce(&mut File) -> io::Result<()>) -> Result<(), SweepError> {
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(format!(".{}.tmp", std::process::id()));
    let unfinished = path.with_file_name(name);
    if let Some(folder) = path.parent().filter(|folder| !folder.as_os_str().is_empty()) {
        fs::create_dir_all(folder).map_err(SweepError::file(folder))?;
    }
    let written = File::create(&unfinished).and_then(|mut file| {
        write(&mut file)?;
        file.sync_all()?;
        fs::rename(&unfinished, path)
    });
    written.map_err(|error| {
        // what is unfinished is of no use; the error says more than that it could not be removed
        let _ = fs::remove_file(&unfinished);
        SweepError::File(path.to_owned(), error)
    })
}
