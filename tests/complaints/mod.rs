//! # Complaints
//!
//! Known complaints about physics engines that no other test covers. `docs/complaints.md` maps complaints to
//! tests.

mod crowds;
mod gains;
mod origin;
