//! Joints that only 2D has, or that are made differently there.

use crate::dim::joint_axes::{JointAxesMask, JointAxis};
use crate::dim::math::Vector;
use crate::model::joint::kind::{joint_axis_methods, joint_drive_methods, joint_kind};
use crate::model::joint::views::joint_view;
use crate::model::joint::{GenericJoint, RevoluteJoint, RevoluteJointBuilder};

impl Default for RevoluteJoint {
    fn default() -> Self {
        Self::new()
    }
}

impl Default for RevoluteJointBuilder {
    fn default() -> Self {
        Self::new()
    }
}

impl RevoluteJoint {
    /// A revolute joint through the origins of the bodies.
    pub fn new() -> Self {
        Self { data: GenericJoint::new(JointAxesMask::LOCKED_REVOLUTE_AXES) }
    }
}

impl RevoluteJointBuilder {
    /// A revolute joint through the origins of the bodies.
    pub fn new() -> Self {
        Self(RevoluteJoint::new())
    }
}

joint_kind! {
    /// A pin of the second body slides in a slot of the first one, and rotates there: a wheel on a
    /// suspension.
    PinSlotJoint, PinSlotJointBuilder
}
joint_axis_methods!(PinSlotJoint, PinSlotJointBuilder);
joint_drive_methods!(PinSlotJoint, PinSlotJointBuilder, [JointAxis::LinX], ());
joint_view!(
    as_pin_slot,
    as_pin_slot_mut,
    PinSlotJoint,
    JointAxesMask::LOCKED_PIN_SLOT_AXES,
    JointAxesMask::empty()
);

impl PinSlotJoint {
    /// A slot along an axis, given in the frames of both bodies. Its length does not matter; one without
    /// a direction is logged, and X taken instead.
    pub fn new(axis: Vector) -> Self {
        let mut data = GenericJoint::new(JointAxesMask::LOCKED_PIN_SLOT_AXES);
        data.set_local_axis1(axis).set_local_axis2(axis);
        Self { data }
    }
}

impl PinSlotJointBuilder {
    /// A slot along an axis: see [`PinSlotJoint::new`].
    pub fn new(axis: Vector) -> Self {
        Self(PinSlotJoint::new(axis))
    }
}
