//! The joint that keeps two points from getting too far apart.

use super::GenericJoint;
use super::kind::{joint_kind, joint_motor_methods};
use crate::dim::joint_axes::{JointAxesMask, JointAxis};
use crate::dim::math::Real;

joint_kind! {
    /// Keeps two points, one on each body, from getting further apart than a distance.
    RopeJoint, RopeJointBuilder
}
joint_motor_methods!(RopeJoint, RopeJointBuilder, [JointAxis::LinX], ());

impl RopeJoint {
    /// A rope of a length.
    pub fn new(max_distance: Real) -> Self {
        let mut data = GenericJoint::new(JointAxesMask::empty());
        data.coupled_axes = JointAxesMask::LIN_AXES;
        let mut rope = Self { data };
        rope.data.set_limits(JointAxis::LinX, [0.0, 0.0]);
        rope.set_max_distance(max_distance);
        rope
    }

    /// The largest distance of the two points.
    pub fn max_distance(&self) -> Real {
        self.data.limits[JointAxis::LinX as usize].max
    }

    /// Sets the largest distance of the two points. A negative one is logged, and the old one stays.
    pub fn set_max_distance(&mut self, max_distance: Real) -> &mut Self {
        self.data.set_limits(JointAxis::LinX, [0.0, max_distance]);
        self
    }
}

impl RopeJointBuilder {
    /// A rope of a length.
    pub fn new(max_distance: Real) -> Self {
        Self(RopeJoint::new(max_distance))
    }

    /// Sets the largest distance of the two points.
    pub fn max_distance(mut self, max_distance: Real) -> Self {
        self.0.set_max_distance(max_distance);
        self
    }
}
