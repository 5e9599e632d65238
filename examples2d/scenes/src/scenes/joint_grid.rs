//! Net of balls, each joined to its left and its upper neighbour: thousands of closed loops.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::add;
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "joint_grid",
    description: "100 × 100 balls joined to a net of 19,800 hinges, held by seven in the middle of its top row.",
    category: Category::Stress,
    steps: 200,
    law: Law { overlap_max: 0.01, height_min: -101.0, reach_max: 57.0, gap_max: 0.2, ..Law::NONE },
    source: file!(),
    build,
};

/// Balls along each side.
const SIDE: usize = 100;
/// Largest distance of a fixed ball from the middle of the top row, in balls.
const FIXED_BALLS_REACH: usize = 3;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = PhysicsWorld::new();
    let mut balls = Vec::with_capacity(SIDE * SIDE);
    // Balls do not collide, so that only joints act.
    let ball = ColliderBuilder::ball(0.4).density(1.0).collision_groups(InteractionGroups::none());
    for column in 0..SIDE {
        for row in 0..SIDE {
            let place = Vector::new(column as Real - 0.5 * SIDE as Real, -(row as Real));
            let body = add(&mut world, place, ball.clone());
            if row == 0 && column.abs_diff(SIDE / 2) <= FIXED_BALLS_REACH {
                world.bodies[body].set_body_type(RigidBodyType::Fixed, false);
            }
            if row > 0 {
                join(&mut world, balls[balls.len() - 1], body, -Vector::Y);
            }
            if column > 0 {
                join(&mut world, balls[balls.len() - SIDE], body, Vector::X);
            }
            balls.push(body);
        }
    }
    Scene::new(world, View::flat())
}

/// Joins two balls at their midpoint; `way` is the vector from the first to the second.
fn join(world: &mut PhysicsWorld, first: RigidBodyHandle, second: RigidBodyHandle, way: Vector) {
    let hinge = RevoluteJointBuilder::new().local_anchor1(0.5 * way).local_anchor2(-0.5 * way);
    world.insert_impulse_joint(first, second, hinge);
}
