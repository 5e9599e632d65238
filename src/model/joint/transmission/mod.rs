//! Transmissions: joints that relate a coordinate of one body to a coordinate of another.

mod gear;
mod pulley;
mod rack;

pub use gear::{GearJoint, GearJointBuilder};
pub use pulley::{PulleyJoint, PulleyJointBuilder};
pub use rack::{RackJoint, RackJointBuilder};

use super::views::Named;
use super::{GenericJoint, InvalidJoint, mask_of, nearest_turn, relative_rotation};
use crate::base::measure::is_point;
use crate::dim::joint_axes::{JointAxesMask, JointAxis, twist};
use crate::dim::math::{Pose, Real, Vector};
use TransmissionEnd::{Angle, Distance, Shift};

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
/// [`GearJoint`], [`RackJoint`] and [`PulleyJoint`] are the common combinations. Other ends can be combined:
/// an angle and a distance are a winch. The limits and the motor of [`JointAxis::LinX`] apply to the sum. A
/// transmission has no locked axes, and no other limits and motors.
///
/// Angles and displacements are those of steps: poses that a program sets are not counted, and neither is the
/// time in which the joint does not act. A displacement is that of a body that does not rotate across the
/// axis. The force and the torque of the joint are those on the second body. Those on the first one are not
/// their opposites.
///
/// Both coordinates are relative to the world, so the housing should stand still. The degrees of freedom of
/// one multibody are coupled by
/// [`Multibody::add_dof_coupling`](crate::dynamics::Multibody::add_dof_coupling), also in a housing that
/// moves.
///
/// ```
/// # use rapier3d::prelude::*;
/// // A drum of radius 0.2 about its X axis, and a rope from a hook: 3 m are free at the start.
/// let mut winch = GenericJoint::new(JointAxesMask::empty());
/// let hook = TransmissionEnd::Distance { from: vector![0.0, 5.0, 0.0] };
/// let rope = Transmission::new([TransmissionEnd::Angle, hook], [0.2, 1.0]);
/// winch.set_transmission(rope).set_limits(JointAxis::LinX, [-Real::MAX, 3.0]);
/// assert!(winch.validate().is_ok());
/// ```
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct Transmission {
    /// The coordinates of the first and of the second body.
    pub ends: [TransmissionEnd; 2],
    /// Factors of both coordinates.
    pub ratios: [Real; 2],
}

/// The sum of the angles and displacements of a transmission since it was inserted. (Distances are measured.)
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct TransmissionCount {
    pub sum: Real,
    /// The joint frames in world space when they were last measured; `None` after a program has moved one.
    pub frames: Option<[Pose; 2]>,
    /// The angles (rad) by which the step has rotated the ends since then. They have all turns.
    pub rotated: [Real; 2],
}

impl TransmissionCount {
    /// Nothing was counted.
    const NEW: Self = Self { sum: 0.0, frames: None, rotated: [0.0; 2] };
}

impl Transmission {
    /// A transmission with these coordinates and factors.
    pub fn new(ends: [TransmissionEnd; 2], ratios: [Real; 2]) -> Self {
        Self { ends, ratios }
    }

    /// Counts the motions of the joint frames on. They are measured: continuous collision detection moves
    /// bodies after the solver.
    pub(crate) fn count(
        &self,
        last: Option<TransmissionCount>,
        frames: [Pose; 2],
    ) -> TransmissionCount {
        let TransmissionCount { mut sum, frames: before, rotated } =
            last.unwrap_or(TransmissionCount::NEW);
        for (side, before) in before.into_iter().flatten().enumerate() {
            let now = frames[side];
            let moved = match self.ends[side] {
                TransmissionEnd::Angle => {
                    let angle = twist(&relative_rotation(&before.rotation, &now.rotation));
                    nearest_turn(angle, rotated[side])
                }
                TransmissionEnd::Shift => {
                    let axis = (before.rotation * Vector::X + now.rotation * Vector::X) * 0.5;
                    axis.dot(now.translation - before.translation)
                }
                TransmissionEnd::Distance { .. } => 0.0,
            };
            sum += self.ratios[side] * moved;
        }
        let sum = if sum.is_finite() { sum } else { 0.0 };
        TransmissionCount { sum, frames: Some(frames), rotated: [0.0; 2] }
    }

    /// Exchanges the roles of the two bodies.
    pub(super) fn flip(&mut self) {
        self.ends.swap(0, 1);
        self.ratios.swap(0, 1);
    }

    /// Checks the points and ratios.
    fn check(&self) -> Result<(), InvalidJoint> {
        for end in self.ends {
            if let TransmissionEnd::Distance { from: anchor } = end
                && !is_point(anchor)
            {
                return Err(InvalidJoint::Anchor { anchor });
            }
        }
        let (parameter, expected) = ("the ratio of a transmission", "1e-6 to 1e6 in size");
        let is_usable = |ratio: &Real| (1.0e-6..=1.0e6).contains(&ratio.abs());
        match self.ratios.into_iter().find(|ratio| !is_usable(ratio)) {
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
    /// # Errors If the size of a ratio is not between 1e-6 and 1e6, or a point has no usable coordinates; the
    /// joint stays as it is.
    pub fn try_set_transmission(&mut self, transmission: Transmission) -> Result<(), InvalidJoint> {
        transmission.check()?;
        self.transmission = Some(transmission);
        Ok(())
    }

    /// Checks a transmission, and that the joint has no other axes.
    pub(super) fn check_transmission(&self) -> Result<(), InvalidJoint> {
        let Some(transmission) = &self.transmission else { return Ok(()) };
        transmission.check()?;
        let driven = (self.limit_axes | self.motor_axes) - mask_of(JointAxis::LinX);
        let axes: JointAxesMask = self.locked_axes | self.coupled_axes | driven;
        if axes.is_empty() { Ok(()) } else { Err(InvalidJoint::TransmissionAxes { axes }) }
    }
}

/// `as_name` and `as_name_mut` for transmissions with these ends.
macro_rules! transmission_view {
    ($name:ident, $name_mut:ident, $joint:ident, $ends:pat) => {
        impl GenericJoint {
            #[doc = concat!("This joint as a [`", stringify!($joint), "`], if it is one.")]
            pub fn $name(&self) -> Option<&$joint> {
                matches!(self.transmission, Some(Transmission { ends: $ends, .. }))
                    .then(|| Named::named(self))
            }

            #[doc = concat!("This joint as a [`", stringify!($joint), "`], if it is one.")]
            pub fn $name_mut(&mut self) -> Option<&mut $joint> {
                matches!(self.transmission, Some(Transmission { ends: $ends, .. }))
                    .then(|| Named::named_mut(self))
            }
        }
    };
}

transmission_view!(as_gear, as_gear_mut, GearJoint, [Angle, Angle]);
transmission_view!(as_rack, as_rack_mut, RackJoint, [Angle, Shift]);
transmission_view!(as_pulley, as_pulley_mut, PulleyJoint, [Distance { .. }, Distance { .. }]);
