//! Tables of figures in the output of tests.

use crate::dim;
use rapier::math::Real;

/// Rows of text in aligned columns, and what is wrong with them. Printed when it is dropped, so that
/// all rows of a failing test are seen.
pub struct Table {
    rows: Vec<Vec<String>>,
    problems: Vec<String>,
}

impl Table {
    /// A table of this title and these columns.
    pub fn new(title: &str, columns: &[&str]) -> Self {
        println!("\n{title} ({} f{})", dim::NAME, 8 * size_of::<Real>());
        let head = columns.iter().map(|column| column.to_string()).collect();
        Self { rows: vec![head], problems: Vec::new() }
    }

    /// Adds a row.
    pub fn row<const N: usize>(&mut self, cells: [String; N]) {
        assert_eq!(N, self.rows[0].len(), "as many cells as columns");
        self.rows.push(cells.into());
    }

    /// Fails the test, once the table is complete, unless `figure` of the last row is within
    /// `tolerance` of what it should be.
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
        let width = |column: usize| self.rows.iter().map(|row| row[column].chars().count()).max();
        let widths: Vec<usize> = (0..self.rows[0].len()).filter_map(width).collect();
        for row in &self.rows {
            let cells = row.iter().zip(&widths).map(|(cell, &width)| format!("{cell:>width$}"));
            println!("  {}", cells.collect::<Vec<_>>().join("  "));
        }
        if !std::thread::panicking() && !self.problems.is_empty() {
            panic!("\n{}", self.problems.join("\n"));
        }
    }
}
