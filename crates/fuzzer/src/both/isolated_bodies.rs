//! Two isolated bodies that keep their poses to the last bit, whatever operations the rest of the world gets.
//!
//! They touch each other without overlap, without gravity, and in a separate interaction group. No force acts
//! on them, so the laws of motion keep them at rest in steps of any length.

use super::dim::cuboid;
use super::groups::ISOLATED;
use super::rapier::prelude::*;

/// Coordinate of the bodies along all axes.
const PLACE: Real = 64.0;
/// User data that distinguishes the two bodies from bodies with the same handles in other sets.
const MARK: u128 = 0x0b57;

/// The two bodies and their initial poses.
pub struct IsolatedBodies {
    pub bodies: [RigidBodyHandle; 2],
    pub colliders: [ColliderHandle; 2],
    poses: [Pose; 2],
    /// Whether another collider or a joint was ever attached to one of them. Their poses are then
    /// unconstrained, because they push each other.
    were_attached: bool,
}

impl IsolatedBodies {
    pub fn new(world: &mut PhysicsWorld) -> Self {
        let own = InteractionGroups::new(ISOLATED, ISOLATED);
        let mut insert = |height: Real| {
            let body =
                RigidBodyBuilder::dynamic().translation(Vector::ONE * PLACE + Vector::Y * height);
            let body = body.gravity_scale(0.0).user_data(MARK);
            world.insert(body, cuboid(0.5).collision_groups(own).user_data(MARK))
        };
        let ((body1, collider1), (body2, collider2)) = (insert(0.0), insert(1.0));
        let bodies = [body1, body2];
        let poses = bodies.map(|body| *world.bodies[body].position());
        Self { bodies, colliders: [collider1, collider2], poses, were_attached: false }
    }

    /// Records whether another collider or a joint is attached to one of them.
    ///
    /// New worlds reuse the same handles. An exchange of a whole set can attach another world's colliders and
    /// joints to the isolated bodies. Callers invoke this before a step, which may break joints, and after
    /// it, with all sets updated.
    pub fn note_attachments(&mut self, world: &PhysicsWorld) {
        self.were_attached |= self.bodies.iter().any(|&handle| is_attached(world, handle));
    }

    /// # Panics
    /// If one of the bodies has moved. Bodies that an exchange of a whole set removed are ignored.
    pub fn check(&self, world: &PhysicsWorld) {
        if self.were_attached {
            return;
        }
        for (handle, pose) in self.bodies.iter().zip(&self.poses) {
            let Some(body) = isolated_body(world, *handle) else { continue };
            assert!(
                body.position() == pose && body.vels().is_zero(),
                "isolated body {handle:?} moved from {pose:?} to {:?}",
                body.position()
            );
        }
    }
}

/// Returns the body with this handle, unless it belongs to another world.
fn isolated_body(world: &PhysicsWorld, handle: RigidBodyHandle) -> Option<&RigidBody> {
    world.bodies.get(handle).filter(|body| body.user_data == MARK)
}

/// Returns whether a joint or another collider is attached to an isolated body.
fn is_attached(world: &PhysicsWorld, handle: RigidBodyHandle) -> bool {
    let is_own = |&collider: &_| {
        world.colliders.get(collider).is_some_and(|collider| collider.user_data == MARK)
    };
    isolated_body(world, handle).is_some_and(|body| {
        !body.colliders().iter().all(is_own)
            || world.impulse_joints.attached_joints(handle).next().is_some()
            || world.multibody_joints.attached_bodies(handle).next().is_some()
    })
}
