//! Comments in the field's language: no person words, no verbs of speech, no questions, no wide lines, no
//! constants that are bare adjectives or begin with a quantity.
//!
//! The rule is in CONTRIBUTING.md.

use crate::Complaint;
use crate::source::Source;

/// Places with checked comments.
const CHECKED: [&str; 6] = ["src/", "tests/", "crates/", "examples2d/", "examples3d/", "fuzz/"];
/// Pronouns of people, which data lacks: those with a beginning and an end of the same row.
const PRONOUNS: [(&[&str], &[&str]); 2] = [
    (&["no", "some", "any", "every"], &["body", "one"]),
    (&["wh"], &["o", "om", "oever", "omever"]),
];
/// Verbs of speech and wish, which data lacks. Other forms of these are ordinary words ("a floor, say").
const VERBS: [&str; 10] =
    ["feels", "guesses", "hears", "knows", "said", "says", "tells", "told", "wanted", "wants"];
/// Names of constants that lack a noun and a quantity (`MASS_RATIO_MAX`).
const ADJECTIVES: [&str; 44] = [
    "AHEAD",
    "BENT",
    "CALM",
    "CLOSE",
    "DEEP",
    "DEEPER",
    "DUE",
    "EVEN",
    "FAR",
    "FAST",
    "FASTEST",
    "FLAT",
    "GENTLE",
    "HEAVY",
    "HUGE",
    "LARGE",
    "LEAST",
    "LIGHT",
    "LONG",
    "LOOSE",
    "MOST",
    "NARROW",
    "NEAR",
    "NEARLY",
    "NEAREST",
    "NOTICED",
    "PARALLEL",
    "QUIET",
    "RETIRED",
    "ROUGH",
    "SETTLED",
    "SHORT",
    "SLOW",
    "SMALL",
    "STILL",
    "STRONG",
    "TAUT",
    "THIN",
    "TINY",
    "UNBOUNDED",
    "UNLIMITED",
    "UNVERIFIED",
    "USUAL",
    "WILD",
];
/// Quantities, which stand at the end of a constant's name.
const QUANTITIES: [&str; 4] = ["LEAST_", "MAX_", "MIN_", "MOST_"];
/// The constant of the upstream API with its quantity in front.
const UPSTREAM_NAME: &str = "MAX_MANIFOLD_POINTS";
/// Widest line of a comment, in characters.
const WIDTH_MAX: usize = 110;

/// Complains of comments and constants that break the rule.
pub fn check(sources: &[Source]) -> Vec<Complaint> {
    let is_checked = |path: &str| CHECKED.iter().any(|place| path.starts_with(place));
    sources.iter().filter(|source| is_checked(&source.path)).flat_map(check_file).collect()
}

fn check_file(source: &Source) -> Vec<Complaint> {
    let mut complaints = Vec::new();
    let (mut fenced, mut in_code) = (false, false);
    for (number, (line, code)) in source.text.lines().zip(source.bare.lines()).enumerate() {
        let comment = comment(line, code);
        let is_whole_line = code.trim().is_empty();
        fenced &= is_whole_line && comment.is_some();
        in_code &= is_whole_line && comment.is_some() && !fenced;
        let Some(comment) = comment else { continue };
        if in_code && is_list_item(comment) {
            let what = "code in backticks continues behind a mark of a list".to_owned();
            complaints.push(Complaint::new(&source.path, number + 1, what));
        }
        let is_fence = is_whole_line && comment.trim_start().starts_with("```");
        fenced ^= is_fence;
        in_code ^= !is_fence && comment.matches('`').count() % 2 == 1;
        if !fenced {
            complaints.extend(
                faults(line, comment).map(|what| Complaint::new(&source.path, number + 1, what)),
            );
        }
    }
    complaints.extend(check_constants(source));
    complaints
}

/// Returns whether Markdown takes a line for an item of a list or a quotation.
fn is_list_item(comment: &str) -> bool {
    ["- ", "+ ", "* ", "> "].iter().any(|mark| comment.trim_start().starts_with(mark))
}

/// The text of a comment that is a whole line, or follows the code of a line. `code` is the line with blanks
/// in place of its comments.
fn comment<'a>(line: &'a str, code: &str) -> Option<&'a str> {
    let (start, _) = line.char_indices().nth(code.trim_end().chars().count())?;
    let comment = line[start..].trim_start().strip_prefix("//")?;
    Some(comment.strip_prefix(['/', '!']).unwrap_or(comment))
}

fn faults(line: &str, comment: &str) -> impl Iterator<Item = String> {
    let person = words(comment).find(|word| is_person(&word.to_lowercase()));
    let person = person.map(|word| format!("`{word}` in a comment: data is no person"));
    let verb = words(comment).find(|word| VERBS.contains(&word.to_lowercase().as_str()));
    let verb = verb.map(|word| format!("`{word}` in a comment: data neither speaks nor wishes"));
    let is_question = comment.trim_end().ends_with('?') || comment.contains("? ");
    let question =
        is_question.then(|| "a question in a comment: begin with `Returns whether`".to_owned());
    let width = line.chars().count();
    let is_fixed = comment.trim_start().starts_with('|') || comment.contains("](");
    let wide = (width > WIDTH_MAX && !is_fixed)
        .then(|| format!("a comment of {width} characters, more than {WIDTH_MAX}"));
    [person, verb, question, wide].into_iter().flatten()
}

fn is_person(word: &str) -> bool {
    PRONOUNS.iter().any(|(beginnings, ends)| {
        let mut rests = beginnings.iter().filter_map(|beginning| word.strip_prefix(beginning));
        rests.any(|rest| ends.contains(&rest))
    })
}

/// The words of a comment outside of code in backticks.
fn words(comment: &str) -> impl Iterator<Item = &str> {
    let prose = comment.split('`').step_by(2);
    prose.flat_map(|prose| prose.split(|c: char| !c.is_alphanumeric()))
}

fn check_constants(source: &Source) -> impl Iterator<Item = Complaint> {
    let names = (0..source.tokens.len()).filter(|&at| source.token(at) == "const");
    let misnamed = names.filter(|&at| {
        let name = source.token(at + 1);
        let starts_with_quantity = QUANTITIES.iter().any(|quantity| name.starts_with(quantity));
        source.token(at + 2) == ":"
            && (ADJECTIVES.contains(&name) || starts_with_quantity && name != UPSTREAM_NAME)
    });
    misnamed.map(|at| {
        let what = format!("`{}`: name the noun and the quantity", source.token(at + 1));
        Complaint::new(&source.path, source.tokens[at].line, what)
    })
}

#[cfg(test)]
mod tests {
    use super::{PRONOUNS, VERBS, WIDTH_MAX, check};
    use crate::source::Source;

    fn complaints(text: &str) -> usize {
        check(&[Source::new("src/a.rs", text)]).len()
    }

    #[test]
    fn data_is_no_person() {
        assert_eq!(complaints("/// The body that touches the wall, and no one else's.\n"), 0);
        let pronouns = PRONOUNS.iter().flat_map(|(beginnings, ends)| {
            beginnings
                .iter()
                .flat_map(|beginning| ends.iter().map(move |end| format!("{beginning}{end}")))
        });
        for word in pronouns {
            let capital = format!("{}{}", word[..1].to_uppercase(), &word[1..]);
            assert_eq!(complaints(&format!("/// {capital} touches the wall.\n")), 1);
            assert_eq!(complaints(&format!("fn f() {{\n    // SAFETY: {word} writes.\n}}\n")), 1);
            assert_eq!(
                complaints(&format!("/// The code `{word}` and {word}d.\nlet {word} = 1;\n")),
                0
            );
        }
    }

    #[test]
    fn data_does_not_speak() {
        for verb in VERBS {
            assert_eq!(complaints(&format!("/// The body that the set {verb}.\n")), 1);
            assert_eq!(
                complaints(&format!("/// The body that is `{verb}`.\nlet {verb} = 1;\n")),
                0
            );
        }
        assert_eq!(complaints("/// A hub body (a dynamic floor, say) that is well known.\n"), 0);
    }

    #[test]
    fn questions_in_comments_are_complaints() {
        assert_eq!(complaints("/// Is it fast?\n"), 1);
        assert_eq!(complaints("/// Is it fast? If so, stop it.\n"), 1);
        assert_eq!(complaints("/// Returns whether it is fast.\n"), 0);
        assert_eq!(complaints("/// ```\n/// let a = b()? + 1;\n/// ```\n"), 0);
        assert_eq!(complaints("/// ```\n/// a\n/// ```\n/// Is it fast?\n"), 1);
    }

    #[test]
    fn code_does_not_continue_as_a_list() {
        assert_eq!(complaints("/// The drop is `t (t\n/// + h)`.\n"), 1);
        assert_eq!(complaints("/// The drop is\n/// `t (t + h)`.\n/// * `a`\n/// * `b`\n"), 0);
    }

    #[test]
    fn comments_after_code_are_checked() {
        assert_eq!(complaints("let a = 1; // Is it read?\n"), 1);
        assert_eq!(complaints("let a = \"é\"; // Is it fast?\n"), 1);
        assert_eq!(complaints("let a = 1; // the number of bodies\n"), 0);
        assert_eq!(complaints("let a = \"// Is it fast?\";\n"), 0);
        assert_eq!(complaints("let a = \"\n// Is it fast?\n\";\n"), 0);
        assert_eq!(complaints("/// ```\nlet a = 1; // b\n// Is it fast?\n"), 1);
    }

    #[test]
    fn comments_are_narrow() {
        let line = |width: usize| format!("// {}\n", "a".repeat(width - 3));
        assert_eq!(complaints(&line(WIDTH_MAX)), 0);
        assert_eq!(complaints(&line(WIDTH_MAX + 1)), 1);
        assert_eq!(complaints(&format!("//! | {} |\n", "a".repeat(WIDTH_MAX))), 0);
    }

    #[test]
    fn constants_have_nouns() {
        assert_eq!(complaints("const FAST: f32 = 1.0;\n"), 1);
        assert_eq!(complaints("impl A {\n    pub const NEAR: f32 = 1.0;\n}\n"), 1);
        assert_eq!(complaints("const MAX_SPEED: f32 = 1.0;\n"), 1);
        assert_eq!(complaints("const SPEED_MAX: f32 = 1.0;\nlet a = FAST;\n"), 0);
    }

    #[test]
    fn other_places_are_not_checked() {
        let check_in = |path| check(&[Source::new(path, "// Is it fast?\n")]).len();
        assert_eq!(check_in("crates/bench/src/a.rs"), 1);
        assert_eq!(check_in("crates/scene3d/src/a.rs"), 1);
        assert_eq!(check_in("python/src/a.rs"), 0);
    }
}
