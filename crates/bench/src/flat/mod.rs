//! Scenes in 2D, and the engines that run them.

use rapier2d as ours;
use rapier2d_f64 as double_engine;
use rapier2d_peer as peer;
use scenes2d as examples;

#[cfg(feature = "box2d")]
mod box2d;
#[cfg(feature = "box2d")]
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
    [v.x, v.y, 0.0]
}

/// Returns the vector of three numbers.
fn vector_of(v: [f32; 3]) -> Vector {
    Vector::new(v[0], v[1])
}

/// Creates the scene at its start in Box2D.
#[cfg(feature = "box2d")]
fn start_box(template: &Template, threads: usize) -> Result<Box<dyn Engine + '_>, Unsupported> {
    Ok(Box::new(box2d::Box2d::new(template, threads)?))
}

/// Returns the error of a build without Box2D.
#[cfg(not(feature = "box2d"))]
fn start_box(_: &Template, _: usize) -> Result<Box<dyn Engine + '_>, Unsupported> {
    Err(Unsupported::because("built without the feature box2d"))
}

/// Scenes of the gallery that contain only physics. The flag marks the default scenes.
const SCENES: [(&str, bool); 16] = [
    ("large_pyramid", true),
    ("many_pyramids", true),
    ("smash", false),
    ("tumbler", false),
    ("spinner", false),
    ("compounds", false),
    ("downpour", false),
    ("junkyard", false),
    ("ragdolls", false),
    ("washer", false),
    ("tower30", false),
    ("pyramid20", false),
    ("card_house", false),
    ("heavy_on_light", false),
    ("heightfield", false),
    ("joint_grid", false),
];

/// Returns the scenes in 2D.
pub fn scenes() -> Vec<Scene> {
    engines::catalog("2d", &SCENES)
}

/// Builds a world of few bodies in 2D.
pub fn small(world: Small) -> Box<dyn crate::engine::Template> {
    Box::new(Template::small(world))
}

/// Builds a growing world in 2D.
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
