//! The command line: see `--help`.

use clap::{Parser, Subcommand};
use replay::{Failure, Request, flat, play, solid};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Records runs of the engine as files, replays them on any machine, and compares them.
#[derive(Parser)]
#[command(version)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Record a scene of a gallery.
    Record {
        /// Gallery and name of the scene, such as `3d/dominoes`.
        scene: String,
        /// Number of steps (default: as many as the gallery takes).
        #[arg(long)]
        steps: Option<usize>,
        /// Record hashes after every stage of a step, too.
        #[arg(long)]
        stages: bool,
        /// The file to write.
        #[arg(long, short, default_value = "scene.rec")]
        output: PathBuf,
    },
    /// Replay a recording, compare every hash, and stop at the first that differs.
    Play {
        /// The recording.
        file: PathBuf,
    },
    /// Find the first step, stage and body in which two recordings differ.
    Compare {
        /// A recording.
        first: PathBuf,
        /// Another recording of the same run.
        second: PathBuf,
    },
}

/// Reason for the failure of the program.
#[derive(Debug, thiserror::Error)]
enum Error {
    #[error("{}: {error}", path.display())]
    File { path: PathBuf, error: std::io::Error },
    #[error("`{0}` is not the name of a scene: it begins with `2d/` or `3d/`")]
    Name(String),
    #[error(transparent)]
    Failure(#[from] Failure),
}

fn main() -> ExitCode {
    match run(&Arguments::parse().command) {
        Ok(text) => {
            println!("{text}");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("replay: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(command: &Command) -> Result<String, Error> {
    match command {
        Command::Record { scene, steps, stages, output } => {
            let recording = record(scene, *steps, *stages)?;
            std::fs::write(output, &recording).map_err(at(output))?;
            Ok(format!("{}: {} bytes", output.display(), recording.len()))
        }
        Command::Play { file } => {
            let summary = play(&read(file)?)?;
            Ok(format!("{summary}\nall hashes are equal"))
        }
        Command::Compare { first, second } => {
            solid::compare(&read(first)?, &read(second)?)?;
            Ok("the recordings are equal".to_string())
        }
    }
}

fn record(name: &str, steps: Option<usize>, stages: bool) -> Result<Vec<u8>, Error> {
    let (gallery, scene) = name.split_once('/').ok_or_else(|| Error::Name(name.to_string()))?;
    let request = Request { scene, steps, stages };
    match gallery {
        "2d" => Ok(flat::record(&request)?),
        "3d" => Ok(solid::record(&request)?),
        _ => Err(Error::Name(name.to_string())),
    }
}

fn read(path: &Path) -> Result<Vec<u8>, Error> {
    std::fs::read(path).map_err(at(path))
}

fn at(path: &Path) -> impl FnOnce(std::io::Error) -> Error {
    move |error| Error::File { path: path.to_path_buf(), error }
}
