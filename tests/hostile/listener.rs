//! Listens to what the engine logs.

use log::{LevelFilter, Log, Metadata, Record};
use rapier::prelude::*;
use std::cell::RefCell;
use std::sync::Once;

thread_local! {
    /// Log of this thread: tests run concurrently.
    static HEARD: RefCell<Vec<String>> = const { RefCell::new(Vec::new()) };
}

struct Listener;

impl Log for Listener {
    fn enabled(&self, _: &Metadata<'_>) -> bool {
        true
    }

    fn log(&self, record: &Record<'_>) {
        HEARD.with_borrow_mut(|heard| heard.push(record.args().to_string()));
    }

    fn flush(&self) {}
}

/// The result of `work`, and its warnings and errors in the engine's log.
pub fn listen<T>(work: impl FnOnce() -> T) -> (T, Vec<String>) {
    static INSTALLED: Once = Once::new();
    INSTALLED.call_once(|| {
        log::set_logger(&Listener).unwrap();
        log::set_max_level(LevelFilter::Warn);
    });
    HEARD.take();
    let result = work();
    (result, HEARD.take())
}

/// Returns whether a text names a number, in either printed form.
pub fn names(text: &str, value: Real) -> bool {
    text.contains(&format!("{value}")) || text.contains(&format!("{value:?}"))
}
