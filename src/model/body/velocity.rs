//! The velocity of a rigid body, and its integration.

use crate::base::measure::{SIZE_MAX, is_point};
use crate::dim::math::{
    ANG_ZERO, AngVector, Pose, Real, Vector, ang_is_finite, ang_length_squared, cross,
    rotation_from_angle,
};

/// Velocity of a body: that of its centre of mass, and its angular velocity.
#[cfg(not(feature = "upstream-signatures"))]
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
#[repr(C)]
pub struct RigidBodyVelocity {
    /// World-space velocity of the centre of mass (length/s).
    pub linvel: Vector,
    /// World-space angular velocity (rad/s).
    pub angvel: AngVector,
}

/// Velocity of a body over a kind of numbers, as in Rapier. The engine has one kind.
#[cfg(feature = "upstream-signatures")]
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
#[repr(C)]
pub struct RigidBodyVelocity<N: Number = Real> {
    /// World-space velocity of the centre of mass (length/s).
    pub linvel: N::Vector,
    /// World-space angular velocity (rad/s).
    pub angvel: N::AngVector,
}

/// Numbers, with the vectors that they make.
#[cfg(feature = "upstream-signatures")]
pub trait Number {
    /// Type of vectors.
    type Vector;
    /// Type of angular vectors.
    type AngVector;
}

#[cfg(feature = "upstream-signatures")]
impl Number for Real {
    type Vector = Vector;
    type AngVector = AngVector;
}

impl Default for RigidBodyVelocity {
    fn default() -> Self {
        Self::zero()
    }
}

impl RigidBodyVelocity {
    /// A velocity with these linear (length/s) and angular (rad/s) parts.
    pub const fn new(linvel: Vector, angvel: AngVector) -> Self {
        Self { linvel, angvel }
    }

    /// The velocity of a body at rest.
    pub const fn zero() -> Self {
        Self { linvel: Vector::ZERO, angvel: ANG_ZERO }
    }

    /// Returns whether the velocity is zero.
    pub fn is_zero(&self) -> bool {
        *self == Self::zero()
    }

    /// Returns whether all components are finite.
    pub fn is_finite(&self) -> bool {
        self.linvel.is_finite() && ang_is_finite(self.angvel)
    }

    /// Returns whether the linear and the angular speed are at most [`SIZE_MAX`].
    pub(crate) fn is_usable(&self) -> bool {
        is_point(self.linvel) && ang_length_squared(self.angvel) <= SIZE_MAX * SIZE_MAX
    }

    /// World-space velocity (length/s) of the body's point at `point`, if its centre of mass is at
    /// `center_of_mass` (both in world space).
    pub fn velocity_at_point(&self, point: Vector, center_of_mass: Vector) -> Vector {
        self.linvel + cross(self.angvel, point - center_of_mass)
    }

    /// The pose after `dt` seconds at this velocity, from `pose`. The rotation is about the centre of mass,
    /// at `local_center_of_mass` in the body's frame.
    pub fn integrate(&self, dt: Real, pose: &Pose, local_center_of_mass: Vector) -> Pose {
        let center_of_mass = pose * local_center_of_mass + self.linvel * dt;
        let rotation = (rotation_from_angle(self.angvel * dt) * pose.rotation).normalize();
        Pose::from_parts(center_of_mass - rotation * local_center_of_mass, rotation)
    }

    /// The velocity after `dt` seconds of damping (both factors in 1/s).
    ///
    /// The implicit Euler step `v / (1 + dt·c)`: no factor reverses the velocity.
    #[must_use]
    pub fn apply_damping(&self, dt: Real, linear_damping: Real, angular_damping: Real) -> Self {
        Self {
            linvel: self.linvel * (1.0 / (1.0 + dt * linear_damping)),
            angvel: self.angvel * (1.0 / (1.0 + dt * angular_damping)),
        }
    }
}

impl core::ops::Add for RigidBodyVelocity {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { linvel: self.linvel + other.linvel, angvel: self.angvel + other.angvel }
    }
}

impl core::ops::AddAssign for RigidBodyVelocity {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}
