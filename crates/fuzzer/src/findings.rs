//! What a string of bytes finds, and the shortest string that finds the same.

use crate::{Run, Tally};
use std::cell::RefCell;
use std::panic::{PanicHookInfo, catch_unwind};
use std::sync::Once;

thread_local! {
    /// Where and why this thread panicked last.
    static LAST: RefCell<Option<Finding>> = const { RefCell::new(None) };
}

/// A panic.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// File, line and column.
    pub place: String,
    /// What it said.
    pub message: String,
}

impl std::fmt::Display for Finding {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}: {}", self.place, self.message)
    }
}

/// Does what the bytes say.
///
/// From the first call on, panics of the whole program are noted instead of printed.
///
/// # Errors
/// If something was not in order.
pub fn search(run: Run, bytes: &[u8]) -> Result<Tally, Finding> {
    static QUIET: Once = Once::new();
    QUIET.call_once(|| std::panic::set_hook(Box::new(note)));
    catch_unwind(|| run(bytes)).map_err(|_| {
        LAST.take().unwrap_or_else(|| Finding { place: "unknown".into(), message: String::new() })
    })
}

fn note(info: &PanicHookInfo<'_>) {
    let place = info.location().map_or_else(String::new, ToString::to_string);
    let text = info.payload().downcast_ref::<String>().map(String::as_str);
    let text = text.or_else(|| info.payload().downcast_ref::<&str>().copied());
    let message = text.unwrap_or_default().to_owned();
    if std::env::var_os("FUZZ_TELL").is_some() {
        eprintln!("{}", std::backtrace::Backtrace::capture());
    }
    LAST.set(Some(Finding { place, message }));
}

/// The shortest string found that panics at the same place: pieces are left out, and bytes set to zero, as long as
/// that goes well.
pub fn minimised(run: Run, bytes: &[u8], finding: &Finding) -> Vec<u8> {
    let same = |bytes: &[u8]| search(run, bytes).is_err_and(|other| other.place == finding.place);
    let mut shortest = bytes.to_vec();
    let mut piece = shortest.len() / 2;
    while piece > 0 {
        let mut at = 0;
        while at < shortest.len() {
            let mut shorter = shortest.clone();
            shorter.drain(at..(at + piece).min(shortest.len()));
            if same(&shorter) {
                shortest = shorter;
            } else {
                at += piece;
            }
        }
        piece /= 2;
    }
    for at in 0..shortest.len() {
        let old = std::mem::replace(&mut shortest[at], 0);
        if old != 0 && !same(&shortest) {
            shortest[at] = old;
        }
    }
    shortest
}

#[cfg(test)]
mod tests {
    use super::{minimised, search};
    use crate::Tally;

    fn dislikes_seven(bytes: &[u8]) -> Tally {
        assert!(!bytes.windows(2).any(|pair| pair == [7, 8]), "a seven before an eight");
        Tally { operations: bytes.len(), steps: 0 }
    }

    #[test]
    fn a_finding_is_minimised() {
        let bytes = [1, 2, 7, 8, 9, 7, 3, 4, 5, 6];
        let finding = search(dislikes_seven, &bytes).unwrap_err();
        assert_eq!(finding.message, "a seven before an eight");
        assert_eq!(minimised(dislikes_seven, &bytes, &finding), [7, 8]);
        assert_eq!(search(dislikes_seven, &bytes[..3]).unwrap().operations, 3);
    }
}
