//! Two bodies that nobody touches. Whatever happens around them, they stay where they are, to the last bit.
//!
//! They lean on each other without weight and without overlap, in a group of their own: no force acts on them, so
//! the laws of motion leave them no freedom at all, in steps of any length.

use super::colliders::APART;
use super::dim::cuboid;
use super::rapier::prelude::*;

/// Where they stand.
const PLACE: Real = 64.0;
/// How to know them from bodies that have the same handles in other sets.
const MARK: u128 = 0x0b57;

/// The two bodies, and where they were put.
pub struct Bystanders {
    pub bodies: [RigidBodyHandle; 2],
    pub colliders: [ColliderHandle; 2],
    poses: [Pose; 2],
    /// Something held on to one of them: both may be anywhere since, because they push each other.
    were_held: bool,
}

impl Bystanders {
    pub fn new(world: &mut PhysicsWorld) -> Self {
        let own = InteractionGroups::new(APART, APART);
        let mut stand = |height: Real| {
            let body =
                RigidBodyBuilder::dynamic().translation(Vector::ONE * PLACE + Vector::Y * height);
            let body = body.gravity_scale(0.0).user_data(MARK);
            world.insert(body, cuboid(0.5).collision_groups(own).user_data(MARK))
        };
        let ((body1, collider1), (body2, collider2)) = (stand(0.0), stand(1.0));
        let bodies = [body1, body2];
        let poses = bodies.map(|body| *world.bodies[body].position());
        Self { bodies, colliders: [collider1, collider2], poses, were_held: false }
    }

    /// Notes who is held by anything.
    ///
    /// Others have the same handles in worlds that begin anew, and what belongs to them comes to the bystanders when a whole set is
    /// exchanged. To be called before a step, which may break joints, and behind it, when all sets have heard of it.
    pub fn look(&mut self, world: &PhysicsWorld) {
        self.were_held |= self.bodies.iter().any(|&handle| is_held(world, handle));
    }

    /// # Panics
    /// If one has moved. Who is not there any more (because a whole set was exchanged) has not.
    pub fn check(&self, world: &PhysicsWorld) {
        if self.were_held {
            return;
        }
        for (handle, pose) in self.bodies.iter().zip(&self.poses) {
            let Some(body) = bystander(world, *handle) else { continue };
            assert!(
                body.position() == pose && body.vels().is_zero(),
                "nobody touched {handle:?}, but it moved from {pose:?} to {:?}",
                body.position()
            );
        }
    }
}

/// The body with this handle, if it is not another world's.
fn bystander(world: &PhysicsWorld, handle: RigidBodyHandle) -> Option<&RigidBody> {
    world.bodies.get(handle).filter(|body| body.user_data == MARK)
}

/// Does anything hold on to a bystander, a collider that is not its own or a joint?
fn is_held(world: &PhysicsWorld, handle: RigidBodyHandle) -> bool {
    let is_own = |&collider: &_| {
        world.colliders.get(collider).is_some_and(|collider| collider.user_data == MARK)
    };
    bystander(world, handle).is_some_and(|body| {
        !body.colliders().iter().all(is_own)
            || world.impulse_joints.attached_joints(handle).next().is_some()
            || world.multibody_joints.attached_bodies(handle).next().is_some()
    })
}
