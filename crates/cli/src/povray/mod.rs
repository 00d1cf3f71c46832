//! POV-Ray's door: its switches, INI files, text streams and exit codes, as version 3.7 has them.
mod animation;
mod console;
mod ini;
mod keys;
mod run;
mod switches;
#[cfg(test)]
mod tests;

use std::path::PathBuf;

use crate::Outcome;
use console::Console;
use keys::{OptionError, Settings, StreamKind};

/// Runs what a POV-Ray command line says.
pub(crate) fn run(arguments: &[String]) -> Outcome {
    match arguments {
        [only] if ["-h", "-?", "--help", "-help", "+h", "+?"].contains(&only.to_lowercase().as_str()) => {
            eprint!("{HELP}");
            return Outcome::Done;
        }
        [only] if ["--version", "-version"].contains(&only.as_str()) => {
            eprintln!("Raggio {}, compatible with POV-Ray 3.7", env!("CARGO_PKG_VERSION"));
            return Outcome::Done;
        }
        _ => {}
    }
    match read_options(arguments) {
        Ok(settings) => run::render(&settings),
        Err(error) => {
            let command: Vec<&str> =
                std::iter::once("povray").chain(arguments.iter().map(String::as_str)).collect();
            eprintln!("\nProblem with option setting");
            eprintln!("{}", command.join(" "));
            eprintln!("{}: {}", error.option, error.reason);
            eprintln!("Failed to parse command-line option");
            Outcome::Failed
        }
    }
}

/// The INI file of the surroundings, then the command line.
fn read_options(arguments: &[String]) -> Result<Settings, OptionError> {
    let mut settings = Settings::default();
    if let Some(path) = default_ini() {
        ini::apply_file(&path.to_string_lossy(), &mut settings)?;
    }
    ini::apply_arguments(arguments, &mut settings)?;
    match settings.input {
        Some(_) => Ok(settings),
        None => Err(OptionError::new("povray", "No input file provided")),
    }
}

/// `POVINI`, else `povray.ini` in this folder, else the user's own.
fn default_ini() -> Option<PathBuf> {
    if let Some(path) = std::env::var_os("POVINI").map(PathBuf::from) {
        if path.is_file() {
            return Some(path);
        }
        eprintln!("povray: POVINI environment: cannot open {}: No such file or directory", path.display());
    }
    let here = PathBuf::from("povray.ini");
    let home = std::env::var_os("HOME").map(|home| PathBuf::from(home).join(".povray/3.7/povray.ini"));
    [Some(here), home].into_iter().flatten().find(|path| path.is_file())
}

const HELP: &str = "\
Usage: povray [+/-]Option1 [+/-]Option2 ... [INI-file[section]]

  +I<file>  scene file            +O<file>  output file, - for standard output
  +W<n>     width                 +H<n>     height
  +F<x><n>  file type: B BMP, C and T Targa, E OpenEXR, H HDR, J JPEG, N PNG, P PPM; n bits per colour
  +A<n.n>   anti-aliasing         +AM<n>    its method       +R<n>  its depth
  +J<n.n>   jitter                +AG<n.n>  its gamma
  +Q<n>     quality 0 to 9        +WT<n>    threads
  +UA       alpha channel         +L<path>  library folder
  +SC +EC +SR +ER<n>  first and last column and row
  +K<n.n>   clock                 +KFF<n>   last frame of an animation
  +KFI<n> +KI<n.n> +KF<n.n> +KC   first frame, first and last clock, cyclic
  +SF +EF<n>  first and last frame to render
  +GA<file> all messages, to a file; -GA none on the console
  Declare=NAME=NUMBER             Any other INI option may be given as well.
";
