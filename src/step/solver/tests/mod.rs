//! The contact kernels against their formulas. The same tests for both dimensions.
//!
//! Everything is computed again here, body by body and with plain vectors, so that a wrong sign or axis in
//! the lanes shows.

mod friction;
mod memory;
mod normal;
mod scene;
mod wide;
