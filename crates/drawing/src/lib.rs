//! # Drawing: a scene as data, and pictures of it
//!
//! A [`Drawing`] holds meshes with their instances, lines and labels; a [`Camera`] holds a point of view. Two
//! renderers read both. The crate `render` draws on a graphics adapter. [`raster`] paints on the processor,
//! needs no driver and gives the same bytes on every machine.
//!
//! The crate contains no physics. Points are `[f32; 3]` in every dimension and precision; flat scenes lie at
//! z = 0.

mod animation;
pub mod camera;
mod color;
mod image;
pub mod light;
mod mesh;
mod outline;
pub mod raster;
mod sheet;
pub mod vector;

pub use animation::Animation;
pub use camera::{Camera, Seen, View};
pub use color::Color;
pub use image::{Image, naming};
pub use mesh::{Mesh, Vertex};
pub use sheet::{Batch, Drawing, Instance, Label, Line, Role};

/// A position in the scene; y is up.
pub type Point = [f32; 3];
