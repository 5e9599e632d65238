//! The artefacts of each kind, and the programs that pack the files.

use crate::Failure;
use crate::files::{copy, copy_tree, entries, make_empty_folder, read, write};
use crate::manifest;
use crate::settings::Settings;
use crate::stage::{Naming, Stage};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

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
    settings: &Settings,
) -> Result<Vec<(String, u64)>, Failure> {
    let (folder, stage) = (artefacts.join("python"), artefacts.join("stage/python"));
    make_empty_folder(&folder)?;
    make_empty_folder(&stage)?;
    Stage::build(repository, &stage, Naming::OfTheRepository, &["python"])?;
    let package = stage.join("rapier-python");
    let readme = published_readme(&read(&repository.join("python/README.md"))?, &settings.python);
    write(&package.join("README.md"), &readme)?;
    let mut project = manifest::parse(&repository.join("python/pyproject.toml"))?;
    project["project"]["name"] = toml_edit::value(&settings.python);
    write(&package.join("pyproject.toml"), &project.to_string())?;
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

/// The description of the published Python package, which is installed by its name.
fn published_readme(text: &str, name: &str) -> String {
    let published = |line: &str| match line.starts_with("pip install ./python") {
        true => format!("pip install {name}\n"),
        false => format!("{line}\n"),
    };
    text.lines().map(published).collect()
}

/// The tarballs of both npm packages. The sizes of their downloads follow: raw, by gzip, by brotli.
pub fn npm(
    repository: &Path,
    artefacts: &Path,
    settings: &Settings,
) -> Result<Vec<(String, u64)>, Failure> {
    let folder = artefacts.join("npm");
    make_empty_folder(&folder)?;
    let target = absolute(&folder)?;
    let mut downloads = Vec::new();
    for package in &settings.packages {
        let home = repository.join(&package.folder);
        call(Command::new("npm").args(["ci", "--no-fund", "--no-audit"]).current_dir(&home))?;
        let fast = settings.is_fast.then_some("--fast");
        call(Command::new("./build_all.sh").args(fast).current_dir(&home))?;
        let dimension = package.folder.trim_start_matches("rapier").trim_end_matches('d');
        let mut pack = Command::new("node");
        pack.arg(repository.join("javascript/pack.mjs")).arg(dimension).arg(&target);
        pack.args([&package.name, &settings.repository]).args(fast);
        downloads.extend(output(&mut pack)?.lines().filter_map(size_and_name));
    }
    if settings.is_fast {
        return Ok(Vec::new());
    }
    let mut all = sizes(&folder)?;
    all.extend(downloads);
    Ok(all)
}

/// Reads a line of `javascript/pack.mjs`: bytes and name.
fn size_and_name(line: &str) -> Option<(String, u64)> {
    let (bytes, name) = line.split_once(' ')?;
    Some((name.to_owned(), bytes.parse().ok()?))
}

/// The output of a program that ends well. Its messages stay visible.
fn output(command: &mut Command) -> Result<String, Failure> {
    let program = format!("{command:?}");
    let failed = |status| Failure::Program { program: program.clone(), status };
    let result = command.stderr(Stdio::inherit()).output();
    let result = result.map_err(|reason| failed(reason.to_string()))?;
    match result.status.success() {
        true => Ok(String::from_utf8_lossy(&result.stdout).into_owned()),
        false => Err(failed(result.status.to_string())),
    }
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

#[cfg(test)]
mod tests {
    use super::{published_readme, size_and_name};

    #[test]
    fn a_published_readme_names_the_package() {
        let text = "# rapier\npip install ./python    # needs Rust\n";
        assert_eq!(published_readme(text, "other"), "# rapier\npip install other\n");
    }

    #[test]
    fn lines_of_sizes_are_read() {
        let read = size_and_name("123 rapier3d/rapier.wasm.br");
        assert_eq!(read, Some(("rapier3d/rapier.wasm.br".to_owned(), 123)));
        assert_eq!(size_and_name("npm notice"), None);
    }
}
