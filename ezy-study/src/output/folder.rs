//! A folder of files that belong together.

use std::fs::{self, File, TryLockError};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// A folder that one program at a time writes its results into.
#[derive(Debug)]
pub struct OutputFolder {
    path: PathBuf,
    is_new: bool,
    /// Locked as long as it is open; `None` on systems where a folder cannot be locked.
    _lock: Option<File>,
}

impl OutputFolder {
    /// Makes the folder when it is not there, and keeps other writers out where the system can lock a folder. Its files stay
    /// as they are.
    ///
    /// # Errors
    /// The error of the system; [`ErrorKind::ResourceBusy`] when another writer has the folder.
    pub fn create(path: &Path) -> io::Result<Self> {
        let is_new = !path.exists();
        fs::create_dir_all(path)?;
        let lock = match File::open(path) {
            Ok(folder) => match folder.try_lock() {
                Ok(()) => Some(folder),
                Err(TryLockError::WouldBlock) => {
                    return Err(io::Error::new(ErrorKind::ResourceBusy, "another program is writing into it"));
                }
                Err(TryLockError::Error(_)) => None,
            },
            Err(_) => None,
        };
        Ok(Self { path: path.to_owned(), is_new, _lock: lock })
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }
}

impl Drop for OutputFolder {
    /// Removes a folder that was made here and got no file.
    fn drop(&mut self) {
        if self.is_new {
            // a folder with files stays
            _ = fs::remove_dir(&self.path);
        }
    }
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[test]
    fn invariant_second_writer_into_a_folder_is_refused() {
        let path = std::env::temp_dir().join(format!("ezy-output-folder-{}", std::process::id()));
        let first = OutputFolder::create(&path).unwrap();
        assert_eq!(OutputFolder::create(&path).unwrap_err().kind(), ErrorKind::ResourceBusy);
        super::super::write(&first.path().join("a.csv"), "rows").unwrap();
        drop(first);
        drop(OutputFolder::create(&path).unwrap());
        fs::remove_dir_all(path).unwrap();
    }
}
