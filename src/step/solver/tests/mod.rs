//! The contact kernels against their formulas. The same tests for both dimensions.
//!
//! Everything is computed a second time here, body by body and with plain vectors, so that a wrong
//! sign or a mistaken axis in the lanes shows.

mod friction;
mod memory;
mod normal;
mod scene;
