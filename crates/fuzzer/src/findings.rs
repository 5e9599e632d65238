//! Findings of a string of bytes, and the shortest string with the same finding.

use crate::{Run, Tally};
use std::cell::RefCell;
use std::panic::{PanicHookInfo, catch_unwind};
use std::sync::Once;

thread_local! {
    /// Place and message of this thread's last panic.
    static LAST: RefCell<Option<Finding>> = const { RefCell::new(None) };
}

/// A panic.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// File, line and column.
    pub place: String,
    /// Message of the panic.
    pub message: String,
}

impl std::fmt::Display for Finding {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}: {}", self.place, self.message)
    }
}

/// Runs the operations of the bytes.
///
/// The first call installs a panic hook for the whole program, which records panics instead of printing them.
///
/// # Errors
/// If an invariant was violated.
pub fn search(run: Run, bytes: &[u8]) -> Result<Tally, Finding> {
    static PANIC_HOOK: Once = Once::new();
    PANIC_HOOK.call_once(|| std::panic::set_hook(Box::new(record_panic)));
    catch_unwind(|| run(bytes)).map_err(|_| {
        LAST.take().unwrap_or_else(|| Finding { place: "unknown".into(), message: String::new() })
    })
}

fn record_panic(info: &PanicHookInfo<'_>) {
    let place = info.location().map_or_else(String::new, ToString::to_string);
    let text = info.payload().downcast_ref::<String>().map(String::as_str);
    let text = text.or_else(|| info.payload().downcast_ref::<&str>().copied());
    let message = text.unwrap_or_default().to_owned();
    if std::env::var_os("FUZZ_VERBOSE").is_some() {
        eprintln!("{}", std::backtrace::Backtrace::capture());
    }
    LAST.set(Some(Finding { place, message }));
}

/// Returns the shortest string found that panics at the same place. The search removes pieces and sets bytes
/// to zero as long as the panic persists.
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

    fn panics_on_seven(bytes: &[u8]) -> Tally {
        assert!(!bytes.windows(2).any(|pair| pair == [7, 8]), "a seven before an eight");
        Tally { operations: bytes.len(), steps: 0 }
    }

    #[test]
    fn a_finding_is_minimised() {
        let bytes = [1, 2, 7, 8, 9, 7, 3, 4, 5, 6];
        let finding = search(panics_on_seven, &bytes).unwrap_err();
        assert_eq!(finding.message, "a seven before an eight");
        assert_eq!(minimised(panics_on_seven, &bytes, &finding), [7, 8]);
        assert_eq!(search(panics_on_seven, &bytes[..3]).unwrap().operations, 3);
    }
}
