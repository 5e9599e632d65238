//! The pose from which a body's drift is measured.

use super::RigidBody;
use crate::base::measure::is_point;
use crate::dim::math::{Real, Rotation, Vector, rotation_is_valid};
use crate::model::island::turn_bound;

/// Where a body was when the current drift window began.
#[derive(Copy, Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct RestPose {
    center: Vector,
    rotation: Rotation,
    /// Age of the window (s).
    pub age: Real,
}

/// How far a body is from its [`RestPose`].
#[derive(Copy, Clone, Debug)]
pub(crate) struct Drift {
    /// No point of the colliders is farther than this from where it was (length units).
    pub distance: Real,
    /// No direction of the body has turned by a longer chord than this (rad, for small angles).
    pub angle: Real,
}

impl RestPose {
    /// The pose of a body that has none yet.
    pub const ORIGIN: Self = Self { center: Vector::ZERO, rotation: Rotation::IDENTITY, age: 0.0 };

    /// The body's present pose.
    pub fn of(body: &RigidBody) -> Self {
        Self { center: body.mprops.world_com, rotation: body.pose.rotation, age: 0.0 }
    }

    /// Returns whether all numbers can be computed with.
    pub(super) fn is_sound(&self) -> bool {
        is_point(self.center) && rotation_is_valid(&self.rotation) && self.age >= 0.0
    }

    /// The drift of the body since.
    pub fn drift(&self, body: &RigidBody) -> Drift {
        let angle = turn_bound(body.pose.rotation, self.rotation);
        let shift = (body.mprops.world_com - self.center).length();
        Drift { distance: shift + angle * body.extent, angle }
    }
}

#[cfg(test)]
mod tests {
    use super::RestPose;
    use crate::dim::math::{Rotation, Vector, rotation_from_angle, torque};
    use crate::model::body::RigidBodyBuilder;

    /// A point at the end of a long body moves by the angle times the length, which the bound does not fall below.
    #[test]
    fn a_turn_counts_with_the_extent_of_the_body() {
        let mut body = RigidBodyBuilder::dynamic().translation(Vector::X).build();
        body.extent = 10.0;
        let start = RestPose::of(&body);
        assert_eq!(start.drift(&body).distance, 0.0);
        let turn: Rotation = rotation_from_angle(torque(Vector::X, Vector::Y * 0.01));
        body.set_rotation(turn, false);
        body.update_world_mass_properties();
        let drift = start.drift(&body);
        assert!((0.0099..0.0123).contains(&drift.angle), "{drift:?}");
        assert!((0.099..0.123).contains(&drift.distance), "{drift:?}");
    }
}
