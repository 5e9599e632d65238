//! The tables that tests wrote: one file a test and crate, with tabs between cells.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::{fs, io};

/// A table, of one crate at first and then of all crates that have a table with this title and these columns.
pub struct Table {
    /// The title.
    pub title: String,
    /// The names of the columns.
    pub columns: Vec<String>,
    /// Rows, each with the crate's name in the documents.
    pub rows: Vec<(&'static str, Vec<String>)>,
}

/// Tables by the path of the test, with dots between its parts.
pub type Tables = BTreeMap<String, Vec<Table>>;

/// Reads the tables of these crates (folder, name in the documents).
pub fn read(folder: &Path, crates: &[(&str, &'static str)]) -> io::Result<Tables> {
    let mut tables = Tables::new();
    for &(package, name) in crates {
        for entry in fs::read_dir(folder.join(package))? {
            let path = entry?.path();
            let test = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            merge(tables.entry(test).or_default(), &fs::read_to_string(&path)?, name);
        }
    }
    Ok(tables)
}

/// Names of the tests that have a table in one precision of a dimension and lack it in the other: an
/// incomplete run.
pub fn incomplete(tables: &Tables) -> Vec<&str> {
    let builds = |found: &[Table]| -> BTreeSet<&'static str> {
        found.iter().flat_map(|table| table.rows.iter().map(|(name, _)| *name)).collect()
    };
    let lacks = |found: &[Table]| {
        let builds = builds(found);
        ["2D", "3D"]
            .iter()
            .any(|dimension| builds.iter().filter(|name| name.starts_with(dimension)).count() == 1)
    };
    tables.iter().filter(|(_, found)| lacks(found)).map(|(test, _)| test.as_str()).collect()
}

/// Adds the tables of a file to those of the same test in other crates.
fn merge(tables: &mut Vec<Table>, text: &str, name: &'static str) {
    for block in text.split_terminator("\n\n") {
        let mut lines = block.lines();
        let title = lines.next().unwrap_or_default();
        let mut rows = lines.map(|line| line.split('\t').map(str::to_string).collect::<Vec<_>>());
        let columns = rows.next().unwrap_or_default();
        let rows = rows.map(|row| (name, row));
        match tables.iter_mut().find(|table| table.title == title && table.columns == columns) {
            Some(table) => table.rows.extend(rows),
            None => tables.push(Table { title: title.to_string(), columns, rows: rows.collect() }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_of_one_precision_alone_are_reported() {
        let mut tables = Tables::new();
        for (test, build) in [("a.b", "2D f32"), ("a.b", "2D f64"), ("a.c", "3D f32")] {
            merge(tables.entry(test.to_string()).or_default(), "t\nrate\n30\n\n", build);
        }
        assert_eq!(incomplete(&tables), ["a.c"]);
    }

    #[test]
    fn tables_of_two_crates_are_one() {
        let mut tables = Vec::new();
        merge(&mut tables, "fall\nrate\tdrop\n30\t1.5\n60\t1.4\n\nthrow\nrate\n30\n\n", "2D f32");
        merge(&mut tables, "fall\nrate\tdrop\n30\t1.6\n\n", "3D f32");
        assert_eq!(tables.len(), 2);
        assert_eq!(tables[0].columns, ["rate", "drop"]);
        let names: Vec<_> =
            tables[0].rows.iter().map(|(name, row)| (*name, row[1].as_str())).collect();
        assert_eq!(names, [("2D f32", "1.5"), ("2D f32", "1.4"), ("3D f32", "1.6")]);
    }
}
