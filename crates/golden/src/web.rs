//! Functions that JavaScript calls: see `run.mjs`. Strings are handed over as a pointer and a length.

use crate::{EXPECTED, Settings, line, scenes};
use std::sync::Mutex;

/// Text of the last call.
static TEXT: Mutex<String> = Mutex::new(String::new());

fn leave(text: String) -> usize {
    let mut place = TEXT.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    *place = text;
    place.len()
}

/// The number of scenes.
#[unsafe(no_mangle)]
pub extern "C" fn golden_count() -> usize {
    scenes().len()
}

/// Runs a scene, stores its line of hashes as the text, and returns the length of the text in bytes.
#[unsafe(no_mangle)]
pub extern "C" fn golden_run(index: usize) -> usize {
    let scenes = scenes();
    let Some(scene) = scenes.get(index) else { return leave(String::new()) };
    leave(line(scene, scene.run(Settings { threads: 1, wide: true })))
}

/// Stores the expected hashes as the text, and returns its length in bytes.
#[unsafe(no_mangle)]
pub extern "C" fn golden_expected() -> usize {
    leave(EXPECTED.into())
}

/// Returns the address of the text.
#[unsafe(no_mangle)]
pub extern "C" fn golden_text() -> *const u8 {
    TEXT.lock().unwrap_or_else(|poisoned| poisoned.into_inner()).as_ptr()
}

#[cfg(target_arch = "wasm32")]
#[link(wasm_import_module = "golden")]
unsafe extern "C" {
    /// The time in milliseconds.
    safe fn now() -> f64;
}

/// Runs a pile, stores its line of times as the text, and returns its length in bytes; 0 behind the last
/// pile.
#[cfg(target_arch = "wasm32")]
#[unsafe(no_mangle)]
pub extern "C" fn golden_time(index: usize) -> usize {
    let line = crate::PILES.get(index).map(|&(engine, pile)| crate::time(engine, pile, || now()));
    leave(line.unwrap_or_default())
}
