//! Sides of one-sided surfaces: oriented polylines, and meshes and height fields with parry's
//! `FIX_INTERNAL_EDGES`.
//!
//! Contacts push away from the front of such a surface only. A body from behind must not be stopped: no
//! contact would follow, and the body would hang in the air. The middle of a part decides on its side,
//! because the middle is what the search keeps from passing through.

use super::MovingPart;
use crate::dim::collide::{Flat, as_flat};
use crate::dim::math::{Real, Vector};

/// Returns whether the centre of the first part, in its own frame, is behind the second part after a fraction
/// of the step, and the second part does not push toward that side.
pub(super) fn is_behind(
    [own, other]: [MovingPart<'_, '_>; 2],
    center: Vector,
    fraction: Real,
) -> bool {
    let Some(constraints) = other.part.constraints else { return false };
    let Some(flat) = as_flat(other.part.shape).and_then(Flat::new) else { return false };
    let center = own.sweep.at(fraction) * center;
    let offset = other.sweep.at(fraction).inverse_transform_point(center) - flat.origin();
    let height = offset.dot(flat.normal());
    let side = if height < 0.0 { -flat.normal() } else { flat.normal() };
    constraints.project_local_normal(side).is_none()
}
