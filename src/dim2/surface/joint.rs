//! Joints that exist in 2D only, or have other constructors there.

use crate::dim::joint_axes::{JointAxesMask, JointAxis};
use crate::dim::math::{Real, Vector};
use crate::model::joint::kind::{joint_axis_methods, joint_drive_methods, joint_kind};
use crate::model::joint::views::joint_view;
use crate::model::joint::{
    GearJoint, GearJointBuilder, GenericJoint, RackJoint, RackJointBuilder, RevoluteJoint,
    RevoluteJointBuilder,
};

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
    /// A joint whose pin on the second body slides and rotates in a slot of the first body, like a wheel on a
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
    /// A slot along an axis, which is the same in the frames of both bodies. Its length does not matter. An
    /// axis without a direction is logged and replaced by X.
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

impl GearJoint {
    /// Gears of this ratio: see [`Self::ratio`]. A ratio whose size is not between 1e-6 and 1e6 is logged
    /// and replaced by 1.
    pub fn new(ratio: Real) -> Self {
        Self::of_ratio(ratio)
    }
}

impl GearJointBuilder {
    /// Gears of this ratio: see [`GearJoint::new`].
    pub fn new(ratio: Real) -> Self {
        Self(GearJoint::new(ratio))
    }
}

impl RackJoint {
    /// A pinion, and a rack along an axis of the second body, in that body's frame: see [`Self::radius`]. The
    /// length of the axis does not matter. A radius whose size is not between 1e-6 and 1e6 is logged and
    /// replaced by 1.
    pub fn new(axis: Vector, radius: Real) -> Self {
        let mut rack = Self::of_radius(radius);
        rack.data.set_local_axis2(axis);
        rack
    }
}

impl RackJointBuilder {
    /// A pinion and a rack: see [`RackJoint::new`].
    pub fn new(axis: Vector, radius: Real) -> Self {
        Self(RackJoint::new(axis, radius))
    }
}
