//! Runs the 3D gallery.
fn main() {}
