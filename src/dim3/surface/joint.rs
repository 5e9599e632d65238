//! Joints that exist in 3D only, or have other constructors there.

use crate::dim::joint_axes::{JointAxesMask, JointAxis};
use crate::dim::math::{Real, Vector};
use crate::model::joint::kind::{joint_drive_methods, joint_frame_methods, joint_kind};
use crate::model::joint::views::joint_view;
use crate::model::joint::{GenericJoint, RevoluteJoint, RevoluteJointBuilder};

impl RevoluteJoint {
    /// A hinge about an axis, which is the same in the frames of both bodies. Its length does not matter. An
    /// axis without a direction is logged and replaced by X.
    pub fn new(axis: Vector) -> Self {
        let mut data = GenericJoint::new(JointAxesMask::LOCKED_REVOLUTE_AXES);
        data.set_local_axis1(axis).set_local_axis2(axis);
        Self { data }
    }
}

impl RevoluteJointBuilder {
    /// A hinge about an axis: see [`RevoluteJoint::new`].
    pub fn new(axis: Vector) -> Self {
        Self(RevoluteJoint::new(axis))
    }
}

joint_kind! {
    /// A ball-and-socket joint: it locks the translations and leaves all rotations free.
    ///
    /// The joint has two kinds of limits. With limits per axis ([`Self::set_limits`]), `AngX` bounds the
    /// twist, and `AngY` and `AngZ` the swing about these axes. With a cone ([`Self::set_swing_limit`]), one
    /// angle bounds the swing and `AngX` the twist, as for shoulders and hips.
    ///
    /// ```
    /// # use rapier3d::prelude::*;
    /// let shoulder = SphericalJointBuilder::new()
    ///     .local_anchor1(vector![0.3, 0.5, 0.0])
    ///     .swing_limit(1.2)
    ///     .limits(JointAxis::AngX, [-0.5, 0.5])
    ///     .build();
    /// assert_eq!(shoulder.swing_limit(), Some(1.2));
    /// ```
    SphericalJoint, SphericalJointBuilder
}
joint_frame_methods!(SphericalJoint, SphericalJointBuilder);
joint_drive_methods!(SphericalJoint, SphericalJointBuilder, [], (axis: JointAxis));
joint_view!(
    as_spherical,
    as_spherical_mut,
    SphericalJoint,
    JointAxesMask::LOCKED_SPHERICAL_AXES,
    JointAxesMask::empty()
);

/// The two axes of the swing.
const SWING_AXES: JointAxesMask = JointAxesMask::ANG_Y.union(JointAxesMask::ANG_Z);

impl Default for SphericalJoint {
    fn default() -> Self {
        Self::new()
    }
}

impl Default for SphericalJointBuilder {
    fn default() -> Self {
        Self::new()
    }
}

impl SphericalJoint {
    /// A ball-and-socket joint with its anchors at the origins of the bodies.
    pub fn new() -> Self {
        Self { data: GenericJoint::new(JointAxesMask::LOCKED_SPHERICAL_AXES) }
    }

    /// The largest angle (radians) between the X axes of the two frames; `None` without a limit.
    pub fn swing_limit(&self) -> Option<Real> {
        let coupled = self.data.coupled_axes.contains(SWING_AXES);
        let limits = self.data.limits(JointAxis::AngY).filter(|_| coupled)?;
        Some(limits.max)
    }

    /// Sets the largest angle (radians) between the X axes of the two frames. After this call, `AngY` is the
    /// swing in any direction.
    pub fn set_swing_limit(&mut self, angle: Real) -> &mut Self {
        self.data.coupled_axes |= SWING_AXES;
        self.data.set_limits(JointAxis::AngY, [0.0, angle]);
        self
    }
}

impl SphericalJointBuilder {
    /// A ball-and-socket joint with its anchors at the origins of the bodies.
    pub fn new() -> Self {
        Self(SphericalJoint::new())
    }

    /// Sets the largest angle between the X axes of the two frames: see
    /// [`SphericalJoint::set_swing_limit`].
    pub fn swing_limit(mut self, angle: Real) -> Self {
        self.0.set_swing_limit(angle);
        self
    }
}
