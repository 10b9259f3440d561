//! Files that are whole or absent: written beside their final name, then renamed.

use crate::error::{CoreError, Result};
use std::fs::{self, File, OpenOptions};
use std::io::{BufWriter, ErrorKind, Read, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

/// Names tried for a temporary file before giving up: others hold one only when a process of the
/// same number died half way, or when someone plants them.
const NAME_TRIES: u32 = 256;

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
            let (temporary, file) = Temporary::beside(path)?;
            fill(path, file, write)?;
            written.push((temporary, *path));
        }
    }
    for (temporary, path) in written {
        fs::rename(&temporary.0, path).map_err(|error| CoreError::io(path, error))?;
    }
    Ok(())
}

/// Number in the next temporary name of this process.
static NEXT_NAME: AtomicU64 = AtomicU64::new(0);

/// A file that is removed when dropped, unless it was renamed away.
struct Temporary(PathBuf);

impl Temporary {
    /// A new file in the folder of `path`. Its name is short whatever `path` is called, and a file
    /// or link that already has it is neither opened nor followed.
    fn beside(path: &Path) -> Result<(Self, File)> {
        let mut tries = 1;
        loop {
            let number = NEXT_NAME.fetch_add(1, Ordering::Relaxed);
            let beside = path.with_file_name(temporary_name(number));
            match OpenOptions::new().write(true).create_new(true).open(&beside) {
                Ok(file) => return Ok((Self(beside), file)),
                Err(error) if error.kind() == ErrorKind::AlreadyExists && tries < NAME_TRIES => {
                    tries += 1;
                }
                Err(error) => return Err(CoreError::io(path, error)),
            }
        }
    }
}

fn temporary_name(number: u64) -> String {
    format!(".tree-{}-{number}.tmp", std::process::id())
}

/// Writes `file`, which will become `path`, down to the disk.
fn fill<E: From<CoreError>>(
    path: &Path,
    file: File,
    write: impl FnOnce(&mut dyn Write) -> std::result::Result<(), E>,
) -> std::result::Result<(), E> {
    let io = |error| CoreError::io(path, error);
    let mut writer = BufWriter::new(file);
    write(&mut writer)?;
    let file = writer.into_inner().map_err(|error| io(error.into_error()))?;
    file.sync_all().map_err(io)?;
    Ok(())
}

impl Drop for Temporary {
    fn drop(&mut self) {
        // Gone already when the rename succeeded; nothing can be done here if removal fails.
        let _ = fs::remove_file(&self.0);
    }
}

/// Reads a file whose size is within [`Limits::input_bytes`](crate::Limits::input_bytes).
///
/// # Errors
/// [`CoreError::Io`] or [`CoreError::Limit`], the latter having read no more than one byte over the
/// limit, even from a pipe or device whose size nobody knows.
pub fn read_bytes(path: &Path, limits: &crate::Limits) -> Result<Vec<u8>> {
    let io = |error| CoreError::io(path, error);
    let file = File::open(path).map_err(io)?;
    let cap = limits.input_bytes;
    limits.check(crate::Resource::InputBytes, file.metadata().map_err(io)?.len())?;
    let mut bytes = Vec::new();
    file.take(cap.saturating_add(1)).read_to_end(&mut bytes).map_err(io)?;
    limits.check(crate::Resource::InputBytes, bytes.len() as u64)?;
    Ok(bytes)
}

/// Reads a text file as [`read_bytes`] does. Bytes that are no UTF-8 (comments in an old encoding)
/// become U+FFFD.
///
/// # Errors
/// As [`read_bytes`].
pub fn read_text(path: &Path, limits: &crate::Limits) -> Result<String> {
    Ok(String::from_utf8_lossy(&read_bytes(path, limits)?).into_owned())
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

    #[cfg(unix)]
    #[test]
    fn a_source_without_end_is_read_only_up_to_the_limit() {
        let limits = crate::Limits { input_bytes: 1000, ..Default::default() };
        let error = read_bytes(Path::new("/dev/zero"), &limits).unwrap_err();
        assert!(matches!(error, CoreError::Limit(limit) if limit.requested == 1001), "{error}");
    }

    #[test]
    fn a_name_of_255_bytes_can_be_written() {
        let folder = folder("long");
        let name = "n".repeat(255);
        write_atomic::<CoreError>(&folder.join(&name), |_| Ok(())).unwrap();
        assert_eq!(names(&folder), [name]);
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn planted_temporary_names_are_passed_over_and_links_not_followed() {
        let (folder, victim) = (folder("planted"), folder("victim").join("v"));
        fs::write(&victim, "mine").unwrap();
        let start = NEXT_NAME.load(Ordering::Relaxed);
        let plant: Vec<_> =
            (start..start + 64).map(|number| folder.join(temporary_name(number))).collect();
        for path in &plant {
            #[cfg(unix)]
            std::os::unix::fs::symlink(&victim, path).unwrap();
            #[cfg(not(unix))]
            fs::write(path, "mine").unwrap();
        }
        let write = |path: &Path| {
            write_atomic(path, |out| out.write_all(b"new").map_err(|e| CoreError::io("a", e)))
        };
        write(&folder.join("a")).unwrap();
        assert_eq!(fs::read_to_string(folder.join("a")).unwrap(), "new");
        for path in plant.iter().chain([&victim]) {
            assert_eq!(fs::read_to_string(path).unwrap(), "mine");
        }
        assert_eq!(names(&folder).len(), plant.len() + 1);
        fs::remove_dir_all(folder).unwrap();
        fs::remove_dir_all(victim.parent().unwrap()).unwrap();
    }

    #[test]
    fn a_missing_folder_is_an_error_that_names_the_file() {
        let path = Path::new("/no/such/folder/tree.glb");
        let error = write_atomic::<CoreError>(path, |_| Ok(())).unwrap_err();
        assert!(error.to_string().contains("/no/such/folder/tree.glb"), "{error}");
    }
}
