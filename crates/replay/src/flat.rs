//! Recording and replaying in 2D.

use rapier2d as rapier;
use scenes2d as examples;

#[path = "both.rs"]
mod both;

pub use both::{compare, play, record};
