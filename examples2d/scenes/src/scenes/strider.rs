//! Closed loops of joints: Theo Jansen's walking machine.

use crate::common::{Law, Scene, SceneInfo, Strider, turns};
use crate::kit::{add, square, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "strider",
    description: "Theo Jansen's walking machine: six legs of bars and hinges in closed loops, and one motor.",
    category: Category::Joints,
    steps: 240,
    law: Law { overlap_max: 0.01, height_min: 0.0, gap_max: 0.03, ..Law::NONE },
    source: file!(),
    build,
};

/// Speed of the crank (rad/s).
const SPEED: Real = -4.0;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(60.0);
    let pairs: Vec<_> = turns(3, 0.0).map(|angle| (0.0, angle)).collect();
    Strider::new(&mut world, Vector::X * -5.0, &pairs, 0.0, SPEED);
    for i in 0..5 {
        add(&mut world, Vector::new(2.5, 0.2 + 0.4 * i as Real), square(0.2).density(0.5));
    }
    Scene::new(world, View::flat()).focusing(Vector::new(-6.5, -0.3), Vector::new(5.0, 3.6))
}
