//! Thumbnails: pictures rendered one after another for a contact sheet.
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use raggio::image::{Bitmap, EncodeOptions, develop};
use raggio::{RenderOptions, SceneOptions};

use crate::progress::Progress;
use crate::report::Report;
use crate::{Outcome, pipeline, sheet};

/// The pictures so far.
pub(crate) struct Thumbnails<'a> {
    report: &'a Report,
    cancel: &'a Arc<AtomicBool>,
    cells: Vec<(String, Bitmap)>,
    /// Whether the last one was interrupted; no more are needed then.
    pub cancelled: bool,
}

impl<'a> Thumbnails<'a> {
    pub(crate) fn new(report: &'a Report, cancel: &'a Arc<AtomicBool>) -> Self {
        Thumbnails { report, cancel, cells: Vec::new(), cancelled: false }
    }

    /// Renders one more. `Err` without a message: the diagnostics have been shown already.
    pub(crate) fn add(
        &mut self,
        label: String,
        scene: &SceneOptions,
        options: &RenderOptions,
    ) -> Result<(), Option<String>> {
        let ready = match pipeline::prepare(scene, &mut |text| self.report.debug(text), self.cancel) {
            Ok(ready) => ready,
            Err(failure) => {
                self.report.failure(&failure);
                return Err(None);
            }
        };
        // The pictures are variations of one scene: what it is warned of is worth saying once.
        if self.cells.is_empty() {
            self.report.diagnostics(&ready.loaded.warnings, &ready.loaded.sources);
        }
        let film = {
            let progress = Progress::new(&label, self.report.human());
            ready.world.render(options, self.cancel, &|done, all| progress.set(done, all))
        };
        self.cancelled = film.cancelled;
        let encode = pipeline::encode_options(&ready.loaded, EncodeOptions::default());
        self.cells.push((label, develop(&pipeline::picture(film), &encode)));
        Ok(())
    }

    /// Writes the sheet as a PNG.
    pub(crate) fn write(self, output: &Path) -> Result<Outcome, Option<String>> {
        let failed = |e: String| Some(format!("cannot write {}: {e}", output.display()));
        let mut png = Vec::new();
        raggio::image::write_png(&sheet::sheet(&self.cells), 1, &mut png)
            .map_err(|e| failed(e.to_string()))?;
        raggio::write_whole(output, &png).map_err(|e| failed(e.to_string()))?;
        if self.cancelled {
            self.report.say("warning", &format!("interrupted; {} holds what was there", output.display()));
            return Ok(Outcome::Interrupted);
        }
        Ok(Outcome::Done)
    }
}
