//! Lengths of functions and files, headers, unfinished code.

use crate::Complaint;
use crate::source::Source;
use core::ops::Range;

/// Lines of a file, all counted.
const FILE_LINES: usize = 500;
/// Lines of a function from `fn` to its last brace, without blank lines and comments.
const FUNCTION_LINES: usize = 64;

/// Parameters of a function, each field of a tuple counted. Clippy counts a tuple as one parameter.
const PARAMETERS: usize = 7;

/// Files that may be longer, with the reason.
const LONG_FILES: [(&str, &str); 0] = [];
/// Functions that may be longer, with their files and the reason.
const LONG_FUNCTIONS: [(&str, &str, &str); 0] = [];

/// Complains of files and functions that are too long, that have no header or too many parameters, or that
/// are unfinished.
pub fn check(sources: &[Source]) -> Vec<Complaint> {
    let mut complaints = Vec::new();
    for source in sources {
        check_file(source, &mut complaints);
        check_functions(source, &mut complaints);
        check_parameters(source, &mut complaints);
        check_finished(source, &mut complaints);
    }
    complaints
}

fn check_file(source: &Source, complaints: &mut Vec<Complaint>) {
    if !source.text.starts_with("//! ") {
        complaints.push(Complaint::new(
            &source.path,
            1,
            "does not begin with `//!`: state its content and its reasons",
        ));
    }
    let lines = source.text.lines().count();
    let listed = LONG_FILES.iter().any(|(path, _)| *path == source.path);
    if lines > FILE_LINES && !listed {
        let what = format!("{lines} lines, more than {FILE_LINES}");
        complaints.push(Complaint::new(&source.path, lines, what));
    }
    if lines <= FILE_LINES && listed {
        complaints.push(Complaint::new(&source.path, lines, "is listed as a long file but is not"));
    }
}

fn check_functions(source: &Source, complaints: &mut Vec<Complaint>) {
    let code: Vec<&str> = source.bare.lines().collect();
    for at in 0..source.tokens.len() {
        let Some((first, last)) = function_at(source, at) else { continue };
        let lines = code[first - 1..last].iter().filter(|line| !line.trim().is_empty()).count();
        let name = source.token(at + 1);
        let listed =
            LONG_FUNCTIONS.iter().any(|(path, long, _)| *path == source.path && *long == name);
        if lines > FUNCTION_LINES && !listed {
            let what = format!("{name}: {lines} lines, more than {FUNCTION_LINES}");
            complaints.push(Complaint::new(&source.path, first, what));
        }
    }
}

fn check_parameters(source: &Source, complaints: &mut Vec<Complaint>) {
    for at in 0..source.tokens.len() {
        let Some(count) = parameters_of(source, at) else { continue };
        if count > PARAMETERS {
            let name = source.token(at + 1);
            let what = format!("{name}: {count} parameters in tuples, more than {PARAMETERS}");
            complaints.push(Complaint::new(&source.path, source.tokens[at].line, what));
        }
    }
}

/// Number of parameters of the function whose `fn` is this token, with the fields of tuples counted; `None`
/// without a tuple.
fn parameters_of(source: &Source, at: usize) -> Option<usize> {
    if source.token(at) != "fn" {
        return None;
    }
    let open = if source.token(at + 2) == "<" { list_at(source, at + 2).1 + 1 } else { at + 2 };
    if source.token(open) != "(" {
        return None;
    }
    let fields = list_at(source, open).0.into_iter().map(|parameter| {
        let is_colon = |&index: &usize| source.token(index) == ":";
        let kind = parameter.clone().find(is_colon).map_or(parameter.start, |colon| colon + 1);
        let mut kind = kind..parameter.end;
        while let "&" | "mut" | "'" = source.token(kind.start) {
            kind.start += if source.token(kind.start) == "'" { 2 } else { 1 };
        }
        let is_tuple = source.token(kind.start) == "(";
        if is_tuple { list_at(source, kind.start).0.len() } else { 1 }
    });
    let fields: Vec<usize> = fields.collect();
    fields.iter().any(|&count| count != 1).then(|| fields.iter().sum())
}

/// The items of a list in brackets that opens at a token, and the token that closes it.
fn list_at(source: &Source, open: usize) -> (Vec<Range<usize>>, usize) {
    let (mut items, mut start, mut depth) = (Vec::new(), open + 1, 0_usize);
    for at in open..source.tokens.len() {
        match source.token(at) {
            "(" | "[" | "{" | "<" => depth += 1,
            ">" if source.token(at - 1) == "-" => {}
            ")" | "]" | "}" | ">" => depth -= 1,
            "," if depth == 1 => {
                items.push(start..at);
                start = at + 1;
            }
            _ => {}
        }
        if depth == 0 {
            if start < at {
                items.push(start..at);
            }
            return (items, at);
        }
    }
    (items, source.tokens.len())
}

/// The first and the last line of the function whose `fn` is this token, if it has a body.
fn function_at(source: &Source, at: usize) -> Option<(usize, usize)> {
    let named = source.token(at + 1).starts_with(|c: char| c.is_alphabetic() || c == '_');
    if source.token(at) != "fn" || !named {
        return None;
    }
    let (mut round, mut curly) = (0_usize, 0_usize);
    for token in &source.tokens[at..] {
        match token.text.as_str() {
            "(" | "[" => round += 1,
            ")" | "]" => round = round.saturating_sub(1),
            ";" if round == 0 && curly == 0 => return None,
            "{" if round == 0 || curly > 0 => curly += 1,
            "}" if curly > 0 => {
                curly -= 1;
                if curly == 0 {
                    return Some((source.tokens[at].line, token.line));
                }
            }
            _ => {}
        }
    }
    None
}

fn check_finished(source: &Source, complaints: &mut Vec<Complaint>) {
    for at in 0..source.tokens.len() {
        let word = source.token(at);
        if matches!(word, "todo" | "unimplemented" | "dbg") && source.token(at + 1) == "!" {
            let what = format!("`{word}!` must not stay");
            complaints.push(Complaint::new(&source.path, source.tokens[at].line, what));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{FILE_LINES, FUNCTION_LINES, check};
    use crate::Complaint;
    use crate::source::Source;

    fn complaints(text: &str) -> Vec<Complaint> {
        check(&[Source::new("src/a.rs", text)])
    }

    #[test]
    fn files_begin_with_a_description() {
        assert!(complaints("//! A thing.\n").is_empty());
        assert_eq!(complaints("use a::b;\n").len(), 1);
        assert_eq!(complaints("").len(), 1);
    }

    #[test]
    fn files_end() {
        let long = format!("//! A thing.{}", "\n// more".repeat(FILE_LINES));
        assert_eq!(complaints(&long)[0].line, FILE_LINES + 1);
        assert!(complaints(&long[..long.len() - 10]).is_empty());
    }

    #[test]
    fn functions_end() {
        let body = |lines: usize| {
            let body = "    g(); // h\n    // k\n\n".repeat(lines);
            format!("//! A thing.\ntrait T {{ fn short(&self); }}\nfn f(a: [u8; 2]) {{\n{body}}}\n")
        };
        assert!(complaints(&body(FUNCTION_LINES - 2)).is_empty());
        let long = complaints(&body(FUNCTION_LINES - 1));
        assert_eq!((long.len(), long[0].line), (1, 3));
    }

    #[test]
    fn types_of_functions_have_no_body() {
        let text = format!(
            "//! A.\ntype F = fn(u8);\nconst C: F = |_| {{}};\n{}",
            "static A: u8 = 1;\n".repeat(80)
        );
        assert!(complaints(&text).is_empty());
    }

    #[test]
    fn tuples_hide_no_parameters() {
        let text =
            |parameters: &str| format!("//! A.\nfn f<'a, F: Fn(u8) -> u8>({parameters}) {{}}");
        let five = "&self, a: A<B, C>, b: [(D, E); 2], (c, d): (&'a C, D<E, F>)";
        assert!(complaints(&text(five)).is_empty());
        let seven = format!("{five}, (e, f): &'a mut (E, F),");
        assert!(complaints(&text(&seven)).is_empty());
        assert_eq!(complaints(&text(&format!("{seven} g: &(impl G + H)"))).len(), 1);
        assert!(complaints(&text("a: A, b: B, c: C, d: D, e: E, f: F, g: G, h: H")).is_empty());
    }

    #[test]
    fn code_is_finished() {
        for name in ["todo", "unimplemented"] {
            assert_eq!(complaints(&format!("//! A.\nfn f() {{ {name}!(\"x\") }}")).len(), 1);
            let spoken_of = format!("//! A.\nfn f() {{ g(\"{name}!\") }} // {name}!()");
            assert!(complaints(&spoken_of).is_empty());
        }
    }
}
