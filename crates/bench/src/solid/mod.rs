//! Scenes in 3D, and the engines that run them.

use rapier3d as ours;
use rapier3d_f64 as double_engine;
use rapier3d_peer as peer;
use scenes3d as examples;

#[cfg(feature = "box3d")]
mod box3d;
#[cfg(feature = "box3d")]
#[path = "../both/box_engines.rs"]
mod box_engines;
mod dim;
#[path = "../both/double.rs"]
mod double;
#[path = "../both/engines.rs"]
mod engines;
#[path = "../both/overlap.rs"]
mod overlap;
#[path = "../both/rapier.rs"]
mod rapier;
#[path = "../both/same.rs"]
mod same;
#[path = "../both/separation.rs"]
mod separation;
#[path = "../both/small_worlds.rs"]
mod small_worlds;
#[path = "../both/template.rs"]
mod template;
#[path = "../both/this.rs"]
mod this;
#[path = "../both/wide.rs"]
mod wide;
#[path = "../both/worlds.rs"]
mod worlds;

use crate::catalog::Scene;
use crate::engine::{Engine, Unsupported};
use crate::growth::world::World;
use crate::small::Small;
use ours::math::Vector;
use template::Template;

/// Returns a vector as three numbers.
fn three(v: Vector) -> [f32; 3] {
    [v.x, v.y, v.z]
}

/// Returns the vector of three numbers.
fn vector_of(v: [f32; 3]) -> Vector {
    Vector::from_array(v)
}

/// Creates the scene at its start in Box3D.
#[cfg(feature = "box3d")]
fn start_box(template: &Template, threads: usize) -> Result<Box<dyn Engine + '_>, Unsupported> {
    Ok(Box::new(box3d::Box3d::new(template, threads)?))
}

/// Returns the error of a build without Box3D.
#[cfg(not(feature = "box3d"))]
fn start_box(_: &Template, _: usize) -> Result<Box<dyn Engine + '_>, Unsupported> {
    Err(Unsupported::because("built without the feature box3d"))
}

/// Scenes of the gallery that contain only physics. The flag marks the default scenes.
const SCENES: [(&str, bool); 23] = [
    ("large_pyramid", true),
    ("many_pyramids", true),
    ("convex_pile", true),
    ("tower30", false),
    ("pyramid20", false),
    ("junkyard", false),
    ("washer", false),
    ("large_world", false),
    ("card_house", false),
    ("heavy_on_light", false),
    ("trimesh", false),
    ("heightfield", false),
    ("fine_mesh", false),
    ("tiles", false),
    ("cobbles", false),
    ("glide_mesh", false),
    ("glide_box", false),
    ("joint_grid", false),
    ("ragdolls", false),
    ("ragdoll_rain", false),
    ("trees100", false),
    ("trees50", false),
    ("trees25", false),
];

/// Returns the scenes in 3D.
pub fn scenes() -> Vec<Scene> {
    engines::catalog("3d", &SCENES)
}

/// Builds a world of few bodies in 3D.
pub fn small(world: Small) -> Box<dyn crate::engine::Template> {
    Box::new(Template::small(world))
}

/// Builds a growing world in 3D.
pub fn grown(world: World) -> Box<dyn crate::engine::Template> {
    Box::new(Template::grown(world))
}

#[cfg(test)]
mod tests {
    #[test]
    fn every_scene_is_in_the_gallery() {
        assert_eq!(super::scenes().len(), super::SCENES.len());
    }
}
