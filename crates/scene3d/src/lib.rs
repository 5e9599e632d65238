//! # A 3D scene: a world, and all that belongs to it beside physics
//!
//! [`Scene`] steps a world with a script, hooks and reactions to events; the gallery runs it, and the
//! testbed shows it. [`Artist`] turns its world into a drawing.

pub use rapier3d as rapier;

mod common;
mod shapes;

pub use common::{
    Artist, BodyColors, Controls, Law, Overlays, Scene, SceneInfo, Script, StepEvents, entries, gap,
};
pub use shapes::point;
