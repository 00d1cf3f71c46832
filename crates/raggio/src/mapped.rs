//! Large files as memory: mapped instead of read, which spares a copy of the whole.
#![allow(unsafe_code)]
use std::fs::File;
use std::io;
use std::ops::Deref;
use std::path::Path;

use memmap2::Mmap;

/// Smaller files are read.
const LEAST: u64 = 1 << 20;

/// The bytes of a file.
pub(crate) enum Bytes {
    Read(Vec<u8>),
    Mapped(Mmap),
}

impl Deref for Bytes {
    type Target = [u8];

    fn deref(&self) -> &[u8] {
        match self {
            Bytes::Read(bytes) => bytes,
            Bytes::Mapped(map) => map,
        }
    }
}

/// Reads or maps a file. While another program shortens a mapped file the system may end this one, and what it writes
/// there may be seen in part: as with a file that is read while it is written, but for longer.
pub(crate) fn open(path: &Path) -> io::Result<Bytes> {
    let file = File::open(path)?;
    let about = file.metadata()?;
    if about.is_file() && about.len() >= LEAST {
        // SAFETY: nothing here writes to the file. Readers of models take each number out of the bytes once and check
        // it where they keep it, so that bytes which change under them can make a wrong model, but no wrong index.
        if let Ok(map) = unsafe { Mmap::map(&file) } {
            return Ok(Bytes::Mapped(map));
        }
    }
    std::fs::read(path).map(Bytes::Read)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_of_all_sizes_are_the_same_as_read() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("a");
        for length in [0, 10, LEAST as usize - 1, LEAST as usize, LEAST as usize + 5000] {
            let bytes: Vec<u8> = (0..length).map(|i| (i * i / 7) as u8).collect();
            std::fs::write(&path, &bytes).expect("written");
            let opened = open(&path).expect("opened");
            assert_eq!(matches!(opened, Bytes::Mapped(_)), length as u64 >= LEAST);
            assert!(*opened == bytes[..]);
        }
        assert!(open(folder.path()).is_err());
        assert!(open(&folder.path().join("none")).is_err());
    }
}
