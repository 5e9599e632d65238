//! Hashes of simulated state, for the comparison of two runs.
//!
//! A hash covers the bits of every quantity of an element that a step reads and writes, and that a user can
//! read. These are poses, velocities, forces, masses, sleep states, joint coordinates and impulses, and
//! touching pairs. Caches are left out: warm-start data that differ change a velocity in the same step.
//!
//! The hash function is the word mixer of [`crate::base::hash`]. It is no defence against forgery. It is
//! fast, and the same on every machine: words are 64 bits wide, and a number enters by its bits. `-0.0` and
//! `0.0` therefore differ, because `1.0 / x` does.

use super::body::{RigidBody, RigidBodySet};
use super::collider::{Collider, ColliderSet};
use super::contact::NarrowPhase;
use super::joint::{ImpulseJoint, ImpulseJointSet};
use super::multibody::{Multibody, MultibodyJointSet};
use crate::base::hash::MixHasher;
use crate::dim::math::{AngVector, Pose, Real, Vector};
use crate::dim::spatial::{ang_components, rotation_components};
use core::hash::Hasher as _;

/// Collects words and numbers.
#[derive(Default)]
struct StateHasher(MixHasher);

impl StateHasher {
    fn word(&mut self, word: impl Into<u64>) -> &mut Self {
        self.0.write_u64(word.into());
        self
    }

    /// The two halves of a handle.
    fn handle(&mut self, (slot, generation): (u32, u32)) -> &mut Self {
        self.word(u64::from(slot) << 32 | u64::from(generation))
    }

    fn reals(&mut self, numbers: &[Real]) -> &mut Self {
        for &number in numbers {
            self.word(number.to_bits());
        }
        self
    }

    fn vector(&mut self, vector: Vector) -> &mut Self {
        self.reals(&vector.to_array())
    }

    fn angular(&mut self, vector: AngVector) -> &mut Self {
        self.reals(&ang_components(vector))
    }

    fn pose(&mut self, pose: &Pose) -> &mut Self {
        self.vector(pose.translation).reals(&rotation_components(&pose.rotation))
    }

    fn finish(&self) -> u64 {
        self.0.finish()
    }
}

/// Combines the hashes of elements under their handles.
fn hash_all(elements: impl Iterator<Item = ((u32, u32), u64)>) -> u64 {
    let mut hasher = StateHasher::default();
    for (handle, hash) in elements {
        hasher.handle(handle).word(hash);
    }
    hasher.finish()
}

/// Combines hashes in their order.
fn combined_hash(hashes: impl IntoIterator<Item = u64>) -> u64 {
    let mut hasher = StateHasher::default();
    for hash in hashes {
        hasher.word(hash);
    }
    hasher.finish()
}

/// A hash of poses.
pub(crate) fn hash_of_poses(poses: &[Pose]) -> u64 {
    let mut hasher = StateHasher::default();
    for pose in poses {
        hasher.pose(pose);
    }
    hasher.finish()
}

/// The sets that a hash of a world covers.
pub(crate) struct WorldSets<'a> {
    pub bodies: &'a RigidBodySet,
    pub colliders: &'a ColliderSet,
    pub impulse_joints: &'a ImpulseJointSet,
    pub multibody_joints: &'a MultibodyJointSet,
    pub narrow_phase: &'a NarrowPhase,
}

/// A hash of all sets.
pub(crate) fn world_hash(world: &WorldSets<'_>) -> u64 {
    combined_hash([
        world.bodies.hash(),
        world.colliders.hash(),
        world.impulse_joints.hash(),
        world.multibody_joints.hash(),
        world.narrow_phase.hash(),
    ])
}

impl RigidBody {
    /// A hash of the body's state: pose, velocities, forces, mass, type, and whether it sleeps. Equal bits
    /// give equal hashes on every machine.
    ///
    /// ```
    /// # use rapier3d::prelude::*;
    /// let ball = RigidBodyBuilder::dynamic().linvel(Vector::X).build();
    /// let mut other = ball.clone();
    /// assert_eq!(ball.hash(), other.hash());
    /// other.set_linvel(Vector::X * 1.0000001, true);
    /// assert_ne!(ball.hash(), other.hash());
    /// ```
    pub fn hash(&self) -> u64 {
        let flags = u64::from(self.enabled) | u64::from(self.is_sleeping()) << 1;
        let (push_force, push_torque) = self.push;
        StateHasher::default()
            .pose(&self.pose)
            .vector(self.vels.linvel)
            .angular(self.vels.angvel)
            .vector(self.force + push_force)
            .angular(self.torque + push_torque)
            .vector(self.mprops.local_mprops.local_com)
            .reals(&[self.mass(), self.gravity_scale, self.linear_damping, self.angular_damping])
            .word(flags | (self.body_type as u64) << 2)
            .finish()
    }
}

impl Collider {
    /// A hash of the collider's state: pose, volume, material, parent, and whether it is enabled and a
    /// sensor. Equal bits give equal hashes on every machine.
    pub fn hash(&self) -> u64 {
        let flags = u64::from(self.is_enabled()) | u64::from(self.is_sensor()) << 1;
        let parent = self.parent().map_or((u32::MAX, u32::MAX), |body| body.into_raw_parts());
        StateHasher::default()
            .pose(&self.pose)
            .reals(&[self.friction(), self.restitution(), self.contact_skin, self.mass()])
            .handle(parent)
            .word(flags | (self.shape().shape_type() as u64) << 2)
            .finish()
    }
}

impl ImpulseJoint {
    /// A hash of the joint's state: bodies, impulses, the sum of a transmission, and whether it is enabled.
    /// Equal bits give equal hashes on every machine.
    pub fn hash(&self) -> u64 {
        let counted = self.count.map(|count| count.sum);
        StateHasher::default()
            .handle(self.body1.into_raw_parts())
            .handle(self.body2.into_raw_parts())
            .reals(&self.impulses)
            .reals(counted.as_slice())
            .word(u64::from(self.data.is_enabled()))
            .finish()
    }
}

impl Multibody {
    /// A hash of the multibody's state: coordinates and velocities of all degrees of freedom. Equal bits give
    /// equal hashes on every machine.
    pub fn hash(&self) -> u64 {
        let mut hasher = StateHasher::default();
        for link in self.links() {
            hasher.handle(link.rigid_body_handle().into_raw_parts());
            hasher.pose(&link.joint.body_to_parent());
        }
        hasher.reals(self.generalized_velocity()).finish()
    }
}

impl RigidBodySet {
    /// A hash of all bodies with their handles: see [`RigidBody::hash`].
    pub fn hash(&self) -> u64 {
        hash_all(self.iter().map(|(handle, body)| (handle.into_raw_parts(), body.hash())))
    }
}

impl ColliderSet {
    /// A hash of all colliders with their handles: see [`Collider::hash`].
    pub fn hash(&self) -> u64 {
        hash_all(self.iter().map(|(handle, collider)| (handle.into_raw_parts(), collider.hash())))
    }
}

impl ImpulseJointSet {
    /// A hash of all joints with their handles: see [`ImpulseJoint::hash`].
    pub fn hash(&self) -> u64 {
        hash_all(self.iter().map(|(handle, joint)| (handle.into_raw_parts(), joint.hash())))
    }
}

impl MultibodyJointSet {
    /// A hash of all multibodies: see [`Multibody::hash`].
    pub fn hash(&self) -> u64 {
        hash_all(self.multibodies().map(|multibody| ((0, 0), multibody.hash())))
    }
}

impl NarrowPhase {
    /// A hash of all pairs: their colliders, and whether the colliders touch.
    pub fn hash(&self) -> u64 {
        let mut hasher = StateHasher::default();
        for (collider1, collider2, pair) in self.contact_pairs() {
            hasher.handle(collider1.into_raw_parts()).handle(collider2.into_raw_parts());
            hasher.word(u64::from(pair.has_any_active_contact()));
        }
        for (collider1, collider2, intersects) in self.intersection_pairs() {
            hasher.handle(collider1.into_raw_parts()).handle(collider2.into_raw_parts());
            hasher.word(u64::from(intersects));
        }
        hasher.finish()
    }
}
