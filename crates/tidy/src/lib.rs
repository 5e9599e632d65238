//! Checks the source tree against the rules of the house.
//!
//! The compiler checks arrows between crates, not between the rooms of one. This crate checks the rules of
//! CONTRIBUTING.md and docs/architecture.md on the text of the sources and documents. It has a few hundred
//! lines without dependencies, which run with every `cargo test`. The rules and their exceptions:
//!
//! * [`arrows`]: dependencies among rooms.
//! * [`variants`]: one tree without `cfg` on dimension or precision; twins that stay twins.
//! * [`limits`]: lengths of functions and files, headers, unfinished code.
//! * [`danger`]: places of `unsafe`, and its documentation.
//! * [`papers`]: documents that agree with the source.
//! * [`prose`]: comments in the field's language.

pub mod arrows;
pub mod danger;
pub mod limits;
pub mod papers;
pub mod prose;
pub mod source;
pub mod variants;

use core::fmt;
use source::Source;
use std::io;
use std::path::Path;

/// A violation of a rule.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Complaint {
    /// The file, relative to the repository.
    pub file: String,
    /// The line, counted from 1.
    pub line: usize,
    /// The violated rule, and the violation.
    pub what: String,
}

impl Complaint {
    /// A complaint about a line of a file.
    pub fn new(file: &str, line: usize, what: impl Into<String>) -> Self {
        Self { file: file.to_owned(), line, what: what.into() }
    }
}

impl fmt::Display for Complaint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: {}", self.file, self.line, self.what)
    }
}

/// All complaints about the repository at `root`, by file and line.
///
/// # Errors
/// A file or folder cannot be read.
pub fn check(root: &Path) -> io::Result<Vec<Complaint>> {
    let rust = source::read(root, "rs")?;
    let sources: Vec<Source> = rust.iter().map(|(path, text)| Source::new(path, text)).collect();
    let documents = source::read(root, "md")?;

    let mut complaints = arrows::check(&sources);
    complaints.extend(variants::check(&sources));
    complaints.extend(limits::check(&sources));
    complaints.extend(danger::check(&sources));
    complaints.extend(prose::check(&sources));
    complaints.extend(papers::check(root, &sources, &documents));
    complaints.sort();
    Ok(complaints)
}
