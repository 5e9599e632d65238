//! # Render: drawings on a graphics adapter
//!
//! [`Renderer`] draws a [`Drawing`](drawing::Drawing) into a [`Target`]: instanced meshes with the shadow of
//! the sun, lines, four samples a pixel. [`Blit`] copies the target into a window's pass. [`Offscreen`] reads
//! it back as a picture.
//! The crate contains no physics, no window and no user interface.

mod blit;
mod buffers;
mod offscreen;
mod pipelines;
mod renderer;
mod target;
mod uniforms;

pub use blit::{Blit, Copyable};
pub use offscreen::{Offscreen, read};
pub use renderer::{Quality, Renderer};
pub use target::Target;
pub use wgpu;
