//! Friction on a slope: boxes below a critical coefficient slide.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::add_fixed;
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "friction",
    description: "Boxes with a friction from 0 to 1 on ramps of 27 degrees: those above 0.5 stay.",
    category: Category::Basics,
    steps: 150,
    law: Law { overlap_max: 0.02, height_min: -16.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Slope of a ramp, which is also the critical coefficient of friction.
const SLOPE: Real = 0.5;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = PhysicsWorld::new();
    add_fixed(&mut world, -Vector::Y * 17.0, ColliderBuilder::cuboid(200.0, 1.0));
    let angle = SLOPE.atan();
    let (along, up) =
        (Vector::new(angle.cos(), -angle.sin()), Vector::new(angle.sin(), angle.cos()));
    for i in 0..=10 {
        let friction = i as Real / 10.0;
        let [column, row] = [i % 4, i / 4].map(|n| n as Real);
        let foot = Vector::new(11.0 * column, -6.0 * row);
        let ramp = RigidBodyBuilder::fixed().translation(foot).rotation(-angle);
        world.insert(ramp, ColliderBuilder::cuboid(4.5, 0.1).friction(1.0));
        let shape = ColliderBuilder::cuboid(0.5, 0.35)
            .friction(friction)
            .friction_combine_rule(CoefficientCombineRule::Min);
        let place = foot - along * 3.6 + up * 0.45;
        world.insert(RigidBodyBuilder::dynamic().translation(place).rotation(-angle), shape);
    }
    Scene::new(world, View::flat()).focusing(Vector::new(-5.0, -15.0), Vector::new(38.0, 3.0))
}
