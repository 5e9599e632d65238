//! Scenes of both dimensions: those of the galleries that contain only physics, and growing worlds.

use crate::catalog::Scene;
use crate::engine::Template;
use crate::growth::world::World;
use crate::small::Small;
use crate::{flat, solid};

/// Returns all scenes, 3D first.
pub fn all() -> Vec<Scene> {
    let mut scenes = solid::scenes();
    scenes.extend(flat::scenes());
    scenes
}

/// Builds a growing world in a dimension, `2d` or `3d`.
pub fn grown(dimension: &str, world: World) -> Box<dyn Template> {
    if dimension == "2d" { flat::grown(world) } else { solid::grown(world) }
}

/// Builds a world of few bodies in a dimension, `2d` or `3d`.
pub fn small(dimension: &str, world: Small) -> Box<dyn Template> {
    if dimension == "2d" { flat::small(world) } else { solid::small(world) }
}
