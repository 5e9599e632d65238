//! # Quarantine
//!
//! A body whose numbers overflow is disabled at its pose before the step, and reported. Most tests here
//! step two worlds side by side and misuse one of them. In the other, its *twin*, the user disables the
//! same bodies before each step. Bodies and events must be equal to the last bit if an edit alone makes a
//! body diverge. A step that failed for another reason may have woken bodies and coloured contacts that the
//! twin has not. Such a step has the same bits in each run (`random_edits.rs`).

mod causes;
mod contacts;
mod crowds;
mod joints;
mod random_edits;
mod recovery;
mod stage;
mod threads;
