//! Recording and replaying in 3D.

use scenes3d as examples;
use rapier3d as rapier;

#[path = "both.rs"]
mod both;

pub use both::{compare, play, record};
