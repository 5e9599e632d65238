//! Motion of a body within a drift window: its drift from the initial pose, and the length of its smoothed
//! path.

use super::{RigidBody, RigidBodyVelocity};
use crate::base::measure::is_point;
use crate::dim::math::{ANG_ZERO, Real, Rotation, Vector, ang_length_squared};
use crate::model::check::is_saved_unit;
use crate::model::island::rotation_bound;

/// The pose of a body at the beginning of the current drift window, and its motion since.
#[derive(Copy, Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct RestPose {
    center: Vector,
    rotation: Rotation,
    /// Age of the window (s).
    pub age: Real,
    /// Velocity after the last step.
    velocity: RigidBodyVelocity,
    /// Lengths of the smoothed path within the window.
    pub path: Drift,
}

/// A bound of the motion of a body: its distance from its [`RestPose`], or the length of its path.
#[derive(Copy, Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Drift {
    /// No point of the colliders moved farther than this (length units).
    pub distance: Real,
    /// No direction of the body turned by more than this (rad; a drift is a chord, a path is an arc).
    pub angle: Real,
}

impl Drift {
    /// No motion.
    const NONE: Self = Self { distance: 0.0, angle: 0.0 };
}

impl RestPose {
    /// The pose of a body that has none yet.
    pub const ORIGIN: Self = Self {
        center: Vector::ZERO,
        rotation: Rotation::IDENTITY,
        age: 0.0,
        velocity: RigidBodyVelocity::new(Vector::ZERO, ANG_ZERO),
        path: Drift::NONE,
    };

    /// The body's present pose.
    pub fn of(body: &RigidBody) -> Self {
        Self {
            center: body.mprops.world_com,
            rotation: body.pose.rotation,
            age: 0.0,
            velocity: body.vels,
            path: Drift::NONE,
        }
    }

    /// Adds a step of the body to the path.
    ///
    /// The step counts with the mean of the velocities at its two ends. A velocity that alternates from step
    /// to step, as in a trembling pile, therefore adds nothing. A motion over several steps adds its whole
    /// length.
    pub fn extend_path(&mut self, body: &RigidBody, dt: Real) {
        let half = 0.5 * dt;
        let shift = (body.vels.linvel + self.velocity.linvel).length() * half;
        let angle = ang_length_squared(body.vels.angvel + self.velocity.angvel).sqrt() * half;
        self.path.distance += shift + angle * body.extent;
        self.path.angle += angle;
        self.velocity = body.vels;
    }

    /// Returns whether all numbers are usable.
    pub(super) fn is_sound(&self) -> bool {
        let lengths = [self.age, self.path.distance, self.path.angle];
        is_point(self.center)
            && is_saved_unit(self.rotation.length_squared())
            && lengths.iter().all(|length| *length >= 0.0)
            && self.velocity.is_finite()
    }

    /// The drift of the body since the start of the window.
    pub fn drift(&self, body: &RigidBody) -> Drift {
        let angle = rotation_bound(body.pose.rotation, self.rotation);
        let shift = (body.mprops.world_com - self.center).length();
        Drift { distance: shift + angle * body.extent, angle }
    }
}

#[cfg(test)]
mod tests {
    use super::RestPose;
    use crate::dim::math::{Rotation, Vector, rotation_from_angle, torque};
    use crate::model::body::RigidBodyBuilder;

    /// A point at the end of a long body moves by the angle times the length, which the bound does not fall
    /// below.
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
