//! Joints that exist in 3D only, or have other constructors there.

use crate::dim::joint_axes::{JointAxesMask, JointAxis};
use crate::dim::math::{Real, Vector};
use crate::model::joint::kind::{joint_drive_methods, joint_frame_methods, joint_kind};
use crate::model::joint::views::joint_view;
use crate::model::joint::{
    GearJoint, GearJointBuilder, GenericJoint, RackJoint, RackJointBuilder, RevoluteJoint,
    RevoluteJointBuilder,
};

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

impl GearJoint {
    /// Gears about these axes of the bodies, each in the body's frame: see [`Self::ratio`]. The lengths of
    /// the axes do not matter. A ratio whose size is not between 1e-6 and 1e6 is logged and replaced by 1.
    ///
    /// ```
    /// # use rapier3d::prelude::*;
    /// # let mut world = PhysicsWorld::new();
    /// # let frame = world.insert_body(RigidBodyBuilder::fixed());
    /// # let mut wheel = |x: Real| {
    /// #     let body = RigidBodyBuilder::dynamic().translation(vector![x, 0.0, 0.0]);
    /// #     let (body, _) = world.insert(body, ColliderBuilder::cylinder(0.1, 0.4));
    /// #     let axle = RevoluteJointBuilder::new(Vector::Y).local_anchor1(vector![x, 0.0, 0.0]);
    /// #     world.insert_impulse_joint(frame, body, axle);
    /// #     body
    /// # };
    /// # let (small, large) = (wheel(0.0), wheel(1.0));
    /// // The large wheel has three times as many teeth, and rotates the other way.
    /// let gear = GearJoint::new(Vector::Y, Vector::Y, 3.0);
    /// world.insert_impulse_joint(small, large, gear);
    /// # world.bodies[small].set_angvel(vector![0.0, 4.0, 0.0], true);
    /// # for _ in 0..60 { world.step(); }
    /// # let [first, second] = [small, large].map(|wheel| world.bodies[wheel].angvel().y);
    /// # assert!((first + 3.0 * second).abs() < 1.0e-4);
    /// ```
    pub fn new(axis1: Vector, axis2: Vector, ratio: Real) -> Self {
        let mut gear = Self::of_ratio(ratio);
        gear.data.set_local_axis1(axis1).set_local_axis2(axis2);
        gear
    }
}

impl GearJointBuilder {
    /// Gears about two axes: see [`GearJoint::new`].
    pub fn new(axis1: Vector, axis2: Vector, ratio: Real) -> Self {
        Self(GearJoint::new(axis1, axis2, ratio))
    }
}

impl RackJoint {
    /// A pinion that rotates about an axis of the first body, and a rack along an axis of the second, each in
    /// the body's frame: see [`Self::radius`]. The lengths of the axes do not matter. A radius
    /// whose size is not between 1e-6 and 1e6 is logged and replaced by 1.
    pub fn new(axis1: Vector, axis2: Vector, radius: Real) -> Self {
        let mut rack = Self::of_radius(radius);
        rack.data.set_local_axis1(axis1).set_local_axis2(axis2);
        rack
    }
}

impl RackJointBuilder {
    /// A pinion and a rack: see [`RackJoint::new`].
    pub fn new(axis1: Vector, axis2: Vector, radius: Real) -> Self {
        Self(RackJoint::new(axis1, axis2, radius))
    }
}
