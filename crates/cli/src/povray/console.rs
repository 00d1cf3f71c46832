//! Text streams: to the console, to files of their own, to one file for all.
use std::fs::File;
use std::io::Write;
use std::sync::Mutex;

use super::{Settings, StreamKind};

/// Streams as the settings want them. Messages of the same moment come out whole.
pub(super) struct Console {
    console: [bool; 6],
    files: Mutex<[Option<File>; 6]>,
}

impl Console {
    /// Opens the files. One that cannot be opened is reported and left out.
    pub(super) fn open(settings: &Settings) -> Console {
        let open = |name: &String| match File::create(name) {
            Ok(file) => Some(file),
            Err(error) => {
                eprintln!("povray: cannot open {name}: {error}");
                None
            }
        };
        let console = std::array::from_fn(|i| settings.streams[i].console);
        let files = std::array::from_fn(|i| settings.streams[i].file.as_ref().and_then(open));
        Console { console, files: Mutex::new(files) }
    }

    /// Says something that brings its own line end.
    pub(super) fn say(&self, stream: StreamKind, text: &str) {
        if self.console[stream as usize] {
            eprint!("{text}");
        }
        let Ok(mut files) = self.files.lock() else { return };
        for index in [stream as usize, StreamKind::All as usize] {
            if let Some(file) = &mut files[index] {
                // A full disk must not end a picture; the console has the message.
                let _ = file.write_all(text.as_bytes());
            }
        }
    }

    /// Says a whole line.
    pub(super) fn line(&self, stream: StreamKind, text: impl AsRef<str>) {
        self.say(stream, &format!("{}\n", text.as_ref()));
    }
}
