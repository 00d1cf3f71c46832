//! `sweep`: one scene with several values of one setting, on one contact sheet.
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use raggio::{Declared, RenderOptions, SceneOptions};

use crate::args::{SceneArgs, SweepArgs};
use crate::commands::{antialias, scene_options};
use crate::report::Report;
use crate::thumbnails::Thumbnails;
use crate::{Outcome, pipeline};

/// The values to try, in order; at least one.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Sweep(pub Vec<f64>);

/// More pictures than this are a slip of the pen.
const MOST: usize = 256;

/// The size of each picture when none is given.
const SIZE: (usize, usize) = (320, 240);

/// `a..b` or `a..b:step`, both ends included.
pub(crate) fn range(text: &str) -> Result<Sweep, String> {
    let expected = || format!("a range like 0..7 or 0..1:0.25 is expected, not {text:?}");
    let number = |v: &str| v.trim().parse::<f64>().ok().filter(|v| v.is_finite()).ok_or_else(expected);
    let (ends, step) = match text.split_once(':') {
        Some((ends, step)) => (ends, number(step)?.abs()),
        None => (text, 1.0),
    };
    let (from, to) = ends.split_once("..").ok_or_else(expected)?;
    let (from, to) = (number(from)?, number(to)?);
    // A hair more than the quotient, so that 0..1:0.1 ends at 1.
    let steps = ((to - from).abs() / step + 1e-9).floor();
    if !(0.0..MOST as f64).contains(&steps) {
        return Err(format!("{text} would be more than {MOST} pictures"));
    }
    let step = if to < from { -step } else { step };
    Ok(Sweep((0..=steps as usize).map(|i| from + step * i as f64).collect()))
}

/// `NAME=range`.
pub(crate) fn named_range(text: &str) -> Result<(String, Sweep), String> {
    let (name, values) = text.split_once('=').ok_or("NAME=RANGE is expected")?;
    Ok((name.trim().to_owned(), range(values)?))
}

/// Renders the sheet.
pub(crate) fn sweep(args: &SweepArgs, cancel: &Arc<AtomicBool>) -> Outcome {
    let report = Report::new(args.message_format);
    match try_sweep(args, &report, cancel) {
        Ok(outcome) => outcome,
        Err(message) => {
            message.iter().for_each(|m| report.say("error", m));
            Outcome::Failed
        }
    }
}

fn try_sweep(args: &SweepArgs, report: &Report, cancel: &Arc<AtomicBool>) -> Result<Outcome, Option<String>> {
    let (name, values) = variation(args);
    let mut pictures = Thumbnails::new(report, cancel);
    for &value in values {
        let (scene, options) = settings(args, value).map_err(Some)?;
        pictures.add(format!("{name}={value}"), &scene, &options)?;
        if pictures.cancelled {
            break;
        }
    }
    pictures.write(&args.output)
}

/// What is varied, and its values.
fn variation(args: &SweepArgs) -> (&str, &[f64]) {
    let choice = &args.sweep;
    match (&choice.max_depth, &choice.quality, &choice.clock, &choice.declare) {
        (Some(Sweep(values)), ..) => ("max-depth", values),
        (_, Some(Sweep(values)), ..) => ("quality", values),
        (_, _, Some(Sweep(values)), _) => ("clock", values),
        (.., Some((name, Sweep(values)))) => (name, values),
        _ => ("", &[]),
    }
}

/// Scene and rendering options for one value.
fn settings(args: &SweepArgs, value: f64) -> Result<(SceneOptions, RenderOptions), String> {
    let size = args.size.unwrap_or(SIZE);
    let mut scene = SceneArgs {
        scene: args.scene.clone(),
        library: args.library.clone(),
        size: Some(size),
        message_format: args.message_format,
        ..SceneArgs::default()
    };
    let mut options = RenderOptions {
        threads: args.threads,
        antialias: args.antialias.map(antialias),
        ..pipeline::render_options(size)
    };
    let choice = &args.sweep;
    if choice.max_depth.is_some() {
        options.max_trace_level = Some(value.clamp(0.0, 256.0) as u16);
    } else if choice.quality.is_some() {
        options.quality = value.clamp(0.0, 9.0) as u8;
    } else if choice.clock.is_some() {
        scene.clock = Some(value);
    } else if let Some((name, _)) = &choice.declare {
        scene.declare.push((name.clone(), Declared::Number(value)));
    }
    Ok((scene_options(&scene)?, options))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_include_both_ends() {
        assert_eq!(range("0..3"), Ok(Sweep(vec![0.0, 1.0, 2.0, 3.0])));
        assert_eq!(range("1..0:0.5"), Ok(Sweep(vec![1.0, 0.5, 0.0])));
        assert_eq!(range("0..1:0.1").map(|s| s.0.len()), Ok(11));
        assert_eq!(range("5..5"), Ok(Sweep(vec![5.0])));
        assert_eq!(named_range("H=1..2"), Ok(("H".to_owned(), Sweep(vec![1.0, 2.0]))));
        for wrong in ["", "3", "a..b", "0..1:0", "0..1e9", "0..nan"] {
            assert!(range(wrong).is_err(), "{wrong}");
        }
    }
}
