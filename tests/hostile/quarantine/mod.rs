//! # Quarantine
//!
//! A body whose numbers leave the range in which one can calculate is left where the step found it, disabled,
//! and reported; the others go on bit for bit as if it had been disabled before the step. Every test here
//! steps two worlds side by side. One is mistreated. In the other, its *twin*, the user disables the same
//! bodies before each step. Bodies and events must be the same.

mod chance;
mod contacts;
mod crowds;
mod joints;
mod roads;
mod stage;
mod threads;
mod way_home;
