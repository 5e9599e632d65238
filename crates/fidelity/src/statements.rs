//! The laws that tests state: doc comments of test functions, and of their files.

use std::path::Path;
use std::{fs, io};

/// A file of tests.
pub struct TestFile {
    /// Path below the repository's root.
    pub path: String,
    /// The first paragraph of the file's documentation: the subject.
    pub subject: String,
    /// The other paragraphs.
    pub text: String,
    /// The tests, in their order.
    pub tests: Vec<Test>,
}

impl TestFile {
    /// Module and name of a test: the last two parts of its path.
    pub fn key(&self, test: &Test) -> String {
        let mut parts = self.path.trim_end_matches(".rs").trim_end_matches("/mod").rsplit('/');
        format!("{}.{}", parts.next().unwrap_or_default(), test.name)
    }
}

/// A test function.
pub struct Test {
    /// The function's name.
    pub name: String,
    /// The function's documentation.
    pub law: String,
}

/// Reads all files of a folder below `tests/`, in the order of their names.
pub fn read(root: &Path, folder: &str) -> io::Result<Vec<TestFile>> {
    let mut paths: Vec<_> = fs::read_dir(root.join("tests").join(folder))?
        .map(|entry| Ok(entry?.path()))
        .collect::<io::Result<_>>()?;
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "rs"));
    paths.sort();
    let file = |path: &std::path::PathBuf| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        Ok(parse(&format!("tests/{folder}/{name}"), &fs::read_to_string(path)?))
    };
    paths.iter().map(file).collect()
}

fn parse(path: &str, text: &str) -> TestFile {
    let documentation = joined(text.lines().map_while(|line| line.strip_prefix("//!")));
    let (subject, rest) = documentation.split_once("\n\n").unwrap_or((&documentation, ""));
    let lines: Vec<&str> = text.lines().collect();
    let tests = (0..lines.len())
        .filter(|&at| lines[at].trim() == "#[test]")
        .filter_map(|at| test_at(&lines, at));
    TestFile {
        path: path.to_string(),
        subject: subject.trim_end_matches('.').replace('\n', " "),
        text: rest.to_string(),
        tests: tests.collect(),
    }
}

/// The test with the attribute in this line.
fn test_at(lines: &[&str], attribute: usize) -> Option<Test> {
    let head = lines[attribute + 1..].iter().find(|line| !line.starts_with('#'))?;
    let name = head.trim_start_matches("pub ").strip_prefix("fn ")?.split('(').next()?;
    let above = lines[..attribute].iter().rev();
    let mut comment: Vec<&str> = above.map_while(|line| line.strip_prefix("///")).collect();
    comment.reverse();
    Some(Test { name: name.to_string(), law: joined(comment.into_iter()) })
}

/// Lines of a comment as text, without the blank that follows the marks.
fn joined<'a>(lines: impl Iterator<Item = &'a str>) -> String {
    let lines: Vec<&str> = lines.map(|line| line.strip_prefix(' ').unwrap_or(line)).collect();
    lines.join("\n").trim().to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILE: &str = "//! Free fall.\n//!\n//! More.\n\nuse x;\n\n/// A law\n/// in two lines.\n#[test]\n\
                        #[cfg_attr(miri, ignore)]\nfn free_fall() {}\n\nfn helper() {}\n\n#[test]\nfn silent() {}\n";

    #[test]
    fn doc_comments_are_found_with_their_tests() {
        let file = parse("tests/a/b.rs", FILE);
        assert_eq!((file.subject.as_str(), file.text.as_str()), ("Free fall", "More."));
        let found: Vec<_> =
            file.tests.iter().map(|test| (test.name.as_str(), test.law.as_str())).collect();
        assert_eq!(found, [("free_fall", "A law\nin two lines."), ("silent", "")]);
    }
}
