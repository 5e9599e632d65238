//! # Gallery: runs scenes from the command line
//!
//! Both galleries, `all_examples2` and `all_examples3`, are this crate plus their own list of scenes.
//! It reads the command line, steps every chosen scene with a progress bar, prints a table of what
//! the scenes cost, and leaves a picture of each in a folder together with a page that shows them all.
//!
//! It knows no engine. What it needs from one is the trait [`SceneRun`]: step, count, draw. Points
//! are `[f32; 3]` whatever the dimension and the precision of the engine; a flat world draws at z = 0.

mod album;
mod args;
mod catalog;
mod mode;
mod picture;
mod progress;
mod runner;
mod table;

pub use catalog::{Category, Entry, SceneRun, StageTimes, Stats};
pub use picture::{Color, Line, Pen, Point, Triangle, View};
pub use progress::Progress;
pub use table::{Table, grouped};

use args::{Options, Request};
use mode::Mode;
use std::io::Write;
use std::process::ExitCode;

/// Exit code when the command line cannot be understood or names no known scene.
const EXIT_USAGE: u8 = 2;
/// Exit code when the pictures cannot be written.
const EXIT_FAILURE: u8 = 1;

/// The whole program: reads the process's arguments and does what they ask of `entries`.
///
/// `title` heads the page of pictures, `program` is the name shown in the help.
pub fn main(title: &str, program: &str, entries: &[Entry]) -> ExitCode {
    let arguments: Vec<String> =
        std::env::args_os().skip(1).map(|a| a.to_string_lossy().into_owned()).collect();
    let mut out = std::io::stdout().lock();
    let mut err = std::io::stderr().lock();

    let request = match args::parse(&arguments, entries) {
        Ok(request) => request,
        Err(error) => {
            // Nobody is left to tell when the error stream is gone.
            let _ = writeln!(err, "{program}: {error}");
            return ExitCode::from(EXIT_USAGE);
        }
    };
    let outcome = match request {
        Request::Help => args::print_help(&mut out, program),
        Request::List => args::print_list(&mut out, entries),
        Request::Run(options) => run(&mut out, title, entries, &options),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        // The reader of a pipe may leave before the end, as `head` does: not a failure.
        Err(error) if error.kind() == std::io::ErrorKind::BrokenPipe => ExitCode::SUCCESS,
        Err(error) => {
            let _ = writeln!(err, "{program}: {error}");
            ExitCode::from(EXIT_FAILURE)
        }
    }
}

/// Runs the chosen scenes in the mode that fits the machine.
fn run(
    out: &mut dyn Write,
    title: &str,
    entries: &[Entry],
    options: &Options,
) -> std::io::Result<()> {
    match Mode::choose(options.headless) {
        Mode::Headless { note } => {
            if let Some(note) = note {
                writeln!(out, "{note}")?;
            }
            runner::run(out, title, entries, options)
        }
    }
}
