//! Two wheels whose rotations are in a constant ratio.

use super::super::GenericJoint;
use super::super::kind::{joint_kind, joint_motor_methods};
use super::{Transmission, TransmissionEnd};
use crate::dim::joint_axes::{JointAxesMask, JointAxis};
use crate::dim::math::Real;

joint_kind! {
    /// Two wheels whose rotations are in a constant ratio: `angle1 + ratio · angle2 = 0`, with the angles
    /// from the poses in which the joint was inserted.
    ///
    /// The ratio of two gears is that of their teeth, second to first; they rotate in opposite directions. A
    /// negative ratio is that of an internal gear, a belt or a chain. Each wheel has a joint of its own that
    /// holds it, like a [`RevoluteJoint`](crate::dynamics::RevoluteJoint) with a fixed body. The angles are
    /// relative to the world: see [`Transmission`]. The colliders of the two wheels do not collide with each
    /// other, unless [`Self::set_contacts_enabled`] enables it.
    GearJoint, GearJointBuilder
}
joint_motor_methods!(GearJoint, GearJointBuilder, [JointAxis::LinX], ());

impl GearJoint {
    /// Gears about the X axes of the joint frames.
    pub(crate) fn of_ratio(ratio: Real) -> Self {
        let mut data = GenericJoint::new(JointAxesMask::empty());
        let ends = [TransmissionEnd::Angle; 2];
        data.set_transmission(Transmission::new(ends, [1.0, 1.0])).set_contacts_enabled(false);
        let mut gear = Self { data };
        gear.set_ratio(ratio).set_backlash(0.0);
        gear
    }

    /// Rotation of the first wheel per rotation of the second one, in the opposite direction.
    pub fn ratio(&self) -> Real {
        self.data.transmission.map_or(1.0, |gear| gear.ratios[1] / gear.ratios[0])
    }

    /// Sets the ratio. A ratio whose size is not between 1e-6 and 1e6 is refused with a warning in the log.
    pub fn set_ratio(&mut self, ratio: Real) -> &mut Self {
        if let Some(old) = self.data.transmission {
            self.data.set_transmission(Transmission {
                ratios: [old.ratios[0], old.ratios[0] * ratio],
                ..old
            });
        }
        self
    }

    /// The angle (radians) by which the first wheel can rotate while the second one does not rotate.
    pub fn backlash(&self) -> Real {
        let limits = &self.data.limits[JointAxis::LinX as usize];
        limits.max - limits.min
    }

    /// Sets the angle (radians) by which the first wheel can rotate while the second one does not rotate
    /// (default: 0): one half in each direction. A negative value is refused with a warning in the log.
    pub fn set_backlash(&mut self, angle: Real) -> &mut Self {
        self.data.set_limits(JointAxis::LinX, [-0.5 * angle, 0.5 * angle]);
        self
    }
}

impl GearJointBuilder {
    /// Sets the angle (radians) by which the first wheel can rotate while the second one does not rotate.
    pub fn backlash(mut self, angle: Real) -> Self {
        self.0.set_backlash(angle);
        self
    }
}
