//! A workspace outside the repository, in which each package contains its own sources.
//!
//! All engine crates share one source tree that lies outside their folders, and `cargo package` and
//! `maturin sdist` leave out what lies there. The stage copies to each package the files of its library,
//! its licences and its README.

use crate::Failure;
use crate::files::{copy, copy_tree, read, write};
use crate::manifest;
use crate::settings::Settings;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use toml_edit::{Array, DocumentMut, Item, Table};

/// Features that exist to build one source in two ways, and that documentation shows together.
const DOCUMENTED_FEATURES: [&str; 4] =
    ["serde-serialize", "debug-render", "parallel", "debug-lines"];

/// Names of packages and fields of manifests in a stage.
pub enum Naming<'a> {
    /// As on the registry: published names, one version, dependencies with versions.
    Published(&'a Settings),
    /// As in the repository.
    OfTheRepository,
}

/// Name and version of a package in the stage.
#[derive(Clone)]
pub struct Package {
    /// Its name, which is its folder, too.
    pub name: String,
    /// Its version.
    pub version: String,
}

/// A workspace outside the repository.
pub struct Stage<'a> {
    repository: &'a Path,
    folder: &'a Path,
    naming: Naming<'a>,
    /// Folders of the packages in the repository.
    packages: BTreeMap<PathBuf, Package>,
    /// Profiles, which only the manifest of a workspace may have.
    profiles: Option<Item>,
}

impl<'a> Stage<'a> {
    /// Copies the packages in the given folders of the repository, with all packages that they depend on by
    /// path.
    pub fn build(
        repository: &'a Path,
        folder: &'a Path,
        naming: Naming<'a>,
        packages: &[&str],
    ) -> Result<Self, Failure> {
        let none = BTreeMap::new();
        let mut stage = Self { repository, folder, naming, packages: none, profiles: None };
        for package in packages {
            stage.add(Path::new(package))?;
        }
        stage.write_workspace()?;
        Ok(stage)
    }

    /// All packages of the stage.
    pub fn packages(&self) -> impl Iterator<Item = &Package> {
        self.packages.values()
    }

    fn add(&mut self, package: &Path) -> Result<Package, Failure> {
        if let Some(known) = self.packages.get(package) {
            return Ok(known.clone());
        }
        let source = self.repository.join(package);
        let mut manifest = manifest::parse(&source.join("Cargo.toml"))?;
        manifest::inherit(&mut manifest, &manifest::workspace_of(&source)?);
        manifest::remove_tests(&mut manifest);
        self.profiles = manifest.remove("profile").or(self.profiles.take());
        let named = self.named(package, &manifest);
        self.packages.insert(package.into(), named.clone());
        for (key, path) in manifest::path_dependencies(&manifest) {
            let dependency = self.add(&manifest::without_dots(&package.join(path)))?;
            self.set_dependency(&mut manifest, &key, &dependency);
        }
        self.describe(&mut manifest, &named);
        self.copy_sources(package, &named.name, &mut manifest)?;
        self.copy_build_script(package, &named.name, &mut manifest)?;
        self.copy_documents(package, &named.name, &mut manifest)?;
        write(&self.folder.join(&named.name).join("Cargo.toml"), &manifest.to_string())?;
        Ok(named)
    }

    fn named(&self, package: &Path, manifest: &DocumentMut) -> Package {
        let field = |name: &str| manifest["package"][name].as_str().unwrap_or_default();
        let (own, published) = (
            (field("name"), field("version")),
            match &self.naming {
                Naming::OfTheRepository => None,
                Naming::Published(settings) => settings.published(&package.to_string_lossy()),
            },
        );
        let (name, version) = published.unwrap_or(own);
        Package { name: name.to_owned(), version: version.to_owned() }
    }

    fn set_dependency(&self, manifest: &mut DocumentMut, key: &str, package: &Package) {
        let path = format!("../{}", package.name);
        let mut fields = vec![("path", path.as_str()), ("package", &package.name)];
        if let Naming::Published(_) = &self.naming {
            fields.push(("version", &package.version));
        }
        manifest::set_dependency(manifest, key, &fields);
    }

    /// Fields that only a published manifest has.
    fn describe(&self, manifest: &mut DocumentMut, named: &Package) {
        let Naming::Published(settings) = &self.naming else { return };
        let documented: Array = manifest["features"].as_table_like().map_or(Array::new(), |all| {
            DOCUMENTED_FEATURES.into_iter().filter(|feature| all.contains_key(feature)).collect()
        });
        let package = &mut manifest["package"];
        package["name"] = toml_edit::value(&named.name);
        package["version"] = toml_edit::value(&named.version);
        package["documentation"] =
            toml_edit::value(format!("https://docs.rs/{}/{}", named.name, named.version));
        if !settings.repository.is_empty() {
            package["repository"] = toml_edit::value(&settings.repository);
        }
        package["metadata"] = Item::Table(Table::from_iter([("docs", Item::Table(Table::new()))]));
        package["metadata"]["docs"]["rs"]["features"] = toml_edit::value(documented);
    }

    /// Copies the files of the library. The path of a library in a shared source tree becomes one in
    /// `src/`.
    fn copy_sources(
        &self,
        package: &Path,
        name: &str,
        manifest: &mut DocumentMut,
    ) -> Result<(), Failure> {
        let root = match manifest.get("lib").and_then(|lib| lib.get("path")).and_then(Item::as_str)
        {
            Some(path) => package.join(path),
            None => package.join("src/lib.rs"),
        };
        let root = self.repository.join(manifest::without_dots(&root));
        let (Some(from), Some(file)) = (root.parent(), root.file_name()) else { return Ok(()) };
        let file = file.to_string_lossy();
        manifest["lib"]["path"] = toml_edit::value(format!("src/{file}"));
        let unwanted = files_of_the_other_dimension(&file);
        let wanted = |entry: &str| {
            !["tests", "tests.rs", "README.md"].contains(&entry) && !unwanted.contains(&entry)
        };
        copy_tree(from, &self.folder.join(name).join("src"), &wanted)
    }

    /// Copies the build script, if the manifest names one.
    fn copy_build_script(
        &self,
        package: &Path,
        name: &str,
        manifest: &mut DocumentMut,
    ) -> Result<(), Failure> {
        let Some(script) = manifest["package"].get("build").and_then(Item::as_str) else {
            return Ok(());
        };
        let script = manifest::without_dots(&package.join(script));
        copy(&self.repository.join(script), &self.folder.join(name).join("build.rs"))?;
        manifest["package"]["build"] = toml_edit::value("build.rs");
        Ok(())
    }

    fn copy_documents(
        &self,
        package: &Path,
        name: &str,
        manifest: &mut DocumentMut,
    ) -> Result<(), Failure> {
        let folder = self.folder.join(name);
        for licence in ["LICENSE-MIT", "LICENSE-APACHE"] {
            copy(&self.repository.join(licence), &folder.join(licence))?;
        }
        let readme = self.repository.join(package).join("README.md");
        if readme.exists() {
            let text = read(&readme)?;
            let text = match &self.naming {
                Naming::Published(settings) => with_absolute_links(&text, &settings.repository),
                Naming::OfTheRepository => text,
            };
            write(&folder.join("README.md"), &text)?;
            manifest["package"]["readme"] = toml_edit::value("README.md");
        }
        Ok(())
    }

    fn write_workspace(&self) -> Result<(), Failure> {
        let members: Array = self.packages().map(|package| package.name.as_str()).collect();
        let mut manifest = DocumentMut::new();
        manifest["workspace"]["resolver"] = toml_edit::value("3");
        manifest["workspace"]["members"] = toml_edit::value(members);
        manifest["profile"] = self.profiles.clone().unwrap_or(Item::None);
        write(&self.folder.join("Cargo.toml"), &manifest.to_string())
    }
}

/// Files that the crate root of one dimension does not read.
fn files_of_the_other_dimension(root: &str) -> &'static [&'static str] {
    match root {
        "lib2d.rs" => &["lib3d.rs", "dim3", "dim3.rs"],
        "lib3d.rs" => &["lib2d.rs", "dim2", "dim2.rs"],
        _ => &[],
    }
}

/// Points links out of the package's folder into the repository. Without its address, only the text of such
/// a link remains.
fn with_absolute_links(text: &str, repository: &str) -> String {
    let mut result = String::new();
    let mut rest = text;
    while let Some(start) = rest.find("](../") {
        let (before, link) = rest.split_at(start);
        let end = link.find(')').unwrap_or(link.len() - 1);
        let target = link[2..end].trim_start_matches("../");
        if repository.is_empty() {
            let opening = before.rfind('[').unwrap_or(before.len());
            result.push_str(&before[..opening]);
            result.push_str(before.get(opening + 1..).unwrap_or_default());
        } else {
            result.push_str(&format!("{before}]({repository}/blob/main/{target})"));
        }
        rest = &link[end + 1..];
    }
    result + rest
}

#[cfg(test)]
mod tests {
    use super::with_absolute_links;

    #[test]
    fn links_point_into_the_repository_or_vanish() {
        let text = "the [guide](../../docs/guide/a.md) and [itself](#part), [b](../b.md).";
        assert_eq!(
            with_absolute_links(text, "https://example.org/r"),
            "the [guide](https://example.org/r/blob/main/docs/guide/a.md) and [itself](#part), \
             [b](https://example.org/r/blob/main/b.md)."
        );
        assert_eq!(with_absolute_links(text, ""), "the guide and [itself](#part), b.");
    }
}
