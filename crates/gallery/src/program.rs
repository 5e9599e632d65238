//! The whole program: command line, then a window or a headless run.

use crate::args::{self, Options, Renderer, Request};
use crate::catalog::Entry;
use crate::mode::has_display;
use crate::painter::{Painter, Rasteriser};
use crate::runner;
use std::io::Write;
use std::path::Path;
use std::process::ExitCode;

/// Exit code of a command line with an unknown option or scene.
const EXIT_USAGE: u8 = 2;
/// Exit code of a run whose pictures cannot be written.
const EXIT_FAILURE: u8 = 1;

/// The content of a window.
pub struct WindowRequest<'a> {
    /// Positions of the chosen scenes in the list.
    pub chosen: &'a [usize],
    /// Folder for pictures and recordings.
    pub folder: &'a Path,
}

/// List of scenes with the means to show them.
pub struct Program<'a> {
    /// Heading of the page of pictures.
    pub title: &'a str,
    /// Name of the program, for its help.
    pub name: &'a str,
    /// The scenes.
    pub entries: &'a [Entry],
    /// Opens a window and returns when it is closed, or returns the reason why it cannot be opened.
    pub window: &'a dyn Fn(&WindowRequest) -> Result<(), String>,
    /// Finds a painter on a graphics adapter.
    pub adapter: &'a dyn Fn() -> Option<Box<dyn Painter>>,
}

impl Program<'_> {
    /// Reads the arguments of the process and executes them.
    pub fn main(&self) -> ExitCode {
        let arguments: Vec<String> =
            std::env::args_os().skip(1).map(|a| a.to_string_lossy().into_owned()).collect();
        let mut out = std::io::stdout().lock();
        let mut err = std::io::stderr().lock();
        let request = match args::parse(&arguments, self.entries) {
            Ok(request) => request,
            Err(error) => {
                // A closed error stream does not change the exit code.
                let _ = writeln!(err, "{}: {error}", self.name);
                return ExitCode::from(EXIT_USAGE);
            }
        };
        let outcome = match request {
            Request::Help => args::print_help(&mut out, self.name),
            Request::List => args::print_list(&mut out, self.entries),
            Request::Run(options) => self.run(&mut out, &options),
        };
        match outcome {
            Ok(()) => ExitCode::SUCCESS,
            // The reader of a pipe may close it before the end, as `head` does. That is not a failure.
            Err(error) if error.kind() == std::io::ErrorKind::BrokenPipe => ExitCode::SUCCESS,
            Err(error) => {
                let _ = writeln!(err, "{}: {error}", self.name);
                ExitCode::from(EXIT_FAILURE)
            }
        }
    }

    /// Opens the window, or runs the chosen scenes headless.
    fn run(&self, out: &mut dyn Write, options: &Options) -> std::io::Result<()> {
        if !options.headless && has_display() {
            writeln!(
                out,
                "A window with {} opens. `-- --help` lists what else is there.",
                self.title
            )?;
            let request = WindowRequest { chosen: &options.chosen, folder: &options.folder };
            match (self.window)(&request) {
                Ok(()) => return Ok(()),
                Err(reason) => writeln!(out, "No window: {reason}. Running headless.")?,
            }
        }
        let mut painter = self.painter(options.renderer)?;
        writeln!(
            out,
            "Scenes to run without a window: {}. A table and pictures in {} follow. Painter: {}.",
            options.chosen.len(),
            options.folder.display(),
            painter.device()
        )?;
        runner::run(out, self.title, self.entries, options, painter.as_mut())
    }

    fn painter(&self, renderer: Renderer) -> std::io::Result<Box<dyn Painter>> {
        let adapter = if renderer == Renderer::Cpu { None } else { (self.adapter)() };
        match (adapter, renderer) {
            (Some(painter), _) => Ok(painter),
            (None, Renderer::Gpu) => Err(std::io::Error::other("there is no graphics adapter")),
            (None, _) => Ok(Box::new(Rasteriser)),
        }
    }
}
