//! # Complaints
//!
//! What users of engines like this one complain about, where no other test stands for it.
//! `docs/complaints.md` says which test answers which complaint.

mod crowds;
mod gains;
mod origin;
