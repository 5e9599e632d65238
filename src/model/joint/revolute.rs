//! The hinge about a common axis.

use super::generic::relative_rotation;
use super::kind::{joint_drive_methods, joint_kind};
use crate::dim::joint_axes::{JointAxis, twist};
use crate::dim::math::{Real, Rotation};

joint_kind! {
    /// A hinge: rotation about a common axis.
    ///
    /// Its angle is continuous beyond half a turn, so limits may span several turns.
    RevoluteJoint, RevoluteJointBuilder
}
joint_drive_methods!(RevoluteJoint, RevoluteJointBuilder, [JointAxis::AngX], ());

impl RevoluteJoint {
    /// The angle (radians, in `-π..=π`) of the second body's joint frame relative to the first's, for bodies
    /// with these rotations.
    pub fn angle(&self, body_rotation1: &Rotation, body_rotation2: &Rotation) -> Real {
        let frame1 = *body_rotation1 * self.data.local_frame1.rotation;
        let frame2 = *body_rotation2 * self.data.local_frame2.rotation;
        twist(&relative_rotation(&frame1, &frame2))
    }
}
