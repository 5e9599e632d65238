//! Closed loops of joints: Theo Jansen's walking machine.

use crate::common::{Law, Scene, SceneInfo, Strider, turns};
use crate::kit::{HALF_TURN, add, cube, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "strider",
    description: "Theo Jansen's walking machine: eight legs of bars and hinges in closed loops, and one motor.",
    category: Category::Joints,
    steps: 240,
    law: Law { overlap_max: 0.02, height_min: 0.0, gap_max: 0.01, ..Law::NONE },
    source: file!(),
    build,
};

/// Depth of the first plane of legs on each side, and the distance of neighbouring planes.
const FIRST_PLANE: Real = 0.7;
const PLANE_DISTANCE: Real = 0.25;
/// Speed of the crank (rad/s).
const SPEED: Real = -4.0;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(60.0);
    let planes = |side: Real, first: Real| {
        let angles = turns(2, first).enumerate();
        angles.map(move |(k, angle)| (side * (FIRST_PLANE + PLANE_DISTANCE * k as Real), angle))
    };
    let pairs: Vec<_> = planes(1.0, 0.0).chain(planes(-1.0, 0.5 * HALF_TURN)).collect();
    Strider::new(&mut world, Vector::X * -5.0, &pairs, FIRST_PLANE, SPEED);
    for i in 0..5 {
        let place = Vector::new(2.5, 0.2 + 0.4 * i as Real, 0.0);
        add(&mut world, place, cube(0.2).density(0.5));
    }
    Scene::new(world, View::orbit(30.0, 14.0))
        .focusing(Vector::new(-5.0, 0.0, -1.5), Vector::new(4.0, 3.0, 1.5))
}
