//! # Quarantine
//!
//! A body whose numbers overflow is disabled at its pose before the step, and reported. All other bodies move
//! bit for bit as if the user had disabled it before the step. Every test here steps two worlds side by side
//! and misuses one of them. In the other, its *twin*, the user disables the same bodies before each step.
//! Bodies and events must be equal.

mod chance;
mod contacts;
mod crowds;
mod joints;
mod roads;
mod stage;
mod threads;
mod way_home;
