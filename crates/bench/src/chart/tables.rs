//! Tables of a page in Markdown, each below its chart.

/// Table below a chart.
pub(super) struct Table<'p> {
    /// Title of the chart.
    pub title: &'p str,
    /// File of the chart.
    pub file: &'p str,
    columns: Vec<&'p str>,
    rows: Vec<Vec<&'p str>>,
}

impl<'p> Table<'p> {
    /// Returns the position of a column.
    pub(super) fn column(&self, name: &str) -> Option<usize> {
        self.columns.iter().position(|column| *column == name)
    }

    /// Returns the cells of some columns, row by row.
    ///
    /// # Errors
    /// The table has no such column.
    pub(super) fn cells<const N: usize>(
        &self,
        names: [&str; N],
    ) -> Result<Vec<[&'p str; N]>, String> {
        let missing = |name| format!("the table of {} has no column {name}", self.file);
        let mut columns = [0; N];
        for (column, name) in columns.iter_mut().zip(names) {
            *column = self.column(name).ok_or_else(|| missing(name))?;
        }
        let cell = |row: &Vec<&'p str>, column| row.get(column).copied().unwrap_or_default();
        Ok(self.rows.iter().map(|row| columns.map(|column| cell(row, column))).collect())
    }
}

/// Returns the first table below each chart of a page.
pub(super) fn illustrated(page: &str) -> Vec<Table<'_>> {
    let mut found: Vec<Table<'_>> = Vec::new();
    let mut chart = None;
    let mut is_inside = false;
    for line in page.lines() {
        chart = chart_of(line).or(chart);
        let Some(cells) = line.strip_prefix('|') else {
            is_inside = false;
            continue;
        };
        let cells = cells.trim_end_matches('|').split('|').map(str::trim).collect();
        if let (false, Some((title, file))) = (is_inside, chart.take()) {
            found.push(Table { title, file, columns: cells, rows: Vec::new() });
            is_inside = true;
        } else if let (true, false, Some(table)) =
            (is_inside, line.starts_with("| --"), found.last_mut())
        {
            table.rows.push(cells);
        }
    }
    found
}

/// Returns title and file of a chart: `![title](name.svg)`.
fn chart_of(line: &str) -> Option<(&str, &str)> {
    let (title, file) = line.strip_prefix("![")?.strip_suffix(')')?.split_once("](")?;
    file.ends_with(".svg").then_some((title, file))
}

/// Returns the number in a cell. Spaces separate thousands.
pub(super) fn number(cell: &str) -> Result<f64, String> {
    let digits: String = cell.chars().filter(|c| !c.is_whitespace()).collect();
    digits.parse().map_err(|_| format!("`{cell}` is no number"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_belong_to_the_chart_above() {
        let page = "![A](a.svg)\n\n## Figures\n\n| x | y |\n| --- | --: |\n| p | 1 000 |\n| q | 2 |\n\n| z |\n| -- |\n| 3 |\n\n![B](b.svg)\n| w |\n| -- |\n";
        let tables = illustrated(page);
        assert_eq!(tables.iter().map(|table| table.file).collect::<Vec<_>>(), ["a.svg", "b.svg"]);
        assert_eq!(tables[0].cells(["y", "x"]).unwrap(), [["1 000", "p"], ["2", "q"]]);
        assert!(tables[0].cells(["z"]).unwrap_err().contains("no column z"));
        assert_eq!((number("1 000"), number("x").is_err()), (Ok(1000.0), true));
    }
}
