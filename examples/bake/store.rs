//! The folder of a tree: files that are whole or absent, and a report that is written last.

use crate::grow::BakeError;
use serde_json::{Map, Value, json};
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};
use tree_core::{CoreError, Limits, file};

/// Name of the report in a tree's folder: the tree is finished when it is there and tells of the same line.
pub(crate) const REPORT: &str = "report.json";
/// From this age on a temporary file is what a killed run has left: no file takes so long to write.
const ABANDONED: Duration = Duration::from_secs(3600);

/// Where a tree's files go.
pub(crate) struct Folder {
    path: PathBuf,
    name: String,
    /// Bytes of each file that was written.
    files: Map<String, Value>,
}

impl Folder {
    pub(crate) fn new(out: &Path, name: &str) -> Self {
        Self { path: out.join(name), name: name.into(), files: Map::new() }
    }

    /// Whether the report tells of this fingerprint and every file is there in full.
    pub(crate) fn is_finished(&self, fingerprint: &str) -> bool {
        let Some(report) = self.report() else { return false };
        let Some(files) = report.get("files").and_then(Value::as_object) else { return false };
        let whole = |(file, bytes): (&String, &Value)| {
            let there = fs::metadata(self.path.join(file))
                .is_ok_and(|meta| meta.is_file() && Some(meta.len()) == bytes.as_u64());
            is_plain(file) && there
        };
        report.get("fingerprint").and_then(Value::as_str) == Some(fingerprint)
            && !files.is_empty()
            && files.iter().all(whole)
    }

    /// Makes the folder, and takes away what an earlier line of this name and killed runs have left. The report goes first: a
    /// folder with a report has the files of that report, and none of another line.
    pub(crate) fn begin(&mut self) -> Result<(), BakeError> {
        let io = |path: &Path, error| CoreError::io(path, error);
        fs::create_dir_all(&self.path).map_err(|error| io(&self.path, error))?;
        if let Some(report) = self.report() {
            self.remove(REPORT)?;
            let old = report.get("files").and_then(Value::as_object);
            for file in old.into_iter().flat_map(Map::keys).filter(|file| is_plain(file)) {
                self.remove(file)?;
            }
        }
        for entry in fs::read_dir(&self.path).map_err(|error| io(&self.path, error))?.flatten() {
            let name = entry.file_name().to_string_lossy().into_owned();
            let age = entry.metadata().and_then(|meta| meta.modified()).ok();
            let age = age.and_then(|written| SystemTime::now().duration_since(written).ok());
            let ours = name.starts_with(".tree-") && name.ends_with(".tmp");
            if ours && age.is_some_and(|age| age > ABANDONED) {
                self.remove(&name)?;
            }
        }
        Ok(())
    }

    /// Takes the folder away where nothing was written to it.
    pub(crate) fn abandon(&self) {
        // One that is not empty stays, and says so by failing.
        drop(fs::remove_dir(&self.path));
    }

    /// Writes the file `NAME` + `tail`.
    pub(crate) fn put(&mut self, tail: &str, bytes: &[u8]) -> Result<(), BakeError> {
        let file = format!("{}{tail}", self.name);
        self.write(&file, bytes)?;
        self.files.insert(file, bytes.len().into());
        Ok(())
    }

    /// Writes the report: from now on the tree is finished.
    pub(crate) fn finish(
        &self,
        fingerprint: &str,
        mut report: Map<String, Value>,
    ) -> Result<(), BakeError> {
        report.insert("name".into(), json!(self.name));
        report.insert("fingerprint".into(), json!(fingerprint));
        report.insert("files".into(), Value::Object(self.files.clone()));
        let sum = self.files.values().filter_map(Value::as_u64).sum::<u64>();
        report.insert("bytes".into(), json!(sum));
        self.write(REPORT, format!("{:#}\n", Value::Object(report)).as_bytes())
    }

    fn report(&self) -> Option<Value> {
        let text = file::read_text(&self.path.join(REPORT), &Limits::default()).ok()?;
        serde_json::from_str(&text).ok()
    }

    fn write(&self, name: &str, bytes: &[u8]) -> Result<(), BakeError> {
        let path = self.path.join(name);
        Ok(file::write_atomic(&path, |out| {
            out.write_all(bytes).map_err(|error| CoreError::io(&path, error))
        })?)
    }

    fn remove(&self, name: &str) -> Result<(), BakeError> {
        let path = self.path.join(name);
        match fs::remove_file(&path) {
            Err(error) if error.kind() != std::io::ErrorKind::NotFound => {
                Err(CoreError::io(path, error).into())
            }
            _ => Ok(()),
        }
    }
}

/// A name in the folder and nowhere else, whoever wrote the report.
fn is_plain(name: &str) -> bool {
    Path::new(name).file_name().is_some_and(|file| file == name)
}
