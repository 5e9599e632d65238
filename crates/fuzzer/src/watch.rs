//! Endless sequences are findings as well. No thread can stop them, so the watch writes them to a file and
//! ends the program.

use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

/// Largest time of a sequence: some hundred times the time of the slowest ones.
const SEQUENCE_TIME_MAX: Duration = Duration::from_secs(60);
const PAUSE: Duration = Duration::from_secs(1);

/// The running sequence.
struct Current {
    since: Instant,
    name: String,
    bytes: Vec<u8>,
}

/// Checks at intervals, on a separate thread, whether the running sequence has ended.
#[derive(Clone, Default)]
pub struct Watch(Arc<Mutex<Option<Current>>>);

impl Watch {
    /// Starts the thread, which runs until the program ends.
    pub fn new() -> Self {
        let watch = Self::default();
        let watcher = watch.clone();
        std::thread::spawn(move || {
            loop {
                std::thread::sleep(PAUSE);
                watcher.check();
            }
        });
        watch
    }

    /// Runs a sequence. `name` identifies it in the report.
    pub fn during<T>(&self, name: String, bytes: &[u8], work: impl FnOnce() -> T) -> T {
        let current = Current { since: Instant::now(), name, bytes: bytes.to_vec() };
        *self.0.lock().unwrap() = Some(current);
        let result = work();
        *self.0.lock().unwrap() = None;
        result
    }

    fn check(&self) {
        let current = self.0.lock().unwrap();
        let Some(current) = current.as_ref().filter(|it| it.since.elapsed() > SEQUENCE_TIME_MAX)
        else {
            return;
        };
        let file = format!("finding-{}.bin", current.name);
        let written = std::fs::write(&file, &current.bytes);
        println!("{}{} exceeds the time limit: {file} {written:?}", crate::wipe(), current.name);
        std::process::exit(1);
    }
}
