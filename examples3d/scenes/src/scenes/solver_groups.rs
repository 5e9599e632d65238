//! Solver groups: contacts with events but without forces.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, add_fixed, cube, world_with_floor};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "solver_groups",
    description: "Ghosts pass a wall that stops other bodies; their contacts send events.",
    category: Category::Events,
    steps: 150,
    law: Law { overlap_max: 0.01, height_min: 0.0, reach_max: 9.0, ..Law::NONE },
    source: file!(),
    build,
};

const SOLID: Group = Group::GROUP_1;
const GHOST: Group = Group::GROUP_2;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = world_with_floor(60.0);
    // The wall acts on solid bodies only; the floor acts on all.
    let wall = ColliderBuilder::cuboid(0.3, 0.8, 6.0)
        .solver_groups(InteractionGroups::new(Group::ALL, SOLID));
    add_fixed(&mut world, Vector::new(0.0, 0.8, 0.0), wall);
    for i in 0..10 {
        let z = 1.15 * (i as Real - 4.5);
        let group = if i % 2 == 0 { SOLID } else { GHOST };
        let groups = InteractionGroups::new(group, Group::ALL);
        let shape = cube(0.4).solver_groups(groups).friction(0.2);
        let body = add(&mut world, Vector::new(-6.0, 0.4, z), shape);
        world.bodies[body].set_linvel(Vector::X * 9.0, true);
    }
    Scene::new(world, View::orbit(-25.0, 35.0))
}
