//! Collision groups: two kinds of bodies, each with its own shelf.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, add_fixed, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "collision_groups",
    description: "Balls and boxes fall through each other's shelf and rest on their own.",
    category: Category::Events,
    steps: 240,
    law: Law { overlap_max: 0.01, height_min: 0.0, reach_max: 8.0, speed_max: 0.1, ..Law::NONE },
    source: file!(),
    build,
};

const BALLS: Group = Group::GROUP_1;
const BOXES: Group = Group::GROUP_2;
const FLOOR: Group = Group::GROUP_32;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(50.0);
    for (y, group) in [(2.5, BALLS), (6.5, BOXES)] {
        // A shelf belongs to the group of its bodies, and collides with no other group.
        let shelf = ColliderBuilder::cuboid(7.0, 0.1)
            .collision_groups(InteractionGroups::new(group, group));
        add_fixed(&mut world, Vector::Y * y, shelf);
    }
    for i in 0..90 {
        let (shape, group) = if i % 2 == 0 {
            (ColliderBuilder::ball(0.4), BALLS)
        } else {
            (ColliderBuilder::cuboid(0.4, 0.3), BOXES)
        };
        let place = Vector::new(0.95 * ((i % 15) as Real - 7.0), 8.0 + (i / 15) as Real);
        // Bodies of other groups do not collide with it. The floor is in all groups.
        let groups = InteractionGroups::new(group, group | FLOOR);
        add(&mut world, place, shape.collision_groups(groups));
    }
    Scene::new(world, View::flat())
}
