//! Programs for Rapier 0.32. All four packages share the tests.

extern crate rapier3d as rapier;

#[path = "../../tests/suite.rs"]
mod suite;
