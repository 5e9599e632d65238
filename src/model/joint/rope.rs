//! The joint that limits the distance of two points.

use super::GenericJoint;
use super::kind::{joint_kind, joint_motor_methods};
use crate::dim::joint_axes::{JointAxesMask, JointAxis};
use crate::dim::math::Real;

joint_kind! {
    /// A joint that limits the distance of two points, one on each body.
    RopeJoint, RopeJointBuilder
}
joint_motor_methods!(RopeJoint, RopeJointBuilder, [JointAxis::LinX], ());

impl RopeJoint {
    /// A rope with this largest distance of the two points (length units).
    pub fn new(max_distance: Real) -> Self {
        let mut data = GenericJoint::new(JointAxesMask::empty());
        data.coupled_axes = JointAxesMask::LIN_AXES;
        let mut rope = Self { data };
        rope.data.set_limits(JointAxis::LinX, [0.0, 0.0]);
        rope.set_max_distance(max_distance);
        rope
    }

    /// The largest distance of the two points (length units).
    pub fn max_distance(&self) -> Real {
        self.data.limits[JointAxis::LinX as usize].max
    }

    /// Sets the largest distance of the two points (length units). A negative value is refused with a warning
    /// in the log.
    pub fn set_max_distance(&mut self, max_distance: Real) -> &mut Self {
        self.data.set_limits(JointAxis::LinX, [0.0, max_distance]);
        self
    }
}

impl RopeJointBuilder {
    /// A rope with this largest distance of the two points (length units).
    pub fn new(max_distance: Real) -> Self {
        Self(RopeJoint::new(max_distance))
    }

    /// Sets the largest distance of the two points.
    pub fn max_distance(mut self, max_distance: Real) -> Self {
        self.0.set_max_distance(max_distance);
        self
    }
}
