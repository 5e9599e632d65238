//! Newton's cradle: momentum and energy pass through a row of balls.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add_post, flat, hinge, turn};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "newton_cradle",
    description: "Newton's cradles: equal numbers of balls swing out and in on opposite sides.",
    category: Category::Joints,
    steps: 112,
    law: Law { overlap_max: 0.01, height_min: -5.0, reach_max: 10.0, gap_max: 0.005, ..Law::NONE },
    source: file!(),
    build,
};

/// Number of balls of a cradle, their radius, and the length of their rods.
const BALLS: usize = 5;
const RADIUS: Real = 0.5;
const LENGTH: Real = 4.0;
/// Initial angle of the first balls (rad).
const SWING: Real = 0.8;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = PhysicsWorld::new();
    for raised in 1..=3 {
        let behind = Vector::Z * (-2.5 * (raised as Real - 1.0));
        for i in 0..BALLS {
            let post = Vector::X * (2.0 * RADIUS * i as Real) + behind;
            hang_ball(&mut world, post, if i < raised { -SWING } else { 0.0 });
        }
    }
    Scene::new(world, View::orbit(20.0, 10.0))
}

/// Hangs a ball on a rod, at an angle from the vertical.
fn hang_ball(world: &mut PhysicsWorld, place: Vector, angle: Real) {
    let post = add_post(world, place);
    let at = place + flat(angle.sin(), -angle.cos()) * LENGTH;
    let body = RigidBodyBuilder::dynamic().translation(at).rotation(turn(angle)).can_sleep(false);
    let ball = ColliderBuilder::ball(RADIUS).restitution(1.0).friction(0.0);
    let (ball, _) = world.insert(body, ball);
    world.insert_impulse_joint(post, ball, hinge().local_anchor2(Vector::Y * LENGTH));
}
