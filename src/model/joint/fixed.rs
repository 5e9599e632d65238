//! The joint that locks all axes.

use super::GenericJoint;
use super::kind::{joint_frame_methods, joint_kind};
use crate::dim::joint_axes::JointAxesMask;

joint_kind! {
    /// A joint that locks all axes: the two frames coincide.
    ///
    /// ```
    /// # use rapier3d::prelude::*;
    /// let mut world = PhysicsWorld::new();
    /// let (post, _) = world.insert(RigidBodyBuilder::fixed(), ColliderBuilder::ball(0.1));
    /// let (sign, _) = world.insert(RigidBodyBuilder::dynamic(), ColliderBuilder::ball(0.1));
    /// let joint = FixedJointBuilder::new().local_anchor2(vector![-1.0, 0.0, 0.0]);
    /// world.impulse_joints.insert(post, sign, joint, true);
    /// ```
    FixedJoint, FixedJointBuilder
}
joint_frame_methods!(FixedJoint, FixedJointBuilder);

impl Default for FixedJoint {
    fn default() -> Self {
        Self::new()
    }
}

impl Default for FixedJointBuilder {
    fn default() -> Self {
        Self::new()
    }
}

impl FixedJoint {
    /// A joint with both frames at the origins of the bodies.
    pub fn new() -> Self {
        Self { data: GenericJoint::new(JointAxesMask::LOCKED_FIXED_AXES) }
    }
}

impl FixedJointBuilder {
    /// A joint with both frames at the origins of the bodies.
    pub fn new() -> Self {
        Self(FixedJoint::new())
    }
}
