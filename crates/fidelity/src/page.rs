//! A document: a section for each file of tests, a part for each law.

use crate::area::Area;
use crate::statements::{Test, TestFile};
use crate::tables::{Table, Tables};
use std::collections::BTreeMap;

/// The document of an area. Tests without a table are left out.
///
/// # Errors
/// Two tests have one table, or a table of the area has no test.
pub fn write(area: &Area, files: &[TestFile], tables: &Tables) -> Result<String, String> {
    let mut own: BTreeMap<&str, &[Table]> = BTreeMap::new();
    for (path, found) in tables.iter().filter(|(path, _)| area.contains(path)) {
        own.insert(path, found);
    }
    let mut text = format!(
        "# {}\n\nWritten by `cargo run -p fidelity` from the tests in `tests/{}/`. [How to read these pages](README.md)\n",
        area.title, area.folder
    );
    for file in files {
        let found: Vec<_> = file
            .tests
            .iter()
            .filter_map(|test| Some((test, take(&mut own, &file.key(test))?)))
            .collect();
        if !found.is_empty() {
            text += &section(file, &found);
        }
    }
    match own.keys().next() {
        Some(path) => Err(format!("no file of tests/{} has the test {path}", area.folder)),
        None => Ok(text),
    }
}

/// Takes the tables of the test whose path ends with this key.
fn take<'a>(own: &mut BTreeMap<&str, &'a [Table]>, key: &str) -> Option<&'a [Table]> {
    let end = format!(".{key}");
    let path = *own.keys().find(|path| path.ends_with(&end))?;
    own.remove(path)
}

fn section(file: &TestFile, tests: &[(&Test, &[Table])]) -> String {
    let mut text = format!("\n## {}\n", file.subject);
    if !file.text.is_empty() {
        text += &format!("\n{}\n", file.text);
    }
    for (test, found) in tests {
        text += &format!("\n### {}\n", heading(&found[0].title));
        if !test.law.is_empty() {
            text += &format!("\n{}\n", test.law);
        }
        for (at, table) in found.iter().enumerate() {
            if at > 0 {
                text += &format!("\n{}:\n", heading(&table.title));
            }
            text += &shown(table);
        }
        text += &format!("\nTest `{}` in `{}`.\n", test.name, file.path);
    }
    text
}

/// A title with a capital letter.
fn heading(title: &str) -> String {
    let mut letters = title.chars();
    letters
        .next()
        .map(|first| first.to_uppercase().collect::<String>() + letters.as_str())
        .unwrap_or_default()
}

/// Tables with more rows are folded.
const ROWS_MAX: usize = 24;

/// A table, folded if it is long.
fn shown(table: &Table) -> String {
    let text = markdown(table);
    let rows = table.rows.len();
    if rows <= ROWS_MAX {
        return text;
    }
    format!("\n<details>\n<summary>{rows} rows</summary>\n{text}\n</details>\n")
}

/// The rows of all crates, with the crate in the first column.
fn markdown(table: &Table) -> String {
    let row = |first: &str, cells: &[String]| {
        let cells: Vec<_> = cells.iter().map(|cell| cell.replace('|', "\\|")).collect();
        format!("| {first} | {} |\n", cells.join(" | ").trim())
    };
    let mut text = format!(
        "\n{}| --- |{}\n",
        row("build", &table.columns),
        " --: |".repeat(table.columns.len())
    );
    for (name, cells) in &table.rows {
        text += &row(name, cells);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_law_stands_above_its_figures() {
        let area = Area { folder: "a", filters: &["suite::a"], page: "a.md", title: "A" };
        let test = Test { name: "fall".into(), law: "It drops.".into() };
        let file = TestFile {
            path: "tests/a/b.rs".into(),
            subject: "Fall".into(),
            text: String::new(),
            tests: vec![test],
        };
        let rows = vec![("2D f32", vec!["30".to_string(), "1.5".to_string()])];
        let table =
            Table { title: "free fall".into(), columns: vec!["rate".into(), "drop".into()], rows };
        let text =
            write(&area, &[file], &Tables::from([("suite.a.b.fall".to_string(), vec![table])]))
                .expect("one test has the table");
        let law = text.find("### Free fall\n\nIt drops.\n").expect("the law");
        let figures = text
            .find("| build | rate | drop |\n| --- | --: | --: |\n| 2D f32 | 30 | 1.5 |")
            .expect("the figures");
        assert!(law < figures);
    }

    #[test]
    fn a_table_without_a_test_is_reported() {
        let area = Area { folder: "a", filters: &["suite::a"], page: "a.md", title: "A" };
        let tables = |path: &str| Tables::from([(path.to_string(), Vec::new())]);
        assert!(write(&area, &[], &tables("suite.a.b.fall")).is_err());
        assert!(write(&area, &[], &tables("suite.other.b.fall")).is_ok());
    }

    #[test]
    fn long_tables_are_folded() {
        let table = |count| {
            let rows = vec![("2D f32", vec!["30".to_string()]); count];
            Table { title: "fall".into(), columns: vec!["rate".into()], rows }
        };
        assert!(!shown(&table(ROWS_MAX)).contains("<details>"));
        assert!(
            shown(&table(ROWS_MAX + 1)).contains("<summary>25 rows</summary>\n\n| build | rate |")
        );
    }
}
