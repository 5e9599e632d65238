//! Tables of figures in the output of tests. `crates/fidelity` makes the documents of `docs/fidelity/` from
//! them.

use crate::dim;
use rapier::math::Real;
use std::collections::BTreeSet;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use std::{env, fs, io, thread};

/// Environment variable with the folder for copies of all tables.
const TABLES: &str = "FIDELITY_TABLES";

/// The files that this run has written.
static WRITTEN: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

/// Rows of text in aligned columns, and the rows' failures. The drop prints the table, so that all rows of a
/// failing test are visible.
pub struct Table {
    title: String,
    rows: Vec<Vec<String>>,
    problems: Vec<String>,
}

impl Table {
    /// Creates a table with this title and these columns.
    pub fn new(title: &str, columns: &[&str]) -> Self {
        let head = columns.iter().map(|column| column.to_string()).collect();
        Self { title: title.to_string(), rows: vec![head], problems: Vec::new() }
    }

    /// Adds a row.
    pub fn row<const N: usize>(&mut self, cells: [String; N]) {
        assert_eq!(N, self.rows[0].len(), "as many cells as columns");
        self.rows.push(cells.into());
    }

    /// Fails the test, once the table is complete, unless `figure` of the last row is within `tolerance` of
    /// `expected`.
    pub fn check(&mut self, what: &str, figure: Real, expected: Real, tolerance: Real) {
        let near = (figure - expected).abs() <= tolerance;
        self.require(near, &format!("{what} is {figure}, not {expected} ± {tolerance}"));
    }

    /// Fails the test, once the table is complete, unless `holds` is true of the last row.
    pub fn require(&mut self, holds: bool, problem: &str) {
        if !holds {
            let row = self.rows.last().map(|row| row.join(" ")).unwrap_or_default();
            self.problems.push(format!("[{row}] {problem}"));
        }
    }
}

impl Drop for Table {
    fn drop(&mut self) {
        println!("{}", self.text());
        if thread::panicking() {
            return;
        }
        if !self.problems.is_empty() {
            panic!("\n{}", self.problems.join("\n"));
        }
        if let Some(folder) = env::var_os(TABLES) {
            self.save(folder.as_ref()).expect("the folder of tables can be written");
        }
    }
}

impl Table {
    /// Returns the title and the rows in aligned columns.
    fn text(&self) -> String {
        let width = |column: usize| self.rows.iter().map(|row| row[column].chars().count()).max();
        let widths: Vec<usize> = (0..self.rows[0].len()).filter_map(width).collect();
        let mut text = format!("\n{} ({} f{})", self.title, dim::NAME, 8 * size_of::<Real>());
        for row in &self.rows {
            let cells = row.iter().zip(&widths).map(|(cell, &width)| format!("{cell:>width$}"));
            text += &format!("\n  {}", cells.collect::<Vec<_>>().join("  "));
        }
        text
    }

    /// Writes the title and the rows, with tabs between cells, into a file with the name of the test, behind
    /// other tables of the test.
    fn save(&self, folder: &Path) -> io::Result<()> {
        let folder = folder.join(env!("CARGO_PKG_NAME"));
        fs::create_dir_all(&folder)?;
        let test = thread::current().name().unwrap_or("unnamed").replace("::", ".");
        let path = folder.join(test);
        // Tables of an earlier run are replaced.
        let is_first = WRITTEN.lock().unwrap_or_else(PoisonError::into_inner).insert(path.clone());
        let mut file = fs::OpenOptions::new()
            .create(true)
            .write(true)
            .truncate(is_first)
            .append(!is_first)
            .open(path)?;
        let rows: String = self.rows.iter().map(|row| row.join("\t") + "\n").collect();
        write!(file, "{}\n{rows}\n", self.title)
    }
}
