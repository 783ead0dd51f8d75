//! One file.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, ErrorKind, Seek as _, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// A file that replaces an older one when it is complete.
///
/// It is written beside as `NAME.partial` and renamed by [`OutputFile::complete`]. A program that is killed leaves the older
/// file as it was, and what it wrote in `NAME.partial`. Such a leftover is overwritten by the next writer. While one
/// writer has the file, others are refused. A pipe or a device is written directly.
#[derive(Debug)]
pub struct OutputFile {
    path: PathBuf,
    partial: PathBuf,
    file: File,
    state: State,
}

/// What has been done with the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum State {
    /// Written directly, never renamed.
    Direct,
    /// Nothing was written. `is_new`: `NAME.partial` was made for this.
    Unwritten { is_new: bool },
    /// Something was written.
    Written,
    /// It has its name.
    Complete,
}

impl OutputFile {
    /// Opens `NAME.partial` beside `path` and keeps other writers out. The older file, and an older `NAME.partial` until the
    /// first byte is written, stay as they are.
    ///
    /// # Errors
    /// The error of the system; [`ErrorKind::ResourceBusy`] when another writer has the file.
    pub fn create(path: &Path) -> io::Result<Self> {
        let target = resolved(path);
        // an older file that may not be written is not replaced either
        if let Some(file) = opened(path)?
            && !file.metadata()?.is_file()
        {
            return Ok(Self { partial: path.to_owned(), path: path.to_owned(), file, state: State::Direct });
        }
        let open = || io::Error::new(ErrorKind::InvalidInput, "it stands for a file that is open already");
        let path = target.ok_or_else(open)?;
        let name =
            path.file_name().ok_or_else(|| io::Error::new(ErrorKind::InvalidInput, "this is no name of a file"))?;
        let mut partial_name = name.to_owned();
        partial_name.push(".partial");
        let partial = path.with_file_name(partial_name);
        let (file, is_new) = locked(&partial)?;
        Ok(Self { path, partial, file, state: State::Unwritten { is_new } })
    }

    /// As [`OutputFile::create`], but goes on behind the first bytes of an older `NAME.partial`: `keep` is handed all of them, and says how
    /// many are good. A pipe or a device is written from its start.
    ///
    /// # Errors
    /// Those of [`OutputFile::create`].
    pub fn resume(path: &Path, keep: impl FnOnce(&[u8]) -> usize) -> io::Result<Self> {
        let mut of = Self::create(path)?;
        if let State::Unwritten { is_new: false } = of.state {
            let n_kept = keep(&fs::read(&of.partial)?) as u64;
            of.file.set_len(n_kept)?;
            of.file.seek(SeekFrom::End(0))?;
            of.state = State::Written;
        }
        Ok(of)
    }

    /// Writes `bytes` over the first ones of the file; later writes go on behind its last. Not for a pipe or a device.
    ///
    /// # Errors
    /// The error of the system.
    pub fn write_over_start(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.file.rewind()?;
        self.file.write_all(bytes)?;
        self.file.seek(SeekFrom::End(0)).map(|_| ())
    }

    /// Gives the file its name. A file to which nothing was written becomes an empty one.
    ///
    /// # Errors
    /// The error of the system; the older file is then as it was.
    pub fn complete(mut self) -> io::Result<()> {
        if self.state == State::Direct {
            return self.file.flush();
        }
        self.begin()?;
        if let Ok(older) = fs::metadata(&self.path) {
            self.file.set_permissions(older.permissions())?;
        }
        // some systems find a full disk no earlier; and a name must not stand before its content
        self.file.sync_all()?;
        fs::rename(&self.partial, &self.path)?;
        self.state = State::Complete;
        Ok(())
    }

    /// Where the file is until it is complete, `NAME.partial`; `None` for a pipe or a device.
    pub fn partial(&self) -> Option<&Path> {
        (self.state != State::Direct).then_some(&self.partial)
    }

    /// Empties a leftover before the first byte.
    fn begin(&mut self) -> io::Result<()> {
        if matches!(self.state, State::Unwritten { .. }) {
            self.file.set_len(0)?;
            self.state = State::Written;
        }
        Ok(())
    }
}

impl Write for OutputFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.begin()?;
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

impl Drop for OutputFile {
    fn drop(&mut self) {
        if self.state == (State::Unwritten { is_new: true }) {
            // a leftover empty file is no reason to fail
            _ = fs::remove_file(&self.partial);
        }
    }
}

/// Writes a whole file as [`OutputFile`] does.
///
/// # Errors
/// Those of [`OutputFile`].
pub fn write(path: &Path, bytes: impl AsRef<[u8]>) -> io::Result<()> {
    let mut file = OutputFile::create(path)?;
    file.write_all(bytes.as_ref())?;
    file.complete()
}

/// Symbolic links that are followed at most, as many as Linux follows.
const MAX_LINKS: usize = 40;

/// Where the links of `path` lead to: they stay when the file is replaced. None for what a process has open, such as
/// `/dev/stdout`: it may be a pipe, but not a file, in which rows and other output would overwrite each other.
fn resolved(path: &Path) -> Option<PathBuf> {
    let mut path = path.to_owned();
    for _ in 0..MAX_LINKS {
        if path.starts_with("/dev/fd") || path.starts_with("/proc") {
            return None;
        }
        match fs::read_link(&path) {
            Ok(to) => path = path.parent().unwrap_or(Path::new("")).join(to),
            Err(_) => break,
        }
    }
    Some(path)
}

/// The file that is there, opened for writing; `None` when there is none.
fn opened(path: &Path) -> io::Result<Option<File>> {
    match OpenOptions::new().append(true).open(path) {
        Ok(file) => Ok(Some(file)),
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
        Err(error) => Err(error),
    }
}

/// Opens and locks a file, and tells whether it was made here.
fn locked(partial: &Path) -> io::Result<(File, bool)> {
    loop {
        let is_new = match fs::symlink_metadata(partial) {
            Ok(there) if there.is_file() => false,
            // a link would lead the writer elsewhere, a pipe would hold it
            Ok(_) => {
                let what =
                    format!("`{}` is in the way and no file: remove it, or give another name", partial.display());
                return Err(io::Error::new(ErrorKind::AlreadyExists, what));
            }
            Err(_) => true,
        };
        let file = OpenOptions::new().write(true).create(true).truncate(false).open(partial)?;
        if takes(&file, partial)? {
            return Ok((file, is_new));
        }
    }
}

/// Locks a file that was opened at `partial`. False when the writer before gave it its name in between.
fn takes(file: &File, partial: &Path) -> io::Result<bool> {
    match file.try_lock() {
        Ok(()) => is_at(file, partial),
        Err(TryLockError::WouldBlock) => {
            let what = format!("another program is writing `{}`", partial.display());
            Err(io::Error::new(ErrorKind::ResourceBusy, what))
        }
        // a file system without locks
        Err(TryLockError::Error(_)) => Ok(true),
    }
}

/// Whether `file`, which is locked here, is the one at `path`.
#[cfg(unix)]
fn is_at(file: &File, path: &Path) -> io::Result<bool> {
    use std::os::unix::fs::MetadataExt as _;
    let here = file.metadata()?;
    Ok(fs::symlink_metadata(path).is_ok_and(|there| (there.dev(), there.ino()) == (here.dev(), here.ino())))
}

/// Whether `file`, which is locked here, is the one at `path`: then another handle cannot lock it.
#[cfg(not(unix))]
fn is_at(_: &File, path: &Path) -> io::Result<bool> {
    match OpenOptions::new().write(true).open(path) {
        Ok(other) => Ok(matches!(other.try_lock(), Err(TryLockError::WouldBlock))),
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(false),
        Err(error) => Err(error),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A fresh folder for one test.
    fn folder(name: &str) -> PathBuf {
        let path = std::env::temp_dir().join(format!("ezy-output-{name}-{}", std::process::id()));
        _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).unwrap();
        path
    }

    fn read(path: &Path) -> String {
        fs::read_to_string(path).unwrap()
    }

    #[test]
    fn invariant_file_takes_its_place_when_it_is_complete() {
        let folder = folder("complete");
        let (path, partial) = (folder.join("a.csv"), folder.join("a.csv.partial"));
        fs::write(&path, "old").unwrap();
        fs::write(&partial, "left by a program that was killed").unwrap();
        let mut file = OutputFile::create(&path).unwrap();
        assert_eq!(fs::metadata(&partial).unwrap().len(), 33);
        file.write_all(b"new").unwrap();
        assert_eq!((read(&path), fs::metadata(&partial).unwrap().len()), ("old".into(), 3));
        file.complete().unwrap();
        assert_eq!((read(&path), partial.exists()), ("new".into(), false));
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn invariant_file_that_is_dropped_leaves_what_was_written_beside_the_older_one() {
        let folder = folder("dropped");
        let (path, partial) = (folder.join("a.csv"), folder.join("a.csv.partial"));
        drop(OutputFile::create(&path).unwrap());
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 0);
        fs::write(&path, "old").unwrap();
        OutputFile::create(&path).unwrap().write_all(b"new").unwrap();
        assert_eq!((read(&path), read(&partial)), ("old".into(), "new".into()));
        drop(OutputFile::create(&path).unwrap());
        assert_eq!(read(&partial), "new");
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn invariant_resumed_file_goes_on_behind_what_is_good() {
        let folder = folder("resumed");
        let path = folder.join("a.csv");
        let mut nothing = OutputFile::resume(&path, |_| panic!("there is nothing to keep")).unwrap();
        nothing.write_all(b"1\n2\n3").unwrap();
        drop(nothing);
        let mut file = OutputFile::resume(&path, |bytes| {
            assert_eq!(bytes, b"1\n2\n3");
            4
        })
        .unwrap();
        assert_eq!(OutputFile::resume(&path, <[u8]>::len).unwrap_err().kind(), ErrorKind::ResourceBusy);
        file.write_all(b"4\n").unwrap();
        file.complete().unwrap();
        assert_eq!(read(&path), "1\n2\n4\n");
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn invariant_second_writer_is_refused_as_long_as_there_is_a_first() {
        let folder = folder("second");
        let path = folder.join("a.csv");
        let first = OutputFile::create(&path).unwrap();
        let refused = OutputFile::create(&path).unwrap_err();
        assert_eq!(refused.kind(), ErrorKind::ResourceBusy);
        assert!(refused.to_string().contains("a.csv.partial"), "{refused}");
        first.complete().unwrap();
        write(&path, "second").unwrap();
        assert_eq!(read(&path), "second");
        fs::remove_dir_all(folder).unwrap();
    }

    /// A second writer opens the file before the first one completes it, and locks it afterwards: it would write into the complete file.
    #[test]
    fn invariant_file_that_got_its_name_before_it_was_locked_is_not_taken() {
        let folder = folder("renamed");
        let (path, partial) = (folder.join("a.csv"), folder.join("a.csv.partial"));
        let mut first = OutputFile::create(&path).unwrap();
        let second = OpenOptions::new().write(true).open(&partial).unwrap();
        assert_eq!(takes(&second, &partial).unwrap_err().kind(), ErrorKind::ResourceBusy);
        first.write_all(b"first").unwrap();
        first.complete().unwrap();
        assert!(!takes(&second, &partial).unwrap());
        drop(second);
        // another one in its place is none of it either
        let third = OpenOptions::new().write(true).open(&path).unwrap();
        fs::write(&partial, "another").unwrap();
        assert!(!takes(&third, &partial).unwrap());
        fs::remove_dir_all(folder).unwrap();
    }

    /// Many writers at once: each is refused, or gives the file its own text whole.
    #[test]
    fn invariant_file_of_many_writers_is_that_of_one() {
        const N_WRITERS: usize = 8;
        const N_ROUNDS: usize = 50;
        let folder = folder("many");
        let path = folder.join("a.csv");
        let text = |i: usize| format!("{i}").repeat(10_000 + i);
        std::thread::scope(|scope| {
            for i in 0..N_WRITERS {
                let path = &path;
                scope.spawn(move || {
                    for _ in 0..N_ROUNDS {
                        match write(path, text(i)) {
                            Ok(()) => {}
                            Err(error) => assert_eq!(error.kind(), ErrorKind::ResourceBusy, "{error}"),
                        }
                        if let Ok(found) = fs::read_to_string(path) {
                            assert!((0..N_WRITERS).any(|i| found == text(i)), "{} bytes", found.len());
                        }
                    }
                });
            }
        });
        assert!(path.exists() && !folder.join("a.csv.partial").exists());
        fs::remove_dir_all(folder).unwrap();
    }

    #[cfg(unix)]
    #[test]
    fn invariant_link_stays_a_link_and_permissions_stay() {
        use std::os::unix::fs::PermissionsExt as _;
        let folder = folder("link");
        let (target, link) = (folder.join("target.csv"), folder.join("link.csv"));
        fs::write(&target, "old").unwrap();
        fs::set_permissions(&target, fs::Permissions::from_mode(0o640)).unwrap();
        std::os::unix::fs::symlink("target.csv", &link).unwrap();
        write(&link, "new").unwrap();
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!((read(&target), fs::metadata(&target).unwrap().permissions().mode() & 0o777), ("new".into(), 0o640));
        fs::remove_dir_all(folder).unwrap();
    }

    #[cfg(unix)]
    #[test]
    fn invariant_link_in_place_of_the_partial_file_is_not_followed() {
        let folder = folder("partial_link");
        let other = folder.join("other.txt");
        fs::write(&other, "of somebody else").unwrap();
        std::os::unix::fs::symlink("other.txt", folder.join("a.csv.partial")).unwrap();
        let refused = write(&folder.join("a.csv"), "new").unwrap_err();
        assert!(refused.to_string().contains("a.csv.partial` is in the way"), "{refused}");
        assert_eq!((read(&other), folder.join("a.csv").exists()), ("of somebody else".into(), false));
        fs::remove_dir_all(folder).unwrap();
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn invariant_device_is_written_directly() {
        write(Path::new("/dev/null"), "gone").unwrap();
        let full = write(Path::new("/dev/full"), "too much").unwrap_err();
        assert_eq!(full.kind(), ErrorKind::StorageFull);
        assert!(!Path::new("/dev/full.partial").exists());
    }
}
