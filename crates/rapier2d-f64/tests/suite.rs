//! Integration tests of the public API; the tests themselves are shared by all four crates.
