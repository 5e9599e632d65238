//! Spatial vectors in 2D: linear and angular part in one list of three numbers, the linear ones first.
//!
//! Velocities, forces and accelerations of a link are such lists, in world axes, about the link's centre of
//! mass.

use super::axes::LockedAxes;
use super::joint_axes::JointAxesMask;
use super::math::{ANG_DIM, AngVector, Real, Rotation, SpatialVector, Vector, rotation_to_angle};
use crate::base::trig::sin_cos;
use parry::mass_properties::MassProperties;

/// The axes of rotation: 2D has one.
pub const ANG_AXES: [AngVector; ANG_DIM] = [1.0];

/// Both parts in one.
#[inline]
pub fn join(linear: Vector, angular: AngVector) -> SpatialVector {
    [linear.x, linear.y, angular]
}

/// The linear part.
#[inline]
pub fn linear(s: &SpatialVector) -> Vector {
    Vector::new(s[0], s[1])
}

/// The angular part.
#[inline]
pub fn angular(s: &SpatialVector) -> AngVector {
    s[2]
}

/// The components of an angular vector.
#[inline]
pub fn ang_components(a: AngVector) -> [Real; ANG_DIM] {
    [a]
}

/// The components of a rotation: the cosine and the sine of its angle.
#[inline]
pub fn rotation_components(rotation: &Rotation) -> [Real; 2] {
    [rotation.re, rotation.im]
}

/// The rate of change of the direction `b` under the rotation `a`: the axis of the plane is constant.
#[inline]
pub fn ang_cross(_: AngVector, _: AngVector) -> AngVector {
    0.0
}

/// An axis of rotation after the rotation: the axis of the plane is constant.
#[inline]
pub fn turn_axis(_: Rotation, axis: AngVector) -> AngVector {
    axis
}

/// The rotation by an angle (radians).
#[inline]
pub fn rotation_about(_: usize, angle: Real) -> Rotation {
    let (sine, cosine) = sin_cos(angle);
    Rotation::from_cos_sin_unchecked(cosine, sine)
}

/// The angle of a rotation (radians, at most half a turn).
pub fn angle_about(_: usize, rotation: Rotation) -> Real {
    rotation_to_angle(&rotation)
}

/// 2D has one axis of rotation: the first angle is all.
pub fn angles_about(_: [usize; 2], rotation: Rotation) -> [Real; 2] {
    [rotation_to_angle(&rotation), 0.0]
}

/// The axes of the world along and about which a body can move, as those of a joint.
pub fn free_axes(locked: LockedAxes) -> JointAxesMask {
    let mut free = JointAxesMask::all();
    free.set(JointAxesMask::LIN_X, !locked.contains(LockedAxes::TRANSLATION_LOCKED_X));
    free.set(JointAxesMask::LIN_Y, !locked.contains(LockedAxes::TRANSLATION_LOCKED_Y));
    free.set(JointAxesMask::ANG_X, !locked.contains(LockedAxes::ROTATION_LOCKED_Z));
    free
}

/// The angular inertia about the centre of mass.
pub fn world_inertia(mass: &MassProperties, _: Rotation) -> [[Real; ANG_DIM]; ANG_DIM] {
    [[mass.principal_inertia()]]
}

/// The error if the rotation is locked, and how the relative angular velocity changes it. `rotation` is the
/// second frame's, seen from the first.
pub fn locked_angles(rotation: Rotation) -> [(Real, AngVector); ANG_DIM] {
    [(rotation_to_angle(&rotation), 1.0)]
}
