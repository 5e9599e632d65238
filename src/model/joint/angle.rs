//! The angles of free rotations, from the rotations of the bodies.

use super::GenericJoint;
use super::generic::{mask_of, relative_rotation};
use crate::dim::joint_angle::{FreeRotations, angle_about};
use crate::dim::joint_axes::{JointAxesMask, JointAxis};
use crate::dim::math::{Real, Rotation};

impl GenericJoint {
    /// The angle (radians, in `-π..=π`) of the second joint frame relative to the first about an axis, for
    /// bodies with these rotations. `None` for translations and locked rotations.
    ///
    /// It is the angle to which the limits and the motor of this axis apply. A single free rotation has the
    /// angle of the whole relative rotation. Two have the components of its rotation vector. If all are free,
    /// `AngX` is the *twist* about the second frame's X axis, and the others are the *swing*, the shortest
    /// rotation that leads the first frame's X axis to the second frame's: the components of its rotation
    /// vector. Coupled rotations have a common angle, which is not negative: the swing in any direction, or
    /// the angle of the whole rotation. Two free rotations of a multibody have other angles, those of a
    /// universal joint: [`MultibodyJoint`](crate::dynamics::MultibodyJoint).
    ///
    /// ```
    /// # use rapier3d::prelude::*;
    /// // The second body's X axis points 0.3 rad to the left and no higher than the first body's.
    /// let (first, second) = (Rotation::IDENTITY, Rotation::from_rotation_y(0.3));
    /// let ball = SphericalJoint::new();
    /// let angle = |axis| ball.data.angle(axis, &first, &second).expect("the rotation is free");
    /// assert!((angle(JointAxis::AngY) - 0.3).abs() < 1.0e-6);
    /// assert!(angle(JointAxis::AngX).abs() < 1.0e-6 && angle(JointAxis::AngZ).abs() < 1.0e-6);
    /// assert_eq!(FixedJoint::new().data.angle(JointAxis::AngY, &first, &second), None);
    /// ```
    pub fn angle(
        &self,
        axis: JointAxis,
        body_rotation1: &Rotation,
        body_rotation2: &Rotation,
    ) -> Option<Real> {
        let free = !self.locked_axes;
        if !(free & JointAxesMask::ANG_AXES).contains(mask_of(axis)) {
            return None;
        }
        let frame1 = *body_rotation1 * self.local_frame1.rotation;
        let frame2 = *body_rotation2 * self.local_frame2.rotation;
        let rotations = FreeRotations::new(free, self.coupled_axes);
        Some(angle_about(axis, rotations, &relative_rotation(&frame1, &frame2)).0)
    }
}

#[cfg(test)]
mod tests {
    use crate::dim::joint_axes::{JointAxesMask, JointAxis, frame_along};
    use crate::dim::math::{Rotation, Vector};
    use crate::model::joint::{FixedJoint, GenericJoint, RevoluteJoint};

    #[test]
    fn hinges_have_the_angle_of_their_own_method() {
        let hinge = RevoluteJoint { data: GenericJoint::new(JointAxesMask::LOCKED_REVOLUTE_AXES) };
        let second = frame_along((Vector::X + Vector::Y * 0.5).normalize());
        let bodies = (&Rotation::default(), &second);
        let angle = |joint: &GenericJoint, axis| joint.angle(axis, bodies.0, bodies.1);
        assert_eq!(angle(&hinge.data, JointAxis::AngX), Some(hinge.angle(bodies.0, bodies.1)));
        assert_eq!(angle(&hinge.data, JointAxis::LinX), None);
        assert_eq!(angle(&FixedJoint::new().data, JointAxis::AngX), None);
    }
}
