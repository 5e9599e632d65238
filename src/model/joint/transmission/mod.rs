//! Transmissions: joints that relate a coordinate of one body to a coordinate of another.

mod gear;
mod pulley;
mod rack;

pub use gear::{GearJoint, GearJointBuilder};
pub use pulley::{PulleyJoint, PulleyJointBuilder};
pub use rack::{RackJoint, RackJointBuilder};

use super::{GenericJoint, InvalidJoint, mask_of};
use crate::base::measure::is_point;
use crate::dim::joint_axes::{JointAxesMask, JointAxis};
use crate::dim::math::{Real, Vector};

/// A coordinate of a body relative to the world.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub enum TransmissionEnd {
    /// The angle (radians, with all turns) of the body about the X axis of its joint frame, from 0 when the
    /// joint was inserted. In 2D, the angle of the body.
    Angle,
    /// The displacement (length units) of the joint's anchor along the X axis of its joint frame, from 0 when
    /// the joint was inserted.
    Shift,
    /// The distance (length units) of the joint's anchor from a point of the world.
    Distance {
        /// The point, in world space.
        from: Vector,
    },
}

/// The sum of a coordinate of each of two bodies: `ratios[0] · first + ratios[1] · second`.
///
/// [`GearJoint`], [`RackJoint`] and [`PulleyJoint`] are transmissions with names. Other ends can be combined:
/// an angle and a distance are a winch. The limits and the motor of [`JointAxis::LinX`] apply to the sum. A
/// transmission has no locked axes, and no other limits and motors.
///
/// Both coordinates are relative to the world, so the housing should stand still. The degrees of freedom of
/// one multibody are coupled by
/// [`Multibody::add_dof_coupling`](crate::dynamics::Multibody::add_dof_coupling), also in a housing that moves.
///
/// ```
/// # use rapier3d::prelude::*;
/// // A drum of radius 0.2 that rotates about its X axis, and a rope from a hook on a beam: 3 m are free at the start.
/// let mut winch = GenericJoint::new(JointAxesMask::empty());
/// let hook = TransmissionEnd::Distance { from: vector![0.0, 5.0, 0.0] };
/// let rope = Transmission::new([TransmissionEnd::Angle, hook], [0.2, 1.0]);
/// winch
///     .set_transmission(rope)
///     .set_limits(JointAxis::LinX, [-Real::MAX, 3.0]);
/// assert!(winch.validate().is_ok());
/// ```
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct Transmission {
    /// The coordinates of the first and of the second body.
    pub ends: [TransmissionEnd; 2],
    /// Factors of both coordinates.
    pub ratios: [Real; 2],
    /// The sum of the angles and displacements until the end of the last step. (Distances are measured.)
    pub(crate) progress: Real,
}

impl Transmission {
    /// A transmission that starts with angles and displacements of 0.
    pub fn new(ends: [TransmissionEnd; 2], ratios: [Real; 2]) -> Self {
        Self { ends, ratios, progress: 0.0 }
    }

    /// Checks its numbers.
    fn check(&self) -> Result<(), InvalidJoint> {
        for end in self.ends {
            if let TransmissionEnd::Distance { from: anchor } = end
                && !is_point(anchor)
            {
                return Err(InvalidJoint::Anchor { anchor });
            }
        }
        let (parameter, expected) = ("the ratio of a transmission", "finite, and not 0");
        let is_usable = |ratio: Real| ratio.is_normal() && (1.0 / ratio).is_normal();
        match self.ratios.into_iter().find(|ratio| !is_usable(*ratio)) {
            Some(value) => Err(InvalidJoint::Number { parameter, value, expected }),
            None => Ok(()),
        }
    }
}

impl GenericJoint {
    /// The transmission; `None` of other joints.
    pub fn transmission(&self) -> Option<&Transmission> {
        self.transmission.as_ref()
    }

    /// Makes the joint a transmission.
    pub fn set_transmission(&mut self, transmission: Transmission) -> &mut Self {
        let _ = self.try_set_transmission(transmission).map_err(super::generic::log_refusal);
        self
    }

    /// [`Self::set_transmission`].
    ///
    /// # Errors
    /// If a ratio is 0 or not finite, or a point has no usable coordinates; the joint stays as it is.
    pub fn try_set_transmission(&mut self, transmission: Transmission) -> Result<(), InvalidJoint> {
        transmission.check()?;
        self.transmission = Some(transmission);
        Ok(())
    }

    /// Checks a transmission, and that the joint has no axes besides.
    pub(super) fn check_transmission(&self) -> Result<(), InvalidJoint> {
        let Some(transmission) = &self.transmission else { return Ok(()) };
        transmission.check()?;
        let driven = (self.limit_axes | self.motor_axes) - mask_of(JointAxis::LinX);
        let axes: JointAxesMask = self.locked_axes | driven;
        if axes.is_empty() { Ok(()) } else { Err(InvalidJoint::TransmissionAxes { axes }) }
    }
}
