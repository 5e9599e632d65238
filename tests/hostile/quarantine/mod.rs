//! # Quarantine
//!
//! A body whose numbers leave the range in which one can calculate is left where the step found it, disabled,
//! and reported. Most tests here step two worlds side by side. One is mistreated. In the other, its *twin*,
//! the user disables the same bodies before each step. Bodies and events must be the same. That holds
//! exactly for edits that a body cannot survive. A step that failed for another reason may have woken bodies
//! and coloured contacts that the twin has not. It has the same bits in each run (`chance.rs`).

mod chance;
mod contacts;
mod crowds;
mod joints;
mod roads;
mod stage;
mod threads;
mod way_home;
