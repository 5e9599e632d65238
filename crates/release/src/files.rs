//! Reading, writing and copying of files, with errors that name the path.

use crate::Failure;
use std::fs;
use std::path::Path;

/// Reads a text file.
pub fn read(place: &Path) -> Result<String, Failure> {
    fs::read_to_string(place).map_err(|reason| Failure::File { place: place.into(), reason })
}

/// Writes a text file, and creates its folder.
pub fn write(place: &Path, text: &str) -> Result<(), Failure> {
    make_folder_of(place)?;
    fs::write(place, text).map_err(|reason| Failure::File { place: place.into(), reason })
}

/// Copies a file, and creates its folder.
pub fn copy(from: &Path, to: &Path) -> Result<(), Failure> {
    make_folder_of(to)?;
    let copied = fs::copy(from, to);
    copied.map(drop).map_err(|reason| Failure::File { place: from.into(), reason })
}

/// Removes a folder with its content, and creates it again.
pub fn make_empty_folder(place: &Path) -> Result<(), Failure> {
    let failed = |reason| Failure::File { place: place.into(), reason };
    if place.exists() {
        fs::remove_dir_all(place).map_err(failed)?;
    }
    fs::create_dir_all(place).map_err(failed)
}

/// Names of the entries of a folder, sorted.
pub fn entries(folder: &Path) -> Result<Vec<String>, Failure> {
    let failed = |reason| Failure::File { place: folder.into(), reason };
    let mut names = Vec::new();
    for entry in fs::read_dir(folder).map_err(failed)? {
        names.push(entry.map_err(failed)?.file_name().to_string_lossy().into_owned());
    }
    names.sort();
    Ok(names)
}

/// Copies the files below a folder for which `wanted` is true. `wanted` gets the name of an entry, whether
/// of a file or a folder.
pub fn copy_tree(from: &Path, to: &Path, wanted: &dyn Fn(&str) -> bool) -> Result<(), Failure> {
    for name in entries(from)?.iter().filter(|name| wanted(name)) {
        let (source, target) = (from.join(name), to.join(name));
        if source.is_dir() {
            copy_tree(&source, &target, wanted)?;
        } else {
            copy(&source, &target)?;
        }
    }
    Ok(())
}

fn make_folder_of(place: &Path) -> Result<(), Failure> {
    let Some(folder) = place.parent() else { return Ok(()) };
    fs::create_dir_all(folder).map_err(|reason| Failure::File { place: folder.into(), reason })
}
