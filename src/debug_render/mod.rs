//! # Debug rendering: a world as lines
//!
//! Reads:   bodies, colliders, contacts, joints
//! Writes:  nothing but lines, to a [`DebugRenderBackend`] of the user's
//! Never:   changes the world; decides how a line is drawn
//!
//! [`DebugRenderPipeline`] draws the objects that [`DebugRenderMode`] selects. Every line has its object and
//! a colour of the [`DebugRenderStyle`]. The outlines of shapes are in
//! `dim2/outline.rs` and `dim3/outline.rs`.

mod backend;
mod joints;
mod outlines;
mod pipeline;
mod sketch;
mod style;

#[cfg(test)]
mod tests;

pub use backend::{DebugRenderBackend, DebugRenderObject};
pub use pipeline::{DebugRenderMode, DebugRenderPipeline};
pub use style::{DebugColor, DebugRenderStyle};
