//! Initialisation of the module.

use crate::fault::Kind;
use crate::threads::is_worker;
use crate::{host, memory};
use log::{LevelFilter, Log, Metadata, Record};

/// Stores the engine's warnings: they contain values that a setter rejected.
struct Warnings;

impl Log for Warnings {
    fn enabled(&self, _: &Metadata<'_>) -> bool {
        true
    }

    fn log(&self, record: &Record<'_>) {
        // Workers log quarantined bodies, which events report as well.
        if !is_worker() {
            memory::put_warning(record.args().to_string());
        }
    }

    fn flush(&self) {}
}

static WARNINGS: Warnings = Warnings;

exports! {
    /// Prepares the module. JavaScript calls it once.
    fn start() {
        // A second call keeps the logger.
        let _ = log::set_logger(&WARNINGS);
        log::set_max_level(LevelFilter::Warn);
        #[cfg(target_arch = "wasm32")]
        crate::rapier::pipeline::Timer::set_clock(|| host::now());
        std::panic::set_hook(Box::new(|information| {
            let (address, length) = match is_worker() {
                true => (0, 0),
                false => memory::put_text(&information.to_string()),
            };
            host::fail(Kind::Internal as u32, address, length)
        }));
    }
}
