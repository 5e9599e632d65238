//! Imports of the module from JavaScript.

/// The functions that `javascript/src/raw.ts` supplies.
#[cfg(target_arch = "wasm32")]
mod imported {
    #[link(wasm_import_module = "rapier")]
    unsafe extern "C" {
        /// Throws an error with a text in memory. The kind is that of `Fault`.
        pub safe fn fail(kind: u32, text: usize, length: usize) -> !;
        /// Passes a warning on.
        pub safe fn warn(text: usize, length: usize);
        /// Calls the predicate of a query. Returns whether the collider takes part.
        pub safe fn accepts(collider: f64) -> u32;
        /// Calls the visitor of a query. Returns whether the query continues.
        pub safe fn visit(collider: f64) -> u32;
        /// The time in milliseconds.
        pub safe fn now() -> f64;
        /// Calls a hook. The kind is 0 for contact pairs, 1 for intersection pairs, 2 for the modification of
        /// contacts.
        pub safe fn hook(kind: u32, collider1: f64, collider2: f64, body1: f64, body2: f64) -> u32;
    }
}

/// Replacement on other targets, where the crate is only checked.
#[cfg(not(target_arch = "wasm32"))]
mod imported {
    pub fn fail(kind: u32, _text: usize, _length: usize) -> ! {
        std::process::exit(kind as i32)
    }
    pub fn warn(_text: usize, _length: usize) {}
    pub fn accepts(_collider: f64) -> u32 {
        1
    }
    pub fn visit(_collider: f64) -> u32 {
        1
    }
    pub fn hook(_kind: u32, _collider1: f64, _collider2: f64, _body1: f64, _body2: f64) -> u32 {
        1
    }
}

#[cfg(target_arch = "wasm32")]
pub use imported::now;
pub use imported::{accepts, fail, hook, visit, warn};
