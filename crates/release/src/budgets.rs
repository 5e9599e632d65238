//! `budgets.toml`: the largest size of each artefact.

use crate::Failure;
use crate::files::read;
use std::collections::BTreeMap;
use std::path::Path;

/// Place of the budgets in the repository.
const PLACE: &str = "crates/release/budgets.toml";

/// The largest sizes of artefacts.
pub struct Budgets {
    /// Sizes in kB by [`short_name`].
    largest: BTreeMap<String, f64>,
}

impl Budgets {
    /// Reads the budgets of the repository at `root`.
    pub fn load(root: &Path) -> Result<Self, Failure> {
        let place = root.join(PLACE);
        let largest = toml_edit::de::from_str(&read(&place)?)
            .map_err(|reason| Failure::Manifest { place, reason: reason.to_string() })?;
        Ok(Self { largest })
    }

    /// Checks that no artefact exceeds its budget. An artefact without a budget is a mistake, too.
    pub fn check(&self, artefacts: &[(String, u64)]) -> Result<(), Failure> {
        for (file, bytes) in artefacts {
            let name = short_name(file);
            let size = *bytes as f64 / 1e3;
            let budget = self.largest.get(&name).copied().unwrap_or(0.0);
            if size > budget {
                return Err(Failure::Size { place: PLACE, name, size, budget });
            }
        }
        Ok(())
    }
}

/// The name of a file without version and platform, but with its extension. The version is the first part
/// that begins with a digit.
fn short_name(file: &str) -> String {
    let digit_follows = |(at, _): &(usize, &str)| {
        file[at + 1..].starts_with(|letter: char| letter.is_ascii_digit())
    };
    let Some((at, _)) = file.match_indices('-').find(digit_follows) else { return file.into() };
    let extension = file.rsplit_once('.').map_or("", |(_, extension)| extension);
    format!("{}.{extension}", &file[..at])
}

#[cfg(test)]
mod tests {
    use super::{Budgets, short_name};
    use std::collections::BTreeMap;

    #[test]
    fn names_are_without_version_and_platform() {
        for (file, name) in [
            ("rapier3d-engine-0.32.0.crate", "rapier3d-engine.crate"),
            ("rapier-0.32.0-cp39-abi3-linux_x86_64.whl", "rapier.whl"),
            ("rapier-0.32.0.tar.gz", "rapier.gz"),
            ("rapier2d-engine-f64-0.32.0.crate", "rapier2d-engine-f64.crate"),
            ("rapier3d.wasm", "rapier3d.wasm"),
        ] {
            assert_eq!(short_name(file), name);
        }
    }

    #[test]
    fn artefacts_that_are_too_large_or_unknown_are_refused() {
        let budgets = Budgets { largest: BTreeMap::from([("a.crate".into(), 10.0)]) };
        let check = |file: &str, bytes| budgets.check(&[(file.into(), bytes)]);
        assert!(check("a-1.0.0.crate", 10_000).is_ok());
        assert!(check("a-1.0.0.crate", 10_001).is_err());
        assert!(check("b-1.0.0.crate", 1).is_err());
    }
}
