//! Assembles the artefacts of a release into one folder: crates, the Python packages and the npm tarballs.
//!
//! `cargo run -p release` publishes nothing. `crates/release/try` then uses the artefacts as a user would,
//! outside the repository.

mod artefacts;
mod budgets;
mod files;
mod manifest;
mod settings;
mod stage;

use budgets::Budgets;
use clap::{Parser, ValueEnum};
use settings::Settings;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

/// Reasons for which no artefact was made.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// A file could not be read or written.
    #[error("{}: {reason}", place.display())]
    File {
        /// The file.
        place: PathBuf,
        /// The system's message.
        reason: std::io::Error,
    },
    /// A manifest or the settings have a mistake.
    #[error("{}: {reason}", place.display())]
    Manifest {
        /// The file.
        place: PathBuf,
        /// What is wrong.
        reason: String,
    },
    /// A program failed.
    #[error("`{program}` ended with {status}")]
    Program {
        /// The command.
        program: String,
        /// Its exit status.
        status: String,
    },
    /// An artefact is too large, or has no budget.
    #[error("{name} has {size:.1} kB; its budget is {budget} kB ({place})")]
    Size {
        /// The file of the budgets.
        place: &'static str,
        /// The artefact.
        name: String,
        /// Its size (kB).
        size: f64,
        /// Its largest size (kB); 0 if there is none.
        budget: f64,
    },
}

/// Kinds of artefacts.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Kind {
    /// `.crate` files of the engines, the Bevy plugins and the facade.
    Crates,
    /// The source distribution and the wheel.
    Python,
    /// The tarballs of `npm pack`.
    Npm,
}

/// Assembles the artefacts of a release into `target/artefacts`. Nothing is published.
#[derive(Parser)]
struct Options {
    /// The artefacts to assemble. All, if none is named.
    kinds: Vec<Kind>,
    /// The folder of the artefacts.
    #[arg(long, default_value = "target/artefacts")]
    folder: PathBuf,
    /// Builds the npm packages without full optimisation, documentation and threads: for tries of the script.
    #[arg(long)]
    fast: bool,
}

fn main() -> ExitCode {
    match run(&Options::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("release: {failure}");
            ExitCode::FAILURE
        }
    }
}

fn run(options: &Options) -> Result<(), Failure> {
    let repository = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let repository = manifest::without_dots(&repository);
    let mut settings = Settings::load(&repository)?;
    settings.is_fast = options.fast;
    settings.check_versions(&repository)?;
    let budgets = Budgets::load(&repository)?;
    if settings.repository.is_empty() {
        println!("{}: no address of the repository: manifests have none", settings::PLACE);
    }
    for (kind, assemble) in [
        (Kind::Crates, artefacts::crates as artefacts::Assemble),
        (Kind::Python, artefacts::python),
        (Kind::Npm, artefacts::npm),
    ] {
        if options.kinds.is_empty() || options.kinds.contains(&kind) {
            let start = Instant::now();
            let artefacts = assemble(&repository, &options.folder, &settings)?;
            for (name, bytes) in &artefacts {
                println!("{:>10.1} kB  {name}", *bytes as f64 / 1e3);
            }
            println!("{:>10.0} s", start.elapsed().as_secs_f64());
            budgets.check(&artefacts)?;
        }
    }
    Ok(())
}
