//! Bounds of the motion of bodies.

use crate::dim::math::{AngVector, Real, Rotation, Vector, ang_length_squared};

/// Motion of a body's points in a step: the displacement `shift`, plus at most `rest`.
///
/// Bodies that move together, as in a settling or sliding pile, hardly move relative to each other, and only
/// that affects their contacts. With one number for each body these had to be checked nearly every step.
#[derive(Copy, Clone, Debug, Default)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct BodyMotion {
    /// Displacement of the centre of mass: the difference of the two stored positions, including their
    /// rounding.
    pub shift: Vector,
    /// In length units.
    pub rest: Real,
}

impl BodyMotion {
    /// No motion.
    pub const NONE: Self = Self { shift: Vector::ZERO, rest: 0.0 };

    /// Motion of a body whose points are within `extent` of its centre of mass. The rotation moves them by at
    /// most the angle times that distance.
    pub fn of(shift: Vector, rotvec: AngVector, extent: Real) -> Self {
        let turn_squared = ang_length_squared(rotvec);
        let rest = if turn_squared > 0.0 { turn_squared.sqrt() * extent } else { 0.0 };
        Self { shift, rest }
    }

    /// The motion of a body with this bound on the motion of its points.
    pub fn within(bound: Real) -> Self {
        Self { rest: bound, ..Self::NONE }
    }

    /// No point moved farther than this (length units).
    pub fn bound(&self) -> Real {
        self.shift.length() + self.rest
    }

    /// A bound of the relative displacement of any two points of the two bodies.
    #[inline]
    pub fn against(&self, other: &Self) -> Real {
        (self.shift - other.shift).length() + self.rest + other.rest
    }
}

/// A rotation moves no unit vector farther than this factor times its largest displacement of a coordinate
/// axis. At least one axis is at 54.7 degrees or more from the axis of rotation, and 1 / sin 54.7° is the
/// square root of 3/2.
const ROTATION_BOUND_FACTOR: Real = 1.225;

/// A bound of the distance of a unit vector's images under two rotations.
pub(crate) fn rotation_bound(a: Rotation, b: Rotation) -> Real {
    let apart = Vector::AXES.map(|axis| (a * axis - b * axis).length_squared());
    ROTATION_BOUND_FACTOR * apart.into_iter().fold(0.0, Real::max).sqrt()
}

#[cfg(test)]
mod tests {
    use super::BodyMotion;
    use crate::base::random::Random;
    use crate::dim::math::{Pose, Rotation, Vector, integrate_rotation, torque};

    /// Points of two bodies with random displacements and rotations change their distance by at most the
    /// bound.
    #[test]
    fn no_point_moves_farther_than_the_bound() {
        let mut random = Random(54);
        let mut vector =
            |size: f64| Vector::from_array([(); _].map(|()| random.within(-size, size)));
        for _ in 0..2_000 {
            let extent = 0.7;
            let shifts = [vector(1.0), vector(1.0)];
            let mut ends = [[Vector::ZERO; 2]; 2];
            let mut motions = [BodyMotion::NONE; 2];
            for side in 0..2 {
                let (center, arm) = (vector(2.0), vector(1.0).normalize_or_zero() * extent);
                let rotvec = torque(vector(1.0), vector(1.0));
                let pose = Pose::from_parts(
                    center + shifts[side],
                    integrate_rotation(Rotation::IDENTITY, rotvec),
                );
                ends[side] = [center + arm, pose * arm];
                motions[side] = BodyMotion::of(shifts[side], rotvec, extent);
            }
            let apart = |when: usize| ends[0][when] - ends[1][when];
            let moved = (apart(1) - apart(0)).length();
            let [first, second] = &motions;
            assert!(moved <= first.against(second) + 1.0e-5);
            assert!(first.against(second) <= first.bound() + second.bound() + 1.0e-5);
            assert!((ends[0][1] - ends[0][0]).length() <= first.bound() + 1.0e-5);
        }
    }
}
