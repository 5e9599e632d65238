//! Documents that agree with the source: links and paths exist, named functions are in their file, and the
//! table of stages equals the stages' cards.

use crate::Complaint;
use crate::source::Source;
use std::path::Path;

/// Prefixes of paths of the repository in backticks.
const PLACES: [&str; 8] =
    ["src/", "crates/", "tests/", "examples2d/", "examples3d/", "docs/", ".ci/", ".github"];
/// The document with the table of stages.
const STEP: &str = "docs/step.md";
const TABLE_BEGINS: &str = "<!-- stages: from the first lines of src/step/*/mod.rs -->";
const TABLE_ENDS: &str = "<!-- end of stages -->";
/// Entries of a stage's card, in this order.
const CARD: [&str; 4] = ["Reads", "Writes", "Runs", "Never"];

/// Complains of broken links and paths, and of a table of stages that differs from the cards.
pub fn check(root: &Path, sources: &[Source], documents: &[(String, String)]) -> Vec<Complaint> {
    let mut complaints = Vec::new();
    for (path, text) in documents {
        for (line, target) in targets(path, text) {
            if !exists(root, &target) {
                complaints.push(Complaint::new(path, line, format!("there is no {target}")));
            }
        }
    }
    let (table, missing) = table(sources);
    complaints.extend(missing);
    if let Some((_, text)) = documents.iter().find(|(path, _)| path == STEP) {
        complaints.extend(check_table(text, &table));
    }
    complaints
}

/// Returns whether there is such a file or folder or, behind `::`, such a function in it.
fn exists(root: &Path, target: &str) -> bool {
    match target.split_once("::") {
        None => root.join(target).exists(),
        Some((file, name)) => std::fs::read_to_string(root.join(file))
            .is_ok_and(|text| text.contains(&format!("fn {name}("))),
    }
}

/// Every path of the repository in a document, with its line.
fn targets(path: &str, text: &str) -> Vec<(usize, String)> {
    let folder = Path::new(path).parent().unwrap_or(Path::new(""));
    let mut targets = Vec::new();
    let mut fenced = false;
    for (number, line) in text.lines().enumerate() {
        if line.trim_start().starts_with("```") {
            fenced = !fenced;
        }
        if fenced {
            continue;
        }
        for link in line.split("](").skip(1) {
            let target = link.split([')', '#', ' ']).next().unwrap_or("");
            if !target.is_empty() && !target.contains(':') {
                targets.push((number + 1, folder.join(target).to_string_lossy().into_owned()));
            }
        }
        for quoted in line.split('`').skip(1).step_by(2) {
            let place = PLACES.iter().any(|place| quoted.starts_with(place));
            if place && !quoted.contains(['*', '<', '{', ' ', '…', '$']) {
                let target = if quoted.contains("::") {
                    quoted
                } else {
                    quoted.split([':', '#']).next().unwrap_or("")
                };
                targets.push((number + 1, target.to_owned()));
            }
        }
    }
    targets
}

/// The table of stages according to the cards, and complaints about incomplete cards.
fn table(sources: &[Source]) -> (Vec<String>, Vec<Complaint>) {
    let mut complaints = Vec::new();
    let mut rows = vec![
        "| # | stage | reads | writes | runs | never |".to_owned(),
        "|--:|---|---|---|---|---|".to_owned(),
    ];
    for stage in stages(sources) {
        let path = format!("src/step/{stage}/mod.rs");
        let Some(source) = sources.iter().find(|source| source.path == path) else { continue };
        let mut row = format!("| {} | `{stage}` |", rows.len() - 1);
        for entry in CARD {
            let says = card_entry(&source.text, entry);
            if says.is_empty() {
                let what = format!("the stage's card lacks `//! {entry}:`");
                complaints.push(Complaint::new(&path, 1, what));
            }
            row.push_str(&format!(" {says} |"));
        }
        rows.push(row);
    }
    (rows, complaints)
}

/// The stages in the order in which `step/mod.rs` declares them, which is the execution order.
fn stages(sources: &[Source]) -> Vec<String> {
    let Some(step) = sources.iter().find(|source| source.path == "src/step/mod.rs") else {
        return Vec::new();
    };
    let tokens = (0..step.tokens.len()).filter(|&at| step.token(at) == "mod");
    let names = tokens.map(|at| step.token(at + 1).to_owned());
    let is_folder = |name: &String| {
        sources.iter().any(|source| source.path == format!("src/step/{name}/mod.rs"))
    };
    names.filter(is_folder).filter(|name| name != "tests").collect()
}

/// The text of a card's entry; indented lines continue it.
fn card_entry(text: &str, entry: &str) -> String {
    let card = text.lines().map_while(|line| line.strip_prefix("//!"));
    let mut lines = card.map(|line| line.strip_prefix(' ').unwrap_or(line));
    let Some(first) = lines.find_map(|line| line.strip_prefix(entry)?.strip_prefix(':')) else {
        return String::new();
    };
    let rest = lines.take_while(|line| line.starts_with("  "));
    let parts: Vec<&str> = core::iter::once(first).chain(rest).map(str::trim).collect();
    parts.join(" ")
}

fn check_table(text: &str, table: &[String]) -> Option<Complaint> {
    let mut lines = text.lines().enumerate();
    let Some((begin, _)) = lines.find(|(_, line)| *line == TABLE_BEGINS) else {
        return Some(Complaint::new(STEP, 1, format!("lacks the line {TABLE_BEGINS}")));
    };
    let stands: Vec<&str> = lines
        .map(|(_, line)| line)
        .take_while(|line| *line != TABLE_ENDS)
        .filter(|line| !line.is_empty())
        .collect();
    (stands != table).then(|| {
        let table = table.join("\n");
        Complaint::new(STEP, begin + 1, format!("is not what the cards say, which is\n{table}"))
    })
}

#[cfg(test)]
mod tests {
    use super::{TABLE_BEGINS, TABLE_ENDS, check_table, exists, table, targets};
    use crate::source::Source;
    use std::path::Path;

    #[test]
    fn links_and_paths_are_found() {
        let text =
            "[a](b.md#c) [web](https://d.e) `src/f.rs` `src/*/g.rs` `h`\n```\n`src/i.rs`\n```";
        let found = targets("docs/page.md", text);
        assert_eq!(found, [(1, "docs/b.md".to_owned()), (1, "src/f.rs".to_owned())]);
    }

    #[test]
    fn functions_are_searched() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        assert!(
            exists(root, "src/papers.rs") && exists(root, "src/papers.rs::functions_are_searched")
        );
        assert!(
            !exists(root, "src/paper.rs") && !exists(root, "src/papers.rs::functions_are_lost")
        );
    }

    fn house(card: &str) -> [Source; 3] {
        [
            Source::new("src/step/mod.rs", "mod notes;\nmod solver;"),
            Source::new("src/step/notes.rs", "//! Notes."),
            Source::new("src/step/solver/mod.rs", card),
        ]
    }

    const WHOLE: &str = "//! # Solver\n//!\n//! Reads:   a,\n//!     b\n//! Writes:  c\n//! Runs:    d\n//! Never:   e\n";

    #[test]
    fn the_table_repeats_the_cards() {
        let (rows, complaints) = table(&house(WHOLE));
        assert!(complaints.is_empty());
        assert_eq!(rows[2..], ["| 1 | `solver` | a, b | c | d | e |"]);
        let page = |rows: &[String]| {
            format!("# Step\n{TABLE_BEGINS}\n\n{}\n{TABLE_ENDS}\n", rows.join("\n"))
        };
        assert_eq!(check_table(&page(&rows), &rows), None);
        assert!(check_table(&page(&rows[..2]), &rows).is_some());
        assert!(check_table("# Step\n", &rows).is_some());
    }

    #[test]
    fn a_card_is_whole() {
        let (_, complaints) = table(&house("//! # Solver\n//! Reads: a\n"));
        assert_eq!(complaints.len(), 3);
    }
}
