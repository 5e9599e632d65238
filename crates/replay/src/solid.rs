//! Recording and replaying in 3D.

use rapier3d as rapier;
use scenes3d as examples;

#[path = "both.rs"]
mod both;

pub use both::{compare, play, record};
