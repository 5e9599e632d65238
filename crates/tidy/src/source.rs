//! Files, and the code of a Rust file.

use std::fs;
use std::io;
use std::path::Path;

/// Folders of the repository's own text; build outputs and package folders are excluded.
const FOLDERS: [&str; 7] = ["src", "crates", "tests", "examples2d", "examples3d", "fuzz", "docs"];
const SKIPPED: [&str; 3] = ["target", "node_modules", "pkg"];

/// All files with an extension, with paths relative to `root`, in the order of their paths.
///
/// # Errors
/// A file or folder cannot be read.
pub fn read(root: &Path, extension: &str) -> io::Result<Vec<(String, String)>> {
    let mut files = Vec::new();
    for entry in fs::read_dir(root)? {
        let path = entry?.path();
        if path.extension().is_some_and(|e| e == extension) {
            files.push(path);
        }
    }
    for folder in FOLDERS {
        let folder = root.join(folder);
        if folder.is_dir() {
            walk(&folder, extension, &mut files)?;
        }
    }
    files.sort();
    files
        .iter()
        .map(|path| {
            let relative = path.strip_prefix(root).unwrap_or(path);
            Ok((relative.to_string_lossy().replace('\\', "/"), fs::read_to_string(path)?))
        })
        .collect()
}

fn walk(folder: &Path, extension: &str, files: &mut Vec<std::path::PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        let name = path.file_name().unwrap_or_default();
        if path.is_dir() {
            if !SKIPPED.iter().any(|skipped| name == *skipped) {
                walk(&path, extension, files)?;
            }
        } else if path.extension().is_some_and(|e| e == extension) {
            files.push(path);
        }
    }
    Ok(())
}

/// A word, a `::`, or a single sign of code.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Token {
    /// The line, counted from 1.
    pub line: usize,
    /// The text.
    pub text: String,
}

/// A Rust file.
#[derive(Clone, Debug)]
pub struct Source {
    /// Relative to the repository.
    pub path: String,
    /// The text of the file.
    pub text: String,
    /// Without comments.
    pub bare: String,
    /// The tokens, without comments and without the contents of strings.
    pub tokens: Vec<Token>,
}

impl Source {
    /// Reads a file's text.
    pub fn new(path: &str, text: &str) -> Self {
        let bare = blank(text, false);
        let tokens = tokens(&blank(text, true));
        Self { path: path.to_owned(), text: text.to_owned(), bare, tokens }
    }

    /// Returns the path within `src/` if this is a file of the engine.
    pub fn in_engine(&self) -> Option<&str> {
        self.path.strip_prefix("src/")
    }

    /// The text of a token; empty past the end.
    pub fn token(&self, index: usize) -> &str {
        self.tokens.get(index).map_or("", |token| &token.text)
    }
}

/// Replaces comments by blanks, and the contents of strings if `strings`. Line numbers are kept.
fn blank(text: &str, strings: bool) -> String {
    let chars: Vec<char> = text.chars().collect();
    let mut out = String::with_capacity(text.len());
    let mut at = 0;
    while at < chars.len() {
        let (end, keep) = match piece(&chars, at) {
            Piece::Code => (at + 1, true),
            Piece::Comment(end) => (end, false),
            Piece::String(end) => (end, !strings),
        };
        out.extend(chars[at..end].iter().map(|&c| if keep || c == '\n' { c } else { ' ' }));
        at = end;
    }
    out
}

/// The kind of text at a character, with its end.
enum Piece {
    Code,
    Comment(usize),
    String(usize),
}

fn piece(chars: &[char], at: usize) -> Piece {
    let next = chars.get(at + 1).copied();
    match chars[at] {
        '/' if next == Some('/') => Piece::Comment(line_end(chars, at)),
        '/' if next == Some('*') => Piece::Comment(block_end(chars, at)),
        '"' => Piece::String(string_end(chars, at)),
        '\'' => char_end(chars, at).map_or(Piece::Code, Piece::String),
        'r' if at == 0 || !is_word(chars[at - 1]) || chars[at - 1] == 'b' => {
            raw_end(chars, at).map_or(Piece::Code, Piece::String)
        }
        _ => Piece::Code,
    }
}

fn line_end(chars: &[char], at: usize) -> usize {
    (at..chars.len()).find(|&i| chars[i] == '\n').unwrap_or(chars.len())
}

fn block_end(chars: &[char], at: usize) -> usize {
    let (mut depth, mut i) = (0, at);
    while i + 1 < chars.len() {
        match (chars[i], chars[i + 1]) {
            ('/', '*') => (depth, i) = (depth + 1, i + 2),
            ('*', '/') => (depth, i) = (depth - 1, i + 2),
            _ => i += 1,
        }
        if depth == 0 {
            return i;
        }
    }
    chars.len()
}

fn string_end(chars: &[char], at: usize) -> usize {
    let mut i = at + 1;
    while i < chars.len() && chars[i] != '"' {
        i += if chars[i] == '\\' { 2 } else { 1 };
    }
    (i + 1).min(chars.len())
}

/// The end of a character literal; `None` for a lifetime.
fn char_end(chars: &[char], at: usize) -> Option<usize> {
    match chars.get(at + 1)? {
        '\\' => (at + 3..chars.len()).find(|&i| chars[i] == '\'').map(|i| i + 1),
        _ => (chars.get(at + 2) == Some(&'\'')).then_some(at + 3),
    }
}

/// The end of `r"…"` or `r#"…"#`; `None` if `r` begins a word.
fn raw_end(chars: &[char], at: usize) -> Option<usize> {
    let hashes = chars[at + 1..].iter().take_while(|&&c| c == '#').count();
    let open = at + 1 + hashes;
    if chars.get(open) != Some(&'"') {
        return None;
    }
    let closes = |i: usize| {
        chars[i] == '"' && chars[i + 1..].iter().take_while(|&&c| c == '#').count() >= hashes
    };
    Some((open + 1..chars.len()).find(|&i| closes(i)).map_or(chars.len(), |i| i + 1 + hashes))
}

fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

fn tokens(code: &str) -> Vec<Token> {
    let mut tokens: Vec<Token> = Vec::new();
    for (number, line) in code.lines().enumerate() {
        let mut rest = line.trim_start();
        while let Some(first) = rest.chars().next() {
            let length = match first {
                c if is_word(c) => rest.find(|c| !is_word(c)).unwrap_or(rest.len()),
                ':' if rest.starts_with("::") => 2,
                c => c.len_utf8(),
            };
            tokens.push(Token { line: number + 1, text: rest[..length].to_owned() });
            rest = rest[length..].trim_start();
        }
    }
    tokens
}

#[cfg(test)]
mod tests {
    use super::Source;

    fn words(text: &str) -> Vec<String> {
        Source::new("a.rs", text).tokens.into_iter().map(|token| token.text).collect()
    }

    #[test]
    fn comments_and_strings_are_not_code() {
        assert_eq!(words("a // b\n/* c /* d */ e */ f"), ["a", "f"]);
        assert_eq!(words(r#"g("h \" i", 'j', '\'', b'k')"#), ["g", "(", ",", ",", ",", "b", ")"]);
        assert_eq!(words("x(r#\"l \" m\"#, r\"n\")"), ["x", "(", ",", ")"]);
    }

    #[test]
    fn lifetimes_and_paths_are_code() {
        assert_eq!(words("&'a crate::b"), ["&", "'", "a", "crate", "::", "b"]);
    }

    #[test]
    fn lines_stay_where_they_are() {
        let source = Source::new("a.rs", "/* 1\n2 */ \"3\n4\" end");
        assert_eq!(source.tokens.last().map(|token| token.line), Some(3));
    }

    #[test]
    fn strings_stay_in_what_is_only_bare_of_comments() {
        assert_eq!(Source::new("a.rs", "a \"b\" // c").bare.trim_end(), "a \"b\"");
    }
}
