//! Integration tests of the public API; the tests themselves are shared by all four crates.

extern crate rapier2d as rapier;

#[path = "../../../tests/dim2.rs"]
#[allow(dead_code, reason = "a vocabulary has words that a book does not use")]
mod dim;
#[path = "../../../tests/suite.rs"]
mod suite;
