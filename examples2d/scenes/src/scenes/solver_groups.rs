//! Solver groups: contacts with events but without forces.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, add_fixed, square};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "solver_groups",
    description: "Ghosts pass a wall that stops other bodies; their contacts send events.",
    category: Category::Events,
    steps: 150,
    law: Law { overlap_max: 0.01, height_min: 0.0, reach_max: 7.0, ..Law::NONE },
    source: file!(),
    build,
};

const SOLID: Group = Group::GROUP_1;
const GHOST: Group = Group::GROUP_2;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = PhysicsWorld::new();
    for i in 0..6 {
        let floor = 2.0 * i as Real;
        add_fixed(&mut world, Vector::new(0.0, floor - 0.1), ColliderBuilder::cuboid(9.0, 0.1));
        let group = if i % 2 == 0 { SOLID } else { GHOST };
        let groups = InteractionGroups::new(group, Group::ALL);
        let shape = square(0.4).solver_groups(groups).friction(0.2);
        let body = add(&mut world, Vector::new(-6.0, floor + 0.4), shape);
        world.bodies[body].set_linvel(Vector::X * 9.0, true);
    }
    // The wall acts on solid bodies only.
    let wall =
        ColliderBuilder::cuboid(0.3, 6.0).solver_groups(InteractionGroups::new(Group::ALL, SOLID));
    add_fixed(&mut world, Vector::new(0.0, 6.0), wall);
    Scene::new(world, View::flat()).focusing(Vector::new(-9.0, 0.0), Vector::new(9.0, 12.0))
}
