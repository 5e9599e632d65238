//! `release.toml`: version and published names.

use crate::Failure;
use crate::files::read;
use serde::Deserialize;
use std::path::Path;

/// Place of the settings in the repository.
pub const PLACE: &str = "crates/release/release.toml";

/// Version and published names of all artefacts.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Settings {
    /// The version of every artefact.
    pub version: String,
    /// Address of the public repository, or nothing.
    pub repository: String,
    /// The published crates.
    #[serde(rename = "crate")]
    pub crates: Vec<PublishedCrate>,
}

/// A crate of the repository and its name on the registry.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PublishedCrate {
    /// Folder of its manifest in the repository.
    pub folder: String,
    /// Name on the registry.
    pub name: String,
}

impl Settings {
    /// Reads the settings of the repository at `root`.
    pub fn load(root: &Path) -> Result<Self, Failure> {
        let place = root.join(PLACE);
        toml_edit::de::from_str(&read(&place)?)
            .map_err(|reason| Failure::Manifest { place, reason: reason.to_string() })
    }

    /// The published name of the package in a folder of the repository.
    pub fn name_of(&self, folder: &str) -> Option<&str> {
        let found = self.crates.iter().find(|one| one.folder == folder);
        found.map(|one| one.name.as_str())
    }
}
