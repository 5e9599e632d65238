//! Exhibits of joints: each between a post and a hanging body, in rows, with labels above.

use super::Scene;
use crate::kit::{add, add_post, brick, flat, hinge, near};
use crate::rapier::prelude::*;
use gallery::View;

/// Joins a body to a post, and returns the body.
pub type Stand = fn(&mut PhysicsWorld, RigidBodyHandle) -> RigidBodyHandle;

/// Number of posts per row, and their distance.
const IN_ROW: usize = 4;
const ACROSS: Real = 4.0;
const UP: Real = 4.2;
/// Half extents of the hanging body: along its height, and across.
pub const HALF: Real = 0.6;
const HALF_ACROSS: [Real; 2] = [0.22, 0.3];
/// Steps between two pushes, and the velocity of a push, across and towards the eye.
const REST: usize = 120;
const PUSH: [Real; 2] = [2.4, 2.4];

/// Vector from the post to the middle of the hanging body.
pub fn down() -> Vector {
    Vector::Y * -1.1
}

/// Builds a scene of stands. All bodies are pushed every two seconds.
pub fn show(stands: &[(&'static str, Stand)], view: View) -> Scene {
    let mut world = PhysicsWorld::new();
    let (mut hung, mut labels) = (Vec::new(), Vec::new());
    for (i, &(name, stand)) in stands.iter().enumerate() {
        let (column, row) = ((i % IN_ROW) as Real, (i / IN_ROW) as Real);
        let place = flat(ACROSS * column, -UP * row);
        let post = add_post(&mut world, place);
        hung.push(stand(&mut world, post));
        labels.push((place + Vector::Y * 0.8, name));
    }
    let scene = Scene::new(world, view)
        .showing_joints(0.6)
        .focusing(flat(-1.0, -UP - 2.2), flat(3.0 * ACROSS + 1.0, 1.6));
    let scene = labels.into_iter().fold(scene, |scene, (at, name)| scene.label(at, name));
    let push = flat(PUSH[0], 0.0) + near(PUSH[1]);
    scene.script(move |world, step| {
        if step.is_multiple_of(REST) {
            for &body in &hung {
                let body = &mut world.bodies[body];
                // The push is off the middle, so that the body rotates as well.
                let off = flat(HALF_ACROSS[0], HALF) + near(HALF_ACROSS[1]);
                let at = body.translation() + off * 0.3;
                body.apply_impulse_at_point(push * body.mass(), at, true);
            }
        }
    })
}

/// Adds a body at a distance from a post, and joins both.
pub fn hang(
    world: &mut PhysicsWorld,
    post: RigidBodyHandle,
    offset: Vector,
    joint: impl Into<GenericJoint>,
) -> RigidBodyHandle {
    let place = world.bodies[post].translation() + offset;
    let shape = brick(HALF_ACROSS[0], HALF, HALF_ACROSS[1]);
    let body = add(world, place, ColliderBuilder::new(shape));
    world.impulse_joints.insert(post, body, joint, true);
    body
}

/// Joins a body with all axes locked.
pub fn fixed(world: &mut PhysicsWorld, post: RigidBodyHandle) -> RigidBodyHandle {
    let beside = Vector::X;
    hang(world, post, beside, FixedJointBuilder::new().local_anchor2(-beside))
}

/// Joins a body by a hinge with limits.
pub fn revolute(world: &mut PhysicsWorld, post: RigidBodyHandle) -> RigidBodyHandle {
    hang(world, post, down(), hinge().local_anchor2(-down()).limits([-0.8, 0.8]))
}

/// Joins a body by a slider along a slope.
pub fn prismatic(world: &mut PhysicsWorld, post: RigidBodyHandle) -> RigidBodyHandle {
    let slope = flat(1.0, -0.15);
    let joint = PrismaticJointBuilder::new(slope).local_anchor2(-down()).limits([-1.2, 1.2]);
    hang(world, post, down(), joint)
}

/// Hangs a body on a rope, at its upper end.
pub fn rope(world: &mut PhysicsWorld, post: RigidBodyHandle) -> RigidBodyHandle {
    let joint = RopeJointBuilder::new(1.4).local_anchor2(Vector::Y * HALF);
    hang(world, post, flat(0.5, -1.5), joint)
}

/// Hangs a body on a spring, at its upper end.
pub fn spring(world: &mut PhysicsWorld, post: RigidBodyHandle) -> RigidBodyHandle {
    let joint = SpringJointBuilder::new(Vector::ZERO, Vector::Y * HALF, 0.8, 20.0).damping(0.3);
    hang(world, post, down() * 1.4, joint)
}
