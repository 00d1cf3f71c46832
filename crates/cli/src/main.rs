//! The program: parses arguments, shows progress and messages, nothing else.
//!
//! Two doors lead to the same rooms: the modern one (`args`, `commands`) and POV-Ray's (`povray`).
mod args;
mod cancel;
mod commands;
mod gallery;
mod pipeline;
mod povray;
mod progress;
mod report;
mod sheet;
mod sweep;
mod thumbnails;

use std::path::Path;
use std::process::ExitCode;

use clap::Parser;

/// How a run ended; the exit codes are POV-Ray's.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Outcome {
    Done,
    Failed,
    /// Stopped by the user; what was there has been written.
    Interrupted,
}

impl From<Outcome> for ExitCode {
    fn from(outcome: Outcome) -> Self {
        match outcome {
            Outcome::Done => ExitCode::SUCCESS,
            Outcome::Failed => ExitCode::from(1),
            Outcome::Interrupted => ExitCode::from(2),
        }
    }
}

fn main() -> ExitCode {
    let mut arguments = std::env::args_os().map(|a| a.to_string_lossy().into_owned());
    let program = arguments.next().unwrap_or_default();
    let rest: Vec<String> = arguments.collect();
    let called_povray = Path::new(&program).file_stem().is_some_and(|name| name == "povray");
    if called_povray {
        return povray::run(&rest).into();
    }
    if let Some("povray") = rest.first().map(String::as_str) {
        return povray::run(&rest[1..]).into();
    }
    let cancel = cancel::on_interrupt();
    match args::Arguments::parse_from(with_command(program, rest)).command.unwrap_or_default() {
        args::Command::Render(options) => commands::render(&options, &cancel),
        args::Command::Check(options) => commands::check(&options, &cancel),
        args::Command::Sweep(options) => sweep::sweep(&options, &cancel),
        args::Command::Gallery(options) => gallery::gallery(&options, &cancel),
        args::Command::Povray { arguments } => povray::run(&arguments),
    }
    .into()
}

/// A scene without a command is to be rendered.
fn with_command(program: String, rest: Vec<String>) -> Vec<String> {
    let is_scene = rest.first().is_some_and(|first| Path::new(first).is_file());
    let command = is_scene.then(|| "render".to_owned());
    std::iter::once(program).chain(command).chain(rest).collect()
}
