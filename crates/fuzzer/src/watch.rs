//! Sequences that do not come to an end are findings, too, but nobody can stop them: who watches writes them down and ends the program.

use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

/// How long a sequence may take: some hundred times as long as the slowest do.
const PATIENCE: Duration = Duration::from_secs(60);
const PAUSE: Duration = Duration::from_secs(1);

/// The sequence that is done now.
struct Current {
    since: Instant,
    name: String,
    bytes: Vec<u8>,
}

/// Looks from time to time, on a thread of its own, whether the present sequence has come to its end.
#[derive(Clone, Default)]
pub struct Watch(Arc<Mutex<Option<Current>>>);

impl Watch {
    /// Watches until the program ends.
    pub fn new() -> Self {
        let watch = Self::default();
        let watcher = watch.clone();
        std::thread::spawn(move || {
            loop {
                std::thread::sleep(PAUSE);
                watcher.look();
            }
        });
        watch
    }

    /// Does a sequence. `name` says which one.
    pub fn during<T>(&self, name: String, bytes: &[u8], work: impl FnOnce() -> T) -> T {
        let current = Current { since: Instant::now(), name, bytes: bytes.to_vec() };
        *self.0.lock().unwrap() = Some(current);
        let result = work();
        *self.0.lock().unwrap() = None;
        result
    }

    fn look(&self) {
        let current = self.0.lock().unwrap();
        let Some(current) = current.as_ref().filter(|it| it.since.elapsed() > PATIENCE) else {
            return;
        };
        let file = format!("finding-{}.bin", current.name);
        let written = std::fs::write(&file, &current.bytes);
        println!("{}{} does not come to an end: {file} {written:?}", crate::wipe(), current.name);
        std::process::exit(1);
    }
}
