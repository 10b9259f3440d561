//! Files that are whole or absent: written beside their final name, then renamed.

use crate::error::{CoreError, Result};
use std::fs::{self, File};
use std::io::{BufWriter, Read, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

/// Writes a file so that a reader sees the old one or the whole new one, never a part.
///
/// `write` fills a temporary file in the same folder, which is flushed to disk and then renamed
/// over `path`. When anything fails, the temporary file is removed and `path` is as it was.
///
/// # Errors
/// [`CoreError::Io`] with the path, or what `write` returned.
pub fn write_atomic<E: From<CoreError>>(
    path: &Path,
    write: impl FnOnce(&mut dyn Write) -> std::result::Result<(), E>,
) -> std::result::Result<(), E> {
    write_all_atomic(&mut [(path, Some(Box::new(write)))])
}

/// One file of a group: where it goes and what fills it.
pub type Part<'a, E> =
    (&'a Path, Option<Box<dyn FnOnce(&mut dyn Write) -> std::result::Result<(), E> + 'a>>);

/// Writes files that belong together (an OBJ with its materials and textures): none is renamed
/// before all are written.
///
/// # Errors
/// As [`write_atomic`]; no file is touched unless all could be written. A rename that fails half
/// way (a folder that vanishes) leaves whole files only.
pub fn write_all_atomic<E: From<CoreError>>(
    parts: &mut [Part<'_, E>],
) -> std::result::Result<(), E> {
    let mut written = Vec::with_capacity(parts.len());
    for (path, write) in parts {
        if let Some(write) = write.take() {
            let temporary = Temporary::beside(path);
            temporary.fill(write)?;
            written.push((temporary, *path));
        }
    }
    for (temporary, path) in written {
        fs::rename(&temporary.0, path).map_err(|error| CoreError::io(path, error))?;
    }
    Ok(())
}

/// A file that is removed when dropped, unless it was renamed away.
struct Temporary(PathBuf);

impl Temporary {
    fn beside(path: &Path) -> Self {
        static COUNTER: AtomicU64 = AtomicU64::new(0);
        let mut name = path.file_name().unwrap_or_default().to_os_string();
        let number = COUNTER.fetch_add(1, Ordering::Relaxed);
        name.push(format!(".{}-{number}.tmp", std::process::id()));
        Self(path.with_file_name(name))
    }

    fn fill<E: From<CoreError>>(
        &self,
        write: impl FnOnce(&mut dyn Write) -> std::result::Result<(), E>,
    ) -> std::result::Result<(), E> {
        let io = |error| CoreError::io(&self.0, error);
        let mut writer = BufWriter::new(File::create(&self.0).map_err(io)?);
        write(&mut writer)?;
        let file = writer.into_inner().map_err(|error| io(error.into_error()))?;
        file.sync_all().map_err(io)?;
        Ok(())
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        // Gone already when the rename succeeded; nothing can be done here if removal fails.
        let _ = fs::remove_file(&self.0);
    }
}

/// Reads a text file whose size is within [`Limits::input_bytes`](crate::Limits::input_bytes).
/// Bytes that are no UTF-8 (comments in an old encoding) become U+FFFD.
///
/// # Errors
/// [`CoreError::Io`] or [`CoreError::Limit`], the latter having read no more than the limit, even
/// from a pipe whose size nobody knows.
pub fn read_text(path: &Path, limits: &crate::Limits) -> Result<String> {
    let io = |error| CoreError::io(path, error);
    let file = File::open(path).map_err(io)?;
    let cap = limits.input_bytes;
    limits.check(crate::Resource::InputBytes, file.metadata().map_err(io)?.len())?;
    let mut bytes = Vec::new();
    file.take(cap.saturating_add(1)).read_to_end(&mut bytes).map_err(io)?;
    limits.check(crate::Resource::InputBytes, bytes.len() as u64)?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn folder(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("tree-core-{}-{name}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        folder
    }

    fn names(folder: &Path) -> Vec<String> {
        let mut names: Vec<_> = fs::read_dir(folder)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }

    #[test]
    fn a_failed_write_keeps_the_old_file_and_leaves_nothing_else() {
        let folder = folder("failed");
        let path = folder.join("a.txt");
        fs::write(&path, "old").unwrap();
        let result = write_atomic(&path, |out| {
            out.write_all(b"half of the n").map_err(|e| CoreError::io("a", e))?;
            Err(CoreError::Empty { what: "test" })
        });
        assert!(matches!(result, Err(CoreError::Empty { what: "test" })));
        assert_eq!(fs::read_to_string(&path).unwrap(), "old");
        assert_eq!(names(&folder), ["a.txt"]);
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn a_group_is_written_whole_or_not_at_all() {
        let folder = folder("group");
        let (a, b) = (folder.join("a"), folder.join("b"));
        let mut fail: [Part<'_, CoreError>; 2] = [
            (&a, Some(Box::new(|out| out.write_all(b"1").map_err(|e| CoreError::io("a", e))))),
            (&b, Some(Box::new(|_| Err(CoreError::NoRoot)))),
        ];
        assert!(write_all_atomic(&mut fail).is_err());
        assert!(names(&folder).is_empty());
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn a_file_over_the_limit_is_refused_and_odd_bytes_are_replaced() {
        let folder = folder("read");
        let path = folder.join("latin1.txt");
        fs::write(&path, b"ch\xeane").unwrap();
        assert_eq!(read_text(&path, &crate::Limits::default()).unwrap(), "ch\u{fffd}ne");
        let limits = crate::Limits { input_bytes: 4, ..Default::default() };
        assert!(matches!(read_text(&path, &limits), Err(CoreError::Limit(_))));
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn a_missing_folder_is_an_error_that_names_the_file() {
        let path = Path::new("/no/such/folder/tree.glb");
        let error = write_atomic::<CoreError>(path, |_| Ok(())).unwrap_err();
        assert!(error.to_string().contains("/no/such/folder/tree.glb"), "{error}");
    }
}
