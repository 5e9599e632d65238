//! A pinion that moves a rack.

use super::super::GenericJoint;
use super::super::kind::joint_kind;
use super::{Transmission, TransmissionEnd};
use crate::dim::joint_axes::{JointAxesMask, JointAxis};
use crate::dim::math::Real;

joint_kind! {
    /// A pinion (the first body) that moves a rack (the second one): `displacement = radius · angle`, from
    /// the poses in which the joint was inserted.
    ///
    /// The displacement is that of the rack's anchor along the X axis of its joint frame. Each body has a
    /// joint of its own that holds it. Both coordinates are relative to the world: see [`Transmission`]. The
    /// colliders of the two bodies do not collide with each other, unless [`Self::set_contacts_enabled`]
    /// enables it.
    RackJoint, RackJointBuilder
}

impl RackJoint {
    /// A rack along the X axis of the second joint frame.
    pub(crate) fn of_radius(radius: Real) -> Self {
        let mut data = GenericJoint::new(JointAxesMask::empty());
        let ends = [TransmissionEnd::Angle, TransmissionEnd::Shift];
        data.set_transmission(Transmission::new(ends, [1.0, -1.0])).set_contacts_enabled(false);
        data.set_limits(JointAxis::LinX, [0.0, 0.0]);
        let mut rack = Self { data };
        rack.set_radius(radius);
        rack
    }

    /// Displacement of the rack per radian of the pinion (length units).
    pub fn radius(&self) -> Real {
        self.data.transmission.map_or(1.0, |transmission| transmission.ratios[0])
    }

    /// Sets the displacement of the rack per radian of the pinion (length units); negative if it moves
    /// against its axis. A radius whose size is not between 1e-6 and 1e6 is refused with a warning in the
    /// log.
    pub fn set_radius(&mut self, radius: Real) -> &mut Self {
        if let Some(old) = self.data.transmission {
            self.data.set_transmission(Transmission { ratios: [radius, -1.0], ..old });
        }
        self
    }
}
