//! A reader that ends a file without end.

use std::io::{self, Read};

/// MiB of a whole file, some ten million rows; a pipe may never end.
const LARGEST_FILE: u64 = 512;
/// MiB of one row: what a run with 50,000 bodies writes.
const LONGEST_ROW: u64 = 16;
const MIB: u64 = 1024 * 1024;

/// Reads a table of numbers as text, up to the largest size of a file and of a row; beyond, [`Read::read`] fails with
/// [`io::ErrorKind::Other`] and says so.
pub struct LimitedReader<R> {
    inner: R,
    largest_file: u64,
    longest_row: u64,
    n_read: u64,
    /// Bytes since the last end of a row.
    of_row: u64,
}

impl<R: Read> LimitedReader<R> {
    /// `inner`, up to 512 MiB, with rows of up to 16 MiB.
    pub fn new(inner: R) -> Self {
        Self { inner, largest_file: LARGEST_FILE * MIB, longest_row: LONGEST_ROW * MIB, n_read: 0, of_row: 0 }
    }
}

impl<R: Read> Read for LimitedReader<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let n = self.inner.read(buffer)?;
        self.n_read += n as u64;
        for row in buffer[..n].split_inclusive(|byte| *byte == b'\n') {
            self.of_row += row.len() as u64;
            if self.of_row > self.longest_row {
                let most = self.longest_row / MIB;
                return Err(io::Error::other(format!("a row is longer than {most} MiB; this is no table of inputs")));
            }
            if row.ends_with(b"\n") {
                self.of_row = 0;
            }
        }
        if self.n_read > self.largest_file {
            let most = self.largest_file / MIB;
            return Err(io::Error::other(format!("it is longer than {most} MiB; give fewer rows, further apart")));
        }
        Ok(n)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is read of an endless repetition of `text`, and why reading ends.
    fn read_endless(text: &'static [u8]) -> (u64, String) {
        struct Endless(&'static [u8], usize);
        impl Read for Endless {
            fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
                for byte in buffer.iter_mut() {
                    *byte = self.0[self.1 % self.0.len()];
                    self.1 += 1;
                }
                Ok(buffer.len())
            }
        }
        let mut reader = LimitedReader { largest_file: 8 * MIB, ..LimitedReader::new(Endless(text, 0)) };
        let (mut buffer, mut n_read) = (vec![0; 1 << 16], 0);
        loop {
            match reader.read(&mut buffer) {
                Ok(n) => n_read += n as u64,
                Err(error) => return (n_read, error.to_string()),
            }
        }
    }

    #[test]
    fn invariant_row_without_end_is_refused() {
        let (n_read, why) = read_endless(b"\0");
        assert!(n_read <= 8 * MIB && why.contains("8 MiB"), "the file ends before the row: {n_read}: {why}");
        let mut reader = LimitedReader { longest_row: MIB, ..LimitedReader::new(std::io::repeat(0).take(2 * MIB)) };
        let why = reader.read_to_end(&mut Vec::new()).unwrap_err().to_string();
        assert!(why.contains("a row is longer than 1 MiB"), "{why}");
    }

    #[test]
    fn invariant_file_without_end_is_refused() {
        let (n_read, why) = read_endless(b"0,0.123456789012345,0.123456789012345,0.123456789012345\n");
        assert!(n_read <= 8 * MIB && why.contains("longer than 8 MiB"), "{n_read}: {why}");
    }

    #[test]
    fn invariant_rows_up_to_the_longest_are_read() {
        let mut row = vec![b'0'; (LONGEST_ROW * MIB - 1) as usize];
        row.push(b'\n');
        let text = row.repeat(3);
        let mut found = Vec::new();
        LimitedReader::new(&text[..]).read_to_end(&mut found).unwrap();
        assert_eq!(found, text);
    }
}
