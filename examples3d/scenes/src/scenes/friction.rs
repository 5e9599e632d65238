//! Friction on a slope: boxes below a critical coefficient slide.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::world_with_floor;
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "friction",
    description: "Boxes with a friction from 0 to 1 on a ramp of 27 degrees: those above 0.5 stay.",
    category: Category::Basics,
    steps: 150,
    law: Law { overlap_max: 0.01, height_min: 0.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Slope of the ramp, which is also the critical coefficient of friction.
const SLOPE: Real = 0.5;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(200.0);
    let angle = SLOPE.atan();
    let (along, up) =
        (Vector::new(angle.cos(), -angle.sin(), 0.0), Vector::new(angle.sin(), angle.cos(), 0.0));
    let foot = Vector::new(0.0, 4.0, 0.0);
    let turn = Vector::Z * -angle;
    let ramp = RigidBodyBuilder::fixed().translation(foot).rotation(turn);
    world.insert(ramp, ColliderBuilder::cuboid(8.0, 0.2, 8.0).friction(1.0));
    for i in 0..=10 {
        let friction = i as Real / 10.0;
        let z = 1.4 * (i as Real - 5.0);
        let place = foot - along * 6.5 + up * 0.6 + Vector::Z * z;
        let shape = ColliderBuilder::cuboid(0.5, 0.4, 0.5)
            .friction(friction)
            .friction_combine_rule(CoefficientCombineRule::Min);
        world.insert(RigidBodyBuilder::dynamic().translation(place).rotation(turn), shape);
    }
    Scene::new(world, View::orbit(60.0, 22.0))
        .focusing(Vector::new(-7.0, 0.0, -8.0), Vector::new(12.0, 8.0, 8.0))
}
