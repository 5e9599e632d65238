//! Places of `unsafe`, and its documentation.

use crate::Complaint;
use crate::source::Source;

/// Files and folders of the engine that may be `unsafe`, with the reason.
const ALLOWED: &[(&str, &str)] = &[
    ("src/base/arena.rs", "two elements of one slice at a time"),
    ("src/base/disjoint.rs", "many threads write one slice, each its own elements"),
    ("src/base/late.rs", "the first read completes a shared value"),
    ("src/base/tasks/", "hands elements of one slice out to workers"),
    ("src/base/wide/", "intrinsics of the processor"),
    ("src/dim2/state.rs", "gathers bodies by index into lanes"),
    ("src/dim3/state.rs", "gathers bodies by index into lanes"),
    ("src/dim2/contact/", "constraints of one colour write bodies concurrently"),
    ("src/dim3/contact/", "constraints of one colour write bodies concurrently"),
    ("src/model/body/set.rs", "threads visit bodies concurrently"),
    ("src/model/contact/narrow_phase.rs", "the first read of a pair writes its results back"),
    ("src/model/contact/store/mod.rs", "a pair is written behind a shared reference"),
    ("src/model/frozen.rs", "hands a set's concurrent visits on"),
    ("src/model/joint/views.rs", "a wrapper of a joint is that joint"),
    ("src/model/joint/kind.rs", "declares each wrapper as one"),
    ("src/step/solver/", "constraints of a colour run concurrently"),
    ("src/step/finalize_bodies/mod.rs", "bodies move their colliders concurrently"),
    ("src/step/narrow_phase/update.rs", "pairs are computed concurrently"),
    ("src/step/narrow_phase/ghost_contacts.rs", "bodies are compared concurrently"),
    ("crates/golden/src/web.rs", "exports functions to JavaScript by name"),
    (
        "crates/wasm/src/",
        "exports functions to JavaScript by name, and stores objects of JavaScript in static cells",
    ),
    (
        "crates/compat/src/dynamics/sets.rs",
        "a borrowed set of the engine is its transparent wrapper",
    ),
    (
        "crates/compat/src/dynamics/multibody.rs",
        "a borrowed multibody of the engine is its transparent wrapper",
    ),
    (
        "crates/compat/src/geometry/colliders.rs",
        "a borrowed set of the engine is its transparent wrapper",
    ),
    ("crates/bench/src/", "counts allocations, and calls engines written in C"),
];

/// Complains of `unsafe` in other places, and of `unsafe` without a reason.
pub fn check(sources: &[Source]) -> Vec<Complaint> {
    let mut complaints = Vec::new();
    for source in sources {
        for token in source.tokens.iter().filter(|token| token.text == "unsafe") {
            let placed = ALLOWED.iter().any(|(place, _)| source.path.starts_with(place));
            if !placed {
                let what = "`unsafe` stands in a file that is not listed for it";
                complaints.push(Complaint::new(&source.path, token.line, what));
            }
        }
        check_reasons(source, &mut complaints);
    }
    complaints
}

fn check_reasons(source: &Source, complaints: &mut Vec<Complaint>) {
    let lines: Vec<&str> = source.text.lines().collect();
    for at in 0..source.tokens.len() {
        // An `unsafe fn` documents the caller's obligations; `unsafe extern` and `unsafe(…)` are no blocks.
        let (reason, kind) = match (source.token(at), source.token(at + 1)) {
            ("unsafe", "{" | "impl") => ("SAFETY:", "a block"),
            ("unsafe", "fn") if !of_documented_trait(source, at) => ("# Safety", "a function"),
            _ => continue,
        };
        let line = source.tokens[at].line;
        if !explained(&lines, line, reason) {
            let what = format!("`unsafe`, {kind} without `{reason}`");
            complaints.push(Complaint::new(&source.path, line, what));
        }
    }
}

/// Returns whether this `unsafe fn` implements a trait's, which is documented there.
fn of_documented_trait(source: &Source, at: usize) -> bool {
    let mut depth = 0_i32;
    for i in (0..at).rev() {
        match source.token(i) {
            "}" => depth += 1,
            "{" => depth -= 1,
            "impl" if depth < 0 => {
                return (i..at)
                    .take_while(|&i| source.token(i) != "{")
                    .any(|i| source.token(i) == "for");
            }
            _ => {}
        }
    }
    false
}

/// Returns whether the line contains the reason, or the comments and attributes right above its statement do.
fn explained(lines: &[&str], line: usize, reason: &str) -> bool {
    if lines[line - 1].contains(reason) {
        return true;
    }
    for above in lines[..line - 1].iter().rev().map(|above| above.trim()) {
        let comment = above.starts_with("//");
        if comment && above.contains(reason) {
            return true;
        }
        let ends_statement = above.is_empty() || above.ends_with([';', '{', '}']);
        if ends_statement && !comment {
            return false;
        }
    }
    false
}

#[cfg(test)]
mod tests {
    use super::check;
    use crate::source::Source;

    fn complaints(path: &str, text: &str) -> usize {
        check(&[Source::new(path, text)]).len()
    }

    #[test]
    fn danger_stands_where_it_is_listed() {
        let text = "// SAFETY: the index was checked.\nlet a = unsafe { b.get(c) };";
        assert_eq!(complaints("src/base/arena.rs", text), 0);
        assert_eq!(complaints("src/base/wide/avx.rs", text), 0);
        assert_eq!(complaints("src/model/island/manager.rs", text), 1);
    }

    #[test]
    fn blocks_give_a_reason() {
        let place = "src/base/arena.rs";
        assert_eq!(complaints(place, "let a = 1;\nlet b = unsafe { c() };"), 1);
        assert_eq!(complaints(place, "// SAFETY: d.\nlet b =\n    unsafe { c() };"), 0);
        assert_eq!(complaints(place, "// SAFETY: d.\nlet a = 1;\nlet b = unsafe { c() };"), 1);
        assert_eq!(complaints(place, "unsafe impl Sync for A {}"), 1);
    }

    #[test]
    fn functions_state_their_requirements() {
        let place = "src/base/arena.rs";
        assert_eq!(complaints(place, "/// A.\nunsafe fn a() {}"), 1);
        assert_eq!(
            complaints(place, "/// A.\n/// # Safety\n/// B.\n#[inline]\nunsafe fn a() {}"),
            0
        );
        assert_eq!(complaints(place, "impl A for B {\n    unsafe fn a() {}\n}"), 0);
        assert_eq!(complaints(place, "impl B {\n    unsafe fn a() {}\n}"), 1);
    }
}
