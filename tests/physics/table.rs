//! Tables of figures in the output of tests.

use crate::dim;
use rapier::math::Real;

/// Rows of text in aligned columns. Printed when it is dropped, so that a failing test shows it, too.
pub struct Table {
    rows: Vec<Vec<String>>,
}

impl Table {
    /// A table of this title and these columns.
    pub fn new(title: &str, columns: &[&str]) -> Self {
        println!("\n{title} ({} f{})", dim::NAME, 8 * size_of::<Real>());
        Self { rows: vec![columns.iter().map(|column| column.to_string()).collect()] }
    }

    /// Adds a row.
    pub fn row<const N: usize>(&mut self, cells: [String; N]) {
        assert_eq!(N, self.rows[0].len(), "as many cells as columns");
        self.rows.push(cells.into());
    }
}

impl Drop for Table {
    fn drop(&mut self) {
        let width = |column: usize| self.rows.iter().map(|row| row[column].len()).max();
        let widths: Vec<usize> = (0..self.rows[0].len()).filter_map(width).collect();
        for row in &self.rows {
            let cells = row.iter().zip(&widths).map(|(cell, &width)| format!("{cell:>width$}"));
            println!("  {}", cells.collect::<Vec<_>>().join("  "));
        }
    }
}
