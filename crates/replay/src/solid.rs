//! Recording and replaying in 3D.

use examples3d as examples;
use rapier3d as rapier;

#[path = "both.rs"]
mod both;

pub use both::{compare, play, record};
