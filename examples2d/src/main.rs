//! Runs the 2D gallery.
fn main() {}
