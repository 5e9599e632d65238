//! Captures the engine's log.

use log::{LevelFilter, Log, Metadata, Record};
use rapier::prelude::*;
use std::cell::RefCell;
use std::sync::Once;

thread_local! {
    /// Log of this thread: tests run concurrently.
    static CAPTURED: RefCell<Vec<String>> = const { RefCell::new(Vec::new()) };
}

struct Listener;

impl Log for Listener {
    fn enabled(&self, _: &Metadata<'_>) -> bool {
        true
    }

    fn log(&self, record: &Record<'_>) {
        CAPTURED.with_borrow_mut(|heard| heard.push(record.args().to_string()));
    }

    fn flush(&self) {}
}

/// Returns the result of `work`, and its warnings and errors in the engine's log.
pub fn listen<T>(work: impl FnOnce() -> T) -> (T, Vec<String>) {
    static INSTALLED: Once = Once::new();
    INSTALLED.call_once(|| {
        log::set_logger(&Listener).unwrap();
        log::set_max_level(LevelFilter::Warn);
    });
    CAPTURED.take();
    let result = work();
    (result, CAPTURED.take())
}

/// Returns whether a text names a number, in either printed form.
pub fn names(text: &str, value: Real) -> bool {
    text.contains(&format!("{value}")) || text.contains(&format!("{value:?}"))
}
