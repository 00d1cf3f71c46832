//! `gallery`: every pattern, finish or shape as a small labelled picture, all on one sheet.
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use raggio::{ParseOptions, RenderOptions, SceneOptions};

use crate::Outcome;
use crate::args::{GalleryArgs, GalleryKind};
use crate::commands::antialias;
use crate::pipeline;
use crate::report::Report;
use crate::thumbnails::Thumbnails;

/// The size of each picture when none is given.
const SIZE: (usize, usize) = (160, 120);

/// Stands in a stage for what is shown on it.
const SUBJECT: &str = "SUBJECT";

/// A scene with a gap, and what to put there for each picture.
struct Gallery {
    stage: &'static str,
    /// Label and scene text.
    subjects: Vec<(&'static str, &'static str)>,
}

/// A gallery's text is its stage, a line of three hyphens, then one `label: scene text` to a line.
fn gallery_of(kind: GalleryKind) -> Gallery {
    let text = match kind {
        GalleryKind::Patterns => include_str!("../gallery/patterns.txt"),
        GalleryKind::Finishes => include_str!("../gallery/finishes.txt"),
        GalleryKind::Shapes => include_str!("../gallery/shapes.txt"),
    };
    let (stage, subjects) = text.split_once("---\n").unwrap_or((text, ""));
    Gallery { stage, subjects: subjects.lines().filter_map(|line| line.split_once(": ")).collect() }
}

/// Renders the sheet.
pub(crate) fn gallery(args: &GalleryArgs, cancel: &Arc<AtomicBool>) -> Outcome {
    let report = Report::new(args.message_format);
    match try_gallery(args, &report, cancel) {
        Ok(outcome) => outcome,
        Err(message) => {
            message.iter().for_each(|m| report.say("error", m));
            Outcome::Failed
        }
    }
}

fn try_gallery(
    args: &GalleryArgs,
    report: &Report,
    cancel: &Arc<AtomicBool>,
) -> Result<Outcome, Option<String>> {
    let size = args.size.unwrap_or(SIZE);
    let options = RenderOptions {
        threads: args.threads,
        antialias: Some(antialias(args.antialias)),
        ..pipeline::render_options(size)
    };
    let Gallery { stage, subjects } = gallery_of(args.kind);
    let mut pictures = Thumbnails::new(report, cancel);
    for (label, subject) in subjects {
        let mut scene = SceneOptions::text(label, stage.replace(SUBJECT, subject).into_bytes());
        scene.installed_library = raggio::InstalledLibrary::Never;
        scene.parse = ParseOptions {
            image_width: size.0 as u32,
            image_height: size.1 as u32,
            ..ParseOptions::default()
        };
        pictures.add(label.to_owned(), &scene, &options)?;
        if pictures.cancelled {
            break;
        }
    }
    pictures.write(&args.output)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_subject_is_a_scene_without_faults() {
        let never = Arc::new(AtomicBool::new(false));
        for (kind, least) in
            [(GalleryKind::Patterns, 30), (GalleryKind::Finishes, 20), (GalleryKind::Shapes, 25)]
        {
            let Gallery { stage, subjects } = gallery_of(kind);
            assert!(subjects.len() >= least, "{}", subjects.len());
            assert_eq!(stage.matches(SUBJECT).count(), 1);
            for (label, subject) in subjects {
                let scene = SceneOptions::text(label, stage.replace(SUBJECT, subject).into_bytes());
                let ready = pipeline::prepare(&scene, &mut |_| {}, &never)
                    .unwrap_or_else(|failure| panic!("{label}: {}", failure.render()));
                assert!(ready.loaded.warnings.is_empty(), "{label}");
                assert_eq!(pipeline::left_out(&ready.loaded), None, "{label}");
            }
        }
    }
}
