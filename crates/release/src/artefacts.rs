//! The artefacts of each kind, and the programs that pack the files.

use crate::Failure;
use crate::files::{copy, copy_tree, entries, make_empty_folder};
use crate::settings::Settings;
use crate::stage::{Naming, Stage};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Assembles the artefacts of one kind, and returns their names and sizes in bytes. The arguments are the
/// repository, the folder of all artefacts, and the settings.
pub type Assemble = fn(&Path, &Path, &Settings) -> Result<Vec<(String, u64)>, Failure>;

/// `.crate` files of all published crates.
pub fn crates(
    repository: &Path,
    artefacts: &Path,
    settings: &Settings,
) -> Result<Vec<(String, u64)>, Failure> {
    let (folder, stage) = (artefacts.join("crates"), artefacts.join("stage/crates"));
    make_empty_folder(&folder)?;
    make_empty_folder(&stage)?;
    let packages: Vec<&str> = settings.crates.iter().map(|one| one.folder.as_str()).collect();
    let staged = Stage::build(repository, &stage, Naming::Published(settings), &packages)?;
    let pack = ["package", "--workspace", "--no-verify", "--allow-dirty", "--quiet"];
    call(Command::new("cargo").args(pack).args(["--target-dir", "target"]).current_dir(&stage))?;
    for package in staged.packages() {
        let file = format!("{}-{}.crate", package.name, package.version);
        copy(&stage.join("target/package").join(&file), &folder.join(&file))?;
    }
    sizes(&folder)
}

/// The source distribution, which contains the engines' sources, and a wheel built from this archive.
pub fn python(
    repository: &Path,
    artefacts: &Path,
    _settings: &Settings,
) -> Result<Vec<(String, u64)>, Failure> {
    let (folder, stage) = (artefacts.join("python"), artefacts.join("stage/python"));
    make_empty_folder(&folder)?;
    make_empty_folder(&stage)?;
    Stage::build(repository, &stage, Naming::OfTheRepository, &["python"])?;
    let package = stage.join("rapier-python");
    for file in ["pyproject.toml", "README.md"] {
        copy(&repository.join("python").join(file), &package.join(file))?;
    }
    let sources = |name: &str| name != "__pycache__" && !name.ends_with(".so");
    copy_tree(&repository.join("python/rapier"), &package.join("rapier"), &sources)?;
    // The versions of the lock file are those that the tests ran with.
    copy(&repository.join("python/Cargo.lock"), &stage.join("Cargo.lock"))?;
    let environment = artefacts.join("stage/environment");
    if !environment.exists() {
        call(Command::new("python3").args(["-m", "venv"]).arg(&environment))?;
        let pip = environment.join("bin/pip");
        call(Command::new(pip).args(["install", "--quiet", "build", "twine"]))?;
    }
    let python = absolute(&environment.join("bin/python"))?;
    let target = absolute(&folder)?;
    let build = ["-m", "build", "--outdir"];
    call(Command::new(&python).args(build).arg(&target).current_dir(&package))?;
    let files = entries(&folder)?;
    let check = ["-m", "twine", "check", "--strict"];
    call(Command::new(&python).args(check).args(&files).current_dir(&folder))?;
    sizes(&folder)
}

/// The tarballs of both npm packages.
pub fn npm(
    repository: &Path,
    artefacts: &Path,
    _settings: &Settings,
) -> Result<Vec<(String, u64)>, Failure> {
    let folder = artefacts.join("npm");
    make_empty_folder(&folder)?;
    let target = absolute(&folder)?;
    for package in ["rapier2d", "rapier3d"] {
        let package = repository.join(package);
        call(Command::new("npm").args(["ci", "--no-fund", "--no-audit"]).current_dir(&package))?;
        call(Command::new("./build_all.sh").current_dir(&package))?;
        let pack = ["pack", "--silent", "--pack-destination"];
        call(Command::new("npm").args(pack).arg(&target).current_dir(package.join("pkg")))?;
    }
    sizes(&folder)
}

fn call(command: &mut Command) -> Result<(), Failure> {
    let program = format!("{command:?}");
    let status = command.status().map_err(|reason| Failure::Program {
        program: program.clone(),
        status: reason.to_string(),
    })?;
    if status.success() {
        Ok(())
    } else {
        Err(Failure::Program { program, status: status.to_string() })
    }
}

fn absolute(place: &Path) -> Result<PathBuf, Failure> {
    std::path::absolute(place).map_err(|reason| Failure::File { place: place.into(), reason })
}

fn sizes(folder: &Path) -> Result<Vec<(String, u64)>, Failure> {
    let mut sizes = Vec::new();
    for name in entries(folder)? {
        let place = folder.join(&name);
        let data = fs::metadata(&place).map_err(|reason| Failure::File { place, reason })?;
        sizes.push((name, data.len()));
    }
    Ok(sizes)
}
