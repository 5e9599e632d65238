//! Programs for Rapier 0.36. All four packages share the tests.

extern crate rapier3d_f64 as rapier;

#[path = "../../../tests/suite.rs"]
mod suite;
