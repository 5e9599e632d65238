//! Manifests that stand alone.
//!
//! A manifest of the repository inherits from its workspace, names path dependencies, and points to sources
//! outside its folder. A published manifest can do neither. The functions of this file edit the text with
//! `toml_edit`, so that comments stay.

use crate::Failure;
use crate::files::read;
use std::path::{Component, Path, PathBuf};
use toml_edit::{DocumentMut, InlineTable, Item, Table, TableLike, Value};

/// Parses a manifest.
pub fn parse(place: &Path) -> Result<DocumentMut, Failure> {
    let parsed = read(place)?.parse::<DocumentMut>();
    parsed.map_err(|reason| Failure::Manifest { place: place.into(), reason: reason.to_string() })
}

/// The manifest of the workspace of a package: the nearest one above it with a table `workspace`.
pub fn workspace_of(package: &Path) -> Result<DocumentMut, Failure> {
    for folder in package.ancestors() {
        let place = folder.join("Cargo.toml");
        if place.exists() {
            let manifest = parse(&place)?;
            if manifest.contains_key("workspace") {
                return Ok(manifest);
            }
        }
    }
    let reason = "no workspace above the package".to_owned();
    Err(Failure::Manifest { place: package.into(), reason })
}

/// Replaces everything that the manifest inherits by the values of its workspace.
pub fn inherit(manifest: &mut DocumentMut, workspace: &DocumentMut) {
    let shared = &workspace["workspace"];
    if let Some(package) = manifest.get_mut("package").and_then(Item::as_table_like_mut) {
        inherit_fields(package, shared.get("package"));
    }
    for kind in ["dependencies", "dev-dependencies", "build-dependencies"] {
        if let Some(table) = manifest.get_mut(kind).and_then(Item::as_table_like_mut) {
            inherit_fields(table, shared.get("dependencies"));
        }
    }
    let lints = manifest.get("lints").and_then(|lints| lints.get("workspace"));
    if lints.is_some() {
        manifest["lints"] = shared.get("lints").cloned().unwrap_or(Item::None);
    }
}

fn inherit_fields(table: &mut dyn TableLike, shared: Option<&Item>) {
    for (key, item) in table.iter_mut() {
        let Some(own) = item.as_table_like().filter(|own| own.contains_key("workspace")) else {
            continue;
        };
        let inherited = shared.and_then(|shared| shared.get(key.get())).cloned();
        *item = merged(inherited.unwrap_or(Item::None), own);
    }
}

/// The inherited value with the package's own fields: features add up, other fields are replaced.
fn merged(inherited: Item, own: &dyn TableLike) -> Item {
    if own.len() == 1 {
        return inherited;
    }
    let mut merged = match inherited {
        Item::Value(Value::InlineTable(table)) => table,
        Item::Value(version) => InlineTable::from_iter([("version", version)]),
        _ => InlineTable::new(),
    };
    for (key, value) in own.iter().filter(|(key, _)| *key != "workspace") {
        let Some(value) = value.as_value() else { continue };
        match (key, merged.get_mut(key).and_then(Value::as_array_mut), value.as_array()) {
            ("features", Some(all), Some(more)) => all.extend(more.iter().cloned()),
            _ => drop(merged.insert(key, value.clone())),
        }
    }
    Item::Value(Value::InlineTable(merged))
}

/// The path dependencies of a manifest: the name that the package uses, and the folder, relative to the
/// package's.
pub fn path_dependencies(manifest: &DocumentMut) -> Vec<(String, PathBuf)> {
    let table = manifest.get("dependencies").and_then(Item::as_table_like);
    let all = table.into_iter().flat_map(TableLike::iter);
    let with_path = all.filter_map(|(key, item)| {
        Some((key.to_owned(), PathBuf::from(item.as_table_like()?.get("path")?.as_str()?)))
    });
    with_path.collect()
}

/// Sets the fields of a path dependency.
pub fn set_dependency(manifest: &mut DocumentMut, key: &str, fields: &[(&str, &str)]) {
    let Some(dependency) = manifest["dependencies"][key].as_table_like_mut() else { return };
    for (name, value) in fields {
        dependency.insert(name, toml_edit::value(*value));
    }
}

/// Removes what only the repository needs: tests, examples and their dependencies.
pub fn remove_tests(manifest: &mut DocumentMut) {
    for key in ["test", "example", "bench", "dev-dependencies", "workspace"] {
        manifest.remove(key);
    }
    let package = manifest["package"].or_insert(Item::Table(Table::new()));
    for key in ["autotests", "autoexamples", "autobenches"] {
        package[key] = toml_edit::value(false);
    }
}

/// A path without `..`, by its text alone.
pub fn without_dots(path: &Path) -> PathBuf {
    let mut plain = PathBuf::new();
    for part in path.components() {
        match part {
            Component::ParentDir => drop(plain.pop()),
            Component::CurDir => {}
            other => plain.push(other),
        }
    }
    plain
}
