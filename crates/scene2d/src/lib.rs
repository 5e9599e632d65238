//! # A 2D scene: a world, its script and its drawing
//!
//! [`Scene`] steps a world with a script, hooks and reactions to events; the gallery runs it, and the testbed
//! shows it. [`Artist`] turns its world into a drawing.

pub use rapier2d as rapier;

#[path = "../../scene3d/src/common/mod.rs"]
mod common;
mod shapes;

pub use common::{
    Artist, BodyColors, Controls, Law, Overlays, Scene, SceneInfo, Script, StepEvents, entries, gap,
};
pub use shapes::point;
