//! Tests of whole worlds: sets that are exchanged, saved and loaded; the tests themselves are shared by all four crates.

extern crate rapier2d as rapier;

#[path = "../../../tests/worlds/mod.rs"]
mod worlds;
