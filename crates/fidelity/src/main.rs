//! Writes `docs/fidelity/`: the statements of the physical tests, and the figures that the tests measured.
//!
//! A test states its law in its doc comment and prints a table. This program runs these tests in all four
//! crates, and merges a law with its tables into a section of a document.
//!
//!     cargo run -p fidelity
//!
//! Tables of an earlier run of the tests serve as well:
//!
//!     FIDELITY_TABLES=/tmp/tables WHOLE_SWEEPS=1 cargo test -p rapier2d -p rapier2d-f64 -p rapier3d \
//!         -p rapier3d-f64 --test suite
//!     cargo run -p fidelity -- /tmp/tables

mod area;
mod page;
mod statements;
mod tables;

use area::AREAS;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::{env, error, fs};

/// The crates whose tests run, and their names in the documents.
const CRATES: [(&str, &str); 4] = [
    ("rapier2d", "2D f32"),
    ("rapier2d-f64", "2D f64"),
    ("rapier3d", "3D f32"),
    ("rapier3d-f64", "3D f64"),
];

/// The environment variable that `tests/physics/table.rs` reads.
const TABLES: &str = "FIDELITY_TABLES";
/// The one with which sweeps run all their cases (`tests/physics/stage.rs`).
const WHOLE_SWEEPS: &str = "WHOLE_SWEEPS";

fn main() -> ExitCode {
    match write_documents() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("fidelity: {error}");
            ExitCode::FAILURE
        }
    }
}

fn write_documents() -> Result<(), Box<dyn error::Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize()?;
    let folder = match env::args_os().nth(1) {
        Some(folder) => PathBuf::from(folder),
        None => measure(&root)?,
    };
    let found = tables::read(&folder, &CRATES)?;
    let incomplete = tables::incomplete(&found);
    if !incomplete.is_empty() {
        return Err(format!("tables of one precision alone: {}", incomplete.join(", ")).into());
    }
    for area in &AREAS {
        let files = statements::read(&root, area.folder)?;
        let path = root.join("docs/fidelity").join(area.page);
        fs::write(&path, page::write(area, &files, &found)?)?;
        println!("{}", path.display());
    }
    Ok(())
}

/// Runs the tests of all crates, and returns the folder of their tables.
fn measure(root: &Path) -> Result<PathBuf, Box<dyn error::Error>> {
    let folder = root.join("target/fidelity");
    if folder.exists() {
        fs::remove_dir_all(&folder)?;
    }
    for (name, _) in CRATES {
        run_tests(root, &folder, name)?;
    }
    Ok(folder)
}

/// Runs the tests of all areas in one crate. Cargo shows the progress.
fn run_tests(root: &Path, folder: &Path, name: &str) -> Result<(), Box<dyn error::Error>> {
    println!("{name}: runs the tests");
    let filters = AREAS.iter().flat_map(|area| area.filters).copied();
    let status = Command::new(env!("CARGO"))
        .current_dir(root)
        .args(["test", "--package", name, "--test", "suite", "--"])
        .args(filters)
        .env(TABLES, folder)
        .env(WHOLE_SWEEPS, "1")
        .status()?;
    if status.success() { Ok(()) } else { Err(format!("the tests of {name} failed").into()) }
}
