//! Deliberate panics: the worst case of a user's hook or event handler.
//!
//! They unwind like any panic but skip the panic hook. Printed panics, and crashes that a fuzzer counts, are
//! therefore unintended ones.

use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};

/// Payload of a deliberate panic.
struct DeliberatePanic;

/// Unwinds with the payload of a deliberate panic.
pub fn panic_deliberately() -> ! {
    resume_unwind(Box::new(DeliberatePanic))
}

/// Runs code that may call [`panic_deliberately`]. Returns whether it completed. Other panics continue.
pub fn completes(work: impl FnOnce()) -> bool {
    match catch_unwind(AssertUnwindSafe(work)) {
        Ok(()) => true,
        Err(panic) if panic.is::<DeliberatePanic>() => false,
        Err(panic) => resume_unwind(panic),
    }
}

#[cfg(test)]
mod tests {
    use super::{completes, panic_deliberately};

    #[test]
    fn only_deliberate_panics_are_caught() {
        assert!(completes(|| {}));
        assert!(!completes(|| panic_deliberately()));
        let other =
            std::panic::catch_unwind(|| completes(|| std::panic::resume_unwind(Box::new(1))));
        assert!(other.is_err());
    }
}
