//! # Complaints
//!
//! Known complaints about physics engines that no other test covers. `docs/complaints.md` says which test
//! answers which complaint.

mod crowds;
mod gains;
mod origin;
