//! Validation of values in setters. A setter logs and refuses a value that no simulation can use, and keeps
//! the old value.

use crate::base::measure::is_point;
use crate::dim::math::{Pose, Real, Rotation, rotation_is_valid};
use core::fmt::Debug;

/// The largest error of the squared length of a saved direction or rotation. Steps leave rounding errors of
/// 1e-6.
const UNIT_ERROR_MAX: Real = 1.0e-3;

/// Returns whether a saved direction or rotation of this squared length has unit length. Users' rotations may
/// be less exact: they are normalized. Loaded values are used as they are.
pub(crate) fn is_saved_unit(length_squared: Real) -> bool {
    (length_squared - 1.0).abs() < UNIT_ERROR_MAX
}

/// Returns whether a saved pose is one that a step may have left.
pub(crate) fn is_saved_pose(pose: &Pose) -> bool {
    is_point(pose.translation)
        && pose.rotation.is_finite()
        && is_saved_unit(pose.rotation.length_squared())
}

/// Logs a refused value.
#[cold]
pub(crate) fn refuse(what: &str, value: impl Debug) {
    log::warn!("{value:?} is not valid as {what}; the old value stays");
}

/// Returns whether the value is finite and not negative.
pub(crate) fn is_non_negative(value: Real) -> bool {
    value.is_finite() && value >= 0.0
}

/// The rotation with unit length, or nothing if it is not finite or far from unit length.
///
/// A rotation of unit length comes back bit by bit.
pub(crate) fn checked_rotation(rotation: Rotation) -> Option<Rotation> {
    let error = (rotation.length_squared() - 1.0).abs();
    match rotation_is_valid(&rotation) {
        true if error > 16.0 * Real::EPSILON => Some(rotation.normalize()),
        true => Some(rotation),
        false => None,
    }
}

/// The pose with a rotation of unit length, or nothing if it is not finite or unusably far away.
pub(crate) fn checked_pose(pose: Pose) -> Option<Pose> {
    let rotation = checked_rotation(pose.rotation)?;
    is_point(pose.translation).then(|| Pose::from_parts(pose.translation, rotation))
}
