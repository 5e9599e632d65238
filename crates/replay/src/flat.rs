//! Recording and replaying in 2D.

use scenes2d as examples;
use rapier2d as rapier;

#[path = "both.rs"]
mod both;

pub use both::{compare, play, record};
