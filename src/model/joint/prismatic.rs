//! The sliding joint along a common axis.

use super::GenericJoint;
use super::kind::{joint_axis_methods, joint_drive_methods, joint_kind};
use crate::dim::joint_axes::{JointAxesMask, JointAxis};
use crate::dim::math::Vector;

joint_kind! {
    /// A sliding joint: translation along a common axis, without relative rotation.
    PrismaticJoint, PrismaticJointBuilder
}
joint_axis_methods!(PrismaticJoint, PrismaticJointBuilder);
joint_drive_methods!(PrismaticJoint, PrismaticJointBuilder, [JointAxis::LinX], ());

impl PrismaticJoint {
    /// A joint along an axis, which is the same in the frames of both bodies. Its length does not matter. An
    /// axis without a direction is logged and replaced by X.
    pub fn new(axis: Vector) -> Self {
        let mut data = GenericJoint::new(JointAxesMask::LOCKED_PRISMATIC_AXES);
        data.set_local_axis1(axis).set_local_axis2(axis);
        Self { data }
    }
}

impl PrismaticJointBuilder {
    /// A joint along an axis: see [`PrismaticJoint::new`].
    pub fn new(axis: Vector) -> Self {
        Self(PrismaticJoint::new(axis))
    }
}
