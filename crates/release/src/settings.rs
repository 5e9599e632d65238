//! `release.toml`: version and published names.

use crate::Failure;
use crate::files::read;
use serde::Deserialize;
use std::path::Path;

/// Place of the settings in the repository.
pub const PLACE: &str = "crates/release/release.toml";

/// Manifests that state the version of their package, and the field that does. The facade has the version
/// of the published Rapier that it replaces.
const MANIFESTS: [(&str, &str); 6] = [
    ("Cargo.toml", "version ="),
    ("crates/bevy/Cargo.toml", "version ="),
    ("python/Cargo.toml", "version ="),
    ("python/pyproject.toml", "version ="),
    ("rapier2d/package.json", "\"version\":"),
    ("rapier3d/package.json", "\"version\":"),
];

/// Version and published names of all artefacts.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Settings {
    /// The version of every artefact but the facades.
    pub version: String,
    /// Address of the public repository, or nothing.
    pub repository: String,
    /// Published name of the Python package.
    pub python: String,
    /// The published crates.
    #[serde(rename = "crate")]
    pub crates: Vec<PublishedCrate>,
    /// The published npm packages.
    #[serde(rename = "package")]
    pub packages: Vec<PublishedPackage>,
    /// Whether the npm packages are built without full optimisation, documentation and threads. Their sizes
    /// have no budgets then.
    #[serde(skip)]
    pub is_fast: bool,
}

/// A package of the repository and its name on the registry of npm.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PublishedPackage {
    /// Its folder in the repository.
    pub folder: String,
    /// Name on the registry.
    pub name: String,
}

/// A crate of the repository and its name on the registry.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PublishedCrate {
    /// Folder of its manifest in the repository.
    pub folder: String,
    /// Name on the registry.
    pub name: String,
    /// Its version, where it is not that of the release: a facade has the version of the Rapier that it
    /// replaces.
    pub version: Option<String>,
}

impl Settings {
    /// Reads the settings of the repository at `root`.
    pub fn load(root: &Path) -> Result<Self, Failure> {
        let place = root.join(PLACE);
        toml_edit::de::from_str(&read(&place)?)
            .map_err(|reason| Failure::Manifest { place, reason: reason.to_string() })
    }

    /// Checks that the manifests state the version of the settings.
    pub fn check_versions(&self, root: &Path) -> Result<(), Failure> {
        for (place, field) in MANIFESTS {
            let line = format!("{field} \"{}\"", self.version);
            let place = root.join(place);
            if !read(&place)?.lines().any(|text| text.trim().trim_end_matches(',') == line) {
                let reason = format!("has no line `{line}`, the version of {PLACE}");
                return Err(Failure::Manifest { place, reason });
            }
        }
        Ok(())
    }

    /// The published name and version of the package in a folder of the repository.
    pub fn published(&self, folder: &str) -> Option<(&str, &str)> {
        let found = self.crates.iter().find(|one| one.folder == folder)?;
        Some((&found.name, found.version.as_ref().unwrap_or(&self.version)))
    }
}

#[cfg(test)]
mod tests {
    use super::Settings;
    use std::path::Path;

    /// The lines that the README gives for the time after publication.
    #[test]
    fn the_readme_names_what_is_published() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        let readme =
            std::fs::read_to_string(root.join("README.md")).expect("README.md is readable");
        let settings = Settings::load(&root).expect("the settings are valid");
        let (minor, _) = settings.version.rsplit_once('.').expect("a version has three parts");
        let mut lines = vec![format!("pip install {}", settings.python)];
        for (library, folder) in
            [("rapier3d", "crates/rapier3d"), ("rapier3d-bevy", "crates/bevy/rapier3d")]
        {
            let (name, _) = settings.published(folder).expect("the crate is published");
            lines.push(format!("{library} = {{ package = \"{name}\", version = \"{minor}\" }}"));
            lines.push(format!("{library} = {{ path = \"../rapier/{folder}\" }}"));
        }
        for line in lines {
            assert!(readme.contains(&line), "README.md has no `{line}`");
        }
    }
}
